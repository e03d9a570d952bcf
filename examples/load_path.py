#!/usr/bin/env python3
"""Runs a path with the action `load_path`: checks it, drives it, and prints the planned and the actual times of each point. Then it sends
the same points as two goals; the second one joins the first. The robot moves to joints 0 0 90 0 90 0, and around a box of 200 x 150 mm.
Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Ctrl-C, SIGTERM and a closed terminal stop the robot. Exit status: 0 if all goals SUCCEEDED and the first path was driven as
planned, 1 with the reason if not. The planner alone, in C++ and without ROS: load_path.cpp.
"""
import argparse
import collections
import math
import signal
import sys
import time

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, FrameTrace, LoadPathAction, LoadPathGoal,
                               PathPoint, Transformation)

TIMEOUT = 60.0  # [s]
CLOSE_TIMEOUT = 5.0  # [s]; a command node that hangs must not delay the end of this program
FRAME_TIMEOUT = 1.0  # [s]; frames are published after results
END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
ROW = "  {:>5} {:>5}  {:<9} {:<12} {:>10} {:>10} {:>10} {:>9}"
SPEEDS = {True: {"speed": 60, "acceleration": 180, "deceleration": 180},  # PTP [deg/s, deg/s^2]
          False: {"speed": 150, "acceleration": 600, "deceleration": 600,  # else [mm/s, mm/s^2]
                  "orientation_speed": 60, "orientation_acceleration": 240, "orientation_deceleration": 240}}


class Failed(Exception):
    """The reason why the example failed."""


def point(interpolation, move_id, tolerance=0.0, pose=None, joints=None, **changes):
    """A point of a path. Poses are of the flange, in the robot base. Without a tolerance the robot stops at the point."""
    values = {"joints": [*joints, 0, 0, 0]} if joints else {
        "target_point_type": PathPoint.CARTESIAN, "pose": Transformation(*pose), "pose_type": PathPoint.FLANGE,
        "ref_frame_type": PathPoint.ROBOT}
    if tolerance:
        values.update(termination_type=PathPoint.BLEND, command_tolerance=tolerance)
    values.update(SPEEDS[interpolation == PathPoint.PTP], acceleration_jerk=50, deceleration_jerk=50)
    return PathPoint(interpolation_type=interpolation, move_id=move_id, **{**values, **changes})


HOME = point(PathPoint.PTP, 1, joints=(0, 0, 90, 0, 90, 0))
ABOVE = (450, -200, 420, 180, 0, 90)
AROUND = [
    point(PathPoint.PTP, 10, 25, pose=ABOVE, robot_configuration=5),  # %; righty, above, no flip
    point(PathPoint.CP_LINEAR, 20, 20, pose=(450, -200, 320, 180, 0, 90), profile_type=PathPoint.MOD_SINE),  # mm
    point(PathPoint.CP_LINEAR, 21, 30, pose=(450, 0, 320, 180, 0, 90)),
    point(PathPoint.CP_WRIST, 22, 30, pose=(600, 0, 320, 180, 0, 135)),
    point(PathPoint.CP_WRIST, 23, 20, pose=(600, -200, 320, 180, 0, 90)),
    point(PathPoint.CP_LINEAR, 30, 20, pose=(550, -200, 420, 180, 0, 90), profile_type=PathPoint.POLY5),
    point(PathPoint.PTP, 40, joints=(0, 0, 90, 0, 90, 0))]
# As two goals: the first one stops at its first point, and blends at its end.
CHAIN = [point(PathPoint.PTP, 10, pose=ABOVE, robot_configuration=5), *AROUND[1:]]
FIRST = 3  # points of the first goal
NAMES = {PathPoint.PTP: "PTP", PathPoint.CP_LINEAR: "CP_LINEAR", PathPoint.CP_WRIST: "CP_WRIST"}


