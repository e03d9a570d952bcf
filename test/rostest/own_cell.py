"""A cell that a test launches, with what it offers, and ends."""
import os
import signal
import tempfile
import xmlrpc.client

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from std_srvs.srv import SetBool, Trigger

from cobot_command.msg import BuildCellAction, CellRobot, CellState, CommandStatus, RunCellAction, RunProgramGoal
from cobot_command.srv import ConfirmClear, RecoverRobot, TakeOut
from cobot_test import Latest, OutcomeTestCase, Robot, Sent, program
from own_nodes import Heard
from waiting import DEADLINE, wait_until

NAMES = ("RA", "RB")  # of the cells that are launched without a word
SERVICES = {"hold": SetBool, "finish": SetBool, "stop": Trigger, "recover": RecoverRobot, "confirm_clear": ConfirmClear,
            "take_out": TakeOut}


class CellTestCase(OutcomeTestCase):
    """Each test has a cell of its own, whose robots stand at home."""
    names = NAMES
    time_scale = 10

    def setUp(self):
        self.artifact = rospy.get_param("~artifact")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.journal = os.path.join(folder.name, "cell.journal")
        self.state = Latest("/cell/state", CellState)
        self.launch_robots()
        self.supervisor = self.start_supervisor()
        self.robots = {name: Robot("/" + name) for name in self.names}
        self.wait_for_mode(CellState.READY)
        # A robot stands where it has to as soon as its status is heard; commands it takes when its script link is up, too.
        for robot in self.robots.values():
            robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a ready link")

    def launch_robots(self):
        robots = self.start("roslaunch", "cobot_command", "cell.launch", f"artifact:={self.artifact}", "supervisor:=false", f"time_scale:={self.time_scale}", ends_by=signal.SIGINT)
        self.addCleanup(lambda: self.assertTrue(robots.is_alive(), "the robots ended by themselves:\n" + robots.output()))

    def start_supervisor(self):
        return self.start(program("cell_supervisor"), "__ns:=cell", "__name:=cell_supervisor",
                          f"_artifact:={self.artifact}", f"_journal:={self.journal}")

    def start(self, *command, ends_by=signal.SIGTERM):
        process = Heard(*command)

        def end():
            if process.is_alive():
                process.end(ends_by)
            process.clear_away()

        self.addCleanup(end)
        return process

    # --- What the supervisor offers.
    def ask(self, service, *arguments):
        """Returns its answer."""
        rospy.wait_for_service("/cell/" + service, DEADLINE)
        return rospy.ServiceProxy("/cell/" + service, SERVICES[service])(*arguments)

    def assert_granted(self, answer):
        self.assertTrue(answer.success, answer.message)

    def assert_denied(self, answer, words):
        self.assertFalse(answer.success, answer.message)
        self.assertIn(words, answer.message)

    def client(self, name, kind):
        client = actionlib.ActionClient("/cell/" + name, kind)
        self.assertTrue(client.wait_for_server(rospy.Duration(DEADLINE)), name)
        return client

    def send_run(self, goal):
        return Sent(self.client("run_cell", RunCellAction), goal)

    def send_build(self, goal):
        return Sent(self.client("build_cell", BuildCellAction), goal)

    def send_programs(self, cycles):
        sent = {name: robot.send(RunProgramGoal(cycles=cycles)) for name, robot in self.robots.items()}
        for name, goal in sent.items():
            if goal.wait_until_active().state() not in (GoalStatus.ACTIVE, GoalStatus.SUCCEEDED):
                self.fail(f"{name} did not begin: {goal.finish()}")
        return sent

    def recover_all(self):
        """Each that was stopped goes on from where it is."""
        for name in self.names:
            self.wait_for_robot(name, lambda r: r.state in (CellRobot.FAULT, CellRobot.READY), "at rest")
            robot = robot_in(self.state.message, name)
            if robot.state == CellRobot.FAULT:  # and reports by and by that it stands
                wait_until(lambda: self.ask("recover", name, robot.place, "Ann").success, f"{name}, recovered")

    # --- How things stand.
    def wait_for_mode(self, mode):
        return self.state.wait_for(lambda m: m.mode == mode, f"the mode {mode} of the cell")

    def wait_for_robot(self, name, condition, what):
        self.state.wait_for(lambda m: condition(robot_in(m, name)), f"{name} {what}")

    def wait_until_it_holds_a_zone(self, name):
        state = self.state.wait_for(lambda m: any(z.owner == name for z in m.zones), f"a zone of {name}")
        return next(zone.name for zone in state.zones if zone.owner == name)


def robot_in(state, name):
    return next(robot for robot in state.robots if robot.name == name)


def kill(name):
    """The node of that name, at once and without a farewell."""
    os.kill(pid_of(name), signal.SIGKILL)


def pid_of(name):
    uri = rosgraph.Master("/test").lookupNode(name)
    return xmlrpc.client.ServerProxy(uri).getPid("/test")[2]
