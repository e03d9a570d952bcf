#!/usr/bin/env python3
"""Joints into poses and back by services, without a robot."""
import unittest

import rospy

from cobot_command.msg import RobotData, RobotPose, ToolData, Transformation
from cobot_command.srv import CalculateFrame, CalculateTool, ForwardKinematics, InverseKinematics, InverseKinematicsRequest, WriteTool
from cobot_test import DEADLINE, Latest
from own_nodes import node

JOINTS = [30, -20, 100, 10, 80, -45]
POSE = Transformation(330.992, 27.191, 397.019, -172.893, 7.053, 165.439)


def numbers(transformation):
    return [getattr(transformation, name) for name in ("x", "y", "z", "rx", "ry", "rz")]


class KinematicsTestCase(unittest.TestCase):
    """A command node without a controller."""

    def start(self, **parameters):
        for name in ("/tried", "/robot_description"):
            if rospy.has_param(name):
                rospy.delete_param(name)
        rospy.set_param("/tried", parameters)
        process = node("command_node", "tried")
        self.addCleanup(process.clear_away)
        rospy.wait_for_service("inverse_kinematics", DEADLINE)

    def forward(self, joints, tool=0, frame=0):
        return rospy.ServiceProxy("forward_kinematics", ForwardKinematics)(joints=joints, tool=tool, frame=frame)

    def inverse(self, pose, **fields):
        return rospy.ServiceProxy("inverse_kinematics", InverseKinematics)(InverseKinematicsRequest(pose=pose, **fields))

    def assert_refused(self, answer, error_id, *words):
        self.assertFalse(answer.success)
        self.assertEqual(answer.error_id, error_id, answer.message)
        for word in words:
            self.assertIn(word, answer.message)

    def assert_near(self, found, expected, delta):
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=delta)


class Kinematics(KinematicsTestCase):
    def setUp(self):
        self.start(robot_model="tm5-700")

    def test_go_forward_and_back_as_the_oracle_has_it(self):
        there = self.forward(JOINTS)
        self.assertTrue(there.success, there.message)
        self.assert_near(numbers(there.pose), numbers(POSE), 1e-3)
        self.assertEqual(there.posture.bits, RobotPose(0, 2, 4))
        self.assertEqual(list(there.posture.turns), [0] * 6)
        back = self.inverse(there.pose, bits=there.posture.bits, joints=JOINTS)
        self.assertTrue(back.success, back.message)
        self.assert_near(back.posture.joints, JOINTS, 1e-6)
        self.assertEqual(len(back.branches), 8)
        self.assertTrue(all(branch.within_limits for branch in back.branches))
        lefty = self.inverse(there.pose, bits=RobotPose(1, 3, 5), joints=JOINTS)
        self.assert_near(lefty.posture.joints, [165.6743, -76.5225, 60.5901, 112.9562, 97.1360, 90.2357], 1e-4)
        for configuration in (InverseKinematicsRequest.SAME, InverseKinematicsRequest.FREE):
            chosen = self.inverse(there.pose, configuration=configuration, joints=lefty.posture.joints)
            self.assertEqual(chosen.posture.bits, RobotPose(1, 3, 5))

    def test_refuse_what_cannot_be_reached(self):
        self.assert_refused(self.inverse(Transformation(2000, 0, 400, 180, 0, 90), bits=RobotPose(0, 2, 4)), 0x8C62, "2000")
        self.assert_refused(self.forward([0, 0, 160, 0, 90, 0]), 0x8C63, "joint 3", "155")
        self.assert_refused(self.forward([float("nan"), 0, 90, 0, 90, 0]), 0x200, "joint 1")
        self.assert_refused(self.inverse(Transformation(1e6, 0, 0, 0, 0, 0), bits=RobotPose(0, 2, 4)), 0x213)
        self.assert_refused(self.inverse(POSE), 0x8D05, "config2 is 0")
        self.assert_refused(self.inverse(POSE, configuration=3), 0x8D21, "configuration is 3")

    def test_use_the_tools_of_the_tables_as_they_are_now(self):
        self.assert_refused(self.forward(JOINTS, tool=3), 0x8D35, "tool 3 is not configured", "write_tool")
        self.assert_refused(self.forward(JOINTS, frame=16), 0x8D08, "0 to 15")
        write = rospy.ServiceProxy("write_tool", WriteTool)
        self.assertTrue(write(ToolData(index=3, name="gripper", name_only=True)).success)
        self.assert_refused(self.forward(JOINTS, tool=3), 0x8D35, "gripper", "controller's project")
        self.assertTrue(write(ToolData(index=3, name="gripper", tcp=Transformation(0, 0, 150, 0, 0, 0))).success)
        flange, tip = self.forward(JOINTS).pose, self.forward(JOINTS, tool=3).pose
        self.assertAlmostEqual(sum((a - b) ** 2 for a, b in zip(numbers(tip)[:3], numbers(flange)[:3])), 150 ** 2, delta=1e-3)
        back = self.inverse(tip, tool=3, configuration=InverseKinematicsRequest.SAME, joints=JOINTS)
        self.assert_near(back.posture.joints, JOINTS, 1e-6)

    def test_make_a_frame_and_a_tool_of_what_was_touched(self):
        frame = rospy.ServiceProxy("calculate_frame", CalculateFrame)
        corner, side, other = (Transformation(*place, 0, 0, 0) for place in ((100, 200, 50), (100, 500, 50), (-200, 200, 50)))
        answer = frame(origin=corner, on_x_axis=side, in_xy_plane=other)
        self.assertTrue(answer.success, answer.message)
        self.assert_near(numbers(answer.pose), [100, 200, 50, 0, 0, 90], 1e-6)
        self.assert_refused(frame(origin=corner, on_x_axis=side, in_xy_plane=side), 0x8C59, "10 mm")
        tool = rospy.ServiceProxy("calculate_tool", CalculateTool)
        # About a point 100 mm in front of the flange.
        touches = [Transformation(0, 0, 100, 180, 0, 0), Transformation(0, 0, 100, 180, 0, 90), Transformation(-100, 0, 0, 0, 90, 0),
                   Transformation(0, 100, 0, 90, 0, 0)]
        answer = tool(flanges=touches)
        self.assertTrue(answer.success, answer.message)
        self.assert_near(numbers(answer.tcp), [0, 0, 100, 0, 0, 0], 1e-6)
        self.assert_near(numbers(answer.point)[:3], [0, 0, 0], 1e-6)
        self.assert_refused(tool(flanges=touches[:3]), 0x8C66, "4 to 100")


class WithoutAModel(KinematicsTestCase):
    def test_they_are_refused_by_name(self):
        self.start()
        for answer in (self.forward(JOINTS), self.inverse(POSE)):
            self.assert_refused(answer, RobotData.NOT_OFFERED, "~robot_model")
        told = Latest("robot_data", RobotData).wait_for(lambda m: m.unsupported, "what is not offered")
        self.assertIn("CalculateForwardKinematic", [function.name for function in told.unsupported])
        self.assertEqual(told.axes, [])


if __name__ == "__main__":
    import rostest

    rospy.init_node("kinematics_test")
    rostest.rosrun("cobot_command", "kinematics", "kinematics_test")  # all classes of this file
