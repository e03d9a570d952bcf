#!/usr/bin/env python3
"""Whether every source is formatted as .clang-format says, by the one version of clang-format that decides.

Usage: check_format.py [--fix] ROOT PACKAGES [FILE...]
Versions of clang-format differ in what they make of one .clang-format, and each Debian has another one. The version of
scripts/python-packages.txt decides: the system's where it has the same major number, else the one in PACKAGES, the folder
into which scripts/test puts what it fetches. Without FILE all sources are checked. Exit status 77 (skipped) without such a
version, and 1 with --fix.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

FOLDERS = ("include", "src", "test", "benchmark", "examples")
FETCHED = "clang_format/data/bin/clang-format"
SKIPPED = 77


def wanted(root):
    """The major number."""
    return re.search(r"^clang-format==(\d+)\.", (root / "scripts/python-packages.txt").read_text(encoding="utf-8"), re.MULTILINE)[1]


def version_of(program):
    """The major number; nothing if it cannot be run."""
    try:
        said = subprocess.run([program, "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return None
    found = re.search(r"version (\d+)\.", said)
    return found and found[1]


def formatter(version, candidates):
    return next((program for program in candidates if version_of(program) == version), None)


def sources(root):
    return sorted(path for folder in FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("packages", type=pathlib.Path)
    parser.add_argument("files", nargs="*")
    options = parser.parse_args()
    version = wanted(options.root)
    program = formatter(version, [shutil.which("clang-format") or "clang-format", str(options.packages / FETCHED)])
    if not program:
        print(f"no clang-format {version}, neither on the PATH nor in {options.packages}; scripts/test fetches it")
        return 1 if options.fix else SKIPPED
    how = ["-i"] if options.fix else ["--dry-run", "-Werror"]
    return subprocess.run([program, *how, *(options.files or sources(options.root))], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
