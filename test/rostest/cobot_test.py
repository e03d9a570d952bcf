"""What the rostests share: a robot with its action clients, its status, and the operator's side of the simulator.

Nothing here sleeps to synchronise: every wait is for a condition, with a deadline.
"""
import collections
import contextlib
import itertools
import sys
import threading
import traceback
import unittest

import actionlib
import roslib.packages
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, Trigger

import cobot_command.msg
from cobot_command.msg import ActiveFrames, CommandStatus, ConnectGoal, RobotStatus
from cobot_command.srv import Finish, RaiseError, SetBase, SetFault, SetInput, SetLoad, SetProjectSpeed, SetTcp
import provoked_errors
from cobot_goals import HOME, SLOWLY, to_joints, turn, with_changes
from waiting import DEADLINE, wait_until

CONTROLLER = "simulated_controller"
OPERATOR_SERVICES = {  # all others are Triggers
    "raise_error": RaiseError, "set_base": SetBase, "set_emergency_stop": SetBool, "set_fault": SetFault, "set_input": SetInput,
    "set_load": SetLoad, "set_manual_mode": SetBool, "set_project_speed": SetProjectSpeed, "set_safeguard": SetBool, "set_tcp": SetTcp}


class Latest:
    """The newest message of a topic, and a way to wait for one that fulfils a condition."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self.message = None
        self._messages = collections.deque(maxlen=1000)
        self._count = 0  # of all that came
        self._subscriber = rospy.Subscriber(topic, kind, self._take, queue_size=100)

    def close(self):
        """Receives no more: others that publish on the topic count who is connected."""
        self._subscriber.unregister()

    def _take(self, message):
        with self._changed:
            self.message = message
            self._messages.append(message)
            self._count += 1
            self._changed.notify_all()

    def forget(self):
        """What came until now."""
        with self._changed:
            self.message = None
            self._messages.clear()

    def wait_for(self, condition, what):
        """The newest one that fulfils it, or one of those that come: several may come before this thread is woken."""
        with self._changed:
            seen = self._count - bool(self._messages)

            def find():
                nonlocal seen
                news = list(self._messages)[seen - self._count:] if seen < self._count else []
                seen = self._count
                return next((m for m in news if condition(m)), None)

            return self._await(find, what)

    def wait_for_any(self, condition, what):
        """The first one that fulfils it of all that came or will come: of events, the newest hides those before it."""
        with self._changed:
            return self._await(lambda: next((m for m in self._messages if condition(m)), None), what)

    def _await(self, find, what):
        found = self._changed.wait_for(find, DEADLINE)
        if found is None:
            raise AssertionError(f"{what} did not come within {DEADLINE} s; the last message:\n{self.message}")
        return found

    def all(self):
        with self._changed:
            return list(self._messages)

    def wait_for_return(self, before, away, back, what):
        """Until a message after `before` was `away`, however briefly, and the last one is `back`."""
        def find():
            since = list(itertools.dropwhile(lambda m: m is not before, self._messages))
            return since[-1] if any(away(m) for m in since) and back(since[-1]) else None

        with self._changed:
            self._await(find, what)


class Sent:
    """A goal on its way: its states, its feedback and its end, also while others are."""

    def __init__(self, client, goal):
        self._changed = threading.Condition()
        self.states = []
        self.feedback = []
        self.handle = client.send_goal(goal, self._transition, self._feedback)

    def _transition(self, handle):
        with self._changed:
            self.states.append(handle.get_goal_status())
            self._changed.notify_all()

    def _feedback(self, _, feedback):
        with self._changed:
            self.feedback.append(feedback)
            self._changed.notify_all()

    def _wait(self, condition, what):
        with self._changed:
            if not self._changed.wait_for(condition, DEADLINE):
                raise AssertionError(f"{what} did not come within {DEADLINE} s; states {self.states}, feedback "
                                     f"{self.feedback[-1:]}")

    def ended(self):
        return self.handle.get_comm_state() == actionlib.CommState.DONE

    def state(self):
        return self.handle.get_goal_status()

    def wait_until_known(self):
        """The server has it."""
        self._wait(lambda: self.handle.get_comm_state() != actionlib.CommState.WAITING_FOR_GOAL_ACK, "the known goal")
        return self

    def wait_until_active(self):
        """A client that cancels before the server's first word on a goal takes the goal for lost."""
        self._wait(lambda: self.ended() or self.state() == GoalStatus.ACTIVE, "the active goal")
        return self

    def wait_until_queued(self):
        self.wait_for_feedback(lambda f: f.place_in_queue > 0, "a place in the queue")
        return self

    def wait_for_feedback(self, condition, what, first=0):
        """The first feedback from that number on, old or new, that fulfils the condition."""
        self._wait(lambda: any(condition(f) for f in self.feedback[first:]), what)
        return next(f for f in self.feedback[first:] if condition(f))

    def cancel(self):
        """Unless it has ended: the client would forget its end and wait for another one."""
        with self.handle.comm_state_machine.mutex:
            if not self.ended():
                self.handle.cancel()

    def finish(self):
        """(final state, result)"""
        self._wait(self.ended, "the end of the goal")
        return self.handle.get_terminal_state(), self.handle.get_result()


