#!/usr/bin/env python3
"""The action of MoveIt and others, as they speak it, against a simulated controller over real sockets."""
import math

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from control_msgs.msg import (FollowJointTrajectoryAction, FollowJointTrajectoryFeedback, FollowJointTrajectoryGoal,
                              FollowJointTrajectoryResult, JointTolerance)
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

import provoked_errors
from cobot_goals import HOME, to_joints
from cobot_test import DEADLINE, Sent
from motion_checks import MotionTestCase

ACTION = "follow_joint_trajectory"
NAMES = [f"arm_{name}_joint" for name in ("shoulder_1", "shoulder_2", "elbow", "wrist_1", "wrist_2", "wrist_3")]
SHUFFLED = [3, 0, 5, 1, 4, 2]
NONE = JointTolerance(position=-1)
Result = FollowJointTrajectoryResult


def point(time, *degrees):
    return JointTrajectoryPoint(positions=[math.radians(d) for d in degrees], time_from_start=rospy.Duration(time))


def goal(*points, **changes):
    trajectory = JointTrajectory(joint_names=NAMES, points=list(points))
    return FollowJointTrajectoryGoal(trajectory=trajectory, **changes)


def smooth(last=(40, -10, 100, 10, 80, 20), duration=4.0, steps=40):
    """As a time parameterization makes it: many points, with velocities, from rest to rest."""
    made = []
    for i in range(steps + 1):
        share = i / steps
        way, speed = share * share * (3 - 2 * share), 6 * share * (1 - share) / duration
        at = point(duration * share, *(a + (b - a) * way for a, b in zip(HOME, last)))
        at.velocities = [math.radians(b - a) * speed for a, b in zip(HOME, last)]
        made.append(at)
    return made


def tolerances(position):
    return [JointTolerance(name=name, position=position) for name in NAMES]


def client(namespace=""):
    made = actionlib.ActionClient(namespace + ACTION, FollowJointTrajectoryAction)
    if not made.wait_for_server(rospy.Duration(DEADLINE)):
        raise AssertionError("nobody serves the action")
    return made