class Paths:
    def __init__(self, limits):
        self.limits = limits
        self.connect = client("connect", ConnectAction)
        self.load_path = client("load_path", LoadPathAction)
        self.link = None  # the connect goal, if this program has opened the link
        self.goals = []
        self.pvts = Pvts()

    def run(self):
        self.open_link()
        print("Go home")
        self.expect(self.send("home", path([HOME]), quiet=True))
        self.check()
        self.drive()
        self.chain()

    def open_link(self):
        if is_ready():
            print("A link exists: it is used and kept")
            return
        print("Connect")
        self.link = self.connect.send_goal(ConnectGoal(timeout=20))
        wait_until(lambda: self.link.get_comm_state() == CommState.DONE or is_ready(), "a link")
        if self.link.get_comm_state() == CommState.DONE:
            raise failure("connect", self.link)

    def check(self):
        print("Check the path: nothing is sent")
        checked = self.expect(self.send("check", path(AROUND, check_only=True), quiet=True))
        print(f"  it would take {checked.planned_duration.to_sec():.3f} s; {len(checked.joint_path.points)} points of joint_path")

    def drive(self):
        print("Drive it")
        self.pvts.frames.clear()
        result = self.expect(self.send("path", path(AROUND)))
        show(AROUND, result)
        print(f"  off the plan: joints {result.max_joint_deviation:.3f} deg, path {result.max_path_deviation:.3f} mm,"
              f" lag {result.lag.to_sec():.3f} s")
        print(f"  blends lost: {words(result.blends_lost)}; sent as {self.pvts.told(1)}")
        for name, found, most in (("max_joint_deviation", result.max_joint_deviation, self.limits.joints),
                                  ("max_path_deviation", result.max_path_deviation, self.limits.path),
                                  ("lag", result.lag.to_sec(), self.limits.lag)):
            if not found <= most:
                raise Failed(f"{name} is {found:g}, and at most {most:g} is allowed")

    def chain(self):
        print("Two goals, each with a part of the points: the second joins the first")
        self.pvts.frames.clear()
        first = self.send("first", path(CHAIN, number_of_moves=FIRST))
        second = self.send("second", path(CHAIN, start_index=FIRST, number_of_moves=len(CHAIN) - FIRST))
        for name, goal in (("first", first), ("second", second)):
            result = self.expect(goal)
            print(f"  {name}: SUCCEEDED after {result.actual_duration.to_sec():.3f} s; planned"
                  f" {result.planned_duration.to_sec():.3f} s; blends lost: {words(result.blends_lost)}")
        print(f"  both were sent as {self.pvts.told(2)}: up to the first point, which is a stop, and all after it")

    def send(self, name, goal, quiet=False):
        """Sends a goal and waits until it is accepted, so that it can be cancelled."""
        progress = Progress(name, goal)
        sent = self.load_path.send_goal(goal, feedback_cb=None if quiet else lambda _, feedback: progress.take(feedback))
        self.goals.append(sent)
        wait_until(lambda: sent.get_goal_status() != GoalStatus.PENDING, "an answer of load_path")
        return sent

    @staticmethod
    def expect(goal):
        wait_for_end(goal)
        if goal.get_goal_status() != GoalStatus.SUCCEEDED:
            raise failure("load_path", goal)
        return goal.get_result()

    def leave(self):
        """Stops the robot. Closes the link only if this program has opened it."""
        for goal in self.goals:
            if goal.get_comm_state() != CommState.DONE:
                goal.cancel()
        for goal in self.goals:
            wait_for_end(goal, CLOSE_TIMEOUT)
        if self.link and self.link.get_comm_state() != CommState.DONE:
            self.link.cancel()  # the normal end of connect
            wait_for_end(self.link, CLOSE_TIMEOUT)


class Progress:
    """Prints a line for each point as soon as it becomes active."""

    def __init__(self, name, goal):
        self.name, self.goal, self.told = name, goal, None

    def take(self, feedback):
        if not feedback.active or feedback.active_path_point == self.told:
            return
        self.told = feedback.active_path_point
        print(f"  {self.name}: point {self.told} (move {feedback.active_move_id}) is active, {feedback.done_path_points} done,"
              f" {feedback.queued_path_points} queued, {feedback.pending_path_points} pending", flush=True)


