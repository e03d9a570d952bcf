#!/usr/bin/env python3
"""The program_control action against a simulated controller over real sockets."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ProgramControlGoal, RobotStatus
from cobot_command.srv import ChangeSpeedOverride
from cobot_goals import BUFFERED, MODERATELY, turn
from motion_checks import MotionTestCase

PAUSE, RESUME = (ProgramControlGoal(command=c) for c in (ProgramControlGoal.PAUSE, ProgramControlGoal.RESUME))


class ProgramControl(MotionTestCase):
    def test_pauses_a_motion_and_lets_it_go_on(self):
        sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        self.assert_done(self.robot.run(PAUSE))
        self.robot.robot_status.wait_for(lambda s: s.project_paused == RobotStatus.TRUE, "the pause")
        self.robot.wait_for_standstill()
        self.assertEqual(sent.state(), GoalStatus.ACTIVE)
        sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.assert_done(self.robot.run(RESUME))
        self.assert_done(sent.finish())
        self.assert_stands_at((20, 0, 90, 0, 90, 0))

    def test_does_not_resume_a_robot_that_the_speed_override_holds(self):
        sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        override = rospy.ServiceProxy("change_speed_override", ChangeSpeedOverride)
        self.assertTrue(override(0).success)
        self.robot.wait_for_standstill()
        self.assert_rejected(self.robot.run(RESUME), 0x234, "override")
        self.assertTrue(override(100).success)
        self.assert_done(sent.finish())

    def test_gives_a_paused_motion_the_time_that_the_pause_took(self):
        sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        self.assert_done(self.robot.run(PAUSE))
        sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.robot.wait_for_time_to_pass(3.0)  # longer than the deadline of its tag would be, were it not paused
        self.assertEqual(sent.state(), GoalStatus.ACTIVE)
        self.assert_done(self.robot.run(RESUME))
        self.assert_done(sent.finish())

    def test_pauses_a_motion_that_is_to_leave_the_listen_node(self):
        sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, exit_node=True, **MODERATELY))
        self.assert_done(self.robot.run(PAUSE))
        sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.assert_done(self.robot.run(RESUME))
        self.assert_done(sent.finish())
        self.assert_stands_at((20, 0, 90, 0, 90, 0))

    def test_queues_what_comes_during_a_pause(self):
        self.assert_done(self.robot.run(PAUSE))
        first = self.robot.send(turn(5, 0, 0, 0, 0, 0)).wait_until_active()
        second = self.robot.send(turn(5, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)).wait_until_queued()
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(RESUME))
        self.assert_done(first.finish())
        self.assert_done(second.finish())
        self.assert_stands_at((10, 0, 90, 0, 90, 0))

    def test_takes_a_second_pause_and_a_second_resume(self):
        for goal in (PAUSE, PAUSE, RESUME, RESUME):
            self.assert_done(self.robot.run(goal))

    def test_refuses_commands_that_are_none(self):
        self.assert_refuses((ProgramControlGoal(command=v), 0x21C, "") for v in (-1, 2))


if __name__ == "__main__":
    import rostest

    rospy.init_node("program_control_test")
    rostest.rosrun("cobot_command", "program_control", ProgramControl)
