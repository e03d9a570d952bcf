#!/usr/bin/env python3
"""control_msgs, from source, in one catkin workspace with this package: found, and made before what needs it.

Usage: workspace_test.py CMAKE NINJA TOPLEVEL SOURCES; WORKSPACE_OPTIONS: how the workspace is configured
Nothing is compiled: what Ninja would do says what waits for what.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE, NINJA, TOPLEVEL, SOURCES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4])
OPTIONS = os.environ["WORKSPACE_OPTIONS"].split(";")
# As in a shell in which nothing was sourced: the first build of a workspace, when the order of its packages counts.
PLAIN = {name: value for name, value in os.environ.items()
         if name not in ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "ROS_DISTRO", "ROS_PACKAGE_PATH", "DESTDIR")}
MESSAGE = "control_msgs/FollowJointTrajectoryAction.msg"


def run(*words):
    done = subprocess.run(words, env=PLAIN, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


class ControlMsgsInTheSameWorkspace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        packages = cls.folder / "src"
        packages.mkdir()
        (packages / "CMakeLists.txt").symlink_to(TOPLEVEL)
        (packages / "cobot_command").symlink_to(SOURCES)
        (packages / "control_msgs").symlink_to(SOURCES / "test" / "control_msgs")
        cls.build = cls.folder / "build"
        cls.configure()

    @classmethod
    def configure(cls):
        return run(CMAKE, "-S", cls.folder / "src", "-B", cls.build, "-GNinja", f"-DCMAKE_MAKE_PROGRAM={NINJA}",
                   f"-DCATKIN_DEVEL_PREFIX={cls.folder / 'devel'}", "-DCOBOT_BUILD_TESTS=OFF",
                   "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *OPTIONS)

    def test_is_found_and_made_before_the_action_that_needs_it(self):
        commands = json.loads((self.build / "compile_commands.json").read_text(encoding="utf-8"))
        [action] = [each for each in commands if each["file"].endswith("/actions/follow_joint_trajectory.cpp")]
        self.assertIn("COBOT_HAS_CONTROL_MSGS", action["command"])
        compiled = action["command"].split(" -o ")[1].split()[0]
        self.assertIn(f"Generating C++ code from {MESSAGE}", run(NINJA, "-C", self.build, "-n", compiled))

    def test_can_be_configured_a_second_time(self):
        self.configure()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[5:]])