class Pvts:
    """Counts the PVTs that are sent to the controller."""

    def __init__(self):
        self.frames = collections.deque()
        self.subscriber = rospy.Subscriber("frames", FrameTrace, self.see, queue_size=100)
        wait_until(lambda: self.subscriber.get_num_connections() > 0, "the topic frames")

    def see(self, frame):
        if frame.sent and b"PVTEnter" in bytes(frame.bytes):
            self.frames.append(frame)

    def told(self, expected):
        """The number of PVTs, in words."""
        deadline = time.monotonic() + FRAME_TIMEOUT
        while len(self.frames) < expected and time.monotonic() < deadline:
            time.sleep(0.01)
        return "one PVT" if len(self.frames) == 1 else f"{len(self.frames)} PVTs"


def path(points, **changes):
    return LoadPathGoal(**{"path": points, "number_of_moves": len(points), **changes})


def show(points, result):
    print(ROW.format("point", "move", "way", "end", "begins", "done", "was done", "later by"))
    for index, (wanted, report) in enumerate(zip(points, result.points)):
        ends = (report.start + report.duration).to_sec()
        done = report.done.to_sec()
        unit = "%" if wanted.interpolation_type == PathPoint.PTP else "mm"
        blends = wanted.termination_type == PathPoint.BLEND
        print(ROW.format(index, wanted.move_id, NAMES[wanted.interpolation_type],
                         f"blend {wanted.command_tolerance:g} {unit}" if blends else "stop",
                         f"{report.start.to_sec():.3f} s", f"{ends:.3f} s", f"{done:.3f} s", f"{done - ends:+.3f} s"))
    print(f"  planned {result.planned_duration.to_sec():.3f} s, took {result.actual_duration.to_sec():.3f} s")


def words(indices):
    return ", ".join(map(str, indices)) or "none"


def client(name, kind):
    # Not a SimpleActionClient: it would miss an answer that arrives at once (doc/actions/README.md).
    made = actionlib.ActionClient(name, kind)
    if not made.wait_for_server(rospy.Duration(TIMEOUT)):
        raise Failed(f"no action server {rospy.resolve_name(name)}: is the command node running?")
    return made


def failure(action, goal):
    result = goal.get_result()
    if result is None:
        return Failed(f"{action}: no answer")
    # The ids of load_path from 1000 on are those of its manual, which are decimal.
    number = str(result.error_id) if result.error_id >= 1000 else f"16#{result.error_id:X}"
    blamed = f" (point {result.error_index})" if getattr(result, "error_index", -1) >= 0 else ""
    return Failed(f"{action}: {number}{blamed} {result.error_description} -> {result.remedy}")


def is_ready():
    """Whether commands can be sent."""
    # Latched: the latest message is received at once.
    status = rospy.wait_for_message("command_status", CommandStatus, timeout=10)
    return status.link_state == CommandStatus.READY and status.status_stream


def wait_for_end(goal, seconds=math.inf):
    """Waits for DONE and not for the status of the goal, because the status may arrive before the result."""
    deadline = time.monotonic() + seconds
    while goal.get_comm_state() != CommState.DONE and time.monotonic() < deadline:
        time.sleep(0.01)


def wait_until(condition, what):
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > deadline:
            raise Failed(f"{what} was not received in time")
        time.sleep(0.01)


def interrupt(*_):
    """The first signal starts the shutdown; further signals are ignored."""
    for number in END_SIGNALS:
        signal.signal(number, signal.SIG_IGN)
    raise Failed("interrupted")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, unit, default in (("joints", "deg", 6.0), ("path", "mm", 0.1), ("lag", "s", 0.1)):
        parser.add_argument(f"--{name}", metavar=unit.upper(), type=float, default=default,
                            help=f"allowed deviation from the plan [{unit}] (default: %(default)s)")
    return parser.parse_args(rospy.myargv()[1:])


def main():
    limits = parse_arguments()
    # With its own signal handlers, rospy would shut down before the robot can be stopped.
    rospy.init_node("load_path", anonymous=True, disable_signals=True)
    for number in END_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup ignores SIGHUP
            signal.signal(number, interrupt)
    paths = None
    try:
        paths = Paths(limits)
        paths.run()
    except (Failed, rospy.ROSException) as reason:
        print(f"The path ends here: {reason}")
        return 1
    finally:
        if paths:
            paths.leave()
    print("All paths are done")
    return 0


if __name__ == "__main__":
    sys.exit(main())
