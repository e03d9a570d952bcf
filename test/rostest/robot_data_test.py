#!/usr/bin/env python3
"""What the robot is, and which functions the node offers."""
import rosservice
import rospy

from cobot_command.msg import RobotData
from cobot_test import CobotTestCase, Latest


class RobotDataTest(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.data = Latest("robot_data", RobotData)

    def test_has_what_the_controller_tells_beside_its_stream(self):
        self.establish_at_home()
        told = self.data.wait_for(lambda m: not m.unknown, "what the controller is")
        self.assertEqual((told.maker, told.model, told.controller_model), ("Techman Robot", "tm5-900", "TM5-900"))
        self.assertEqual(told.control_box_sn, "SIMULATED")
        self.assertTrue(told.tmflow_version.startswith("1."), told.tmflow_version)
        self.assertRegex(told.layer_version, r"^\d+\.\d+\.\d+$")
        self.assertEqual([(axis.lower_limit, axis.upper_limit, axis.rated_speed) for axis in told.axes][2:4],
                         [(-155, 155, 180), (-180, 180, 225)])
        self.assertEqual(len(told.axes), 6)

    def test_offers_what_is_there(self):
        told = self.data.wait_for(lambda m: m.supported, "the functions")
        there = {f"service {name.strip('/')}" for name in rosservice.get_service_list()}
        for topic, _ in rospy.get_published_topics():
            name = topic.strip("/")
            there |= {f"topic {name}", f"action {name.replace('/status', '')}"}
        for function in told.supported:
            self.assertTrue(function.interfaces, function.name)
            self.assertEqual([name for name in function.interfaces if name not in there], [], function.name)
        for function in told.unsupported:
            self.assertTrue(function.reason, function.name)


if __name__ == "__main__":
    import rostest

    rospy.init_node("robot_data_test")
    rostest.rosrun("cobot_command", "robot_data", RobotDataTest)
