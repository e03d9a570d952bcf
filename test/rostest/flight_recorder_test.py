#!/usr/bin/env python3
"""A run in the simulator is recorded, replayed and reported: all is whole, and the same.

Usage: flight_recorder_test.py FOLDER, where the bag and the report are left"""
import pathlib
import signal
import subprocess
import sys
import xmlrpc.client

import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import MoveRelativeActionResult
from cobot_goals import cycle, line_to, relative, step, to_joints
from cobot_test import OutcomeTestCase, Robot, program
from own_nodes import Heard
from waiting import wait_until

FOLDER = pathlib.Path(sys.argv[1])
FAR = 2000  # [mm]; out of reach
ACTIONS = ("connect", "move_absolute", "move_relative", "pick_and_place")  # of the run


class FlightRecorder(OutcomeTestCase):
    def test_a_run_is_recorded_replayed_and_reported(self):
        bag = FOLDER / "run.bag"
        FOLDER.mkdir(parents=True, exist_ok=True)
        for file in FOLDER.iterdir():
            if file.is_file():
                file.unlink()  # of an earlier run
        recorder = Heard("roslaunch", "cobot_command", "record.launch", f"file:={bag}")
        self.addCleanup(recorder.clear_away)
        wait_until(lambda: not recorder.is_alive() or hears_the_run(), "the recorder")
        self.assertTrue(recorder.is_alive(), recorder.output())
        self.drive()
        self.assertEqual(recorder.end(signal.SIGINT)[0], 0, recorder.output())
        self.assertTrue(bag.is_file(), f"{list(FOLDER.iterdir())}: the bag was not closed\n{recorder.output()}")
        self.assert_reported(bag)

    def drive(self):
        """What a run has: a link, moves, a cycle, a goal that is refused, a motion that is stopped, and the end of the link."""
        robot = Robot()
        robot.establish()
        self.assert_done(robot.run(to_joints(20, -10, 100, 0, 90, 0)))
        self.assert_done(robot.run(relative(0, 80, 0, 0, 0, 0)))
        self.assert_rejected(robot.run(relative(FAR, 0, 0, 0, 0, 0)), 0x201)
        self.send_without_id()
        self.assert_done(robot.run(cycle(*[step(line_to(450, 0, z, 180, 0, 90)) for z in (460, 400)])))
        robot.start_slowly().cancel()
        robot.wait_for_standstill()
        robot.close()

    def send_without_id(self):
        """As the README sends goals: the server makes the id."""
        results = []
        listening = rospy.Subscriber("/move_relative/result", MoveRelativeActionResult, results.append)
        wait_until(lambda: listening.get_num_connections() > 0, "the server of move_relative")
        goal = "{goal: {data_format: 0, movement_command: 1, target_position: {x: 5}, speed: 50, accel_time: 300}}"
        subprocess.run(["rostopic", "pub", "-1", "/move_relative/goal", "cobot_command/MoveRelativeActionGoal", goal], check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        wait_until(lambda: results, "the result of a goal without an id")
        listening.unregister()
        self.assertEqual(results[0].status.status, GoalStatus.SUCCEEDED, results[0])

    def assert_reported(self, bag):
        done = subprocess.run([program("flight_report.py"), str(bag), "--folder", str(FOLDER)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=100, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, r"decoder: \d\d+ compared, 0 differ")
        self.assertRegex(done.stdout, r"simulator: \d\d+ compared, \d+ may differ, 0 differ")
        self.assertGreater((FOLDER / "report.png").stat().st_size, 50_000)
        page = (FOLDER / "report.html").read_text(encoding="utf-8")
        for words in ("recording whole", "no goal failed", "1 of 7 goals refused", "1 of 7 goals stopped", "16#201", "cycle 1, step 2: Line", "PREEMPTED", "TM5-900"):
            self.assertTrue(words in page, f"{words} is not in the report")  # which is too long to be shown


def hears_the_run():
    """Whether the recorder is connected to all that the command node will say: it comes to one after the other."""
    node = xmlrpc.client.ServerProxy(rosgraph.Master("/test").lookupNode("/command_node"))
    heard = {connection[4] for connection in node.getBusInfo("/test")[2] if "recorder" in connection[1]}
    return heard.issuperset(rospy.resolve_name(name) for name in ("frames", *(f"{action}/result" for action in ACTIONS)))


if __name__ == "__main__":
    import rostest

    rospy.init_node("flight_recorder_test")
    rostest.rosrun("cobot_command", "flight_recorder", FlightRecorder, sys.argv)
