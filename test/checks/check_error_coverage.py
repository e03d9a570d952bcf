#!/usr/bin/env python3
"""Fails unless every row of doc/errors.md was provoked by a rostest, or says that it cannot occur.

Usage: check_error_coverage.py errors.md FILE...   (each of lines "block id", as rostests/provoked_errors.py writes)
"""
import pathlib
import re
import sys

BLOCK = re.compile(r"## `(\w+)`")
ROW = re.compile(r"\| (?:16#[0-9A-F]+|\d+) \| (\d+) \|.*\| ([^|]+) \|$")


# Served with the messages of another package only: its tests provoke what is its own. That it tells of the rest as others do is
# shown in the core (catalogue_rows_test).
WITH_FOREIGN_MESSAGES = {"follow_joint_trajectory": range(0x2A0, 0x2B0)}
# What no test can wait for, as the rest is shown in the core: a way that is too long to be planned takes hours to be driven before.
TOO_LONG_FOR_A_TEST = {("retrace", 0x20C)}


# What a cell has against its robots is shown in the core (catalogue_rows_test), where a gate can be closed by each reason.
OF_CELLS = "run_program"
ONLY_PROGRAMS = "the node has a ~cell: any other command that moves the robot"


def number(error_id):
    """As the page has it: those of path loading are decimal."""
    return str(error_id) if 1000 <= error_id < 2000 else f"16#{error_id:X}"


def rows(page):
    """(block, id): raised when"""
    table, block = {}, ""
    for line in page.splitlines():
        if heading := BLOCK.match(line):
            block = heading.group(1)
        elif row := ROW.match(line):
            table[block, int(row.group(1))] = row.group(2)
    return table


def provoked(files):
    seen = set()
    for file in files:
        for line in pathlib.Path(file).read_text(encoding="utf-8").splitlines():
            block, error_id = line.split()
            seen.add((block, int(error_id, 16)))
    return seen


def main():
    page, files = sys.argv[1], sys.argv[2:]
    table, seen = rows(pathlib.Path(page).read_text(encoding="utf-8")), provoked(files)
    faults = []
    for (block, error_id), raised_when in table.items():
        impossible = raised_when.startswith("cannot occur")
        of_a_cell = block == OF_CELLS or raised_when.startswith(ONLY_PROGRAMS)
        asked_for = not of_a_cell and (block, error_id) not in TOO_LONG_FOR_A_TEST and (
            block not in WITH_FOREIGN_MESSAGES or error_id in WITH_FOREIGN_MESSAGES[block])
        if asked_for and not impossible and (block, error_id) not in seen:
            faults.append(f"{block} {number(error_id)} was provoked by no test: {raised_when}")
        if impossible and (block, error_id) in seen:
            faults.append(f"{block} {number(error_id)} was provoked: {raised_when}")
    faults += [f"{block} {number(error_id)} was provoked, and is in no table" for block, error_id in
               sorted(seen - set(table))]
    print("\n".join(faults) or f"{len(seen)} of {len(table)} rows were provoked, the others cannot occur")
    return 1 if faults or not table else 0


if __name__ == "__main__":
    sys.exit(main())
