#!/usr/bin/env python3
"""How the interface behaves while an exchange_configuration goal lives, on the wire and for clients."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ExchangeConfigurationGoal, ExchangeParCmd, FrameTrace, GroupState
from cobot_command.srv import UpdateConfiguration
from cobot_goals import BUFFERED, turn, with_changes
from cobot_test import CobotTestCase


def exchange(**changes):
    settings = {"log_level": ExchangeParCmd.LOG_INFO, "life_sign_time_out": 300}
    goal = {name: changes.pop(name) for name in ("name", "exec_mode", "priority") if name in changes}
    return with_changes(ExchangeConfigurationGoal(exec_mode=ExchangeConfigurationGoal.PARALLEL,
                                                  par_cmd=with_changes(ExchangeParCmd(**settings), changes)), goal)


class Frames:
    """All that went over the wire since."""

    def __init__(self):
        self.texts = []
        self._subscriber = rospy.Subscriber("frames", FrameTrace, self._take, queue_size=1000)

    def _take(self, frame):
        self.texts.append((frame.sent, frame.text))

    def sent(self, words):
        return [text for sent, text in self.texts if sent and words in text]


class ExchangeConfiguration(CobotTestCase):
    def enable(self, **changes):
        sent = self.robot.send(exchange(**changes))
        sent.wait_for_feedback(lambda f: f.enabled, "an enabled interface")
        return sent

    def update(self, **changes):
        return rospy.ServiceProxy("update_configuration", UpdateConfiguration)(exchange(**changes).par_cmd)

    def test_is_enabled_until_it_is_cancelled(self):
        self.robot.establish()
        sent = self.enable(name="main", priority=3)
        told = sent.feedback[-1]
        self.assertTrue(told.command_buffered and told.parameter_accepted and not told.busy)
        out = told.out_cmd
        self.assertEqual((out.length_acr, out.highest_tool_index, out.highest_frame_index, out.highest_load_index,
                          out.highest_work_area_index), (65, 15, 15, 15, 0))
        self.assertEqual((told.ri_state, told.par_seq, told.without_effect), (1, 1, ["priority"]))
        self.assertTrue(any("work areas" in name for name in told.unsupported), told.unsupported)
        sent.cancel()
        state, result = sent.finish()
        self.assertEqual((state, result.error_id), (GoalStatus.SUCCEEDED, 0))
        self.assertTrue(any(f.busy for f in sent.feedback))

    def test_is_seen_in_the_state_of_the_group(self):
        group = self.robot.latest("group_state", GroupState)
        self.establish_at_home()
        group.wait_for(lambda s: s.enabled and s.sequence == GroupState.IDLE and s.motion_state_known, "an idle robot")
        sent = self.enable()
        self.assertTrue(sent.feedback[-1].out_cmd.accelerating_supported)
        group.wait_for(lambda s: s.ri_state == GroupState.RI_INITIALIZED, "the state of the interface")
        move = self.robot.start_slowly()
        group.wait_for(lambda s: s.sequence == GroupState.EXECUTING and s.constant_velocity, "a robot that moves evenly")
        self.robot.operate("pause_project")
        group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED and s.in_primary_position, "an interrupted robot")
        self.robot.operate("resume_project")
        group.wait_for(lambda s: s.sequence == GroupState.EXECUTING, "a robot that goes on")
        move.cancel()
        move.finish()

    def test_refuses_what_is_out_of_its_range(self):
        self.robot.establish()
        self.assert_refuses([
            (exchange(name="a" * 21), 8, "21 bytes"),
            (exchange(exec_mode=18), 0x8F10, "18"),
            (exchange(log_level=6), 0x8D18, "6"),
            (exchange(wait_for_nr_of_cmd=65), 0x8D39, "65"),
            (exchange(life_sign_time_out=9), 0x8D14, "9 ms"),
            (exchange(sync_reaction=4), 0x8D33, "4"),
            (exchange(wait_at_blending_zone=True), 0x8E21, "true")])

    def test_is_there_once(self):
        self.robot.establish()
        first = self.enable()
        self.assert_refuses([(exchange(), 0x8F12, "one instance")])
        self.assertFalse(first.ended())

    def test_takes_other_settings(self):
        self.robot.establish()
        sent = self.enable()
        self.assertTrue(self.update(life_sign_time_out=400).success)
        sent.wait_for_feedback(lambda f: f.par_seq == 2 and f.parameter_accepted, "the settings")
        answer = self.update(life_sign_time_out=9)
        self.assertEqual((answer.success, answer.error_id), (False, 0x8D14))
        self.assertIn("9 ms", answer.message)
        sent.cancel()
        sent.finish()
        self.assertEqual(self.update().error_id, 0x8612)

    def test_waits_for_a_link_for_five_seconds(self):
        self.robot.close()
        outcome = self.robot.run(exchange())
        self.assert_aborted(outcome, 6)
        result = outcome[1]
        self.assertEqual((result.error_id_enum, result.error_add_txt), ("TIMEOUT_CMD", "_stepCmd = 2"))

    def test_ends_with_a_controller_that_says_nothing_any_more(self):
        self.establish_at_home()
        sent = self.enable()
        frames = Frames()
        move = self.robot.start_slowly()
        self.robot.fault("silence")
        self.assert_aborted(sent.finish(), 0x80A5, "does not stop automatically")
        self.assertEqual(move.finish()[1].error_id, 0x99)
        self.assertTrue(frames.sent("StopAndClearBuffer"), frames.texts[-5:])

    def test_ends_with_the_connection(self):
        self.robot.establish()
        sent = self.enable()
        self.robot.operate("drop_connections")
        outcome = sent.finish()
        self.assert_aborted(outcome, 0x8AAD)
        self.assertEqual(outcome[1].error_id_enum, "CONNECTION_LOST")

    def test_lets_the_first_motion_wait_for_the_next(self):
        self.establish_at_home()
        self.enable(delay_time=20000, wait_for_nr_of_cmd=2)
        first = self.robot.send(turn(5, 0, 0, 0, 0, 0, buffer_mode=BUFFERED))
        first.wait_for_feedback(lambda f: f.text == "waits for the next motion", "the hold")
        second = self.robot.send(turn(-5, 0, 0, 0, 0, 0, buffer_mode=BUFFERED))
        self.assert_done(first.finish())
        self.assert_done(second.finish())


if __name__ == "__main__":
    import rostest

    rospy.init_node("exchange_configuration_test")
    rostest.rosrun("cobot_command", "exchange_configuration", ExchangeConfiguration)
