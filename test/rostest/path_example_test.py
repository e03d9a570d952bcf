#!/usr/bin/env python3
"""The example of load_path finds that the simulated robot goes where it should, and when."""
import re
import subprocess
import unittest

import rospy

from cobot_test import program


class PathExample(unittest.TestCase):
    def test_is_driven_as_it_was_planned(self):
        done = subprocess.run([program("load_path.py")], capture_output=True, text=True, timeout=100, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("blends lost: none; sent as one PVT", done.stdout)
        # The second goal has joined the first: nothing is lost between them.
        self.assertEqual(len(re.findall(r"(?m)^  (?:first|second): SUCCEEDED .*; blends lost: none$", done.stdout)), 2, done.stdout)
        self.assertIn("both were sent as 2 PVTs", done.stdout)
        self.assertIn("All paths are done", done.stdout)


if __name__ == "__main__":
    import rostest

    rospy.init_node("path_example_test")
    rostest.rosrun("cobot_command", "path_example", PathExample)
