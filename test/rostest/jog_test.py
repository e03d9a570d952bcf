#!/usr/bin/env python3
"""Jogs over real sockets, in real time: the arm stands within 250 ms of the last keep-alive, whoever dies."""
import math
import signal

import rospy
from actionlib_msgs.msg import GoalStatus
from std_msgs.msg import Empty

from cobot_command.msg import CommandStatus, JogGoal, JogResult, RobotStatus, StopGoal
from cobot_goals import step_of_joint, to_joints, turn, with_changes
from cobot_test import CobotTestCase, Latest, Robot
from listen_node import ListenNode
from own_nodes import Process
from waiting import wait_until

LICENSED = "licensed"
WITHIN = 0.25  # [s] from the last keep-alive
# A stamp is of when the node has taken the frame in: that is up to a period of the stream (15 ms) and what the machine is late later than
# the arm, and the keep-alive is heard by this test a little after the node, or before. Tests run beside others.
LATE = 0.06  # [s]
STANDS = math.radians(0.1)  # [rad/s], as the layer has it


def held(mode, which, direction=1, **changes):
    directions = [0] * 6
    directions[which] = direction
    return with_changes(JogGoal(mode=mode, directions=directions, speed=10, frame=JogGoal.ACTIVE, tool=JogGoal.ACTIVE), changes)


def step(mode, which, direction=1, **changes):
    return held(mode, which, direction, **{"increment_mm": 10, **changes})


class Holder:
    """Somebody who publishes keep-alives, in a process of his own, until he is killed."""

    def __init__(self, test, robot):
        topic = robot.name_of("jog_keep_alive")
        self._heard = []
        self._subscriber = rospy.Subscriber(topic, Empty, lambda _: self._heard.append(rospy.Time.now()), queue_size=1000, tcp_nodelay=True)
        self._process = Process("rostopic", "pub", "-r", "100", topic, "std_msgs/Empty", "{}")
        test.addCleanup(self._process.clear_away)
        # The node's own connection to him is made beside this one.
        wait_until(lambda: len(self._heard) >= 50, "keep-alives")

    def kill(self):
        """Returns when its last one was heard."""
        self._process.end(signal.SIGKILL)
        self._subscriber.unregister()
        return self._heard[-1]