class Robot:
    """One command node with its simulated controller."""

    def __init__(self, namespace=""):
        self.namespace = namespace
        self._clients = {}
        self.connect = None  # the last connect goal
        self.status = self.latest("command_status", CommandStatus)
        self.robot_status = self.latest("robot_status", RobotStatus)
        self.joints = self.latest("joint_states", JointState)
        self.tool_pose = self.latest("tool_pose", PoseStamped)
        self.active_frames = self.latest("active_frames", ActiveFrames)
        self.true_joints = self.latest(f"{CONTROLLER}/joint_states", JointState)
        self.true_status = self.latest(f"{CONTROLLER}/status", RobotStatus)

    def name_of(self, name):
        return f"{self.namespace}/{name}" if self.namespace else name

    def latest(self, topic, kind):
        return Latest(self.name_of(topic), kind)

    # --- Services of the command node.
    def finish(self, after):
        answer = self.try_to_finish(after)
        if not answer.success:
            raise AssertionError(f"finish failed: {answer.message}")

    def try_to_finish(self, after):
        name = self.name_of("finish")
        rospy.wait_for_service(name, DEADLINE)
        return rospy.ServiceProxy(name, Finish)(after)

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

    def clear_error(self):
        """By the operator; returns when the command layer has heard of it too."""
        self.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.operate("clear_error")
        self.robot_status.wait_for(lambda s: s.in_error == RobotStatus.FALSE, "the end of the error")

    # --- Connect.
    def connect_goal(self, **changes):
        return with_changes(ConnectGoal(host="127.0.0.1", port=self.port(), status_port=self.port("status_port"),
                                        timeout=20.0), changes)

    def send_connect(self, **changes):
        self.connect = self.send(self.connect_goal(**changes))

    def establish(self, **changes):
        """Connects, and waits until commands can be sent and positions come in."""
        self.send_connect(**changes)
        self.status.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")

    def close(self):
        if self.connect and not self.connect.wait_until_active().ended():
            self.connect.cancel()
            self.connect.finish()
        self.status.wait_for(lambda s: s.link_state == CommandStatus.DISCONNECTED, "the end of the link")

    # --- Commands.
    def client(self, block, namespace=""):
        """Of any block, also of another node that has the same controller; its first use costs some milliseconds."""
        name = self.name_of(namespace + block)
        if name not in self._clients:
            kind = {"change_tcp": "ChangeTCP"}.get(block) or block.title().replace("_", "")
            client = actionlib.ActionClient(name, getattr(cobot_command.msg, f"{kind}Action"))
            if not client.wait_for_server(rospy.Duration(DEADLINE)):
                raise AssertionError(f"no server for {name}")
            self._clients[name] = client
        return self._clients[name]

    def send(self, goal, namespace=""):
        return Sent(self.client(provoked_errors.block_of(goal), namespace), goal)

    def run(self, goal, namespace=""):
        """Sends the goal; returns (final state, result)."""
        return self.send(goal, namespace).finish()

    def run_and_reenter(self, goal):
        """Runs a goal that leaves the Listen node, and waits until the flow is there again."""
        before = self.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a ready link")
        outcome = self.run(goal)
        self.status.wait_for_return(before, lambda s: s.link_state == CommandStatus.NOT_LISTENING,
                                    lambda s: s.link_state == CommandStatus.READY, "the Listen node, entered again")
        return outcome

    def start_slowly(self, goal=None):
        """A motion that takes long, when the arm is on its way."""
        sent = self.send(goal or turn(60, 0, 0, 0, 0, 0, **SLOWLY)).wait_until_active()
        self.wait_for_motion()
        return sent

    def wait_for_motion(self):
        self.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) > 1e-3, "the motion of the arm")
        self.joints.wait_for(lambda m: max(abs(v) for v in m.velocity) > 1e-2, "the motion in the stream")

    def wait_for_standstill(self):
        for joints in (self.true_joints, self.joints):
            joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")

    def wait_for_time_to_pass(self, seconds):
        """Until the layer has taken in the controller's status for so long from now on: by its clock, not by ours."""
        until = rospy.Time.now() + rospy.Duration(seconds)
        self.robot_status.wait_for(lambda s: s.header.stamp >= until, f"{seconds} s")


