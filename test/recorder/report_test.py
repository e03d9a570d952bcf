#!/usr/bin/env python3
"""The report is drawn, whatever is in the run and whatever is not. Needs no master.

Usage: report_test.py FOLDER, for the pictures"""
import pathlib
import re
import subprocess
import sys
import unittest

from actionlib_msgs.msg import GoalStatus

from bags import HOME, encoded, write_short_run
from flight import report
from flight.run import RunError
from flight.verdict import Difference, Verdict
from reading_test import BagTestCase

FOLDER = pathlib.Path(sys.argv.pop(1))
PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "recorder" / "flight_report.py"
PNG = b"\x89PNG\r\n\x1a\n"


class Report(BagTestCase):
    def written(self, fill, verdicts=()):
        """(the analysis, the text of the page)"""
        folder = FOLDER / self.id().rpartition(".")[2]
        analysis, (picture, page) = report.write(self.made(fill), list(verdicts), folder)
        self.assertEqual(picture.read_bytes()[:8], PNG)
        return analysis, page.read_text(encoding="utf-8")

    def assert_has(self, page, pattern):
        """The page is too long to be shown."""
        self.assertTrue(re.search(pattern, page), f"{pattern} is not in the page")

    def test_has_all_parts_and_needs_nothing_beside_it(self):
        analysis, page = self.written(write_short_run, [Verdict("decoder", 5), Verdict("simulator", 2)])
        self.assertTrue(analysis.is_good)
        for words in ("Flight report of tm5-900", "recording whole", "decoder: 5 compared, all the same", "Queue tags", "elbow_joint",
                      "run script 1: PTP", "-100 ms", "SUCCEEDED"):
            self.assert_has(page, re.escape(words))
        self.assertEqual(page.count("data:image/svg+xml;base64,"), 3)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', page), [])

    def test_goals_that_failed_show_their_error(self):
        def fill(maker):
            write_short_run(maker)
            maker.result(1.5, "move_relative", "b", GoalStatus.REJECTED, error_id=0x205, error_description="J3 <-155 deg", remedy="move less")

        _, page = self.written(fill)
        self.assert_has(page, r"<td>move_relative</td>.*REJECTED</b></td><td>16#205</td><td>J3 &lt;-155 deg → move less</td>")
        self.assert_has(page, "1 of 2 goals failed")

    def test_shows_what_is_missing_and_what_replays_have_found(self):
        def fill(maker):
            write_short_run(maker)
            maker.lose("joint_states", 7)
            maker.joints(2, HOME)

        verdict = Verdict("simulator", 3, 0, [Difference(1.25, "tag 2", "TMSTA 01,02,true", "TMSTA 01,02,<false>")])
        analysis, page = self.written(fill, [verdict])
        self.assertFalse(analysis.is_good)
        self.assert_has(page, "7 of joint_states lost before 2.000 s")
        self.assert_has(page, r'1\.250 s</td><td>tag 2</td><td class="code">TMSTA 01,02,true</td><td class="code">TMSTA 01,02,&lt;false&gt;</td>')

    def test_is_drawn_of_a_robot_that_only_stood(self):
        def fill(maker):
            maker.joints(0)
            maker.question(0)

        self.assert_has(self.written(fill)[1], "no limits are drawn")

    def test_is_drawn_of_a_long_and_crowded_run(self):
        def fill(maker):
            maker.data()
            maker.question(0)
            for i in range(5000):
                maker.joints(0.015 * i, [i / 50 % 180, *HOME[1:]], [1.3] * 6)
            for i in range(100):
                maker.script(i / 2, str(i + 1), [f"QueueTag({i % 15 + 1},0)"])
                maker.tag(i / 2 + 0.3, i % 15 + 1)
                maker.result(i / 2 + 0.4, "move_absolute", str(i), GoalStatus.ABORTED if i == 50 else GoalStatus.SUCCEEDED, error_id=0x226 * (i == 50))
            maker.receive(60, encoded("CPERR", "04"), "controller: data error")

        _, page = self.written(fill)
        self.assert_has(page, "16#226")

    def test_is_drawn_where_a_replay_cannot_be_made(self):
        self.made(write_short_run)
        folder = FOLDER / self.id().rpartition(".")[2]
        done = subprocess.run([sys.executable, PROGRAM, self.file, "--folder", folder, "--programs", self.file.parent],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("there is no", done.stdout)
        self.assertIn("--no-replay draws without", done.stdout)
        self.assertTrue((folder / "report.png").is_file())

    def test_tells_a_folder_that_it_cannot_use(self):
        with self.assertRaisesRegex(RunError, "cannot be written into .*give another folder"):
            report.write(self.made(write_short_run), [], self.file / "below a file")


if __name__ == "__main__":
    unittest.main()
