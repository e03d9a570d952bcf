#!/usr/bin/env python3
"""The move_relative action against a simulated controller over real sockets."""
import math

import rospy

from cobot_command.msg import MoveRelativeGoal, StopGoal
from cobot_goals import HOME, SLOWLY, relative, turn
from motion_checks import MotionTestCase

PTP, LINE = MoveRelativeGoal.PTP, MoveRelativeGoal.LINE
JPP, CPP, CPR, CAP, CAR, TPP, TPR, TAP, TAR = range(9)
MILLIMETRES = (CAP, CAR, TAP, TAR)


class MoveRelative(MotionTestCase):
    # --- Done.
    def test_goes_by_an_offset_of_the_joints(self):
        self.assert_result_is_true(self.assert_done(self.robot.run(turn(10, -5, 8, 3, -2, 40))))
        self.assert_stands_at([a + b for a, b in zip(HOME, (10, -5, 8, 3, -2, 40))])

    def test_goes_along_the_base_or_the_tool_in_every_format(self):
        # The tool hangs upside down, its X along the base's Y.
        along_tool = {TPP, TPR, TAP, TAR}
        rows = [(PTP, CPP), (PTP, TPP), *((LINE, data_format) for data_format in range(CPP, TAR + 1))]
        before = self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 0.1)))
        for movement, data_format in rows:
            with self.subTest(movement=movement, data_format=data_format):
                goal = relative(0, 0, -20, 0, 0, 0, movement_command=movement, data_format=data_format,
                                speed=250 if data_format in MILLIMETRES else 80)
                after = self.assert_done(self.robot.run(goal))
                self.assert_moved(before, after, (0, 0, 20 if data_format in along_tool else -20, 0, 0, 0))
                before = after

    def test_reports_the_truth(self):
        self.assert_result_is_true(self.assert_done(self.robot.run(relative(30, 20, 10, 5, 5, 5, command_id=7))), 7)

    def test_tells_how_far_it_is(self):
        self.assert_feedback_goes_on(turn(40, 0, 0, 0, 0, 0, speed=20, accel_time=500))

    def test_is_done_on_acceptance_when_it_blends(self):
        for movement, data_format, value in ((PTP, JPP, 100), (LINE, CAP, 100), (LINE, CAR, 2000)):
            with self.subTest(data_format=data_format):
                goal = relative(0, 0, 30, 0, 0, 0, movement_command=movement, data_format=data_format, speed=5,
                                blending_enable=True, blending_value=value)
                self.assertEqual(self.assert_done(self.robot.run(goal)).actual_duration.to_sec(), 0)
                self.robot.wait_for_motion()
                self.assert_stopped()

    def test_leaves_the_listen_node_after_the_motion_on_request(self):
        self.assert_done(self.robot.run_and_reenter(turn(10, 0, 0, 0, 0, 0, exit_node=True)))
        self.assert_stands_at((10, 0, 90, 0, 90, 0))

    # --- Ended or held from outside.
    def test_is_held_by_a_pause_and_stopped_by_a_cancel(self):
        self.assert_is_held_by_a_pause(turn(60, 0, 0, 0, 0, 0, **SLOWLY))
        self.assertNotAlmostEqual(math.degrees(self.robot.true_joints.message.position[0]), 60, places=1)

    # --- Inputs.
    def test_refuses_inputs_outside_their_range(self):
        nan, inf = math.nan, math.inf
        rows = [
            *((relative(0, 0, 9, 0, 0, 0, data_format=f, speed=v), 0x25, "") for f in MILLIMETRES for v in (0, 4501)),
            *((relative(0, 0, 9, 0, 0, 0, data_format=f, speed=v), 0x26, "") for f in (CPP, CPR, TPP, TPR)
              for v in (0, 101)),
            *((turn(1, 0, 0, 0, 0, 0, speed=v), 0x26, "") for v in (-1, 0, 101)),
            *((relative(0, 0, 9, 0, 0, 0, accel_time=v), 0x27, "") for v in (-1, 149, 10000)),
            *((turn(1, 0, 0, 0, 0, 0, data_format=f), 0x30, "") for f in (-1, CPR, CAR, TPR, 9)),
            *((relative(0, 0, 9, 0, 0, 0, speed=80, data_format=f), 0x31, "") for f in (JPP, -1, 9)),
            *((relative(*v, 0, 0, 0), 0x200, "") for v in ((nan, 0, 0), (0, inf, 0), (0, 0, -inf))),
            *((turn(0, 0, 0, 0, 0, 1, data_format=f, blending_enable=True, blending_value=v), 0x210, "")
              for f in (JPP, CPP, TPP) for v in (-1, 101)),
            *((relative(0, 0, 9, 0, 0, 0, speed=50, data_format=f, blending_enable=True, blending_value=v), 0x210, "")
              for f in (CPR, CAR, TPR, TAR) for v in (-1, 2001)),
            *((relative(0, 0, 9, 0, 0, 0, movement_command=v), 0x211, "") for v in (-1, 2)),
            *((relative(0, v, 0, 0, 0, 0), 0x213, "") for v in (-100000.1, 100000.1)),
        ]
        self.assert_refuses(rows)
        self.assert_stands_at(HOME)

    def test_takes_both_ends_of_every_range(self):
        rows = (
            *(relative(0, 0, 1, 0, 0, 0, speed=v, check_only=True) for v in (1, 4500)),
            *(turn(0, 0, 0, 0, 0, 1, speed=v, check_only=True) for v in (1, 100)),
            *(relative(0, 0, 1, 0, 0, 0, accel_time=v, check_only=True) for v in (150, 9999)),
            *(turn(0, 0, 0, 0, 0, 1, blending_enable=True, blending_value=v, check_only=True) for v in (0, 100)),
            *(relative(0, 0, 1, 0, 0, 0, data_format=CAR, blending_enable=True, blending_value=v, check_only=True)
              for v in (0, 2000)),
        )
        for goal in rows:
            with self.subTest(str(goal).replace("\n", " ")):
                self.assert_done(self.robot.run(goal))

    def test_refuses_a_goal_that_is_all_zeros(self):
        self.assert_rejected(self.robot.run(MoveRelativeGoal()), 0x26)

    def assert_stopped(self):
        self.assert_done(self.robot.run(StopGoal()))
        self.robot.wait_for_standstill()


if __name__ == "__main__":
    import rostest

    rospy.init_node("move_relative_test")
    rostest.rosrun("cobot_command", "move_relative", MoveRelative)
