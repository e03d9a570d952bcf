#!/usr/bin/env python3
"""What the command layer makes of a ROS time that jumps, or stands still: its own deadlines go by a clock that does not."""
import threading

import rospy
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from tf2_msgs.msg import TFMessage

from cobot_command.msg import CommandStatus
from cobot_goals import HOME, MODERATELY, line_to, ptp_to, to_joints, turn
from jumping_clock import AN_HOUR, JumpingClock
from motion_checks import MotionTestCase
from tf_frames import pose_in
from waiting import DEADLINE, wait_until

class ClockTest(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = JumpingClock()
        cls.clock.start()
        # From a time of zero on, the first /clock would end every wait with a limit.
        wait_until(lambda: rospy.get_time() > 0, "the first /clock")
        super().setUpClass()

    def test_lets_a_motion_come_to_its_end_and_keeps_the_link_when_the_time_jumps(self):
        for seconds in (AN_HOUR, -AN_HOUR):
            with self.subTest(seconds=seconds):
                sent = self.robot.start_slowly(turn(20, 0, 0, 0, 0, 0, **MODERATELY))
                self.jump(seconds)
                self.assertEqual(sent.state(), GoalStatus.ACTIVE)
                self.assert_done(sent.finish())
                self.assert_stands_at((20, 0, 90, 0, 90, 0))
                self.assertEqual(self.robot.status.message.link_state, CommandStatus.READY)
                self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_takes_targets_in_frames_and_cancels_after_a_jump(self):
        for seconds in (AN_HOUR, -AN_HOUR):
            with self.subTest(seconds=seconds):
                self.jump(seconds)
                for frame in ("base", "active_base"):
                    there = pose_in(frame, (0.4, 0.1, 0.5), (1, 0, 0, 0))
                    self.assert_done(self.robot.run(ptp_to(target_pose=there)))
                sent = self.robot.start_slowly()
                sent.cancel()
                self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
                self.assert_done(self.robot.run(to_joints(*HOME)))

    def test_works_on_while_the_time_stands_still(self):
        self.clock.set_running(False)
        try:
            self.assert_done(self.robot.run(line_to(400, 100, 500, 180, 0, 60)))
            sent = self.robot.start_slowly()
            sent.cancel()
            self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        finally:
            self.clock.set_running(True)

    def test_forgets_goals_that_have_ended_while_the_time_stands_still(self):
        lists = []
        subscriber = rospy.Subscriber("move_absolute/status", GoalStatusArray, lambda m: lists.append(len(m.status_list)))
        self.clock.set_running(False)
        try:
            self.assert_done(self.robot.run(to_joints(*HOME)))
            wait_until(lambda: lists and lists[-1] > 0, "the status of the goal")
            wait_until(lambda: lists[-1] == 0, "the end of that status")
        finally:
            self.clock.set_running(True)
            subscriber.unregister()

    def test_sends_no_frame_of_tf_twice_with_the_same_stamp_though_the_clock_is_slower_than_the_stream(self):
        sent, changed = [], threading.Condition()

        def take(message):
            with changed:
                sent.extend((t.child_frame_id, t.header.stamp) for t in message.transforms)
                changed.notify_all()

        subscriber = rospy.Subscriber("/tf", TFMessage, take, queue_size=1000)
        with changed:
            self.assertTrue(changed.wait_for(lambda: len(sent) > 100, DEADLINE), "frames of tf")
        subscriber.unregister()
        self.assertEqual(len(set(sent)), len(sent), sent)

    def jump(self, seconds):
        """Returns when the command node has seen it: its messages have stamps of the new time."""
        before = self.robot.joints.message.header.stamp
        self.clock.jump(seconds)
        self.robot.joints.wait_for(lambda m: abs((m.header.stamp - before).to_sec()) > AN_HOUR / 2, "the other time")


if __name__ == "__main__":
    import rostest

    rospy.init_node("clock_test")
    rostest.rosrun("cobot_command", "clock", ClockTest)
