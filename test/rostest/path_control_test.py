#!/usr/bin/env python3
"""Tracking objects and feedrate over ROS: what holds paths back, and how fast they run."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus
from std_srvs.srv import Trigger

from cobot_command.msg import LoadPathFeedback, LoadPathGoal, TrackingState
from cobot_command.srv import SetFeedrate, SetTracking
from cobot_goals import path, path_to_joints
from cobot_test import Latest
from motion_checks import MotionTestCase

NAN = float("nan")


def asked(name, kind, *request, **fields):
    rospy.wait_for_service(name, 10)
    return rospy.ServiceProxy(name, kind)(*request, **fields)


def turn(to, **changes):
    """Joint 1 turns at 10 degrees in a second, in the time of the robot."""
    return path(path_to_joints(to, 0, 90, 0, 90, 0, speed=10, acceleration=100, deceleration=100), **changes)


class PathControl(MotionTestCase):
    def setUp(self):
        super().setUp()
        self.addCleanup(self.reset)
        self.tracking = Latest("tracking_state", TrackingState)

    def reset(self):
        for tracking_object in (0, 1):
            asked("set_tracking", SetTracking, tracking_object, False, False)
        asked("set_feedrate", SetFeedrate, percent=100)
        self.robot.wait_for_standstill()

    def test_a_goal_waits_for_its_tracking_object(self):
        sent = self.robot.send(turn(5, enable_tracking_1=True))
        sent.wait_for_feedback(lambda f: f.phase == LoadPathFeedback.WAITING_FOR_TRACKING, "a goal at its gate")
        self.assertIn("tracking object 1 to be on", sent.feedback[-1].text)
        self.assertFalse(sent.feedback[-1].loaded)
        self.assertTrue(asked("set_tracking", SetTracking, 1, True, False).success)
        self.assert_done(sent.finish())
        self.tracking.wait_for(lambda s: list(s.on) == [False, True], "the object to be on")

    def test_an_automatic_object_switches_itself(self):
        self.assertTrue(asked("set_tracking", SetTracking, 0, False, True).success)
        self.assert_done(self.robot.run(turn(5, enable_tracking_0=True)))
        self.tracking.wait_for(lambda s: s.on[0] and s.automatic[0], "the object to have switched itself")

    def test_a_goal_at_its_gate_can_be_cancelled(self):
        sent = self.robot.send(turn(5, enable_tracking_0=True))
        sent.wait_for_feedback(lambda f: f.phase == LoadPathFeedback.WAITING_FOR_TRACKING, "a goal at its gate")
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())

    def test_there_are_two_objects(self):
        answer = asked("set_tracking", SetTracking, 2, True, False)
        self.assertFalse(answer.success)
        self.assertIn("allowed: 0 to 1", answer.message)

    def test_the_feedrate_is_the_time_of_a_path(self):
        self.assertTrue(asked("set_feedrate", SetFeedrate, percent=50).success)
        slow = self.assert_done(self.robot.run(turn(20))).planned_duration.to_sec()
        self.assertTrue(asked("set_feedrate", SetFeedrate, percent=125).success)
        fast = self.assert_done(self.robot.run(turn(0))).planned_duration.to_sec()
        self.assertAlmostEqual(slow, 2.5 * fast, delta=0.01)

    def test_a_feedrate_outside_its_range_is_refused(self):
        for percent in (-1, 125.1, NAN, math.inf):
            with self.subTest(percent=percent):
                answer = asked("set_feedrate", SetFeedrate, percent=percent)
                self.assertEqual((answer.success, answer.error_id), (False, 0x273))
                self.assertIn("allowed: 0 to 125", answer.message)

    def test_a_path_is_stopped_on_its_way_and_goes_on(self):
        sent = self.robot.send(turn(40))
        sent.wait_for_feedback(lambda f: f.active, "a path under way")
        self.robot.wait_for_motion()
        self.assertTrue(asked("stop_on_path", Trigger).success)
        sent.wait_for_feedback(lambda f: f.phase == LoadPathFeedback.HELD, "a path that is held")
        self.robot.wait_for_standstill()
        self.assertTrue(asked("resume_path", Trigger).success)
        self.assert_done(sent.finish())
        self.assert_stands_at((40, 0, 90, 0, 90, 0))

    def test_the_rest_of_a_path_goes_on_at_another_feedrate(self):
        sent = self.robot.send(turn(40))
        sent.wait_for_feedback(lambda f: f.active, "a path under way")
        self.robot.wait_for_motion()
        answer = asked("set_feedrate", SetFeedrate, percent=50, restart=True)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.from_point, 0)
        self.assert_done(sent.finish())
        self.assert_stands_at((40, 0, 90, 0, 90, 0))

    def test_a_path_ends_whose_rest_cannot_be_planned(self):
        points = [path_to_joints(to, 0, 90, 0, 90, 0, speed=36, acceleration=180, deceleration=180) for to in (40, 0)]
        sent = self.robot.send(path(*points, execution=LoadPathGoal.SCRIPT))
        sent.wait_for_feedback(lambda f: f.active, "a path under way")
        self.robot.wait_for_motion()
        self.assertTrue(asked("set_feedrate", SetFeedrate, percent=51, restart=True).success)
        state, result = sent.finish()
        self.assert_aborted((state, result), 0x276)
        self.assertIn("at a feedrate of 51 %", result.error_description)

    def test_a_path_waits_while_paths_are_stopped(self):
        self.assertTrue(asked("set_feedrate", SetFeedrate, percent=0).success)
        sent = self.robot.send(turn(5))
        sent.wait_for_feedback(lambda f: f.phase == LoadPathFeedback.HELD, "a path that waits")
        self.assertTrue(asked("set_feedrate", SetFeedrate, percent=80).success)
        self.assert_done(sent.finish())


if __name__ == "__main__":
    import rostest

    rospy.init_node("path_control_test")
    rostest.rosrun("cobot_command", "path_control", PathControl)
