#!/usr/bin/env python3
"""Prints the coverage of each room from a report of gcovr.

Usage: print_coverage.py COVERAGE_JSON [ROOM]
ROOM: also lists the places of that room that no test reaches."""
import collections
import json
import pathlib
import sys


def room_of(file):
    """The folder of a source of src/ or include/cobot_command/."""
    parts = pathlib.PurePath(file).parts
    below = 2 if parts[0] == "include" else 1
    return parts[below] if len(parts) > below + 1 else "."


def share(reached, there):
    return f"{100 * reached / there:.1f} %" if there else "-"


def main():
    files = json.loads(pathlib.Path(sys.argv[1]).read_text())["files"]
    shown = sys.argv[2] if len(sys.argv) > 2 else ""
    lines, branches = collections.defaultdict(list), collections.defaultdict(list)
    missed = []
    for file in files:
        room = room_of(file["file"])
        for line in file["lines"]:
            if line.get("gcovr/noncode"):
                continue
            lines[room].append(line["count"] > 0)
            taken = [branch["count"] > 0 for branch in line["branches"]]
            branches[room] += taken
            if room == shown and (line["count"] == 0 or not all(taken)):
                what = "not reached" if line["count"] == 0 else f"{taken.count(False)} of {len(taken)} branches not taken"
                missed.append(f"{file['file']}:{line['line_number']}: {what}")
    print("| room | lines | reached | branches | taken |\n|---|---|---|---|---|")
    for room in sorted(lines):
        print(f"| {room} | {len(lines[room])} | {share(sum(lines[room]), len(lines[room]))} "
              f"| {len(branches[room])} | {share(sum(branches[room]), len(branches[room]))} |")
    print("\n".join(missed))


if __name__ == "__main__":
    main()
