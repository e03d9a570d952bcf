#!/usr/bin/env python3
"""Goals that wait for a frame: what takes away the commands that wait takes those, too, and nothing else does."""
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray

from cobot_command.msg import MoveRelativeActionGoal, MoveRelativeActionResult, ProgramControlGoal, StopGoal
from cobot_command.srv import FinishRequest
from cobot_goals import BUFFERED, line_to, relative
from cobot_test import Latest
from own_robot import OwnRobotTestCase
from tf_frames import pose_in
from waiting import wait_until


class GoalsThatWaitForAFrame(OwnRobotTestCase):
    """The node listens to tf from the first of them on, so that they wait for 3 s."""

    def setUp(self):
        super().setUp()
        self.start_command_node(tf_from_start="false", supervision_period=60, reply_timeout=60)
        self.go_home()
        self.far = self.start_far()

    def send_goals_that_wait(self):
        """The first for a frame that does not come, the others behind it."""
        goals = [line_to(0, 0, 0, target_pose=pose_in("nowhere", (0, 0, 0), (1, 0, 0, 0)), buffer_mode=BUFFERED),
                 relative(0, 0, 10, buffer_mode=BUFFERED), relative(0, 0, 20, buffer_mode=BUFFERED)]
        return [self.robot.send(goal).wait_until_known() for goal in goals]

    def assert_taken_away(self, sent, words):
        for goal in sent:
            outcome = goal.finish()
            self.assert_ended(GoalStatus.RECALLED, outcome)
            self.assertIn(words, outcome[1].error_description)

    def test_that_were_cancelled_before_they_came_say_so(self):
        name = self.robot.name_of("move_relative")
        results = Latest(f"{name}/result", MoveRelativeActionResult)
        goals = rospy.Publisher(f"{name}/goal", MoveRelativeActionGoal, queue_size=10)
        cancels = rospy.Publisher(f"{name}/cancel", GoalID, queue_size=10)
        statuses = Latest(f"{name}/status", GoalStatusArray)
        wait_until(lambda: goals.get_num_connections() and cancels.get_num_connections(), "the action server")

        cancels.publish(GoalID(id="early"))
        statuses.wait_for_any(lambda m: any(s.goal_id.id == "early" for s in m.status_list), "the cancel")
        goals.publish(MoveRelativeActionGoal(goal_id=GoalID(id="early"), goal=relative(0, 0, 1)))
        self.assert_says_why(results, "early", "cancelled by its id before the goal was received")

        now = rospy.Time.now()
        cancels.publish(GoalID(id="marker", stamp=now))
        statuses.wait_for_any(lambda m: any(s.goal_id.id == "marker" for s in m.status_list), "the cancel")
        old = GoalID(id="old", stamp=now - rospy.Duration(1))
        goals.publish(MoveRelativeActionGoal(goal_id=old, goal=relative(0, 0, 1)))
        self.assert_says_why(results, "old", "cancelled before the goal was received: an earlier cancel covers all goals")

    def assert_says_why(self, results, goal_id, words):
        result = results.wait_for_any(lambda m: m.status.goal_id.id == goal_id, "the result")
        self.assertEqual(result.status.status, GoalStatus.RECALLED)
        self.assertIn(words, result.result.error_description)
        self.assertIn("new goal", result.result.remedy)

    def test_are_taken_away_by_a_stop(self):
        sent = self.send_goals_that_wait()
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_taken_away(sent, "stopped by the stop block while a frame")
        self.assert_ended(GoalStatus.PREEMPTED, self.far.finish())

    def test_are_taken_away_by_finish_and_what_is_under_way_goes_on(self):
        sent = self.send_goals_that_wait()
        self.robot.finish(FinishRequest.MOVE)
        self.assert_taken_away(sent, "only the running command was to be finished")
        self.assertEqual(self.far.state(), GoalStatus.ACTIVE)

    def test_are_taken_away_by_the_cancel_of_what_is_under_way(self):
        sent = self.send_goals_that_wait()
        self.far.cancel()
        self.assert_taken_away(sent, "move_relative, was cancelled while a frame")
        self.assert_ended(GoalStatus.PREEMPTED, self.far.finish())
        self.assert_stops_on_its_way()

    def test_are_taken_away_by_the_cancel_of_the_connection(self):
        sent = self.send_goals_that_wait()
        self.robot.connect.cancel()
        self.assert_taken_away(sent, "the connection is being closed while a frame")
        self.assert_ended(GoalStatus.PREEMPTED, self.far.finish())

    def test_are_taken_away_by_the_failure_of_what_is_under_way_and_those_that_come_later_are_not(self):
        sent = self.send_goals_that_wait()
        self.robot.fault("drop_tag")  # the error itself is to be seen
        self.robot.operate("raise_error", 0x14058, "joint 3")
        self.assert_aborted(self.far.finish(), 0x222)
        self.assert_taken_away(sent, "move_relative, failed while a frame")
        self.robot.clear_error()
        self.robot.operate("clear_faults")
        self.assert_works()

    def test_are_taken_away_by_the_loss_of_the_link(self):
        sent = self.send_goals_that_wait()
        self.robot.operate("drop_connections")
        self.assert_aborted(self.far.finish(), 0x99)
        self.assert_taken_away(sent, "the link was lost")

    def assert_stay(self, sent):
        """Until their time is over."""
        self.assert_rejected(sent[0].finish(), 0x217, "nowhere")
        for goal in sent[1:]:
            goal.wait_until_queued()

    def test_stay_when_one_is_cancelled_that_waits_for_its_turn(self):
        queued = self.robot.send(relative(0, 0, 1, buffer_mode=BUFFERED)).wait_until_queued()
        sent = self.send_goals_that_wait()
        queued.cancel()
        self.assert_ended(GoalStatus.RECALLED, queued.finish())
        self.assert_stay(sent)

    def test_stay_when_a_pause_is_cancelled_that_goes_past_them(self):
        self.robot.fault("silence")  # it waits for its answer
        sent = self.send_goals_that_wait()
        self.robot.send(ProgramControlGoal(command=ProgramControlGoal.PAUSE)).wait_until_active().cancel()
        self.assert_stay(sent)


if __name__ == "__main__":
    import rostest

    rospy.init_node("intake_test")
    rostest.rosrun("cobot_command", "intake", GoalsThatWaitForAFrame)
