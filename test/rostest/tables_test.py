#!/usr/bin/env python3
"""Tools, frames and loads 0..15: written and read by services, told by a topic, kept by a file over a restart."""
import math
import os
import shutil
import signal
import tempfile
import unittest

import rospy

from cobot_command import srv
from cobot_command.msg import DataTables, FrameData, LoadData, MomentOfInertia, ToolData, Transformation
from cobot_test import DEADLINE, Latest
from own_nodes import Heard, node
from waiting import wait_until

GRIPPER = ToolData(index=3, name="gripper", tcp=Transformation(0, 0, 150, 0, 0, 90), load=1)
HEAVY = LoadData(index=1, mass=2.5, moment_of_inertia=MomentOfInertia(2000, 1000, 500),
                 mass_center=Transformation(0, 0, 80, 0, 0, 0))
TABLE = FrameData(index=4, name="table", name_only=True)
PALLET = FrameData(index=5, pose=Transformation(10, 20, 30, 0, 0, 0), reference=4)


class TableTestCase(unittest.TestCase):
    """A command node without a controller, for each test."""

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.file = os.path.join(self.folder, "tables")
        if rospy.has_param("/tried"):
            rospy.delete_param("/tried")

    def start(self, **parameters):
        rospy.set_param("/tried", dict(parameters, robot_model="tm5-900"))
        process = node("command_node", "tried", process=Heard)
        self.addCleanup(process.clear_away)
        for kind in ("tool", "frame", "load"):
            rospy.wait_for_service(f"write_{kind}", DEADLINE)
        self.topic = Latest("data_tables", DataTables)
        return process

    def end(self, process):
        self.assertEqual(process.end(signal.SIGINT)[0], 0)

    def read(self, kind, index):
        return rospy.ServiceProxy(f"read_{kind}", getattr(srv, f"Read{kind.title()}"))(index)

    def try_to_write(self, data):
        kind = type(data).__name__.replace("Data", "")
        return rospy.ServiceProxy(f"write_{kind.lower()}", getattr(srv, f"Write{kind}"))(data)

    def write(self, *entries):
        for data in entries:
            answer = self.try_to_write(data)
            self.assertTrue(answer.success, answer.message)
        return answer

    def assert_refused(self, answer, error_id, *words):
        self.assertFalse(answer.success)
        self.assertEqual(answer.error_id, error_id, answer.message)
        for word in words:
            self.assertIn(word, answer.message)

    def content(self):
        with open(self.file, encoding="utf-8") as text:
            first, *entries, last = [line for line in text.read().splitlines() if not line.startswith("#")]
        self.assertEqual((first, last), ("begin", f"end {len(entries)}"))
        return entries


class Tables(TableTestCase):
    def setUp(self):
        super().setUp()
        self.start()

    def test_are_empty_but_for_number_zero(self):
        tool = self.read("tool", 0)
        self.assertTrue(tool.success)
        self.assertFalse(tool.tool.empty)
        self.assertTrue(self.read("tool", 1).tool.empty)
        self.assertTrue(self.read("frame", 15).frame.empty)
        self.assertTrue(self.read("load", 7).load.empty)
        told = self.topic.wait_for(lambda m: True, "the tables")
        self.assertEqual((told.tools, told.frames, told.loads), ([], [], []))

    def test_give_back_what_was_written(self):
        self.write(HEAVY, GRIPPER, TABLE, PALLET)
        self.assertEqual(self.read("tool", 3).tool, GRIPPER)
        self.assertEqual(self.read("load", 1).load, HEAVY)
        self.assertEqual(self.read("frame", 4).frame, TABLE)
        self.assertEqual(self.read("frame", 5).frame, PALLET)

    def test_tell_of_every_change_and_of_nothing_else(self):
        before = rospy.Time.now()
        answer = self.write(TABLE)
        self.assertTrue(answer.data_changed)
        self.assertGreaterEqual(answer.stamp, before)
        told = self.topic.wait_for(lambda m: m.frames, "the new frame")
        self.assertEqual(told.frames, [TABLE])
        self.assertEqual(told.stamp, answer.stamp)
        again = self.write(TABLE)
        self.assertFalse(again.data_changed)
        self.assertEqual(again.stamp, answer.stamp)
        self.write(HEAVY)
        self.topic.wait_for(lambda m: m.loads, "the new load")
        self.assertEqual(len([m for m in self.topic.all() if m.frames and not m.loads]), 1)

    def test_say_since_the_last_read_whether_an_entry_has_changed(self):
        self.assertFalse(self.read("tool", 3).data_changed)
        stamp = self.write(ToolData(index=3, name="gripper", name_only=True)).stamp
        read = self.read("tool", 3)
        self.assertTrue(read.data_changed)
        self.assertEqual(read.stamp, stamp)
        self.assertFalse(self.read("tool", 3).data_changed)
        self.assertTrue(self.read("tool", 2).stamp.is_zero())

    def test_empty_an_entry(self):
        self.write(TABLE)
        self.write(FrameData(index=4, empty=True))
        self.assertTrue(self.read("frame", 4).frame.empty)

    def test_refuse_numbers_that_are_not_theirs(self):
        for index in (0, 16, -1):
            self.assert_refused(self.try_to_write(ToolData(index=index)), 0x8D35, f"tool {index}: ", "1 to 15")
            self.assert_refused(self.try_to_write(FrameData(index=index)), 0x8D08, "1 to 15")
            self.assert_refused(self.try_to_write(LoadData(index=index)), 0x8D17, "1 to 15")
        self.assert_refused(self.read("tool", 16), 0x8D35, "0 to 15")
        self.assert_refused(self.read("frame", -1), 0x8D08, "0 to 15")
        self.assert_refused(self.read("load", 16), 0x8D17, "0 to 15")

    def test_refuse_entries_that_cannot_be_and_change_nothing(self):
        self.write(TABLE, FrameData(index=1, reference=4))
        refused = [(FrameData(index=2, reference=1), 0x8C12, "its reference, frame 1, refers to frame 4"),
                   (FrameData(index=2, reference=7), 0x8C13, "frame 7, is not configured"),
                   (FrameData(index=2, reference=2), 0x8C13, "it refers to itself"),
                   (LoadData(index=2, mass=5), 0x8D49, "0 to 4 kg, the payload of tm5-900"),
                   (LoadData(index=2, moment_of_inertia=MomentOfInertia(0, -1, 0)), 0x21D, "-1 kg mm^2"),
                   (ToolData(index=2, load=9), 0x8D17, "its load 9 is not configured"),
                   (ToolData(index=2, tcp=Transformation(z=math.nan)), 0x200, "coordinate 3 of the pose is nan"),
                   (ToolData(index=2, tcp=Transformation(rz=100001)), 0x213, "coordinate 6 of the pose is 100001"),
                   (ToolData(index=2, name_only=True), 0x21F, "neither a name nor a pose"),
                   (ToolData(index=2, name="x" * 256), 0x21F, "256 bytes")]
        for data, error_id, words in refused:
            with self.subTest(data):
                self.assert_refused(self.try_to_write(data), error_id, words)
        for kind in ("tool", "frame", "load"):
            self.assertTrue(getattr(self.read(kind, 2), kind).empty)


