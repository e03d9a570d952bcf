#!/usr/bin/env python3
"""Two command nodes on one controller: no goal is done by the tag of another client, and each notices the other."""
import math

import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus, RetraceGoal, StopGoal
from cobot_goals import ABORTING, HOME, SLOWLY, motions, path, path_to_joints, step_of_joint, to_joints, turn
from cobot_test import CobotTestCase, Latest
from interrupting import interrupt, way_back

OTHER = "other/"
TAG = 2  # both ask for it by their command_id


class TwoClients(CobotTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.other_status = Latest(f"{OTHER}command_status", CommandStatus)

    def setUp(self):
        super().setUp()
        self.establish_at_home()
        self.robot.wait_for_standstill()
        self.other_connect = self.robot.send(self.robot.connect_goal(), OTHER)
        self.other_status.wait_for(lambda s: s.link_state == CommandStatus.READY and s.status_stream,
                                   "the ready link of the other")

    def tearDown(self):
        self.other_connect.cancel()
        self.other_connect.finish()

    def test_are_not_done_by_each_others_tags(self):
        first = self.robot.start_slowly(turn(10, 0, 0, 0, 0, 0, command_id=TAG, **SLOWLY))
        second = self.robot.send(to_joints(-40, 0, 90, 0, 90, 0, command_id=TAG, **SLOWLY), OTHER)
        self.assert_aborted(second.finish(), 0x226, "J1 is ")
        self.assert_done(first.finish())
        self.robot.wait_for_standstill()
        self.assertGreater(math.degrees(self.robot.true_joints.message.position[0]), -39,
                           "the robot was sent a stop command")

    def test_are_not_done_by_the_tag_of_who_has_stopped_them(self):
        first = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, command_id=TAG, **SLOWLY))
        self.assert_done(self.robot.run(StopGoal(), OTHER))
        self.assert_done(self.robot.run(turn(1, 0, 0, 0, 0, 0, command_id=TAG), OTHER))
        state, result = first.finish()
        self.assertEqual(state, GoalStatus.ABORTED)
        # The latter when the second motion of the other comes later than the layer asks what became of the first.
        self.assertIn(result.error_id, (0x226, 0x228), result.error_description)
        self.assertIn("J1 is ", result.error_description)

    def test_are_told_that_the_other_has_stopped_the_robot(self):
        goals = [*motions(**SLOWLY), step_of_joint(60, speed=2), path(path_to_joints(60, 0, 90, 0, 90, 0, speed=5))]
        goals[2].speed = 15
        for goal in goals:
            with self.subTest(type(goal).__name__):
                outcome = self.run_until_the_other_stops_it(goal)
                if outcome[1].error_id == 0x226:  # the other has completed a tag of that number before; the next is free
                    outcome = self.run_until_the_other_stops_it(goal)
                self.assert_aborted(outcome, 0x228, "from its target")
                self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_are_told_so_on_their_way_back_from_an_interruption(self):
        interrupt(self.robot, turn(60, 0, 0, 0, 0, 0, **SLOWLY))
        self.assert_done(self.robot.run(turn(0, 20, 0, 0, 0, 0)))
        outcome = self.run_until_the_other_stops_it(way_back(speed=2))
        if outcome[1].error_id == 0x226:
            outcome = self.run_until_the_other_stops_it(way_back(speed=2))
        self.assert_aborted(outcome, 0x228, "from its target")
        self.assert_done(self.robot.run(StopGoal()))

    def test_are_told_so_on_their_way_back_along_a_path(self):
        self.assert_done(self.robot.run(path(path_to_joints(60, 0, 90, 0, 90, 0))))
        back = RetraceGoal(point=RetraceGoal.START, speed=2)
        outcome = self.run_until_the_other_stops_it(back)
        if outcome[1].error_id == 0x226:
            outcome = self.run_until_the_other_stops_it(back)
        self.assert_aborted(outcome, 0x228, "from its target")

    def run_until_the_other_stops_it(self, goal):
        first = self.robot.start_slowly(goal)
        self.assert_done(self.robot.run(StopGoal(), OTHER))
        outcome = first.finish()
        self.robot.wait_for_standstill()
        return outcome

    def test_are_stopped_by_a_goal_of_the_other_that_takes_over(self):
        first = self.robot.start_slowly(turn(60, 0, 0, 0, 0, 0, command_id=TAG, **SLOWLY))
        self.assert_done(self.robot.run(to_joints(*HOME, buffer_mode=ABORTING, command_id=TAG), OTHER))
        state, result = first.finish()
        self.assertEqual(state, GoalStatus.ABORTED, "it would be done if the other had queued behind it")
        # The latter when the tag of the other has the same number.
        self.assertIn(result.error_id, (0x228, 0x226), result.error_description)

    def test_notice_each_other(self):
        own = self.robot.send(turn(60, 0, 0, 0, 0, 0, command_id=TAG, **SLOWLY), OTHER)
        self.robot.status.wait_for(lambda s: "no command of this node is running" in s.diagnosis,
                                   "the motion of another")
        own.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, own.finish())
        for tag in (7, 8, 9):  # one or two of them the first node may have given out itself
            self.assert_done(self.robot.run(to_joints(*HOME, command_id=tag), OTHER))
        self.robot.status.wait_for(lambda s: "another client commands this controller: tag " in s.diagnosis,
                                   "the tag of another")


if __name__ == "__main__":
    import rostest

    rospy.init_node("two_clients_test")
    rostest.rosrun("cobot_command", "two_clients", TwoClients)
