"""Motions that are interrupted by the service, and the way back to where that was."""
import rospy

from cobot_command.msg import ReturnToPrimaryGoal
from cobot_command.srv import Interruption
from cobot_goals import SLOWLY, turn, with_changes


def ask(service, namespace=""):
    """`interrupt` or `continue`; its whole answer."""
    return rospy.ServiceProxy(namespace + service, Interruption)()


def interrupt(robot, goal=None, namespace=""):
    """The goal, a slow turn of joint 1 if none is given, when it is under way and was interrupted."""
    sent = robot.send(goal or turn(60, 0, 0, 0, 0, 0, **SLOWLY), namespace).wait_until_active()
    robot.wait_for_motion()
    answer = ask("interrupt", namespace)
    if not answer.success:
        raise AssertionError(f"interrupt: 16#{answer.error_id:X}: {answer.message}")
    robot.wait_for_standstill()
    return sent


def way_back(**changes):
    return with_changes(ReturnToPrimaryGoal(trajectory_mode=ReturnToPrimaryGoal.PTP, speed=80), changes)


def line_back(**changes):
    return way_back(**{"trajectory_mode": ReturnToPrimaryGoal.LINEAR, "speed": 20, **changes})
