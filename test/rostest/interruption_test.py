#!/usr/bin/env python3
"""Motions are interrupted, the robot is moved and brought back, and they go on."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus, GroupState, ReturnToPrimaryGoal, RobotStatus, StopGoal
from cobot_command.srv import InverseKinematics, InverseKinematicsRequest
from cobot_goals import BUFFERED, HOME, base, path, path_to_joints, relative, sequence, step_of_joint, tcp, to_joints, turn
from cobot_test import CobotTestCase, Latest
from interrupting import ask, interrupt, line_back, way_back
from listen_node import ListenNode

AWAY = (20, 10, 80, 0, 90, 0)


class Interruptions(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.establish_at_home()
        self.group = self.robot.latest("group_state", GroupState)

    def assert_denied(self, service, error_id, words=""):
        answer = ask(service)
        self.assertEqual((answer.success, hex(answer.error_id)), (False, hex(error_id)), answer.message)
        self.assertIn(words, answer.message)

    def go_on(self):
        answer = ask("continue")
        self.assertTrue(answer.success, answer.message)

    # --- The whole of it.
    def test_let_the_robot_be_moved_and_brought_back(self):
        for move_back in (way_back(speed=5), line_back(speed=5, distance_limit=400)):
            waits = turn(0, 5, 0, 0, 0, 0, buffer_mode=BUFFERED)
            first = self.robot.send(turn(20, 0, 0, 0, 0, 0, speed=10)).wait_until_active()
            second = self.robot.send(waits).wait_until_queued()
            self.robot.wait_for_motion()
            self.assertTrue(ask("interrupt").success)
            self.group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED and s.in_primary_position, "the interruption")
            first.wait_for_feedback(lambda f: "continue" in f.text, "the way out")
            self.robot.wait_for_standstill()
            self.assert_done(self.robot.run(turn(5, -5, 5, 0, 0, 0)))
            self.group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED and not s.in_primary_position, "a robot elsewhere")
            self.assert_denied("continue", 0x8C02, "return_to_primary")
            back = self.robot.send(move_back)
            self.assert_done(back.finish())
            told = [f.remaining_distance for f in back.feedback if f.phase == f.ACTIVE]
            self.assertGreater(told[0], told[-1])
            self.robot.wait_for_standstill()
            self.assertEqual([first.ended(), second.ended()], [False, False])
            self.go_on()
            self.assert_done(first.finish())
            self.assert_done(second.finish())
            self.robot.wait_for_standstill()
            self.assertAlmostEqual(math.degrees(self.robot.true_joints.message.position[0]), 20, places=3)
            self.assertAlmostEqual(math.degrees(self.robot.true_joints.message.position[1]), 5, places=3)
            self.group.wait_for(lambda s: s.sequence == GroupState.IDLE, "an idle robot")
            self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_keep_a_path(self):
        sent = interrupt(self.robot, path(path_to_joints(40, 0, 90, 0, 90, 0, speed=10)))
        self.assert_done(self.robot.run(step_of_joint(5)))
        self.assert_done(self.robot.run(way_back()))
        self.robot.wait_for_standstill()
        self.go_on()
        self.assert_done(sent.finish())

    def test_end_with_what_ends_everything(self):
        sent = interrupt(self.robot)
        waits = self.robot.send(turn(0, 5, 0, 0, 0, 0, buffer_mode=BUFFERED))
        waits.wait_for_feedback(lambda f: "interrupted" in f.text, "the reason")
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.assert_ended(GoalStatus.RECALLED, waits.finish())
        self.assert_denied("continue", 0x233, "nothing")
        sent = interrupt(self.robot)
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        sent = interrupt(self.robot)
        self.robot.operate("drop_connections")
        self.assert_aborted(sent.finish(), 0x99)

    def test_need_something_that_can_go_on(self):
        self.assert_denied("interrupt", 0x233, "no goal is running or queued")
        self.assert_denied("continue", 0x233, "nothing")
        self.assert_rejected(self.robot.run(way_back()), 0x233, "nothing")
        jogged = self.robot.start_slowly(step_of_joint(60, speed=5))
        self.assert_denied("interrupt", 0x233, "jog cannot")
        jogged.cancel()
        jogged.finish()

    # --- The way back.
    def test_know_ways_back_that_are_wrong(self):
        nan = float("nan")
        interrupt(self.robot)
        self.assert_done(self.robot.run(to_joints(*AWAY)))
        self.assert_refuses([(way_back(return_mode=2), 0x8D30, "2"), (way_back(trajectory_mode=0), 0x8D36, "0"),
                             (way_back(speed=-1), 0x26, "-1"), (way_back(speed=101), 0x26, "101"), (way_back(speed=nan), 0x200, "nan"),
                             (way_back(distance_limit=-1), 0x213, "-1"), (way_back(distance_limit=5), 0x8C07, "mm away")])
        busy = self.robot.start_slowly()
        self.assert_rejected(self.robot.run(way_back()), 0x11, "move_relative")
        busy.cancel()
        busy.finish()

    def test_know_other_frames_and_loads(self):
        self.assert_done(self.robot.run(tcp(0, 0, 0)))
        self.robot.wait_for_time_to_pass(0.3)
        interrupt(self.robot)
        for goal, undo, error_id in ((tcp(0, 0, 50), tcp(0, 0, 0), 0x8C22), (base(0, 0, 50), base(0, 0, 0), 0x8C24),
                                     (tcp(0, 0, 0, weight=1), tcp(0, 0, 0), 0x8C23)):
            self.assert_done(self.robot.run(goal))
            self.robot.wait_for_time_to_pass(0.3)
            with self.subTest(hex(error_id)):
                self.assert_rejected(self.robot.run(way_back()), error_id)
                self.assert_done(self.robot.run(way_back(allow_differences=True)))
            self.assert_done(self.robot.run(undo))
            self.robot.wait_for_time_to_pass(0.3)

    def end_at(self, *degrees):
        """A motion to there is interrupted as soon as it moves: there is its end."""
        interrupt(self.robot, to_joints(*degrees, speed=2))

    def pose_at(self, *degrees):
        pose = self.assert_done(self.robot.run(to_joints(*degrees))).final_pose
        return pose.x, pose.y, pose.z, pose.rx, pose.ry, pose.rz

    def joints_at(self, pose):
        request = InverseKinematicsRequest(configuration=InverseKinematicsRequest.FREE, joints=list(HOME))
        for name, value in zip(("x", "y", "z", "rx", "ry", "rz"), pose):
            setattr(request.pose, name, value)
        answer = rospy.ServiceProxy("inverse_kinematics", InverseKinematics)(request)
        self.assertTrue(answer.success, answer.message)
        return answer.posture.joints

    def assert_line_refused(self, error_id, to, begin, **changes):
        """In a line from `begin` to the end of a motion to `to`, both in joints."""
        with self.subTest(hex(error_id)):
            self.assert_done(self.robot.run(to_joints(*HOME)))
            self.end_at(*to)
            self.assert_done(self.robot.run(to_joints(*begin)))
            goal = line_back(return_mode=ReturnToPrimaryGoal.END_POSITION, **changes)
            self.assert_rejected(self.robot.run(goal), error_id)
            self.assert_done(self.robot.run(StopGoal()))

    def test_know_ways_back_that_cannot_be_made(self):
        self.assert_line_refused(0x201, (170, 0, 90, 0, 90, 0), HOME)
        self.assert_line_refused(0x203, (-80, 0, 90, 0, 90, 0), (262, 0, 90, 0, 90, 0))
        self.assert_line_refused(0x20A, (0, 0, 90, 0, 90, 180), HOME)
        x, y, z, *rest = self.pose_at(0, -40, 130, 0, 90, 0)
        self.assert_line_refused(0x204, self.joints_at((x, y + 300, z, *rest)), (0, -40, 130, 0, 90, 0), speed=100)
        x, y, z, *rest = self.pose_at(0, 0, 0, 0, 0, 0)
        self.assert_line_refused(0x205, self.joints_at((x + 100, y, z - 100, *rest)), (0, 0, 0, 0, 0, 0), speed=1)
        self.assert_line_refused(0x202, self.joints_at(self.first_beyond((10, 15, 80, -5, 85, 20))), (10, 15, 80, -5, 85, 20))

    def first_beyond(self, begin):
        """The first pose along x that can be reached, but not with the bits of `begin`."""
        self.pose_at(*begin)
        goal = sequence(relative(3000, 0, 0, speed=250), start_joints=[])
        _, result = self.robot.run(goal)
        self.assertEqual(result.steps[0].error_id, 0x202, result.error_description)
        point = result.steps[0].offending_point
        return point.x + 1, point.y, point.z, point.rx, point.ry, point.rz

    def test_know_ways_back_that_take_too_long_to_plan(self):
        # The way is so long, and so slow, that its plan takes three times the least budget that a node can be given.
        connect = self.robot.send(self.robot.connect_goal(), "hurried/")
        Latest("hurried/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        interrupt(self.robot, namespace="hurried/")
        self.assert_done(self.robot.run(turn(90, 0, 0, 0, 0, 0), "hurried/"))
        self.robot.operate("set_project_speed", 5)
        Latest("hurried/robot_status", RobotStatus).wait_for(lambda s: s.project_speed == 5, "the low project speed")
        self.assert_rejected(self.robot.run(line_back(speed=1), "hurried/"), 0x20C)
        connect.cancel()
        connect.finish()

    def test_know_nothing_of_a_base_that_nobody_tells(self):
        connect = self.robot.send(self.robot.connect_goal(port=self.baseless("script_port"), status_port=self.baseless("status_port")),
                                  "baseless/")
        Latest("baseless/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        sent = self.robot.send(turn(60, 0, 0, 0, 0, 0, speed=2), "baseless/").wait_until_active()
        sent.wait_for_feedback(lambda f: f.progress > 0.02, "a motion")
        answer = ask("interrupt", "baseless/")
        self.assertTrue(answer.success, answer.message)
        self.assert_done(self.robot.run(base(base_name="table"), "baseless/"))
        self.assert_rejected(self.robot.run(line_back(allow_differences=True), "baseless/"), 0x231)
        connect.cancel()
        connect.finish()

    @staticmethod
    def baseless(port):
        return rospy.get_param("baseless/simulated_controller/listening")[port]

    # --- What the robot, and the wire, do.
    def test_fail_as_other_commands_do(self):
        for faults, error_id in ((["ignore_script"], 0x70), (["refuse_script"], 0x80), (["false_tag"], 0x110), (["early_tag"], 0x226),
                                 (["drop_tag", "query_none"], 0x223), (["drop_tag", "drop_tag_answer"], 0x100)):
            with self.subTest(hex(error_id)):
                self.assert_fails(error_id, 2 if "early_tag" in faults else 10, lambda: [self.robot.fault(fault, count=1) for fault in faults])
        self.assert_fails(0x224, 10, lambda: self.robot.fault("cperr_script", count=1, text="02"))

    def assert_fails(self, error_id, speed, do_harm):
        self.begin_elsewhere()
        do_harm()
        outcome = self.robot.run(way_back(speed=speed))
        self.end_of_it()
        self.assert_aborted(outcome, error_id)

    def begin_elsewhere(self):
        interrupt(self.robot)
        self.assert_done(self.robot.run(to_joints(*AWAY)))

    def end_of_it(self):
        self.robot.operate("clear_faults")
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_fail_with_the_link_and_with_a_stop_that_is_refused(self):
        self.begin_elsewhere()
        back = self.robot.start_slowly(way_back(speed=2))
        self.robot.fault("refuse_stop", count=1)
        back.cancel()
        self.assert_aborted(back.finish(), 0x225, "refused")
        self.end_of_it()
        self.begin_elsewhere()
        back = self.robot.start_slowly(way_back(speed=2))
        self.robot.operate("drop_connections")
        self.assert_aborted(back.finish(), 0x99)

    def test_are_refused_by_a_robot_that_takes_no_commands(self):
        self.robot.operate("raise_error", 0x14058, "joint 3")
        self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.assert_rejected(self.robot.run(way_back()), 0x222)
        self.robot.clear_error()
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.NOT_LISTENING, "a flow elsewhere")
        self.assert_rejected(self.robot.run(way_back()), 0x220)
        self.robot.close()
        self.assert_rejected(self.robot.run(way_back()), 0x10)
        self.assert_denied("interrupt", 0x10)
        with ListenNode() as node:  # one that an emergency stop does not end
            self.robot.establish(port=node.port)
            self.robot.operate("set_emergency_stop", True)
            self.robot.robot_status.wait_for(lambda s: s.e_stopped == RobotStatus.TRUE, "the emergency stop")
            self.assert_rejected(self.robot.run(way_back()), 0x221)
            self.robot.close()

    def test_are_refused_while_the_robot_moves_on_from_before_the_link(self):
        moving = self.robot.start_slowly(turn(120, 0, 0, 0, 0, 0, speed=2))
        connect = self.robot.send(self.robot.connect_goal(), "hurried/")
        Latest("hurried/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and "no goal of this layer" in s.diagnosis, "the orphan")
        self.assert_rejected(self.robot.run(way_back(), "hurried/"), 0x227)
        moving.cancel()
        moving.finish()
        connect.cancel()
        connect.finish()


if __name__ == "__main__":
    import rostest

    rospy.init_node("interruption_test")
    rostest.rosrun("cobot_command", "interruption", Interruptions)
