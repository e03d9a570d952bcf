#!/usr/bin/env python3
"""The operator's side and the faults of the simulated controller, as its services offer them."""
import socket

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus, MomentOfInertia, RobotStatus, Transformation
from cobot_goals import BUFFERED, ELSEWHERE, HOME, SLOWLY, to_joints
from cobot_test import CobotTestCase


class Operator(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.robot.establish()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    # --- The project and its flow.
    def test_stops_and_runs_the_project(self):
        self.robot.operate("stop_project")
        self.wait_for_truth(project_running=RobotStatus.FALSE)
        with self.assertRaises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", self.robot.port()))
        self.robot.operate("run_project")
        self.wait_for_truth(project_running=RobotStatus.TRUE)
        socket.create_connection(("127.0.0.1", self.robot.port())).close()

    def test_pauses_the_motion_and_lets_it_go_on(self):
        self.start_slowly()
        self.robot.operate("pause_project")
        self.wait_for_truth(project_paused=RobotStatus.TRUE, in_motion=RobotStatus.FALSE)
        self.robot.operate("resume_project")
        self.wait_for_truth(project_paused=RobotStatus.FALSE, in_motion=RobotStatus.TRUE)

    def test_lets_the_flow_leave_the_listen_node_and_come_back(self):
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.NOT_LISTENING, "a flow elsewhere")
        self.assert_rejected(self.robot.run(to_joints(*ELSEWHERE)), 0x220)
        self.robot.operate("enter_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "the flow in the Listen node")

    def test_cannot_pause_a_project_that_does_not_run(self):
        self.robot.operate("stop_project")
        for service in ("pause_project", "resume_project", "leave_listen_node", "enter_listen_node"):
            with self.subTest(service):
                answer = self.robot.try_to(service)
                self.assertFalse(answer.success)
                self.assertIn("run it first", answer.message)

    # --- The cell.
    def test_stops_everything_with_the_emergency_stop(self):
        self.start_slowly()
        self.robot.operate("set_emergency_stop", True)
        self.wait_for_truth(e_stopped=RobotStatus.TRUE, in_motion=RobotStatus.FALSE,
                            project_running=RobotStatus.FALSE)
        self.assertFalse(self.robot.try_to("run_project").success)

    def test_holds_the_arm_while_the_safeguard_is_open(self):
        self.start_slowly()
        self.robot.operate("set_safeguard", True)
        self.wait_for_truth(safeguard=RobotStatus.TRUE, in_motion=RobotStatus.FALSE)
        self.robot.robot_status.wait_for(lambda s: s.safeguard == RobotStatus.TRUE, "the safeguard in the stream")
        self.robot.operate("set_safeguard", False)
        self.wait_for_truth(safeguard=RobotStatus.FALSE, in_motion=RobotStatus.TRUE)

    def test_switches_between_manual_and_automatic_mode(self):
        self.robot.operate("set_manual_mode", True)
        self.robot.robot_status.wait_for(lambda s: s.mode == RobotStatus.MODE_MANUAL, "manual mode")
        self.robot.operate("set_manual_mode", False)
        self.robot.robot_status.wait_for(lambda s: s.mode == RobotStatus.MODE_AUTOMATIC, "automatic mode")

    def test_changes_the_project_speed(self):
        self.robot.operate("set_project_speed", 35)
        self.robot.robot_status.wait_for(lambda s: s.project_speed == 35, "the project speed")
        self.assertIn("steps of 5", self.robot.try_to("set_project_speed", 36).message)

    def test_sets_inputs(self):
        self.assertIn("on", self.robot.operate("set_input", "EndModule", 2, True))
        self.assertIn("off", self.robot.operate("set_input", "ControlBox", 15, False))
        self.assertIn("0 to 3", self.robot.try_to("set_input", "EndModule", 4, True).message)
        self.assertIn("ControlBox and EndModule", self.robot.try_to("set_input", "Elsewhere", 0, True).message)

    def test_changes_tools_and_bases_as_the_pendant_does(self):
        self.assertIn("at 0, 0, 160, 0, 0, 0", self.robot.operate("set_tcp", "gripper", Transformation(z=160)))
        self.assertIn("at 0, 0, 0, 0, 0, 90", self.robot.operate("set_base", "table", Transformation(rz=90)))
        load = self.robot.operate("set_load", "gripper", 2.5, MomentOfInertia(1, 2, 3), Transformation(z=-80))
        self.assertIn("2.5 kg, inertia 1, 2, 3 kg mm^2, centre at 0, 0, -80, 0, 0, 0", load)
        self.assertIn("it has", self.robot.try_to("set_tcp", "nothing", Transformation()).message)
        self.assertIn("is fixed", self.robot.try_to("set_base", "RobotBase", Transformation()).message)
        self.assertIn("0 to 1000", self.robot.try_to("set_load", "gripper", -1, MomentOfInertia(), Transformation()).message)

    # --- Errors and faults.
    def test_lets_the_robot_fail_and_recover(self):
        self.start_slowly()
        self.robot.operate("raise_error", 0x14058, "joint 3")
        state, _ = self.sent.finish()
        self.assertEqual(state, GoalStatus.ABORTED)
        status = self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.assertEqual(status.error_code, 0x14058)  # TMflow 1.80 has no Error_Content
        self.robot.clear_error()

    def test_drops_the_connections_and_takes_new_ones(self):
        self.robot.operate("drop_connections")
        self.assert_aborted(self.robot.connect.finish(), 0x90)
        self.robot.establish()

    def test_turns_faults_on_and_off(self):
        self.robot.fault("refuse_script", count=1)
        self.assert_aborted(self.robot.run(to_joints(*ELSEWHERE)), 0x80)
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))
        self.robot.fault("cperr_script", text="02")
        self.assert_aborted(self.robot.run(to_joints(*HOME)), 0x224)
        self.robot.fault("cperr_script", active=False)
        # The layer's own stop was answered so, too: it waits until the robot is seen to stand.
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=BUFFERED)))
        self.robot.fault("delay_reply", count=1, seconds=0.2)
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))

    def test_names_the_faults_that_it_knows(self):
        answer = self.robot.try_to("set_fault", "gremlins", True, 0, 0.0, "")
        self.assertFalse(answer.success)
        for name in ("gremlins", "refuse_script", "silence", "drop_tag", "delay_reply", "hide_items"):
            self.assertIn(name, answer.message)

    def test_turns_all_faults_off_together(self):
        self.robot.fault("refuse_script")
        self.robot.fault("drop_stream")
        self.robot.operate("clear_faults")
        self.assert_done(self.robot.run(to_joints(*ELSEWHERE)))

    # --- Helpers.
    def start_slowly(self):
        """Starts towards ELSEWHERE, and returns when the arm is on its way."""
        self.sent = self.robot.start_slowly(to_joints(*ELSEWHERE, **SLOWLY))

    def wait_for_truth(self, **expected):
        self.robot.true_status.wait_for(
            lambda s: all(getattr(s, name) == value for name, value in expected.items()), f"{expected}")


if __name__ == "__main__":
    import rostest

    rospy.init_node("operator_test")
    rostest.rosrun("cobot_command", "operator", Operator)
