#!/usr/bin/env python3
"""The pick and place of the thesis by many robots at the same time."""
import math
import os
import unittest

import actionlib
import rospkg
import rospy
import yaml
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from std_srvs.srv import Trigger

from cobot_command.msg import CommandStatus, PickAndPlaceAction, PickAndPlaceGoal
from cobot_test import CONTROLLER, Latest, Sent

STEPS_FILE = "package://cobot_command/config/pick_and_place.yaml"
PATIENCE = 400.0  # [s]; for all of them together, on a machine that has other work too


class Member:
    """One robot of the fleet; listens to little, for there are many."""

    def __init__(self, name):
        self.name = name
        self.client = actionlib.ActionClient(f"{name}/pick_and_place", PickAndPlaceAction)
        self.status = Latest(f"{name}/command_status", CommandStatus)
        self.sent = None

    def is_ready(self):
        status = self.status.message
        return status is not None and status.link_state == CommandStatus.READY and status.status_stream

    def start(self, goal):
        self.sent = Sent(self.client, goal)

    def is_accepted(self):
        return self.sent.state() != GoalStatus.PENDING

    def words(self):
        """What there is to say of its goal."""
        result = self.sent.handle.get_result()
        return f"{self.name}: {result.error_description if result else 'no result'}; {self.status.message.diagnosis}"

    def operate(self, service):
        name = f"{self.name}/{CONTROLLER}/{service}"
        rospy.wait_for_service(name, PATIENCE)
        answer = rospy.ServiceProxy(name, Trigger)()
        if not answer.success:
            raise AssertionError(f"{name}: {answer.message}")

    def true_tool(self):
        """Where the simulator itself says that the tool is."""
        return rospy.wait_for_message(f"{self.name}/{CONTROLLER}/tool_pose", PoseStamped, PATIENCE).pose


class Fleet(unittest.TestCase):
    def test_all_do_a_cycle_at_the_same_time_and_each_ends_right(self):
        fleet = [Member(f"robot_{k}") for k in range(1, rospy.get_param("~count") + 1)]
        self.wait_for_all(fleet, Member.is_ready, "ready")
        for member in fleet:
            self.assertTrue(member.client.wait_for_server(rospy.Duration(PATIENCE)), member.name)
        # Held until each has its goal: however slow the machine is, they do their cycles at the same time.
        for member in fleet:
            member.operate("pause_project")
        for member in fleet:
            member.start(PickAndPlaceGoal(steps_file=STEPS_FILE, cycles=1))
        self.wait_for_all(fleet, Member.is_accepted, "accepted")
        for member in fleet:
            self.assertEqual(member.sent.state(), GoalStatus.ACTIVE, member.words())
        for member in fleet:
            member.operate("resume_project")
        self.wait_for_all(fleet, lambda member: member.sent.ended(), "at the end of its goal")
        for member in fleet:
            with self.subTest(robot=member.name):
                self.assert_cycle_is_done(member)
                self.assert_stands_at_the_last_target(member)
                self.assert_nothing_went_wrong_on_the_wire(member)

    def wait_for_all(self, fleet, condition, what):
        deadline = rospy.Time.now() + rospy.Duration(PATIENCE)
        rate = rospy.Rate(10)
        waiting = fleet
        while waiting:
            self.assertLess(rospy.Time.now(), deadline,
                            f"not {what} within {PATIENCE} s: {[(m.name, m.status.message) for m in waiting]}")
            rate.sleep()
            waiting = [member for member in waiting if not condition(member)]

    def assert_cycle_is_done(self, member):
        state, result = member.sent.finish()
        self.assertEqual(result.error_id, 0, result.error_description)
        self.assertEqual(state, GoalStatus.SUCCEEDED)
        self.assertEqual((result.cycles_done, result.failed_step, len(result.steps)), (1, -1, len(steps())))
        self.assertEqual([step.error_id for step in result.steps], [0] * len(steps()))

    def assert_stands_at_the_last_target(self, member):
        x, y, z, rx, ry, rz = steps()[-1]["target_position"]
        self.assertEqual((rx, ry, rz), (180, 0, 90))  # Rz(90) Rx(180), as a quaternion:
        wanted = (math.sqrt(0.5), math.sqrt(0.5), 0, 0)
        tool = member.true_tool()
        position, turn = tool.position, tool.orientation
        self.assertLess(math.dist((position.x, position.y, position.z), (x / 1e3, y / 1e3, z / 1e3)), 1e-5)
        cosine = sum(a * b for a, b in zip((turn.x, turn.y, turn.z, turn.w), wanted))
        self.assertGreater(abs(cosine), 1 - 1e-9)

    def assert_nothing_went_wrong_on_the_wire(self, member):
        status = member.status.message
        self.assertEqual((status.late_replies, status.decode_faults), (0, 0), status.diagnosis)
        self.assertEqual([(b.block, b.error_description) for b in status.blocks if b.error], [])
        self.assertEqual(status.last_lost.to_sec(), 0, "the link was never lost")


def steps():
    folder = rospkg.RosPack().get_path("cobot_command")
    with open(os.path.join(folder, "config", "pick_and_place.yaml"), encoding="utf-8") as file:
        return yaml.safe_load(file)["steps"]


if __name__ == "__main__":
    import rostest

    rospy.init_node("fleet_test")
    rostest.rosrun("cobot_command", "fleet", Fleet)
