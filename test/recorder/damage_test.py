#!/usr/bin/env python3
"""Whatever bytes a bag consists of: it becomes a run, or a sentence says why not. Needs no master."""
import contextlib
import io
import random
import subprocess
import sys
import unittest

import genpy.dynamic
import rosbag
from std_msgs.msg import Header, String

from bags import SOURCES, write_short_run
from flight import bag_reader, wholeness
from flight.analysis import analyse
from flight.run import RunError
from reading_test import BagTestCase

MAGIC = b"#ROSBAG V2.0\n"
CASES = 250


def flipped(chance, content):
    """1 to 50 bits of it are others."""
    damaged = bytearray(content)
    for _ in range(chance.choice((1, 5, 50))):
        bit = chance.randrange(8 * len(damaged))
        damaged[bit // 8] ^= 1 << bit % 8
    return damaged


def overwritten(chance, content):
    begin, count = chance.randrange(len(content)), chance.randrange(1, 300)
    return content[:begin] + chance.randbytes(count) + content[begin + count:]


def cut(chance, content):
    return content[:chance.randrange(len(content))]


class Damage(BagTestCase):
    def read_quietly(self, content):
        """The library prints warnings."""
        self.file.write_bytes(content)
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            return analyse(bag_reader.read(self.file))

    def test_a_damaged_bag_becomes_a_run_or_a_sentence(self):
        self.made(write_short_run)
        content = self.file.read_bytes()
        for damage in (flipped, overwritten, cut):
            chance = random.Random(3)
            ends = []
            for case in range(CASES):
                with self.subTest(damage=damage.__name__, case=case):
                    try:
                        self.read_quietly(damage(chance, content))
                        ends.append("")
                    except RunError as reason:
                        ends.append(str(reason))
            self.assertEqual(len(ends), CASES)
            self.assertGreater(sum(bool(end) for end in ends), CASES / 4)

    def test_garbage_is_no_bag(self):
        chance = random.Random(7)
        for content in (chance.randbytes(200_000), MAGIC, MAGIC + chance.randbytes(200_000), MAGIC + b"\xff" * 5000, bytes(5000)):
            with self.assertRaisesRegex(RunError, "run.bag (cannot be read as a bag|was not closed)"):
                self.read_quietly(content)

    def test_a_definition_that_was_damaged_is_told_by_its_sum(self):
        self.made(write_short_run)
        content = self.file.read_bytes()
        self.assertIn(b"float64[] position", content)
        # The library keeps definitions by their sums; a program reads one bag.
        rosbag.bag._message_types.clear()
        self.addCleanup(rosbag.bag._message_types.clear)
        with self.assertRaisesRegex(RunError, "is damaged: the definition of sensor_msgs/JointState of joint_states has the checksum"):
            self.read_quietly(content.replace(b"float64[] position", b"float64[] qosition"))

    def test_a_bag_of_another_version_is_told_by_the_field_that_it_lacks(self):
        def fill(maker):
            maker.joints(0)
            trace = genpy.dynamic.generate_dynamic("cobot_command/FrameTrace", "bool sent\n")["cobot_command/FrameTrace"]
            maker.write("frames", trace(sent=True), 0.1)

        self.assert_refused("has cobot_command/FrameTrace without the field header: .* another version of cobot_command", fill)

    def test_topics_of_our_names_and_others_types_are_others(self):
        def fill(maker):
            write_short_run(maker)
            for name in ("messages", "tool_pose", "planned_path", "robot_data", "door/goal", "door/cancel", "door/feedback", "door/result"):
                maker.write("other/" + name, String("x"), 0.5)
            maker.write("robot_status", Header(), 0.5)
            maker.write("door/result", String("x"), 0.5)
            maker.write("other/frames", String("x"), 0.5)

        run = self.made(fill)
        self.assertEqual([goal.action for goal in run.goals], ["move_absolute"])
        self.assertEqual(wholeness.faults(run), [])

    def test_numbers_that_are_none_are_left_out_and_told(self):
        def fill(maker):
            write_short_run(maker)
            for broken in (float("nan"), float("inf"), 1e300):
                maker.joints(1.4, [broken] * 6)
                maker.joints(1.4, [0] * 6, [broken] * 6)
                maker.tool(1.4, 0, broken, 0)
                maker.planned(1.4, (0, 0, 0), (broken, 0, 0))
            maker.data(1.4, limits=[(-270, 270, 0)] * 6)

        run = self.made(fill)
        self.assertEqual(run.unusable, {"joint_states": 6, "tool_pose": 3, "planned_path": 3, "robot_data": 1})
        self.assertIn("6 of joint_states cannot be used: their numbers are invalid or out of range", wholeness.faults(run))
        self.assertEqual(len(run.joints.times), 22)

    def test_stamps_of_another_clock_are_told_and_not_used(self):
        def fill(maker):
            write_short_run(maker)
            maker.clock = -7200
            maker.joints(1.4)
            maker.question(1.5)

        run = self.made(fill)
        self.assertAlmostEqual(run.joints.times[-1], 1.4, 3)
        self.assertAlmostEqual(run.frames[-1].time, 1.501, 3)
        self.assertRegex(wholeness.remarks(run)[0], "3 messages have stamps of another time")


class Programs(BagTestCase):
    def ended(self, program):
        done = subprocess.run([sys.executable, SOURCES / "recorder" / program, self.file], cwd=self.file.parent, capture_output=True, text=True,
                              timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr.splitlines()[-1]

    def test_end_with_2_and_a_sentence_for_garbage_and_for_a_bag_with_flipped_bits(self):
        self.made(write_short_run)
        content = bytearray(self.file.read_bytes())
        for place in range(len(MAGIC), len(content), len(content) // 50):
            content[place] ^= 16
        for damaged in (bytes(content), random.Random(1).randbytes(200_000), MAGIC + bytes(100)):
            self.file.write_bytes(damaged)
            for program in ("flight_report.py", "flight_replay.py"):
                self.assertRegex(self.ended(program), rf"^{program}: .*run.bag (cannot be read|is damaged|was not closed)")


if __name__ == "__main__":
    unittest.main()
