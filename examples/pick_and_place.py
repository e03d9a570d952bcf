#!/usr/bin/env python3
"""Runs pick-and-place cycles with the action `pick_and_place` and prints the result of each step.
Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Ctrl-C, SIGTERM and a closed terminal stop the robot. Exit status: 0 only if every step is Done, 1 if not, 2 if the command node or the steps
cannot be used.
"""
import argparse
import math
import signal
import sys
import time

import actionlib
import rospkg
import rospy
import yaml
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, PickAndPlaceAction, PickAndPlaceFeedback,
                               PickAndPlaceGoal)

CONNECT_TIMEOUT = 30.0  # [s]; the Connect block's own range is 10..300
STOP_TIMEOUT = CLOSE_TIMEOUT = 5.0  # [s]
STEPS_UNREADABLE = 0x256
MOVING = (PickAndPlaceFeedback.ACTIVE, PickAndPlaceFeedback.HELD)
END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
ROW = "{:>5} {:>5}  {:<17} {:<5} {:<4} {:<36} {:>9} {:>9} {:>4}  {}"


def main():
    arguments = parse_arguments()
    # With its own signal handlers, rospy would shut down before the robot can be stopped.
    rospy.init_node("pick_and_place", anonymous=True, disable_signals=True)
    for number in END_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup ignores SIGHUP
            signal.signal(number, interrupt)
    # Not SimpleActionClients: they would miss messages of the first moments (doc/actions/README.md).
    connect = actionlib.ActionClient("connect", ConnectAction)
    pick_and_place = actionlib.ActionClient("pick_and_place", PickAndPlaceAction)
    for client, name in ((connect, "connect"), (pick_and_place, "pick_and_place")):
        if not client.wait_for_server(rospy.Duration(CONNECT_TIMEOUT)):
            print(f"no action server {rospy.resolve_name(name)}: is the command node running?")
            return 2
    link = None
    try:
        if not is_there(arguments):
            link = connect.send_goal(ConnectGoal(host=arguments.host, port=arguments.port, timeout=CONNECT_TIMEOUT))
            if not is_ready(link):
                return 1
        return run(pick_and_place, arguments)
    except KeyboardInterrupt:
        return 1
    finally:
        if link:
            link.cancel()  # the normal end of Connect
            wait_for_end(link, CLOSE_TIMEOUT)


