#!/usr/bin/env python3
"""Holds the table "What may wait, and where" of doc/ros.md against the sources of ros/ and runtime/: each source that calls something
which can wait for the world outside of the process has its row, with the thread that waits there, and no row is left over.

check_waits.py [--print] ROOT; --print: the rows that the sources need, without their words."""
import pathlib
import re
import sys

# What can wait, by what is called.
KINDS = {
    "master": r"\.advertise(Service)?\s*[<(]|\.subscribe\s*[<(]|serviceClient|\w+Param\(|\.param\(|TransformListener>?\(|"
              r"ProgramClient>\(|before\.reset\(\)|ros::start|ros::init|ros::shutdown|ros::master::",
    "condition": r"[.>]wait(_for|_until)?\(|catchUp\(\)|answerOf\(",
    "thread": r"\.join\(\)",
    "disk": r"\bfsync\(|fdatasync\(|[io]fstream|filesystem::(rename|exists|remove|is_|status)|rospack|readArtifact\(|readCell",
    "tf": r"lookupTransform\(",
}
FOLDERS = ["src/ros", "src/runtime", "include/cobot_command/ros", "include/cobot_command/runtime"]
PAGE = "doc/ros.md"
HEADING = "## What may wait, and where"


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def in_sources(root):
    found = set()
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            text = without_comments(path.read_text())
            name = str(path.relative_to(root)).replace("include/cobot_command/", "").replace("src/", "")
            for kind, pattern in KINDS.items():
                if re.search(pattern, text):
                    found.add((name, kind))
    return found


def in_page(root):
    _, _, rest = (root / PAGE).read_text().partition(HEADING)
    section = rest.partition("\n## ")[0]
    return set(re.findall(r"^\| `([\w/.]+)` \| (\w+) \|", section, flags=re.MULTILINE))


def main(arguments):
    root = pathlib.Path(arguments[-1])
    needed = in_sources(root)
    if "--print" in arguments:
        for name, kind in sorted(needed):
            print(f"| `{name}` | {kind} | | |")
        return 0
    told = in_page(root)
    for name, kind in sorted(needed - told):
        print(f"{name}: waits for the {kind}, and {PAGE} has no row of it: on which thread, and for how long?")
    for name, kind in sorted(told - needed):
        print(f"{PAGE}: {name} does not wait for the {kind}: take the row out")
    if needed != told:
        return 1
    print("each call that can wait is in the table of the page")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
