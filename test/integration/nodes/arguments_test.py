#!/usr/bin/env python3
"""What the nodes make of words on their command line, before they look for a master.

Usage: arguments_test.py COMMAND_NODE SIMULATED_CONTROLLER_NODE
"""
import os
import subprocess
import sys
import unittest

NODES = sys.argv[1:3]
NOWHERE = {**os.environ, "ROS_MASTER_URI": "http://localhost:1"}


def run(node, *words):
    return subprocess.run([node, *words], env=NOWHERE, capture_output=True, text=True, timeout=60, check=False)


class Arguments(unittest.TestCase):
    def test_ask_for_help(self):
        for node in NODES:
            for word in ("--help", "-h"):
                ended = run(node, "_robot_ip:=10.0.0.1", word)
                self.assertEqual((ended.returncode, ended.stderr), (0, ""), node)
                self.assertIn(f"usage: {os.path.basename(node)}", ended.stdout)

    def test_that_no_node_understands_are_refused(self):
        for node in NODES:
            for word in ("banana", "--robot_ip=10.0.0.1", "robot_ip=10.0.0.1", "", "\x1b[2J"):
                ended = run(node, "__name:=one", word)
                self.assertEqual((ended.returncode, ended.stdout), (2, ""), (node, word))
                self.assertIn("allowed: name:=value, --help", ended.stderr)
                self.assertNotIn("\x1b", ended.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