class FollowJointTrajectory(MotionTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.client = client()

    def send(self, wanted):
        return Sent(self.client, wanted)

    def start(self, wanted):
        sent = self.send(wanted).wait_until_active()
        self.robot.wait_for_motion()
        return sent

    def run_it(self, wanted):
        return self.send(wanted).finish()

    def assert_successful(self, outcome):
        state, result = outcome
        self.assertEqual((state, result.error_code), (GoalStatus.SUCCEEDED, Result.SUCCESSFUL), result.error_string)

    def assert_fails(self, state, code, error_id, outcome, words=""):
        found, result = outcome
        self.assertEqual((found, result.error_code), (state, code), result.error_string)
        self.assertTrue(result.error_string.startswith(f"16#{error_id:X} "), result.error_string)
        self.assertIn(words, result.error_string)
        provoked_errors.note(ACTION, error_id)

    def assert_refused(self, error_id, wanted, words="", code=Result.INVALID_GOAL):
        with self.subTest(hex(error_id), words=words):
            self.assert_fails(GoalStatus.REJECTED, code, error_id, self.run_it(wanted), words)

    def assert_stands(self):
        self.robot.wait_for_standstill()

    # --- The messages.
    def test_has_the_messages_of_everybody(self):
        for kind, checksum in ((FollowJointTrajectoryAction, "bc4f9b743838566551c0390c65f1a248"),
                               (FollowJointTrajectoryGoal, "69636787b6ecbde4d61d711979bc7ecb"),
                               (FollowJointTrajectoryResult, "493383b18409bfb604b4e26c676401d2"),
                               (FollowJointTrajectoryFeedback, "10817c60c2486ef6b33e97dcd87f4474"),
                               (JointTolerance, "f544fe9c16cf04547e135dd6063ff5be")):
            self.assertEqual(kind._md5sum, checksum, kind._type)

    # --- Done.
    def test_follows_what_moveit_sends(self):
        sent = self.send(goal(*smooth()))
        self.assert_successful(sent.finish())
        self.assert_stands_at((40, -10, 100, 10, 80, 20))
        told = [f for f in sent.feedback if f.actual.positions]
        self.assertGreater(len(told), 20)
        for feedback in told:
            self.assertEqual(feedback.joint_names, NAMES)
            for desired, actual, error in zip(feedback.desired.positions, feedback.actual.positions, feedback.error.positions):
                self.assertAlmostEqual(error, desired - actual)
                self.assertLess(abs(error), math.radians(10))
        self.assertGreater(told[-1].desired.time_from_start.to_sec(), 3.5)

    def test_takes_joints_in_any_order(self):
        wanted = goal(*smooth((40, 0, 90, 0, 90, 0)))
        wanted.trajectory.joint_names = [NAMES[i] for i in SHUFFLED]
        for at in wanted.trajectory.points:
            at.positions = [at.positions[i] for i in SHUFFLED]
            at.velocities = [at.velocities[i] for i in SHUFFLED]
        wanted.path_tolerance = list(reversed(tolerances(0.05)))
        self.assert_successful(self.run_it(wanted))
        self.assert_stands_at((40, 0, 90, 0, 90, 0))

    def test_derives_velocities(self):
        self.assert_successful(self.run_it(goal(point(0, *HOME), point(1, 20, 0, 90, 0, 90, 0), point(2, 30, 10, 90, 0, 90, 0))))
        self.assert_stands_at((30, 10, 90, 0, 90, 0))

    def test_goes_to_its_first_point(self):
        self.assert_successful(self.run_it(goal(point(2, 20, 0, 90, 0, 90, 0))))

    def test_begins_at_its_stamp(self):
        wanted = goal(*smooth(duration=2))
        wanted.trajectory.header.stamp = rospy.Time.now() + rospy.Duration(1.5)
        sent = self.send(wanted).wait_until_active()
        self.robot.wait_for_motion()
        self.assertGreater(rospy.Time.now(), wanted.trajectory.header.stamp)
        self.assert_successful(sent.finish())

    def test_with_the_stamp_of_now_begins_now(self):
        wanted = goal(*smooth(duration=2))
        wanted.trajectory.header.stamp = rospy.Time.now()
        self.assert_successful(self.run_it(wanted))

    # --- Ended from outside.
    def test_can_be_cancelled_in_the_middle(self):
        sent = self.start(goal(*smooth(duration=20)))
        sent.cancel()
        state, result = sent.finish()
        self.assertEqual((state, result.error_code), (GoalStatus.PREEMPTED, Result.SUCCESSFUL), result.error_string)
        self.assert_stands()

    def test_is_replaced_by_a_new_one(self):
        first = self.start(goal(*smooth(duration=20)))
        second = self.send(goal(point(3, *HOME)))
        self.assertEqual(first.finish()[0], GoalStatus.PREEMPTED)
        self.assert_successful(second.finish())
        self.assert_stands_at(HOME)

    def test_is_stopped_by_one_without_points(self):
        first = self.start(goal(*smooth(duration=20)))
        self.assert_successful(self.run_it(FollowJointTrajectoryGoal()))
        self.assertEqual(first.finish()[0], GoalStatus.PREEMPTED)
        self.assert_stands()

    # --- Tolerances.
    def straight_parts(self):
        """Of which a controller that makes straight parts of a PVT leaves the way."""
        middle = point(2, 30, 30, 90, 0, 90, 0)
        wanted = goal(point(0, *HOME), middle, point(4, 60, 0, 90, 0, 90, 0))
        for at in wanted.trajectory.points:
            at.velocities = [0] * 6
        middle.velocities = [math.radians(30), 0, 0, 0, 0, 0]
        return wanted

    def test_is_stopped_where_it_leaves_its_path_tolerance(self):
        self.robot.fault("pvt_linear")
        wanted = self.straight_parts()
        wanted.path_tolerance = [JointTolerance(name=NAMES[0], position=0.02)]
        self.assert_fails(GoalStatus.ABORTED, Result.PATH_TOLERANCE_VIOLATED, 0x2A4, self.run_it(wanted), "off the trajectory")
        self.assert_stands()
        self.assertLess(self.robot.true_joints.message.position[0], math.radians(55))
        self.robot.fault("pvt_linear", False)
        self.establish_again_at_home()

    def test_may_have_no_path_tolerance(self):
        self.robot.fault("pvt_linear")
        wanted = self.straight_parts()
        wanted.path_tolerance = tolerances(-1)
        self.assert_successful(self.run_it(wanted))

    def test_is_judged_by_its_goal_tolerance(self):
        self.robot.fault("early_tag", count=1)
        outcome = self.run_it(goal(*smooth()))
        self.assert_fails(GoalStatus.ABORTED, Result.GOAL_TOLERANCE_VIOLATED, 0x2A5, outcome)
        self.assert_stands()
        self.establish_again_at_home()
        self.robot.fault("early_tag", count=1)
        self.assert_successful(self.run_it(goal(*smooth(), goal_time_tolerance=rospy.Duration(20))))

    # --- Refused.
    def test_refuses_joints_that_are_not_its_own(self):
        for names, words in ((["joint_1", *NAMES[1:]], "joint_1 is not a joint of this robot"), (NAMES[:5], "arm_wrist_3_joint is missing"),
                             ([NAMES[1], *NAMES[1:]], "arm_shoulder_2_joint is listed twice"), ([*NAMES, "finger"], "finger")):
            wanted = goal(*smooth())
            wanted.trajectory.joint_names = names
            self.assert_refused(0x2A1, wanted, words, Result.INVALID_JOINTS)
        self.assert_refused(0x2A1, goal(*smooth(), goal_tolerance=[NONE]), "tolerance", Result.INVALID_JOINTS)

    def test_refuses_a_stamp_of_the_past(self):
        wanted = goal(*smooth())
        wanted.trajectory.header.stamp = rospy.Time.now() - rospy.Duration(2)
        self.assert_refused(0x2A2, wanted, "allowed", Result.OLD_HEADER_TIMESTAMP)

    def test_refuses_what_cannot_be_made(self):
        self.assert_refused(0x2A3, goal(point(0, 10, 0, 90, 0, 90, 0), point(2, *HOME)), "J1 is at 0.000 deg")
        self.assert_refused(0x2A0, goal(point(0, *HOME), point(0, 1, 0, 90, 0, 90, 0)), "point 1")
        self.assert_refused(0x2A0, goal(point(1, *HOME[:5])), "point 0")
        self.assert_refused(0x203, goal(point(9, 0, 0, 170, 0, 90, 0)), "on the path to point 0")
        self.assert_refused(0x204, goal(point(2, *HOME), point(2.2, 90, 0, 90, 0, 90, 0)), "on the path to point 1")
        self.assert_refused(0x206, goal(point(20000, 1, 0, 90, 0, 90, 0)), "h")
        self.assert_stands_at(HOME)

    def test_what_is_wrong_replaces_nothing(self):
        first = self.start(goal(*smooth(duration=6)))
        self.assert_refused(0x2A0, goal(point(-1, *HOME)))
        self.assert_successful(first.finish())

    def test_refuses_what_nobody_can_plan_or_hear(self):
        unmodelled = client("unmodelled/")
        outcome = Sent(unmodelled, goal(*smooth())).finish()
        self.assert_fails(GoalStatus.REJECTED, Result.INVALID_GOAL, 0x10, outcome)
        self.robot.operate("set_emergency_stop", True)
        self.robot.close()
        self.assert_refused(0x10, goal(*smooth()))

    # --- What fails on its way, for which control_msgs has no code.
    def test_fails_with_the_script_and_the_motion(self):
        for fault, text, error_id in (("ignore_script", "", 0x70), ("refuse_script", "", 0x80), ("cperr_script", "01", 0x224),
                                      ("false_tag", "", 0x110)):
            with self.subTest(fault):
                self.robot.fault(fault, count=1, text=text)
                self.assert_fails(GoalStatus.ABORTED, error_id, error_id, self.run_it(goal(*smooth(duration=2))))
                self.establish_again_at_home()

    def test_fails_with_the_link(self):
        sent = self.start(goal(*smooth(duration=20)))
        self.robot.operate("drop_connections")
        self.assert_fails(GoalStatus.ABORTED, 0x99, 0x99, sent.finish())

    def establish_again_at_home(self):
        self.robot.operate("clear_faults")
        self.robot.close()
        self.robot.establish()
        self.assert_done(self.robot.run(to_joints(*HOME)))


if __name__ == "__main__":
    import rostest

    rospy.init_node("follow_joint_trajectory_test")
    rostest.rosrun("cobot_command", "follow_joint_trajectory", FollowJointTrajectory)
