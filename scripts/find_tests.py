#!/usr/bin/env python3
"""Prints the CTest entries, as a regular expression, that contain tests whose name matches.

find_tests.py BUILD_FOLDER REGEX [ENTRIES]

ENTRIES is a regular expression: other entries are not considered.

An entry matches by its own name, or, if it is a GoogleTest program (test/support/run_gtest.py), by the name of one of its tests:
NAME.Suite.test. Run CTest with COBOT_TEST_PATTERN=REGEX in the environment, so that such a program runs only these tests.
Exit status: 0 found, 4 no test matches, else an error."""
import concurrent.futures
import json
import os
import re
import subprocess
import sys

RUNNER = "run_gtest.py"
PATIENCE = 60  # [s]
NO_TEST = 4


def matches(test, pattern, regex):
    command = test.get("command", [])
    runner = next((number for number, word in enumerate(command) if word.endswith(RUNNER)), None)
    if runner is None:
        return regex.search(test["name"]) is not None
    try:
        listing = subprocess.run([*command[:runner + 1], "--list", *command[runner + 1:]], env=dict(os.environ, COBOT_TEST_PATTERN=pattern),
                                 capture_output=True, text=True, check=False, timeout=PATIENCE)
        names = listing.stdout.strip() if listing.returncode == 0 else None
    except subprocess.TimeoutExpired:
        names = None
    # A program that does not list its tests, because it was not built, is chosen by its entry: CTest reports it then.
    return regex.search(test["name"]) is not None if names is None else bool(names)


def main():
    folder, pattern, *within = sys.argv[1:]
    shown = subprocess.run(["ctest", "--test-dir", folder, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    tests = [test for test in json.loads(shown.stdout)["tests"] if not within or re.search(within[0], test["name"])]
    regex = re.compile(pattern)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [test["name"] for test, is_one in zip(tests, pool.map(lambda test: matches(test, pattern, regex), tests)) if is_one]
    if not found:
        return NO_TEST
    print("^(" + "|".join(re.escape(name) for name in found) + ")$")
    return 0


if __name__ == "__main__":
    sys.exit(main())
