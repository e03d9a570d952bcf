#!/usr/bin/env python3
"""The pick_and_place action against a simulated controller over real sockets."""
import pathlib
import tempfile

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import OutputAction, PickAndPlaceGoal, RobotStatus
from cobot_command.srv import FinishRequest
from cobot_goals import BUFFERED, HOME, MODERATELY, SLOWLY, cycle, step, to_joints, turn
from motion_checks import MotionTestCase

FILE = "package://cobot_command/config/pick_and_place.yaml"
GRIP, RELEASE = (OutputAction("EndModule", 0, value) for value in (True, False))
A, B = (to_joints(15, 0, 90, 0, 90, 0), to_joints(-15, 0, 90, 0, 90, 0))


class PickAndPlace(MotionTestCase):
    # --- Done.
    def test_runs_all_steps_of_all_cycles(self):
        result = self.assert_done(self.robot.run(cycle(step(A, GRIP), step(B, RELEASE, 0.1), cycles=2)))
        self.assertEqual((result.cycles_done, result.failed_step, len(result.steps)), (2, -1, 2))
        self.assertGreater(result.actual_duration.to_sec(), 0.2)
        self.assertGreater(result.planned_duration.to_sec(), 0.2)
        self.assert_stands_at((-15, 0, 90, 0, 90, 0))

    def test_tells_step_cycle_and_phase(self):
        sent = self.robot.send(cycle(step(A, GRIP, 0.1), step(B), cycles=2))
        self.assert_done(sent.finish())
        places = [(f.cycle, f.step) for f in sent.feedback if f.step >= 0]
        self.assertEqual(sorted(set(places)), [(1, 0), (1, 1), (2, 0), (2, 1)])
        self.assertEqual(places, sorted(places))
        self.assertTrue({f.ACTIVE for f in sent.feedback} <= {f.phase for f in sent.feedback})
        dwell = sent.wait_for_feedback(lambda f: f.phase == f.DWELLING, "DWELLING")
        self.assertIn("0.1 s", dwell.text)

    def test_reads_the_steps_of_the_thesis_from_its_file(self):
        result = self.assert_done(self.robot.run(PickAndPlaceGoal(steps_file=FILE, cycles=1, check_only=True)))
        self.assertEqual(len([report for report in result.steps if report.joint_path.points]) >= 6, True)
        self.assertGreater(result.planned_duration.to_sec(), 1)
        longer = self.assert_done(self.robot.run(PickAndPlaceGoal(steps_file=FILE, cycles=5, check_only=True)))
        self.assertEqual(longer.planned_duration, result.planned_duration, "it is that of one cycle")

    def test_runs_until_it_is_cancelled(self):
        sent = self.robot.send(cycle(step(A), step(B), cycles=0))
        sent.wait_for_feedback(lambda f: f.cycle == 3, "the third cycle")
        sent.cancel()
        outcome = sent.finish()
        self.assert_ended(GoalStatus.PREEMPTED, outcome)
        self.assertGreaterEqual(outcome[1].cycles_done, 2)
        self.robot.wait_for_standstill()

    def test_can_be_cancelled_while_it_dwells(self):
        sent = self.robot.send(cycle(step(A, dwell=3600), step(B)))
        sent.wait_for_feedback(lambda f: f.phase == f.DWELLING, "DWELLING")
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.assert_stands_at((15, 0, 90, 0, 90, 0))

    # --- Ended in its own time.
    def test_ends_behind_its_cycle_on_request(self):
        sent = self.robot.send(cycle(step(A), step(B), cycles=0))
        sent.wait_for_feedback(lambda f: f.cycle == 2, "the second cycle")
        self.robot.finish(FinishRequest.CYCLE)
        result = self.assert_done(sent.finish())
        self.assertGreaterEqual(result.cycles_done, 2)
        self.assertIn("on request", sent.handle.get_goal_status_text())
        self.assert_stands_at((-15, 0, 90, 0, 90, 0))

    def test_ends_behind_its_move_on_request(self):
        sent = self.robot.start_slowly(cycle(step(turn_to(25), GRIP, 3600), step(B)))
        self.robot.finish(FinishRequest.MOVE)
        outcome = sent.finish()
        self.assert_ended(GoalStatus.PREEMPTED, outcome)
        self.assertEqual(outcome[1].cycles_done, 0)
        self.assert_stands_at((25, 0, 90, 0, 90, 0))

    def test_is_asked_to_end_behind_a_move_or_a_cycle_only(self):
        answer = self.robot.try_to_finish(2)
        self.assertFalse(answer.success)
        self.assertIn("after is 2", answer.message)

    def test_is_not_said_to_end_when_nothing_is_under_way(self):
        for after in (FinishRequest.MOVE, FinishRequest.CYCLE):
            answer = self.robot.try_to_finish(after)
            self.assertFalse(answer.success)
            self.assertEqual(answer.message, "nothing is running")

    def test_leaves_the_listen_node_behind_the_last_step_of_the_last_cycle(self):
        leaving = turn_to(-15)
        leaving.exit_node = True
        result = self.assert_done(self.robot.run_and_reenter(cycle(step(A), step(leaving), cycles=2)))
        self.assertEqual(result.cycles_done, 2)
        self.assert_stands_at((-15, 0, 90, 0, 90, 0))

    def test_refuses_to_leave_the_listen_node_earlier(self):
        leaving = to_joints(15, 0, 90, 0, 90, 0, exit_node=True)
        self.assert_refuses([(cycle(step(leaving), step(B)), 0x259, "step 1 of 2"),
                             (cycle(step(A), step(leaving), cycles=0), 0x259, "cycles is 0"),
                             (cycle(step(leaving, GRIP)), 0x259, "output")])

    def test_waits_for_its_turn(self):
        busy = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        sent = self.robot.send(cycle(step(A), buffer_mode=BUFFERED)).wait_until_queued()
        self.assert_done(busy.finish())
        self.assert_done(sent.finish())

    # --- Held, or ended from outside.
    def test_is_held_by_a_pause_in_motion_and_goes_on(self):
        sent = self.robot.start_slowly(cycle(step(turn_to(25)), step(B)))
        self.robot.operate("pause_project")
        sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.robot.operate("resume_project")
        self.assert_done(sent.finish())

    def test_is_held_by_a_pause_while_it_dwells(self):
        sent = self.robot.send(cycle(step(A, dwell=0.5), step(B)))
        sent.wait_for_feedback(lambda f: f.phase == f.DWELLING, "DWELLING")
        self.robot.operate("pause_project")
        self.robot.robot_status.wait_for(lambda s: s.project_paused == RobotStatus.TRUE, "the pause")
        self.robot.wait_for_time_to_pass(1.0)  # longer than the dwell
        self.assertEqual([f.step for f in sent.feedback if f.step == 1], [])
        self.robot.operate("resume_project")
        self.assert_done(sent.finish())

    def test_is_aborted_by_an_emergency_stop_and_does_not_resume(self):
        sent = self.robot.start_slowly(cycle(step(to_joints(60, 0, 90, 0, 90, 0, **SLOWLY)), step(B)))
        self.robot.operate("set_emergency_stop", True)
        self.assert_aborted(sent.finish(), 0x99)
        self.robot.reset()
        self.robot.establish()
        self.robot.wait_for_standstill()

    # --- What fails in a cycle.
    def test_fails_with_the_step_and_its_error(self):
        self.robot.fault("refuse_script", count=1)
        state, result = outcome = self.robot.run(cycle(step(A), step(B)))
        self.assert_aborted(outcome, 0x252, "step 1 of 2")
        self.assertEqual((result.failed_step, result.step_error_id, result.cycles_done), (0, 0x80, 0))
        self.assertIn("line 1", result.step_error_description)

    def test_fails_when_an_output_is_not_set(self):
        sent = self.robot.start_slowly(cycle(step(turn_to(25), GRIP)))
        self.robot.fault("refuse_script", count=1)
        self.assert_aborted(sent.finish(), 0x257, "output")

    # --- Inputs.
    def test_refuses_steps_that_cannot_be_read(self):
        rows = [(PickAndPlaceGoal(steps_file="/no/such/file.yaml", cycles=1), 0x256, "no/such"),
                (PickAndPlaceGoal(steps_file="package://no_such_package/a.yaml", cycles=1), 0x256, "no_such_package' is not found"),
                *((PickAndPlaceGoal(steps_file=path, cycles=1), 0x256, words) for path, words in
                  (("/proc/self/mem", "cannot be read"), ("/dev/zero", "a device"), ("/tmp", "a folder")))]
        with tempfile.TemporaryDirectory() as folder:
            for name, text, words in (("broken", "steps: [", "broken"), ("unknown", "dance: 1\nsteps: []", "unknown.yaml:1: unknown key in the file"),
                                      ("missing", "steps: [{movement_command: PTP}]", "missing.yaml")):
                file = pathlib.Path(folder) / f"{name}.yaml"
                file.write_text(text, encoding="utf-8")
                rows.append((PickAndPlaceGoal(steps_file=str(file), cycles=1), 0x256, words))
            self.assert_refuses(rows)

    def test_refuses_inputs_outside_their_range(self):
        nan = float("nan")
        self.assert_refuses([
            (cycle(), 0x250, "0 steps"), (cycle(*[step(A)] * 51), 0x250, "51 steps"),
            (cycle(step(A), step(to_joints(*HOME, speed=0))), 0x251, "step 2"),
            (cycle(step(A), step(to_joints(0, 0, 156, 0, 90, 0))), 0x251, "step 2"),
            *((cycle(step(A, dwell=v)), 0x253, "") for v in (-0.1, 3600.1, nan)),
            *((cycle(step(A), cycles=v), 0x254, "") for v in (-1, 1000001)),
            *((cycle(step(A, OutputAction(*v, True))), 0x255, "") for v in
              (("EndModule", -1), ("EndModule", 4), ("ControlBox", 16), ("ControlBox", -1), ("ExtModule", 0))),
            *((cycle(step(to_joints(*HOME, blending_enable=True), *v), step(A)), 0x258, "")
              for v in ((GRIP,), (None, 1.0)))])

    def test_takes_both_ends_of_every_range(self):
        for goal in (cycle(*[step(A)] * 50), cycle(step(A, dwell=3600)), cycle(step(A), cycles=0),
                     cycle(step(A), cycles=1000000), cycle(step(A, OutputAction("EndModule", 3, False))),
                     *(cycle(step(A, OutputAction("ControlBox", v, True))) for v in (0, 15))):
            goal.check_only = True
            with self.subTest(steps=len(goal.steps), cycles=goal.cycles):
                self.assert_done(self.robot.run(goal))


def turn_to(degrees):
    return to_joints(degrees, 0, 90, 0, 90, 0, **MODERATELY)


if __name__ == "__main__":
    import rostest

    rospy.init_node("pick_and_place_test")
    rostest.rosrun("cobot_command", "pick_and_place", PickAndPlace)
