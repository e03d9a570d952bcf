#!/usr/bin/env python3
"""Writes the tables of doc/actions/*.md from action/*.action, msg/*.msg and doc/errors.md.

A page is written by hand above its line `<!-- made by ... -->`, and by this program below it. With --check nothing is
written; the exit status is 1, with the faults printed, if a page differs from what this program would write. In both
cases these are faults: a field without a comment, a number in a goal without a unit or a range, an action without a
page or an example.
"""
import argparse
import pathlib
import re
import sys
from dataclasses import dataclass, field

MARK = "<!-- made by scripts/make_action_pages.py from {}: edit those -->"
MARK_LINE = re.compile(r"^<!-- made by .*\n", re.MULTILINE)
EXAMPLE = re.compile(r"^```sh example", re.MULTILINE)
INDEX = "README"
# Served with the messages of another package; its fields are written here once more, for the tests.
FOREIGN = {"follow_joint_trajectory": "control_msgs"}
# Served by the supervisor of a cell: their errors stand on their pages, and rostest.cell has their examples.
OF_SUPERVISOR = {"build_cell", "run_cell"}

DECLARATION = re.compile(r"(?P<type>[\w/]+)(?P<array>\[\d*\])?\s+(?P<name>\w+)(=(?P<value>[^#\s]+))?\s*"
                         r"(#\s*(?P<comment>.*))?")
NUMBER = re.compile(r"u?int\d+|float\d+")
UNIT_OR_RANGE = re.compile(r"\d\.\.\d|\[[^\]]+\]")
ENDS = re.compile(r"((?:(?:SUCCEEDED|REJECTED|ABORTED|PREEMPTED|RECALLED)(?:, )?)+):\s*")
ERROR_ROW = re.compile(r"\| (16#[0-9A-F]+|\d+) \| \d+ \|")
NO_MORE = "cannot occur any more"


# --- What stands in an .action or .msg file.
@dataclass
class Declaration:
    type: str
    array: str
    name: str
    value: str
    comment: str


@dataclass
class Constants:
    """Values of a field. `field` is empty when they belong to none, `title` when nothing is said of them all."""
    field: str
    title: str
    entries: list = field(default_factory=list)


@dataclass
class Section:
    fields: list = field(default_factory=list)
    constants: list = field(default_factory=list)
    notes: list = field(default_factory=list)

    def constants_of(self, name):
        return next((group for group in self.constants if group.field == name), None)


def read_interface(path):
    """(what the first comment says, one Section for each part between the lines `---`)."""
    lines = path.read_text(encoding="utf-8").splitlines()
    end = next((i for i, line in enumerate(lines) if not line.startswith("#")), len(lines))
    header = " ".join(line.lstrip("# ").rstrip() for line in lines[:end])
    parts = [[]]
    for line in lines[end:]:
        if line == "---":
            parts.append([])
        else:
            parts[-1].append(line)
    return re.sub(r"\s+", " ", header), [read_section(part) for part in parts]


def read_section(lines):
    section, remark, last, group = Section(), [], None, None
    for line in lines:
        declared = DECLARATION.fullmatch(line)
        if line.startswith("#"):
            remark.append(line.lstrip("# "))
            group = None
        elif line.lstrip().startswith("#"):  # goes on with the comment of the line above
            last.comment += " " + line.lstrip("# ")
        elif declared:
            last = Declaration(*(re.sub(r"\s+", " ", declared[key] or "")
                                 for key in ("type", "array", "name", "value", "comment")))
            if last.value:
                if group is None:
                    group = begin_group(section, " ".join(remark))
                    remark = []
                group.entries.append(last)
            else:
                section.fields.append(last)
                # Constants without a title are those of the field behind them, when that says nothing else.
                if group is not None and not group.title and not last.comment:
                    group.field = group.field or last.name
                group = None
        else:  # an empty line
            if remark:
                section.notes.append(" ".join(remark))
            remark = []
    if remark:
        section.notes.append(" ".join(remark))
    return section


