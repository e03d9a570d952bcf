"""The shell examples of pages: blocks that begin with ```sh example [state [error id]]."""
import contextlib
import pathlib
import re
import subprocess

import rospkg
import rospy
from actionlib_msgs.msg import GoalStatus

import cobot_command.msg
from cobot_command.msg import CommandStatus

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("cobot_command"))
OF_SUPERVISOR = {"build_cell", "run_cell"}  # no command node serves these: cell_test.py has their goals
# The state is SUCCEEDED if it is not given.
EXAMPLE = re.compile(r"^```sh example *(?P<state>\w*) *(?:16#(?P<error_id>\w+)|(?P<decimal>\d+))?\n(?P<command>.*?)^```$", re.M | re.S)
TARGET = re.compile(r"rostopic pub -1 /(?P<action>\w+)/(?:goal|cancel) ")


def results_of_all_actions(robot):
    """The latest result of each action, by its name."""
    results = {}
    for path in PACKAGE.glob("action/*.action"):
        action = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", path.stem).lower()
        if action not in OF_SUPERVISOR:
            results[action] = robot.latest(f"{action}/result", getattr(cobot_command.msg, f"{path.stem}ActionResult"))
    return results


def examples_of(page):
    return list(EXAMPLE.finditer((PACKAGE / page).read_text(encoding="utf-8")))


def check(test, robot, results, example, shells):
    """Runs the command of an example and expects its state and error id."""
    results = results[TARGET.search(example["command"])["action"]]
    results.forget()
    if example["state"] == "ACTIVE":
        with shell(example["command"]):  # what ends it must not be faster
            robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a link")
        return
    shells.enter_context(shell(example["command"]))
    # Results of the test's own goals may still arrive.
    end = results.wait_for_any(lambda m: rospy.get_name() not in m.status.goal_id.id, "the result")
    test.assertEqual(end.status.status, getattr(GoalStatus, example["state"] or "SUCCEEDED"), end)
    test.assertEqual(hex(end.result.error_id), hex(int(example["decimal"] or 0) or int(example["error_id"] or "0", 16)), end)


@contextlib.contextmanager
def shell(command):
    """Runs the command in parallel with what follows, and waits for its end: `rostopic pub -1` stays for three seconds."""
    with subprocess.Popen(["bash", "-c", command]) as process:
        yield
    if process.returncode != 0:
        raise AssertionError(f"ended with {process.returncode}: {command}")
