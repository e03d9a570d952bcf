"""What the rostests share: a robot with its action clients, its status, and the operator's side of the simulator.

Nothing here sleeps to synchronise: every wait is for a condition, with a deadline.
"""
import threading
import unittest

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, Trigger

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, MoveAbsoluteAction, MoveAbsoluteGoal,
                               RobotStatus, Transformation)
from cobot_command.srv import RaiseError, SetFault, SetInput, SetProjectSpeed

DEADLINE = 30.0  # [s] of wall time; far beyond what anything here takes
CONTROLLER = "simulated_controller"
OPERATOR_SERVICES = {  # all others are Triggers
    "raise_error": RaiseError, "set_emergency_stop": SetBool, "set_fault": SetFault, "set_input": SetInput,
    "set_manual_mode": SetBool, "set_project_speed": SetProjectSpeed, "set_safeguard": SetBool}


class Latest:
    """The newest message of a topic, and a way to wait for one that fulfils a condition."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self.message = None
        self._subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=100)

    def _take(self, message):
        with self._changed:
            self.message = message
            self._changed.notify_all()

    def wait_for(self, condition, what):
        with self._changed:
            if not self._changed.wait_for(lambda: self.message is not None and condition(self.message), DEADLINE):
                raise AssertionError(f"{what} did not come within {DEADLINE} s; the last message:\n{self.message}")
            return self.message


class Robot:
    """One command node with its simulated controller."""

    def __init__(self, namespace=""):
        self.namespace = namespace
        self.connect = actionlib.SimpleActionClient(self.name_of("connect"), ConnectAction)
        self.move = actionlib.SimpleActionClient(self.name_of("move_absolute"), MoveAbsoluteAction)
        self.status = self.latest("command_status", CommandStatus)
        self.robot_status = self.latest("robot_status", RobotStatus)
        self.joints = self.latest("joint_states", JointState)
        self.tool_pose = self.latest("tool_pose", PoseStamped)
        self.true_joints = self.latest(f"{CONTROLLER}/joint_states", JointState)
        self.true_status = self.latest(f"{CONTROLLER}/status", RobotStatus)
        for client in (self.connect, self.move):
            if not client.wait_for_server(rospy.Duration(DEADLINE)):
                raise AssertionError(f"no server for {client.action_client.ns}")

    def name_of(self, name):
        return f"{self.namespace}/{name}" if self.namespace else name

    def latest(self, topic, kind):
        return Latest(self.name_of(topic), kind)

    # --- The operator's side of the simulated controller.
    def port(self, name="script_port"):
        parameter = self.name_of(f"{CONTROLLER}/listening/{name}")
        wait_until(lambda: rospy.has_param(parameter), "the controller's port")
        return rospy.get_param(parameter)

    def operate(self, service, *arguments):
        """Calls a service of the simulated controller; returns what it says."""
        answer = self.try_to(service, *arguments)
        if not answer.success:
            raise AssertionError(f"{service} failed: {answer.message}")
        return answer.message

    def try_to(self, service, *arguments):
        """The same, and returns its whole answer."""
        name = self.name_of(f"{CONTROLLER}/{service}")
        rospy.wait_for_service(name, DEADLINE)
        return rospy.ServiceProxy(name, OPERATOR_SERVICES.get(service, Trigger))(*arguments)

    def fault(self, name, active=True, count=0, seconds=0.0, text=""):
        """Turns a fault of the world on (standing, or for the next `count` times) or off; see doc/simulator.md."""
        return self.operate("set_fault", name, active, count, seconds, text)

    def reset(self):
        """The controller as it was at the start, but for where its arm is; without a link."""
        self.operate("clear_faults")
        self.operate("set_emergency_stop", False)
        self.operate("set_safeguard", False)
        self.operate("set_manual_mode", False)
        self.operate("set_project_speed", 100)
        self.operate("run_project")
        self.operate("clear_error")
        self.operate("resume_project")
        self.operate("enter_listen_node")
        self.close()

    # --- Connect.
    def send_connect(self, **changes):
        goal = ConnectGoal(host="127.0.0.1", port=self.port(), status_port=self.port("status_port"), timeout=20.0)
        for name, value in changes.items():
            setattr(goal, name, value)
        self.connect.send_goal(goal)

    def establish(self):
        """Connects, and waits until commands can be sent and positions come in."""
        self.send_connect()
        self.status.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")

    def close(self):
        self.connect.cancel_all_goals()
        self.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the end of the link")

    # --- MoveAbsolute.
    def run(self, goal):
        """Sends the goal; returns (final state, result)."""
        self.move.send_goal(goal)
        return self.finish()

    def finish(self):
        return finish(self.move)


def finish(client):
    if not client.wait_for_result(rospy.Duration(DEADLINE)):
        raise AssertionError("the goal did not end")
    return client.get_state(), client.get_result()


def to_joints(*degrees, **changes):
    return with_changes(
        MoveAbsoluteGoal(movement_command=MoveAbsoluteGoal.PTP, data_format=MoveAbsoluteGoal.JPP,
                         target_position=Transformation(*degrees), speed=80, accel_time=200,
                         precise_positioning=True), changes)


def ptp_to(*pose, **changes):
    return with_changes(to_joints(*pose), {"data_format": MoveAbsoluteGoal.CPP, **changes})


def line_to(*pose, **changes):
    return with_changes(
        to_joints(*pose), {"movement_command": MoveAbsoluteGoal.LINE, "data_format": MoveAbsoluteGoal.CAP,
                           "speed": 250, **changes})


def with_changes(goal, changes):
    for name, value in changes.items():
        if not hasattr(goal, name):
            raise AttributeError(name)
        setattr(goal, name, value)
    return goal


def wait_until(condition, what):
    deadline = rospy.Time.now() + rospy.Duration(DEADLINE)
    rate = rospy.Rate(100)
    while not condition():
        if rospy.Time.now() > deadline:
            raise AssertionError(f"{what} did not come within {DEADLINE} s")
        rate.sleep()


class OutcomeTestCase(unittest.TestCase):
    """What is expected of the (state, result) of a goal."""

    def assert_rejected(self, outcome, error_id, words=""):
        self._assert_error(GoalStatus.REJECTED, outcome, error_id, words)

    def assert_aborted(self, outcome, error_id, words=""):
        self._assert_error(GoalStatus.ABORTED, outcome, error_id, words)

    def assert_done(self, outcome):
        state, result = outcome
        self.assertEqual(result.error_id, 0, result.error_description)
        self.assertEqual(state, GoalStatus.SUCCEEDED)

    def _assert_error(self, expected_state, outcome, error_id, words):
        state, result = outcome
        self.assertEqual(hex(result.error_id), hex(error_id), result.error_description)
        self.assertEqual(state, expected_state, result.error_description)
        self.assertTrue(result.remedy, "an error has a remedy")
        self.assertIn(words.lower(), result.error_description.lower())


class CobotTestCase(OutcomeTestCase):
    """Each test starts with a running project in its Listen node, nothing that holds the arm, no fault and no link."""

    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()

    def setUp(self):
        self.robot.reset()
