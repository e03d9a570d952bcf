#!/usr/bin/env python3
"""Fails when tm_simulator would not start with the packages of scripts/packages-run.txt alone, or when one of them is not needed. Exit status 77
without Debian's packages: skipped.

check_run_packages.py PROGRAM LIST"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
LIBRARY = re.compile(r"=> (/\S+)")


def has_packages():
    return shutil.which("dpkg-query") is not None


def printed(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def package_of(file):
    """Debian has a file of /usr/lib under either name, and a library under the name that its link leads to."""
    for name in (file, f"/usr{file}", file.removeprefix("/usr"), os.path.realpath(file)):
        found = subprocess.run(["dpkg-query", "--search", name], check=False, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        if found:
            return found.split(":")[0]
    return None


def packages_of(program):
    """{package: one of its libraries that the program loads}, but for our own libraries."""
    files = LIBRARY.findall(printed("ldd", str(program)))
    return {package_of(file) or file: file for file in files if not pathlib.Path(file).name.startswith("libcobot_")}


def listed(text):
    """Each line as the set of its alternatives."""
    lines = [line.partition("#")[0].strip() for line in text.splitlines()]
    return [{name.strip() for name in line.split("|")} for line in lines if line]


def with_dependencies(packages):
    """They, and what apt installs with them, as far as it is installed here."""
    found, left = set(), set(packages)
    while left:
        package = left.pop()
        found.add(package)
        fields = subprocess.run(["dpkg-query", "--show", "--showformat=${Depends},${Pre-Depends}", package], check=False, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True).stdout
        left |= set(re.findall(r"(?:^|[,|])\s*([a-z0-9][a-z0-9+.-]+)", fields)) - found
    return found


def faults(program, text):
    lines, needed = listed(text), packages_of(program)
    for missing in sorted(needed.keys() - with_dependencies(set().union(*lines))):
        yield f"{program} loads {needed[missing]} of {missing}, which is not in the list"
    for line in lines:
        if not line & needed.keys():
            yield f"{' | '.join(sorted(line))} is in the list, and {program} loads nothing of it"


def main():
    if not has_packages():
        print("dpkg-query is missing: skipped")
        return SKIPPED
    found = list(faults(sys.argv[1], pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")))
    print("\n".join(found) or "tm_simulator needs the packages in the list, and no others")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
