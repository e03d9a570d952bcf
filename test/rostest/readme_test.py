#!/usr/bin/env python3
"""Every command of README's five minutes, and its fifteen lines of Python, do what it says."""
import contextlib
import re
import signal
import subprocess
import sys

from cobot_command.msg import CommandStatus
from cobot_goals import HOME
from cobot_test import Robot
from motion_checks import MotionTestCase
from own_nodes import Heard
from page_examples import PACKAGE, check, examples_of, results_of_all_actions, shell

PAGE = (PACKAGE / "README.md").read_text(encoding="utf-8")
LAUNCH = re.search(r"^roslaunch .*$", PAGE, re.M)[0]
ON_FREE_PORTS = " rviz:=false script_port:=0 status_port:=0"
STATUS = re.search(r"^rostopic echo -n1 /command_status/link_state *# (\d)", PAGE, re.M)
PYTHON = re.search(r"^```python\n(.*?)^```$", PAGE, re.M | re.S)[1]


class Readme(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        cls.launched = Heard(*(LAUNCH + ON_FREE_PORTS).split())
        cls.robot = Robot()
        cls.results = results_of_all_actions(cls.robot)

    @classmethod
    def tearDownClass(cls):
        cls.launched.end(signal.SIGINT)
        cls.launched.clear_away()

    def setUp(self):
        self.robot.port()  # when it is there, the simulator is

    def test_the_five_minutes_go_as_it_says(self):
        examples = examples_of("README.md")
        self.assertEqual([example["state"] for example in examples], ["ACTIVE", "", "", "REJECTED"])
        with contextlib.ExitStack() as shells:
            for number, example in enumerate(examples):
                check(self, self.robot, self.results, example, shells)
                if number == 0:
                    shown = subprocess.run(["bash", "-c", STATUS[0]], capture_output=True, text=True, timeout=60, check=True)
                    self.assertEqual(shown.stdout.split()[0], STATUS[1])
                    self.assertEqual(int(STATUS[1]), CommandStatus.READY)
        self.move_by_the_lines_of_python()

    def move_by_the_lines_of_python(self):
        done = subprocess.run([sys.executable, "-c", PYTHON], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, "The robot is at its target.\n"), done.stderr)
        self.assert_stands_at(HOME)
        with shell("rostopic pub -1 /connect/cancel actionlib_msgs/GoalID '{}'"):
            self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the closed link")


if __name__ == "__main__":
    import rospy
    import rostest

    rospy.init_node("readme_test")
    rostest.rosrun("cobot_command", "readme", Readme)
