"""A simulated controller and a command node that a test starts and ends by itself."""
import math

import rospy

from cobot_goals import HOME, relative, to_joints, turn
from cobot_test import OutcomeTestCase, Robot
from own_nodes import node

FAR = 150  # [deg], at 5 % of 180 deg/s: 17 s
PORTS = "simulated_controller/listening"
SIMULATOR = {"robot_model": "tm5-900", "script_port": 0, "status_port": 0}


def angle(joints):
    return math.degrees(joints.position[0])


class OwnRobotTestCase(OutcomeTestCase):
    """A simulated controller and a command node for each test."""

    def setUp(self):
        self.robot = Robot()
        self.start_simulator()
        self.robot.true_joints.wait_for(lambda m: True, "the arm")

    def start_simulator(self):
        if rospy.has_param(PORTS):
            rospy.delete_param(PORTS)  # of the one before
        self.simulator = self.start("simulated_controller_node", "simulated_controller", **SIMULATOR)

    def start(self, kind, name, **parameters):
        process = node(kind, name, **parameters)
        self.addCleanup(process.clear_away)
        return process

    def start_command_node(self, **parameters):
        self.robot = Robot()  # its clients have to find the new node
        return self.start("command_node", "command_node", robot_model="tm5-900", **parameters)

    def go_home(self):
        self.robot.establish()
        self.assert_done(self.robot.run(to_joints(*HOME, speed=100)))

    def start_far(self, speed=5):
        """A motion that takes long, on its way."""
        sent = self.robot.send(turn(FAR, 0, 0, 0, 0, 0, speed=speed)).wait_until_active()
        self.wait_until_it_moves()
        return sent

    def wait_until_it_moves(self):
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) > 0.02, "the motion of the arm")

    def assert_stops_on_its_way(self):
        last = self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")
        self.assertLess(angle(last), FAR - 20)

    def assert_works(self):
        """A new link, and a motion over it."""
        self.go_home()
        self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))
