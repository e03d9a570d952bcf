#!/usr/bin/env python3
"""Compares the table "What may wait, and where" of doc/ros.md with the sources of ros/ and runtime/. Each source that calls something
which can wait for the world outside of the process has its row, with the number of these calls, so that a new call is noticed in a source
that has a row already. The thread that waits is the statement of the author: no check finds it out.

check_waits.py [--print] ROOT; --print: the rows that the sources need, without their words."""
import pathlib
import re
import sys

# What can wait, by what is called.
KINDS = {
    "master": r"\.advertise(Service)?\s*[<(]|\.subscribe\s*[<(]|serviceClient|\w+Param\(|\.param\(|TransformListener>?\(|"
              r"ProgramClient>\(|before\.reset\(\)|\.shutdown\(\)|ros::start|ros::init|ros::shutdown|ros::master::",
    "condition": r"[.>]wait(_for|_until)?\(|catchUp\(\)|answerOf\(|future\w*\.get\(\)",
    "thread": r"\.join\(\)|std::async\(|[sS]pinner_?->stop\(\)",
    "disk": r"\bfsync\(|fdatasync\(|[io]fstream|filesystem::(rename|exists|remove|is_|status)|rospack|readArtifact\(|readCell|"
            r"::open\(\w|[ (]open\(path|[ (]read\((descriptor|file)|::l?stat\(|[^\w]rename\(",
    "tf": r"lookupTransform\(",
}
FOLDERS = ["src/ros", "src/runtime", "include/cobot_command/ros", "include/cobot_command/runtime"]
PAGE = "doc/ros.md"
HEADING = "## What may wait, and where"


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def in_sources(root):
    found = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            text = without_comments(path.read_text())
            name = str(path.relative_to(root)).replace("include/cobot_command/", "").replace("src/", "")
            for kind, pattern in KINDS.items():
                calls = len(re.findall(pattern, text))
                if calls:
                    found[name, kind] = calls
    return found


def in_page(root):
    _, _, rest = (root / PAGE).read_text().partition(HEADING)
    section = rest.partition("\n## ")[0]
    rows = re.findall(r"^\| `([\w/.]+)` \| (\w+) \| (\d+) \|", section, flags=re.MULTILINE)
    return {(name, kind): int(calls) for name, kind, calls in rows}


def main(arguments):
    root = pathlib.Path(arguments[-1])
    needed = in_sources(root)
    if "--print" in arguments:
        for (name, kind), calls in sorted(needed.items()):
            print(f"| `{name}` | {kind} | {calls} | | |")
        return 0
    listed = in_page(root)
    for name, kind in sorted(needed.keys() | listed.keys()):
        calls, known = needed.get((name, kind), 0), listed.get((name, kind), 0)
        if calls != known:
            print(f"{name}: it has {calls} calls that can wait for the {kind}, {PAGE} lists {known}: state for each on which thread it waits, "
                  "and for how long")
    if needed != listed:
        return 1
    print("each call that can wait is in the table of the page")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
