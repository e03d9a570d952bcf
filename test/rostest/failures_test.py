#!/usr/bin/env python3
"""How commands fail that are good by themselves: the controller refuses them, or the wire fails."""
import itertools

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ChangeLoadGoal, ExitListenNodeGoal, ProgramControlGoal, StopGoal
from cobot_goals import (ELSEWHERE, HOME, base, cycle, motions, move_script, output, path, path_to_joints, pause, relative, script, step, tcp,
                         to_joints, turn, wait_for)
from cobot_test import CobotTestCase
from provoked_errors import own_number

SLOWLY = {"speed": 5}


def all_motions(**changes):
    return [*motions(**changes), path(path_to_joints(*ELSEWHERE, **changes))]


def scripts():
    """One goal of each block that is one script; the motions are short."""
    return [to_joints(*HOME), relative(0, 0, 1, 0, 0, 0), motions()[2], base(20, 30, 10, 0, 0, 90), tcp(0, 0, 150),
            ChangeLoadGoal(weight=1), output(), ExitListenNodeGoal(), script("ChangeLoad(1)"), ProgramControlGoal(command=ProgramControlGoal.RESUME),
            path(path_to_joints(1, 0, 90, 0, 90, 0), path_to_joints(*HOME))]


class Failures(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.establish_at_home()

    # --- The answer to the script.
    def test_of_scripts_that_are_not_answered(self):
        for goal in scripts():
            with self.subTest(type(goal).__name__):
                self.robot.fault("ignore_script", count=1)
                self.assert_aborted(self.robot.run(goal), 0x70, "no reply")

    def test_of_scripts_that_are_refused(self):
        for goal in scripts():
            with self.subTest(type(goal).__name__):
                self.robot.fault("refuse_script", count=1)
                self.assert_aborted(self.robot.run(goal), 0x80, "line 1")

    def test_of_scripts_with_a_communication_error(self):
        for code, goal in zip(itertools.cycle(("01", "02", "03", "04")), scripts()):
            with self.subTest(type(goal).__name__):
                self.robot.fault("cperr_script", count=1, text=code)
                self.assert_aborted(self.robot.run(goal), 0x224)

    def test_of_scripts_that_come_as_the_flow_leaves_the_listen_node(self):
        for goal in scripts():
            with self.subTest(type(goal).__name__):
                self.robot.fault("cperr_script", count=1, text="F1")
                self.assert_aborted(self.robot.run(goal), own_number(goal, 0x220))
                self.robot.close()  # whether it is in the Listen node is known anew with a new link
                self.robot.establish()

    def test_of_all_that_is_busy_when_the_link_is_lost(self):
        for goal in [*scripts(), wait_for(), pause(60), StopGoal(), cycle(step(to_joints(*HOME)))]:
            with self.subTest(type(goal).__name__):
                self.robot.fault("silence")
                sent = self.robot.send(goal).wait_until_active()
                self.robot.operate("drop_connections")
                self.assert_aborted(sent.finish(), own_number(goal, 0x99))
                self.robot.reset()
                self.robot.establish()

    # --- The motion.
    def test_of_motions_that_the_controller_reports_as_not_completed(self):
        for goal in all_motions():
            with self.subTest(type(goal).__name__):
                self.robot.fault("false_tag", count=1)
                self.assert_aborted(self.robot.run(goal), 0x110, "false")
                self.return_home()

    def test_of_overdue_motions_that_the_controller_does_not_know(self):
        for goal in all_motions():
            with self.subTest(type(goal).__name__):
                self.robot.fault("drop_tag", count=1)
                self.robot.fault("query_none", count=1)
                self.assert_aborted(self.robot.run(goal), 0x223, "does not know")
                self.return_home()

    def test_of_overdue_motions_that_the_controller_says_are_not_completed(self):
        self.robot.fault("drop_tag", count=1)
        self.robot.fault("query_false")  # also when it is asked again, as the first answer may come before a frame does
        self.assert_aborted(self.robot.run(motions()[0]), 0x110, "standstill")

    def test_of_overdue_motions_whose_tag_cannot_be_asked_for(self):
        for goal in all_motions():
            with self.subTest(type(goal).__name__):
                self.robot.fault("drop_tag", count=1)
                self.robot.fault("drop_tag_answer", count=1)
                self.assert_aborted(self.robot.run(goal), 0x100)
                self.return_home()

    def test_of_cancelled_motions_whose_stop_is_refused(self):
        for goal in all_motions(**SLOWLY):
            with self.subTest(type(goal).__name__):
                sent = self.robot.start_slowly(goal)
                self.robot.fault("refuse_stop", count=1)
                sent.cancel()
                self.assert_aborted(sent.finish(), 0x225, "refused")
                self.assert_done(self.robot.run(StopGoal()))
                self.return_home()

    def test_of_the_stop_block_when_it_is_refused_or_does_nothing(self):
        for fault, words in (("refuse_stop", "refused"), ("ignore_stop", "still moves")):
            with self.subTest(fault):
                self.robot.start_slowly(turn(120, 0, 0, 0, 0, 0, speed=2))  # outlasts all that is waited for
                self.robot.fault(fault, count=2)
                self.assert_aborted(self.robot.run(StopGoal()), 0x225, words)
                self.robot.operate("clear_faults")
                self.assert_done(self.robot.run(StopGoal()))

    def test_of_a_motion_when_the_controller_comes_into_error(self):
        sent = self.robot.start_slowly(move_script(5))
        self.robot.fault("drop_tag")  # the error itself, not the tag that it fails, is to be seen
        self.robot.operate("raise_error", 0x14058, "joint 3")
        self.assert_aborted(sent.finish(), 0x222, "0x14058: no posture")

    def test_of_motions_tells_the_error_though_their_tag_comes_before_it(self):
        for goal in all_motions(**SLOWLY):
            with self.subTest(type(goal).__name__):
                sent = self.robot.start_slowly(goal)
                self.robot.operate("raise_error", 0x14058, "joint 3")
                self.assert_aborted(sent.finish(), own_number(goal, 0x222), "0x14058: no posture")
                self.assert_done(self.robot.run(StopGoal()))  # acknowledges it
                self.assert_aborted(self.robot.run(to_joints(*HOME)), 0x222, "0x14058: no posture")  # it stands
                self.assert_done(self.robot.run(StopGoal()))
                self.robot.clear_error()
                self.return_home()

    def test_of_motions_whose_tag_comes_before_the_robot_is_there(self):
        for goal in all_motions(**SLOWLY):
            with self.subTest(type(goal).__name__):
                self.robot.fault("early_tag", count=1)
                self.assert_aborted(self.robot.run(goal), 0x226, "from its target")
                self.robot.wait_for_standstill()
                self.return_home()

    def test_of_all_that_is_busy_when_the_emergency_stop_is_pressed(self):
        sent = self.robot.start_slowly()
        self.robot.operate("set_emergency_stop", True)
        self.assert_aborted(sent.finish(), 0x99, "emergency stop")
        self.assert_aborted(self.robot.connect.finish(), 0x90, "emergency stop")

    def test_of_a_motion_that_an_unanswered_pause_has_stopped(self):
        sent = self.robot.start_slowly()
        self.robot.fault("ignore_script", count=1)
        self.assert_aborted(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.PAUSE)), 0x70, "no reply")
        state, result = sent.finish()
        self.assertEqual(state, GoalStatus.PREEMPTED, result.error_description)
        self.assertIn("program_control got no reply", result.error_description)
        self.robot.wait_for_standstill()

    # --- None of it is a failure.
    def test_never_of_messages_that_are_late_doubled_or_lost_without_need(self):
        for fault in ("duplicate_reply", "duplicate_tag", "corrupt_stream", "drop_stream"):
            with self.subTest(fault):
                self.robot.fault(fault, count=1)
                self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))
        self.robot.fault("delay_reply", count=1, seconds=1.0)
        self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))
        self.robot.fault("drop_tag", count=1)  # asked for, the controller says that the motion is done
        self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))

    def return_home(self):
        self.robot.operate("clear_faults")
        self.assert_done(self.robot.run(to_joints(*HOME)))


if __name__ == "__main__":
    import rostest

    rospy.init_node("failures_test")
    rostest.rosrun("cobot_command", "failures", Failures)
