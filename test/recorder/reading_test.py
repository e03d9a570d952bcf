#!/usr/bin/env python3
"""A bag becomes a run, or says why it does not. Needs no master."""
import pathlib
import tempfile
import unittest

import rosbag
from actionlib_msgs.msg import GoalID, GoalStatus

import cobot_command.msg
from bags import BEGAN, HOME, NAMES, SOURCES, BagMaker, write_short_run
from cobot_command.msg import CommandStatus, RobotStatus
from flight import bag_reader, topics, wholeness
from flight.run import RunError


class BagTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "run.bag"

    def made(self, fill, namespace="", wanted=None):
        """The run of a bag that `fill` has written."""
        with BagMaker(self.file, namespace) as maker:
            fill(maker)
        return bag_reader.read(self.file, wanted)

    def assert_refused(self, words, fill, wanted=None):
        with self.assertRaisesRegex(RunError, words):
            self.made(fill, wanted=wanted)


class Reading(BagTestCase):
    def test_takes_joints_tool_frames_and_limits(self):
        run = self.made(write_short_run)
        self.assertEqual(run.joints.names, NAMES)
        self.assertEqual(run.joints.angles[0].round(6).tolist(), HOME)
        self.assertEqual(run.joints.angles[-1].round(6).tolist(), [45, *HOME[1:]])
        self.assertEqual(run.joints.speeds[-1].round(6).tolist(), [45, 0, 0, 0, 0, 0])
        self.assertEqual(run.tool.places[0].round(6).tolist(), [500, 0, 300])
        self.assertEqual([(frame.sent, frame.meaning) for frame in run.frames][:2], [(True, "in a Listen node?"), (False, "in a Listen node: Listen1")])
        self.assertEqual((run.axes[2].lower, run.axes[2].upper, run.axes[2].rated_speed), (-155, 155, 180))
        self.assertEqual(run.identity["model"], "tm5-900")
        self.assertEqual(len(run.planned), 1)
        self.assertAlmostEqual(run.began, BEGAN, 3)
        self.assertAlmostEqual(run.duration, 1.31, 3)

    def test_joins_what_is_of_one_goal(self):
        def fill(maker):
            maker.joints(0)
            maker.goal(0.1, "move_absolute", "a", speed=50)
            maker.goal(0.2, "stop", "a")
            maker.feedback(0.3, "move_absolute", "a", progress=0.5)
            maker.write("move_absolute/cancel", GoalID(id="a"), 0.4)
            maker.result(0.5, "move_absolute", "a", GoalStatus.PREEMPTED)
            maker.frame(0.6, True, b"", "")

        moved, stopped = self.made(fill).goals
        self.assertEqual((moved.action, moved.message.speed, len(moved.feedback), moved.end.status), ("move_absolute", 50, 1, GoalStatus.PREEMPTED))
        self.assertAlmostEqual(moved.cancelled[0], 0.4, 3)
        self.assertIsNone(stopped.end)

    def test_tells_speeds_where_the_stream_does_not(self):
        def fill(maker):
            maker.frame(0, True, b"", "")
            for step in range(5):
                maker.joints(0.1 * step, [10 * step, *HOME[1:]], ())

        self.assertEqual(self.made(fill).joints.speeds[:, 0].round(3).tolist(), [100] * 5)

    def test_tells_what_holds_the_robot(self):
        def fill(maker):
            maker.joints(0)
            maker.frame(0, True, b"", "")
            for time, held in enumerate((0, 0, 1, 1, 0)):
                maker.state(time, safeguard=held, project_paused=RobotStatus.UNKNOWN)

        self.assertEqual([(round(time), held) for time, held in self.made(fill).states], [(0, ""), (2, "safeguard"), (4, "")])

    def test_finds_the_one_robot_in_its_namespace(self):
        self.assertEqual(self.made(write_short_run, "cell/robot_1").namespace, "cell/robot_1")

    def test_wants_to_know_which_of_several_robots(self):
        with BagMaker(self.file, "robot_1") as maker:
            write_short_run(maker)
            maker.namespace = "/robot_2/"
            maker.frame(2, True, b"", "")
        with self.assertRaisesRegex(RunError, "/robot_1, /robot_2; choose one"):
            bag_reader.read(self.file)
        self.assertEqual(len(bag_reader.read(self.file, "/robot_1").goals), 1)

    def test_refuses_a_bag_without_joint_states(self):
        self.assert_refused("has no joint_states: the status stream was missing", lambda maker: maker.question(0))

    def test_refuses_a_bag_without_frames(self):
        self.assert_refused("has no topic frames; it has joint_states", lambda maker: maker.joints(0))

    def test_refuses_what_is_no_bag(self):
        for content, words in ((b"", "cannot be read"), (b"no bag at all, but some text of several bytes", "cannot be read")):
            self.file.write_bytes(content)
            with self.assertRaisesRegex(RunError, words):
                bag_reader.read(self.file)
        with self.assertRaisesRegex(RunError, "there is no bag"):
            bag_reader.read(self.file.with_name("nowhere.bag"))

    def test_refuses_a_bag_that_was_not_closed(self):
        maker = BagMaker(self.file)
        write_short_run(maker)
        maker.bag.flush()
        unclosed = self.file.with_suffix(".active")
        unclosed.write_bytes(self.file.read_bytes())
        maker.bag.close()
        with self.assertRaisesRegex(RunError, "was not closed, .*rosbag reindex"):
            bag_reader.read(unclosed)

    def test_refuses_an_empty_bag(self):
        rosbag.Bag(str(self.file), "w").close()
        with self.assertRaisesRegex(RunError, "has no messages"):
            bag_reader.read(self.file)


