#!/usr/bin/env python3
"""What is not made while nobody listens: whoever begins to listen misses nothing of it."""
import statistics
import unittest

import rospy
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from geometry_msgs.msg import PoseStamped

from cobot_command.msg import (CommandStatus, ProgramControlActionGoal, ProgramControlActionResult, ProgramControlGoal,
                               RobotStatus)
from cobot_command.srv import SetProjectSpeed
from cobot_test import CONTROLLER, DEADLINE, Latest, wait_until

OLD = 1.0  # [s]; far more than what is kept fresh may be old, for a machine that has other work too


def first(topic, kind):
    """What somebody gets who begins to listen now."""
    return rospy.wait_for_message(topic, kind, DEADLINE)


def published(topic, kind, seconds=2.0):
    """How many messages a second the node publishes: roscpp numbers them all, whether somebody gets them or not."""
    began, before = rospy.Time.now(), first(topic, kind).header.seq
    rospy.sleep(seconds)  # the window that is counted in
    return (first(topic, kind).header.seq - before) / (rospy.Time.now() - began).to_sec()


class WhoBeginsToListen(unittest.TestCase):
    def setUp(self):
        status = Latest("command_status", CommandStatus)
        status.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream, "the link")

    def test_gets_the_robot_as_it_is_now(self):
        rospy.wait_for_service(f"{CONTROLLER}/set_project_speed", DEADLINE)
        for percent in (35, 100):
            rospy.ServiceProxy(f"{CONTROLLER}/set_project_speed", SetProjectSpeed)(percent)
            wait_until(lambda: first("robot_status", RobotStatus).project_speed == percent, f"{percent} %")
            age = rospy.Time.now() - first("robot_status", RobotStatus).header.stamp
            self.assertLess(age.to_sec(), OLD)

    def test_gets_the_status_of_an_action_at_once_and_then_five_times_a_second(self):
        began = rospy.Time.now()
        statuses = Latest("move_absolute/status", GoalStatusArray)
        statuses.wait_for(lambda m: m.header.stamp >= began, "a status of now")
        wait_until(lambda: len(statuses.all()) >= 12, "the next ones")
        stamps = [m.header.stamp.to_sec() for m in statuses.all()][1:]
        self.assertAlmostEqual(statistics.median(b - a for a, b in zip(stamps, stamps[1:])), 0.2, delta=0.05)

    def test_gets_the_end_of_a_goal_to_whose_status_nobody_listened(self):
        goals = rospy.Publisher("program_control/goal", ProgramControlActionGoal, queue_size=1)
        results = Latest("program_control/result", ProgramControlActionResult)
        wait_until(goals.get_num_connections, "the action server")
        goals.publish(ProgramControlActionGoal(goal=ProgramControlGoal(command=-1)))
        results.wait_for_any(lambda m: m.status.status == GoalStatus.REJECTED, "the result")
        ended = [s.status for s in first("program_control/status", GoalStatusArray).status_list]
        self.assertEqual(ended, [GoalStatus.REJECTED])
        wait_until(lambda: not first("program_control/status", GoalStatusArray).status_list, "nothing of a goal long gone")

    def test_is_the_reason_that_much_is_published(self):
        for topic, kind in (("tool_pose", PoseStamped), ("robot_status", RobotStatus), ("move_relative/status", GoalStatusArray)):
            unheard = published(topic, kind)
            listener = rospy.Subscriber(topic, kind, lambda message: None)
            heard = published(topic, kind)
            listener.unregister()
            self.assertGreater(heard, 2 * unheard, topic)


if __name__ == "__main__":
    import rostest

    rospy.init_node("listeners_test")
    rostest.rosrun("cobot_command", "listeners", WhoBeginsToListen)