def begin_group(section, title):
    """The title begins with the field's name: "data_format (table 5.3.2.5): target, speed, blending"."""
    named = re.match(r"(\w+)(?: \(.*?\))?:?\s*(.*)", title)
    section.constants.append(Constants(named[1], named[2]) if named else Constants("", ""))
    return section.constants[-1]


def read_errors(path):
    """The rows of doc/errors.md by action, in its order."""
    errors = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            rows = errors.setdefault(line[3:].strip("`"), [])
        elif ERROR_ROW.match(line):
            rows.append(line)
    return errors


class Package:
    def __init__(self, root):
        self.pages = root / "doc/actions"
        self.errors = read_errors(root / "doc/errors.md")
        self.messages = {path.stem: read_interface(path) for path in (*root.glob("msg/*.msg"), *root.glob("test/control_msgs/msg/*.msg"))}
        self.actions = {snake_case(path.stem): (path.stem, *read_interface(path))
                        for path in (*root.glob("action/*.action"), *root.glob("test/control_msgs/action/*.action"))}

    def messages_in(self, sections):
        """The names of all own messages in the fields, and in the fields of those."""
        found = []
        for section in sections:
            for entry in section.fields:
                if entry.type in self.messages and entry.type not in found:
                    inner = self.messages_in(self.messages[entry.type][1])
                    found += [entry.type] + [name for name in inner if name not in found]
        return list(dict.fromkeys(found))


def snake_case(name):
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


# --- What a page says.
def page_tables(package, action):
    name, header, sections = package.actions[action]
    goal, result, feedback = sections
    package_name = FOREIGN.get(action, "cobot_command")
    topic = f"/cell/{action}" if action in OF_SUPERVISOR else f"/{action}"
    lines = ["## Names", f"Type `{package_name}/{name}`; its goal is sent to `{topic}/goal`"
             f" (`{package_name}/{name}ActionGoal`). With a window: `rosrun actionlib_tools axclient.py {topic}`.", ""]
    lines += ["## How a goal ends", "| state | when |", "|---|---|"]
    lines += [f"| {states} | {when} |" for states, when in ends(header)] + [""]
    for title, section in (("Goal", goal), ("Result", result), ("Feedback", feedback)):
        lines += [f"## {title}"] + section_table(package, section)
    messages = package.messages_in(sections)
    for message in messages:
        text, (section,) = package.messages[message]
        lines += [f"## {message}", text, ""] + section_table(package, section)
    return "\n".join(lines + error_tables(package.errors.get(action, []))) + "\n"


def ends(header):
    """[(states, when)] of "... SUCCEEDED: this. ABORTED: that."""
    pieces = ENDS.split(header)
    return [(states, capital(when.strip())) for states, when in zip(pieces[1::2], pieces[2::2])]


def section_table(package, section):
    if not section.fields:
        return ["Nothing.", ""]
    lines = ["| field | type | meaning |", "|---|---|---|"]
    for entry in section.fields:
        group = section.constants_of(entry.name)
        parts = [entry.comment] + (constant_lines(group) if group else [])
        lines.append(f"| `{entry.name}` | {type_link(package, entry)} | {'<br>'.join(p for p in parts if p)} |")
    lines.append("")
    for group in section.constants:
        if not any(entry.name == group.field for entry in section.fields):
            lines += [", ".join(constant_lines(group)), ""]
    for note in section.notes:
        lines += [note, ""]
    return lines


def constant_lines(group):
    lines = [capital(group.title)] if group.title else []
    return lines + [f"`{c.name}` {c.value}" + (f": {c.comment}" if c.comment else "") for c in group.entries]


def type_link(package, entry):
    goal_of = snake_case(entry.type[:-len("Goal")]) if entry.type.endswith("Goal") else ""
    if entry.type in package.messages:
        return f"[{entry.type}](#{entry.type.lower()}){entry.array}"
    if goal_of in package.actions:
        return f"[{entry.type}]({goal_of}.md#goal){entry.array}"
    return f"`{entry.type}{entry.array}`"


