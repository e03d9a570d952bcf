#!/usr/bin/env python3
"""RViz with its panel, on a screen that nobody sees: an operator clicks through it, and it ends cleanly."""
import os
import signal
import subprocess
import unittest

import rospkg
import rosgraph
import rosnode
import rospy
import rostest

from waiting import wait_until

SCREEN = "-screen 0 1500x1000x24"
SECONDS = 520


def on_screen(*command):
    """The command in a process group of its own, with a screen of its own and without a graphics card."""
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "QT_X11_NO_MITSHM": "1"}
    return subprocess.Popen(["xvfb-run", "--auto-servernum", f"--server-args={SCREEN}", *command], env=environment,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)


def config():
    return os.path.join(rospkg.RosPack().get_path("cobot_command"), "rviz", "cobot.rviz")


def is_heard_by(topic, node):
    _, subscribers, _ = rosgraph.Master("/rviz_test").getSystemState()
    return any(name == topic and node in nodes for name, nodes in subscribers)


class Rviz(unittest.TestCase):
    def start(self, *command):
        process = on_screen(*command)
        self.addCleanup(self.end, process)
        return process

    def end(self, process):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()

    def test_shows_a_panel_that_an_operator_can_work_with(self):
        process = self.start(os.environ["PANEL_TEST"], "-d", config(), "-f", "base")
        output, _ = process.communicate(timeout=SECONDS)
        print(output)
        self.assertEqual(process.returncode, 0, "see the output above")

    def test_ends_cleanly_when_it_is_told_to(self):
        process = self.start("rviz", "-d", config(), "-f", "base", "__name:=rviz_to_end")
        wait_until(lambda: "/rviz_to_end" in rosnode.get_node_names(), "RViz", 60)
        wait_until(lambda: is_heard_by("/rviz_to_end/preview_joints", "/rviz_to_end") and is_heard_by("/command_status", "/rviz_to_end"),
                   "what it shows, and its panel", 60)
        rosnode.kill_nodes(["/rviz_to_end"])
        output, _ = process.communicate(timeout=30)
        print(output)
        self.assertEqual(process.returncode, 0, "see the output above")


if __name__ == "__main__":
    rospy.init_node("rviz_test")
    rostest.rosrun("cobot_command", "rviz", Rviz)
