#!/usr/bin/env python3
"""The monitor of a cell beside robots and a mechanism that nothing else keeps apart. In real time, as it judges by the age of what it hears."""
import hashlib
import os
import re
import signal
import subprocess
import tempfile
import threading

import rospkg
import rospy
import tf2_ros
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from std_msgs.msg import Float64
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import Marker, MarkerArray

from cobot_command.msg import CellDistances, CellRobot, CellState, CellZone, FrameTrace, StopActionGoal
from cobot_goals import to_joints, turn
from cobot_test import Latest, OutcomeTestCase, Robot, program
from figure import print_figure
from own_nodes import Heard, Process
from waiting import DEADLINE, wait_until

HOME = (0, -30, 120, 0, 90, 0)
T1 = (0, 45, 60, -15, 90, 0)
STOP_DISTANCE = 0.018  # [m]
SLOW = {"speed": 2, "accel_time": 200}  # some 60 mm/s of the tool


def between(part):
    """On the way from HOME to T1."""
    return [a + part * (b - a) for a, b in zip(HOME, T1)]


def cell_file(name):
    return os.path.join(rospkg.RosPack().get_path("cobot_command"), "config", "cells", f"{name}.yaml")


def digest_of(artifact):
    with open(artifact, "rb") as file:
        return hashlib.sha256(file.readline()).hexdigest()


def call(name, kind, *arguments):
    rospy.wait_for_service(name, DEADLINE)
    return rospy.ServiceProxy(name, kind)(*arguments)


class Pallet:
    """Slides towards where it is told to, and stays where it is once it is stopped."""

    STEP = 0.002  # [m], fifty times a second: 0.1 m/s

    def __init__(self):
        self.position = self.target = 0.0  # [m]
        self.stops = 0
        self._is_over = threading.Event()
        self._told = rospy.Publisher("/PALLET/position", Float64, queue_size=1)
        self._stops = rospy.Subscriber("/PALLET/stop/goal", StopActionGoal, self._stop)
        self._thread = threading.Thread(target=self._slide)
        self._thread.start()

    def end(self):
        self._is_over.set()
        self._thread.join()
        self._stops.unregister()

    def _stop(self, _goal):
        self.stops += 1
        self.target = self.position

    def _slide(self):
        while not self._is_over.wait(0.02):
            self.position += max(-self.STEP, min(self.STEP, self.target - self.position))
            self._told.publish(self.position)


class SupervisorOfThePallet:
    """Tells that the robot is at home and runs its program, twenty times a second."""

    def __init__(self, artifact):
        robot = CellRobot(name="RA", state=CellRobot.READY, place="HOME")
        self._state = CellState(hash=digest_of(artifact), instance=1, mode=CellState.RUNNING, robots=[robot])
        self._told = rospy.Publisher("/cell/state", CellState, queue_size=1)
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._tell)
        self._thread.start()

    def end(self):
        self._is_over.set()
        self._thread.join()
        self._told.unregister()

    def _tell(self):
        while not self._is_over.wait(0.05):
            self._state.number += 1
            self._told.publish(self._state)


