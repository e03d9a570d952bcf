#!/usr/bin/env python3
"""Many random goals of all actions from four clients at once, with cancels at random times; the PLCopen rules are watched
all the time. Then some cases of their own that chance does not bring.

Parameters: ~goals, and ~seed (0: another one each time). The same seed sends the same goals again."""
import contextlib
import itertools
import os
import random
import signal
import unittest

import rospy
from actionlib_msgs.msg import GoalID, GoalStatus

from cobot_goals import base, sequence, to_joints, turn
from load_clients import AN_HOUR, BLOCKS
from load_run import DEADLINE, Load
from random_goals import Drawn

ROUND = 250  # goals
MOST_SHOWN = 20  # faults; the first is what counts
MOST_GROWTH = 8.0  # [KiB] of the node for each goal; one that stayed in memory would need more
WATCHED = {"ASAN_OPTIONS", "TSAN_OPTIONS"} & set(os.environ)  # sanitizers keep books of all memory, freed or not
IN_ONE_CYCLE = 300  # goals of one action; actionlib's own queue has 50


class LoadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.load = Load(rospy.get_param("~seed") or random.randrange(1, 10**6))
        cls.watch, cls.publishers = cls.load.watch, cls.load.publishers

    @classmethod
    def tearDownClass(cls):
        cls.load.finish()

    def test_of_random_goals_ends_each_once_and_holds_the_rules_of_plcopen(self):
        goals, load = rospy.get_param("~goals"), self.load
        for start in range(0, goals, ROUND):
            self.assert_holds(load.run_round(min(ROUND, goals - start)))
        print(load.report(), flush=True)
        # How many depends on how fast the simulator is asked; that each asked end is compared, plcopen_rules_test promises.
        self.assertGreater(load.compared, 0, "the simulator was never asked where the robot is")
        self.assertEqual(load.succeeded, set(BLOCKS), "every action succeeds now and then")
        for name in ("descriptors", "threads"):
            self.assertEqual(len({getattr(s, name) for s in load.samples}), 1, load.samples)
        if not WATCHED:
            # Of the second half: the first goals of each kind fill what is used again and again.
            middle, last = load.samples[len(load.samples) // 2], load.samples[-1]
            self.assertLess(last.kibibytes - middle.kibibytes, MOST_GROWTH * goals / 2, load.samples)

    # --- Many at once.
    def test_of_a_burst_of_goals_in_one_callback_cycle_ends_each(self):
        self.load.settle()
        with self.node_held():
            ids = [self.send(f"burst-{n}", base(buffer_mode=-1), {0x215}) for n in range(IN_ONE_CYCLE)]
        self.assert_all_end(ids)
        self.load.settle()
        self.assert_holds(self.load.judge())

    def test_of_hundred_goals_of_several_actions_in_one_callback_cycle_ends_each(self):
        self.load.settle()
        goals = (turn(1, buffer_mode=1), base(buffer_mode=1), to_joints(0, 0, 90, 0, 90, buffer_mode=1),
                 sequence(turn(1), start_joints=[0, 0, 90, 0, 90, 0]))
        with self.node_held():
            ids = [self.send(f"mixed-{n}", goals[n % len(goals)]) for n in range(100)]
        self.assert_all_end(ids)
        self.load.settle()
        self.assert_holds(self.load.judge())
        self.assertIn(GoalStatus.SUCCEEDED, {self.watch.state_of(i) for i in ids})

    # --- Cancels that outlive their goal.
    def test_of_a_cancel_of_a_goal_that_never_comes_leaves_nothing_behind(self):
        for stamp in (rospy.Time(0), rospy.Time.now() + AN_HOUR):
            with self.subTest(stamp=stamp.to_sec()):
                self.publishers.cancel["change_base"].publish(GoalID(id="never", stamp=stamp))
                self.assertTrue(self.watch.wait_for(lambda: "never" in self.watch.listed("change_base"), DEADLINE))
                self.assertTrue(self.watch.wait_for(lambda: "never" not in self.watch.listed("change_base"), DEADLINE),
                                "actionlib still lists the cancel of a goal that there is not")

    def test_of_goals_behind_a_cancel_from_a_clock_that_is_an_hour_ahead_are_taken(self):
        self.load.settle()
        for n in range(5):  # actionlib's list is tidied up once a second, which shall not be what helps
            cancel = f"ahead-{n}"
            self.publishers.cancel["check_sequence"].publish(GoalID(id=cancel, stamp=rospy.Time.now() + AN_HOUR))
            self.assertTrue(self.watch.wait_for(lambda: cancel in self.watch.listed("check_sequence"), DEADLINE))
            name = self.send(f"after-{n}", sequence(turn(1), start_joints=[0, 0, 90, 0, 90, 0]))
            self.assert_all_end([name])
            self.assertEqual(self.watch.state_of(name), GoalStatus.SUCCEEDED, "cancelled on arrival")

    # --- Helpers.
    def send(self, name, goal, errors=None):
        return self.load.send(name, Drawn(goal, errors and frozenset(errors), False, None))

    @contextlib.contextmanager
    def node_held(self):
        """What is sent to it meanwhile waits in its sockets, and comes at once."""
        os.kill(self.load.pid, signal.SIGSTOP)
        try:
            yield
        finally:
            os.kill(self.load.pid, signal.SIGCONT)

    def assert_all_end(self, ids):
        self.watch.wait_for(lambda: all(self.watch.has_ended(i) for i in ids), DEADLINE)
        open_ones = [i for i in ids if not self.watch.has_ended(i)]
        self.assertFalse(open_ones, f"{len(open_ones)} of {len(ids)} goals have no end")

    def assert_holds(self, faults):
        self.assertTrue(not faults, "\n".join([f"{len(faults)} faults; seed:={self.load.seed}", *faults[:MOST_SHOWN]]))


if __name__ == "__main__":
    import rostest

    rospy.init_node("load_test")
    rostest.rosrun("cobot_command", "load", LoadTest)
