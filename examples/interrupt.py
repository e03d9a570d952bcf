#!/usr/bin/env python3
"""Interrupts a motion, moves the robot away, brings it back, and continues the motion:

1. Joint 1 turns by some degrees, and `interrupt` suspends this motion on its path.
2. Joint 2 moves away by two degrees.
3. `return_to_primary` moves the robot back to its path.
4. `continue` completes the motion of joint 1. Then joint 1 turns back.

Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Exit status: 0 if all steps succeeded, 1 with the reason if not.
"""
import argparse
import math
import signal
import sys

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus
from sensor_msgs.msg import JointState

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, MoveRelativeAction, MoveRelativeGoal, ReturnToPrimaryAction,
                               ReturnToPrimaryGoal, Transformation)
from cobot_command.srv import Interruption

LINK_TIMEOUT = 30.0  # [s]
PATIENCE = 5.0  # [s]
LONGEST = 120.0  # [s] of a motion
INTERRUPTED_AT = 1 / 3  # of the motion
AWAY = 2.0  # [deg]


class Failed(Exception):
    """The reason why the example failed."""


def client(name, kind):
    found = actionlib.ActionClient(name, kind)
    if not found.wait_for_server(rospy.Duration(LINK_TIMEOUT)):
        raise Failed(f"no action server {name}: is the command node running?")
    return found


def link():
    """Opens a link and returns its connect goal; None: a link exists already."""
    def state():
        return rospy.wait_for_message("command_status", CommandStatus, LINK_TIMEOUT).link_state

    if state() == CommandStatus.READY:
        return None
    handle = client("connect", ConnectAction).send_goal(ConnectGoal(timeout=LINK_TIMEOUT))
    deadline = rospy.Time.now() + rospy.Duration(LINK_TIMEOUT)
    while state() != CommandStatus.READY:
        if handle.get_comm_state() == CommState.DONE or rospy.Time.now() > deadline:
            raise Failed("no link: " + (handle.get_result().error_description if handle.get_result() else "no answer"))
        rospy.sleep(0.05)
    return handle


def wait(handle, seconds):
    """Waits until the goal has ended, or for `seconds`. Returns whether it has ended."""
    deadline = rospy.Time.now() + rospy.Duration(seconds)
    while handle.get_comm_state() != CommState.DONE and rospy.Time.now() < deadline:
        if rospy.is_shutdown():
            raise Failed("end requested")
        rospy.sleep(0.01)
    return handle.get_comm_state() == CommState.DONE


def expect_done(handle, what):
    if not wait(handle, LONGEST):
        handle.cancel()
        raise Failed(f"{what} did not end in time: it was cancelled")
    result = handle.get_result()
    if handle.get_terminal_state() != GoalStatus.SUCCEEDED:
        raise Failed(f"{what}: error 16#{result.error_id:X}: {result.error_description}. {result.remedy}")
    print(f"{what}: done", flush=True)


def ask(service):
    answer = rospy.ServiceProxy(service, Interruption)()
    if not answer.success:
        raise Failed(f"{service}: 16#{answer.error_id:X}: {answer.message}")
    print(f"{service}: {answer.message}", flush=True)


def turn(moves, j1, j2, speed):
    goal = MoveRelativeGoal(movement_command=MoveRelativeGoal.PTP, data_format=MoveRelativeGoal.JPP,
                            target_position=Transformation(x=j1, y=j2), speed=speed, accel_time=300)
    return moves.send_goal(goal)


def joint_1():
    """[deg]"""
    return math.degrees(rospy.wait_for_message("joint_states", JointState, PATIENCE).position[0])


def demonstrate(options):
    moves, ways_back = client("move_relative", MoveRelativeAction), client("return_to_primary", ReturnToPrimaryAction)
    for service in ("interrupt", "continue"):
        rospy.wait_for_service(service, LINK_TIMEOUT)
    begin = joint_1()
    motion = turn(moves, options.degrees, 0, options.speed)
    while abs(joint_1() - begin) < INTERRUPTED_AT * abs(options.degrees):
        if motion.get_comm_state() == CommState.DONE:
            raise Failed(f"the motion ended too early: {motion.get_result().error_description}")
    ask("interrupt")
    expect_done(turn(moves, 0, AWAY, options.speed), "away")
    back = ReturnToPrimaryGoal(return_mode=ReturnToPrimaryGoal.INTERRUPT_POSITION, trajectory_mode=ReturnToPrimaryGoal.PTP,
                               speed=options.speed)
    expect_done(ways_back.send_goal(back), "the return")
    ask("continue")
    expect_done(motion, "the interrupted motion")
    expect_done(turn(moves, -options.degrees, 0, options.speed), "back to the start")


def run(options):
    own_link = link()
    try:
        demonstrate(options)
    finally:
        if own_link:
            own_link.cancel()
            wait(own_link, LINK_TIMEOUT)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--degrees", type=float, default=30.0, help="turn of joint 1 [deg] (default: %(default)s)")
    parser.add_argument("--speed", type=int, default=5, help="[%%] of the rated speeds (default: %(default)s)")
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("interrupt_example", anonymous=True)
    signal.signal(signal.SIGTERM, lambda *_: rospy.signal_shutdown("end requested"))
    try:
        run(options)
    except (Failed, rospy.ROSException, rospy.ServiceException) as why:
        print(f"Failed: {why}", flush=True)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
