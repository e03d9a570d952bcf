#!/usr/bin/env python3
"""What belongs to one goal is found, whatever id it was sent with. Needs no master."""
import itertools
import random
import unittest

from actionlib_msgs.msg import GoalID, GoalStatus

from bags import NODE
from flight import wholeness
from flight.pairing import pairs
from reading_test import BagTestCase


class Goals(BagTestCase):
    def goals_of(self, fill):
        def filled(maker):
            maker.joints(0)
            maker.question(0)
            fill(maker)

        self.run_made = self.made(filled)
        return self.run_made.goals

    def assert_whole(self):
        self.assertEqual(wholeness.faults(self.run_made), [])

    def test_a_goal_without_an_id_is_joined_with_the_id_that_the_server_gave_it(self):
        def fill(maker):
            maker.goal(1, "move_absolute", "", speed=50)
            maker.feedback(1.1, "move_absolute", f"{NODE}-1-17.5", given=1.001, progress=0.5)
            maker.result(2, "move_absolute", f"{NODE}-1-17.5", given=1.001)

        moved, = self.goals_of(fill)
        self.assertEqual((moved.identity, moved.message.speed, len(moved.feedback), moved.end.status),
                         (f"{NODE}-1-17.5", 50, 1, GoalStatus.SUCCEEDED))
        self.assertAlmostEqual(moved.begun, 1, 3)
        self.assert_whole()

    def test_several_goals_without_an_id_are_joined_by_their_times(self):
        def fill(maker):
            for second in (1, 2, 3):
                maker.goal(second, "move_absolute", "", speed=10 * second)
            maker.goal(1.5, "stop", "")
            # They waited for each other: their ends tell nothing of when they were sent.
            for second in (1, 2, 3):
                maker.result(8 + second / 10, "move_absolute", f"{NODE}-{second}-x", given=second + 0.002)
            maker.result(1.6, "stop", f"{NODE}-4-x", given=1.502)

        goals = self.goals_of(fill)
        self.assertEqual([(goal.action, getattr(goal.message, "speed", None), goal.identity) for goal in goals],
                         [("move_absolute", 10, f"{NODE}-1-x"), ("stop", None, f"{NODE}-4-x"), ("move_absolute", 20, f"{NODE}-2-x"),
                          ("move_absolute", 30, f"{NODE}-3-x")])
        self.assert_whole()

    def test_goals_that_the_recorder_heard_late_keep_their_order(self):
        def fill(maker):
            # Each was refused before the recorder had found who sent it.
            for begun in (1.0, 1.2):
                maker.result(begun + 0.001, "move_absolute", f"{NODE}-{begun}", GoalStatus.REJECTED, given=begun)
                maker.goal(begun + 0.25, "move_absolute", "", speed=round(10 * begun))

        goals = self.goals_of(fill)
        self.assertEqual([(goal.identity, goal.message.speed, round(goal.begun, 3)) for goal in goals],
                         [(f"{NODE}-1.0", 10, 1.0), (f"{NODE}-1.2", 12, 1.2)])
        self.assert_whole()

    def test_a_goal_that_was_not_recorded_does_not_take_the_message_of_the_next_one(self):
        def fill(maker):
            maker.result(1.1, "move_absolute", f"{NODE}-1-x", given=1)
            maker.goal(2, "move_absolute", "", speed=20)
            maker.result(3, "move_absolute", f"{NODE}-2-x", given=2.001)

        unheard, heard = self.goals_of(fill)
        self.assertIsNone(unheard.message)
        self.assertEqual((heard.identity, heard.message.speed), (f"{NODE}-2-x", 20))
        self.assert_whole()

    def test_a_goal_of_a_client_that_gave_an_id_takes_no_message_without_one(self):
        def fill(maker):
            maker.goal(1, "move_absolute", "", speed=20)
            maker.result(1.01, "move_absolute", "/client-1-17.5", given=1)

        nameless, unheard = self.goals_of(fill)
        self.assertEqual((nameless.identity, nameless.end), ("", None))
        self.assertIsNone(unheard.message)
        self.assertEqual(len(wholeness.faults(self.run_made)), 1)

    def test_each_goal_without_an_id_that_has_no_result_is_open(self):
        def fill(maker):
            for time in (1, 2, 3):
                maker.goal(time, "move_absolute", "")
            maker.result(2.5, "move_absolute", f"{NODE}-1-x", given=1.001)

        self.assertEqual([goal.end is None for goal in self.goals_of(fill)], [False, True, True])
        self.assertEqual(len(wholeness.faults(self.run_made)), 2)

    def test_a_cancel_of_all_is_told_once_of_a_goal_without_an_id(self):
        def fill(maker):
            maker.goal(1, "move_absolute", "")
            maker.feedback(1.1, "move_absolute", f"{NODE}-1-x", given=1.001)
            maker.write("move_absolute/cancel", GoalID(), 1.5)
            maker.result(1.7, "move_absolute", f"{NODE}-1-x", GoalStatus.PREEMPTED, given=1.001)
            maker.write("move_absolute/cancel", GoalID(), 2)

        moved, = self.goals_of(fill)
        self.assertEqual([round(time, 3) for time in moved.cancelled], [1.5])

    def test_an_id_that_a_client_uses_again_is_another_goal(self):
        def fill(maker):
            for second, speed in ((1, 10), (20, 20)):
                maker.goal(second, "move_absolute", "mine", speed=speed)
                maker.result(second + 0.5, "move_absolute", "mine")
            # Sent again within the seconds in which the server remembers it, and ignored by it.
            maker.goal(21, "move_absolute", "mine", speed=30)

        self.assertEqual([(goal.message.speed, round(goal.end.time, 3)) for goal in self.goals_of(fill)], [(10, 1.5), (20, 20.5)])
        self.assert_whole()

    def test_a_goal_that_is_heard_after_its_result_is_that_goal(self):
        def fill(maker):
            maker.result(1, "stop", "mine")
            maker.goal(1.1, "stop", "mine")

        stopped, = self.goals_of(fill)
        self.assertIsNotNone(stopped.message)
        self.assert_whole()

    def test_a_bag_that_does_not_say_who_sent_its_results_is_read_as_well(self):
        def fill(maker):
            maker.sender = None
            maker.goal(1, "move_absolute", "", speed=20)
            maker.result(1.01, "move_absolute", "/some_node-1-17.5", given=1)

        moved, = self.goals_of(fill)
        self.assertEqual(moved.message.speed, 20)


