#!/usr/bin/env python3
"""Fails where a page disagrees with its subject: which room may use which, how large files of goals may be, which messages show units; where a
link leads to no file or no heading; and where the README is too long for a first look.

The table of rooms in doc/architecture.md names what a room is built on; what that uses is meant with it. check_layers.py has what may be included."""
import functools
import pathlib
import re
import sys

from check_layers import ALLOWED

ALL_ABOVE = "all of the above"
# The constant with the size of a file of each field of goals, and the pages that say it: a pattern with the number of MiB.
SIZES = {
    "steps_file": ("src/ros/files/pick_and_place_file.cpp", {"doc/ros.md": r"`steps_file`: (\d+) MiB at most"}),
    "path_file": ("src/ros/files/path_file.cpp", {"doc/ros.md": r"`path_file`: (\d+) MiB", "doc/actions/load_path.md": r"regular file of up to (\d+) MiB"}),
}
SIZE = re.compile(r"kMaxFileSize = (\d+) << 20;")
# What a first look can take: lines, and bytes.
README_LIMITS = (150, 14_000)
LINK = re.compile(r"\]\(([^()\s]+)\)")
SHOWN = re.compile(r"rosmsg show (?:-r )?cobot_command/(\w+)")


def rooms_in(page):
    """(room, what the page says of it) of each row of the table of rooms; some rows are of two."""
    for line in page.splitlines():
        row = re.match(r"\| (`[a-z_]+/.*?) \|.*\| (.*?) \|$", line)
        if row:
            for room in re.findall(r"`([a-z_]+)/", row[1]):
                yield room, row[2]


def below(rooms):
    """They, and all that they may use."""
    found, open_rooms = set(), list(rooms)
    while open_rooms:
        room = open_rooms.pop()
        if room not in found:
            found.add(room)
            open_rooms += ALLOWED.get(room, ())
    return found


def faults_of_rooms(page):
    above = set()
    for room, said in rooms_in(page):
        if room in ALLOWED:
            named = set(re.findall(r"`([a-z_/]+)`", said))
            may = {used for used in ALLOWED[room] if used.split("/")[0] != room}
            told = above if ALL_ABOVE in said else below(named)
            for more in sorted(may - told):
                yield f"{room}/ may use {more}/ (check_layers.py), and its row does not say so: {said}"
            for more in sorted(named - may):
                yield f"{room}/ may not use {more}/ (check_layers.py), and its row says so: {said}"
        above.add(room)
    for room in sorted({room.split("/")[0] for room in ALLOWED} - above):
        yield f"{room}/ has no row"


def faults_of_sizes(root):
    for field, (source, pages) in SIZES.items():
        size = SIZE.search((root / source).read_text(encoding="utf-8"))
        for page, pattern in pages.items():
            said = re.search(pattern, (root / page).read_text(encoding="utf-8"))
            if not size or not said or size[1] != said[1]:
                yield (f"{page}: the size of a {field} is {said[1] if said else 'not said'} MiB (\"{pattern}\");"
                       f" {source} has {size[1] if size else 'none'} MiB (kMaxFileSize)")


def pages_of(root):
    named = [root / "README.md", root / "CONTRIBUTING.md", *root.glob("test/**/README.md"), *root.glob("benchmark/**/README.md")]
    return [page for page in named if page.is_file()] + sorted((root / "doc").rglob("*.md"))


def definition_of(root, message):
    """The words of a message, as rosmsg show -r has them; nothing of one that is made of others without words."""
    file = root / "msg" / f"{message}.msg"
    if file.is_file():
        return file.read_text(encoding="utf-8")
    part = re.fullmatch(r"(\w+?)(Goal|Result|Feedback)", message)
    file = root / "action" / f"{part[1]}.action" if part else None
    if not file or not file.is_file():
        return None
    parts = file.read_text(encoding="utf-8").split("\n---\n")
    return parts[("Goal", "Result", "Feedback").index(part[2])]


def faults_of_messages(root):
    for page in pages_of(root):
        for message in SHOWN.findall(page.read_text(encoding="utf-8")):
            text = definition_of(root, message)
            if text is None or not re.search(r"#.*(\[(mm|deg)|%|\bmm\b)", text):
                yield f"{page.relative_to(root)}: rosmsg shows no unit of {message}; that of a goal is in its ...Goal, without Action"


@functools.lru_cache(maxsize=None)
def anchors_of(text):
    """As GitHub makes them of headings: without code quotes and punctuation, the second one of a name with -1."""
    found = set()
    for heading in re.findall(r"^#+ +(.*?)\s*$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), flags=re.M):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        found.add(next(name for name in (anchor, *(f"{anchor}-{n}" for n in range(1, 100))) if name not in found))
    return found


def faults_of_links(root):
    for page in pages_of(root):
        text = page.read_text(encoding="utf-8")
        for link in LINK.findall(re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.M | re.S)):
            if re.match(r"[a-z]+:", link):
                continue
            name, _, anchor = link.partition("#")
            target = (page.parent / name).resolve() if name else page
            if not target.exists():
                yield f"{page.relative_to(root)}: the link {link} leads to no file"
            elif anchor and anchor not in anchors_of(target.read_text(encoding="utf-8")):
                yield f"{page.relative_to(root)}: the link {link} leads to no heading"


def faults_of_the_readme(root):
    text = (root / "README.md").read_text(encoding="utf-8")
    for found, allowed, what in zip((text.count("\n"), len(text.encode())), README_LIMITS, ("lines", "bytes")):
        if found > allowed:
            yield f"README.md has {found} {what}; allowed are {allowed}: move what is reference to doc/"


def faults(root):
    page = root / "doc/architecture.md"
    yield from (f"{page.relative_to(root)}: {fault}" for fault in faults_of_rooms(page.read_text(encoding="utf-8")))
    yield from faults_of_sizes(root)
    yield from faults_of_messages(root)
    yield from faults_of_links(root)
    yield from faults_of_the_readme(root)


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "rooms, sizes, units and links of the pages are right")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
