#!/usr/bin/env python3
"""A tour of the actions: connects, checks before it moves, moves in three ways with blending, works in another base
with another tool, pauses and resumes, stops, and comes back. Needs about 1 m of free space around the robot.

Exit status: 0 when everything went as it should, 1 with the reason when not. The same in C++: tour.cpp.
"""
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command import msg
from cobot_command.msg import CommandStatus, MoveAbsoluteGoal, MoveCircleGoal, MoveRelativeGoal, Transformation

HOME = MoveAbsoluteGoal(movement_command=MoveAbsoluteGoal.PTP, data_format=MoveAbsoluteGoal.JPP,
                        target_position=Transformation(0, 0, 90, 0, 90, 0),  # joints [deg]
                        speed=50, accel_time=300, precise_positioning=True)
UP = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
                      target_position=Transformation(z=60), speed=150, accel_time=300,  # mm, mm/s, ms
                      blending_enable=True, blending_value=50)
ASIDE = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.CAP,
                         target_position=Transformation(y=80), speed=150, accel_time=300, precise_positioning=True,
                         buffer_mode=MoveRelativeGoal.BUFFERED)
ARC = MoveCircleGoal(data_format=MoveCircleGoal.CAP, arc_point=Transformation(480, -60, 461, 180, 0, 90),
                     end_point=Transformation(517.5, 0, 461, 180, 0, 90), speed=150, accel_time=300,
                     precise_positioning=True)
SLOWLY_DOWN = MoveRelativeGoal(movement_command=MoveRelativeGoal.LINE, data_format=MoveRelativeGoal.TAP,
                               target_position=Transformation(z=150), speed=20, accel_time=300)
TIMEOUT = rospy.Duration(60)


class Failed(Exception):
    """What did not go as it should."""


class Tour:
    def __init__(self):
        self.clients = {}

    def run(self):
        print("Connect: the goal stays active as long as the link lives")
        self.connect()

        print("Check a sequence that begins at home: nothing is sent")
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
            target_position=Transformation(z=20), speed=100, accel_time=300, precise_positioning=True)).final_pose
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
        client = self.start("connect", msg.ConnectGoal(timeout=20))
        while client.get_state() == GoalStatus.ACTIVE:
            # Latched: the newest is there at once.
            status = rospy.wait_for_message("command_status", CommandStatus, timeout=10)
            if status.link_state == CommandStatus.READY and status.status_stream:
                return
        self.expect("connect", client, GoalStatus.ACTIVE)

    def disconnect(self):
        """The normal end of connect. Without one it does nothing."""
        if "connect" in self.clients and self.clients["connect"].get_state() == GoalStatus.ACTIVE:
            self.clients["connect"].cancel_goal()
            self.expect("connect", self.clients["connect"], GoalStatus.SUCCEEDED)

    def do(self, action, goal):
        """Runs a goal to its end and returns its result; anything but SUCCEEDED is a failure."""
        return self.expect(action, self.start(action, goal), GoalStatus.SUCCEEDED)

    def start(self, action, goal):
        """Sends a goal and waits until it is taken, that is until it may be cancelled."""
        kind = getattr(msg, type(goal).__name__.replace("Goal", "Action"))
        client = self.clients.setdefault(action, actionlib.SimpleActionClient(action, kind))
        if not client.wait_for_server(TIMEOUT):
            raise Failed(f"no action server {rospy.resolve_name(action)}: is the command node running?")
        client.send_goal(goal)
        self.wait_while(client, (GoalStatus.PENDING, ))
        return client

    def expect(self, action, client, state):
        if not self.wait_while(client, (GoalStatus.PENDING, GoalStatus.ACTIVE)):
            raise Failed(f"{action} did not end")
        result = client.get_result()
        if client.get_state() != state:
            raise Failed(f"{action}: 16#{result.error_id:X} {result.error_description} -> {result.remedy}")
        return result

    @staticmethod
    def wait_while(client, states):
        """False when it took too long. wait_for_result would miss a goal that ended before send_goal returned."""
        deadline = rospy.Time.now() + TIMEOUT
        while client.get_state() in states:
            if rospy.Time.now() > deadline:
                return False
            rospy.sleep(0.01)
        return True


def main():
    rospy.init_node("tour", anonymous=True)
    tour = Tour()
    try:
        tour.run()
    except (Failed, rospy.ROSException) as failure:
        print(f"The tour ends here: {failure}")
        return 1
    finally:
        tour.disconnect()
    print("The tour is over")
    return 0


if __name__ == "__main__":
    sys.exit(main())
