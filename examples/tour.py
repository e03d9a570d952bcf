#!/usr/bin/env python3
"""A tour of the actions: connects, checks a sequence before it moves, moves in three ways with blending, works in another
base with another tool, pauses and resumes, stops, and returns. Needs about 1 m of free space around the robot.
Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Ctrl-C, SIGTERM and a closed terminal stop the robot. Exit status: 0 if all steps succeeded, 1 with the reason if not.
The same in C++: tour.cpp.
"""
import argparse
import signal
import sys

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus

from cobot_command import msg
from cobot_command.msg import CommandStatus, MoveAbsoluteGoal, MoveCircleGoal, MoveRelativeGoal, Transformation

HOME = MoveAbsoluteGoal(movement_command=MoveAbsoluteGoal.PTP, data_format=MoveAbsoluteGoal.JPP,
                        target_position=Transformation(0, 0, 90, 0, 90, 0),  # joints [deg]
                        speed=50, accel_time=300)
UP = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
                      target_position=Transformation(z=60), speed=150, accel_time=300,  # mm, mm/s, ms
                      blending_enable=True, blending_value=50)
ASIDE = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
                         target_position=Transformation(y=80), speed=150, accel_time=300,
                         buffer_mode=MoveRelativeGoal.BUFFERED)
ARC = MoveCircleGoal(data_format=MoveCircleGoal.CAP, arc_point=Transformation(480, -60, 461, 180, 0, 90),
                     end_point=Transformation(517.5, 0, 461, 180, 0, 90), speed=150, accel_time=300)
SLOWLY_DOWN = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.TAP,
                               target_position=Transformation(z=150), speed=20, accel_time=300)
TIMEOUT = 60.0  # [s]
CLOSE_TIMEOUT = 5.0  # [s]; a command node that hangs must not delay the end of this program
END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Failed(Exception):
    """The reason why the example failed."""


