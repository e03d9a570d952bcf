#!/usr/bin/env python3
"""How nodes come to their end, in motion: by signals, by `rosnode kill`, by being killed or held up, and without a
master. Whatever it is, the arm must not just go on, and each goal has one end."""
import signal

import rosnode
import rospy
from actionlib_msgs.msg import GoalStatus

from cobot_command.msg import CommandStatus, MoveRelativeActionResult, PathPoint
from cobot_goals import cycle, line_to, path, path_to_joints, relative, script, sequence, step, to_joints, turn
from own_nodes import Heard, Master, node
from own_robot import FAR, PORTS, OwnRobotTestCase
from waiting import wait_until

END_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def up_and_down(lines):
    """A sequence of lines that are slow, and so planned for long."""
    x, y, z, *turned = 517.5, -122.3, 461.05, 180, 0, 90
    return sequence(*(line_to(x, y, z - 200 * (i % 2), *turned, speed=1) for i in range(lines)))


class EndsTestCase(OwnRobotTestCase):
    def assert_ended_by_the_node(self, sent, words="the command layer is shutting down"):
        state, result = sent.finish()
        self.assertEqual(state, GoalStatus.PREEMPTED, result)
        self.assertIn(words, result.error_description)


class AnEndThatIsAskedFor(EndsTestCase):
    def test_stops_the_robot_and_tells_every_client(self):
        ways = [(number.name, lambda n=number: self.command_node.signal(n)) for number in END_SIGNALS]
        ways += [("rosnode kill", lambda: rosnode.kill_nodes(["/command_node"])),
                 ("twice", lambda: [self.command_node.signal(n) for n in END_SIGNALS])]
        for name, ask in ways:
            with self.subTest(name):
                self.command_node = self.start_command_node()
                self.go_home()
                sent = self.start_far()
                waiting = self.robot.send(relative(0, 0, 1, 0, 0, 0, buffer_mode=1)).wait_until_queued()
                begun = rospy.get_time()
                ask()
                status = self.command_node.wait()
                print(f"{name}: gone after {rospy.get_time() - begun:.3f} s", flush=True)
                self.assertEqual(status, 0)
                self.assert_ended_by_the_node(sent)
                self.assert_ended_by_the_node(self.robot.connect)
                self.assertEqual(waiting.finish()[0], GoalStatus.RECALLED)
                self.assert_stops_on_its_way()

    def test_does_not_wait_long_for_a_robot_that_does_not_answer(self):
        command_node = self.start_command_node()
        self.go_home()
        sent = self.start_far()
        self.robot.fault("silence")
        status, seconds = command_node.end(signal.SIGTERM)
        print(f"silent robot: gone after {seconds:.3f} s", flush=True)
        self.assertEqual(status, 0)
        self.assert_ended_by_the_node(sent, "may still move")

    def test_while_a_sequence_is_planned_stops_the_robot_all_the_same(self):
        command_node = self.start_command_node(process=Heard)
        self.go_home()
        sent = self.start_far(speed=1)
        planned = self.robot.send(up_and_down(200)).wait_until_known()
        status, seconds = command_node.end(signal.SIGTERM)
        print(f"while it plans: gone after {seconds:.3f} s", flush=True)
        self.assertEqual(status, 0)
        self.assert_stops_on_its_way()
        self.assertEqual(planned.finish()[0], GoalStatus.RECALLED)
        self.assert_ended_by_the_node(sent)
        self.assertEqual(command_node.output().count("the robot is not stopped yet"), 0)

    def test_of_the_simulated_controller_ends_goals_and_the_next_one_is_found(self):
        for number in (*END_SIGNALS, signal.SIGKILL):
            with self.subTest(number.name):
                command_node = self.start_command_node()
                self.go_home()
                sent = self.start_far()
                status, _ = self.simulator.end(number)
                self.assertEqual(status, -number if number == signal.SIGKILL else 0)
                self.assert_aborted(sent.finish(), 0x99)
                self.assert_aborted(self.robot.connect.finish(), 0x90)
                self.assertEqual(rospy.has_param(PORTS), number == signal.SIGKILL, "the ports that it has told")
                self.start_simulator()
                self.assert_works()
                self.assertEqual(command_node.end(signal.SIGTERM)[0], 0)


