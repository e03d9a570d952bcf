#!/usr/bin/env python3
"""The connect action against a simulated controller over real sockets."""
import socket

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus
from cobot_goals import BUFFERED, SLOWLY, turn
from cobot_test import CobotTestCase, Latest


class Connect(CobotTestCase):
    def test_stays_active_while_connected_and_reports_the_listen_node(self):
        self.robot.establish()
        status = self.robot.status.message
        self.assertEqual(status.listen_node, "Listen1")
        self.assertEqual(status.port, self.robot.port())
        self.assertGreater(status.last_connected.to_sec(), 0)
        # Goal states and command_status are different topics: which comes first is not defined.
        self.assertEqual(self.robot.connect.wait_until_active().state(), GoalStatus.ACTIVE)
        self.assertEqual([b.block for b in status.blocks if b.busy], ["connect"])

    def test_succeeds_when_it_is_cancelled_and_closes_the_link(self):
        self.robot.establish()
        self.robot.connect.cancel()
        self.assert_done(self.robot.connect.finish())
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the end of the link")

    def test_is_aborted_when_the_link_is_lost_and_a_new_goal_connects_again(self):
        self.robot.establish()
        self.robot.operate("stop_project")
        self.assert_aborted(self.robot.connect.finish(), 0x90)
        lost = self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the lost link")
        self.assertGreater(lost.last_lost.to_sec(), 0)
        self.robot.operate("run_project")
        self.robot.establish()

    def test_keeps_trying_until_the_project_runs(self):
        self.robot.operate("stop_project")
        self.robot.send_connect()
        self.robot.status.wait_for(lambda s: "refused" in s.diagnosis.lower(), "the diagnosis \"refused\"")
        self.robot.operate("run_project")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a ready link")

    def test_is_aborted_after_its_timeout_when_nobody_listens(self):
        self.robot.operate("stop_project")
        self.robot.send_connect(timeout=10.0)
        self.assert_aborted(self.robot.connect.finish(), 0x20, "refused")

    def test_tells_the_status_port_from_the_script_port(self):
        self.robot.send_connect(port=self.robot.port("status_port"))
        self.robot.status.wait_for(lambda s: "status port" in s.diagnosis.lower(), "the diagnosis \"status port\"")

    def test_names_a_script_port_that_is_given_for_the_status_port(self):
        self.robot.send_connect(status_port=self.robot.port())
        self.robot.status.wait_for(lambda s: "script port" in s.status_diagnosis, "the diagnosis \"script port\"")
        self.assertFalse(self.robot.status.message.status_stream)

    def test_is_aborted_after_its_timeout_when_the_flow_is_elsewhere(self):
        self.robot.operate("leave_listen_node")
        self.robot.send_connect(timeout=10.0)
        self.assert_aborted(self.robot.connect.finish(), 0x21)

    def test_tells_an_impostor_from_a_controller(self):
        self.robot.fault("impostor")
        self.robot.send_connect()
        self.robot.status.wait_for(lambda s: "protocol" in s.diagnosis.lower(), "the diagnosis of an impostor")

    def test_tells_a_device_that_is_silent_from_a_controller(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            self.robot.send_connect(port=silent.getsockname()[1], timeout=10.0)
            self.assert_aborted(self.robot.connect.finish(), 0x70)

    def test_is_rejected_with_a_timeout_outside_10_to_300_seconds(self):
        for timeout in (9.99, 300.01, -1.0, 0.0, float("nan"), float("inf")):
            with self.subTest(timeout=timeout):
                self.robot.send_connect(timeout=timeout)
                self.assert_rejected(self.robot.connect.finish(), 0x15)

    def test_accepts_both_ends_of_the_timeout_range(self):
        for timeout in (10.0, 300.0):
            with self.subTest(timeout=timeout):
                self.robot.send_connect(timeout=timeout)
                self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a ready link")
                self.robot.close()

    def test_is_rejected_with_a_host_or_port_that_cannot_be(self):
        for changes, error_id in (({"port": 65536}, 0x241), ({"port": -1}, 0x241), ({"status_port": 70000}, 0x241),
                                  ({"status_port": -1}, 0x241), ({"host": "a\r\nb"}, 0x240), ({"host": "a b"}, 0x240),
                                  ({"host": "x" * 256}, 0x240), ({"host": ""}, 0x240)):
            with self.subTest(**changes):
                self.robot.send_connect(**changes)
                self.assert_rejected(self.robot.connect.finish(), error_id)

    def test_is_rejected_while_another_connect_goal_is_active(self):
        self.robot.establish()
        first = self.robot.connect
        self.robot.send_connect()
        self.assert_rejected(self.robot.connect.finish(), 0x242)
        self.assertEqual(self.robot.status.message.link_state, CommandStatus.READY)
        self.robot.connect = first

    def test_stops_a_motion_that_is_left_over_from_the_link_before(self):
        self.robot.establish()
        self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, **SLOWLY))
        self.robot.operate("drop_connections")
        self.assert_aborted(self.robot.connect.finish(), 0x90)
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) > 1e-3, "an arm that moves on")
        self.robot.send_connect()
        self.robot.status.wait_for(lambda s: "no goal of this layer" in s.diagnosis, "the orphan")
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(turn(-1, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)))

    def test_tells_when_the_link_was_made_and_lost_since_the_goal_came(self):
        self.robot.establish()
        connected = self.robot.connect.wait_for_feedback(lambda f: f.connected, "the link")
        self.assertGreater(connected.last_connected.to_sec(), 0)
        self.assertEqual(connected.last_lost.to_sec(), 0)
        self.robot.connect.cancel()
        result = self.assert_done(self.robot.connect.finish())
        self.assertGreaterEqual(result.last_lost, result.last_connected)
        self.robot.send_connect()
        again = self.robot.connect.wait_for_feedback(lambda f: True, "a feedback")
        self.assertEqual(again.last_lost.to_sec(), 0, "reset with the goal")

    # --- A link that is kept without a goal.
    def test_of_a_kept_link_needs_no_goal_and_comes_back_without_resuming_anything(self):
        kept = Latest("kept/command_status", CommandStatus)
        kept.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream, "the kept link")
        moving = self.robot.send(turn(60, 0, 0, 0, 0, 0, **SLOWLY), "kept/").wait_until_active()
        self.robot.true_joints.wait_for(lambda m: abs(m.velocity[0]) > 1e-3, "the motion")
        before = kept.message.last_lost
        self.robot.operate("stop_project")
        self.assert_aborted(moving.finish(), 0x99)
        kept.wait_for(lambda s: s.link_state != CommandStatus.READY and s.last_lost > before, "the lost link")
        self.robot.operate("run_project")
        kept.wait_for(lambda s: s.link_state == CommandStatus.READY, "the link, once more")
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")
        self.assertEqual(kept.message.queue_depth, 0)


if __name__ == "__main__":
    import rostest

    rospy.init_node("connect_test")
    rostest.rosrun("cobot_command", "connect", Connect)
