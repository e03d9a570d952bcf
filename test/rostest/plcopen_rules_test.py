#!/usr/bin/env python3
"""The watch of the load test finds what breaks a rule: each is broken here once. Needs no master."""
import unittest

import rospy
from actionlib_msgs.msg import GoalStatus

import plcopen_goals
from cobot_command.msg import (BlockStatus, CommandStatus, LoadPathGoal, MoveAbsoluteFeedback, MoveAbsoluteResult, StopGoal,
                               StopResult)
from cobot_goals import HOME, to_joints
from load_clients import BLOCKS
from load_watch import Record
from plcopen_status import StatusRules
from random_goals import Drawn, RandomGoals

TABLE = {("move_absolute", 0x11), ("move_absolute", 0x28), ("stop", 0x225)}
ERROR = {"error": True, "error_id": 0x11, "error_description": "another is busy"}


def status(seq=1, link_state=CommandStatus.READY, late_replies=0, commands=(0, 0), tags=(), waiting_return=None,
           **blocks):
    """Of the given blocks: {output: value}."""
    message = CommandStatus(link_state=link_state, late_replies=late_replies, open_tags=list(tags))
    message.header.seq = seq
    message.commands_under_way, message.commands_waiting = commands
    message.queue_depth = sum(commands)
    busy_stop = blocks.get("stop", {}).get("busy", False)
    message.waiting_return = sum(commands) > 0 or busy_stop if waiting_return is None else waiting_return
    message.blocks = [BlockStatus(block=name, **blocks.get(name, {})) for name in BLOCKS]
    return message


class StatusRulesTest(unittest.TestCase):
    def assert_found(self, words, *messages):
        rules = StatusRules(TABLE)
        found = [rules.check(m) for m in messages]
        self.assertEqual([f for f in found[:-1] if f], [], "only the last one breaks a rule")
        if words:
            self.assertTrue(any(words in fault for fault in found[-1]), found[-1])
        else:
            self.assertEqual(found[-1], [])

    def test_takes_what_holds_all_rules(self):
        self.assert_found("", status(), status(2, move_absolute={"busy": True, "active": True}, commands=(1, 2)),
                          status(3, move_absolute=ERROR), status(4, move_absolute=ERROR, stop={"busy": True}))

    def test_finds_outputs_that_exclude_each_other(self):
        self.assert_found("R1", status(commands=(1, 0), move_absolute={"busy": True, "done": True}))
        self.assert_found("R2", status(move_absolute={"done": True, "active": True}))
        self.assert_found("R2", status(move_absolute={"active": True}))

    def test_finds_outputs_that_were_reset_without_another_execution(self):
        self.assert_found("R3", status(move_absolute=ERROR), status(2))
        self.assert_found("R3", status(move_absolute={"done": True}), status(2))

    def test_finds_errors_that_are_none_or_of_another_block(self):
        self.assert_found("error_id", status(move_absolute={**ERROR, "error_id": 0}))
        self.assert_found("error_id", status(move_absolute={"done": True, "error_description": "why"}))
        self.assert_found("table", status(move_absolute={**ERROR, "error_id": 0x225}))

    def test_finds_more_than_one_robot_could_do(self):
        self.assert_found("R9", status(commands=(1, 1), move_absolute={"busy": True, "active": True},
                                       move_circle={"busy": True, "active": True}))
        self.assert_found("R9", status(commands=(1, 0), stop={"busy": True},
                                       move_circle={"busy": True, "active": True}))
        self.assert_found("under way", status(commands=(2, 0), move_circle={"busy": True}))

    def test_finds_counts_that_do_not_agree_with_the_blocks(self):
        self.assert_found("R1", status(commands=(1, 0)))
        self.assert_found("R1", status(move_circle={"busy": True}))
        self.assert_found("waiting_return", status(commands=(1, 0), move_circle={"busy": True}, waiting_return=False))
        self.assert_found("open tags", status(tags=(3, 3)))
        self.assert_found("open tags", status(tags=(16,)))
        self.assert_found("fell", status(late_replies=2), status(2, late_replies=1))

    def test_finds_a_busy_block_without_a_connection(self):
        self.assert_found("without a connection", status(link_state=CommandStatus.DISCONNECTED, stop={"busy": True}))

    def test_judges_no_change_across_messages_that_were_lost(self):
        rules = StatusRules(TABLE)
        rules.check(status(1, late_replies=2))
        self.assertEqual(rules.check(status(5, late_replies=1)), [])
        self.assertEqual(rules.lost, 3)