class Jog(CobotTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.licensed = Robot(LICENSED)

    def setUp(self):
        super().setUp()
        self.establish_at_home()

    def at_home(self, robot):
        if robot is self.licensed:
            robot.reset()
            robot.establish()
            self.addCleanup(robot.close)
        self.assert_done(robot.run(to_joints(0, 0, 90, 0, 90, 0)))

    # --- Hold to run.
    def test_stands_within_250_ms_of_the_last_keep_alive(self):
        for robot, means in ((self.robot, JogResult.MOVES), (self.licensed, JogResult.VELOCITY)):
            self.at_home(robot)
            for goal in (held(JogGoal.AXES, 0), held(JogGoal.AXES, 0, -1, speed=60), held(JogGoal.FRAME, 1), held(JogGoal.TOOL, 5)):
                with self.subTest(means=means, goal=goal):
                    result = self.let_go(robot, goal)
                    self.assertEqual((result.ended_by, result.means), (JogResult.RELEASED, means), result.why)
                    self.assertGreater(max(abs(result.way), abs(result.turn)), 0.5)

    def let_go(self, robot, goal):
        holder = Holder(self, robot)
        sent = robot.send(goal).wait_until_active()
        robot.wait_for_motion()
        robot.wait_for_time_to_pass(0.3)
        last = holder.kill()
        result = self.assert_done(sent.finish())
        robot.joints.wait_for(lambda m: m.header.stamp > last + rospy.Duration(WITHIN + LATE), "frames behind the end")
        for joints in robot.joints.all():
            since = (joints.header.stamp - last).to_sec()
            if since > WITHIN + LATE:
                self.assertLess(max(abs(v) for v in joints.velocity), STANDS, f"{since:.3f} s behind the last keep-alive")
        return result

    def test_needs_somebody_who_holds_it(self):
        result = self.assert_done(self.robot.run(held(JogGoal.AXES, 0)))
        self.assertEqual(result.ended_by, JogResult.RELEASED)
        self.assertLess(result.turn, 18 * WITHIN)

    def test_stands_before_a_limit_and_says_which(self):
        self.assert_done(self.robot.run(to_joints(0, 0, 150, 0, 90, 0)))
        holder = Holder(self, self.robot)
        result = self.assert_done(self.robot.run(held(JogGoal.AXES, 2)))
        holder.kill()
        self.assertEqual((result.ended_by, result.joint), (JogResult.JOINT_LIMIT, 3), result.why)
        self.assertIn("in the other direction", result.why)
        self.assertAlmostEqual(result.final_joints[2], 155, delta=0.1)
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 2)), 0x203, "J3")

    def test_tells_how_it_goes(self):
        holder = Holder(self, self.robot)
        sent = self.robot.send(held(JogGoal.AXES, 2)).wait_until_active()
        self.robot.wait_for_motion()
        moving = sent.wait_for_feedback(lambda f: f.turn > 1, "a degree of way")
        self.assertEqual(moving.means, JogResult.MOVES)
        self.assertGreater(moving.room_deg, 50)
        self.assertLess(moving.keep_alive_age, 0.25)
        holder.kill()
        self.assert_done(sent.finish())

    def test_is_stopped_and_cancelled(self):
        holder = Holder(self, self.robot)
        sent = self.robot.start_slowly(held(JogGoal.AXES, 0))
        self.assert_done(self.robot.run(StopGoal()))
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        sent = self.robot.start_slowly(held(JogGoal.AXES, 0))
        sent.cancel()
        self.assert_ended(GoalStatus.PREEMPTED, sent.finish())
        self.robot.wait_for_standstill()
        holder.kill()

    # --- Increments.
    def test_makes_increments(self):
        before = self.robot.tool_pose.message.pose.position.z
        result = self.assert_done(self.robot.run(step(JogGoal.FRAME, 2, increment_mm=12.5)))
        self.assertEqual(result.ended_by, JogResult.INCREMENT_DONE)
        self.robot.wait_for_standstill()
        self.assertAlmostEqual(self.robot.tool_pose.message.pose.position.z - before, 0.0125, delta=2e-5)
        self.assertAlmostEqual(result.way, 12.5, delta=0.1)

    # --- What speaks against it.
    def test_refuses_wrong_parameters(self):
        nan = float("nan")
        self.assert_refuses([(held(3, 0), 0x8D12, "mode"), (held(JogGoal.AXES, 0, 2), 0x8D12, "directions"),
                             (held(JogGoal.AXES, 0, 0), 0x8D12, "all"), (step(JogGoal.AXES, 0), 0x8D12, "increment"),
                             (held(JogGoal.FRAME, 3, directions=[0, 0, 0, 1, 1, 0], increment_deg=5), 0x8C36, "1 1"),
                             (held(JogGoal.AXES, 0, speed=101), 0x26, "speed"), (held(JogGoal.AXES, 0, speed=nan), 0x200, "nan"),
                             (held(JogGoal.FRAME, 0, frame=16), 0x8D08, "16"), (held(JogGoal.TOOL, 0, tool=9), 0x8D35, "9")])

    def test_refuses_what_the_arm_cannot_make(self):
        self.assert_refuses([(step(JogGoal.FRAME, 2, -1, increment_mm=2000), 0x201, ""), (step_of_joint(300), 0x203, "J1"),
                             (step(JogGoal.TOOL, 5, increment_mm=0, increment_deg=180), 0x20A, "half a turn")])
        for start, goal, error_id in (((10, 15, 80, -5, 85, 20), step(JogGoal.FRAME, 0, increment_mm=3000), 0x202),
                                      ((0, -40, 130, 0, 90, 0), step(JogGoal.FRAME, 1, increment_mm=300, speed=100), 0x204),
                                      ((0, 0, 0, 0, 0, 0), step(JogGoal.FRAME, 2, -1, increment_mm=100, speed=1), 0x205)):
            self.assert_done(self.robot.run(to_joints(*start)))
            with self.subTest(hex(error_id)):
                self.assert_rejected(self.robot.run(goal), error_id)

    def test_begins_only_while_nothing_is_under_way(self):
        busy = self.robot.start_slowly()
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x8C33, "move_relative")
        busy.cancel()
        busy.finish()

    def test_needs_a_link_a_stream_a_model_and_time_to_plan(self):
        self.robot.operate("set_project_speed", 5)  # so that there is much to look at
        for namespace, goal, error_id in (("unmodelled/", held(JogGoal.AXES, 0), 0x209), ("hurried/", held(JogGoal.FRAME, 2, speed=1), 0x20C)):
            connect = self.robot.send(self.robot.connect_goal(), namespace)
            Latest(f"{namespace}command_status", CommandStatus).wait_for(
                lambda s: s.link_state == CommandStatus.READY and s.status_stream, "a ready link")
            Latest(f"{namespace}robot_status", RobotStatus).wait_for(lambda s: s.project_speed == 5, "the low project speed")
            with self.subTest(hex(error_id)):
                self.assert_rejected(self.robot.run(goal, namespace), error_id)
            connect.cancel()
            connect.finish()
        self.robot.close()
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x10)
        self.robot.send_connect(status_port=1)
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a link")
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x208)

    def test_is_refused_elsewhere_in_error_and_behind_an_emergency_stop(self):
        self.robot.operate("leave_listen_node")
        self.robot.status.wait_for(lambda s: s.link_state == CommandStatus.NOT_LISTENING, "a flow elsewhere")
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x220)
        self.robot.reset()
        self.robot.establish()
        self.robot.operate("raise_error", 0x14058, "joint 3")
        self.robot.robot_status.wait_for(lambda s: s.in_error == RobotStatus.TRUE, "the error")
        self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x222)
        self.robot.clear_error()
        self.robot.close()
        with ListenNode() as node:  # one that an emergency stop does not end
            self.robot.establish(port=node.port)
            self.robot.operate("set_emergency_stop", True)
            self.robot.robot_status.wait_for(lambda s: s.e_stopped == RobotStatus.TRUE, "the emergency stop")
            self.assert_rejected(self.robot.run(held(JogGoal.AXES, 0)), 0x221)
            self.robot.close()

    # --- What the wire does.
    def test_fails_as_other_commands_do(self):
        for faults, error_id in ((["ignore_script"], 0x70), (["refuse_script"], 0x80), (["false_tag"], 0x110), (["early_tag"], 0x226),
                                 (["drop_tag", "query_none"], 0x223), (["drop_tag", "drop_tag_answer"], 0x100)):
            with self.subTest(hex(error_id)):
                for fault in faults:
                    self.robot.fault(fault, count=1)
                self.assert_aborted(self.robot.run(step_of_joint(30, speed=10)), error_id)
                self.robot.operate("clear_faults")
                self.assert_done(self.robot.run(StopGoal()))  # it stands, as the layer sees it, too
        self.robot.fault("cperr_script", count=1, text="02")
        self.assert_aborted(self.robot.run(step_of_joint(5)), 0x224)

    def test_fails_with_a_link_that_is_lost(self):
        sent = self.robot.start_slowly(step_of_joint(60, speed=5))
        self.robot.operate("drop_connections")
        self.assert_aborted(sent.finish(), 0x99)

    def test_fails_where_its_stop_is_refused(self):
        sent = self.robot.start_slowly(step_of_joint(60, speed=5))
        self.robot.fault("refuse_stop", count=1)
        sent.cancel()
        self.assert_aborted(sent.finish(), 0x225, "refused")
        self.assert_done(self.robot.run(StopGoal()))


if __name__ == "__main__":
    import rostest

    rospy.init_node("jog_test")
    rostest.rosrun("cobot_command", "jog", Jog)