class CellMonitor(OutcomeTestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.artifact = os.path.join(cls.folder.name, "handover.artifact")
        subprocess.run([program("tm_cell"), "build", cell_file("handover"), "-o", cls.artifact], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.nodes, self.robots = {}, {}
        for name in ("RA", "RB"):
            self.start_robot(name)
        sent = [robot.send(to_joints(*HOME)) for robot in self.robots.values()]
        for goal in sent:
            self.assert_done(goal.finish())

    # --- Its task.
    def test_stops_both_when_they_come_too_close_until_they_are_apart(self):
        self.start_monitor()
        pair = self.distances.wait_for(lambda m: m.pairs[0].known, "the distance at home").pairs[0]
        self.assertEqual((pair.robot, pair.other), ("RA", "RB"))
        self.assertAlmostEqual(pair.now, 0.659, delta=0.002)
        self.assert_done(self.robots["RA"].run(to_joints(*T1, speed=30)))
        self.assert_done(self.robots["RB"].run(to_joints(*between(0.2), speed=10)))
        frames = {name: robot.latest("frames", FrameTrace) for name, robot in self.robots.items()}
        wrist = self.robots["RA"].send(turn(0, 0, 0, 0, 0, 120, speed=2)).wait_until_active()
        towards = self.robots["RB"].send(to_joints(*T1, **SLOW))
        alarmed = self.distances.wait_for(lambda m: m.alarmed, "the alarm")
        self.assertIn("RB", alarmed.text)
        for sent in (wrist, towards):
            self.assertEqual(sent.finish()[0], GoalStatus.PREEMPTED)
        self.measure_stop(alarmed, frames)
        for robot in self.robots.values():
            robot.wait_for_standstill()
        stands = self.distances.message.pairs[0]
        self.assertLess(stands.now, STOP_DISTANCE + 0.001)
        self.assertGreater(stands.least, 0, "they never touched")
        self.assertTrue(stands.breached)
        refused = call("/cell/reset_monitor", Trigger)
        self.assertFalse(refused.success, refused.message)
        self.assertIn("while the cause persists", refused.message)
        self.assert_diagnosed(DiagnosticStatus.ERROR)
        self.drive_apart_and_reset()
        self.distances.wait_for(lambda m: not m.alarmed and not m.pairs[0].breached, "the end of the alarm")
        # A stop of the last step may have been on its way when the monitor was reset.
        wait_until(lambda: self.robots["RB"].run(to_joints(*HOME, speed=10))[0] == GoalStatus.SUCCEEDED, "RB at home")
        self.assertFalse(self.distances.message.alarmed)

    def test_stops_the_other_robot_when_a_command_node_dies_on_its_way(self):
        self.start_monitor()
        moved = {name: robot.send(turn(0, 0, 0, 0, 0, 150, **SLOW)).wait_until_active() for name, robot in self.robots.items()}
        for robot in self.robots.values():
            robot.wait_for_motion()
        self.distances.wait_for(lambda m: m.pairs[0].uncertainty > 0, "both in motion")
        self.nodes["RA"].end(signal.SIGKILL)
        alarmed = self.distances.wait_for(lambda m: m.alarmed, "the alarm")
        self.assertIn("RA moved in its last report", alarmed.text)
        self.assertEqual(moved["RB"].finish()[0], GoalStatus.PREEMPTED)
        refused = call("/cell/reset_monitor", Trigger)
        self.assertFalse(refused.success, refused.message)
        self.start_robot("RA")  # which stops what the one before it has left on its way
        wait_until(lambda: call("/cell/reset_monitor", Trigger).success, "the end of the alarm")

    def test_stops_a_robot_and_the_mechanism_that_comes_too_close_to_it(self):
        pallet = self.start_pallet()
        pair = self.distances.wait_for(lambda m: m.pairs[0].known, "the distance of the pallet").pairs[0]
        self.assertEqual((pair.robot, pair.other), ("RA", "PALLET"))
        self.assert_done(self.robots["RA"].run(to_joints(*T1, speed=30)))
        self.assertFalse(self.distances.message.alarmed)
        wrist = self.robots["RA"].send(turn(0, 0, 0, 0, 0, 120, speed=2)).wait_until_active()
        pallet.target = 0.9
        alarmed = self.distances.wait_for(lambda m: m.alarmed, "the alarm")
        self.assertIn("PALLET", alarmed.text)
        self.assertEqual(wrist.finish()[0], GoalStatus.PREEMPTED)
        wait_until(lambda: pallet.stops > 0, "the stop of the pallet")
        self.assertLess(pallet.position, 0.9)

        def is_away():
            pallet.target = 0.0  # what moves now is stopped again, soon
            return pallet.position == 0.0

        wait_until(is_away, "a pallet that is away")
        wait_until(lambda: call("/cell/reset_monitor", Trigger).success, "the end of the alarm")

    def test_stops_the_robots_when_a_mechanism_on_its_way_falls_silent(self):
        pallet = self.start_pallet()
        wrist = self.robots["RA"].send(turn(0, 0, 0, 0, 0, 150, **SLOW)).wait_until_active()
        pallet.target = 0.9
        self.distances.wait_for(lambda m: m.pairs[0].uncertainty > 0 and pallet.position > 0.05, "a pallet on its way")
        pallet.end()
        alarmed = self.distances.wait_for(lambda m: m.alarmed, "the alarm")
        self.assertIn("PALLET moved in its last report", alarmed.text)
        self.assertEqual(wrist.finish()[0], GoalStatus.PREEMPTED)

    def test_takes_a_robot_for_carrying_what_it_has_at_its_place_while_the_supervisor_tells_it(self):
        artifact = os.path.join(self.folder.name, "pallet.artifact")
        subprocess.run([program("tm_cell"), "build", cell_file("pallet"), "-o", artifact], check=True)
        self.start_pallet(artifact=artifact)
        with_sheet = self.distances.wait_for(lambda m: m.pairs[0].known and m.pairs[0].exact, "the distance").pairs[0].now
        supervisor = SupervisorOfThePallet(artifact)
        self.addCleanup(supervisor.end)
        self.distances.wait_for(lambda m: m.pairs[0].now > with_sheet + 0.01, "the distance without the sheet")
        self.assert_carried("nothing")
        supervisor.end()
        self.distances.wait_for(lambda m: m.pairs[0].now < with_sheet + 0.001, "the distance with the sheet")
        self.assert_carried("all parts it can carry, because the actual parts are unknown")

    def test_only_warns_where_it_is_told_to(self):
        self.start_monitor(mode="warn")
        self.assert_done(self.robots["RA"].run(to_joints(*T1)))
        self.assert_done(self.robots["RB"].run(to_joints(*T1)))
        self.distances.wait_for(lambda m: m.pairs[0].now < 0, "bodies in each other")
        self.assertFalse(self.distances.message.alarmed)
        wait_until(lambda: "Nothing is stopped" in self.monitor.output(), "the warning")

    def test_listens_where_a_robot_reports_from(self):
        text = open(cell_file("handover"), encoding="utf-8").read().replace("namespace: RA", "namespace: elsewhere")
        path = os.path.join(self.folder.name, "elsewhere.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.start_monitor(cell_file=path, artifact="")
        self.distances.wait_for(lambda m: "RA has not reported" in m.text, "a robot that is not there")
        # As its command node would, if it had a seat in the cell.
        reporter = Process("rostopic", "pub", "-r", "10", "/cell/reports",
                           "cobot_command/CellReport", "{robot: RA}", "__ns:=/RA", "__name:=reporter",
                           stdout=subprocess.DEVNULL)
        self.addCleanup(reporter.clear_away)
        self.distances.wait_for(lambda m: m.pairs[0].known, "the distance")

    # --- Its pictures.
    def test_shows_zones_in_the_colours_of_their_owners_and_claims_on_request(self):
        self.start_monitor()
        zones = Latest("/cell/zones", MarkerArray)
        free = zones.wait_for(lambda m: len(m.markers) > 1, "the zones").markers
        cubes = next(m for m in free if m.ns == "zones")
        self.assertEqual((cubes.type, cubes.header.frame_id), (Marker.CUBE_LIST, "world"))
        self.assertGreater(len(cubes.points), 100)
        state = CellState(hash=digest_of(self.artifact), zones=[CellZone(name="Z1", state=CellZone.HELD, owner="RA", waiting=["RB"])])
        supervisor = rospy.Publisher("/cell/state", CellState, queue_size=1, latch=True)
        supervisor.publish(state)
        held = zones.wait_for(lambda m: any(n.text == "Z1: RA" for n in m.markers), "the owner").markers
        self.assertNotEqual(next(m for m in held if m.ns == "zones").color, cubes.color)
        self.assertEqual(len([m for m in held if m.ns == "waiting"]), 1)
        claims = Latest("/cell/claims", MarkerArray)
        self.assertTrue(call("/cell/show_claims", SetBool, True).success)
        claims.wait_for(lambda m: len([c for c in m.markers if c.ns == "claims"]) == 2, "the claims")
        self.assertTrue(call("/cell/show_claims", SetBool, False).success)
        claims.wait_for(lambda m: len(m.markers) == 1, "the end of the claims")
        closest = Latest("/cell/closest", MarkerArray)
        closest.wait_for(lambda m: any(t.text in ("658 mm", "659 mm", "660 mm") for t in m.markers), "the shortest way")

    def test_shows_robots_whatever_they_are_called(self):
        with open(cell_file("handover"), encoding="utf-8") as file:
            text = file.read()
        for name, space, other in (("RA", "RA", "left_arm"), ("RB", "/RB", "ARM_2")):
            text = re.sub(rf"\b{name}\b", other, text).replace(f"namespace: {other}", f"namespace: {space}")
        path = os.path.join(self.folder.name, "names.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        self.start_monitor(cell_file=path, artifact="")
        bodies = Latest("/cell/bodies", MarkerArray)
        shown = bodies.wait_for(lambda m: {n.ns for n in m.markers} >= {"left_arm", "ARM_2"}, "both robots").markers
        self.assertEqual({m.header.frame_id for m in shown}, {"world"})
        for name, side in (("left_arm", -1), ("ARM_2", 1)):
            core = next(m for m in shown if m.ns == name and m.type == Marker.CYLINDER)
            self.assertAlmostEqual(core.pose.position.x, 0.72 * side, delta=0.1)
        self.monitor.end(signal.SIGTERM)
        self.start_monitor(cell_file=cell_file("pallet"), artifact="")
        obstacles = Latest("/cell/obstacles", MarkerArray)
        obstacles.wait_for(lambda m: any(n.text == "fence" for n in m.markers), "the fence")

    def test_tells_tf_where_the_robots_stand(self):
        self.start_monitor()
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        for frame, x in (("RA_base", -0.72), ("RB_base", 0.72)):
            place = buffer.lookup_transform("world", frame, rospy.Time(0), rospy.Duration(DEADLINE)).transform
            self.assertAlmostEqual(place.translation.x, x, places=6)
        self.assertAlmostEqual(abs(place.rotation.z), 1, places=6)
        listener.unregister()

    # --- What it refuses.
    def test_does_not_start_with_what_it_cannot_use(self):
        for changes, words in (({"cell_file": "handover.yaml"}, "an absolute path"),
                               ({"cell_file": "/nowhere.yaml"}, "/nowhere.yaml cannot be read"),
                               ({"cell_file": cell_file("iris")}, "another cell than ~cell_file"),
                               ({"stop_distance": 0.05}, "must be at most the margin")):
            with self.subTest(words=words):
                self.start_monitor(**changes)
                self.assertEqual(self.monitor.wait(), 2)
                self.assertIn(words, self.monitor.output())

    # --- Helpers.
    def measure_stop(self, alarmed, frames):
        """P8 of doc/cell.md: from the joints by which two were too close to the last of the stops on the wires."""
        data = max(m.header.stamp for robot in self.robots.values() for m in robot.joints.all() if m.header.stamp <= alarmed.header.stamp)
        stops = [next(m.header.stamp for m in latest.all() if m.sent and "StopAndClearBuffer" in m.text and m.header.stamp >= data)
                 for latest in frames.values()]
        print_figure("P8", "from measured joints that are too close to the stop frames of both robots, over ROS",
                     [1000 * (max(stops) - data).to_sec()], "ms", 50)

    def start_robot(self, name):
        if rospy.has_param(f"/{name}/command_node"):
            rospy.delete_param(f"/{name}/command_node")
        self.nodes[name] = Process(program("command_node"), "__name:=command_node", f"__ns:=/{name}", "_robot_model:=tm5-900",
                                   f"_prefix:={name}_")
        self.addCleanup(self.nodes[name].clear_away)
        self.robots[name] = Robot(name)
        self.robots[name].establish()

    def start_pallet(self, artifact=""):
        """The monitor of its cell, too."""
        pallet = Pallet()
        self.addCleanup(pallet.end)
        self.start_monitor(cell_file=cell_file("pallet"), artifact=artifact, stop_distance=-1)
        return pallet

    def start_monitor(self, **changes):
        parameters = {"cell_file": cell_file("handover"), "artifact": self.artifact, "stop_distance": STOP_DISTANCE, **changes}
        if rospy.has_param("/cell/cell_monitor"):
            rospy.delete_param("/cell/cell_monitor")
        private = [f"_{key}:={value}" for key, value in parameters.items()]
        self.monitor = Heard(program("cell_monitor"), "__ns:=/cell", *private)
        self.addCleanup(self.monitor.clear_away)
        self.distances = Latest("/cell/distances", CellDistances)

    def drive_apart_and_reset(self):
        """What moves now is stopped again, soon: so by small steps, as one would jog."""
        def one_step():
            self.robots["RB"].run(turn(0, -3, 0, 0, 0, 0, speed=20))
            return self.distances.message.pairs[0].now > 0.06

        wait_until(one_step, "room between the robots")
        answer = call("/cell/reset_monitor", Trigger)
        self.assertTrue(answer.success, answer.message)

    def assert_carried(self, words):
        diagnostics = Latest("/diagnostics", DiagnosticArray)
        diagnostics.wait_for(lambda m: any(v.key == "carried by RA" and v.value == words for s in m.status for v in s.values), words)

    def assert_diagnosed(self, level):
        diagnostics = Latest("/diagnostics", DiagnosticArray)
        diagnostics.wait_for(lambda m: any(s.name.endswith("Monitor") and s.level == level for s in m.status), f"level {level}")


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_monitor_test")
    rostest.rosrun("cobot_command", "cell_monitor", CellMonitor)
