#!/usr/bin/env python3
"""The end of scripts/test: what is counted, and what is named as failed."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import print_summary  # noqa: E402

PASSED = '<testcase name="{}" time="0.5" status="run"/>'
FAILED = '<testcase name="{}" time="0.5" status="fail"><failure message="it failed"/></testcase>'
SKIPPED = '<testcase name="{}" time="0" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>'
MISSING = '<testcase name="{}" time="0" status="notrun"><skipped message="Unable to find required file"/></testcase>'


class Summary(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, name, *cases):
        path = pathlib.Path(self.folder.name) / name
        path.parent.mkdir(exist_ok=True)
        path.write_text("<testsuite>" + "".join(cases) + "</testsuite>", encoding="utf-8")
        return path

    def lines(self, *entries, outcome=0, failed_phases=()):
        return print_summary.verdict(print_summary.tests_of(self.write("report-1.xml", *entries)), outcome, failed_phases, "Building")

    def test_counts_the_tests_of_a_program_and_not_the_program(self):
        self.write("reports/link.all.xml", PASSED.format("link.A.a"), PASSED.format("link.A.b"))
        self.assertEqual(self.lines(PASSED.format("link.all"), PASSED.format("rostest.stop")), ["3 passed, 0 failed, 0 skipped"])

    def test_names_what_failed_and_what_was_skipped(self):
        self.write("reports/link.all.xml", PASSED.format("link.A.a"), FAILED.format("link.A.b"))
        self.assertEqual(self.lines(FAILED.format("link.all"), SKIPPED.format("rostest.stop"), outcome=1, failed_phases=["Running tests"]),
                         ["  skipped: rostest.stop", "  failed: link.A.b", "  failed phase: Running tests", "1 passed, 1 failed, 1 skipped"])

    def test_names_a_program_that_failed_after_its_tests(self):
        self.write("reports/link.all.xml", PASSED.format("link.A.a"))
        self.assertEqual(self.lines(FAILED.format("link.all")), ["  failed: link.all", "1 passed, 1 failed, 0 skipped"])

    def test_names_a_program_that_is_missing(self):
        self.assertEqual(self.lines(MISSING.format("link.all")), ["  failed: link.all", "0 passed, 1 failed, 0 skipped"])

    def test_names_a_failed_phase_beside_failed_tests(self):
        self.assertEqual(self.lines(FAILED.format("rostest.stop"), outcome=1, failed_phases=["Running tests", "Running clang-tidy"]),
                         ["  failed: rostest.stop", "  failed phase: Running tests", "  failed phase: Running clang-tidy",
                          "0 passed, 1 failed, 0 skipped"])

    def test_names_the_phase_of_an_end_without_a_failed_test(self):
        self.assertEqual(print_summary.verdict([], 1, [], "Building"), ["  ended with 1 in the phase: Building", "0 passed, 0 failed, 0 skipped"])

    def test_has_no_tests_without_a_report(self):
        self.assertEqual(print_summary.tests_of(pathlib.Path(self.folder.name) / "report-1.xml"), [])


if __name__ == "__main__":
    unittest.main()