class ANodeThatIsNotAsked(EndsTestCase):
    def test_when_it_was_killed_the_arm_goes_on_and_the_next_one_stops_it(self):
        corner = path_to_joints(FAR / 2, 0, 90, 0, 90, 0, speed=10, termination_type=PathPoint.BLEND, command_tolerance=20)
        end = path_to_joints(FAR, 20, 90, 0, 90, 0, speed=10)
        turns = [f'PTP("JPP",{angle},0,90,0,90,0,5,300,0,false)' for angle in (FAR / 2, FAR)]
        for goal in (turn(FAR, 0, 0, 0, 0, 0, speed=5), path(corner, end), script(*turns, await_motion=True),
                     cycle(step(to_joints(FAR, 0, 90, 0, 90, 0, speed=5)))):
            with self.subTest(type(goal).__name__):
                command_node = self.start_command_node()
                self.go_home()
                self.robot.send(goal).wait_until_active()
                self.wait_until_it_moves()
                command_node.end(signal.SIGKILL)
                later = rospy.Time.now() + rospy.Duration(0.5)
                self.robot.true_joints.wait_for(lambda m, later=later: m.header.stamp > later and max(map(abs, m.velocity)) > 0.02,
                                                "the arm that goes on")
                command_node = self.start_command_node()
                self.robot.establish()
                self.assert_stops_on_its_way()
                self.assert_works()
                command_node.end(signal.SIGTERM)

    def test_when_it_was_held_up_for_long_every_goal_has_one_end_and_the_link_recovers(self):
        command_node = self.start_command_node()
        self.go_home()
        ends = []
        rospy.Subscriber("move_relative/result", MoveRelativeActionResult, lambda m: ends.append(m.status.goal_id.id))
        sent = self.start_far()
        command_node.signal(signal.SIGSTOP)
        until = rospy.Time.now() + rospy.Duration(5)
        self.robot.true_status.wait_for(lambda m: m.header.stamp > until, "5 s of the controller")
        command_node.signal(signal.SIGCONT)
        state, _ = sent.finish()
        self.assertIn(state, (GoalStatus.SUCCEEDED, GoalStatus.ABORTED))
        self.robot.true_joints.wait_for(lambda m: max(abs(v) for v in m.velocity) < 1e-9, "standstill")
        if self.robot.connect.ended():
            self.assert_works()
        else:
            self.assert_done(self.robot.run(relative(0, 0, 1, 0, 0, 0)))
        self.assertEqual(ends.count(sent.handle.comm_state_machine.action_goal.goal_id.id), 1)


class WithoutAMaster(EndsTestCase):
    """The command node has a master of its own; the truth of the arm comes over that of the test."""

    def setUp(self):
        super().setUp()
        self.master = Master()
        self.addCleanup(lambda: self.master.clear_away())  # it may be another one then
        self.command_node = node("command_node", "command_node", master=self.master.uri, process=Heard, robot_model="tm5-900",
                                 auto_connect="true", robot_ip="127.0.0.1", script_port=self.robot.port(),
                                 status_port=self.robot.port("status_port"))
        self.addCleanup(self.command_node.clear_away)
        self.client("rostopic", "echo", "--filter", f"m.link_state == {CommandStatus.READY}", "-n1",
                    "/command_status").wait()
        self.result = self.client("rostopic", "echo", "-n1", "/move_relative/result")
        wait_until(lambda: self.master.is_sent("/command_node", "/move_relative/result"), "a listener of results")
        self.client("rostopic", "pub", "-1", "/move_relative/goal", "cobot_command/MoveRelativeActionGoal",
                    "{goal: {movement_command: 1, data_format: 0, target_position: {x: %d}, speed: 5, "
                    "accel_time: 300}}" % FAR)
        self.wait_until_it_moves()

    def client(self, *command):
        process = self.master.client(*command)
        self.addCleanup(process.clear_away)
        return process

    def assert_ends_orderly(self):
        status, seconds = self.command_node.end(signal.SIGTERM)
        self.assertEqual(status, 0)
        self.assert_stops_on_its_way()
        wait_until(lambda: "the command layer is shutting down" in self.result.output(), "the result")
        return seconds

    def test_the_node_works_on_and_ends_as_ever(self):
        self.master.end(signal.SIGKILL)
        self.assertTrue(self.command_node.is_alive())
        self.assert_ends_orderly()

    def test_the_node_ends_as_ever_with_a_master_that_was_started_anew(self):
        self.master.end(signal.SIGKILL)
        self.master = Master(self.master.port)
        self.assertTrue(self.command_node.is_alive())
        self.assert_ends_orderly()

    def test_the_node_does_not_wait_for_a_master_that_hangs(self):
        self.master.signal(signal.SIGSTOP)
        print(f"hanging master: gone after {self.assert_ends_orderly():.3f} s", flush=True)
        self.assertIn("3 s were not enough for removing its topics, services and parameters from the ROS master at "
                      + self.master.uri, self.command_node.output())


if __name__ == "__main__":
    import rostest

    rospy.init_node("ends_test")
    rostest.rosrun("cobot_command", "ends", "ends_test")  # all classes of this file
