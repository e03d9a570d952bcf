"""Faults of a running cell, one after the other in an order of chance: of the wire, of the robot, of its operator, of the
processes. Each is over after a moment, and everything as it was."""
import collections
import os
import random
import signal
import threading

import rospy
from std_srvs.srv import SetBool, Trigger

import process_watch
import soak_wire
from cobot_command.srv import RaiseError, SetFault, SetProjectSpeed
from waiting import wait_until

CONTROLLER = "simulated_controller"
SERVICES = {"raise_error": RaiseError, "set_emergency_stop": SetBool, "set_fault": SetFault,  # all others are Triggers
            "set_manual_mode": SetBool, "set_project_speed": SetProjectSpeed, "set_safeguard": SetBool}
DEADLINE = 60.0  # [s] for a service of a controller that has just been started
LONG, SHORT = 60.0, 3.0  # [s] of simulated time: longer and shorter than the layer's patience
# (fault, how often or 0: as long as it lasts, seconds, text)
WORLD = [(f"{kind}_{message}", count, seconds, "")
         for message in ("entry", "reply", "tag", "state", "tag_answer", "cperr")
         for kind, count, seconds in (("drop", 1, 0.0), ("duplicate", 3, 0.0), ("corrupt", 1, 0.0),
                                      ("delay", 1, SHORT), ("delay", 1, LONG))]
WORLD += [("refuse_script", 2, 0.0, "1;2"), ("ignore_script", 1, 0.0, ""), ("cperr_script", 2, 0.0, "04"),
          ("cperr_script", 1, 0.0, "F1"), ("wrong_id", 1, 0.0, ""), ("refuse_stop", 1, 0.0, ""),
          ("ignore_stop", 1, 0.0, ""), ("false_tag", 1, 0.0, ""), ("early_tag", 1, 0.0, ""),
          ("stale_tag", 3, 0.0, ""), ("silence", 0, 0.0, ""),
          ("close_on_connect", 0, 0.0, ""), ("refuse_connections", 0, 0.0, ""), ("impostor", 0, 0.0, ""),
          ("drop_stream", 0, 0.0, ""), ("corrupt_stream", 0, 0.0, ""), ("hide_items", 0, 0.0, "Joint_Angle Joint_Speed")]


class Faults(threading.Thread):
    """One every `period` seconds until it is stopped; `counts` of their names. `complain` is told what cannot be healed."""

    def __init__(self, seed, period, node_pid, complain, wire):
        super().__init__(name="faults", daemon=True)
        self._random = random.Random(f"{seed} faults")
        self._period, self._node_pid, self._complain, self._wire = period, node_pid, complain, wire
        self._stopping = threading.Event()
        self.counts = collections.Counter()
        self._rows = [(f.__name__.strip("_"), f) for f in (
            self._of_the_world, self._of_the_wire,
            self._the_project_stops, self._the_project_pauses, self._the_flow_leaves, self._emergency_stop,
            self._safeguard, self._manual_mode, self._robot_error, self._slow_project, self._connections_drop,
            self._controller_is_killed, self._controller_is_ended, self._controller_hangs, self._node_hangs)]

    def run(self):
        while not self._stopping.wait(self._period):
            # Most are of the world and of the wire: of those there are most.
            name, fault = self._random.choice(self._rows[:2] if self._random.random() < 0.6 else self._rows[2:])
            try:
                self.counts[fault() or name] += 1
                self._heal()
            except Exception as error:  # pylint: disable=broad-except
                self._complain(f"the fault '{name}' could not be brought about or healed: {error!r}")
                return

    def stop(self):
        self._stopping.set()
        self.join()

    def _lasts(self):
        """Its end comes at once when all is to end."""
        self._stopping.wait(self._random.choice((0.05, 0.5, 2.0)))

    def _call(self, service, *arguments):
        name = f"{CONTROLLER}/{service}"
        rospy.wait_for_service(name, DEADLINE)
        return rospy.ServiceProxy(name, SERVICES.get(service, Trigger))(*arguments)

    def _heal(self):
        self._wire.say("heal")
        for service, *arguments in (("clear_faults",), ("set_emergency_stop", False), ("set_safeguard", False),
                                    ("set_manual_mode", False), ("set_project_speed", 100), ("run_project",),
                                    ("clear_error",), ("resume_project",), ("enter_listen_node",)):
            answer = self._call(service, *arguments)
            if not answer.success:
                self._complain(f"{service} does not heal: {answer.message}")

    # --- The world.
    def _of_the_world(self):
        name, count, seconds, text = self._random.choice(WORLD)
        answer = self._call("set_fault", name, True, count, seconds, text)
        if not answer.success:
            self._complain(f"{name}: {answer.message}")
        self._lasts()
        return name

    def _of_the_wire(self):
        line = self._random.choice(soak_wire.FAULTS)
        self._wire.say(line)
        self._lasts()
        return " ".join(line.split()[:2])

    # --- The operator.
    def _the_project_stops(self):
        self._call("stop_project")
        self._lasts()

    def _the_project_pauses(self):
        self._call("pause_project")
        self._lasts()

    def _the_flow_leaves(self):
        self._call("leave_listen_node")
        self._lasts()

    def _emergency_stop(self):
        self._call("set_emergency_stop", True)
        self._lasts()

    def _safeguard(self):
        self._call("set_safeguard", True)
        self._lasts()

    def _manual_mode(self):
        self._call("set_manual_mode", True)
        self._lasts()

    def _robot_error(self):
        self._call("raise_error", self._random.choice((0x14058, 0x22, 1, -1)), "a fault")
        self._lasts()

    def _slow_project(self):
        self._call("set_project_speed", 5)
        self._lasts()

    def _connections_drop(self):
        self._call("drop_connections")

    # --- The processes.
    def _controller_is_killed(self):
        self._end_controller(signal.SIGKILL)

    def _controller_is_ended(self):
        self._end_controller(signal.SIGTERM)

    def _end_controller(self, how):
        """It is started again by whoever launched it."""
        before = process_watch.pid_of(CONTROLLER)
        os.kill(before, how)
        wait_until(lambda: self._has_come_back(before), "another simulated controller", DEADLINE)

    @staticmethod
    def _has_come_back(before):
        try:
            return process_watch.pid_of(CONTROLLER) != before
        except Exception:  # pylint: disable=broad-except
            return False  # its name is that of the dead one still, or nobody's

    def _controller_hangs(self):
        self._hang(process_watch.pid_of(CONTROLLER))

    def _node_hangs(self):
        self._hang(self._node_pid)

    def _hang(self, pid):
        os.kill(pid, signal.SIGSTOP)
        try:
            self._stopping.wait(self._random.choice((0.5, 2.0, 5.0)))
        finally:
            os.kill(pid, signal.SIGCONT)
