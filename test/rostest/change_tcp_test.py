#!/usr/bin/env python3
"""The change_tcp action against a simulated controller over real sockets."""
import math

import rospy

from cobot_command.msg import MomentOfInertia, StopGoal, Transformation
from cobot_goals import relative, tcp, turn
from motion_checks import MotionTestCase
from tf_frames import Lookup
from waiting import wait_until

FAR = 100000.0
HEAVIEST_INERTIA = 1e9


class ChangeTcp(MotionTestCase):
    def tearDown(self):
        self.robot.run(tcp(tcp_name="NOTOOL"))

    # --- Done.
    def test_counts_for_the_motions_behind_it(self):
        before = self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 0.1)))
        self.assert_done(self.robot.run(tcp(0, 0, 150)))
        after = self.assert_done(self.robot.run(relative(0, 0, 20)))
        self.assert_moved(before, after, (0, 0, 20 - 150, 0, 0, 0))

    def test_tells_the_active_tcp_at_once_and_as_a_tf_frame(self):
        frames = Lookup()
        self.assert_done(self.robot.run(tcp(10, 20, 150, weight=2.5)))
        active = self.robot.active_frames.wait_for(lambda f: f.tcp_known and f.tcp.position.z > 0.1, "the TCP")
        self.assertAlmostEqual(active.tcp.position.x, 0.01)
        self.assertAlmostEqual(active.tcp.position.y, 0.02)
        self.assertAlmostEqual(active.tcp.position.z, 0.15)
        self.assertAlmostEqual(active.tool_mass, 2.5)
        wait_until(lambda: math.dist(frames.position("tool0", "active_tool") or (0, 0, 0), (0.01, 0.02, 0.15)) < 1e-6,
                   "the frame active_tool")

    def test_takes_a_tcp_of_the_project_by_its_name(self):
        self.assert_done(self.robot.run(tcp(0, 0, 150)))
        self.assert_done(self.robot.run(tcp(tcp_name="NOTOOL")))
        active = self.robot.active_frames.wait_for(lambda f: f.tcp_name == "NOTOOL", "no tool")
        self.assertEqual(active.tcp.position.z, 0)

    def test_is_aborted_for_a_name_that_the_project_does_not_know(self):
        self.assert_aborted(self.robot.run(tcp(tcp_name="Nothing")), 0x80, "Nothing")

    def test_leaves_the_listen_node_on_request(self):
        self.assert_done(self.robot.run_and_reenter(tcp(exit_node=True)))

    # --- Too heavy.
    def test_is_named_in_the_overload_that_follows_and_a_lighter_tool_leads_out(self):
        self.assert_done(self.robot.run(tcp(weight=14)))
        failed = self.robot.run(relative(0, 0, 20))
        self.assert_aborted(failed, 0x222, "the active tool has 14 kg, the payload of tm5-900 is 4 kg")
        self.assertIn("Execute stop, then change_tcp", failed[1].remedy)
        refused = self.robot.run(tcp(weight=2))
        self.assert_rejected(refused, 0x222, "the active tool has 14 kg")
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_done(self.robot.run(tcp(weight=2)))
        self.assert_done(self.robot.run(relative(0, 0, 20)))

    # --- Inputs.
    def test_refuses_inputs_outside_their_range(self):
        self.assert_refuses([
            *((tcp(weight=v), 0x25, "") for v in (-0.001, 14.001, math.nan, math.inf)),
            *((tcp(0, 0, v), 0x200, "") for v in (math.nan, math.inf)),
            (tcp(mass_center=Transformation(x=math.nan)), 0x200, ""),
            *((tcp(v), 0x213, "") for v in (-FAR - 0.1, FAR + 0.1)),
            (tcp(mass_center=Transformation(z=FAR + 0.1)), 0x213, ""),
            *((tcp(moment_of_inertia=MomentOfInertia(**{axis: v})), 0x21D, "") for axis in ("ixx", "iyy", "izz")
              for v in (-0.1, HEAVIEST_INERTIA + 1, math.nan)),
            (tcp(tcp_name="x" * 256), 0x21F, ""), (tcp(tcp_name="a\tb"), 0x21F, "")])

    def test_takes_both_ends_of_every_range(self):
        for goal in (tcp(weight=0), tcp(weight=14), tcp(moment_of_inertia=MomentOfInertia(0, 0, HEAVIEST_INERTIA)),
                     tcp(-FAR, FAR), tcp(mass_center=Transformation(-FAR, FAR, 0, 0, 0, 0))):
            with self.subTest(str(goal).replace("\n", " ")):
                self.assert_done(self.robot.run(goal))


if __name__ == "__main__":
    import rostest

    rospy.init_node("change_tcp_test")
    rostest.rosrun("cobot_command", "change_tcp", ChangeTcp)
