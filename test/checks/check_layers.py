#!/usr/bin/env python3
"""Fails when a room includes what it may not: a room above it, or ROS inside the core. Rooms: doc/architecture.md."""
import pathlib
import re
import sys

ALLOWED = {
    "common": set(),
    "tm_script": {"common"},
    "script": {"common", "tm_script"},
    "protocol": {"common"},
    "arm": {"common"},
    "motion": {"common", "arm"},
    "planning": {"common", "script", "arm", "motion"},
    "transport": {"common"},
    "link": {"common", "protocol", "arm"},
    "blocks": {"common", "tm_script", "script", "protocol", "arm", "motion", "planning", "link"},
    "simulator": {"common", "tm_script", "script", "protocol", "arm", "motion", "planning"},
    "runtime": {"common", "script", "protocol", "arm", "motion", "planning", "transport", "link", "blocks", "simulator"},
}
# Folders of headers that the core may include. What is not here is refused: nobody can list all packages of ROS.
LIBRARIES = {"Eigen", "arpa", "boost", "console_bridge", "fmt", "gmock", "gtest", "kdl", "netinet", "nlohmann", "rapidcheck", "sys",
             "tl", "urdf_model", "urdf_parser"}
FOLDER = re.compile(r'\s*#\s*include\s*[<"](?!cobot_command/)([^/>"]+)/')
MESSAGE = re.compile(r'\s*#\s*include\s*[<"]cobot_command/[A-Z]')
OWN = re.compile(r'\s*#\s*include\s*[<"]cobot_command/([a-z_]+)/')


def faults(root):
    for room, allowed in ALLOWED.items():
        for folder in (root / "include/cobot_command" / room, root / "src" / room, root / "test/unit" / room):
            for file in sorted(folder.rglob("*")):
                if file.suffix in (".h", ".cpp"):
                    yield from faults_in(file, room, allowed | {room})


def faults_in(file, room, allowed):
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        folder = FOLDER.match(line)
        if MESSAGE.match(line) or (folder and folder.group(1) not in LIBRARIES):
            yield (f"{file}:{number}: {room}/ is core and must not include ROS, only the libraries "
                   f"{', '.join(sorted(LIBRARIES))}: {line}")
        own = OWN.match(line)
        if own and own.group(1) not in allowed:
            yield f"{file}:{number}: {room}/ may not use {own.group(1)}/ (allowed: {', '.join(sorted(allowed))})"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every room uses only the rooms below it, and the core is free of ROS")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