class TablesFile(TableTestCase):
    def test_keeps_what_was_written_over_a_restart(self):
        first = self.start(tables_file=self.file, loads=["1=1"])
        self.assertFalse(os.path.exists(self.file))
        self.write(HEAVY, GRIPPER, TABLE, PALLET)
        self.assertEqual(self.content(), ["tool 3=gripper:0,0,150,0,0,90@1", "frame 4=table", "frame 5=10,20,30,0,0,0@4",
                                          "load 1=2.5,2000,1000,500,0,0,80,0,0,0"])
        self.end(first)
        second = self.start(tables_file=self.file, loads=["1=1"])
        self.assertEqual(self.read("tool", 3).tool, GRIPPER)
        self.assertEqual(self.read("load", 1).load, HEAVY)
        wait_until(lambda: "remove the file to use the parameters" in second.output(), "the warning")
        told = self.topic.wait_for(lambda m: m.tools, "the kept tables")
        self.assertEqual(told.frames, [TABLE, PALLET])
        self.assertEqual(os.listdir(self.folder), ["tables"])

    def test_that_cannot_be_written_refuses_the_write_and_nothing_changes(self):
        self.start(tables_file=self.file)
        self.write(TABLE)
        os.mkdir(self.file + ".new")  # in the way of the new file
        self.assert_refused(self.try_to_write(HEAVY), 0x232, "tables.new cannot be written", "~tables_file")
        self.assertTrue(self.read("load", 1).load.empty)
        self.assertEqual(self.content(), ["frame 4=table"])
        os.rmdir(self.file + ".new")
        self.write(HEAVY)

    def test_that_cannot_be_used_ends_the_node_at_once(self):
        with open(self.file, "w", encoding="utf-8") as text:
            text.write("load 1=2\ntool 3=1,2,3\n")
        cut = os.path.join(self.folder, "cut")
        with open(cut, "w", encoding="utf-8"):
            pass
        for path, words in ((self.file, 'line 2, "tool 3=1,2,3": there are 3 numbers'), (cut, "the file is truncated"),
                            (os.path.join(self.folder, "no", "tables"), "cannot be written"), (self.folder, "folder")):
            with self.subTest(path):
                rospy.set_param("/tried", {"robot_model": "tm5-900", "tables_file": path})
                process = node("command_node", "tried", process=Heard)
                self.addCleanup(process.clear_away)
                self.assertEqual(process.wait(), 2)
                self.assertIn(f"parameter /tried/tables_file is {path}", process.output())
                self.assertIn(words, process.output())


class TableParameters(TableTestCase):
    def test_are_lists(self):
        self.start(tools=["3=gripper:0,0,150,0,0,90@1"], frames=["4=table"],
                   loads=["1=2.5,2000,1000,500,0,0,80,0,0,0"])
        self.assertEqual(self.read("tool", 3).tool, GRIPPER)
        self.assertEqual(self.read("frame", 4).frame, TABLE)
        self.assertEqual(self.read("load", 1).load, HEAVY)


if __name__ == "__main__":
    import rostest

    rospy.init_node("tables_test")
    rostest.rosrun("cobot_command", "tables", "tables_test")  # all classes of this file
