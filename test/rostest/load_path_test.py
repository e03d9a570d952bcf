#!/usr/bin/env python3
"""The load_path action against a simulated controller over real sockets."""
import math
import pathlib
import tempfile

import rospy
from actionlib_msgs.msg import GoalStatus
from visualization_msgs.msg import Marker, MarkerArray

from cobot_command.msg import CommandStatus, FrameData, LoadPathGoal, PathPoint, PathStatus, RobotStatus, StopGoal, ToolData
from cobot_command.srv import WriteFrame, WriteTool
from cobot_goals import ABORTING, HOME, path, path_line, path_of_poses, path_to_joints, script, six, to_joints, with_changes
from cobot_test import DEADLINE, Latest, Robot
from motion_checks import MotionTestCase
from tf_frames import pose_in

FILE = "package://cobot_command/config/path.yaml"
START = (417.5, -122.3, 461.05, 180, 0, 90)  # of the flange at HOME
BLEND = {"termination_type": PathPoint.BLEND}
NAN = float("nan")
MORE_THAN_THE_BUFFER = 8  # points: the active one, and five behind it


def from_file(**changes):
    return with_changes(LoadPathGoal(path_file=FILE, number_of_moves=7), changes)


def above(z, **changes):
    return path_line(*START[:2], START[2] + z, *START[3:], **changes)


def over_the_bench(z, frame="bench", quaternion=(1, 0, 0, 0)):
    """As above(), in the frame of the launch file [m]."""
    return pose_in(frame, (START[1] / 1000 + 0.1, 0.4 - START[0] / 1000, (START[2] + z) / 1000 - 0.3), quaternion)


def slow_path(count=3, **changes):
    """Points at which the robot stops, 20 degrees apart, slowly enough to be interrupted."""
    return path(*(path_to_joints(20 * (i + 1), 0, 90, 0, 90, 0, speed=5) for i in range(count)), **changes)


