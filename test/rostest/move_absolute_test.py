#!/usr/bin/env python3
"""The move_absolute action against a simulated controller over real sockets."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import MoveAbsoluteGoal, RobotPose
from cobot_goals import ELSEWHERE, HOME, POSE, SLOWLY, line_to, ptp_to, to_joints
from cobot_test import CobotTestCase
from tf_frames import pose_in

HOME_POSE = (517.5, -122.3, 461.05, 180, 0, 90)


class MoveAbsolute(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.robot.establish()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    # --- Done.
    def test_is_done_when_the_robot_stands_at_the_joints(self):
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))
        self.assert_stands_at(ELSEWHERE)

    def test_is_done_when_the_robot_stands_at_the_pose(self):
        self.assert_done(self.robot.run(ptp_to(400, 100, 500, 180, 0, 60)))
        self.assert_tool_at(400, 100, 500, 180, 0, 60)

    def test_goes_straight_on_a_line(self):
        self.assert_done(self.robot.run(line_to(400, 100, 500, 170, 10, 60)))
        self.assert_tool_at(400, 100, 500, 170, 10, 60)

    def test_takes_the_wanted_robot_pose(self):
        pose = RobotPose(RobotPose.RIGHTY, RobotPose.BELOW, RobotPose.NOFLIP)
        self.assert_done(self.robot.run(ptp_to(517.5, -122.3, 461.05, 180, 0, 90, robot_pose_enable=True,
                                               robot_pose=pose)))
        self.assertLess(self.robot.true_joints.message.position[2], 0, "elbow below means J3 < 0")

    def test_reports_planned_and_actual_time_and_the_tag(self):
        state, result = self.robot.run(to_joints(*ELSEWHERE, command_id=7))
        self.assertEqual(state, GoalStatus.SUCCEEDED)
        self.assertEqual(result.command_id_ack, 7)
        self.assertGreater(result.planned_duration.to_sec(), 0.1)
        self.assertGreater(result.actual_duration.to_sec(), 0)
        self.assertEqual(len(result.final_joints), 6)

    def test_is_done_on_acceptance_when_it_blends(self):
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE, blending_enable=True, blending_value=50, **SLOWLY)))
        self.wait_for_departure()

    def test_leaves_the_listen_node_after_the_motion_on_request(self):
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE, exit_node=True)))
        self.assert_stands_at(ELSEWHERE)

    # --- Refused before a byte is sent.
    def test_refuses_inputs_outside_their_range_by_the_thesis_ids(self):
        rows = (
            (line_to(400, 100, 500, 180, 0, 60, speed=4501), 0x25),
            (line_to(400, 100, 500, 180, 0, 60, speed=-1), 0x25),
            (to_joints(*HOME, speed=101), 0x26),
            (to_joints(*HOME, speed=0), 0x26),
            (to_joints(*HOME, accel_time=149), 0x27),
            (to_joints(*HOME, accel_time=10000), 0x27),
            (to_joints(*HOME, command_id=1), 0x28),
            (to_joints(*HOME, command_id=10), 0x28),
            (to_joints(*HOME, command_id=-3), 0x28),
            (line_to(400, 100, 500, 180, 0, 60, robot_pose_enable=True), 0x29),
            (ptp_to(400, 100, 500, 180, 0, 60, robot_pose_enable=True, robot_pose=RobotPose(2, 2, 4)), 0x30),
            (ptp_to(400, 100, 500, 180, 0, 60, robot_pose_enable=True, robot_pose=RobotPose(0, 4, 4)), 0x31),
            (ptp_to(400, 100, 500, 180, 0, 60, robot_pose_enable=True, robot_pose=RobotPose(0, 2, 3)), 0x32),
            (ptp_to(400, 100, 500, 180, 0, 60, data_format=MoveAbsoluteGoal.CAP), 0x35),
            (line_to(400, 100, 500, 180, 0, 60, data_format=MoveAbsoluteGoal.JPP, speed=50), 0x36),
        )
        for goal, error_id in rows:
            with self.subTest(error_id=hex(error_id), speed=goal.speed, accel_time=goal.accel_time):
                self.assert_rejected(self.robot.run(goal), error_id)
        self.assert_stands_at(HOME)

    def test_refuses_what_the_arm_cannot_do_and_says_why(self):
        rows = (
            (ptp_to(2000, 0, 400, 180, 0, 90), 0x201, "reach"),
            (to_joints(0, 0, 156, 0, 90, 0), 0x203, "limit"),
            (to_joints(math.nan, 0, 90, 0, 90, 0), 0x200, "finite"),
            (to_joints(math.inf, 0, 90, 0, 90, 0), 0x200, "finite"),
            (ptp_to(400, 100, 500, 1e308, 0, 60), 0x213, ""),
        )
        self.assert_refuses(rows)
        self.assert_rejected(self.robot.run(line_to(-517.5, -122.3, 461.05, 180, 0, 90)), 0x205)
        self.assert_stands_at(HOME)

    def test_refuses_what_the_thesis_has_no_id_for(self):
        radius = {"data_format": MoveAbsoluteGoal.CAR, "blending_enable": True}
        posed = {"robot_pose_enable": True, "robot_pose": RobotPose(0, 2, 4)}
        rows = (
            *((to_joints(*HOME, blending_enable=True, blending_value=v), 0x210, "blending") for v in (-1, 101)),
            *((line_to(*POSE, blending_value=v, **radius), 0x210, "blending") for v in (-1, 2001)),
            *((to_joints(*HOME, movement_command=v), 0x211, "") for v in (-1, 2)),
            (to_joints(*HOME, **posed), 0x212, ""),
            *((ptp_to(*POSE[:2], v, *POSE[3:]), 0x213, "") for v in (-100000.1, 100000.1)),
            (ptp_to(*POSE, target_pose=pose_in("nowhere", (0, 0, 0), (1, 0, 0, 0))), 0x217, "nowhere"),
            (ptp_to(*POSE, target_pose=pose_in("/base", (0, 0, 0), (1, 0, 0, 0))), 0x217, 'no leading /; is "base" meant?'),
            *((ptp_to(*POSE, target_pose=pose_in("base", (0.4, 0.1, 0.5), (v, 0, 0, 0))), 0x218, "")
              for v in (0, 0.9989, 1.0011)),
            (to_joints(*HOME, target_pose=pose_in("base", (0.4, 0.1, 0.5), (1, 0, 0, 0))), 0x219, ""),
        )
        self.assert_refuses(rows)

    def test_takes_both_ends_of_every_range_in_every_format(self):
        radius = {"blending_enable": True, "blending_value": 2000, "check_only": True}
        percent = {"blending_enable": True, "blending_value": 100, "check_only": True}
        for goal in (
                *(to_joints(*ELSEWHERE, speed=v, **percent) for v in (1, 100)),
                *(ptp_to(*POSE, accel_time=v, **percent) for v in (150, 9999)),
                *(line_to(*POSE, speed=v, data_format=f, **percent) for f, v in
                  ((MoveAbsoluteGoal.CPP, 1), (MoveAbsoluteGoal.CAP, 1))),
                *(line_to(*POSE, speed=50, data_format=f, **radius) for f in
                  (MoveAbsoluteGoal.CPR, MoveAbsoluteGoal.CAR)),
                *(line_to(*HOME_POSE[:2], HOME_POSE[2] - 1, *HOME_POSE[3:], speed=v, data_format=f, check_only=True)
                  for f, v in ((MoveAbsoluteGoal.CPP, 100), (MoveAbsoluteGoal.CAP, 4500)))):
            with self.subTest(str(goal).replace("\n", " ")):
                self.assert_done(self.robot.run(goal))

    def test_takes_every_robot_pose_that_the_pose_has(self):
        for shoulder in (RobotPose.RIGHTY, RobotPose.LEFTY):
            for elbow in (RobotPose.ABOVE, RobotPose.BELOW):
                for wrist in (RobotPose.NOFLIP, RobotPose.FLIP):
                    with self.subTest(shoulder=shoulder, elbow=elbow, wrist=wrist):
                        outcome = self.robot.run(ptp_to(*HOME_POSE, robot_pose_enable=True, check_only=True,
                                                        robot_pose=RobotPose(shoulder, elbow, wrist)))
                        if (shoulder, wrist) == (RobotPose.RIGHTY, RobotPose.FLIP):
                            self.assert_rejected(outcome, 0x20A)  # half a turn of joint 6: either way round
                        elif outcome[0] == GoalStatus.REJECTED:
                            self.assert_rejected(outcome, 0x203)  # a posture that only other joint ranges have
                        else:
                            self.assert_done(outcome)

    def test_goes_to_a_pose_in_a_tf_frame(self):
        self.assert_done(self.robot.run(ptp_to(target_pose=pose_in("base", (0.4, 0.1, 0.5), (1, 0, 0, 0)))))
        self.assert_tool_at(400, 100, 500, 180, 0, 0)

    def test_refuses_a_goal_that_is_all_zeros(self):
        state, result = self.robot.run(MoveAbsoluteGoal())
        self.assertEqual(state, GoalStatus.REJECTED, result.error_description)

    def test_is_refused_without_a_connection(self):
        self.robot.close()
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x10)

    def test_is_refused_while_another_goal_is_executed(self):
        self.start_slowly()
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x11)
        self.sent.cancel()
        self.robot.true_status.wait_for(lambda s: s.in_motion == 0, "the stop")

    # --- Ended from outside.
    def test_stops_the_robot_and_is_preempted_when_it_is_cancelled(self):
        self.start_slowly()
        self.sent.cancel()
        state, result = self.sent.finish()
        self.assertEqual(state, GoalStatus.PREEMPTED, result.error_description)
        self.assert_stands_still()
        self.assertNotAlmostEqual(math.degrees(self.robot.true_joints.message.position[0]), ELSEWHERE[0], places=1)

    def test_can_be_followed_by_another_goal_after_a_cancel(self):
        self.start_slowly()
        self.sent.cancel()
        self.sent.finish()
        self.assert_done(self.robot.run(to_joints(*HOME)))
        self.assert_stands_at(HOME)

    def test_is_aborted_when_the_link_is_lost_in_motion(self):
        self.start_slowly()
        self.robot.operate("stop_project")
        self.assert_aborted(self.sent.finish(), 0x99)
        self.assert_aborted(self.robot.connect.finish(), 0x90)

    def test_is_aborted_by_an_emergency_stop(self):
        self.start_slowly()
        self.robot.operate("set_emergency_stop", True)
        self.assert_aborted(self.sent.finish(), 0x99)
        self.assert_stands_still()

    def test_works_again_after_the_controller_was_restarted(self):
        self.start_slowly()
        self.robot.operate("stop_project")
        self.sent.finish()
        self.robot.connect.finish()
        self.robot.operate("run_project")
        self.robot.establish()
        self.assert_stands_still()  # nothing resumes by itself
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))
        self.assert_stands_at(ELSEWHERE)

    # --- Helpers.
    def start_slowly(self):
        """Starts towards ELSEWHERE, and returns when the arm is on its way."""
        self.sent = self.robot.start_slowly(to_joints(*ELSEWHERE, **SLOWLY))

    def wait_for_departure(self):
        self.robot.true_joints.wait_for(lambda m: m.position[0] > 0.01, "the arm's departure from HOME")

    def assert_stands_at(self, degrees):
        """The truth of the simulator and what the status stream says of it."""
        wanted = [math.radians(value) for value in degrees]
        for joints in (self.robot.true_joints, self.robot.joints):
            message = joints.wait_for(
                lambda m: max(abs(a - b) for a, b in zip(m.position, wanted)) < 1e-5
                and max(abs(v) for v in m.velocity) < 1e-6, f"the arm at {degrees}")
            self.assertEqual(len(message.name), 6)

    def assert_stands_still(self):
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")

    def assert_tool_at(self, x, y, z, rx, ry, rz):
        """The tool as the status stream reports it: mm and degrees here, m and a quaternion on the topic."""
        wanted = quaternion(math.radians(rx), math.radians(ry), math.radians(rz))

        def there(message):
            position, orientation = message.pose.position, message.pose.orientation
            cosine = sum(a * b for a, b in zip((orientation.w, orientation.x, orientation.y, orientation.z), wanted))
            return (math.dist((position.x, position.y, position.z), (x / 1e3, y / 1e3, z / 1e3)) < 1e-5
                    and abs(cosine) > 1 - 1e-9)

        self.robot.tool_pose.wait_for(there, f"the tool at {(x, y, z, rx, ry, rz)}")


def quaternion(rx, ry, rz):
    """(w, x, y, z) of Rz(rz) Ry(ry) Rx(rx)."""
    product = (1.0, 0.0, 0.0, 0.0)
    for axis, angle in ((3, rz), (2, ry), (1, rx)):
        factor = [math.cos(angle / 2), 0.0, 0.0, 0.0]
        factor[axis] = math.sin(angle / 2)
        product = multiply(product, factor)
    return product


def multiply(a, b):
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


if __name__ == "__main__":
    import rostest

    rospy.init_node("move_absolute_test")
    rostest.rosrun("cobot_command", "move_absolute", MoveAbsolute)
