#!/usr/bin/env python3
"""What goes wrong is told to everybody, once, until it is acknowledged."""
import rospy
from std_srvs.srv import Trigger

from cobot_command.msg import Message, MessageList
from cobot_command.srv import ReadMessages
from cobot_goals import line_to, to_joints
from cobot_test import CobotTestCase, Latest
from tf_frames import pose_in

TOO_FAST = {"speed": 101}


class Messages(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.establish_at_home()
        self.raised = Latest("messages", Message)
        self.pending = Latest("pending_messages", MessageList)
        self.reset()
        self.wait_for_pending(0)
        self.last_id = max((m.id for m in self.read().messages), default=0)

    def reset(self):
        return rospy.ServiceProxy("reset", Trigger)()

    def read(self, min_severity=0, after_id=0):
        return rospy.ServiceProxy("read_messages", ReadMessages)(min_severity=min_severity, after_id=after_id)

    def wait_for_pending(self, count):
        return self.pending.wait_for(lambda m: len(m.messages) == count, f"{count} pending messages").messages

    def refused(self):
        _, result = self.robot.run(to_joints(10, 0, 90, 0, 90, 0, **TOO_FAST))
        return result

    def test_tell_a_refused_goal_as_its_result_does(self):
        result = self.refused()
        message = self.raised.wait_for(lambda m: m.id > self.last_id, "the message")
        self.assertEqual((message.severity, message.type, message.code), (Message.ERROR, Message.CMD, result.error_id))
        self.assertEqual((message.origin, message.text, message.remedy),
                         ("move_absolute", result.error_description, result.remedy))
        self.assertTrue(message.pending)
        self.assertLess(abs((rospy.Time.now() - message.header.stamp).to_sec()), 60)
        self.assertEqual([(m.id, m.text) for m in self.wait_for_pending(1)], [(message.id, message.text)])

    def test_are_shown_to_who_comes_late(self):
        self.refused()
        self.wait_for_pending(1)
        late = Latest("pending_messages", MessageList)
        self.assertEqual(len(late.wait_for(lambda m: True, "a latched list").messages), 1)

    def test_are_one_of_one_cause(self):
        for _ in range(5):
            self.refused()
        self.wait_for_pending(1)
        self.assertEqual(len(self.read(after_id=self.last_id).messages), 1)

    def test_are_acknowledged_by_a_reset_and_kept(self):
        self.refused()
        self.wait_for_pending(1)
        answer = self.reset()
        self.assertTrue(answer.success, answer.message)
        self.assertIn("1 acknowledged", answer.message)
        self.wait_for_pending(0)
        kept = self.read(after_id=self.last_id).messages
        self.assertEqual([m.pending for m in kept], [False])

    def test_of_the_controller_stay_until_it_is_well_again(self):
        self.robot.operate("raise_error", 0x14058, "joint 3")
        message = self.wait_for_pending(1)[0]
        self.assertEqual((message.type, message.code), (Message.RC, 0x14058))
        self.assertIn("0x14058: no posture", message.text)
        answer = self.reset()
        self.assertFalse(answer.success)
        for word in ("0x14058", "no posture", "robot stick"):
            self.assertIn(word, answer.message)
        self.assertEqual(len(self.wait_for_pending(1)), 1)
        self.robot.operate("clear_error")
        self.robot.robot_status.wait_for(lambda m: m.error_code == 0, "the end of the error")
        self.assertTrue(self.reset().success)
        self.wait_for_pending(0)

    def test_of_an_emergency_stop_end_with_it(self):
        self.robot.operate("set_emergency_stop", True)
        stops = self.pending.wait_for(lambda m: any(x.type == Message.RA for x in m.messages), "the emergency stop")
        self.assertEqual([m.severity for m in stops.messages if m.type == Message.RA], [Message.WARNING])
        self.robot.operate("set_emergency_stop", False)
        self.robot.reset()  # the stop has closed the link: until the next one nobody knows
        self.establish_at_home()
        self.pending.wait_for(lambda m: all(x.type != Message.RA for x in m.messages), "its end")

    def test_are_read_from_a_severity_on(self):
        self.refused()
        self.assertTrue(self.read(28, self.last_id).messages)
        answer = self.read(29)
        self.assertFalse(answer.success)
        self.assertEqual(answer.error_id, 0x8D51)
        self.assertIn("29", answer.message)

    def test_tell_a_goal_that_never_came_to_its_block(self):
        goal = line_to(0, 0, 0, target_pose=pose_in("nowhere", (0, 0, 0), (1, 0, 0, 0)))
        _, result = self.robot.run(goal)
        self.assertEqual(result.error_id, 0x217)
        self.assertEqual([m.code for m in self.wait_for_pending(1)], [0x217])


if __name__ == "__main__":
    import rostest

    rospy.init_node("messages_test")
    rostest.rosrun("cobot_command", "messages", Messages)