class LoadPath(MotionTestCase):
    # --- Done.
    def test_runs_the_path_of_its_file(self):
        checked = self.assert_done(self.robot.run(from_file(check_only=True)))
        sent = self.robot.send(from_file())
        result = self.assert_done(sent.finish())
        self.assert_stands_at(HOME)
        self.assertEqual(result.planned_duration, checked.planned_duration)
        self.assertGreater(result.actual_duration.to_sec(), 0.2)
        self.assertEqual((len(result.points), list(result.blends_lost)), (7, []))
        self.assertEqual((result.execution, result.error_index, result.error_joint), (LoadPathGoal.PVT, -1, -1))
        self.assertTrue(result.final_joints_valid and result.final_pose_valid)
        told = [f for f in sent.feedback if f.active]
        self.assertTrue(told)
        for feedback in told:
            known = feedback.pending_path_points + feedback.queued_path_points + feedback.done_path_points
            self.assertIn(known, (5, 6))  # two are active while they blend
        self.assertEqual([f.active_path_point for f in told], sorted(f.active_path_point for f in told))
        self.assertIn(told[-1].active_move_id, (30, 40))

    def test_only_checks(self):
        result = self.assert_done(self.robot.run(from_file(check_only=True)))
        self.assertGreater(len(result.joint_path.points), 100)
        for found, wanted in zip(result.joint_path.points[-1].positions, HOME):
            self.assertAlmostEqual(math.degrees(found), wanted, places=4)
        self.assertEqual(result.joint_path.points[-1].time_from_start, result.planned_duration)
        self.assert_stands_at(HOME)

    def test_checks_without_sending_a_byte(self):
        self.robot.run(from_file(check_only=True))
        outputs = next(b for b in self.robot.status.message.blocks if b.block == "load_path")
        self.assertFalse(outputs.busy)

    def test_loads_a_section_of_its_points(self):
        points = [PathPoint(), *slow_path().path[:1], PathPoint()]
        self.assert_done(self.robot.run(path(*points, start_index=1, number_of_moves=1)))
        self.assert_stands_at((20, 0, 90, 0, 90, 0))

    def test_is_done_at_once_where_the_robot_stands(self):
        result = self.assert_done(self.robot.run(path(path_to_joints(*HOME))))
        self.assertLess(result.planned_duration.to_sec(), 0.1)

    # --- Ended from outside.
    def test_can_be_cancelled_in_the_middle(self):
        sent = self.robot.send(slow_path())
        sent.wait_for_feedback(lambda f: f.active_path_point == 1, "the second point")
        self.robot.wait_for_motion()
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(path(path_to_joints(*HOME))))

    def test_is_interrupted_by_a_stop_until_its_last_point_is_loaded(self):
        sent = self.robot.start_slowly(slow_path(MORE_THAN_THE_BUFFER))
        self.assert_done(self.robot.run(StopGoal()))
        outcome = sent.finish()
        self.assert_aborted(outcome, 1007, "stop")
        self.assertEqual(outcome[1].error_index, 6)
        sent = self.robot.start_slowly(path(path_to_joints(-40, 0, 90, 0, 90, 0, speed=5)))
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())

    def test_is_interrupted_by_a_goal_that_takes_over(self):
        sent = self.robot.start_slowly(slow_path(MORE_THAN_THE_BUFFER))
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=ABORTING)))
        self.assert_aborted(sent.finish(), 1007, "move_absolute")

    def test_tells_the_point_that_a_lost_link_ends(self):
        sent = self.robot.send(slow_path())
        sent.wait_for_feedback(lambda f: f.active_path_point == 1, "the second point")
        self.robot.operate("drop_connections")
        outcome = sent.finish()
        self.assert_aborted(outcome, 1002)
        self.assertEqual(outcome[1].error_index, 1)

    def test_stops_a_robot_that_leaves_its_path(self):
        self.robot.fault("pvt_linear")
        self.addCleanup(self.robot.fault, "pvt_linear", False)
        points = [path_to_joints(15 * (i % 2), 0, 90 + 5 * (i % 3), 0, 90, 0, speed=60) for i in range(1, 6)]
        self.assert_aborted(self.robot.run(path(*points, max_deviation=0.0005)), 0x274, "off its path")
        self.robot.wait_for_standstill()

    # --- What RViz shows.
    def markers(self, points, name):
        return [marker for marker in points.message.markers if marker.ns == name]

    def test_shows_its_corners_and_the_active_point(self):
        points = self.robot.latest("planned_points", MarkerArray)
        line = self.robot.latest("planned_path", Marker)
        active = self.robot.latest("active_point", Marker)
        self.assert_done(self.robot.run(path(path_to_joints(*HOME), above(20, **BLEND, command_tolerance=5), above(0))))
        active.wait_for(lambda m: m.action == Marker.DELETE and len(active.all()) > 2, "the end of the active point")
        corners, blends = self.markers(points, "corners"), self.markers(points, "blends")
        self.assertEqual([round(1000 * p.z) for p in corners[0].points], [round(START[2] + 20)])
        self.assertEqual([round(1000 * b.pose.position.z) for b in blends], [round(START[2] + 20)])
        self.assertTrue(0 < blends[0].scale.x <= 0.0101, blends[0].scale.x)
        self.assertEqual(len(self.markers(points, "points")[0].points), 2)
        self.assertEqual(points.message.markers[0].action, Marker.DELETEALL)
        self.assertGreater(max(p.z for p in line.message.points), (START[2] + 15) / 1000)
        shown = [round(1000 * m.pose.position.z) for m in active.all() if m.action == Marker.ADD]
        self.assertIn(round(START[2] + 20), shown)

    def test_shows_the_point_that_is_refused(self):
        points = self.robot.latest("planned_points", MarkerArray)
        for check_only in (True, False):
            far = with_changes(above(0), {"pose": six((500, -122.3, 461.05, 180, 0, 90))})
            self.assert_done(self.robot.run(path(path_to_joints(*HOME), far, check_only=True)))
            points.wait_for(lambda m: not self.markers(points, "refused"), "a path without a fault")
            far.pose = six((2000, -122.3, 461.05, 180, 0, 90))
            self.assert_rejected(self.robot.run(path(path_to_joints(*HOME), far, check_only=check_only)), 1046)
            points.wait_for(lambda m: self.markers(points, "refused"), "the point that is refused")
            text = self.markers(points, "error")[0].text
            self.assertTrue(text.startswith("point 1: "), text)

    # --- What everyone is told of it.
    def test_tells_how_its_path_goes_until_it_is_over(self):
        told = self.robot.latest("path_status", PathStatus)
        told.wait_for(lambda s: not s.path_planner_active, "the status of no path")
        self.assert_done(self.robot.run(from_file()))
        told.wait_for(lambda s: not s.path_planner_active and len(told.all()) > 2, "the end of the path")
        status = [s for s in told.all() if s.path_planner_active]
        ids = [s.active_move_id for s in status if s.active_move_id]
        self.assertEqual(ids, sorted(ids))
        self.assertIn(21, ids)
        line = next(s for s in status if s.active_move_id == 21)
        self.assertEqual((line.active_interpolation, line.active_type, line.active_ref_frame_type),
                         (PathPoint.CP_LINEAR, PathPoint.FLANGE, PathPoint.ROBOT))
        self.assertTrue(all(0 <= s.active_move_percent <= 100 for s in status))
        self.assertGreater(max(s.linear_velocity for s in status), 50)
        self.assertGreater(max(s.linear_acceleration for s in status), 50)
        self.assertTrue(any(s.progress_source == PathStatus.STREAM for s in status))
        end = told.message
        self.assertEqual((end.active_move_id, end.linear_velocity, end.feedrate, end.gate_waits), (0, 0, 100, False))

    def test_shows_both_moves_of_a_corner(self):
        """The controller sends no tag at the start of a blend: an arm faster than its plan is past it when it is known."""
        robot = Robot("real_time")
        self.addCleanup(robot.close)
        robot.establish()
        shown = robot.latest("path_status", PathStatus)
        self.assert_done(robot.run(from_file()))
        blends = [s for s in shown.all() if s.blending_move_id]
        self.assertTrue(any(0 < s.blending_move_percent < 100 for s in blends))
        self.assertLessEqual({(s.active_move_id, s.blending_move_id) for s in blends}, {(10, 20), (20, 21), (21, 22), (22, 23), (30, 40)})

    # --- The robot.
    def test_is_refused_by_a_robot_that_is_not_energised(self):
        self.robot.close()
        self.robot.send_connect()
        self.robot.status.wait_for(lambda s: s.status_stream, "the status stream")
        self.robot.operate("set_emergency_stop", True)
        self.robot.connect.finish()
        self.robot.send_connect()
        self.robot.robot_status.wait_for(lambda s: s.e_stopped == RobotStatus.TRUE, "the emergency stop")
        self.assert_rejected(self.robot.run(path(path_to_joints(*HOME))), 1005)

    def test_is_refused_in_manual_mode(self):
        self.robot.operate("set_manual_mode", True)
        self.robot.robot_status.wait_for(lambda s: s.mode == RobotStatus.MODE_MANUAL, "the manual mode")
        self.assert_rejected(self.robot.run(path(path_to_joints(*HOME))), 1006)

    def test_sends_joint_targets_by_ptp_without_a_model_of_the_arm(self):
        connect = self.robot.send(self.robot.connect_goal(), "unmodelled/")
        Latest("unmodelled/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        increment = above(0, move_type=PathPoint.INCREMENTAL)
        for goal, error_id in ((path(path_to_joints(*HOME), check_only=True), 0x209), (path(path_to_joints(*HOME), above(10)), 1021),
                               (path(increment), 1019), (path(path_to_joints(*HOME), execution=LoadPathGoal.PVT), 0x272)):
            with self.subTest(error_id=error_id):
                self.assert_rejected(self.robot.run(goal, "unmodelled/"), error_id)
        result = self.assert_done(self.robot.run(path(path_to_joints(*HOME), allow_approximation=True), "unmodelled/"))
        self.assertEqual(result.execution, LoadPathGoal.SCRIPT)
        self.assertIn("no model", result.execution_reason)
        connect.cancel()
        self.assert_done(connect.finish())

    def test_takes_targets_in_the_world(self):
        connect = self.robot.send(self.robot.connect_goal(), "in_cell/")
        Latest("in_cell/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        in_world = path(above(-150, ref_frame_type=PathPoint.WORLD), check_only=True)
        in_robot = path(above(-50), check_only=True)
        ends = [self.assert_done(self.robot.run(goal, "in_cell/")).joint_path.points[-1].positions for goal in (in_world, in_robot)]
        for found, wanted in zip(*ends):
            self.assertAlmostEqual(found, wanted, places=6)
        connect.cancel()
        self.assert_done(connect.finish())

    def test_takes_its_targets_from_poses_of_tf(self):
        checked = self.assert_done(self.robot.run(path(above(30), above(50), check_only=True)))
        sent = self.robot.send(path_of_poses(over_the_bench(30), over_the_bench(50), move_id=7))
        self.assert_done(sent.finish())
        self.assert_stands_at([math.degrees(p) for p in checked.joint_path.points[-1].positions])
        told = {(f.active_path_point, f.active_move_id) for f in sent.feedback if f.active}
        self.assertTrue(told and told <= {(0, 7), (1, 8)}, told)

    def test_is_given_up_when_its_plan_takes_too_long(self):
        points = [above(10 * (i % 2), **BLEND) for i in range(1000)]
        connect = self.robot.send(self.robot.connect_goal(), "hurried/")
        Latest("hurried/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        self.assert_rejected(self.robot.run(path(*points), "hurried/"), 0x20C)
        connect.cancel()
        self.assert_done(connect.finish())

    # --- Inputs.
    def assert_blames(self, goal, error_id, index=-1, joint=-1, words=""):
        with self.subTest(error_id=error_id, index=index):
            outcome = self.robot.run(goal)
            self.assert_rejected(outcome, error_id, words)
            self.assertEqual((outcome[1].error_index, outcome[1].error_joint), (index, joint))

    def test_refuses_numbers_outside_their_range(self):
        one = path_to_joints(*HOME)
        self.assert_blames(LoadPathGoal(), 1010)
        self.assert_blames(path(*[one] * 20, start_index=15, number_of_moves=6), 1010)
        self.assert_blames(path(*[one] * 1001), 1010)
        self.assert_blames(path(*[one] * 20, start_index=20, number_of_moves=1), 1012)
        self.assert_blames(path(one, execution=3), 0x275)
        self.assert_blames(path(one, buffer_mode=3), 0x215)
        for deviation in (-0.1, NAN, 1e6):
            self.assert_blames(path(one, max_deviation=deviation), 0x278)
        self.assert_blames(path(one, with_changes(path_to_joints(*HOME), {"tracking_axis_position": 5}), enable_tracking_0=True),
                           0x270, 1)

    def test_refuses_the_first_wrong_point(self):
        first = path_to_joints(*HOME)
        for error_id, changes in ((1013, {"speed": -1}), (1014, {"acceleration_jerk": 101}), (1017, {"move_type": 2}),
                                  (1018, {"target_point_type": 3}), (1024, {"termination_type": 1}),
                                  (1023, {**BLEND, "command_tolerance": 100.1}), (1025, {"profile_type": 4}),
                                  (1026, {"robot_configuration": 16})):
            self.assert_blames(path(first, path_to_joints(*HOME, **changes)), error_id, 1)
        for error_id, changes in ((1015, {"orientation_speed": 0}), (1020, {"interpolation_type": 4}),
                                  (1022, {**BLEND, "command_tolerance": -0.1}), (1027, {"pose_type": 0}),
                                  (1028, {"ref_frame_type": 3}), (1029, {"pose_type": PathPoint.TOOL, "pose_id": 16}),
                                  (1030, {"ref_frame_type": PathPoint.USER, "ref_frame_id": -1}),
                                  (1031, {"pose_type": PathPoint.TOOL, "pose_id": 7}),
                                  (1032, {"ref_frame_type": PathPoint.USER, "ref_frame_id": 7})):
            self.assert_blames(path(first, above(10, **changes)), error_id, 1)
        self.assert_blames(path(first, path_to_joints(*HOME, profile_type=9), path_to_joints(*HOME, speed=-1)), 1025, 1)

    def test_refuses_what_the_arm_cannot_do(self):
        first = path_to_joints(*HOME)
        self.assert_blames(path(first, path_to_joints(0, 0, 170, 0, 0, 0)), 1033, 1, 2)
        self.assert_blames(path(above(10, move_type=PathPoint.INCREMENTAL, ref_frame_type=PathPoint.USER)), 1035, 0)
        self.assert_blames(path(above(NAN)), 1037, 0)
        self.assert_blames(path(above(10, ref_frame_type=PathPoint.WORLD)), 1040, 0)
        self.assert_blames(path(above(10, robot_configuration=13)), 1048, 0)
        self.assert_blames(path(first, with_changes(path_to_joints(*HOME), {"joints": [0] * 7 + [1, 0]})), 1058, 1, 7)
        self.assert_blames(path(path_to_joints(90, 0, 90, 0, 90, 0, speed=200)), 0x204, 0, 0)
        self.assert_blames(path(path_to_joints(90, 0, 90, 0, 90, 0, speed=1e-4)), 0x206, 0)
        self.assert_blames(path(path_to_joints(140, 0, 90, 0, 90, 0, speed=1)), 0x277, 0)
        far = with_changes(above(0), {"pose": six((2000, -122.3, 461.05, 180, 0, 90))})
        self.assert_blames(path(first, far), 1046, 1)
        posture = with_changes(path_to_joints(*HOME), {"pose": six((800, -122.3, 100, 180, 0, 90)), "robot_configuration": 13,
                                                       "target_point_type": PathPoint.CARTESIAN, "pose_type": PathPoint.FLANGE,
                                                       "ref_frame_type": PathPoint.ROBOT})
        self.assert_blames(path(posture), 1044, 0)
        inwards = with_changes(above(0), {"pose": six((150, -122.3, 150, 180, 0, 90))})
        state, result = self.robot.run(path(inwards))
        self.assert_rejected((state, result), 1047)
        self.assertEqual(result.error_index, 0)
        self.assertTrue(result.points[0].offending_point_valid)
        self.assert_done(self.robot.run(path(path_to_joints(0, 0, 90, 0, 0, 0))))
        upright = with_changes(above(0), {"pose": six((417.5, -122.3, 400, 90, 0, 90))})
        self.assert_blames(path(upright), 1045, 0, 4)

    def test_refuses_a_way_that_begins_outside_the_joint_limits(self):
        larger = Robot("larger")
        larger.establish()
        # Only the robot can read it, so that nobody plans it for the smaller arm.
        far = script("float[] now = Robot[0].Joint", 'PTP("JPP",0,0,160,0,90,0,35,200,0,false)', await_motion=True)
        self.assert_done(larger.run(far))
        state, result = larger.run(path(above(10)))
        self.assert_rejected((state, result), 1043)
        self.assertEqual((result.error_index, result.error_joint), (0, 2))
        larger.close()

    def test_refuses_frames_that_it_does_not_know(self):
        for kind, service, data in (("write_tool", WriteTool, ToolData(index=2, name="gripper", name_only=True)),
                                    ("write_frame", WriteFrame, FrameData(index=2, name="table", name_only=True)),
                                    ("write_frame", WriteFrame, FrameData(index=1, pose=six((0,))))):
            rospy.wait_for_service(kind, DEADLINE)
            answer = rospy.ServiceProxy(kind, service)(data)
            self.assertTrue(answer.success, answer.message)
        self.assert_blames(path(above(10, pose_type=PathPoint.TOOL, pose_id=2)), 1041, 0)
        self.assert_blames(path(above(10, ref_frame_type=PathPoint.USER, ref_frame_id=2)), 1042, 0)
        references = ((PathPoint.ROBOT, 0), (PathPoint.USER, 0), (PathPoint.USER, 1), (PathPoint.WORLD, 0))
        self.assert_blames(path(*(above(10, ref_frame_type=kind, ref_frame_id=i) for kind, i in references)), 1038, 3)

    def test_refuses_poses_that_lead_nowhere(self):
        good = over_the_bench(30)
        self.assert_blames(path_of_poses(good, over_the_bench(40, "tabel"), good), 1040, 1, words='point 1: its pose is in "tabel"')
        for quaternion in ((0, 0, 0, 0), (0, 0, 0, 1.01), (0, NAN, 0, 1)):
            self.assert_blames(path_of_poses(good, good, over_the_bench(30, quaternion=quaternion)), 1037, 2, words="its pose")
        self.assert_blames(path_of_poses(*[good] * 1001), 1010, words="poses has 1001")
        self.assert_blames(path_of_poses(good, over_the_bench(2000)), 1046, 1)
        for goal, words in ((path(poses=[good], number_of_moves=1), "path 0 points"),
                            (path_of_poses(good, joints=HOME + (0,) * 3), "target of its own"),
                            (path_of_poses(good, move_type=PathPoint.INCREMENTAL), "INCREMENTAL")):
            self.assert_blames(goal, 0x27A, words=words)
        self.assert_blames(from_file(poses=[good]), 0x279, words="template of the poses in path")

    def test_refuses_what_a_script_would_say_otherwise(self):
        goal = path(path_to_joints(20, 0, 90, 0, 90, 0, profile_type=PathPoint.MOD_SINE, acceleration_jerk=100),
                    execution=LoadPathGoal.SCRIPT, check_only=True)
        self.assert_rejected(self.robot.run(goal), 0x271, "MOD_SINE")
        result = self.assert_done(self.robot.run(with_changes(goal, {"allow_approximation": True})))
        self.assertTrue(result.approximations)

    def test_refuses_points_that_cannot_be_read(self):
        rows = [("/no/such/file.yaml", "no/such"), ("path.yaml", "absolute path"), ("/dev/zero", "a device"), ("/tmp", "a folder"),
                ("package://no_such_package/a.yaml", "no_such_package' is not found")]
        with tempfile.TemporaryDirectory() as folder:
            for name, text, words in (("broken", "points: [", "broken"), ("unknown", "points:\n  - {dance: 1}", "unknown.yaml:2: unknown key"),
                                      ("missing", "points: [{interpolation_type: PTP}]", "joints is missing")):
                file = pathlib.Path(folder) / f"{name}.yaml"
                file.write_text(text, encoding="utf-8")
                rows.append((str(file), words))
            for location, words in rows:
                self.assert_blames(LoadPathGoal(path_file=location, number_of_moves=1), 0x279, words=words)
            self.assert_blames(from_file(path=[path_to_joints(*HOME)]), 0x279, words="give one")


if __name__ == "__main__":
    import rostest

    rospy.init_node("load_path_test")
    rostest.rosrun("cobot_command", "load_path", LoadPath)
