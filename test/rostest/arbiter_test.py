#!/usr/bin/env python3
"""Whose turn it is when several goals come, over all actions of a robot."""
import math

import rospy
from actionlib_msgs.msg import GoalID, GoalStatus

from cobot_command.msg import CommandStatus, RobotStatus, StopGoal
from cobot_goals import (ABORTING, BUFFERED, HOME, MODERATELY, SLOWLY, base, line_to, queued, relative, script, tcp,
                         to_joints, turn)
from motion_checks import MotionTestCase
from tf_frames import pose_in
from waiting import wait_until


class Arbiter(MotionTestCase):
    # --- BUFFERED.
    def test_runs_buffered_goals_one_after_the_other_in_their_order(self):
        goals = [turn(20, 0, 0, 0, 0, 0, **MODERATELY), relative(0, 0, 20, buffer_mode=BUFFERED),
                 base(10, 0, 0, buffer_mode=BUFFERED), tcp(0, 0, 10, buffer_mode=BUFFERED),
                 script("ChangeLoad(1)", buffer_mode=BUFFERED), base(base_name="RobotBase", buffer_mode=BUFFERED),
                 tcp(tcp_name="NOTOOL", buffer_mode=BUFFERED), to_joints(*HOME, buffer_mode=BUFFERED)]
        sent = [self.robot.start_slowly(goals[0]), *(self.robot.send(goal) for goal in goals[1:])]
        for s in sent:
            self.assert_done(s.finish())
        self.assert_stands_at(HOME)

    def test_tells_the_places_of_those_that_wait_as_they_move_up(self):
        busy = self.robot.start_slowly()
        waiting = [self.robot.send(turn(1, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)) for _ in range(3)]
        for place, sent in enumerate(waiting, start=1):
            first = sent.wait_for_feedback(lambda f: f.place_in_queue > 0, "a place")
            self.assertEqual((first.place_in_queue, first.phase), (place, first.QUEUED))
            self.assertEqual(sent.state(), GoalStatus.PENDING)
        waiting[0].cancel()
        self.assert_ended(GoalStatus.RECALLED, waiting[0].finish())
        waiting[2].wait_for_feedback(lambda f: f.place_in_queue == 2, "the next place")
        self.assertEqual(busy.state(), GoalStatus.ACTIVE)
        busy.cancel()

    def test_refuses_at_once_what_cannot_be_done_from_where_the_others_will_leave_the_robot(self):
        busy = self.robot.start_slowly(turn(0, 0, 60, 0, 0, 0, **SLOWLY))
        self.assert_rejected(self.robot.run(turn(0, 0, 10, 0, 0, 0, buffer_mode=BUFFERED)), 0x203)
        self.assertEqual(busy.state(), GoalStatus.ACTIVE)
        busy.cancel()

    def test_starts_a_relative_motion_from_where_the_one_in_front_ends(self):
        first = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        second = self.robot.send(turn(10, 0, 0, 0, 0, 0, buffer_mode=BUFFERED))
        self.assert_done(first.finish())
        self.assert_done(second.finish())
        self.assert_stands_at((30, 0, 90, 0, 90, 0))

    def test_goes_on_from_a_blended_motion_without_a_stop(self):
        blended = turn(40, 0, 0, 0, 0, 0, blending_enable=True, blending_value=100, **MODERATELY)
        self.assert_done(self.robot.start_slowly(blended).finish())
        self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 40, buffer_mode=BUFFERED, **MODERATELY)))
        self.assert_stands_at((40, 0, 90, 0, 90, 40))

    def test_takes_a_goal_that_refuses_behind_a_blended_one(self):
        self.assert_done(self.robot.run(turn(10, 0, 0, 0, 0, 0, blending_enable=True, **SLOWLY)))
        self.assert_done(self.robot.run(turn(0, 0, 0, 0, 0, 10)))
        self.assert_stands_at((10, 0, 90, 0, 90, 10))

    # --- ABORTING.
    def test_lets_a_goal_take_over_from_all_others(self):
        busy = self.robot.start_slowly()
        waiting = self.robot.send(base(buffer_mode=BUFFERED)).wait_until_queued()
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=ABORTING)))
        for state, sent in ((GoalStatus.PREEMPTED, busy), (GoalStatus.RECALLED, waiting)):
            outcome = sent.finish()
            self.assert_ended(state, outcome)
            self.assertIn("move_absolute", outcome[1].error_description)
        self.assert_stands_at(HOME)

    def test_leaves_the_others_alone_when_the_one_that_would_take_over_is_wrong(self):
        busy = self.robot.start_slowly()
        self.assert_rejected(self.robot.run(to_joints(*HOME, speed=0, buffer_mode=ABORTING)), 0x26)
        self.assertEqual(busy.state(), GoalStatus.ACTIVE)
        busy.cancel()
        busy.finish()

    def test_does_not_run_what_would_take_over_when_the_stop_is_refused(self):
        for goal in queued(buffer_mode=ABORTING):
            with self.subTest(type(goal).__name__):
                busy = self.robot.start_slowly()
                self.robot.fault("refuse_stop", count=1)
                self.assert_rejected(self.robot.run(goal), 0x225, "may still move")
                self.assert_aborted(busy.finish(), 0x225)
                self.assert_done(self.robot.run(StopGoal()))
                self.assert_done(self.robot.run(to_joints(*HOME)))

    # --- What falls with whom.
    def test_ends_what_waits_behind_a_goal_that_is_cancelled_or_fails(self):
        for fails in (False, True):
            with self.subTest(fails=fails):
                busy = self.robot.start_slowly()
                waiting = [self.robot.send(goal).wait_until_queued() for goal in
                           (turn(1, 0, 0, 0, 0, 0, buffer_mode=BUFFERED), base(buffer_mode=BUFFERED))]
                if fails:
                    self.robot.operate("raise_error", 1, "a failure")
                else:
                    busy.cancel()
                busy.finish()
                for sent in waiting:
                    outcome = sent.finish()
                    self.assert_ended(GoalStatus.RECALLED, outcome)
                    self.assertIn("move_relative", outcome[1].error_description)

    def test_cancels_all_goals_of_an_action_by_an_empty_goal_id(self):
        busy = self.robot.start_slowly()
        waiting = [self.robot.send(turn(1, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)).wait_until_queued() for _ in range(2)]
        other = self.robot.send(base(buffer_mode=BUFFERED)).wait_until_queued()
        publisher = rospy.Publisher("move_relative/cancel", GoalID, queue_size=1)
        wait_until(publisher.get_num_connections, "the subscriber of move_relative/cancel")
        publisher.publish(GoalID())
        self.assert_ended(GoalStatus.PREEMPTED, busy.finish())
        for sent in [*waiting, other]:
            self.assert_ended(GoalStatus.RECALLED, sent.finish())
        self.robot.wait_for_standstill()

    def test_shows_busy_and_active_blocks_in_the_status(self):
        busy = self.robot.start_slowly()
        self.robot.send(base(buffer_mode=BUFFERED)).wait_until_queued()
        busy_blocks = lambda s: {b.block for b in s.blocks if b.busy}
        active_blocks = lambda s: [b.block for b in s.blocks if b.active]
        status = self.robot.status.wait_for(lambda s: "move_relative" in active_blocks(s), "the active block")
        self.assertLessEqual({"connect", "move_relative"}, busy_blocks(status))
        self.assertEqual(active_blocks(status), ["connect", "move_relative"])
        busy.cancel()
        busy.finish()
        aborted = self.robot.status.wait_for(lambda s: "move_relative" not in busy_blocks(s), "the idle block")
        self.assertEqual([b.block for b in aborted.blocks if b.block == "move_relative" and b.command_aborted],
                         ["move_relative"])

    # --- Frames of tf.
    def test_refuses_targets_in_frames_that_tf_cannot_connect_and_keeps_the_order_behind_them(self):
        lost = self.robot.send(line_to(0, 0, 0, target_pose=pose_in("nowhere", (0, 0, 0), (1, 0, 0, 0))))
        behind = self.robot.send(turn(1, 0, 0, 0, 0, 0))
        self.assert_rejected(lost.finish(), 0x217, "nowhere")
        self.assert_done(behind.finish())

    # --- The cell.
    def test_holds_a_motion_while_the_safeguard_is_open(self):
        sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
        self.robot.operate("set_safeguard", True)
        sent.wait_for_feedback(lambda f: f.phase == f.HELD, "HELD")
        self.robot.wait_for_standstill()
        self.robot.operate("set_safeguard", False)
        self.assert_done(sent.finish())
        self.assert_stands_at((20, 0, 90, 0, 90, 0))

    def test_moves_in_manual_mode_and_with_another_project_speed(self):
        self.robot.operate("set_manual_mode", True)
        self.robot.operate("set_project_speed", 50)
        self.robot.robot_status.wait_for(lambda s: s.project_speed == 50 and s.mode == RobotStatus.MODE_MANUAL,
                                         "half the speed")
        slow = self.assert_done(self.robot.run(turn(20, 0, 0, 0, 0, 0, **MODERATELY))).planned_duration
        self.robot.operate("set_project_speed", 100)
        self.robot.robot_status.wait_for(lambda s: s.project_speed == 100, "the whole speed")
        fast = self.assert_done(self.robot.run(turn(20, 0, 0, 0, 0, 0, **MODERATELY))).planned_duration
        self.assertGreater(slow.to_sec(), 1.4 * fast.to_sec())

    def test_resumes_nothing_after_a_lost_link(self):
        busy = self.robot.start_slowly()
        waiting = self.robot.send(turn(5, 0, 0, 0, 0, 0, buffer_mode=BUFFERED)).wait_until_queued()
        self.robot.operate("stop_project")
        self.assert_aborted(busy.finish(), 0x99)
        self.assertIn(waiting.finish()[0], (GoalStatus.RECALLED, GoalStatus.REJECTED))
        self.robot.operate("run_project")
        self.robot.establish()
        self.robot.wait_for_standstill()
        self.assertEqual(self.robot.status.message.queue_depth, 0)
        before = math.degrees(self.robot.true_joints.message.position[0])
        self.assert_done(self.robot.run(turn(1, 0, 0, 0, 0, 0)))
        self.robot.true_joints.wait_for(lambda m: abs(math.degrees(m.position[0]) - before - 1) < 1e-3, "one degree")
        self.assertEqual(self.robot.status.message.link_state, CommandStatus.READY)


if __name__ == "__main__":
    import rostest

    rospy.init_node("arbiter_test")
    rostest.rosrun("cobot_command", "arbiter", Arbiter)
