#!/usr/bin/env python3
"""The report is drawn, whatever is in the run and whatever is not. Needs no master.

Usage: report_test.py FOLDER, for the pictures"""
import base64
import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from actionlib_msgs.msg import GoalStatus

from bags import HOME, duration, encoded, write_short_run
from flight import html_page, report
from flight.analysis import analyse
from flight.drawing import page, style, tables
from flight.run import RunError
from flight.verdict import Difference, Verdict
from reading_test import BagTestCase

FOLDER = pathlib.Path(sys.argv.pop(1))
PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "recorder" / "flight_report.py"
PNG = b"\x89PNG\r\n\x1a\n"


def write_ends(maker):
    """A small path, and goals that end in each way; the refused ones behind the motion."""
    maker.data()
    maker.question(0)
    for step in range(50):
        maker.joints(0.1 + step / 50, [step / 25, *HOME[1:]], [2, 0, 0, 0, 0, 0])
    maker.goal(0.1, "move_absolute", "stopped")
    maker.script(0.15, "1", ["QueueTag(1,0)", "QueueTag(2,0)"])
    maker.script(0.6, "2", ["StopAndClearBuffer()"])
    maker.result(0.7, "move_absolute", "stopped", GoalStatus.PREEMPTED)
    maker.goal(1, "move_absolute", "failed")
    maker.script(1.05, "3", ["QueueTag(3,0)"])
    maker.tag(1.1, 3, "false")
    maker.result(1.15, "move_absolute", "failed", GoalStatus.ABORTED, error_id=0x226)
    maker.goal(5, "move_absolute", "refused")
    maker.result(5.001, "move_absolute", "refused", GoalStatus.REJECTED, error_id=0x201)
    maker.joints(9)


class Drawn(BagTestCase):
    def axes(self, draw):
        """What draw(figure, analysis) has drawn of write_ends()."""
        with page.styled():
            figure = Figure(figsize=(page.WIDTH, 6))
            draw(figure, analyse(self.made(write_ends)))
            return figure.axes

    def test_refused_stopped_and_failed_are_three_colours_in_head_lane_and_table(self):
        self.assertEqual(len({style.GOOD, style.BAD, style.REFUSED, style.STOPPED, style.OPEN}), 5)
        analysis = analyse(self.made(write_ends))
        self.assertEqual(list(tables.verdict_words(analysis))[1:],
                         [("1 of 3 goals failed", style.BAD), ("1 of 3 goals refused", style.REFUSED), ("1 of 3 goals stopped", style.STOPPED)])
        text = html_page.goal_table(analysis)
        for outcome, colour in (("PREEMPTED", style.STOPPED), ("ABORTED", style.BAD), ("REJECTED", style.REFUSED)):
            self.assertIn(f'<b style="color:{colour}">{outcome}</b>', text)

    def test_a_goal_without_length_has_a_mark_in_its_lane_though_it_came_behind_the_motion(self):
        _, line = self.axes(lambda figure, analysis: page.draw_times(figure, analysis, 2))
        mark, = (drawn for drawn in line.lines if drawn.get_marker() == "D")
        begun, = mark.get_xdata()
        self.assertAlmostEqual(begun, 5, 3)
        self.assertEqual(mark.get_color(), style.REFUSED)
        left, right = line.get_xlim()
        self.assertTrue(left < begun < right, (left, right))
        self.assertIn("REJECTED 16#201", {text.get_text().strip() for text in line.texts})

    def test_tags_that_a_wanted_stop_drops_are_no_failures(self):
        _, line = self.axes(lambda figure, analysis: page.draw_times(figure, analysis, 2))
        bars = {round(bar.get_x(), 2): to_hex(bar.get_facecolor()) for bar in line.patches if isinstance(bar, Rectangle) and bar.get_height() > 0.6}
        self.assertEqual((bars[0.15], bars[0.6], bars[1.05]), (style.STOPPED, style.STOPPED, style.BAD))
        words = html_page.tag_table(analyse(self.made(write_ends)))
        self.assertEqual([words.count(f"<td>{end}</td>") for end in ("dropped by a stop", "failed")], [2, 1])

    def test_the_curve_of_a_joint_fills_its_strip_and_the_limits_are_in_the_corner(self):
        angles, speeds, *_ = self.axes(page.draw_joints)
        for axes, size, words in ((angles, 1.96, "-270° to 270°"), (speeds, 2, "±180°/s")):
            low, high = axes.get_ylim()
            self.assertGreater(size / (high - low), 0.6, (low, high))
            self.assertIn(words, {text.get_text() for text in axes.texts})

    def test_a_limit_is_drawn_where_the_curve_comes_near_it(self):
        def fill(maker):
            maker.data()
            maker.question(0)
            for step in range(50):
                maker.joints(step / 50, [265 + step / 10, *HOME[1:]], [5, 0, 0, 0, 0, 0])

        with page.styled():
            figure = Figure(figsize=(page.WIDTH, 6))
            page.draw_joints(figure, analyse(self.made(fill)))
        self.assertIn(270, [line.get_ydata()[0] for line in figure.axes[0].lines if line.get_color() == style.LIMIT])

    def test_is_drawn_whatever_texts_and_numbers_there_are(self):
        def fill(maker):
            write_ends(maker)
            maker.data(2, control_box_sn="\x00$\\frac$\x1b[31m", layer_version="$x_$")
            maker.goal(2, "load_path", "odd", path_file="$^{$\x00")
            maker.result(3, "load_path", "odd", 99, planned_duration=duration(2**31 - 1), actual_duration=duration(-2**31 + 1), error_id=7,
                         error_description="$TMSCT,1$ \x07")
            maker.result(3, "move_circle", "odd", planned_duration=duration(1e9), actual_duration=duration(1e-9), command_id_ack=-5)

        folder = FOLDER / self.id().rpartition(".")[2]
        _, (_, written) = report.write(self.made(fill), [], folder)
        for picture in re.findall(r"svg\+xml;base64,([^\"]+)", written.read_text(encoding="utf-8")):
            xml.etree.ElementTree.fromstring(base64.b64decode(picture))


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

    def test_goals_that_were_refused_show_their_error_and_did_not_fail(self):
        def fill(maker):
            write_short_run(maker)
            maker.result(1.5, "move_relative", "b", GoalStatus.REJECTED, error_id=0x205, error_description="J3 <-155 deg", remedy="move less")

        _, page = self.written(fill)
        self.assert_has(page, r"<td>move_relative</td>.*REJECTED</b></td><td>16#205</td><td>J3 &lt;-155 deg → move less</td>")
        for words in ("no goal failed", "1 of 2 goals refused"):
            self.assert_has(page, words)

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
        self.assertIn("does not exist", done.stdout)
        self.assertIn("--no-replay draws without", done.stdout)
        self.assertTrue((folder / "report.png").is_file())

    def test_tells_a_folder_that_it_cannot_use(self):
        with self.assertRaisesRegex(RunError, "cannot be written into .*give another folder"):
            report.write(self.made(write_short_run), [], self.file / "below a file")


if __name__ == "__main__":
    unittest.main()
