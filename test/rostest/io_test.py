#!/usr/bin/env python3
"""The actions set_output, wait_for_input, wait_time and change_load, and the topic digital_io, against a simulated
controller over real sockets."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ChangeLoadGoal, DigitalIo, ProgramControlGoal, SetOutputGoal, StopGoal
from cobot_goals import ABORTING, BUFFERED, HOME, MODERATELY, cycle, output, pause, step, to_joints, turn, wait_for
from motion_checks import MotionTestCase


def analog(value, module="ControlBox", **changes):
    return output(0, value, module=module, kind=SetOutputGoal.ANALOG, **changes)


class Io(MotionTestCase):
    def setUp(self):
        super().setUp()
        self.robot.operate("set_input", "ControlBox", 0, False)
        self.levels = self.robot.latest("digital_io", DigitalIo)

    def test_sets_outputs_in_their_turn_and_at_once(self):
        for goal in (output(), output(3, 0), output(15, module="ControlBox"), output(at_once=True), analog(-2.5),
                     analog(10, at_once=True)):
            with self.subTest(goal):
                self.assert_done(self.robot.run(goal))

    def test_sets_an_output_at_once_while_the_robot_moves(self):
        moving = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        self.assert_done(self.robot.run(output(at_once=True)))
        self.assertEqual(moving.state(), GoalStatus.ACTIVE)
        self.assert_rejected(self.robot.run(output()), 0x11, "move_relative")
        moving.cancel()
        moving.finish()

    def test_waits_for_an_input_and_holds_back_what_comes_behind(self):
        waiting = self.robot.send(wait_for()).wait_until_active()
        behind = self.robot.send(to_joints(*HOME, buffer_mode=BUFFERED)).wait_until_queued()
        self.assertFalse(waiting.ended())
        self.robot.operate("set_input", "ControlBox", 0, True)
        self.assert_done(waiting.finish())
        self.assert_done(behind.finish())

    def test_gives_up_an_input_that_does_not_come(self):
        waiting = self.robot.send(wait_for(timeout=0.2)).wait_until_active()
        behind = self.robot.send(to_joints(*HOME, buffer_mode=BUFFERED))
        self.assert_aborted(waiting.finish(), 0x265, "input 0 of ControlBox was off for 0.2 s")
        state, _ = behind.finish()
        self.assertEqual(state, GoalStatus.RECALLED)

    def test_names_an_input_that_the_controller_does_not_stream(self):
        self.assert_aborted(self.robot.run(wait_for(15)), 0x266, "input 15 of ControlBox")

    def test_ends_a_wait_that_is_cancelled(self):
        waiting = self.robot.send(wait_for(timeout=0)).wait_until_active()
        waiting.cancel()
        state, result = waiting.finish()
        self.assertEqual(state, GoalStatus.PREEMPTED, result.error_description)

    def test_waits_for_a_time_at_its_turn_between_two_moves(self):
        # Goals of two actions arrive in any order; and this one lasts until both others have arrived.
        before = self.robot.send(turn(10, 0, 0, 0, 0, 0, speed=3)).wait_until_active()
        waiting = self.robot.send(pause(1.0, buffer_mode=BUFFERED)).wait_until_queued()
        behind = self.robot.send(to_joints(*HOME, buffer_mode=BUFFERED)).wait_until_queued()
        running = waiting.wait_for_feedback(lambda f: f.phase == f.ACTIVE, "the turn of the wait")
        self.assert_done(before.finish())
        self.assertFalse(behind.ended())
        self.assertEqual((running.place_in_queue, running.remaining.to_sec()), (0, 1.0))
        self.assertAlmostEqual(self.assert_done(waiting.finish()).actual_duration.to_sec(), 1.0, delta=0.1)
        self.assert_done(behind.finish())
        left = [f.remaining for f in waiting.feedback if f.phase == f.ACTIVE]
        self.assertGreater(len(left), 3)
        self.assertEqual(left, sorted(left, reverse=True))

    def test_begins_a_time_when_the_blended_motion_in_front_has_come_to_its_end(self):
        self.assert_done(self.robot.run(turn(10, 0, 0, 0, 0, 0, blending_enable=True, **MODERATELY)))
        waiting = self.robot.send(pause(0.2)).wait_until_queued()
        self.assertIn("until the robot is at standstill", waiting.feedback[0].text)
        self.assert_done(waiting.finish())
        self.assert_stands_at((10, *HOME[1:]))
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_ends_a_time_that_is_cancelled_stopped_or_taken_over_and_what_waits_behind_it(self):
        for end in ("cancel", StopGoal(), pause(0, buffer_mode=ABORTING)):
            with self.subTest(end):
                waiting = self.robot.send(pause(60)).wait_until_active()
                behind = self.robot.send(to_joints(*HOME, buffer_mode=BUFFERED)).wait_until_queued()
                if end == "cancel":
                    waiting.cancel()
                else:
                    self.assert_done(self.robot.run(end))
                state, result = waiting.finish()
                self.assertEqual(state, GoalStatus.PREEMPTED, result.error_description)
                self.assertIn("while it waited for 60 s", result.error_description)
                self.assertEqual(behind.finish()[0], GoalStatus.RECALLED)

    def test_holds_a_time_while_the_project_is_paused(self):
        waiting = self.robot.send(pause(3.0)).wait_until_active()
        self.assert_done(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.PAUSE)))
        held = waiting.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.robot.wait_for_time_to_pass(1.0)
        self.assertFalse(waiting.ended())
        self.assertGreater(held.remaining.to_sec(), 0)
        self.assert_done(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.RESUME)))
        self.assertGreater(self.assert_done(waiting.finish()).actual_duration.to_sec(), 4.0)

    def test_does_a_cycle_with_the_switch_of_a_gripper(self):
        grip = cycle(step(to_joints(*HOME), awaited=wait_for(timeout=10)), cycles=1)
        sent = self.robot.send(grip)
        sent.wait_for_feedback(lambda f: "waits for input 0" in f.text, "the wait")
        self.robot.operate("set_input", "ControlBox", 0, True)
        self.assert_done(sent.finish())

    def test_ends_a_cycle_whose_switch_does_not_come(self):
        outcome = self.robot.run(cycle(step(to_joints(*HOME), awaited=wait_for(timeout=0.1))))
        self.assert_aborted(outcome, 0x252)
        result = outcome[1]
        self.assertEqual((result.failed_step, result.step_error_id), (0, 0x265))

    def test_shows_the_outputs_that_it_has_set(self):
        for level, shown in ((1, DigitalIo.ON), (0, DigitalIo.OFF)):
            self.assert_done(self.robot.run(output(3, level)))
            self.levels.wait_for(lambda m: m.end_module_outputs[3] == shown, "the output of the end module")
            self.assert_done(self.robot.run(output(7, level, module="ControlBox", at_once=True)))
            self.levels.wait_for(lambda m: m.control_box_outputs[7] == shown, "the output of the control box")

    def test_shows_the_inputs_that_the_world_sets(self):
        for on, shown in ((True, DigitalIo.ON), (False, DigitalIo.OFF)):
            self.robot.operate("set_input", "ControlBox", 7, on)
            self.robot.operate("set_input", "EndModule", 2, on)
            self.levels.wait_for(lambda m: m.control_box_inputs[7] == m.end_module_inputs[2] == shown, "both inputs")

    def test_shows_levels_when_they_change_and_only_those_that_are_streamed(self):
        levels = self.levels.wait_for(lambda m: m.control_box_inputs[0] == DigitalIo.OFF, "the levels")
        self.assertEqual(levels.control_box_inputs[8:], 8 * (DigitalIo.UNKNOWN,))
        self.assertEqual(levels.end_module_inputs[3], DigitalIo.UNKNOWN)
        self.robot.wait_for_time_to_pass(0.2)
        self.levels.forget()
        self.robot.wait_for_time_to_pass(0.2)
        self.robot.operate("set_input", "ControlBox", 0, True)
        self.levels.wait_for(lambda m: m.control_box_inputs[0] == DigitalIo.ON, "the input")
        self.assertEqual(len(self.levels.all()), 1)

    def test_does_not_know_levels_without_a_stream(self):
        self.levels.wait_for(lambda m: m.control_box_inputs[0] == DigitalIo.OFF, "the levels")
        self.robot.close()
        self.levels.wait_for(lambda m: set(m.control_box_inputs + m.control_box_outputs) == {DigitalIo.UNKNOWN},
                             "no levels without a stream")
        self.robot.establish()
        self.levels.wait_for(lambda m: m.control_box_inputs[0] == DigitalIo.OFF, "the levels again")

    def test_changes_the_load(self):
        for weight in (0, 1.5, 0):
            self.assert_done(self.robot.run(ChangeLoadGoal(weight=weight)))

    def test_refuses_what_there_is_not(self):
        self.assert_refuses([
            (output(4), 0x255, "output 4"), (output(module="Gripper"), 0x255, "'Gripper'"),
            (analog(1, module="EndModule"), 0x255, "allowed: 0 of ControlBox"), (output(0, 2), 0x262, "value is 2"),
            (analog(10.5), 0x262, "10.5 V"), (output(kind=2), 0x262, "kind is 2"), (wait_for(16), 0x263, "input 16"),
            (wait_for(timeout=-1), 0x264, "-1 s"), (pause(-1), 0x8D34, "-1 s"), (pause(86401), 0x8D34, "86401 s"),
            (ChangeLoadGoal(weight=14.1), 0x261, "14.1"),
            (cycle(step(to_joints(*HOME), awaited=wait_for(16))), 0x263, "step 1"),
            (cycle(step(to_joints(*HOME), awaited=wait_for(timeout=1e6))), 0x264, "step 1")])


if __name__ == "__main__":
    import rostest

    rospy.init_node("io_test")
    rostest.rosrun("cobot_command", "io", Io)
