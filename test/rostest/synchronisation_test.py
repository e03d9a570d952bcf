#!/usr/bin/env python3
"""Tables and the controller's project side by side, and what happens to motions while they differ."""
import rospy
from diagnostic_msgs.msg import DiagnosticArray

from cobot_command.msg import (DataSets, ExchangeConfigurationGoal, ExchangeParCmd, GroupState, ProgramControlGoal, RetraceGoal, StopGoal,
                               Transformation)
from cobot_command.srv import ReadFrame, ReadSoftwareLimits, WriteSoftwareLimits
from cobot_goals import BUFFERED, HOME, circle, cycle, path, path_to_joints, POSE, relative, script, step, step_of_joint, to_joints, turn
from cobot_test import CobotTestCase, Latest
from interrupting import ask, interrupt, way_back
from waiting import wait_until


def movers():
    """One goal of each block that may move the robot."""
    return [to_joints(*HOME), relative(0, 0, 20, 0, 0, 0), circle((450, 0, 500, 180, 0, 90), POSE), script("ChangeLoad(1)"),
            cycle(step(to_joints(*HOME))), path(path_to_joints(*HOME)), step_of_joint(5),
            RetraceGoal(point=RetraceGoal.START)]


class Synchronisation(CobotTestCase):
    def setUp(self):
        super().setUp()
        self.group = self.robot.latest("group_state", GroupState)
        self.addCleanup(self.robot.operate, "set_tcp", "gripper", Transformation(z=150))
        self.addCleanup(self.robot.operate, "set_base", "table", Transformation(x=400))

    def enable(self, reaction=ExchangeParCmd.NO_REACTION, **sets):
        enabled = DataSets(**(sets or {"tools": True}))
        sent = self.robot.send(ExchangeConfigurationGoal(par_cmd=ExchangeParCmd(
            log_level=ExchangeParCmd.LOG_INFO, life_sign_time_out=2000, sync_reaction=reaction, data_enable_sync=enabled,
            data_in_sync=enabled)))
        sent.wait_for_feedback(lambda f: f.enabled, "an enabled interface")
        return sent

    def end(self, exchange):
        exchange.cancel()
        exchange.finish()

    def change_the_pendant(self):
        self.robot.operate("set_tcp", "gripper", Transformation(z=160))
        self.group.wait_for(lambda s: "gripper" in s.out_of_sync, "the difference")

    def change_it_back(self):
        self.robot.operate("set_tcp", "gripper", Transformation(z=150))
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_SYNCHRONIZED, "data in sync")

    def assert_all_rejected(self, goals, error_id, words=""):
        for goal in goals:
            with self.subTest(type(goal).__name__):
                self.assert_rejected(self.robot.run(goal), error_id, words)

    def test_is_told_as_the_pendant_changes_a_tool(self):
        self.robot.establish()
        said = Latest("/diagnostics", DiagnosticArray)
        sent = self.enable()
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_SYNCHRONIZED and not s.out_of_sync, "data in sync")
        self.change_the_pendant()
        sent.wait_for_feedback(lambda f: not f.out_cmd.data_in_sync.tools and f.out_cmd.change_index_tool == 3, "the change")
        said.wait_for(lambda d: any("Exchange" in s.name and s.level == 1 and "gripper" in s.message for s in d.status),
                      "the diagnosis")
        self.change_it_back()
        self.end(sent)

    def test_takes_the_controllers_values_where_these_win(self):
        self.robot.establish()
        sent = self.enable(frames=True)
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_SYNCHRONIZED, "data in sync")
        self.robot.operate("set_base", "table", Transformation(x=410))
        read = rospy.ServiceProxy("read_frame", ReadFrame)
        wait_until(lambda: abs(read(4).frame.pose.x - 410) < 1e-3, "the frame of the pendant")
        self.end(sent)

    def test_tells_where_the_software_limits_go_beyond_those_of_the_safety_functions(self):
        self.robot.establish()
        limits = rospy.ServiceProxy("read_software_limits", ReadSoftwareLimits)()
        write = rospy.ServiceProxy("write_software_limits", WriteSoftwareLimits)
        self.addCleanup(write, limits.lowest, limits.highest)
        said = Latest("/diagnostics", DiagnosticArray)
        sent = self.enable(ExchangeParCmd.NO_ENABLE, software_limits=True)
        told = sent.wait_for_feedback(lambda f: not f.out_cmd.data_in_sync.software_limits, "the difference")
        self.assertNotIn("software_limits", told.local_sets)
        words = "limit J1 to -170..165 deg"
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_INITIALIZED and words in s.out_of_sync, "the difference in words")
        said.wait_for(lambda d: any("Exchange" in s.name and s.level == 1 and words in s.message for s in d.status), "the diagnosis")
        self.assert_rejected(self.robot.run(to_joints(*HOME)), 0x8C06, words)
        answer = write((-170,) + limits.lowest[1:], (165,) + limits.highest[1:])
        self.assertTrue(answer.success, answer.message)
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_SYNCHRONIZED and not s.out_of_sync, "limits that are inside")
        self.assert_done(self.robot.run(to_joints(*HOME)))
        self.end(sent)

    def test_refuses_motions_without_the_interface(self):
        self.robot.establish()
        self.assert_all_rejected(movers(), 0x8C05)

    def test_stops_a_robot_whose_interface_is_disabled(self):
        exchange = self.enable_at_home()
        busy = self.robot.start_slowly()
        self.end(exchange)
        self.assertIn("exchange_configuration, which motions require, was disabled", busy.finish()[1].error_description)

    def enable_at_home(self, **settings):
        self.robot.establish()
        exchange = self.enable(**settings)
        self.assert_done(self.robot.run(to_joints(*HOME)))
        return exchange

    def test_refuses_motions_where_the_data_were_never_in_sync(self):
        self.robot.establish()
        self.robot.operate("set_tcp", "gripper", Transformation(z=160))
        exchange = self.enable(ExchangeParCmd.NO_ENABLE)
        self.group.wait_for(lambda s: "gripper" in s.out_of_sync, "the difference")
        self.assert_all_rejected(movers(), 0x8C06, "160")
        self.change_it_back()
        self.assert_done(self.robot.run(to_joints(*HOME)))
        self.end(exchange)

    def test_interrupts_the_robot_until_it_is_resumed_in_sync(self):
        exchange = self.enable_at_home(reaction=ExchangeParCmd.INTERRUPT_AT_ONCE)
        busy = self.robot.start_slowly(turn(30, 0, 0, 0, 0, 0, speed=10))
        self.change_the_pendant()
        self.group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED, "an interrupted robot")
        self.assert_all_rejected(movers(), 0x8C30, "160")
        waits = self.robot.send(turn(-5, 0, 0, 0, 0, 0, buffer_mode=BUFFERED))
        waits.wait_for_feedback(lambda f: "interrupted" in f.text, "the reason")
        resume = ProgramControlGoal(command=ProgramControlGoal.RESUME)
        self.assert_rejected(self.robot.run(resume), 0x8C30)
        self.change_it_back()
        self.assertFalse(busy.ended())
        self.assert_done(self.robot.run(resume))
        self.assert_done(busy.finish())
        self.assert_done(waits.finish())
        self.group.wait_for(lambda s: s.sequence == GroupState.IDLE, "an idle robot")
        self.end(exchange)

    def test_refuses_the_way_back_of_an_interrupted_motion_for_the_same_reasons(self):
        exchange = self.enable_at_home()
        interrupt(self.robot)
        self.end(exchange)
        self.assert_rejected(self.robot.run(way_back()), 0x8C05)
        self.robot.operate("set_tcp", "gripper", Transformation(z=160))
        exchange = self.enable(ExchangeParCmd.NO_ENABLE)
        self.group.wait_for(lambda s: "gripper" in s.out_of_sync, "the difference")
        self.assert_rejected(self.robot.run(way_back()), 0x8C06, "160")
        self.change_it_back()
        self.end(exchange)
        exchange = self.enable(ExchangeParCmd.INTERRUPT_AT_ONCE)
        self.group.wait_for(lambda s: s.ri_state == GroupState.RI_SYNCHRONIZED, "data in sync")
        self.assert_done(self.robot.run(way_back()))
        self.change_the_pendant()
        wait_until(lambda: self.robot.run(way_back())[1].error_id == 0x8C30, "the reaction")
        self.assert_rejected(self.robot.run(way_back()), 0x8C30)
        answer = ask("continue")
        self.assertEqual(hex(answer.error_id), "0x8c30", answer.message)
        self.change_it_back()
        self.end(exchange)

    def test_leaves_the_stop_alone(self):
        exchange = self.enable_at_home(reaction=ExchangeParCmd.INTERRUPT_AT_ONCE)
        busy = self.robot.start_slowly(turn(30, 0, 0, 0, 0, 0, speed=10))
        self.change_the_pendant()
        self.group.wait_for(lambda s: s.sequence == GroupState.INTERRUPTED, "an interrupted robot")
        self.assert_done(self.robot.run(StopGoal()))
        busy.finish()
        self.change_it_back()
        self.group.wait_for(lambda s: s.sequence == GroupState.IDLE, "an idle robot")
        self.assert_done(self.robot.run(ProgramControlGoal(command=ProgramControlGoal.RESUME)))
        self.end(exchange)


if __name__ == "__main__":
    import rostest

    rospy.init_node("synchronisation_test")
    rostest.rosrun("cobot_command", "synchronisation", Synchronisation)
