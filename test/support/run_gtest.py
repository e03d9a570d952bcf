#!/usr/bin/env python3
"""Runs a GoogleTest program in one process, and reports each of its tests by its name.

run_gtest.py [--timeout SECONDS] [--report FILE] [--list] NAME PROGRAM

A test that crashes, or takes longer than the timeout, fails alone: the tests after it run in a new process. What a test prints is shown if it
fails. --report: a JUnit file. --list: only prints the names.
COBOT_TEST_PATTERN in the environment is a regular expression: only tests whose name, NAME.Suite.test, contains it are run.
COBOT_TEST_SHUFFLE is a number, 1 to 99999: the tests run in the random order with this seed.
Exit status: 0 all passed, 1 some failed, 77 no test matches."""
import argparse
import contextlib
import json
import os
import re
import selectors
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

NONE_MATCHES = 77
FAILED = "it failed"
POLL = 0.5  # [s]
LINE = re.compile(r"\[ *(RUN|OK|FAILED|SKIPPED) *\] (\S+?\.\S+?)(?:,|$| \((\d+) ms\))")


def names_in(listing):
    """Of the JSON that --gtest_list_tests writes: a value of a parameter may have any characters in the text that it prints."""
    for suite in json.loads(listing)["testsuites"]:
        for test in suite["testsuite"]:
            name = f"{suite['name']}.{test['name']}"
            if "DISABLED_" not in name:
                yield name


def list_tests(program):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "tests.json")
        listing = subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{file}"], capture_output=True, text=True, check=False)
        if listing.returncode != 0:
            raise RuntimeError(f"{program} --gtest_list_tests ended with {listing.returncode}\n{listing.stdout}{listing.stderr}")
        with open(file, encoding="utf-8", errors="replace") as made:
            return list(names_in(made.read()))


class Test:
    def __init__(self, name):
        self.name = name
        self.seconds = 0.0
        self.fault = "it was not run"
        self.is_skipped = False
        self.output = []


class Run:
    """One program; all tests that are to be run, and how each ended."""

    def __init__(self, program, names, timeout):
        self._program = program
        self._timeout = timeout
        self.tests = {name: Test(name) for name in names}
        self.end_fault = []  # of the process, after its tests

    def run(self):
        left = list(self.tests)
        while left:
            self._process(left)
            ran = [name for name in left if self.tests[name].fault != "it was not run"]
            left = [name for name in left if name not in set(ran)]
            if not ran:
                break

    def _process(self, names):
        """Until the program ends, or takes too long for a test or for its end."""
        with tempfile.NamedTemporaryFile("w", suffix=".flags") as flags:
            flags.write("\n".join([f"--gtest_filter={':'.join(names)}", "--gtest_color=no", *order()]) + "\n")
            flags.flush()
            with subprocess.Popen([self._program, f"--gtest_flagfile={flags.name}"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, start_new_session=True) as process:
                try:
                    running, rest, is_late = self._follow(process)
                finally:  # what it has started, too
                    with contextlib.suppress(ProcessLookupError):
                        os.killpg(process.pid, signal.SIGKILL)
                status = process.wait()
        how = f"took longer than {self._timeout} s" if is_late else f"ended with {status}"
        if running is not None:
            running.seconds = time.monotonic() - running.begun
            running.fault = how if is_late else "its process " + how
        elif is_late or (status != 0 and not any(self.tests[name].fault == FAILED for name in names)):
            self.end_fault += [f"The process {how}, and no test of it had failed:", *rest]

    def _follow(self, process):
        """Returns the test that was running at the end, what was printed since the last one, and whether it took too long."""
        running, output, pending, since = None, [], b"", time.monotonic()
        selector = selectors.DefaultSelector()
        selector.register(process.stdout, selectors.EVENT_READ)
        while True:
            if not selector.select(POLL):
                has_ended = process.poll() is not None  # a process that it has started keeps the output open
                is_late = time.monotonic() > (running.begun if running else since) + self._timeout
                if has_ended or is_late:
                    return running, output, is_late and not has_ended
                continue
            chunk = os.read(process.stdout.fileno(), 1 << 16)
            if not chunk:
                return running, output, not ends(process, self._timeout)
            *lines, pending = (pending + chunk).split(b"\n")
            for line in (line.decode(errors="replace") for line in lines):
                running, output = self._read(line, running, output)
                since = time.monotonic()

    def _read(self, line, running, output):
        found = LINE.search(line)
        test = self.tests.get(found[2]) if found else None
        if test and found[1] == "RUN":
            if running is not None:
                running.fault = "another test began before its end"
            test.begun = time.monotonic()
            test.output = output = [line]
            return test, output
        output.append(line)
        # The value of a parameter, with any characters, can be between the name and the time.
        if test and test is running:
            test.seconds = int(found[3]) / 1000 if found[3] else time.monotonic() - test.begun
            test.fault = FAILED if found[1] == "FAILED" else ""
            test.is_skipped = found[1] == "SKIPPED"
            return None, []
        return running, output


def order():
    seed = os.environ.get("COBOT_TEST_SHUFFLE", "")
    return ["--gtest_shuffle", f"--gtest_random_seed={seed}"] if seed else []


def ends(process, patience):
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(patience)
    return process.poll() is not None


def report(file, name, tests):
    suite = ElementTree.Element("testsuite", name=name, tests=str(len(tests)), failures=str(sum(bool(test.fault) for test in tests)))
    for test in tests:
        case = ElementTree.SubElement(suite, "testcase", name=f"{name}.{test.name}", classname=name, time=f"{test.seconds:.3f}")
        if test.fault:
            ElementTree.SubElement(case, "failure", message=test.fault)
        if test.is_skipped:
            ElementTree.SubElement(case, "skipped")
    os.makedirs(os.path.dirname(file) or ".", exist_ok=True)
    ElementTree.ElementTree(suite).write(file, encoding="utf-8")


def show(name, run):
    tests = list(run.tests.values())
    failed = [test for test in tests if test.fault]
    for test in failed:
        print("\n".join(test.output), f"\n{name}.{test.name}: {test.fault}\n")
    print("\n".join(run.end_fault))
    skipped = [test for test in tests if test.is_skipped]
    for test in skipped:
        print(f"skipped: {name}.{test.name}", *(line for line in test.output[1:-1] if line.strip()), sep="\n  ")
    print(f"{name}: {len(tests) - len(failed) - len(skipped)} passed, {len(failed)} failed, {len(skipped)} skipped")
    for test in failed:
        print(f"  failed: {name}.{test.name}")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("name")
    parser.add_argument("program")
    parser.add_argument("--timeout", type=float, default=120.0)
    parser.add_argument("--report")
    parser.add_argument("--list", action="store_true")
    return parser.parse_args()


def main():
    given = arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # ends the program, too
    try:
        all_names = list_tests(given.program)
    except RuntimeError as error:
        print(error)
        return 1
    pattern = os.environ.get("COBOT_TEST_PATTERN", "")
    names = [name for name in all_names if re.search(pattern, f"{given.name}.{name}")]
    if given.list:
        print("\n".join(f"{given.name}.{name}" for name in names))
        return 0
    if not names:
        if not pattern:
            print(f"{given.program} has no tests")
        return NONE_MATCHES if pattern else 1
    run = Run(given.program, names, given.timeout)
    run.run()
    if given.report:
        report(given.report, given.name, list(run.tests.values()))
    show(given.name, run)
    return 1 if run.end_fault or any(test.fault for test in run.tests.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
