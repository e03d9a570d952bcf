#!/usr/bin/env python3
"""Motions that the arm cannot make are refused before a byte is sent; a list of commands can be checked beforehand."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus, FrameTrace, MoveAbsoluteGoal, RobotStatus, SequenceStep, StopGoal
from cobot_goals import (BUFFERED, ELSEWHERE, HOME, POSE, SLOWLY, base, circle, cycle, line_to, ptp_to, relative, script,
                         sequence, step, tcp, to_joints, turn)
from cobot_test import CobotTestCase, Latest
import provoked_errors

FAST = {"speed": 4500, "accel_time": 150}


def slow_lines(count, **changes):
    """Lines of 300 mm at 1 mm/s, up and down: they are planned for long."""
    return [line_to(517.5, -122.3, 461.05 - 300 * (i % 2 == 0), 180, 0, 90, speed=1, **changes) for i in range(count)]


class Planning(CobotTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.frames = Latest("frames", FrameTrace)

    def setUp(self):
        super().setUp()
        self.establish_at_home()

    # --- Beside everything else.
    def test_delays_no_stop_and_no_check_of_the_link(self):
        moving = self.robot.start_slowly(turn(120, 0, 0, 0, 0, 0, speed=2))
        check = self.robot.send(sequence(*slow_lines(200)))
        self.assert_done(self.robot.run(StopGoal()))
        self.assertFalse(check.ended(), "it was planned before the robot was stopped")
        self.assertEqual(moving.finish()[0], GoalStatus.PREEMPTED)
        check.cancel()
        state, result = check.finish()
        self.assertEqual(state, GoalStatus.RECALLED, result.error_description)
        self.assertIn("while it was planned", result.error_description)

    def test_takes_no_more_checks_than_may_wait(self):
        # Each takes long, as one in front may be given up while the others are sent. No more at a time than actionlib's own
        # queues hold.
        self.set_project_speed(5)  # of 1 mm/s: each is planned for as long as it may
        self.addCleanup(self.set_project_speed, 100)
        checks = []
        while not any(self.was_refused(check) for check in checks):
            self.assertLess(len(checks), 100)
            burst = [self.robot.send(sequence(*slow_lines(200))) for _ in range(8)]
            checks += [check.wait_until_known() for check in burst]
        self.assertGreater(sum(not self.was_refused(check) for check in checks), 60)
        self.assert_rejected(next(check for check in checks if self.was_refused(check)).finish(), 0x216)
        self.assert_rejected(self.robot.run(slow_lines(1, check_only=True)[0]), 0x216)
        # By one message: of many at once, a loaded machine loses some, and each check that is left takes its whole budget.
        self.robot.client("check_sequence").cancel_all_goals()
        for check in checks:
            state, result = check.finish()
            self.assertTrue(state == GoalStatus.RECALLED or result.error_id in (0x216, 0x20C), (state, result))

    @staticmethod
    def was_refused(check):
        return check.ended() and check.finish()[1].error_id == 0x216

    def test_of_a_cycle_is_ended_with_its_goal(self):
        steps = [step(line) for line in slow_lines(50)]
        sent = self.robot.send(cycle(*steps)).wait_until_queued()
        sent.cancel()
        self.assertEqual(sent.finish()[0], GoalStatus.RECALLED)
        self.assert_done(self.robot.run(turn(1, 0, 0, 0, 0, 0)))

    def test_is_given_up_when_it_takes_too_long(self):
        connect = self.robot.send(self.robot.connect_goal(), "hurried/")
        Latest("hurried/command_status", CommandStatus).wait_for(
            lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
        self.robot.operate("set_project_speed", 5)  # of 1 mm/s: for more than an hour
        Latest("hurried/robot_status", RobotStatus).wait_for(lambda s: s.project_speed == 5, "the low project speed")
        slow = {"speed": 1, "check_only": True}
        goals = (relative(0, 0, -300, **slow), slow_lines(1, check_only=True)[0], slow_lines(1)[0],
                 script(*['Line("CAP",517.5,-122.3,161.05,180,0,90,1,200,0,false)',
                          'Line("CAP",517.5,-122.3,461.05,180,0,90,1,200,0,false)'] * 10),
                 circle((517.5, 0, 300, 180, 0, 90), (517.5, 120, 461, 180, 0, 90), **slow),
                 sequence(*slow_lines(50)), cycle(*[step(line) for line in slow_lines(50)]))
        for goal in goals:
            with self.subTest(type(goal).__name__):
                self.assert_rejected(self.robot.run(goal, "hurried/"), 0x20C)
        self.set_project_speed(100)
        connect.cancel()
        self.assert_done(connect.finish())

    def set_project_speed(self, percent):
        self.robot.operate("set_project_speed", percent)
        self.robot.robot_status.wait_for(lambda s: s.project_speed == percent, "the project speed")

    # --- One motion.
    def test_refuses_ways_that_leave_the_reach(self):
        self.assert_refuses_ways(0x201, (0, 0, -2000))

    def test_refuses_ways_that_need_another_posture(self):
        self.assert_done(self.robot.run(to_joints(10, 15, 80, -5, 85, 20)))
        self.assert_refuses_ways(0x202, (3000, 0, 0))

    def test_refuses_ways_on_which_a_joint_would_be_too_fast(self):
        self.assert_done(self.robot.run(to_joints(0, -40, 130, 0, 90, 0)))
        self.assert_refuses_ways(0x204, (0, 300, 0), **FAST)

    def test_refuses_ways_through_a_singularity(self):
        self.assert_done(self.robot.run(to_joints(0, 0, 0, 0, 0, 0)))
        self.assert_refuses_ways(0x205, (100, 0, -100), speed=10)

    def test_refuses_ways_that_take_too_long(self):
        self.assert_refuses_ways(0x206, (90000, 0, 0), speed=1)

    def test_refuses_half_turns_which_can_be_made_either_way_round(self):
        self.assert_refuses_ways(0x20A, (0, 0, -50), turned=180)
        start = (517.5, -122.3, 461.05, 180, 0)
        self.assert_refuses([(ptp_to(*start, 270), 0x20A, "half a turn"),
                             (line_to(*start, 269.5, check_only=True), 0x20A, "half a turn")])
        self.assert_done(self.robot.run(line_to(*start, 268, check_only=True)))

    def test_refuses_targets_beyond_the_limit_of_a_joint(self):
        for limit in (155, -155):
            self.assert_refuses([(to_joints(0, 0, limit * 1.001, 0, 90, 0), 0x203, "j3"),
                                 (turn(0, 0, limit * 1.001 - 90, 0, 0, 0), 0x203, "j3"),
                                 (script(f'PTP("JPP",0,0,{limit * 1.001},0,90,0,35,200,0,false)'), 0x203, "j3")])
        self.assert_done(self.robot.run(to_joints(0, 0, 154.9, 0, 90, 0, check_only=True)))

    def test_refuses_a_circle_beyond_the_limit_of_a_joint(self):
        arc, end = self.tool_at(265, 0, 90, 0, 90, 0), self.tool_at(-80, 0, 90, 0, 90, 0)
        self.assert_done(self.robot.run(to_joints(260, 0, 90, 0, 90, 0)))
        self.assert_refuses([(circle(arc, end), 0x203, "j1")])

    def test_records_the_frames_of_each_port_on_a_topic_of_its_own(self):
        status_frames = Latest("status_frames", FrameTrace)
        status_frames.wait_for(lambda m: True, "a frame of the status port")
        self.frames.forget()
        self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))
        self.frames.wait_for_any(lambda m: "complete" in m.meaning, "the tag of the motion")
        self.assertEqual({m.channel for m in status_frames.all()}, {FrameTrace.STATUS})
        self.assertEqual({m.channel for m in self.frames.all()}, {FrameTrace.SCRIPT})

    # --- check_only.
    def test_checks_without_sending_anything(self):
        self.frames.forget()
        for goal in (to_joints(*ELSEWHERE, check_only=True), relative(0, 0, 50, 0, 0, 0, check_only=True),
                     circle((450, 0, 500, 180, 0, 90), POSE, check_only=True)):
            with self.subTest(type(goal).__name__):
                result = self.assert_done(self.robot.run(goal))
                self.assertGreater(result.planned_duration.to_sec(), 0)
                self.assertEqual(result.actual_duration.to_sec(), 0)
                path = result.joint_path
                self.assertEqual(len(path.joint_names), 6)
                self.assertEqual([p.time_from_start for p in path.points],
                                 sorted(p.time_from_start for p in path.points))
                self.assertAlmostEqual(path.points[-1].time_from_start.to_sec(), result.planned_duration.to_sec(), 6)
        self.assertFalse([m.meaning for m in self.frames.all() if "script" in m.meaning])
        self.robot.wait_for_standstill()

    def test_checks_behind_what_is_under_way(self):
        busy = self.robot.start_slowly(to_joints(*ELSEWHERE, **SLOWLY))
        result = self.assert_done(self.robot.run(turn(1, 0, 0, 0, 0, 0, check_only=True)))
        self.assertAlmostEqual(result.joint_path.points[0].positions[0], 1.0471976, places=5)
        self.assertEqual(busy.state(), GoalStatus.ACTIVE)
        busy.cancel()
        busy.finish()

    # --- A sequence.
    def test_checks_a_sequence_of_all_kinds_of_steps_end_to_end(self):
        steps = (to_joints(*HOME), relative(0, 0, 50, 0, 0, 0), circle((450, 0, 500, 180, 0, 90), POSE),
                 base(0, 0, 100), tcp(0, 0, 50))
        result = self.assert_done(self.robot.run(sequence(*steps)))
        self.assertEqual(result.failed_step, -1)
        self.assertEqual(len(result.steps), len(steps))
        motions = [report for report in result.steps if report.joint_path.points]
        self.assertEqual(len(motions), 3)
        self.assertAlmostEqual(sum(report.duration.to_sec() for report in result.steps),
                               result.planned_duration.to_sec(), 6)
        for before, after in zip(motions, motions[1:]):
            self.assertEqual(before.joint_path.points[-1].positions, after.joint_path.points[0].positions)

    def test_needs_no_connection_to_check_a_sequence(self):
        self.robot.close()
        self.assert_done(self.robot.run(sequence(to_joints(*ELSEWHERE))))

    def test_says_which_step_of_a_sequence_fails_and_where(self):
        result = self.assert_step_fails(sequence(to_joints(*HOME), relative(0, 0, -2000, 0, 0, 0)), 1, 0x201)
        self.assertTrue(result.steps[1].offending_point_valid)
        self.assertLess(result.steps[1].offending_point.z, 300)
        self.assertAlmostEqual(result.steps[1].offending_point.x, 517.5, places=1)

    def test_names_the_first_violated_input_of_a_step(self):
        self.assert_step_fails(sequence(to_joints(*HOME, speed=0)), 0, 0x26)
        self.assert_step_fails(sequence(base(0, 0, 0), tcp(0, 0, 0, weight=15)), 1, 0x25)

    def test_refuses_blends_that_do_not_fit(self):
        absolute = line_to(417.5, -122.3, 353, 180, 0, 90, data_format=MoveAbsoluteGoal.CAR, blending_enable=True,
                           blending_value=200)
        blended = relative(0, 0, 20, 0, 0, 0, data_format=4, blending_enable=True, blending_value=200)
        after = relative(0, 0, 0, 0, 0, 0, target_position=relative(-100, 100, 0).target_position)
        self.assert_step_fails(sequence(absolute, after), 0, 0x207)
        self.assert_step_fails(sequence(blended, after), 0, 0x207)

    def test_refuses_motions_in_a_base_of_which_only_the_name_is_known(self):
        named = base(0, 0, 0, base_name="Table")
        pose = line_to(*POSE)
        pose.target_pose.header.frame_id = "base"
        pose.target_pose.pose.position.z = 0.4
        pose.target_pose.pose.orientation.x = 1
        arc = circle((450, 0, 500, 180, 0, 90), POSE)
        arc.end_pose = pose.target_pose
        for goal in (pose, relative(0, 0, 10, 0, 0, 0), arc):
            with self.subTest(type(goal).__name__):
                self.assert_step_fails(sequence(named, goal), 1, 0x231)

    def test_refuses_sequences_that_are_empty_too_long_or_unknown(self):
        one = base(0, 0, 0)
        self.assert_refuses([(sequence(), 0x250, "0 steps"), (sequence(*[one] * 201), 0x250, "201 steps"),
                             (sequence(one, steps=[SequenceStep(kind=5)]), 0x256, "")])
        self.assert_done(self.robot.run(sequence(*[one] * 200)))

    def test_takes_the_start_from_where_the_robot_will_be(self):
        busy = self.robot.start_slowly(to_joints(*ELSEWHERE, **SLOWLY))
        waiting = self.robot.send(turn(10, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)).wait_until_queued()
        result = self.assert_done(self.robot.run(sequence(turn(10, 0, 0, 0, 0, 0), start_joints=[])))
        self.assertAlmostEqual(result.steps[0].joint_path.points[0].positions[0], 1.2217305, places=5)
        busy.cancel()
        busy.finish()
        waiting.finish()

    # --- Helpers.
    def tool_at(self, *degrees):
        """[mm, deg]"""
        pose = self.assert_done(self.robot.run(to_joints(*degrees))).final_pose
        return pose.x, pose.y, pose.z, pose.rx, pose.ry, pose.rz

    def assert_refuses_ways(self, error_id, offset, turned=0, **changes):
        """The way from where the tool is: as an absolute and a relative line, nearly as an arc, and as a script."""
        start = self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 0))).final_pose
        rest = (start.rx, start.ry, start.rz + turned)
        end = (start.x + offset[0], start.y + offset[1], start.z + offset[2], *rest)
        arc = (start.x + offset[0] / 2 + 20, start.y + offset[1] / 2, start.z + offset[2] / 2 + 20, *rest)
        line = line_to(*end, **changes)
        numbers = ",".join(f"{value:.6f}" for value in end)
        lines = script(f'Line("CAP",{numbers},{line.speed},{line.accel_time},0,false)')
        goals = (line, relative(*offset, 0, 0, turned, **changes), circle(arc, end, **changes), lines)
        self.assert_refuses([(goal, error_id, "") for goal in goals])

    def assert_step_fails(self, goal, index, error_id):
        """The row of the step's own table counts as seen: it is its check that found it."""
        state, result = outcome = self.robot.run(goal)
        self.assert_rejected(outcome, 0x251, f"step {index + 1} of")
        self.assertEqual(result.failed_step, index)
        self.assertEqual(hex(result.steps[index].error_id), hex(error_id), result.error_description)
        block = ("move_absolute", "move_relative", "move_circle", "change_base", "change_tcp")[goal.steps[index].kind]
        provoked_errors.note(block, error_id)
        return result


if __name__ == "__main__":
    import rostest

    rospy.init_node("planning_test")
    rostest.rosrun("cobot_command", "planning", Planning)
