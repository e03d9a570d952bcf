#!/usr/bin/env python3
"""What the nodes make of words on their command line, before they look for a master.

Usage: arguments_test.py NODE...
"""
import os
import subprocess
import sys
import unittest

NODES = sys.argv[1:]
NOWHERE = {**os.environ, "ROS_MASTER_URI": "http://localhost:1"}


def run(node, *words, env=NOWHERE):
    return subprocess.run([node, *words], env=env, capture_output=True, text=True, timeout=60, check=False)


class Arguments(unittest.TestCase):
    def test_ask_for_help(self):
        for node in NODES:
            for word in ("--help", "-h"):
                ended = run(node, "_robot_ip:=10.0.0.1", word)
                self.assertEqual((ended.returncode, ended.stderr), (0, ""), node)
                self.assertIn(f"usage: {os.path.basename(node)}", ended.stdout)

    def test_ask_for_the_version(self):
        for node in NODES:
            ended = run(node, "--version")
            self.assertEqual((ended.returncode, ended.stderr), (0, ""), node)
            self.assertRegex(ended.stdout, rf"^{os.path.basename(node)} \(cobot_command\) \d+\.\d+\.\d+\n$")

    def test_that_no_node_understands_are_refused(self):
        for node in NODES:
            for word in ("banana", "--robot_ip=10.0.0.1", "robot_ip=10.0.0.1", "", "\x1b[2J"):
                ended = run(node, "__name:=one", word)
                self.assertEqual((ended.returncode, ended.stdout), (2, ""), (node, word))
                self.assertIn("allowed: name:=value, --help, --version", ended.stderr)
                self.assertNotIn("\x1b", ended.stderr)

    def assert_refused(self, words, *arguments, env=NOWHERE):
        for node in NODES:
            ended = run(node, *arguments, env=env)
            self.assertEqual((ended.returncode, ended.stdout), (2, ""), (node, arguments, ended.stderr))
            self.assertRegex(ended.stderr, f"^{os.path.basename(node)}: {words}")
            self.assertEqual(ended.stderr.count("\n"), 1, ended.stderr)

    def test_that_are_no_name_of_a_node_are_refused(self):
        for name in ("~x", "a b", "/x", "a/b", "", "9x", "_x", "a-b", "é"):
            self.assert_refused("__name is '.*'; allowed: letters, digits and _", f"__name:={name}")

    def test_that_are_no_namespace_are_refused(self):
        for space in ("~x", "a b", "/a-b", "é"):
            self.assert_refused("__ns is '.*'; allowed: letters, digits, _ and /", f"__ns:={space}")
            self.assert_refused("ROS_NAMESPACE is '.*'; allowed: letters, digits, _ and /", env={**NOWHERE, "ROS_NAMESPACE": space})

    def test_that_rename_what_has_no_name_or_to_what_is_none_are_refused(self):
        for word in ("stop/goal:=a b", "a b:=stop/goal", "stop/goal:=", ":=stop/goal", "stop/goal:=/", "9:=x", "x:=~", "x:=é", "x:=a~b"):
            self.assert_refused("'.*' in '.*' is not a valid name of a topic, service or action; allowed: letters, digits", word)

    def test_that_are_no_parameter_are_refused(self):
        for word in ("_:=1", "_a b:=1", "_a-b:=1", "_~a:=1"):
            self.assert_refused("'.*' is not a valid name of a parameter; allowed: letters, digits", word)

    def test_that_are_no_master_are_refused(self):
        for master in ("localhost", "http://localhost", "http://:11311", "http://localhost:0", "http://localhost:x", "http://localhost:70000", "11311"):
            self.assert_refused("__master is '.*'; allowed: http://host:port", f"__master:={master}")
            self.assert_refused("ROS_MASTER_URI is '.*'; allowed: http://host:port", env={**NOWHERE, "ROS_MASTER_URI": master})
        without = {name: value for name, value in NOWHERE.items() if name != "ROS_MASTER_URI"}
        self.assert_refused("ROS_MASTER_URI is not set", env=without)
        self.assert_refused("__tcpros_server_port is 'x'; allowed: a port from 0 to 65535", "__tcpros_server_port:=x")

    def test_that_are_names_are_taken(self):
        for node in NODES:
            with subprocess.Popen([node, "__name:=robot_1", "__ns:=//cell/a1/", "__master:=", "__tcpros_server_port:=0", "__log:=/dev/null",
                                   "~a/b:=/c", "stop/goal:=/x/1", "_a/b:=a b"], env=NOWHERE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True) as process:
                said = process.stdout.readline()
                process.kill()
            self.assertIn("Failed to contact master", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
