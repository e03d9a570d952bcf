#!/usr/bin/env python3
"""check_layers.py finds what it is for."""
import pathlib
import tempfile
import unittest

import check_layers

ROS = ("ros/ros.h", "rospack/rospack.h", "xmlrpcpp/XmlRpc.h", "diagnostic_updater/diagnostic_updater.h",
       "dynamic_reconfigure/server.h", "tf/tf.h", "tf2_ros/buffer.h", "actionlib/server/action_server.h", "std_msgs/Header.h",
       "std_srvs/Trigger.h", "eigen_conversions/eigen_msg.h", "cobot_command/RobotStatus.h")
CORE = ("string", "sys/stat.h", "boost/asio/post.hpp", "kdl/frames.hpp", "tinyxml2.h", "other.h", "cobot_command/common/time.h")


def faults_of(line, room="link", wing="", where="src"):
    with tempfile.TemporaryDirectory() as root:
        folder = pathlib.Path(root, where, room, wing)
        folder.mkdir(parents=True)
        (folder / "some.cpp").write_text(f"// words\n{line}\n", encoding="utf-8")
        return list(check_layers.faults(pathlib.Path(root)))


class CheckLayers(unittest.TestCase):
    def test_finds_ros_in_the_core(self):
        for header in ROS:
            for line in (f"#include <{header}>", f'#include "{header}"', f"  # include <{header}>"):
                with self.subTest(line):
                    self.assertEqual(len(faults_of(line)), 1)
                    self.assertIn("some.cpp:2: link/ is core and must not include ROS", faults_of(line)[0])

    def test_finds_rooms_above(self):
        for line in ('#include "cobot_command/blocks/list/goal.h"', "#include <cobot_command/blocks/list/goal.h>"):
            self.assertIn("link/ may not use blocks/", "".join(faults_of(line)))

    def test_finds_what_a_wing_may_not_use(self):
        for line in ('#include "core_impl.h"', '#include "stops/stop_run.h"', '#include "cobot_command/command/command_core.h"'):
            self.assertIn("the wing command/board may not use", "".join(faults_of(line, "command", "board")))
        self.assertIn("the wing blocks/shared", "".join(faults_of('#include "cobot_command/blocks/list/goal.h"', "blocks", "shared")))

    def test_leaves_what_a_wing_may_use(self):
        for line in ('#include "runs/command_run.h"', '#include "forecast/forecast.h"', '#include "stops/stop_run.h"'):
            self.assertEqual(faults_of(line, "command", "runs"), [])
        self.assertEqual(faults_of('#include "stops/stop_run.h"', "command"), [])
        self.assertEqual(faults_of('#include "cobot_command/command/actions.h"', "command", "board"), [])
        self.assertEqual(faults_of('#include "stops/stop_run.h"', "command", "board", "test/unit"), [])

    def test_finds_the_simulator_beside_the_command_layer(self):
        for place in (("runtime", "command"), ("ros", "command"), ("ros", "actions"), ("ros", "shared")):
            for header in ("simulator/settings.h", "runtime/simulation/simulator_runtime.h"):
                self.assertIn("may not use", "".join(faults_of(f'#include "cobot_command/{header}"', *place)), (place, header))
        self.assertIn("ros/simulation/ may not use runtime/command/ (allowed: arm",
                      "".join(faults_of('#include "cobot_command/runtime/command/command_runtime.h"', "ros", "simulation")))
        for line in ('#include "simulation/simulated_clock.h"', '#include "cobot_command/runtime/simulation/simulator_setup.h"'):
            self.assertIn("the wing runtime/command may not use", "".join(faults_of(line, "runtime", "command")))

    def test_leaves_what_each_of_both_sides_uses(self):
        for room, wing, header in (("runtime", "command", "runtime/shared/end_signals.h"), ("ros", "simulation", "simulator/settings.h"),
                                   ("ros", "command", "runtime/command/command_runtime.h"), ("ros", "actions", "RobotPose.h")):
            self.assertEqual(faults_of(f'#include "cobot_command/{header}"', room, wing), [])

    def test_finds_nothing_else(self):
        for header in CORE:
            for line in (f"#include <{header}>", f'#include "{header}"', f"// as in {header}"):
                with self.subTest(line):
                    self.assertEqual(faults_of(line), [])
        self.assertEqual(faults_of("#include <ros/ros.h>", "ros"), [])


if __name__ == "__main__":
    unittest.main()
