#!/usr/bin/env python3
"""What scripts/bare reads.

bare.py command README NAME: prints the README's command scripts/NAME, as its section "Two commands" has it.

bare.py skipped --user USER LOG [BUILD_FOLDER]: prints which tests a run skipped, or left out of the build, for want of something. LOG is its
output. Below BUILD_FOLDER, CTest and CMake have written what that does not show. Exit status 1: one of them must not be skipped."""
import argparse
import pathlib
import re
import sys

# What may be missing on a bare machine: a pattern, the user for whom that is so (empty: each), and why.
EXPECTED = (
    (r"ros\.PickAndPlaceFile\.aFileWithoutPermissionIsRefused", "root", "root may read every file; --as-user runs it"),
    (r"The action follow_joint_trajectory is not served: control_msgs is missing", "", "Debian has no such package; the tests bring their own"),
)
# "12/90 Test #12: NAME .....***Skipped 0.01 sec", and in the list at the end "12 - NAME (Skipped)".
OF_CTEST = re.compile(r"^ *\d+/\d+ Test +#\d+: (\S+) \.*\*\*\*(?:Skipped|Not Run)|^\s+\d+ - (\S+) \((?:Skipped|Not Run|Disabled)\)", re.M)
# Of test/support/run_gtest.py: a line for each, and one at the end with their number.
OF_RUNNER = re.compile(r"^\s*skipped: (\S+)", re.M)
COUNT_OF_RUNNER = re.compile(r"^(\S+): \d+ passed, \d+ failed, (\d+) skipped", re.M)
# Of Python's unittest, in CTest's log, behind the line with the name of the test.
OF_UNITTEST = re.compile(r"^\d+/\d+ Testing: (\S+)|^(?:OK|FAILED) \(.*?skipped=(\d+)", re.M)
OF_CMAKE = re.compile(r"^-- (.*\b(?:was not found|is not there|is missing)\b.*)", re.M)
NO_PYTHON_PACKAGES = "They cannot be fetched: their tests will be skipped."


def command_of(readme, name):
    section = re.search(r"^## Two commands$(.*?)(?=^## |\Z)", readme, re.M | re.S)
    lines = re.findall(rf"^ {{4}}(scripts/{re.escape(name)}\b.*)$", section[1] if section else "", re.M)
    if len(lines) != 1:
        raise ValueError(f"README: its section \"Two commands\" has {len(lines)} lines that begin with scripts/{name}; needed is one")
    return lines[0].partition("#")[0].strip()


def skipped_in(text):
    """Names of tests, or sentences."""
    found = [first or second for first, second in OF_CTEST.findall(text)] + OF_RUNNER.findall(text)
    for program, count in COUNT_OF_RUNNER.findall(text):
        nameless = int(count) - sum(name.startswith(f"{program}.") for name in set(found))
        if nameless > 0:
            found.append(f"{program} (unnamed tests: {nameless})")
    test = "?"
    for name, count in OF_UNITTEST.findall(text):
        test = name or test
        if count:
            found.append(f"{test} (of its tests: {count})")
    if NO_PYTHON_PACKAGES in text:
        found.append("all that need scripts/python-packages.txt, which could not be fetched")
    return found


def skipped_in_build(folder):
    found = []
    for log in sorted(folder.rglob("LastTest*.log")):
        found += skipped_in(log.read_text(encoding="utf-8", errors="replace"))
    for log in sorted(folder.rglob("configure.log")):
        found += OF_CMAKE.findall(log.read_text(encoding="utf-8", errors="replace"))
    return found


def why_expected(name, user):
    for pattern, of_user, reason in EXPECTED:
        if of_user in ("", user) and re.fullmatch(pattern, name):
            return reason
    return None


def judged(names, user):
    """(lines, whether all are expected)"""
    reasons = {name: why_expected(name, user) for name in dict.fromkeys(names)}
    lines = [f"skipped, as expected: {name} ({reason})" for name, reason in reasons.items() if reason]
    lines += [f"skipped: {name}" for name, reason in reasons.items() if not reason]
    return lines or ["No test was skipped."], all(reasons.values())


def main():
    parser = argparse.ArgumentParser(description="What scripts/bare reads.")
    kinds = parser.add_subparsers(dest="kind", required=True)
    command = kinds.add_parser("command")
    command.add_argument("readme", type=pathlib.Path)
    command.add_argument("name")
    skipped = kinds.add_parser("skipped")
    skipped.add_argument("--user", required=True)
    skipped.add_argument("log", type=pathlib.Path)
    skipped.add_argument("build", type=pathlib.Path, nargs="?")
    given = parser.parse_args()
    if given.kind == "command":
        try:
            print(command_of(given.readme.read_text(encoding="utf-8"), given.name))
        except ValueError as error:
            sys.exit(str(error))
        return 0
    names = skipped_in(given.log.read_text(encoding="utf-8", errors="replace"))
    if given.build and given.build.is_dir():
        names += skipped_in_build(given.build)
    lines, is_expected = judged(names, given.user)
    print("\n".join(lines))
    return 0 if is_expected else 1


if __name__ == "__main__":
    sys.exit(main())
