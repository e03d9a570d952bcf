#!/usr/bin/env python3
"""Fails when two files of a namespace each define a type of one name: the linker takes either for both, and says nothing."""
import re
import sys

from project import project_root

NAMESPACE = re.compile(r"namespace (cobot_command[\w:]*) \{")
TYPE = re.compile(r"(?:struct|class|enum class) (?:\[\[\w+\]\] )?(\w+)(?: final)?(?: : [^;]*| \{[^;]*| \{.*\};)?$")


def types_in(file):
    """(namespace, name) of each type that stands in a named namespace, and in no other type."""
    space, hidden = None, False
    for line in file.read_text(encoding="utf-8").splitlines():
        opened = NAMESPACE.match(line)
        if opened:
            space = opened.group(1)
        elif line == "namespace {":
            hidden = True
        elif line == "}  // namespace":
            hidden = False
        elif space and not hidden:
            found = TYPE.match(line)
            if found:
                yield space, found.group(1)


def faults(root):
    known = {}
    for folder in ("include", "src"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for name in types_in(file):
                first = known.setdefault(name, file)
                if first != file:
                    yield f"{file}: {name[0]}::{name[1]} is in {first} too: give one of them another name"


def main():
    found = list(faults(project_root(sys.argv[1])))
    print("\n".join(found) if found else "every type of a namespace has a name of its own")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
