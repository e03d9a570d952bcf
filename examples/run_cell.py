#!/usr/bin/env python3
"""Runs all robots of a cell with the action `run_cell`, and prints where each robot goes, and for which zone and which robot it waits.

Ctrl-C, SIGTERM and a closed terminal cancel the action, which stops the robots. Exit status: 0 if all cycles were done and, if the cell
has a monitor, no two robots came closer than --distance; 1 with the reason if not.
"""
import argparse
import signal
import sys
import time

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CellRobot, CellState, CellZone, RunCellAction, RunCellGoal

PATIENCE = 60.0  # [s]
SOON = 3.0  # [s]
LOOK_EVERY = 0.05  # [s]
NOT_BEGUN = "the end was requested before the start"
END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
REASONS = {CellRobot.ZONE_HELD: "{} has the zone", CellRobot.WOULD_BLOCK: "after it {} could not return home",
           CellRobot.AGED: "{} has waited for longer", CellRobot.QUARANTINED: "{} is lost, or is in the zone without a permit",
           CellRobot.HOLDING: "nothing is granted now", CellRobot.SCHEDULED: "it is the turn of {}"}


class Teller:
    """Prints what is new in the cell."""

    def __init__(self):
        self.begun = None
        self.robots = {}
        self.owners = {}
        self.failures = set()

    def tell(self, feedback):
        self.begun = self.begun or rospy.Time.now()
        state = feedback.state
        for zone in state.zones:
            owner = zone.owner if zone.state != CellZone.FREE else ""
            if self.owners.get(zone.name, "") != owner:
                self.say(f"{zone.name}: {owner + ' has it' if owner else 'free'}")
            self.owners[zone.name] = owner
        for robot in state.robots:
            words = self.words_of(robot)
            if self.robots.get(robot.name) != words:
                self.say(f"{robot.name}: {words}")
            self.robots[robot.name] = words
        for failure in feedback.failures:
            if failure not in self.failures:
                self.say(f"failed: {failure}" + ("; the others continue, Ctrl-C stops them" if feedback.open else ""))
        self.failures.update(feedback.failures)

    def say(self, text):
        print(f"{(rospy.Time.now() - self.begun).to_sec():7.2f} s  {text}", flush=True)

    @staticmethod
    def words_of(robot):
        if robot.state == CellRobot.OUT:
            return f"out of the cell: {robot.text}"
        if robot.state == CellRobot.WAITING and robot.reason != CellRobot.NO_REASON:
            return f"at {robot.place}, waits: {REASONS[robot.reason].format(' and '.join(robot.blocked_by))}"
        return f"at {robot.place}" + (f": {robot.text}" if robot.text else "")


class EndAsked:
    """Whether a signal was received. The handler only sets a flag, because it might interrupt another handler that holds a lock."""

    def __init__(self):
        self._is_so = False
        for number in END_SIGNALS:
            signal.signal(number, self._note)

    def _note(self, *_):
        self._is_so = True

    def __bool__(self):
        return self._is_so


def wait_until(condition, end_asked, patience):
    """False: the condition was not met within `patience` [s], or the end was requested first."""
    begin = time.monotonic()
    while not condition():
        if end_asked or time.monotonic() - begin > patience:
            return False
        time.sleep(LOOK_EVERY)
    return True


def run(arguments):
    end_asked = EndAsked()
    client = actionlib.ActionClient(f"{arguments.cell}/run_cell", RunCellAction)
    if not client.wait_for_server(rospy.Duration(1)):
        print(f"waiting for {arguments.cell}/run_cell", flush=True)
    if not wait_until(lambda: client.wait_for_server(rospy.Duration(0.01)), end_asked, PATIENCE):
        return NOT_BEGUN if end_asked else f"no action server {arguments.cell}/run_cell: start cell.launch first"
    if not wait_until_it_has_begun(arguments.cell, end_asked):
        return NOT_BEGUN if end_asked else f"the cell was not READY within {PATIENCE:.0f} s: see rostopic echo -n 1 {arguments.cell}/state"
    teller = Teller()
    handle = client.send_goal(RunCellGoal(cycles=arguments.cycles, robots=arguments.robots), None, lambda _, feedback: teller.tell(feedback))
    if not wait_until(lambda: handle.get_comm_state() == CommState.DONE, end_asked, float("inf")):
        handle.cancel()
        if not wait_until(lambda: handle.get_comm_state() == CommState.DONE, False, PATIENCE):
            return f"it was cancelled, and has not ended within {PATIENCE:.0f} s: see rostopic echo -n 1 {arguments.cell}/state"
    return verdict(handle, arguments.distance)


def wait_until_it_has_begun(cell, end_asked):
    """Waits while nodes that were just started find each other. If that takes longer, the action refuses the goal with the reason."""
    states = []
    subscriber = rospy.Subscriber(f"{cell}/state", CellState, states.append, queue_size=1)
    if not wait_until(lambda: states and states[-1].mode != CellState.STARTING, end_asked, SOON):
        print(f"the cell starts: {states[-1].diagnosis}" if states else f"no state is received on {cell}/state", flush=True)
    begun = wait_until(lambda: states and states[-1].mode != CellState.STARTING, end_asked, PATIENCE)
    if begun:
        wait_until(lambda: states[-1].mode != CellState.RECOVERY, end_asked, SOON)
    subscriber.unregister()
    return begun


def verdict(handle, distance):
    """The reason of the failure; empty on success."""
    result = handle.get_result()
    if handle.get_terminal_state() != GoalStatus.SUCCEEDED:
        return f"16#{result.error_id:X} {result.error_description}. {result.remedy}" if result else \
            "the goal was lost because the supervisor has ended: the robots complete their own goals; see its log, and restart it"
    cycles = ", ".join(f"{name} {count}" for name, count in zip(result.robots, result.cycles_done))
    print(f"cycles: {cycles}; {result.makespan.to_sec():.1f} s")
    if result.least_distance < 0:
        print("the monitor did not publish all the time: distances were not measured")
        return ""
    print(f"least distance: {result.least_distance * 1e3:.1f} mm")
    if result.least_distance < distance / 1e3:
        return f"two robots came as close as {result.least_distance * 1e3:.1f} mm: at least {distance:g} mm are required"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cell", default="/cell", help="namespace of the cell (default: %(default)s)")
    parser.add_argument("--cycles", type=int, default=3, help="cycles of each robot, 1 to 1000000; 0: until cancelled (default: %(default)s)")
    parser.add_argument("--robots", nargs="+", default=[], metavar="NAME", help="only these robots (default: all robots of the cell)")
    parser.add_argument("--distance", type=float, default=20.0, help="minimum distance between robots [mm] (default: %(default)s)")
    arguments = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("run_cell", anonymous=True, disable_signals=True)
    fault = run(arguments)
    if fault:
        print(f"run_cell: {fault}", file=sys.stderr)
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main())
