#!/usr/bin/env python3
"""Nodes whose end is asked for while they start, at many moments of that: they end as ever, and never by an abort."""
import signal
import time

import rospy

from cobot_test import OutcomeTestCase
from own_nodes import Heard, Master, node
from waiting import wait_until

KINDS = {"command_node": {"robot_model": "tm5-900"},
         "simulated_controller_node": {"robot_model": "tm5-900", "script_port": 0, "status_port": 0}}
# [s] behind the first moment at which a node catches signals; on a quiet machine both have started after 0.2 s.
MOMENTS = [n / 100 for n in range(16)] + [0.2, 0.3, 0.4, 0.6]
NOBODY = "nobody"


class AStartThatIsInterrupted(OutcomeTestCase):
    def start(self, kind):
        process = node(kind, "starting", process=Heard, **KINDS[kind])
        self.addCleanup(process.clear_away)
        return process

    def assert_ended(self, process):
        self.assertEqual(process.wait(), 0, process.output())

    def test_by_a_signal_ends_as_ever(self):
        for kind in KINDS:
            for moment in MOMENTS:
                with self.subTest(kind, moment=moment):
                    process = self.start(kind)
                    process.wait_until_it_catches(signal.SIGTERM)
                    time.sleep(moment)  # what is tried here is the moment itself
                    process.signal(signal.SIGTERM)
                    self.assert_ended(process)

    def test_by_another_node_of_its_name_ends_as_ever(self):
        for kind in KINDS:
            for moment in MOMENTS[::3]:
                with self.subTest(kind, moment=moment):
                    first = self.start(kind)
                    first.wait_until_it_catches(signal.SIGTERM)
                    time.sleep(moment)
                    second = self.start(kind)
                    self.assert_ended(first)
                    second.wait_until_it_catches(signal.SIGTERM)
                    second.signal(signal.SIGTERM)
                    self.assert_ended(second)

    def test_ends_while_it_waits_for_a_master(self):
        for kind, parameters in [*KINDS.items(), *((kind, {}) for kind in KINDS)]:  # without any it waits later
            with self.subTest(kind, parameters=parameters):
                master = Master()
                master.end(signal.SIGKILL)
                process = node(kind, "starting", master=master.uri, process=Heard, **parameters)
                self.addCleanup(process.clear_away)
                wait_until(lambda: "Failed to contact master" in process.output(), "the search for a master")
                process.signal(signal.SIGINT)
                self.assert_ended(process)
                self.assertNotIn("were not enough", process.output())


class ACommandNodeThatWaitsForPorts(OutcomeTestCase):
    def setUp(self):
        self.master = Master()
        self.addCleanup(self.master.clear_away)
        self.node = node("command_node", "waiting", master=self.master.uri, process=Heard,
                         simulated_controller=NOBODY)
        self.addCleanup(self.node.clear_away)
        wait_until(lambda: "waiting for the ports of nobody" in self.node.output(), "a node that waits")

    def test_ends_as_ever_and_blames_nobody(self):
        self.node.signal(signal.SIGINT)
        self.assertEqual(self.node.wait(), 0)
        self.assertNotIn("published no ports", self.node.output())

    def test_says_what_it_was_at_when_its_master_hangs(self):
        self.master.signal(signal.SIGSTOP)
        self.node.signal(signal.SIGTERM)
        self.assertEqual(self.node.wait(), 0)
        self.assertIn("3 s were not enough for starting, with its requests to the ROS master at " + self.master.uri,
                      self.node.output())


if __name__ == "__main__":
    import rostest

    rospy.init_node("starts_test")
    rostest.rosrun("cobot_command", "starts", "starts_test")  # all classes of this file