def program(name):
    """Its path; rosrun passes over build folders."""
    return roslib.packages.find_node("cobot_command", name)[0]


class OutcomeTestCase(unittest.TestCase):
    """What is expected of the (state, result) of a goal."""

    @contextlib.contextmanager
    def subTest(self, *args, **params):
        """rosunit counts the failures of subtests, and does not say which; here they are told."""
        with super().subTest(*args, **params):
            try:
                yield
            except Exception:
                print(f"{self.id()} {args} {params}:\n{traceback.format_exc(limit=-2)}", file=sys.stderr, flush=True)
                raise

    def assert_rejected(self, outcome, error_id, words=""):
        self._assert_error(GoalStatus.REJECTED, outcome, error_id, words)

    def assert_aborted(self, outcome, error_id, words=""):
        self._assert_error(GoalStatus.ABORTED, outcome, error_id, words)

    def assert_done(self, outcome):
        """Returns the result."""
        state, result = outcome
        self.assertEqual(result.error_id, 0, result.error_description)
        self.assertEqual(state, GoalStatus.SUCCEEDED)
        return result

    def assert_ended(self, expected_state, outcome):
        """PREEMPTED or RECALLED."""
        state, result = outcome
        self.assertEqual(state, expected_state, result.error_description)
        self.assertEqual(result.error_id, 0, result.error_description)

    def _assert_error(self, expected_state, outcome, error_id, words):
        state, result = outcome
        self.assertEqual(hex(result.error_id), hex(error_id), result.error_description)
        self.assertEqual(state, expected_state, result.error_description)
        self.assertTrue(result.remedy, "an error has a remedy")
        self.assertIn(words.lower(), result.error_description.lower())
        provoked_errors.note(provoked_errors.block_of(result), error_id)


class CobotTestCase(OutcomeTestCase):
    """Each test starts with a running project in its Listen node, nothing that holds the arm, no fault and no link."""

    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()

    def setUp(self):
        self.robot.reset()

    def establish_at_home(self):
        self.robot.establish()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def assert_refuses(self, rows):
        """Rows of (goal, error id, words of the description)."""
        for goal, error_id, words in rows:
            with self.subTest(error_id=hex(error_id), words=words):
                self.assert_rejected(self.robot.run(goal), error_id, words)
