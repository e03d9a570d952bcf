#!/usr/bin/env python3
"""The move_circle action against a simulated controller over real sockets."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import MoveCircleGoal
from cobot_goals import circle, line_to
from motion_checks import MotionTestCase
from tf_frames import Frames, pose_in

START = (450, -100, 400, 180, 0, 90)
ARC = (500, 0, 400, 180, 0, 90)
END = (450, 100, 400, 180, 0, 90)
SLOWLY = {"speed": 20, "accel_time": 1000}


class MoveCircle(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.tf = Frames()
        cls.tf.publish("base", "table", (0.2, 0.1, 0.3), math.pi / 2)

    def setUp(self):
        super().setUp()
        self.start = self.assert_done(self.robot.run(line_to(*START)))

    # --- Done.
    def test_goes_through_the_arc_point_to_the_end_in_both_formats(self):
        for data_format, speed in ((MoveCircleGoal.CAP, 250), (MoveCircleGoal.CPP, 80)):
            with self.subTest(data_format=data_format):
                result = self.assert_done(self.robot.run(circle(ARC, END, data_format=data_format, speed=speed)))
                self.assert_moved(self.start, result, (0, 200, 0, 0, 0, 0))
                self.assert_result_is_true(result)
                self.assert_done(self.robot.run(line_to(*START)))

    def test_passes_the_arc_point(self):
        path = self.assert_done(self.robot.run(circle(ARC, END, check_only=True))).joint_path
        reached = self.assert_done(self.robot.run(line_to(*ARC))).final_joints
        nearest = min(max(abs(math.degrees(a) - b) for a, b in zip(point.positions, reached)) for point in path.points)
        self.assertLess(nearest, 1.0)

    def test_turns_to_the_orientation_of_the_end_without_an_angle_and_holds_it_with_one(self):
        turned = (*END[:3], 180, 0, 60)
        result = self.assert_done(self.robot.run(circle(ARC, turned)))
        self.assert_moved(self.start, result, (0, 200, 0, 0, 0, -30))
        self.assert_done(self.robot.run(line_to(*START)))
        result = self.assert_done(self.robot.run(circle(ARC, turned, arc_angle=360)))
        self.assert_moved(self.start, result, (0, 0, 0, 0, 0, 0))

    def test_goes_to_poses_in_a_tf_frame(self):
        # Seen from the table, the base's X is -Y and the base's Y is X.
        arc = pose_in("table", (-0.1, -0.3, 0.1), (1, 0, 0, 0))
        end = pose_in("table", (0.0, -0.25, 0.1), (1, 0, 0, 0))
        result = self.assert_done(self.robot.run(circle(ARC, END, arc_pose=arc, end_pose=end)))
        self.assert_moved(self.start, result, (0, 200, 0, 0, 0, 0))

    def test_tells_how_far_it_is(self):
        self.assert_feedback_goes_on(circle(ARC, END, speed=100))

    def test_is_done_on_acceptance_when_it_blends(self):
        for value in (0, 100):
            with self.subTest(blending_value=value):
                result = self.assert_done(self.robot.run(
                    circle(ARC, END, blending_enable=True, blending_value=value, **SLOWLY)))
                self.assertEqual(result.actual_duration.to_sec(), 0)
                self.robot.wait_for_motion()
                self.assert_done(self.robot.run(line_to(*START, buffer_mode=MoveCircleGoal.ABORTING)))

    def test_leaves_the_listen_node_after_the_motion_on_request(self):
        self.assert_done(self.robot.run_and_reenter(circle(ARC, END, exit_node=True)))

    # --- Ended or held from outside.
    def test_is_held_by_a_pause_and_stopped_by_a_cancel(self):
        self.assert_is_held_by_a_pause(circle(ARC, END, **SLOWLY))

    def test_is_preempted_when_another_takes_over(self):
        sent = self.robot.start_slowly(circle(ARC, END, **SLOWLY))
        self.assert_done(self.robot.run(line_to(*START, buffer_mode=MoveCircleGoal.ABORTING)))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())

    # --- Inputs.
    def test_refuses_inputs_outside_their_range(self):
        nan = math.nan
        with_pose = {"end_pose": pose_in("no_such_frame", (0, 0, 0), (1, 0, 0, 0))}
        zero = {"arc_pose": pose_in("base", (0.5, 0, 0.4), (0, 0, 0, 0))}
        long = {"arc_pose": pose_in("base", (0.5, 0, 0.4), (1.0011, 0, 0, 0))}
        rows = [
            *((circle(ARC, END, speed=v), 0x25, "") for v in (-1, 0, 4501)),
            *((circle(ARC, END, data_format=MoveCircleGoal.CPP, speed=v), 0x26, "") for v in (-1, 0, 101)),
            *((circle(ARC, END, accel_time=v), 0x27, "") for v in (149, 10000)),
            (circle((nan, *ARC[1:]), END), 0x200, ""), (circle(ARC, (*END[:5], nan)), 0x200, ""),
            *((circle(ARC, END, blending_enable=True, blending_value=v), 0x210, "") for v in (-1, 101)),
            (circle((100000.1, *ARC[1:]), END), 0x213, ""), (circle(ARC, (*END[:2], -100000.1, 0, 0, 0)), 0x213, ""),
            (circle(ARC, END, **with_pose), 0x217, "no_such_frame"), (circle(ARC, END, **zero), 0x218, ""),
            (circle(ARC, END, **long), 0x218, ""),
            *((circle(ARC, END, arc_angle=v), 0x21A, "") for v in (-0.1, 360.1, nan)),
            *((circle(ARC, END, speed=80, data_format=v), 0x21B, "") for v in (-1, 2)),
            (circle(START, END), 0x206, "circle"),
        ]
        self.assert_refuses(rows)

    def test_takes_both_ends_of_every_range(self):
        rows = (
            *(circle(ARC, END, speed=v) for v in (1, 1000)),
            *(circle(ARC, END, data_format=MoveCircleGoal.CPP, speed=v) for v in (1, 100)),
            *(circle(ARC, END, accel_time=v) for v in (150, 9999)), *(circle(ARC, END, arc_angle=v) for v in (0, 360)),
            *(circle(ARC, END, arc_pose=pose_in("base", (0.5, 0, 0.4), (v, 0, 0, 0))) for v in (0.9991, 1.0009)),
        )
        for goal in rows:
            goal.check_only = True
            with self.subTest(str(goal).replace("\n", " ")):
                self.assert_done(self.robot.run(goal))

    def test_refuses_a_goal_that_is_all_zeros(self):
        self.assert_rejected(self.robot.run(MoveCircleGoal()), 0x26)


if __name__ == "__main__":
    import rostest

    rospy.init_node("move_circle_test")
    rostest.rosrun("cobot_command", "move_circle", MoveCircle)
