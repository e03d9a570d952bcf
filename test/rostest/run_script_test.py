#!/usr/bin/env python3
"""The run_script action against a simulated controller over real sockets."""
import rospy

from cobot_command.msg import RunScriptGoal
from cobot_goals import ABORTING, move_script, script
from motion_checks import MotionTestCase

LONGEST = 4096


def of_length(length):
    """Lines that the controller takes, together so many bytes."""
    line = "ChangeLoad(1)"
    count, rest = divmod(length, len(line) + 1)
    text = "\n".join([line] * count)
    return script(text + " " * (length - len(text)))


class RunScript(MotionTestCase):
    # --- Done.
    def test_is_done_when_its_motions_are_done_if_that_is_awaited(self):
        result = self.assert_done(self.robot.run(move_script()))
        self.assertIn(result.command_id_ack, range(1, 16))
        self.assert_stands_at((60, -20, 100, 10, 80, -45))

    def test_is_done_on_acceptance_if_not(self):
        result = self.assert_done(self.robot.run(move_script(5, await_motion=False)))
        self.assertEqual(result.command_id_ack, 0)
        self.robot.wait_for_motion()
        self.assert_done(self.robot.run(script("ChangeLoad(1)", buffer_mode=ABORTING)))
        self.robot.wait_for_standstill()

    def test_takes_lines_apart_by_lf_or_cr_lf(self):
        for separator in ("\n", "\r\n", "\n\n"):
            with self.subTest(repr(separator)):
                self.assert_done(self.robot.run(RunScriptGoal(script=separator.join(["ChangeLoad(1)"] * 3))))

    def test_leaves_the_listen_node_by_a_script_exit_at_its_end(self):
        goal = script('PTP("JPP",5,0,90,0,90,0,50,200,0,false)', "ScriptExit()", await_motion=True)
        self.assert_done(self.robot.run_and_reenter(goal))
        self.assert_stands_at((5, 0, 90, 0, 90, 0))

    def test_is_aborted_with_the_text_of_the_lines_that_the_controller_refuses(self):
        self.assert_aborted(self.robot.run(script("ChangeLoad(1)", "Dance()")), 0x80, "line 2: Dance()")

    # --- Ended or held from outside.
    def test_is_held_by_a_pause_and_stopped_by_a_cancel(self):
        self.assert_is_held_by_a_pause(move_script(5))

    def test_is_held_behind_a_motion_that_a_script_has_paused(self):
        self.assert_done(self.robot.run(script("Pause()", *move_script(5, await_motion=False).script.split("\n"))))
        sent = self.robot.send(script('PTP("JPP",5,0,90,0,90,0,50,200,0,false)', await_motion=True))
        held = sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.assertIn("the project is paused: program_control with RESUME", held.text)
        self.robot.operate("resume_project")
        self.assert_done(sent.finish())
        self.assert_stands_at((5, 0, 90, 0, 90, 0))

    def test_is_done_wherever_its_own_stop_leaves_the_robot(self):
        self.assert_done(self.robot.run(script(move_script(5).script, "StopAndClearBuffer()", await_motion=True)))

    # --- Inputs.
    def test_refuses_scripts_that_it_must_not_send(self):
        self.assert_refuses([
            (script(""), 0x21E, "empty"), (script(" ", "\t", ""), 0x21E, "empty"),
            (of_length(LONGEST + 1), 0x21E, "4097"),
            (script("ChangeLoad(1)", "a\x07b"), 0x21E, "line 2"), (script("QueueTag(1)"), 0x21E, "QueueTag"),
            (script("x = 1 // waitqueuetag"), 0x21E, "WaitQueueTag"),
            (script("ScriptExit()", "ChangeLoad(1)"), 0x21E, "never run")])

    def test_refuses_times_for_the_answer_outside_their_range(self):
        nan = float("nan")
        self.assert_refuses((script("ChangeLoad(1)", reply_timeout=v), 0x260, "") for v in (-1, 0.049, 3600.1, nan))

    def test_takes_both_ends_of_every_range(self):
        for goal in (script("ChangeLoad(1)", reply_timeout=0), script("ChangeLoad(1)", reply_timeout=3600),
                     of_length(LONGEST)):
            self.assert_done(self.robot.run(goal))
        self.robot.fault("ignore_script", count=1)
        self.assert_aborted(self.robot.run(script("ChangeLoad(1)", reply_timeout=0.05)), 0x70, "0.05 s")

    def test_refuses_a_goal_that_is_empty(self):
        self.assert_rejected(self.robot.run(RunScriptGoal()), 0x21E)


if __name__ == "__main__":
    import rostest

    rospy.init_node("run_script_test")
    rostest.rosrun("cobot_command", "run_script", RunScript)
