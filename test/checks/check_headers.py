#!/usr/bin/env python3
"""Fails when a header of include/ is of no use to another room: it belongs into src/ then. Of use is what another room or
a test other than the room's own unit tests includes, and what such a header includes in turn. The sub-rooms of SPLIT are
rooms of their own here."""
import re
import sys

from project import project_root

OWN = re.compile(r'#\s*include\s*"cobot_command/([a-z_]+)/((?:[a-z_]+/)*[a-z_0-9]+\.h)"')
PUBLIC = "include/cobot_command"
# Rooms with a library for each folder, that use each other as rooms do.
SPLIT = {"cell", "rapid"}


def includes_of(file):
    return {f"{room}/{name}" for room, name in OWN.findall(file.read_text(encoding="utf-8"))}


def room_of(path):
    """Of a header or source, also of the room's own unit tests; None for other tests, examples and the like."""
    parts = path.parts
    if parts[0] in ("include", "src"):
        return room_in(parts[2 if parts[0] == "include" else 1 :])
    return room_in(parts[2:]) if parts[:2] == ("test", "unit") else None


def room_in(parts):
    return "/".join(parts[:2]) if parts[0] in SPLIT and len(parts) > 2 else parts[0]


def useful(root, headers):
    found = set()
    for folder in ("include", "src", "test", "benchmark", "examples"):
        for file in (root / folder).rglob("*"):
            if file.suffix in (".h", ".cpp"):
                room = room_of(file.relative_to(root))
                found |= {header for header in includes_of(file) if room_in(header.split("/")) != room}
    grown = True
    while grown:
        more = set().union(*(includes_of(headers[header]) for header in found if header in headers)) - found
        grown = bool(more)
        found |= more
    return found


def private_ones(root):
    headers = {str(file.relative_to(root / PUBLIC)): file for file in (root / PUBLIC).rglob("*.h")}
    return sorted(set(headers) - useful(root, headers))


def main():
    wrong = private_ones(project_root(sys.argv[1]))
    for header in wrong:
        print(f"{PUBLIC}/{header}: only its own room includes it, so it belongs into src/{header.split('/')[0]}/")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