def error_tables(rows):
    if not rows:
        return []
    head = ["| id | decimal | description | remedy | raised when |", "|---|---|---|---|---|"]
    lines = ["## Errors", "The first violated row decides the `error_id`."] + [""] + head
    past = [row for row in rows if row.split(" | ")[4].startswith(NO_MORE)]
    lines += [row for row in rows if row not in past]
    if past:
        lines += ["", "In the thesis, but without a cause left:", ""] + head + past
    return lines


def index_tables(package):
    lines = ["| action | what it does | SUCCEEDED means |", "|---|---|---|"]
    for action in [*package.errors, *sorted(OF_SUPERVISOR)]:
        _, header, _ = package.actions[action]
        what = re.split(r"(?<=\.) ", re.sub(r"^\w+ \(.*?\): ", "", header))[0]
        succeeded = dict(ends(header)).get("SUCCEEDED", "")
        lines.append(f"| [`{action}`]({action}.md) | {capital(what)} | {succeeded} |")
    return "\n".join(lines) + "\n"


def capital(text):
    return text[:1].upper() + text[1:]


# --- What is wrong.
def faults_in_interfaces(package):
    for name, _, sections in package.actions.values():
        where = f"action/{name}.action"
        if len(sections) != 3:
            yield f"{where}: an action has a goal, a result and a feedback"
        for number, section in enumerate(sections):
            yield from faults_in_section(where, section, number == 0)
    in_goals = package.messages_in([sections[0] for _, _, sections in package.actions.values()])
    for message in package.messages_in([s for _, _, sections in package.actions.values() for s in sections]):
        yield from faults_in_section(f"msg/{message}.msg", package.messages[message][1][0], message in in_goals)


def faults_in_section(where, section, in_goal):
    known = {constant.name for group in section.constants for constant in group.entries}
    for entry in section.fields:
        has_constants = section.constants_of(entry.name) is not None or known & set(entry.comment.split())
        if not entry.comment and not has_constants:
            yield f"{where}: {entry.name} has no comment"
        counts = NUMBER.fullmatch(entry.type) or entry.array
        if in_goal and counts and not has_constants and not UNIT_OR_RANGE.search(entry.comment):
            yield f"{where}: {entry.name} has neither a [unit] nor a range a..b"


def faults_in_pages(package):
    for action in sorted((package.actions.keys() - OF_SUPERVISOR) ^ package.errors.keys()):
        yield f"{action} is in one of action/ and doc/errors.md only"
    for path in sorted(package.pages.glob("*.md")):
        if path.stem != INDEX and path.stem not in package.actions:
            yield f"{path.name}: there is no such action"
    for action in sorted(package.actions):
        path = package.pages / f"{action}.md"
        if not path.exists():
            yield f"doc/actions/{path.name} is missing: begin it with a title, what the action does, and an example"
        elif action not in OF_SUPERVISOR and not EXAMPLE.search(path.read_text(encoding="utf-8")):
            yield f"doc/actions/{path.name} has no example, a block that begins with ```sh example"


def pages(package):
    """(path, what it has to hold) of every page that there is."""
    texts = {package.pages / f"{INDEX}.md": (MARK.format("action/*.action"), index_tables(package))}
    for action, (name, _, _) in package.actions.items():
        mark = MARK.format(f"action/{name}.action, msg/ and doc/errors.md")
        texts[package.pages / f"{action}.md"] = (mark, page_tables(package, action))
    for path, (mark, tables) in sorted(texts.items()):
        if path.exists():
            by_hand = MARK_LINE.split(path.read_text(encoding="utf-8"))[0].rstrip("\n")
            yield path, f"{by_hand}\n\n{mark}\n{tables}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing; fail when a page is not current")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent,
                        help="the package (default: %(default)s)")
    arguments = parser.parse_args()
    package = Package(arguments.root)
    faults = list(faults_in_interfaces(package)) + list(faults_in_pages(package))
    for path, text in [] if faults else pages(package):
        if path.read_text(encoding="utf-8") == text:
            continue
        if arguments.check:
            faults.append(f"{path} is not current: run scripts/make_action_pages.py")
        else:
            path.write_text(text, encoding="utf-8")
            print(f"written: {path}")
    print("\n".join(faults) or "the pages of the actions are current")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
