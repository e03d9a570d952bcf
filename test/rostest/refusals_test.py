#!/usr/bin/env python3
"""What every command is refused for, whatever it wants: the link, its turn, the robot."""
import rospy

from cobot_command.msg import CommandStatus, ProgramControlGoal, RobotStatus, StopGoal
from cobot_goals import (BUFFERED, HOME, commands, cycle, motions, path, path_to_joints, queued, script, sequence, step, to_joints, turn,
                         with_changes)
from cobot_test import CobotTestCase, Latest
from listen_node import ListenNode
from provoked_errors import own_number

MOST_THAT_WAIT = 64


class Refusals(CobotTestCase):
    def assert_all_rejected(self, goals, error_id, words=""):
        for goal in goals:
            with self.subTest(type(goal).__name__):
                self.assert_rejected(self.robot.run(goal), own_number(goal, error_id), words)

    def test_of_all_commands_without_a_connection(self):
        self.assert_all_rejected(commands(), 0x10)

    def test_of_all_commands_while_the_flow_is_elsewhere(self):
        self.robot.establish()
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.NOT_LISTENING, "a flow elsewhere")
        self.assert_all_rejected(queued(), 0x220)

    def test_never_of_a_stop_or_a_pause_while_the_flow_is_elsewhere_as_they_are_tried(self):
        self.robot.establish()
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.NOT_LISTENING, "a flow elsewhere")
        self.assert_aborted(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.PAUSE)), 0x220)
        self.assert_aborted(self.robot.run(StopGoal()), 0x225)

    def test_of_all_that_have_a_turn_while_another_is_busy(self):
        self.establish_at_home()
        busy = self.robot.start_slowly()
        self.assert_all_rejected(queued(), 0x11, "move_relative")
        busy.cancel()
        busy.finish()

    def test_of_all_that_have_a_turn_with_a_buffer_mode_that_is_none(self):
        self.robot.establish()
        for buffer_mode in (-1, 3):
            self.assert_all_rejected(queued(buffer_mode=buffer_mode), 0x215)

    def test_of_all_that_have_a_turn_when_too_many_wait(self):
        self.establish_at_home()
        busy = self.robot.start_slowly()
        # One by one: actionlib's own queues are shorter than this.
        waiting = [self.robot.send(turn(0, 0, 0, 0, 0, 1, buffer_mode=BUFFERED)).wait_until_queued()
                   for _ in range(MOST_THAT_WAIT)]
        self.assertEqual([sent.feedback[0].place_in_queue for sent in waiting], list(range(1, MOST_THAT_WAIT + 1)))
        self.assert_all_rejected(queued(buffer_mode=BUFFERED), 0x216, "64")
        busy.cancel()
        busy.finish()

    def test_of_all_that_have_a_turn_while_the_controller_is_in_error(self):
        self.robot.establish()
        self.robot.operate("raise_error", 0x14058, "joint 3")
        self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.assert_all_rejected(queued(), 0x222, "error 0x14058: no posture")
        self.robot.clear_error()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_of_all_until_a_stop_acknowledges_the_error_which_the_next_motion_then_clears(self):
        self.establish_at_home()
        # Too far for joint 3, behind a line that only the robot can read: the controller finds it out.
        far = script("float[] now = Robot[0].Joint", 'PTP("JPP",0,0,170,0,90,0,35,200,0,false)', await_motion=True)
        self.robot.run(far)
        self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x222)
        self.robot.status.wait_for(lambda s: "execute stop" in s.diagnosis, "the way out")
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_done(self.robot.run(to_joints(*HOME)))
        self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.FALSE, "the end of the error")

    def test_of_all_that_have_a_turn_while_the_robot_moves_on_from_before_the_link(self):
        self.establish_at_home()
        moving = self.robot.start_slowly(turn(120, 0, 0, 0, 0, 0, speed=2))  # outlasts all that is waited for
        connect = self.robot.send(self.robot.connect_goal(), "unmodelled/")
        status = Latest("unmodelled/command_status", CommandStatus)
        status.wait_for(lambda s: s.link_state == CommandStatus.READY and "no goal of this layer" in s.diagnosis,
                        "the orphan")
        for goal in queued():
            with self.subTest(type(goal).__name__):
                self.assert_rejected(self.robot.run(goal, "unmodelled/"), 0x227)
        self.assertFalse(moving.ended())
        moving.cancel()
        moving.finish()
        status.wait_for(lambda s: "no goal of this layer" not in s.diagnosis, "a robot that stands")
        connect.cancel()
        self.assert_done(connect.finish())

    def test_of_all_that_have_a_turn_during_an_emergency_stop(self):
        with ListenNode() as node:  # one that an emergency stop does not end
            self.robot.establish(port=node.port)
            self.robot.operate("set_emergency_stop", True)
            self.robot.robot_status.wait_for(lambda s: s.e_stopped == RobotStatus.TRUE, "the emergency stop")
            self.assert_all_rejected(queued(), 0x221)
            self.assertEqual(node.scripts, [], "nothing was sent")
            self.robot.close()

    def test_of_all_command_ids_but_0_and_2_to_9(self):
        self.establish_at_home()
        with_id = [goal for goal in commands() if hasattr(goal, "command_id")]
        self.assertEqual(len(with_id), 6)
        for command_id in (-1, 1, 10):
            self.assert_all_rejected([with_changes(goal, {"command_id": command_id}) for goal in with_id], 0x28)
        for command_id in (0, 2, 9):
            for goal in with_id:
                with self.subTest(type(goal).__name__, command_id=command_id):
                    result = self.assert_done(self.robot.run(with_changes(goal, {"command_id": command_id})))
                    self.assertEqual(result.command_id_ack, command_id or result.command_id_ack)
            self.robot.run(to_joints(*HOME))

    def test_of_checks_that_do_not_know_the_start(self):
        checks = [*motions(check_only=True)[:3], cycle(step(to_joints(*HOME)), check_only=True),
                  sequence(to_joints(*HOME), start_joints=[]), path(path_to_joints(*HOME), check_only=True)]
        self.assert_all_rejected(checks, 0x208)
        self.assert_all_rejected([sequence(to_joints(*HOME), start_joints=[0, 0, 90]),
                                  sequence(to_joints(*HOME), start_joints=[0, 0, float("nan"), 0, 0, 0])], 0x208)

    def test_of_checks_without_a_model_of_the_arm(self):
        goals = [*motions(check_only=True)[:3], cycle(step(to_joints(*HOME)), check_only=True),
                 sequence(to_joints(*HOME)), path(path_to_joints(*HOME), check_only=True)]
        connect = self.robot.send(self.robot.connect_goal(), "unmodelled/")
        Latest("unmodelled/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        for goal in goals:
            with self.subTest(type(goal).__name__):
                self.assert_rejected(self.robot.run(goal, "unmodelled/"), 0x209)
        connect.cancel()
        self.assert_done(connect.finish())


if __name__ == "__main__":
    import rostest

    rospy.init_node("refusals_test")
    rostest.rosrun("cobot_command", "refusals", Refusals)
