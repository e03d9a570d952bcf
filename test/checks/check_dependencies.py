#!/usr/bin/env python3
"""Fails where package.xml depends on something that rosdep does not know (rosdep_keys.txt), or leaves out a ROS program that README.md uses.

check_dependencies.py ROOT"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

KEYS = pathlib.Path(__file__).with_name("rosdep_keys.txt")
# A program of ROS that README.md runs, and the package that has it.
PROGRAMS = {"roslaunch": "roslaunch", "rostopic": "rostopic", "rosservice": "rosservice", "rosmsg": "rosmsg", "rosrun": "rosbash",
            "rosnode": "rosnode", "axclient.py": "actionlib_tools"}


def known_keys(text):
    return {line.split()[0] for line in text.splitlines() if line.strip() and not line.startswith("#")}


def dependencies(package_xml):
    """What each tag depends on, with the lists of conditions that do not matter here."""
    return {element.text.strip() for element in ElementTree.fromstring(package_xml) if element.tag.endswith("depend")}


def faults(package_xml, readme, keys):
    needed = dependencies(package_xml)
    for key in sorted(needed - keys):
        yield f"package.xml: {key} is no key of rosdep_keys.txt: use a key that rosdep knows, and add it there with its source"
    for key in sorted(keys - needed):
        yield f"rosdep_keys.txt: package.xml does not depend on {key}: remove the line"
    for program, package in PROGRAMS.items():
        if re.search(rf"\b{re.escape(program)}\b", readme) and package not in needed:
            yield f"package.xml: README.md uses {program}: add <exec_depend>{package}</exec_depend>"


def main():
    root = pathlib.Path(sys.argv[1])
    found = list(faults((root / "package.xml").read_text(encoding="utf-8"), (root / "README.md").read_text(encoding="utf-8"),
                        known_keys(KEYS.read_text(encoding="utf-8"))))
    print("\n".join(found) or "rosdep knows every dependency")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
