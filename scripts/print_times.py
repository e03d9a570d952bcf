#!/usr/bin/env python3
"""Says what took longest in a run of scripts/test: its phases, what was compiled and linked, and the tests.

Usage: print_times.py PHASES BUILD_FOLDER [TESTED_FOLDER...]
PHASES has a line for each phase: when it began [s since 1970], a tab, what it does.
"""

import pathlib
import sys
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


def tests_of(folder):
    """Pairs of seconds and names, as ctest noted them."""
    report = pathlib.Path(folder) / "times.xml"
    if not report.exists():
        return []
    return [(float(test.get("time")), test.get("name")) for test in xml.etree.ElementTree.parse(report).iter("testcase")]


def show(title, rows):
    if not rows:
        return
    print(f"\n{title}: {sum(seconds for seconds, _ in rows):.0f} s in {len(rows)}, the longest:")
    for seconds, what in sorted(rows, reverse=True)[:SHOWN]:
        print(f"{seconds:8.1f} s  {what}")


def main():
    phases_file, build, tested = sys.argv[1], sys.argv[2], sys.argv[3:]
    now = time.time()
    phases = phases_of(phases_file, now)
    print("\n== What took how long")
    for seconds, what in phases:
        print(f"{seconds:8.1f} s  {what}")
    print(f"{sum(seconds for seconds, _ in phases):8.1f} s  together")
    show("Compiled", steps_of(build, now - sum(seconds for seconds, _ in phases)))
    for folder in tested:
        show(f"Tests in {pathlib.Path(folder).name}", tests_of(folder))


if __name__ == "__main__":
    main()
