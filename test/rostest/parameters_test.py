#!/usr/bin/env python3
"""Nodes with parameters that they cannot use end with status 2 and a line that names the parameter.

All kinds of bad values are tried without ROS, in test/unit/ros/parameters_test.cpp; here it is whole nodes, and values that
once came through to where they were an exception.
"""
import subprocess
import tempfile
import unittest

import rospy
import yaml

from cobot_test import program
from waiting import wait_until

DEADLINE = 100  # [s]; reached only when something is broken
NAN = float("nan")
FREE_PORTS = {"script_port": 0, "status_port": 0}
DESCRIPTION = "/described/robot_description"

COMMAND_NODE = [
    ({"simulated_controller": "a b"}, 'simulated_controller is the text "a b"; allowed: the name of a node, or empty'),
    ({"simulated_controller": "~own"}, 'simulated_controller is the text "~own"'),
    ({"diagnostic_period": NAN}, "diagnostic_period is nan; allowed: a number, 0.1 to 3600 s"),
    ({"diagnostic_period": "often"}, 'diagnostic_period is the text "often"'),
    ({"script_port": 5890.7}, "script_port is 5890.7; allowed: a whole number, 0 to 65535"),
    ({"supervision_misses": 2.5}, "supervision_misses is 2.5; allowed: a whole number, 1 to 100"),
    ({"stop_timeout": float("inf")}, "stop_timeout is inf"),
    ({"retry_min": 3.0}, "retry_min is 3 s, more than retry_max, which is 1 s"),
    ({"prefix": "/x"}, 'prefix is the text "/x"'),
    ({"prefix": ["a"]}, "prefix is a list of 1"),
    ({"robot_ip": {"a": 1}}, "robot_ip is a namespace with parameters"),
    ({"auto_connect": "yes"}, 'auto_connect is the text "yes"; allowed: true or false'),
]
SIMULATED_CONTROLLER = [
    ({"publish_rate": float("inf")}, "publish_rate is inf"),
    ({"publish_rate": NAN}, "publish_rate is nan"),
    ({"bind_address": "nowhere"}, 'bind_address is the text "nowhere"; allowed: a numeric address of this machine'),
    ({"bind_address": "192.0.2.1"}, "bind_address must be an address of this machine"),
    ({"prefix": "a b"}, 'prefix is the text "a b"'),
    ({"points": ["P=0,0,170,0,0,0"]}, 'points "P" has joint 3 at 170 deg, outside its limits'),
    ({"variables": ["int PTP"]}, 'variables holds "int PTP": PTP is a function'),
    ({"write_clients": "999.1.1.1"}, 'write_clients names "999.1.1.1", which is not an address'),
    ({"bases": ["a=0,0,0,0,0,0", "a=0,0,0,0,0,0"]}, 'bases names "a" twice'),
    ({"start_posture_deg": [0, 0, 90, 0, 90]}, "start_posture_deg is a list of 5; allowed: a list of six joint angles"),
    ({"robot_model": ""}, "robot_model is empty, and there is no robot_description"),
]


def start(name, parameters, node="tried", namespace="/"):
    """The process of a node with these private parameters, and no others."""
    space = namespace + node
    if rospy.has_param(space):
        rospy.delete_param(space)
    rospy.set_param(space, parameters)
    return subprocess.Popen([program(name), f"__name:={node}", f"__ns:={namespace}"], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, universal_newlines=True)


def run(*arguments, **keywords):
    """(exit status, output) of a node that is expected to end by itself."""
    process = start(*arguments, **keywords)
    try:
        output, _ = process.communicate(timeout=DEADLINE)
    except subprocess.TimeoutExpired:
        process.kill()
        output, _ = process.communicate()
        return "still running", output
    return process.returncode, output


class Parameters(unittest.TestCase):
    def assert_refused(self, outcome, words):
        status, output = outcome
        self.assertEqual(status, 2, output)
        self.assertIn(words, output)
        self.assertIn("FATAL", output)

    def test_that_the_command_node_cannot_use(self):
        for parameters, words in COMMAND_NODE:
            with self.subTest(words):
                self.assert_refused(run("command_node", parameters), "parameter /tried/" + words)

    def test_that_the_simulated_controller_cannot_use(self):
        for parameters, words in SIMULATED_CONTROLLER:
            with self.subTest(words):
                given = {"robot_model": "tm5-900", **FREE_PORTS, **parameters}
                self.assert_refused(run("simulated_controller_node", given), words)

    def test_that_are_no_description(self):
        for description, words in ((7, "robot_description is 7"), ("", "robot_description cannot be used")):
            with self.subTest(words):
                rospy.set_param(DESCRIPTION, description)
                self.assert_refused(run("command_node", {}, namespace="/described/"),
                                    "parameter /described/tried/robot_model is empty, and " + words)

    def test_that_launch_files_miss(self):
        for arguments, words in ((["bringup.launch"], "requires the 'robot_ip' arg to be set"),
                                 (["fleet.launch", "count:=0"], "count_must_be_1_or_more"),
                                 (["fleet.launch", "count:=-2"], "count_must_be_1_or_more")):
            with self.subTest(arguments):
                done = subprocess.run(["roslaunch", "--nodes", "cobot_command", *arguments], capture_output=True, text=True,
                                      timeout=DEADLINE, check=False)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(words, done.stdout + done.stderr)

    def test_that_a_file_adds_to_those_of_the_launch_file(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write("safety_limits: ['1=-90,90']\ntime_scale: 2.0\n")
            file.flush()
            done = subprocess.run(["roslaunch", "--dump-params", "cobot_command", "bringup.launch", "sim:=true",
                                   f"sim_parameters:={file.name}", f"parameters:={file.name}"], capture_output=True, text=True,
                                  timeout=DEADLINE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        given = yaml.safe_load(done.stdout)
        for node in ("simulated_controller", "command_node"):
            self.assertEqual(given[f"/{node}/safety_limits"], ["1=-90,90"])
        self.assertEqual(given["/simulated_controller/time_scale"], 1.0, "the argument rules")

    def test_that_a_fleet_gives_to_each_of_its_robots(self):
        arguments = {"tf_from_start": True, "auto_connect": True, "time_scale": 2.0, "robot_model": "tm12"}
        done = subprocess.run(["roslaunch", "--dump-params", "cobot_command", "fleet.launch", "count:=3",
                               *(f"{name}:={value}" for name, value in arguments.items())],
                              capture_output=True, text=True, timeout=DEADLINE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        given = yaml.safe_load(done.stdout)
        for robot in ("robot_1", "robot_2", "robot_3"):
            self.assertEqual(given[f"/{robot}/command_node/tf_from_start"], True)
            self.assertEqual(given[f"/{robot}/command_node/auto_connect"], True)
            self.assertEqual(given[f"/{robot}/simulated_controller/time_scale"], 2.0)
            self.assertEqual(given[f"/{robot}/simulated_controller/robot_model"], "tm12")

    def test_that_are_misspelt_are_named_and_the_node_goes_on(self):
        process = start("simulated_controller_node", {"robot_model": "tm5-900", "project_sped": 50, **FREE_PORTS})
        try:
            wait_until(lambda: rospy.has_param("/tried/listening/status_port"), "a node that serves")
        finally:
            process.terminate()
            output, _ = process.communicate(timeout=DEADLINE)
        self.assertIn("parameter /tried/project_sped is not a parameter of this node and is ignored: did you mean project_speed?",
                      output)


if __name__ == "__main__":
    import rostest

    rospy.init_node("parameters_test")
    rostest.rosrun("cobot_command", "parameters", Parameters)