def interrupt(*_):
    """The first signal starts the shutdown; further signals are ignored."""
    for number in END_SIGNALS:
        signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", default="", help="address of the controller (default: that of an existing link, else the node's robot_ip)")
    parser.add_argument("--port", type=int, default=0, help="script port (default: that of an existing link, else the node's script_port)")
    parser.add_argument("--cycles", type=int, default=1,
                        help="number of cycles; 0: until interrupted (default: %(default)s)")
    parser.add_argument("--steps", default="package://cobot_command/config/pick_and_place.yaml",
                        help="YAML file with the steps, on the command node's machine (default: %(default)s)")
    return parser.parse_args(rospy.myargv()[1:])


def is_there(arguments):
    """Whether a link to the right controller exists already, of another connect goal or of ~auto_connect."""
    try:
        status = rospy.wait_for_message("command_status", CommandStatus, timeout=10.0)
    except rospy.ROSException:
        return False
    right = arguments.host in ("", status.host) and arguments.port in (0, status.port)
    return right and is_usable(status)


def is_usable(status):
    if status.link_state != CommandStatus.READY or not status.status_stream:
        return False
    print(f"connected to {status.host}:{status.port}, in Listen node \"{status.listen_node}\"\n")
    return True


def is_ready(link):
    """Waits until commands can be sent over the link. Its goal stays active; False if the goal has ended."""
    deadline = rospy.Time.now() + rospy.Duration(CONNECT_TIMEOUT + 5.0)
    while rospy.Time.now() < deadline:
        try:
            status = rospy.wait_for_message("command_status", CommandStatus, timeout=1.0)
        except rospy.ROSException:
            continue
        if link.get_comm_state() == CommState.DONE:
            break
        if is_usable(status):
            return True
    result = link.get_result()
    print("not connected: " + (f"{result.error_description} -> {result.remedy}" if result else "no answer"))
    return False


def run(client, arguments):
    table = Table(arguments.steps)
    goal = client.send_goal(PickAndPlaceGoal(steps_file=arguments.steps, cycles=arguments.cycles),
                            feedback_cb=lambda _, feedback: table.take(feedback))
    try:
        wait_for_end(goal)
    except KeyboardInterrupt:
        goal.cancel()
        wait_for_end(goal, STOP_TIMEOUT)
    result = goal.get_result()
    if goal.get_goal_status() == GoalStatus.SUCCEEDED:
        table.end("Done")
        print(f"\n{result.cycles_done} cycle(s), all steps Done")
        return 0
    if result is None:
        table.end("no answer")
        return 1
    error = f"16#{result.error_id:X}: {result.error_description} -> {result.remedy}"
    verdict = error if result.error_id else result.error_description
    table.end(f"Error {verdict}" if result.failed_step >= 0 else "interrupted")
    print(f"\nnot done, after {result.cycles_done} cycle(s): {verdict}")
    return 2 if result.error_id == STEPS_UNREADABLE else 1


def wait_for_end(goal, seconds=math.inf):
    """Waits for DONE and not for the status of the goal, because the status may arrive before the result."""
    deadline = time.monotonic() + seconds
    while goal.get_comm_state() != CommState.DONE and time.monotonic() < deadline:
        time.sleep(0.05)


class Table:
    """Prints a row for each step as soon as the feedback shows that the next step has begun."""

    def __init__(self, steps_file):
        self.steps = read_steps(steps_file)
        self.row = None        # (cycle, step) that is running
        self.planned = self.tag = 0
        self.began = self.stood = None
        print(ROW.format("cycle", "step", "name", "move", "fmt", "target [mm, deg]", "planned", "actual", "tag",
                         "result"))

    def take(self, feedback):
        if feedback.step < 0:
            return
        row, now = (feedback.cycle, feedback.step), rospy.get_time()
        if row != self.row:
            self.end("Done", now)
            self.row, self.began, self.stood = row, None, None
            self.planned = self.tag = 0
        if feedback.phase in MOVING and feedback.command_id_ack:
            self.began = self.began or now
            self.planned, self.tag = feedback.planned_duration.to_sec(), feedback.command_id_ack
        elif self.began:  # the output or the dwell after the move
            self.stood = self.stood or now

    def end(self, verdict, now=None):
        """Prints the row of the running step. The actual time is that of the move in the feedback."""
        if self.row is None:
            return
        cycle, step = self.row
        actual = (self.stood or now or rospy.get_time()) - self.began if self.began else 0
        print(ROW.format(cycle, step + 1, *self.words(step), f"{self.planned:.2f} s", f"{actual:.2f} s", self.tag,
                         verdict), flush=True)
        self.row = None

    def words(self, step):
        """Name, move, format and target; blank if the file is not on this machine."""
        if step >= len(self.steps):
            return "", "", "", ""
        values = self.steps[step]
        target = ", ".join(f"{value:g}" for value in values["target_position"])
        return values.get("name", ""), values["movement_command"], values["data_format"], target


def read_steps(path):
    """For the table only: the command node reads and checks the file itself."""
    if path.startswith("package://"):
        package, _, rest = path[len("package://"):].partition("/")
        path = f"{rospkg.RosPack().get_path(package)}/{rest}"
    try:
        with open(path, encoding="utf-8") as file:
            return yaml.safe_load(file)["steps"]
    except (OSError, yaml.YAMLError, KeyError, TypeError, rospkg.ResourceNotFound):
        return []


if __name__ == "__main__":
    sys.exit(main())