def record(name, goal, begin, end, state, block="move_absolute", waits_since=None, errors=None, **result):
    """A goal that was with the controller from `begin` to `end` [s]; no begin: never."""
    made = Record(name, block, Drawn(goal, errors and frozenset(errors), False, None))
    made.sent = rospy.Time(0)
    if waits_since is not None:
        waiting = MoveAbsoluteFeedback(place_in_queue=1, phase=plcopen_goals.QUEUED)
        made.feedback.append((rospy.Time(waits_since), waiting))
    if begin is not None:
        made.accepted = rospy.Time(begin)
        made.feedback.append((rospy.Time(begin + 0.1), MoveAbsoluteFeedback()))
    kind = MoveAbsoluteResult if block == "move_absolute" else StopResult
    made.results.append((rospy.Time(end), state, kind(**result)))
    return made


FAILED = {"error_id": 0x11, "error_description": "why", "remedy": "what"}


class GoalRulesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.rostime.set_rostime_initialized(True)

    def assert_found(self, words, faults):
        faults = list(faults)
        self.assertTrue(any(words in fault for fault in faults) if words else not faults, faults)

    def test_takes_ends_that_hold_all_rules(self):
        for good in (record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED, final_joints=HOME),
                     record("b", to_joints(*HOME), None, 2, GoalStatus.REJECTED, **FAILED),
                     record("c", to_joints(*HOME, command_id=1), None, 2, GoalStatus.REJECTED, errors={0x28},
                            **{**FAILED, "error_id": 0x28})):
            self.assert_found("", plcopen_goals.faults_of(good, TABLE))

    def test_finds_a_success_that_is_elsewhere(self):
        for joints in ((), (1, *HOME[1:])):
            away = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED, final_joints=joints)
            self.assert_found("succeeded at", plcopen_goals.faults_of(away, TABLE))

    def test_takes_a_success_that_does_not_know_its_place_only_where_the_stream_breaks(self):
        blind = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED)
        self.assert_found("succeeded at", plcopen_goals.faults_of(blind, TABLE))
        self.assert_found("", plcopen_goals.faults_of(blind, TABLE, stream_breaks=True))
        away = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED, final_joints=(1, *HOME[1:]))
        self.assert_found("succeeded at", plcopen_goals.faults_of(away, TABLE, stream_breaks=True))

    def test_finds_ends_without_or_with_a_wrong_error(self):
        for words, state, result in (("error_id 0", GoalStatus.REJECTED, {}),
                                     ("error_id 17", GoalStatus.SUCCEEDED, FAILED),
                                     ("error_id 17", GoalStatus.PREEMPTED, FAILED),
                                     ("table", GoalStatus.ABORTED, {**FAILED, "error_id": 0x225}),
                                     ("remedy", GoalStatus.ABORTED, {**FAILED, "remedy": ""})):
            with self.subTest(words):
                ended = record("a", to_joints(*HOME), 1, 2, state, **result)
                self.assert_found(words, plcopen_goals.faults_of(ended, TABLE))

    def test_finds_wrong_goals_that_succeed_or_have_another_error(self):
        goal = to_joints(*HOME, speed=0)
        self.assert_found("cannot", plcopen_goals.faults_of(
            record("a", goal, 1, 2, GoalStatus.SUCCEEDED, errors={0x26}), TABLE))
        self.assert_found("0x26", plcopen_goals.faults_of(
            record("a", goal, None, 2, GoalStatus.REJECTED, errors={0x26}, **{**FAILED, "error_id": 0x28}), TABLE))

    def test_finds_another_command_id_in_the_result(self):
        self.assert_found("acknowledged", plcopen_goals.faults_of(
            record("a", to_joints(*HOME, command_id=7), 1, 2, GoalStatus.SUCCEEDED, command_id_ack=8), TABLE))

    def test_finds_two_commands_at_once(self):
        goal = to_joints(*HOME)
        first = record("a", goal, 1, 3, GoalStatus.SUCCEEDED)
        for words, begin in (("R9", 2), ("", 3)):
            second = record("b", goal, begin, 4, GoalStatus.SUCCEEDED)
            self.assert_found(words, plcopen_goals.Round([first, second], []).faults())

    def test_takes_paths_that_follow_each_other_for_one(self):
        first = record("a", LoadPathGoal(), 1, 3, GoalStatus.SUCCEEDED, "load_path")
        second = record("b", LoadPathGoal(), 2, 4, GoalStatus.SUCCEEDED, "load_path")
        self.assert_found("", plcopen_goals.Round([first, second], []).faults())

    def test_lets_a_path_wait_behind_others_of_its_kind_though_it_refuses_to(self):
        for goal, block, words in ((LoadPathGoal(), "load_path", ""), (to_joints(*HOME, buffer_mode=0), "move_absolute", "waits behind another goal")):
            with self.subTest(block=block):
                waits = record("a", goal, None, 4, GoalStatus.RECALLED, block, waits_since=1)
                waits.feedback[0][1].place_in_queue = 2
                self.assert_found(words, plcopen_goals.faults_of(waits, set()))

    def test_finds_goals_that_outlive_the_failure_in_front_of_them(self):
        goal = to_joints(*HOME)
        failed = record("a", goal, 1, 3, GoalStatus.ABORTED, **FAILED)
        self.assert_found("R10", plcopen_goals.Round(
            [failed, record("b", goal, 3, 4, GoalStatus.SUCCEEDED, waits_since=2)], []).faults())
        self.assert_found("", plcopen_goals.Round(
            [failed, record("b", goal, None, 3, GoalStatus.RECALLED, waits_since=2)], []).faults())

    def test_finds_ends_that_the_robot_does_not_know_of(self):
        at_home = tuple(0.017453292519943295 * d for d in HOME)
        elsewhere = (0.1, *at_home[1:])
        done = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED)
        stopped = record("s", StopGoal(), 1, 2, GoalStatus.SUCCEEDED, "stop")
        for words, ended, joints, velocity in (("", done, at_home, 0.0), ("not at", done, elsewhere, 0.0),
                                               ("moves", done, at_home, 0.1), ("moves", stopped, elsewhere, 0.1),
                                               ("", stopped, elsewhere, 0.0)):
            with self.subTest(words):
                truth = [(rospy.Time(t), joints, velocity) for t in (1, 3, 4)]
                whole = plcopen_goals.Round([ended], truth)
                self.assert_found(words, whole.faults())
                self.assertEqual(whole.compared, 1)

    def test_asks_the_robot_nothing_where_another_goal_has_moved_it_on(self):
        done = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED)
        behind = record("b", to_joints(*HOME), 2.5, 6, GoalStatus.SUCCEEDED)
        whole = plcopen_goals.Round([done, behind], [(rospy.Time(t), HOME, 1.0) for t in (1, 3, 4)])
        self.assert_found("", whole.faults())

    def test_knows_that_a_command_is_told_of_behind_its_script(self):
        done = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED)
        behind = record("b", to_joints(*HOME), 3.5, 6, GoalStatus.SUCCEEDED)
        for sent, words in ((1.5, ""), (3.2, "moves")):
            with self.subTest(sent=sent):
                behind.sent = rospy.Time(sent)
                whole = plcopen_goals.Round([done, behind], [(rospy.Time(t), HOME, 1.0) for t in (1, 2.5, 3)])
                self.assert_found(words, whole.faults())

    def test_finds_outputs_that_do_not_show_the_last_end(self):
        ended = record("a", to_joints(*HOME), 1, 2, GoalStatus.SUCCEEDED)
        self.assert_found("R4", plcopen_goals.shown_faults([ended], status(move_absolute=ERROR)))
        self.assert_found("", plcopen_goals.shown_faults([ended], status(move_absolute={"done": True})))
        for why in ("cancelled" + plcopen_goals.LOOKED_UP, *plcopen_goals.CANCELLED_EARLY):
            with self.subTest(why):
                early = record("b", to_joints(*HOME), None, 3, GoalStatus.RECALLED, error_description=why)
                self.assert_found("", plcopen_goals.shown_faults([ended, early], status(move_absolute={"done": True})))


class RandomGoalsTest(unittest.TestCase):
    def test_are_the_same_for_the_same_seed_and_of_every_action(self):
        one, same, other = RandomGoals("7"), RandomGoals("7"), RandomGoals("8")
        drawn = [one.draw() for _ in range(2000)]
        self.assertEqual(str(drawn), str([same.draw() for _ in range(2000)]))
        self.assertNotEqual(str(drawn[:50]), str([other.draw() for _ in range(50)]))
        self.assertEqual(len({type(d.goal) for d in drawn if d.errors is None}), len(BLOCKS), "good ones")
        self.assertEqual(len({type(d.goal) for d in drawn if d.errors is not None}), len(BLOCKS) - 1, "all but stop")


if __name__ == "__main__":
    unittest.main()
