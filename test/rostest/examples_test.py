#!/usr/bin/env python3
"""Every shell example of doc/actions ends as its page says, and the example clients do what they say."""
import contextlib
import re
import signal
import subprocess

from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus
from cobot_goals import HOME, base, tcp, to_joints
from cobot_test import program
from motion_checks import MotionTestCase
from page_examples import check, examples_of, results_of_all_actions

CLIENT_DEADLINE = 120  # [s]
# The layer does not know that this controller is five times as fast as it plans.
ANY_TIME = ["--joints", "1000", "--path", "1000", "--lag", "10"]
CLIENTS = (["pick_and_place.py", "--cycles", "0"], ["tour.py"], ["tour"], ["load_path.py", *ANY_TIME])


class Examples(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.results = results_of_all_actions(cls.robot)

    def test_every_page_has_examples_and_they_end_as_it_says(self):
        with contextlib.ExitStack() as shells:
            for action in sorted(self.results):
                examples = examples_of(f"doc/actions/{action}.md")
                self.assertTrue(examples, action)
                self.start_afresh()
                if action == "connect":
                    self.robot.close()
                for example in examples:
                    with self.subTest(action=action, command=example["command"]):
                        check(self, self.robot, self.results, example, shells)

    def test_tours_come_to_their_end(self):
        for client in ("tour.py", "tour"):
            with self.subTest(client=client):
                output = self.run_client(client)
                self.assertIn("The tour is over", output)
                self.assert_stands_at(HOME, streamed=False)
                self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the closed link")

    def test_pick_and_place_shows_every_step(self):
        output = self.run_client("pick_and_place.py", "--cycles", "2")
        for name in ("above pick", "pick", "up with the part", "above place", "place", "up, empty"):
            self.assertEqual(len(re.findall(rf"^ +[12] +\d  {name}  .*  Done$", output, re.M)), 2, output)
        self.assertIn("2 cycle(s), all steps Done", output)

    def test_exchange_configuration_goes_through_the_steps_of_its_page(self):
        output = self.run_client("exchange_configuration.py", "--seconds", "0.5")
        self.assertIn("Enabled: 65 commands can be held; tools up to 15, frames up to 15, loads up to 15", output)
        self.assertIn("Disabled", output)
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the closed link")

    def test_exchange_configuration_tells_why_it_is_not_enabled(self):
        output = self.run_client("exchange_configuration.py", "--life-sign-time-out", "9", exit_status=1)
        self.assertRegex(output, "error 36116: life_sign_time_out is 9 ms")

    def test_load_path_shows_every_point(self):
        output = self.run_client("load_path.py", *ANY_TIME)
        for index, way in enumerate(("PTP", "CP_LINEAR", "CP_LINEAR", "CP_WRIST", "CP_WRIST", "CP_LINEAR", "PTP")):
            self.assertRegex(output, rf"(?m)^ +{index} +\d+  {way} ")
            self.assertRegex(output, rf"(?m)^  path: point {index} .* is active, {index} done")
        self.assertIn("blends lost: none; sent as one PVT", output)
        self.assertEqual(len(re.findall("(first|second): SUCCEEDED", output)), 2, output)
        self.assert_stands_at(HOME, streamed=False)

    def test_load_path_tells_when_the_robot_was_not_where_it_should_be(self):
        output = self.run_client("load_path.py", exit_status=1)
        self.assertRegex(output, r"max_joint_deviation is [\d.]+, and at most 6 is allowed")

    def test_clients_use_a_link_that_is_there_and_leave_it(self):
        for command, end in ((["tour.py"], "The tour is over"), (["tour"], "The tour is over"),
                             (["pick_and_place.py"], "1 cycle(s), all steps Done"),
                             (["load_path.py", *ANY_TIME], "All paths are done")):
            with self.subTest(command=command):
                self.assertIn(end, self.run_client(*command, closed=False))
                self.assertEqual(self.robot.connect.state(), GoalStatus.ACTIVE)
        for command in CLIENTS:
            with self.subTest(interrupted=command):
                self.interrupt(command, signal.SIGINT)
                self.assertEqual(self.robot.connect.state(), GoalStatus.ACTIVE)

    def test_clients_that_are_asked_for_help_move_nothing(self):
        before = self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill").position
        for name in ("tour.py", "tour", "jog.py", "pick_and_place.py", "load_path.py", "interrupt.py"):
            with self.subTest(name):
                self.assertIn("usage" if name.endswith(".py") else "moves the robot", self.run_client(name, "--help", closed=False))
                self.run_client(name, "--nonsense", exit_status=2, closed=False)
        self.run_client("jog.py", "--seconds", "nan", exit_status=2, closed=False)
        self.assertEqual(self.robot.true_joints.message.position, before)

    def test_clients_stop_the_robot_when_they_are_told_to_end(self):
        for command in CLIENTS:
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(command=command, signal=number.name):
                    self.robot.close()
                    self.interrupt(command, number)
                    self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the closed link")

    def interrupt(self, command, number):
        with subprocess.Popen([program(command[0]), *command[1:]], stdout=subprocess.PIPE, text=True) as client:
            self.robot.wait_for_motion()
            client.send_signal(number)
            output, _ = client.communicate(timeout=CLIENT_DEADLINE)
        self.assertEqual(client.returncode, 1, output)
        self.assertIn("interrupted", output)
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")

    def test_jog_tells_why_the_arm_came_to_rest(self):
        output = self.run_client("jog.py", "--direction", "1", "--speed", "10", "--seconds", "1")
        self.assertIn("no more keep-alives were received", output)
        self.robot.establish()
        self.assertIn("5.00 deg: the increment is complete", self.run_client("jog.py", "--deg", "5", closed=False))

    def test_interrupt_brings_the_robot_back_and_lets_its_motion_go_on(self):
        output = self.run_client("interrupt.py")
        for words in ("interrupt: interrupted: move_relative", "the return: done", "the interrupted motion: done", "back to the start: done"):
            self.assertIn(words, output)
        self.assert_stands_at(HOME, streamed=False)

    def test_jog_tells_why_it_was_refused(self):
        self.assertIn("16#26", self.run_client("jog.py", "--speed", "101", exit_status=1))

    def test_pick_and_place_tells_steps_that_it_cannot_use(self):
        self.assertIn("16#256", self.run_client("pick_and_place.py", "--steps", "/nowhere.yaml", exit_status=2))

    # --- Helpers.
    def start_afresh(self):
        """Connected and at HOME, with the base and the tool that the controller starts with."""
        self.robot.reset()
        self.establish_at_home()
        for goal in (base(base_name="RobotBase"), tcp(tcp_name="NOTOOL")):
            self.assert_done(self.robot.run(goal))

    def run_client(self, name, *arguments, exit_status=0, closed=True):
        if closed:
            self.robot.close()
        done = subprocess.run([program(name), *arguments], capture_output=True, text=True, timeout=CLIENT_DEADLINE,
                              check=False)
        self.assertEqual(done.returncode, exit_status, done.stdout + done.stderr)
        return done.stdout


if __name__ == "__main__":
    import rospy
    import rostest

    rospy.init_node("examples_test")
    rostest.rosrun("cobot_command", "examples", Examples)