class Pairing(unittest.TestCase):
    def best_of_all(self, left, right, near):
        """(how many, the time between them), by trying each."""
        for count in range(min(len(left), len(right)), 0, -1):
            costs = [sum(apart) for some in itertools.combinations(left, count) for others in itertools.combinations(right, count)
                     for apart in [[abs(a - b) for a, b in zip(some, others)]] if max(apart) <= near]
            if costs:
                return count, min(costs)
        return 0, 0

    def test_no_other_pairing_joins_more_or_is_closer(self):
        chance = random.Random(5)
        for _ in range(400):
            left, right = (sorted(chance.uniform(0, 20) for _ in range(chance.randrange(6))) for _ in range(2))
            found = pairs(left, right, 3)
            self.assertEqual(found, sorted(found))
            self.assertEqual([len(set(side)) for side in zip(*found)], [len(found)] * 2 if found else [])
            count, cost = self.best_of_all(left, right, 3)
            self.assertEqual(len(found), count)
            self.assertAlmostEqual(sum(abs(left[i] - right[j]) for i, j in found), cost, 9)

    def test_all_of_as_many_are_paired_in_their_order_without_trying(self):
        times = [0.1 * i for i in range(100_000)]
        self.assertEqual(pairs(times, [time + 0.3 for time in times], 5), [(i, i) for i in range(100_000)])


if __name__ == "__main__":
    unittest.main()
