#!/usr/bin/env python3
"""Prints what took longest in a run of scripts/test (its phases, compiled files and tests), and as the last lines its verdict.

print_summary.py --outcome STATUS [--failed-phase DESCRIPTION]... PHASES BUILD_FOLDER [REPORT...]

STATUS is the exit status of the run. A failed phase is one after which the run continued. PHASES has a line for each phase: its start time [s since 1970], a tab, its description. A REPORT is
a JUnit file of ctest. The folder beside it has the reports of the GoogleTest programs (test/support/run_gtest.py)."""
import argparse
import pathlib
import time
import xml.etree.ElementTree

SHOWN = 8


def phases_of(file, now):
    """Pairs of seconds and what was done."""
    lines = [line.split("\t", 1) for line in pathlib.Path(file).read_text().splitlines()]
    starts = [float(start) for start, _ in lines] + [now]
    return [(end - start, what) for start, end, (_, what) in zip(starts, starts[1:], lines)]


def steps_of(folder, since):
    """Pairs of seconds and what was made, of all build steps since then; ninja writes a line for each."""
    steps = {}
    for log in pathlib.Path(folder).glob("**/.ninja_log"):
        for line in log.read_text().splitlines():
            fields = line.split("\t")
            if len(fields) == 5 and int(fields[2]) >= since * 1e9:
                steps[log.parent / fields[3]] = (int(fields[1]) - int(fields[0])) / 1000
    return [(seconds, str(path.relative_to(folder))) for path, seconds in steps.items() if path.suffix == ".o"]


class Case:
    def __init__(self, element):
        self.name = element.get("name")
        self.seconds = float(element.get("time", 0))
        skipped = element.find("skipped")
        # CTest writes both what skipped itself and what it could not start as "notrun".
        is_missing = element.get("status") == "notrun" and (skipped is None or not skipped.get("message", "").startswith("SKIP_"))
        self.failed = element.find("failure") is not None or element.get("status") == "fail" or is_missing
        self.skipped = not self.failed and (skipped is not None or element.get("status") == "disabled")


def cases_of(report):
    return [Case(element) for element in xml.etree.ElementTree.parse(report).iter("testcase")]


def tests_of(report):
    """Each test of a GoogleTest program, and everything else that ctest ran."""
    report = pathlib.Path(report)
    tests = []
    for entry in cases_of(report) if report.exists() else []:
        own = report.parent / "reports" / (entry.name + ".xml")
        of_program = cases_of(own) if own.exists() else [entry]
        # A program can also fail after its last test.
        is_blamed = not entry.failed or any(case.failed for case in of_program)
        tests += of_program if is_blamed else [*of_program, entry]
    return tests


def show(title, rows):
    if not rows:
        return
    print(f"\n{title}: {sum(seconds for seconds, _ in rows):.0f} s in {len(rows)}, the longest:")
    for seconds, what in sorted(rows, reverse=True)[:SHOWN]:
        print(f"{seconds:8.1f} s  {what}")


def verdict(tests, outcome, failed_phases, last_phase):
    failed = [test.name for test in tests if test.failed]
    skipped = [test.name for test in tests if test.skipped]
    lines = [f"  skipped: {name}" for name in skipped] + [f"  failed: {name}" for name in failed]
    lines += [f"  failed phase: {phase}" for phase in failed_phases]
    if outcome != 0 and not failed_phases:
        lines.append(f"  ended with {outcome} in the phase: {last_phase}")
    return [*lines, f"{len(tests) - len(failed) - len(skipped)} passed, {len(failed)} failed, {len(skipped)} skipped"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--outcome", type=int, required=True)
    parser.add_argument("--failed-phase", action="append", default=[])
    parser.add_argument("phases")
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("reports", nargs="*")
    given = parser.parse_args()
    now = time.time()
    phases = phases_of(given.phases, now)
    tests = [test for report in given.reports for test in tests_of(report)]
    taken = sum(seconds for seconds, _ in phases)
    print("\n== What took how long")
    for seconds, what in phases:
        print(f"{seconds:8.1f} s  {what}")
    print(f"{taken:8.1f} s  together")
    show("Compiled", steps_of(given.build, now - taken))
    show("Tests", [(test.seconds, test.name) for test in tests])
    print("\n== Verdict")
    print("\n".join(verdict(tests, given.outcome, given.failed_phase, phases[-1][1] if phases else "none")))


if __name__ == "__main__":
    main()
