#!/usr/bin/env python3
"""The exit_listen_node action against a simulated controller over real sockets."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ExitListenNodeGoal
from cobot_goals import ABORTING, BUFFERED, HOME, MODERATELY, SLOWLY, to_joints, turn
from motion_checks import MotionTestCase


class ExitListenNode(MotionTestCase):
    def test_lets_the_flow_go_on_and_come_back(self):
        self.assert_done(self.robot.run_and_reenter(ExitListenNodeGoal()))
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_waits_for_the_motion_in_front_of_it(self):
        moving = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        leaving = self.robot.send(ExitListenNodeGoal(buffer_mode=BUFFERED)).wait_until_queued()
        self.assert_done(moving.finish())
        self.assert_done(leaving.finish())
        self.assert_stands_at((20, 0, 90, 0, 90, 0))

    def test_takes_over_from_a_motion(self):
        moving = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, **SLOWLY))
        self.assert_done(self.robot.run(ExitListenNodeGoal(buffer_mode=ABORTING)))
        self.assert_ended(GoalStatus.PREEMPTED, moving.finish())
        self.robot.wait_for_standstill()

    def test_refuses_what_waits_behind_it(self):
        self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        leaving = self.robot.send(ExitListenNodeGoal(buffer_mode=BUFFERED)).wait_until_queued()
        behind = self.robot.send(to_joints(*HOME, buffer_mode=BUFFERED)).wait_until_queued()
        self.assert_done(leaving.finish())
        self.assert_rejected(behind.finish(), 0x220)


if __name__ == "__main__":
    import rostest

    rospy.init_node("exit_listen_node_test")
    rostest.rosrun("cobot_command", "exit_listen_node", ExitListenNode)
