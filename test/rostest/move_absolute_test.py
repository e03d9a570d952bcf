#!/usr/bin/env python3
"""The move_absolute action against a simulated controller over real sockets."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import MoveAbsoluteGoal, RobotPose
from cobot_test import CobotTestCase, finish, line_to, ptp_to, to_joints, wait_until

HOME = (0, 0, 90, 0, 90, 0)
ELSEWHERE = (60, -20, 100, 10, 80, -45)
SLOWLY = {"speed": 5, "accel_time": 1000}  # long enough to be interrupted


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
            (ptp_to(2000, 0, 400, 180, 0, 90), "reach"),
            (to_joints(0, 0, 156, 0, 90, 0), "limit"),
            (line_to(-517.5, -122.3, 461.05, 180, 0, 90), ""),
            (to_joints(math.nan, 0, 90, 0, 90, 0), "finite"),
            (to_joints(math.inf, 0, 90, 0, 90, 0), "finite"),
            (ptp_to(400, 100, 500, 1e308, 0, 60), ""),
            (to_joints(*HOME, blending_enable=True, blending_value=101), "blending"),
            (to_joints(*HOME, blending_enable=True, blending_value=-1), "blending"),
        )
        for goal, words in rows:
            with self.subTest(target=str(goal.target_position).replace("\n", " ")):
                state, result = self.robot.run(goal)
                self.assertEqual(state, GoalStatus.REJECTED, result.error_description)
                self.assertGreaterEqual(result.error_id, 0x200)
                self.assertIn(words, result.error_description.lower())
        self.assert_stands_at(HOME)

    def test_refuses_a_goal_that_is_all_zeros(self):
        state, result = self.robot.run(MoveAbsoluteGoal())
        self.assertEqual(state, GoalStatus.REJECTED, result.error_description)

    def test_is_refused_without_a_connection(self):
        self.robot.close()
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x10)

    def test_is_refused_while_another_goal_is_executed(self):
        self.start_slowly()
        first = self.robot.move.gh
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x11)
        first.cancel()
        self.robot.true_status.wait_for(lambda s: s.in_motion == 0, "the stop")

    # --- Ended from outside.
    def test_stops_the_robot_and_is_preempted_when_it_is_cancelled(self):
        self.start_slowly()
        self.robot.move.cancel_goal()
        state, result = finish(self.robot.move)
        self.assertEqual(state, GoalStatus.PREEMPTED, result.error_description)
        self.assert_stands_still()
        self.assertNotAlmostEqual(math.degrees(self.robot.true_joints.message.position[0]), ELSEWHERE[0], places=1)

    def test_can_be_followed_by_another_goal_after_a_cancel(self):
        self.start_slowly()
        self.robot.move.cancel_goal()
        finish(self.robot.move)
        self.assert_done(self.robot.run(to_joints(*HOME)))
        self.assert_stands_at(HOME)

    def test_is_aborted_when_the_link_is_lost_in_motion(self):
        self.start_slowly()
        self.robot.operate("stop_project")
        self.assert_aborted(finish(self.robot.move), 0x99)
        self.assert_aborted(finish(self.robot.connect), 0x90)

    def test_is_aborted_by_an_emergency_stop(self):
        self.start_slowly()
        self.robot.operate("set_emergency_stop", True)
        self.assert_aborted(finish(self.robot.move), 0x99)
        self.assert_stands_still()

    def test_works_again_after_the_controller_was_restarted(self):
        self.start_slowly()
        self.robot.operate("stop_project")
        finish(self.robot.move)
        finish(self.robot.connect)
        self.robot.operate("run_project")
        self.robot.establish()
        self.assert_stands_still()  # nothing resumes by itself
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))
        self.assert_stands_at(ELSEWHERE)

    # --- Helpers.
    def start_slowly(self):
        """Starts towards ELSEWHERE, and returns when the arm is on its way."""
        self.robot.move.send_goal(to_joints(*ELSEWHERE, **SLOWLY))
        # A client that cancels before the server's first word on a goal takes the goal for lost.
        wait_until(lambda: self.robot.move.get_state() == GoalStatus.ACTIVE, "the active goal")
        self.wait_for_departure()

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
