"""Where the arm is, by the truth of the simulator and by what the command layer says of it."""
import math

from actionlib_msgs.msg import GoalStatus

from cobot_test import CobotTestCase

AS_REPORTED = 0.1  # [mm, deg]; a result tells where the stream showed the arm behind its tag


class MotionTestCase(CobotTestCase):
    """Each test starts connected, with the arm at HOME."""

    def setUp(self):
        super().setUp()
        self.establish_at_home()

    def assert_stands_at(self, degrees, streamed=True):
        """Without a link there is no stream of it."""
        wanted = [math.radians(value) for value in degrees]
        for joints in (self.robot.true_joints, self.robot.joints) if streamed else (self.robot.true_joints,):
            joints.wait_for(lambda m: max(abs(a - b) for a, b in zip(m.position, wanted)) < 1e-5
                            and max(abs(v) for v in m.velocity) < 1e-6, f"the arm at {degrees}")

    def assert_moved(self, before, after, offset):
        """Two results of motions lie this far apart [mm, deg]."""
        for name, difference in zip(("x", "y", "z", "rx", "ry", "rz"), offset):
            found = getattr(after.final_pose, name) - getattr(before.final_pose, name)
            if name.startswith("r"):
                found = (found - difference + 180) % 360 - 180 + difference
            self.assertAlmostEqual(found, difference, delta=AS_REPORTED, msg=name)

    def assert_result_is_true(self, result, tag=None):
        """Its joints are those of the simulator, its times are positive, and its tag is one of the layer's."""
        self.robot.wait_for_standstill()
        true = [math.degrees(p) for p in self.robot.true_joints.message.position]
        for found, wanted in zip(result.final_joints, true):
            self.assertAlmostEqual(found, wanted, delta=AS_REPORTED)
        self.assertGreater(result.planned_duration.to_sec(), 0)
        self.assertGreater(result.actual_duration.to_sec(), 0)
        self.assertIn(result.command_id_ack, [tag] if tag else range(1, 16))

    def assert_feedback_goes_on(self, goal):
        """The feedback of a motion that is carried out to its end."""
        sent = self.robot.send(goal)
        self.assert_done(sent.finish())
        active = [f for f in sent.feedback if f.phase == f.ACTIVE]
        self.assertEqual(sent.feedback[0].phase, sent.feedback[0].SENT)
        self.assertGreater(len(active), 3)
        self.assertEqual([f.progress for f in active], sorted(f.progress for f in active))
        self.assertEqual([f.remaining for f in active], sorted((f.remaining for f in active), reverse=True))
        self.assertGreater(active[-1].progress, active[0].progress)
        self.assertTrue(all(f.planned_duration == active[0].planned_duration and f.place_in_queue == 0 for f in active))
        self.assertGreater(active[0].planned_duration.to_sec(), 0)
        self.assertIn(active[0].command_id_ack, range(1, 16))

    def assert_is_held_by_a_pause(self, goal):
        sent = self.robot.start_slowly(goal)
        self.robot.operate("pause_project")
        held = sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.assertIn("paused", held.text)
        told = len(sent.feedback)
        self.robot.operate("resume_project")
        sent.wait_for_feedback(lambda f: f.phase == f.ACTIVE, "ACTIVE again", told)
        self.assertEqual(sent.state(), GoalStatus.ACTIVE)
        self.assert_can_be_cancelled(sent)

    def assert_can_be_cancelled(self, sent):
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        stopping = [f for f in sent.feedback if f.phase == f.STOPPING]
        self.assertTrue(stopping)
        self.robot.wait_for_standstill()
