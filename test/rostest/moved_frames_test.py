#!/usr/bin/env python3
"""Targets in tf frames that move while a goal waits for its turn, as they do when the robot is on a vehicle."""
import itertools

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_goals import BUFFERED, base, circle, cycle, line_to, relative, sequence, step, tcp
from motion_checks import MotionTestCase
from tf_frames import Frames, pose_in
from waiting import wait_until

START = (450, -100, 400, 180, 0, 90)
ABOVE_START = (450, -100, 410, 180, 0, 90)
END = (450, 100, 400, 180, 0, 90)
TABLE = (0.2, 0.1, 0.3)
OVER_THE_TABLE = (0.25, -0.1, 0.1)
PUSHED = 0.05  # [m]


class Table:
    """A frame with a name of its own, that can be pushed along Y."""
    numbers = itertools.count()

    def __init__(self, tf, robot):
        self._tf, self._robot = tf, robot
        self.name = f"table_{next(self.numbers)}"
        self._publish(0)
        wait_until(self._planned_end, "the table")

    def over(self):
        return pose_in(self.name, OVER_THE_TABLE, (1, 0, 0, 0))

    def to(self, **changes):
        return line_to(0, 0, 0, **{"target_pose": self.over(), **changes})

    def push(self):
        """Returns when the command node knows of it."""
        before = self._planned_end()
        self._publish(PUSHED)
        wait_until(lambda: any(abs(a - b) > 1e-3 for a, b in zip(self._planned_end(), before)), "the pushed table")

    def _publish(self, pushed):
        self._tf.publish("base", self.name, (TABLE[0], TABLE[1] + pushed, TABLE[2]), 0)

    def _planned_end(self):
        """Of a motion to it from HOME [rad]; empty while the node does not know it."""
        # With a base and a TCP of its own: behind a cycle nobody knows which there will be.
        state, result = self._robot.run(sequence(base(0, 0, 0), tcp(0, 0, 0), self.to()))
        return result.steps[2].joint_path.points[-1].positions if state == GoalStatus.SUCCEEDED else ()


class MovedFrames(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.tf = Frames()

    def setUp(self):
        super().setUp()
        self.assert_done(self.robot.run(line_to(*START)))
        self.table = Table(self.tf, self.robot)

    def end_after_a_push(self, goal):
        """Of a goal that waits, behind a motion that is held until the table has been pushed."""
        self.robot.operate("pause_project")
        motion = self.robot.send(relative(0, 0, 10)).wait_until_active()
        waiting = self.robot.send(goal).wait_until_queued()
        self.table.push()
        self.robot.operate("resume_project")
        self.assert_done(motion.finish())
        return waiting.finish()

    def test_refuses_a_move_whose_frame_has_moved(self):
        self.assert_rejected(self.end_after_a_push(self.table.to(buffer_mode=BUFFERED)), 0x20B, "50.0 mm")

    def test_refuses_an_arc_one_of_whose_frames_has_moved(self):
        goal = circle((), END, arc_pose=self.table.over(), buffer_mode=BUFFERED)
        self.assert_rejected(self.end_after_a_push(goal), 0x20B, "arc_pose")

    def test_refuses_a_base_whose_frame_has_moved(self):
        goal = base(base_pose=self.table.over(), buffer_mode=BUFFERED)
        self.assert_rejected(self.end_after_a_push(goal), 0x20B, "base_pose")

    def test_refuses_a_cycle_before_its_first_move(self):
        goal = cycle(step(line_to(*END)), step(self.table.to()), buffer_mode=BUFFERED)
        outcome = self.end_after_a_push(goal)
        self.assert_rejected(outcome, 0x251, "frame moved")
        self.assertEqual((outcome[1].failed_step, outcome[1].step_error_id), (1, 0x20B))

    def test_ends_a_cycle_at_the_step_whose_frame_has_moved(self):
        self.robot.operate("pause_project")
        running = self.robot.send(cycle(step(line_to(*ABOVE_START)), step(self.table.to()))).wait_until_active()
        self.table.push()
        self.robot.operate("resume_project")
        outcome = running.finish()
        self.assert_aborted(outcome, 0x251, "frame moved")
        self.assertEqual((outcome[1].failed_step, outcome[1].step_error_id), (1, 0x20B))

    def test_goes_where_the_frame_was_when_the_goal_says_so_by_a_stamp(self):
        goal = self.table.to(buffer_mode=BUFFERED)
        goal.target_pose.header.stamp = rospy.Time.now()
        self.assert_done(self.end_after_a_push(goal))
        self.robot.tool_pose.wait_for(
            lambda m: abs(m.pose.position.y - TABLE[1] - OVER_THE_TABLE[1]) < 1e-4, "the tool where the table was")


if __name__ == "__main__":
    import rostest

    rospy.init_node("moved_frames_test")
    rostest.rosrun("cobot_command", "moved_frames", MovedFrames)
