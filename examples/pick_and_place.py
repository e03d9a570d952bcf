#!/usr/bin/env python3
"""Runs one pick-and-place cycle through the actions and prints what became of each step.

Exit status: 0 only if every step is Done, 1 if not, 2 if the command node or the steps cannot be used.
"""
import argparse
import sys

import actionlib
import rospkg
import rospy
import yaml
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import (CommandStatus, ConnectAction, ConnectGoal, MoveAbsoluteAction, MoveAbsoluteGoal, RobotPose,
                               Transformation)

CONNECT_TIMEOUT = 30.0  # [s]; the Connect block's own range is 10..300
STEP_TIMEOUT = 120.0    # [s]; far beyond any step: the block's own deadline comes first
ROW = "{:>4}  {:<17} {:<5} {:<4} {:<36} {:>9} {:>9} {:>4}  {}"


def main():
    arguments = parse_arguments()
    rospy.init_node("pick_and_place", anonymous=True)
    steps, dwell = read_steps(arguments.steps)
    move = actionlib.SimpleActionClient("move_absolute", MoveAbsoluteAction)
    connect = actionlib.SimpleActionClient("connect", ConnectAction)
    for client, name in ((move, "move_absolute"), (connect, "connect")):
        if not client.wait_for_server(rospy.Duration(CONNECT_TIMEOUT)):
            print(f"no action server {rospy.resolve_name(name)}: is the command node running?")
            return 2
    if not connected(connect, arguments):
        return 1
    try:
        return 0 if run_cycles(move, steps, dwell, arguments.cycles) else 1
    finally:
        connect.cancel_goal()  # the normal end of Connect
        connect.wait_for_result(rospy.Duration(5.0))


def parse_arguments():
    default_steps = rospkg.RosPack().get_path("cobot_command") + "/config/pick_and_place.yaml"
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", default="", help="address of the controller (default: the command node's robot_ip)")
    parser.add_argument("--port", type=int, default=0, help="script port (default: the command node's script_port)")
    parser.add_argument("--cycles", type=int, default=1, help="how many cycles to run (default: %(default)s)")
    parser.add_argument("--steps", default=default_steps, help="YAML file with the steps (default: %(default)s)")
    return parser.parse_args(rospy.myargv()[1:])


def read_steps(path):
    with open(path, encoding="utf-8") as file:
        content = yaml.safe_load(file)
    return content["steps"], content["dwell"]


def connected(client, arguments):
    """Sends the Connect goal, which stays active, and waits until commands can be sent."""
    client.send_goal(ConnectGoal(host=arguments.host, port=arguments.port, timeout=CONNECT_TIMEOUT))
    deadline = rospy.Time.now() + rospy.Duration(CONNECT_TIMEOUT + 5.0)
    while rospy.Time.now() < deadline:
        try:
            status = rospy.wait_for_message("command_status", CommandStatus, timeout=1.0)
        except rospy.ROSException:
            continue
        if client.get_state() not in (GoalStatus.PENDING, GoalStatus.ACTIVE):
            break
        if status.link_state == CommandStatus.READY and status.status_stream:
            print(f"connected to {status.host}:{status.port}, in Listen node \"{status.listen_node}\"\n")
            return True
    result = client.get_result()
    print("not connected: " + (f"{result.error_description} -> {result.remedy}" if result else "no answer"))
    return False


def run_cycles(move, steps, dwell, cycles):
    print(ROW.format("step", "name", "move", "fmt", "target [mm, deg]", "planned", "actual", "tag", "result"))
    for _ in range(cycles):
        for number, step in enumerate(steps, start=1):
            if not run_step(move, number, step):
                return False
            if step.get("dwell"):
                rospy.sleep(dwell)
    print(f"\n{cycles} cycle(s), all steps Done")
    return True


def run_step(move, number, step):
    move.send_goal(goal_of(step))
    if not move.wait_for_result(rospy.Duration(STEP_TIMEOUT)):
        print(f"step {number}: no result in {STEP_TIMEOUT} s")
        return False
    done = move.get_state() == GoalStatus.SUCCEEDED
    result = move.get_result()
    verdict = "Done" if done else f"Error 16#{result.error_id:X}: {result.error_description} -> {result.remedy}"
    target = ", ".join(f"{value:g}" for value in step["target_position"])
    print(ROW.format(number, step["name"], step["movement_command"], step["data_format"], target,
                     seconds(result.planned_duration), seconds(result.actual_duration), result.command_id_ack, verdict),
          flush=True)
    return done


def goal_of(step):
    goal = MoveAbsoluteGoal(
        movement_command=getattr(MoveAbsoluteGoal, step["movement_command"]),
        data_format=getattr(MoveAbsoluteGoal, step["data_format"]),
        target_position=Transformation(*step["target_position"]),
        speed=step["speed"],
        accel_time=step["accel_time"],
        precise_positioning=True)
    if "robot_pose" in step:
        goal.robot_pose_enable = True
        goal.robot_pose = RobotPose(*(getattr(RobotPose, name) for name in step["robot_pose"]))
    return goal


def seconds(duration):
    return f"{duration.to_sec():.2f} s"


if __name__ == "__main__":
    sys.exit(main())
