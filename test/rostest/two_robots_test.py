#!/usr/bin/env python3
"""Two robots of different models at the same time: what happens to one is nothing to the other."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

from cobot_command.msg import MoveAbsoluteGoal, RobotStatus, StopGoal
from cobot_goals import HOME, ptp_to, to_joints
from cobot_test import OutcomeTestCase, Robot
from waiting import wait_until

TARGETS = {"left": (60, -20, 100, 10, 80, -45), "right": (-50, 15, 80, -10, 95, 30)}
SLOWLY = {"speed": 1, "accel_time": 1000}  # the other robot can be dealt with meanwhile


class TwoRobots(OutcomeTestCase):
    @classmethod
    def setUpClass(cls):
        cls.robots = {name: Robot(name) for name in TARGETS}
        cls.left, cls.right = cls.robots["left"], cls.robots["right"]

    def setUp(self):
        for robot in self.robots.values():
            robot.reset()
            robot.establish()
        self.send_both(lambda name: to_joints(*HOME))
        for sent in self.sent.values():
            self.assert_done(sent.finish())

    # --- Side by side.
    def test_move_at_once_each_to_its_own_target(self):
        self.start_both(speed=5, accel_time=1000)
        for name, robot in self.robots.items():
            self.assert_done(self.sent[name].finish())
            self.assert_stands_at(robot, TARGETS[name])

    def test_go_to_where_the_same_pose_is_for_each_model(self):
        self.send_both(lambda name: ptp_to(450, 100, 500, 180, 0, 60))
        for name, robot in self.robots.items():
            self.assert_done(self.sent[name].finish())
            robot.tool_pose.wait_for(lambda m: math.dist(
                (m.pose.position.x, m.pose.position.y, m.pose.position.z), (0.45, 0.1, 0.5)) < 1e-5, "the tool there")
        left, right = (robot.true_joints.message.position for robot in (self.left, self.right))
        self.assertGreater(max(abs(a - b) for a, b in zip(left, right)), 0.01, "the arms are of different lengths")

    # --- Names.
    def test_name_their_joints_apart(self):
        for name, robot in self.robots.items():
            for joints in (robot.joints, robot.true_joints):
                message = joints.wait_for(lambda m: True, "a position")
                self.assertEqual({joint.split("_")[0] for joint in message.name}, {name})

    def test_have_frames_that_do_not_mix(self):
        parents = {}

        def take(message):
            for transform in message.transforms:
                parents.setdefault(transform.child_frame_id, set()).add(transform.header.frame_id)

        subscribers = [rospy.Subscriber(topic, TFMessage, take, queue_size=1000) for topic in ("/tf", "/tf_static")]
        chain = ["active_tool", "tool0"]
        wait_until(lambda: all(f"{name}_{frame}" in parents for name in self.robots for frame in chain),
                   "the frames of both robots")
        for subscriber in subscribers:
            subscriber.unregister()
        for child, of_child in parents.items():
            self.assertEqual(len(of_child), 1, f"{child} has several parents: {of_child}")
            self.assertEqual(child.split("_")[0], next(iter(of_child)).split("_")[0], f"{child} in {of_child}")

    def test_refuse_a_target_in_a_frame_of_the_other(self):
        pose = Pose(Point(0.45, 0.1, 0.5), Quaternion(1, 0, 0, 0))
        for name, other in (("left", "right"), ("right", "left")):
            goal = MoveAbsoluteGoal(movement_command=MoveAbsoluteGoal.PTP, data_format=MoveAbsoluteGoal.CPP, speed=50,
                                    accel_time=300)
            for frame in (f"{name}_base", f"{other}_base"):
                goal.target_pose = PoseStamped(Header(frame_id=frame), pose)
                outcome = self.robots[name].run(goal)
                if frame.startswith(name):
                    self.assert_done(outcome)
                else:
                    self.assert_rejected(outcome, 0x217, frame)

    # --- What happens to one.
    def test_go_on_when_the_other_is_stopped(self):
        self.start_both(**SLOWLY)
        self.assert_done(self.left.run(StopGoal()))
        state, _ = self.sent["left"].finish()
        self.assertEqual(state, GoalStatus.PREEMPTED)
        self.assert_right_arrives()

    def test_go_on_when_the_goal_of_the_other_is_cancelled(self):
        self.start_both(**SLOWLY)
        self.sent["left"].cancel()
        state, _ = self.sent["left"].finish()
        self.assertEqual(state, GoalStatus.PREEMPTED)
        self.assert_right_arrives()

    def test_go_on_when_the_other_has_an_emergency_stop(self):
        self.start_both(**SLOWLY)
        self.left.operate("set_emergency_stop", True)
        state, result = self.sent["left"].finish()
        self.assertEqual(state, GoalStatus.ABORTED, result.error_description)
        self.left.true_status.wait_for(lambda s: s.e_stopped == RobotStatus.TRUE, "the emergency stop")
        self.assertEqual(self.right.robot_status.message.e_stopped, RobotStatus.FALSE)
        self.assert_right_arrives()

    def test_go_on_when_the_link_of_the_other_is_lost(self):
        self.start_both(**SLOWLY)
        self.left.operate("drop_connections")
        self.assert_aborted(self.left.connect.finish(), 0x90)
        self.assert_right_arrives()

    # --- Helpers.
    def send_both(self, goal_of):
        self.sent = {name: robot.send(goal_of(name)) for name, robot in self.robots.items()}

    def start_both(self, **changes):
        """Sends each towards its target, and returns when both are on their way."""
        self.send_both(lambda name: to_joints(*TARGETS[name], **changes))
        for sent in self.sent.values():
            sent.wait_until_active()
        wait_until(lambda: all(max(abs(v) for v in robot.true_joints.message.velocity) > 0.001
                               for robot in self.robots.values()), "both arms in motion")

    def assert_right_arrives(self):
        self.assertEqual(self.sent["right"].state(), GoalStatus.ACTIVE)
        self.assert_done(self.sent["right"].finish())
        self.assert_stands_at(self.right, TARGETS["right"])

    def assert_stands_at(self, robot, degrees):
        """The truth of the robot's own simulator, and what its status stream says of it."""
        wanted = [math.radians(value) for value in degrees]
        for joints in (robot.true_joints, robot.joints):
            joints.wait_for(lambda m: max(abs(a - b) for a, b in zip(m.position, wanted)) < 1e-5
                            and max(abs(v) for v in m.velocity) < 1e-6, f"the arm of {robot.namespace} at {degrees}")


if __name__ == "__main__":
    import rostest

    rospy.init_node("two_robots_test")
    rostest.rosrun("cobot_command", "two_robots", TwoRobots)
