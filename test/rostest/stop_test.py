#!/usr/bin/env python3
"""The stop action against a simulated controller over real sockets."""
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import ExitListenNodeGoal, ProgramControlGoal, StopGoal
from cobot_goals import ABORTING, BUFFERED, HOME, SLOWLY, base, cycle, script, step, to_joints, turn
from motion_checks import MotionTestCase

NO_EFFECT = "nothing shows that the stop took effect"


class Stop(MotionTestCase):
    def test_is_done_when_the_robot_stands_and_takes_the_motion_away(self):
        sent = self.robot.start_slowly()
        stop = self.robot.send(StopGoal())
        self.assertEqual(self.assert_done(stop.finish()).error_description, "")
        self.robot.wait_for_standstill()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.assertIn(stop.feedback[0].STOPPING, [f.phase for f in stop.feedback])

    def test_that_is_ignored_tells_at_the_target_of_the_motion_that_nothing_shows_its_effect(self):
        sent = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, speed=1))
        self.robot.fault("ignore_stop", count=1)
        stopped = self.robot.run(StopGoal())
        self.assert_done(stopped)
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        for _, result in (stopped, sent.finish()):
            self.assertIn(NO_EFFECT, result.error_description)
        self.assert_stands_at((HOME[0] + 60, *HOME[1:]))

    def test_that_fails_holds_back_the_next_motion_until_one_is_confirmed(self):
        sent = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, speed=1))
        self.robot.fault("refuse_stop", count=1)
        self.assert_aborted(self.robot.run(StopGoal()), 0x225, "refused")
        self.assert_aborted(sent.finish(), 0x225, "refused")
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x227, "may still move")
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=ABORTING)))
        self.assert_stands_at(HOME)

    def test_is_done_when_nothing_moves(self):
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_takes_away_all_that_waits(self):
        running = self.robot.start_slowly()
        waiting = [self.robot.send(goal).wait_until_queued() for goal in
                   (turn(1, 0, 0, 0, 0, 0, buffer_mode=BUFFERED), base(buffer_mode=BUFFERED),
                    script("ChangeLoad(1)", buffer_mode=BUFFERED),
                    cycle(step(to_joints(*HOME)), buffer_mode=BUFFERED))]
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, running.finish())
        for sent in waiting:
            self.assert_ended(GoalStatus.RECALLED, sent.finish())
        self.robot.status.wait_for(lambda s: s.queue_depth == 0 and not s.open_tags, "an empty queue")

    def test_stops_a_blended_motion_that_is_done_for_its_goal(self):
        self.assert_done(self.robot.run(turn(60, 0, 0, 0, 0, 0, blending_enable=True, **SLOWLY)))
        self.robot.wait_for_motion()
        self.assert_done(self.robot.run(StopGoal()))
        self.robot.wait_for_standstill()

    def test_stops_a_motion_that_is_to_leave_the_listen_node_and_it_stays_there(self):
        sent = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, exit_node=True, **SLOWLY))
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_comes_with_the_cancel_of_a_motion_that_is_to_leave_the_listen_node(self):
        sent = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, exit_node=True, blending_enable=True, **SLOWLY))
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.robot.wait_for_standstill()
        self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_is_tried_outside_the_listen_node_and_tells_that_the_robot_may_move(self):
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == s.NOT_LISTENING, "the flow elsewhere")
        self.assert_aborted(self.robot.run(StopGoal()), 0x225, "listen")

    def test_works_again_when_the_entry_message_behind_an_exit_was_lost_or_came_before_the_reply(self):
        for fault, seconds in (("drop_entry", 0.0), ("corrupt_entry", 0.0), ("delay_reply", 0.5)):
            with self.subTest(fault):
                self.robot.fault(fault, count=1, seconds=seconds)
                self.assert_done(self.robot.run_and_reenter(ExitListenNodeGoal()))
                self.assert_done(self.robot.run(StopGoal()))
                self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_stops_a_paused_robot_for_good(self):
        sent = self.robot.start_slowly()
        self.assert_done(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.PAUSE)))
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.assert_done(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.RESUME)))
        self.robot.wait_for_standstill()

    def test_can_be_followed_by_a_motion_at_once(self):
        self.robot.start_slowly()
        self.robot.send(StopGoal()).wait_until_active()
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=BUFFERED)))
        self.assert_stands_at(HOME)

    def test_of_several_at_once_are_all_done(self):
        self.robot.start_slowly()
        for sent in [self.robot.send(StopGoal()) for _ in range(3)]:
            self.assert_done(sent.finish())


if __name__ == "__main__":
    import rostest

    rospy.init_node("stop_test")
    rostest.rosrun("cobot_command", "stop", Stop)
