#!/usr/bin/env python3
"""What doc/path.md draws is what the formulas of its laws and corners say.

Usage: path_curves_test.py path_curves
"""
import collections
import csv
import subprocess
import sys
import unittest

PROGRAM = sys.argv.pop(1)


def printed(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=60, check=False)


def curves(kind, *names):
    rows = collections.defaultdict(list)
    for row in csv.DictReader(printed(kind).stdout.splitlines()):
        rows[tuple(row.pop(name) for name in names)].append({column: float(value) for column, value in row.items()})
    return rows


def moving_time(rows):
    """Between the first row of rest and the last one, which are a step outside."""
    return rows[-2]["time"]


class PathCurves(unittest.TestCase):
    def test_laws_take_their_time(self):
        laws = curves("laws", "law", "share")
        times = {"S_CURVE": (1.5, 1.6, 1.75), "MOD_SINE": (1.5, 1.6376, 1.8798), "POLY5": (1.5, 1.6522, 1.9375),
                 "SINE2": (1.5, 1.6667, 2.0)}
        self.assertEqual(len(laws), 12)
        for law, wanted in times.items():
            for share, time in zip(("0", "50", "100"), wanted):
                with self.subTest(law=law, share=share):
                    rows = laws[law, share]
                    self.assertGreaterEqual(moving_time(rows), time - 1e-9)
                    self.assertLessEqual(moving_time(rows), time + 0.0035)  # ramps and cruise are whole milliseconds
                    self.assertLessEqual(max(row["speed"] for row in rows), 90.001)
                    self.assertLessEqual(max(abs(row["acceleration"]) for row in rows), 180.01)
                    self.assertGreater(max(row["acceleration"] for row in rows), 178)
                    self.assertEqual((rows[0]["speed"], rows[-1]["speed"]), (0, 0))

    def test_corners_are_passed_as_near_as_the_tolerance_says(self):
        corners = curves("corner", "tolerance")
        for tolerance, time, nearest in (("0", 2.4, 0), ("5", 2.2586, 1.768), ("100", 2.2, 3.536)):
            with self.subTest(tolerance=tolerance):
                rows = corners[tolerance,]
                self.assertAlmostEqual(moving_time(rows), time, delta=0.003)
                self.assertAlmostEqual(min((row["y"] ** 2 + row["z"] ** 2) ** 0.5 for row in rows), nearest, delta=0.02)

    def test_refuses_other_curves(self):
        done = printed("heart")
        self.assertEqual(done.returncode, 2)
        self.assertIn("allowed: laws, corner", done.stderr)


if __name__ == "__main__":
    unittest.main()
