#!/usr/bin/env python3
"""Back along the way of a path, and forth again, against a simulated controller over real sockets."""
import math

import rospy

from cobot_command.msg import CommandStatus, LoadPathGoal, RetraceGoal, StopGoal
from cobot_command.srv import ChangeSpeedOverride, Interruption, ReadSoftwareLimits, WriteSoftwareLimits
from cobot_goals import ABORTING, BUFFERED, HOME, path, path_to_joints, to_joints, turn, with_changes
from cobot_test import Latest
from motion_checks import MotionTestCase

BEGIN = (40, 0, 90, 0, 90, 0)


def back(**changes):
    return with_changes(RetraceGoal(point=RetraceGoal.START, speed=100), changes)


class Retraces(MotionTestCase):
    def setUp(self):
        super().setUp()
        self.path = self.drive()

    def drive(self, namespace="", **changes):
        """From BEGIN over a point at (20, 10, ...) to HOME."""
        self.assert_done(self.robot.run(to_joints(*BEGIN), namespace))
        points = (path_to_joints(20, 10, 90, 0, 90, 0, **changes), path_to_joints(*HOME, **changes))
        return self.assert_done(self.robot.run(path(*points), namespace))

    def connected(self, namespace, **changes):
        connect = self.robot.send(self.robot.connect_goal(**changes), namespace)
        self.addCleanup(lambda: (connect.cancel(), connect.finish()))
        Latest(f"{namespace}command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")

    # --- Where it leads.
    def test_lead_to_the_points_of_a_path_and_back_to_its_end(self):
        path_id = self.path.method_id
        for goal, joints in ((back(point=0), (20, 10, 90, 0, 90, 0)), (back(), BEGIN), (back(point=0, method_id=path_id), (20, 10, 90, 0, 90, 0)),
                             (back(point=1), HOME), (back(speed=0), BEGIN), (back(point=RetraceGoal.END), HOME)):
            result = self.assert_done(self.robot.run(goal))
            self.assert_stands_at(joints)
            self.assertGreater(result.planned_duration.to_sec(), 0)
            self.assertGreater(result.actual_duration.to_sec(), 0)
            for found, wanted in zip(result.final_joints, joints):
                self.assertAlmostEqual(found, wanted, delta=0.1)

    def test_tell_how_far_they_are(self):
        sent = self.robot.send(back(speed=5))
        self.assert_done(sent.finish())
        told = [f for f in sent.feedback if f.phase == f.ACTIVE]
        self.assertGreater(len(told), 3)
        self.assertEqual([f.progress for f in told], sorted(f.progress for f in told))
        self.assertEqual([f.remaining for f in told], sorted((f.remaining for f in told), reverse=True))

    def test_tell_how_many_commands_are_in_front_of_them(self):
        self.assert_done(self.robot.run(to_joints(*BEGIN)))
        moving = self.robot.start_slowly(path(path_to_joints(*HOME, speed=20)))
        waiting = self.robot.send(back(buffer_mode=BUFFERED)).wait_until_queued()
        self.assertEqual(waiting.feedback[0].place_in_queue, 1)
        self.assert_done(moving.finish())
        self.assert_done(waiting.finish())
        self.assertEqual(waiting.feedback[-1].place_in_queue, 0)
        self.assert_stands_at(BEGIN)

    def test_lead_out_of_where_a_path_was_stopped(self):
        self.assert_done(self.robot.run(to_joints(*BEGIN)))
        self.robot.start_slowly(path(path_to_joints(*HOME, speed=5)))
        self.assert_done(self.robot.run(StopGoal()))
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(back()))
        self.assert_stands_at(BEGIN)

    def test_let_a_path_that_is_interrupted_go_on(self):
        self.assert_done(self.robot.run(to_joints(*BEGIN)))
        sent = self.robot.start_slowly(path(path_to_joints(*HOME, speed=5)))
        ask = {name: rospy.ServiceProxy(name, Interruption) for name in ("interrupt", "continue")}
        answer = ask["interrupt"]()
        self.assertTrue(answer.success, answer.message)
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(back()))
        self.assert_stands_at(BEGIN)
        self.assertEqual(hex(ask["continue"]().error_id), "0x8c02")
        self.assert_done(self.robot.run(back(point=RetraceGoal.END)))
        answer = ask["continue"]()
        self.assertTrue(answer.success, answer.message)
        self.assert_done(sent.finish())

    def test_take_over_and_are_cancelled(self):
        self.assert_done(self.robot.run(to_joints(*BEGIN)))
        sent = self.robot.send(path(path_to_joints(*HOME, speed=20)))
        self.robot.joints.wait_for(lambda m: m.position[0] < math.radians(25), "the middle of the path")
        retrace = self.robot.send(back(speed=10, buffer_mode=ABORTING))
        self.assert_preempted(sent)
        self.robot.wait_for_motion()
        retrace.cancel()
        self.assert_preempted(retrace)
        self.assert_done(self.robot.run(back()))
        self.assert_stands_at(BEGIN)

    def assert_preempted(self, sent):
        self.assertIn(sent.finish()[1].error_id, (0, 1007))

    # --- What is wrong.
    def test_are_refused_by_what_they_ask_for(self):
        nan = float("nan")
        self.assert_refuses([(back(speed=-1), 0x26, "-1"), (back(speed=100.1), 0x26, "100.1"), (back(speed=nan), 0x26, "nan"), (back(speed=0.9), 0x26, "0.9"),
                             (back(point=2), 0x27C, "allowed: 0..1"), (back(point=-3), 0x27C, "-3"), (back(method_id=99), 0x27C, "99"),
                             (back(method_id=-1), 0x27C, "-1")])

    def test_need_a_robot_on_the_way(self):
        self.assert_done(self.robot.run(turn(0, 0, 1, 0, 0, 0)))
        self.assert_rejected(self.robot.run(back()), 0x27D)
        self.assert_done(self.robot.run(turn(0, 0, -1, 0, 0, 0)))
        self.assert_done(self.robot.run(back()))

    def test_take_no_longer_than_three_hours(self):
        self.drive(speed=30)
        override = rospy.ServiceProxy("change_speed_override", ChangeSpeedOverride)
        self.addCleanup(override, 100)
        self.assertTrue(override(1).success)
        self.assert_rejected(self.robot.run(back(speed=1)), 0x206, "at most 10800 s")

    def test_keep_to_the_software_limits_of_now(self):
        limits = rospy.ServiceProxy("read_software_limits", ReadSoftwareLimits)()
        write = rospy.ServiceProxy("write_software_limits", WriteSoftwareLimits)
        self.robot.wait_for_standstill()
        narrow = write(limits.lower, (30,) + tuple(limits.upper[1:]))
        self.addCleanup(write, limits.lower, limits.upper)
        self.assertTrue(narrow.success, narrow.message)
        self.assert_rejected(self.robot.run(back()), 0x203, "J1")

    def test_need_a_path_a_model_a_stream_a_pvt_and_time_to_plan(self):
        self.connected("unmodelled/")
        self.assert_rejected(self.robot.run(back(), "unmodelled/"), 0x209)
        self.connected("fresh/")
        self.assert_rejected(self.robot.run(back(), "fresh/"), 0x27B)
        self.robot.fault("refuse_script", count=1)
        self.assert_aborted(self.robot.run(path(path_to_joints(1, 0, 90, 0, 90, 0))), 0x80)
        self.assert_rejected(self.robot.run(back()), 0x272)
        self.robot.close()
        self.robot.send_connect(status_port=1)
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a link")
        self.assert_rejected(self.robot.run(back()), 0x208)

    def test_of_a_long_way_are_more_points_than_one_pvt_may_have(self):
        ports = rospy.get_param("long/simulated_controller/listening")
        self.connected("long/", port=ports["script_port"], status_port=ports["status_port"])
        self.assert_done(self.robot.run(to_joints(-260, 0, 90, 0, 90, 0), "long/"))
        slowest = path_to_joints(20, 0, 90, 0, 90, 0, speed=1.8)
        self.assert_done(self.robot.run(path(slowest, execution=LoadPathGoal.SCRIPT, allow_approximation=True), "long/"))
        self.assert_rejected(self.robot.run(back(), "long/"), 0x277, "5000")

    # --- What the robot, and the wire, do.
    def test_fail_as_other_commands_do(self):
        for faults, error_id in ((["ignore_script"], 0x70), (["refuse_script"], 0x80), (["false_tag"], 0x110), (["early_tag"], 0x226),
                                 (["drop_tag", "query_none"], 0x223), (["drop_tag", "drop_tag_answer"], 0x100)):
            with self.subTest(hex(error_id)):
                self.assert_fails(error_id, lambda: [self.robot.fault(fault, count=1) for fault in faults])
        self.assert_fails(0x224, lambda: self.robot.fault("cperr_script", count=1, text="02"))

    def assert_fails(self, error_id, do_harm):
        do_harm()
        outcome = self.robot.run(back(speed=10))
        self.robot.operate("clear_faults")
        self.robot.wait_for_standstill()
        self.assert_aborted(outcome, error_id)
        self.assert_done(self.robot.run(back(point=RetraceGoal.END)))

    def test_fail_with_the_link_and_with_a_stop_that_is_refused(self):
        retrace = self.robot.start_slowly(back(speed=2))
        self.robot.fault("refuse_stop", count=1)
        retrace.cancel()
        self.assert_aborted(retrace.finish(), 0x225, "refused")
        self.assert_done(self.robot.run(StopGoal()))
        retrace = self.robot.start_slowly(back(speed=2))
        self.robot.operate("drop_connections")
        self.assert_aborted(retrace.finish(), 0x99)


if __name__ == "__main__":
    import rostest

    rospy.init_node("retrace_test")
    rostest.rosrun("cobot_command", "retrace", Retraces)