class Tour:
    def __init__(self):
        self.clients = {}  # not SimpleActionClients, which would miss an answer that arrives at once (doc/actions/README.md)
        self.link = None  # the connect goal, if this program has opened the link
        self.uses_others_link = False
        self.has_moved = False

    def run(self):
        self.connect()

        print("Check a sequence that starts at home: nothing is sent")
        checked = self.do("check_sequence", msg.CheckSequenceGoal(
            start_joints=[0, 0, 90, 0, 90, 0],
            steps=[msg.SequenceStep(kind=msg.SequenceStep.MOVE_RELATIVE, move_relative=UP),
                   msg.SequenceStep(kind=msg.SequenceStep.MOVE_RELATIVE, move_relative=ASIDE)]))
        print(f"  it would take {checked.planned_duration.to_sec():.2f} s")

        print("Go home, point to point")
        self.do("move_absolute", HOME)

        print("Up, and aside without stopping in between: the first is done when it is accepted")
        self.do("move_relative", UP)
        self.do("move_relative", ASIDE)

        print("Home again, and along an arc")
        self.do("move_absolute", HOME)
        end = self.do("move_circle", ARC).final_pose
        print(f"  the tool is at {end.x:.1f}, {end.y:.1f}, {end.z:.1f} mm")

        print("Another base and another tool: the same place has other numbers")
        self.do("change_base", msg.ChangeBaseGoal(transformation=Transformation(x=400, z=100)))
        self.do("change_tcp", msg.ChangeTCPGoal(tcp_offset=Transformation(z=120), weight=1.2))
        end = self.do("move_relative", MoveRelativeGoal(
            movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
            target_position=Transformation(z=20), speed=100, accel_time=300)).final_pose
        print(f"  the tool is at {end.x:.1f}, {end.y:.1f}, {end.z:.1f} mm")
        self.do("change_tcp", msg.ChangeTCPGoal(tcp_name="NOTOOL"))
        self.do("change_base", msg.ChangeBaseGoal(base_name="RobotBase"))

        print("Begin a slow motion; pause it, resume it, stop it")
        down = self.start("move_relative", SLOWLY_DOWN)
        self.do("program_control", msg.ProgramControlGoal(command=msg.ProgramControlGoal.PAUSE))
        self.do("program_control", msg.ProgramControlGoal(command=msg.ProgramControlGoal.RESUME))
        self.do("stop", msg.StopGoal())
        self.expect("move_relative", down, GoalStatus.PREEMPTED)

        print("Home")
        self.do("move_absolute", HOME)

    def connect(self):
        self.client("connect", msg.ConnectAction)
        if is_ready():
            print("A link exists: it is used and kept")
            self.uses_others_link = True
            return
        print("Connect: the goal stays active as long as the link exists")
        self.link = self.start("connect", msg.ConnectGoal(timeout=20))
        while self.link.get_goal_status() == GoalStatus.ACTIVE:
            if is_ready():
                return
        self.expect("connect", self.link, GoalStatus.ACTIVE)

    def leave(self):
        """Stops the robot: by the normal end of connect, or by a stop if another client has opened the link. A robot that
        this program has not moved is not stopped, because another client may move it."""
        if self.uses_others_link and self.has_moved:
            self.expect("stop", self.start("stop", msg.StopGoal()), GoalStatus.SUCCEEDED, CLOSE_TIMEOUT)
        if self.link and self.link.get_goal_status() == GoalStatus.ACTIVE:
            self.link.cancel()
            self.expect("connect", self.link, GoalStatus.SUCCEEDED, CLOSE_TIMEOUT)

    def do(self, action, goal):
        """Runs a goal to its end and returns its result; anything but SUCCEEDED is a failure."""
        return self.expect(action, self.start(action, goal), GoalStatus.SUCCEEDED)

    def start(self, action, goal):
        """Sends a goal and waits until it is accepted, so that it can be cancelled."""
        sent = self.client(action, getattr(msg, type(goal).__name__.replace("Goal", "Action"))).send_goal(goal)
        wait_until(lambda: sent.get_goal_status() != GoalStatus.PENDING, f"an answer of {action}")
        taken = sent.get_goal_status() != GoalStatus.REJECTED
        self.has_moved = self.has_moved or (taken and action.startswith("move_"))
        return sent

    def client(self, action, kind):
        if action not in self.clients:
            self.clients[action] = actionlib.ActionClient(action, kind)
        if not self.clients[action].wait_for_server(rospy.Duration(TIMEOUT)):
            raise Failed(f"no action server {rospy.resolve_name(action)}: is the command node running?")
        return self.clients[action]

    @staticmethod
    def expect(action, sent, state, timeout=TIMEOUT):
        wait_until(lambda: sent.get_comm_state() == CommState.DONE, f"the end of {action}", timeout)
        result = sent.get_result()
        if sent.get_goal_status() != state:
            raise Failed(f"{action}: 16#{result.error_id:X} {result.error_description} -> {result.remedy}")
        return result


def is_ready():
    """Whether commands can be sent."""
    # Latched: the latest message is received at once.
    status = rospy.wait_for_message("command_status", CommandStatus, timeout=10)
    return status.link_state == CommandStatus.READY and status.status_stream


def wait_until(condition, what, timeout=TIMEOUT):
    deadline = rospy.Time.now() + rospy.Duration(timeout)
    while not condition():
        if rospy.Time.now() > deadline:
            raise Failed(f"{what} was not received in time")
        rospy.sleep(0.01)


def interrupt(*_):
    """The first signal starts the shutdown; further signals are ignored."""
    for number in END_SIGNALS:
        signal.signal(number, signal.SIG_IGN)
    raise Failed("interrupted")


def main():
    # It has no options; --help explains it, and must not move the robot.
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args(rospy.myargv()[1:])
    # With its own signal handlers, rospy would shut down before the robot can be stopped.
    rospy.init_node("tour", anonymous=True, disable_signals=True)
    for number in END_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup ignores SIGHUP
            signal.signal(number, interrupt)
    tour = Tour()
    over = False
    try:
        over = succeeds(tour.run)
    finally:
        over = succeeds(tour.leave) and over
    if over:
        print("The tour is over")
    return 0 if over else 1


def succeeds(part):
    try:
        part()
    except (Failed, rospy.ROSException) as failure:
        print(f"The tour ends here: {failure}")
        return False
    return True


if __name__ == "__main__":
    sys.exit(main())
