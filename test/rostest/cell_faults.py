"""Faults of a running cell, one after the other in an order of chance: of controllers, operators, nodes, the supervisor, people.
Each is over after a moment; what it has left is for a person to set right."""
import os
import random
import signal
import time

import rospy

import process_watch
from cobot_command.msg import StopActionGoal
from cobot_test import program
from own_cell import kill
from waiting import wait_until

LONGEST = 10.0  # [s]


class CellFaults:
    """`case` has the cell, and starts what is started anew. The first robot's node and the monitor are left alone, so that what they
    take of the machine can be measured."""

    def __init__(self, case, seed):
        self._case = case
        self._random = random.Random(seed)
        self._stops = {robot: rospy.Publisher(f"/{robot}/stop/goal", StopActionGoal, queue_size=1) for robot in case.robots}
        self.counts = {}

    def make(self):
        """Brings one about and ends it; returns its name."""
        robot = self._random.choice(list(self._case.robots))
        faults = {
            "robot error": lambda: self._operator(robot, ("raise_error", 0x14058, "a fault"), ("clear_error", )),
            "emergency stop": lambda: self._operator(robot, ("set_emergency_stop", True), ("set_emergency_stop", False),
                                                     ("run_project", )),
            "pause": lambda: self._operator(robot, ("pause_project", ), ("resume_project", )),
            "manual mode": lambda: self._operator(robot, ("set_manual_mode", True), ("set_manual_mode", False)),
            "stopped project": lambda: self._operator(robot, ("stop_project", ), ("run_project", )),
            "slow project": lambda: self._operator(robot, ("set_project_speed", 10), ("set_project_speed", 100)),
            "lost connections": lambda: self._operator(robot, ("drop_connections", )),
            "lost stream": lambda: self._world(robot, "drop_stream"),
            "early tag": lambda: self._world(robot, "early_tag"),
            "stop": lambda: self._stop(robot),
            "cancel": lambda: self._case.cancel(robot),
            "node that hangs": lambda: self._hang(robot),
            "node that is killed": lambda: self._kill_node(self._random.choice(list(self._case.robots)[1:])),
            "supervisor that is killed": self._kill_supervisor,
            "hold": lambda: self._people("hold"),
            "stop of all": lambda: self._people("stop"),
        }
        name = self._random.choice(sorted(faults))
        faults[name]()
        self.counts[name] = self.counts.get(name, 0) + 1
        return f"{name} ({robot})"

    def _lasts(self):
        """So long, whatever comes of it."""
        time.sleep(self._random.uniform(0.5, LONGEST))

    def _operator(self, robot, trouble, *relief):
        self._case.robots[robot].operate(*trouble)
        self._lasts()
        for action in relief:
            self._case.robots[robot].operate(*action)

    def _world(self, robot, fault):
        self._case.robots[robot].fault(fault, count=0 if fault == "drop_stream" else 1)
        self._lasts()
        self._case.robots[robot].fault(fault, active=False)

    def _stop(self, robot):
        wait_until(lambda: self._stops[robot].get_num_connections() > 0, f"the node of {robot}")
        self._stops[robot].publish(StopActionGoal())

    def _hang(self, robot):
        pid = process_watch.pid_of(f"/{robot}/command_node")
        os.kill(pid, signal.SIGSTOP)
        try:
            self._lasts()
        finally:
            os.kill(pid, signal.SIGCONT)

    def _kill_node(self, robot):
        name = f"/{robot}/command_node"
        kill(name)
        self._lasts()
        self._case.start(program("command_node"), f"__ns:=/{robot}", "__name:=command_node")
        self._case.forget(robot)

    def _kill_supervisor(self):
        self._case.supervisor.end(signal.SIGKILL)
        self._lasts()
        self._case.supervisor = self._case.start_supervisor()

    def _people(self, service):
        self._case.ask("hold", True) if service == "hold" else self._case.ask("stop")
        self._lasts()
        self._case.ask("hold", False)