class Wholeness(BagTestCase):
    def test_a_whole_recording_has_no_faults(self):
        run = self.made(write_short_run)
        self.assertEqual((wholeness.faults(run), wholeness.remarks(run)), ([], []))

    def test_lost_messages_are_counted(self):
        def fill(maker):
            write_short_run(maker)
            maker.lose("frames", 3)
            maker.question(2)

        self.assertEqual(wholeness.faults(self.made(fill)), ["3 of frames lost before 2.000 s"])

    def test_a_goal_without_a_result_is_missing_its_end(self):
        def fill(maker):
            write_short_run(maker)
            maker.goal(1.4, "move_absolute", "late")

        self.assertRegex(wholeness.faults(self.made(fill))[0], r"move_absolute, a goal of 1.400 s, has no result")

    def test_what_is_no_fault_of_the_recording_is_remarked(self):
        def fill(maker):
            maker.joints(0)
            maker.send(0.1, b"$TMSCT,15,7,ScriptExit(0),*5F\r\n", "run script 7: ScriptExit(0)")
            maker.receive(0.2, b"$TMSCT", "not understood: the stream ended inside a frame")
            maker.result(0.3, "stop", "unheard")

        run = self.made(fill)
        self.assertEqual(wholeness.faults(run), [])
        for words, said in zip(("before the recorder was connected", "could not read", "script 7 .* has no reply", "no limits"), wholeness.remarks(run)):
            self.assertRegex(said, words)

    def test_link_breaks_are_where_the_connection_ends(self):
        from flight.simulator_replay import link_breaks
        states = (CommandStatus.DISCONNECTED, CommandStatus.CONNECTING, CommandStatus.PROBING, CommandStatus.READY, CommandStatus.CONNECTING,
                  CommandStatus.READY)
        self.assertEqual(link_breaks(list(enumerate(states))), [4])


class Topics(unittest.TestCase):
    def test_every_action_of_the_package_is_recorded(self):
        actions = topics.actions_in(dir(cobot_command.msg))
        self.assertEqual(len(actions), len(list((SOURCES / "action").glob("*.action"))))
        names = topics.recorded(actions)
        for name in ("change_tcp/goal", "pick_and_place/result", "follow_joint_trajectory/feedback", "frames"):
            self.assertIn(name, names)
        self.assertNotIn("status_frames", names)
        self.assertIn("status_frames", topics.recorded(actions, with_status_frames=True))


if __name__ == "__main__":
    unittest.main()
