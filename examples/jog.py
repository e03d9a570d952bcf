#!/usr/bin/env python3
"""Jogs the arm with the action `jog` for some seconds or by an increment, and prints why the arm came to rest. During the seconds it
publishes keep-alives, like a button that an operator holds.
Uses an existing link and leaves it open. Otherwise opens a link and closes it at the end.

Exit status: 0 if the jog ended normally, 1 with the reason if not.
"""
import argparse
import signal
import sys

import actionlib
import rospy
from actionlib import CommState
from actionlib_msgs.msg import GoalStatus
from std_msgs.msg import Empty

from cobot_command.msg import CommandStatus, ConnectAction, ConnectGoal, JogAction, JogGoal

RATE = 100  # [Hz] of the keep-alives
LINK_TIMEOUT = 30.0  # [s]
PATIENCE = 5.0  # [s]
MOST_SECONDS = 60.0  # of a jog
MODES = {"frame": JogGoal.FRAME, "tool": JogGoal.TOOL, "axes": JogGoal.AXES}


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


def wait_for_end(handle, patience):
    deadline = rospy.Time.now() + rospy.Duration(patience)
    while handle.get_comm_state() != CommState.DONE and rospy.Time.now() < deadline and not rospy.is_shutdown():
        rospy.sleep(0.01)


def jog(options):
    directions = [0] * 6
    directions[abs(options.direction) - 1] = 1 if options.direction > 0 else -1
    goal = JogGoal(mode=MODES[options.mode], directions=directions, speed=options.speed, increment_mm=options.mm,
                   increment_deg=options.deg, frame=options.frame, tool=options.tool)
    held = rospy.Publisher("jog_keep_alive", Empty, queue_size=1)
    handle = client("jog", JogAction).send_goal(goal)
    if not options.mm and not options.deg:
        end = rospy.Time.now() + rospy.Duration(options.seconds)
        rate = rospy.Rate(RATE)
        while rospy.Time.now() < end and handle.get_comm_state() != CommState.DONE:
            held.publish()
            rate.sleep()
    wait_for_end(handle, PATIENCE if not options.mm and not options.deg else 600)
    result = handle.get_result()
    if handle.get_comm_state() != CommState.DONE or result is None:
        handle.cancel()
        raise Failed("the jog did not end in time: it was cancelled")
    if handle.get_terminal_state() != GoalStatus.SUCCEEDED:
        raise Failed(f"error 16#{result.error_id:X}: {result.error_description}. {result.remedy}")
    print(f"{result.way:.2f} mm, {result.turn:.2f} deg: {result.why}", flush=True)


def run(options):
    own_link = link()
    try:
        jog(options)
    finally:
        if own_link:
            own_link.cancel()
            wait_for_end(own_link, PATIENCE)


def seconds(text):
    value = float(text)
    if not 0 <= value <= MOST_SECONDS:
        raise argparse.ArgumentTypeError(f"{text} is outside 0 to {MOST_SECONDS}")
    return value


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mode", choices=sorted(MODES), default="axes")
    parser.add_argument("--direction", type=int, choices=[-6, -5, -4, -3, -2, -1, 1, 2, 3, 4, 5, 6], default=1,
                        help="1..6: X Y Z RX RY RZ, or J1..J6; negative: the opposite direction (default: %(default)s)")
    parser.add_argument("--speed", type=float, default=5.0, help="[%%] of the reference (default: %(default)s)")
    parser.add_argument("--seconds", type=seconds, default=1.0, help="time for which the button is held (default: %(default)s)")
    parser.add_argument("--mm", type=float, default=0.0, help="increment instead of a time")
    parser.add_argument("--deg", type=float, default=0.0, help="increment of a turn instead of a time")
    parser.add_argument("--frame", type=int, default=JogGoal.ACTIVE)
    parser.add_argument("--tool", type=int, default=JogGoal.ACTIVE)
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("jog_example", anonymous=True)
    signal.signal(signal.SIGTERM, lambda *_: rospy.signal_shutdown("end requested"))
    try:
        run(options)
    except (Failed, rospy.ROSException) as why:
        print(f"Failed: {why}", flush=True)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
