#!/usr/bin/env python3
"""The change_base action against a simulated controller over real sockets."""
import math

import rospy

from cobot_command.msg import ChangeBaseGoal
from cobot_goals import BUFFERED, SLOWLY, base, line_to, relative, turn
from motion_checks import AS_REPORTED, MotionTestCase
from tf_frames import Frames, Lookup, pose_in
from waiting import wait_until

FAR = 100000.0


class ChangeBase(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.tf = Frames()
        cls.tf.publish("base", "table", (0.2, 0.1, 0.3), math.pi / 2)

    def tearDown(self):
        self.robot.run(base(base_name="RobotBase"))

    # --- Done.
    def test_counts_for_the_motions_behind_it(self):
        before = self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 0.1)))
        self.assert_done(self.robot.run(base(100, 50, 20, 0, 0, 90)))
        after = self.assert_done(self.robot.run(relative(30, 0, 0)))
        # The base's X is the robot's Y, and its Y the robot's -X.
        self.assertAlmostEqual(after.final_pose.x, before.final_pose.y - 50 + 30, delta=AS_REPORTED)
        self.assertAlmostEqual(after.final_pose.y, -(before.final_pose.x - 100), delta=AS_REPORTED)
        self.assertAlmostEqual(after.final_pose.z, before.final_pose.z - 20, delta=AS_REPORTED)

    def test_tells_the_active_base_at_once_and_as_a_tf_frame(self):
        frames = Lookup()
        self.assert_done(self.robot.run(base(100, 50, 20, 0, 0, 90)))
        active = self.robot.active_frames.wait_for(lambda f: f.base_known and f.base.position.x > 0.05, "the base")
        self.assertEqual(active.header.frame_id, "base")
        self.assertAlmostEqual(active.base.position.x, 0.1)
        self.assertAlmostEqual(active.base.position.y, 0.05)
        self.assertAlmostEqual(active.base.position.z, 0.02)
        self.assertAlmostEqual(active.base.orientation.z, math.sqrt(0.5))
        wait_until(lambda: math.dist(frames.position("base", "active_base") or (0, 0, 0), (0.1, 0.05, 0.02)) < 1e-6,
                   "the frame active_base")

    def test_tells_it_before_the_motions_in_front_are_done(self):
        moving = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, blending_enable=True, **SLOWLY))
        self.assert_done(moving.finish())
        self.assert_done(self.robot.run(base(70, 0, 0, buffer_mode=BUFFERED)))
        self.robot.active_frames.wait_for(lambda f: abs(f.base.position.x - 0.07) < 1e-9, "the base")
        self.assertGreater(max(abs(v) for v in self.robot.true_joints.message.velocity), 1e-3)
        self.robot.operate("stop_project")

    def test_takes_a_base_of_the_project_by_its_name(self):
        self.assert_done(self.robot.run(base(10, 0, 0)))
        self.assert_done(self.robot.run(base(base_name="RobotBase")))
        active = self.robot.active_frames.wait_for(lambda f: f.base_name == "RobotBase", "the robot base")
        self.assertEqual(active.base.position.x, 0)

    def test_is_aborted_for_a_name_that_the_project_does_not_know(self):
        self.assert_aborted(self.robot.run(base(base_name="Nowhere")), 0x80, "Nowhere")

    def test_takes_a_base_in_a_tf_frame(self):
        self.assert_done(self.robot.run(base(base_pose=pose_in("table", (0.1, 0, 0), (0, 0, 0, 1)))))
        active = self.robot.active_frames.wait_for(lambda f: abs(f.base.position.x - 0.2) < 1e-6, "the base")
        self.assertAlmostEqual(active.base.position.y, 0.2)
        self.assertAlmostEqual(active.base.position.z, 0.3)

    def test_lets_targets_in_a_tf_frame_stay_where_they_are(self):
        self.assert_done(self.robot.run(base(100, 50, 20, 0, 0, 90)))
        goal = line_to(0, 0, 0, target_pose=pose_in("base", (0.4, 0.1, 0.5), (1, 0, 0, 0)))
        self.assert_done(self.robot.run(goal))
        self.robot.tool_pose.wait_for(
            lambda m: math.dist((m.pose.position.x, m.pose.position.y, m.pose.position.z), (0.4, 0.1, 0.5)) < 1e-5,
            "the tool at the pose")

    def test_leaves_the_listen_node_on_request(self):
        self.assert_done(self.robot.run_and_reenter(base(exit_node=True)))

    # --- Inputs.
    def test_refuses_inputs_outside_their_range(self):
        self.assert_refuses([
            *((base(0, v), 0x200, "") for v in (math.nan, math.inf, -math.inf)),
            *((base(0, 0, 0, v), 0x213, "") for v in (-FAR - 0.1, FAR + 0.1)),
            (base(base_pose=pose_in("no_such_frame", (0, 0, 0), (0, 0, 0, 1))), 0x217, "no_such_frame"),
            *((base(base_pose=pose_in("base", (0, 0, 0), (0, 0, 0, v))), 0x218, "") for v in (0, 0.9989, 1.0011)),
            (base(base_name="x" * 256), 0x21F, ""), (base(base_name="a\nb"), 0x21F, "")])

    def test_takes_both_ends_of_every_range(self):
        for goal in (base(-FAR, FAR), base(0, 0, 0, 100000, 0, -100000),
                     base(base_pose=pose_in("base", (0, 0, 0), (0, 0, 0, 0.9991))), ChangeBaseGoal()):
            with self.subTest(str(goal).replace("\n", " ")):
                self.assert_done(self.robot.run(goal))


if __name__ == "__main__":
    import rostest

    rospy.init_node("change_base_test")
    rostest.rosrun("cobot_command", "change_base", ChangeBase)
