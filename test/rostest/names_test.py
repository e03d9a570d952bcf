#!/usr/bin/env python3
"""Nodes that are started with names which they have for something else: they end with a sentence, and never by an abort."""
import signal
import sys

import rosnode
import rospy

from cobot_test import OutcomeTestCase, program
from own_nodes import Heard
from waiting import wait_until

PARAMETERS = {"command_node": ["_robot_model:=tm5-900"],
              "simulated_controller_node": ["_robot_model:=tm5-900", "_script_port:=0", "_status_port:=0"]}
# What a node renames to what it has already: topics of two types, publishers and subscribers, services, and those of libraries.
TAKEN = {"command_node": ("stop/goal:=move_absolute/goal", "stop/goal:=joint_states", "joint_states:=stop/goal", "frames:=joint_states",
                          "move_absolute/result:=stop/result", "read_tool:=write_tool", "finish:=reset", "/tf_static:=joint_states", "/diagnostics:=tool_pose",
                          "jog_keep_alive:=stop/cancel", "tool_pose:=/rosout", "planned_path:=planned_points", "interrupt:=~get_loggers"),
         "simulated_controller_node": ("~joint_states:=~status", "~set_input:=~set_tcp", "~status:=/rosout")}


class ANameThatIsTaken(OutcomeTestCase):
    def test_ends_the_node_with_2_and_a_sentence(self):
        for kind, renamings in TAKEN.items():
            for renaming in renamings:
                with self.subTest(kind, renaming=renaming):
                    process = Heard(program(kind), "__name:=starting", *PARAMETERS[kind], renaming)
                    self.addCleanup(process.clear_away)
                    self.assertEqual(process.wait(), 2, process.output())
                    self.assertRegex(process.output(), f"{kind}: a name of this node cannot be used: .*, named '")

    def test_of_the_same_type_is_no_fault(self):
        process = Heard(program("command_node"), "__name:=starting", "stop/cancel:=move_absolute/cancel", "status_frames:=frames", "foo:=joint_states")
        self.addCleanup(process.clear_away)
        wait_until(lambda: rosnode.rosnode_ping("/starting", max_count=1) or not process.is_alive(), "the node")
        self.assertEqual(process.end(signal.SIGINT)[0], 0, process.output())


if __name__ == "__main__":
    import rostest

    rospy.init_node("names_test")
    rostest.rosrun("cobot_command", "names", ANameThatIsTaken, sys.argv)
