#!/usr/bin/env python3
"""Speed override, default dynamics and software limits, by their services."""
import math

import rospy

from cobot_command import srv
from cobot_command.msg import DefaultDynamics, GroupState
from cobot_goals import to_joints
from cobot_test import CobotTestCase

LOWER = (-270, -180, -155, -180, -180, -270)
UPPER = (270, 180, 155, 180, 180, 270)
NONE = DefaultDynamics(-1, -1, -1, -1, -1)


def call(name, *arguments, **fields):
    kind = getattr(srv, "".join(word.title() for word in name.split("_")))
    return rospy.ServiceProxy(name, kind)(*arguments, **fields)


class Dynamics(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.establish_at_home()
        self.group = self.robot.latest("group_state", GroupState)
        self.addCleanup(lambda: call("change_speed_override", 100))
        self.addCleanup(lambda: call("write_default_dynamics", NONE))

    def planned(self, goal):
        goal.check_only = True
        outcome = self.robot.run(goal)
        self.assert_done(outcome)
        return outcome[1].planned_duration.to_sec()

    def test_slow_the_next_motion(self):
        goal = to_joints(60, 0, 90, 0, 90, 0, speed=50)
        full = self.planned(goal)
        answer = call("change_speed_override", 50)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.effective, 50)
        self.assertIn("next motion", answer.message)
        self.group.wait_for(lambda s: s.speed_override == 50 and s.effective_speed == 50, "the override")
        self.assertAlmostEqual(self.planned(goal), 2 * (full - 0.2) + 0.2, delta=1e-3)

    def test_refuse_an_override_out_of_its_range(self):
        for percent in (101, -1, math.nan):
            answer = call("change_speed_override", percent)
            self.assertEqual((answer.success, answer.error_id, answer.effective), (False, 0x8D23, 100), answer.message)
        self.group.wait_for(lambda s: s.speed_override == 100, "the override of before")

    def test_hold_the_robot_at_nought(self):
        move = self.robot.start_slowly()
        answer = call("change_speed_override", 0)
        self.assertTrue(answer.success, answer.message)
        self.group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED and s.effective_speed == 0, "a robot that is held")
        self.assertFalse(move.ended())
        self.assertTrue(call("change_speed_override", 100).success)
        self.group.wait_for(lambda s: s.sequence == GroupState.EXECUTING, "a robot that goes on")
        move.cancel()
        move.finish()

    def test_tell_what_a_hundred_percent_are_of(self):
        answer = call("read_reference_dynamics")
        self.assertTrue(answer.success)
        self.assertAlmostEqual(answer.joint_speeds[0], 180, delta=1e-3)
        self.assertAlmostEqual(answer.tcp_speed, 1400, delta=1e-6)
        refused = call("write_reference_dynamics", answer.joint_speeds, answer.tcp_speed)
        self.assertEqual((refused.success, refused.error_id), (False, 0x8F11))

    def test_give_moves_what_they_have_not(self):
        self.assertEqual(call("read_default_dynamics").defaults, NONE)
        goal = to_joints(60, 0, 90, 0, 90, 0, speed=-1, accel_time=-1)
        self.assert_refuses([(goal, 0x26, "there is no default")])
        defaults = DefaultDynamics(25, -1, 500, -1, -1)
        self.assertTrue(call("write_default_dynamics", defaults).success)
        self.assertEqual(call("read_default_dynamics").defaults, defaults)
        self.assertAlmostEqual(self.planned(goal), 60 / 45 + 0.5, delta=1e-3)
        answer = call("write_default_dynamics", DefaultDynamics(101, -1, -1, -1, -1))
        self.assertEqual((answer.success, answer.error_id), (False, 0x8D07), answer.message)
        self.assertEqual(call("read_default_dynamics").defaults, defaults)

    def test_keep_joints_within_their_limits(self):
        self.addCleanup(lambda: call("write_software_limits", *self.model()))
        limits = call("read_software_limits")
        self.assertTrue(limits.success)
        self.assertEqual(limits.lower, limits.lowest)
        for found, expected in zip(limits.lower + limits.upper, LOWER + UPPER):
            self.assertAlmostEqual(found, expected, delta=1e-3)
        narrow = (-30,) + LOWER[1:], (30,) + UPPER[1:]
        answer = call("write_software_limits", *narrow)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(call("read_software_limits").upper[0], 30, delta=1e-9)
        self.assert_refuses([(to_joints(31, 0, 90, 0, 90, 0), 0x203, "J1")])
        for lower, upper, error_id in ((-271, 30, 0x8D15), (30, 30, 0x8D15), (math.nan, 30, 0x8D15), (10, 30, 0x8C54)):
            refused = call("write_software_limits", (lower,) + LOWER[1:], (upper,) + UPPER[1:])
            self.assertEqual((refused.success, refused.error_id), (False, error_id), refused.message)
        move = self.robot.start_slowly(to_joints(20, 0, 90, 0, 90, 0, speed=2))
        self.assertEqual(call("write_software_limits", *narrow).error_id, 0x8C53)
        move.cancel()
        move.finish()

    @staticmethod
    def model():
        limits = call("read_software_limits")
        return limits.lowest, limits.highest


if __name__ == "__main__":
    import rostest

    rospy.init_node("dynamics_test")
    rostest.rosrun("cobot_command", "dynamics", Dynamics)
