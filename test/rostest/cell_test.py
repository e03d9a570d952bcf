#!/usr/bin/env python3
"""Robots of a cell with their supervisor: what it grants, what people may ask of it, and what it makes of what fails."""
import os
import signal
import sys

import rospkg
import rospy
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray

from cobot_command.msg import BuildCellGoal, CellDistance, CellDistances, CellReport, CellRobot, CellState, CellZone, RunCellGoal, RunProgramGoal, StopGoal
from cobot_goals import turn
from cobot_test import program
from own_cell import NAMES, CellTestCase, kill, robot_in
from waiting import wait_until

NOT_READY, NOT_BUILT, ONLY_PROGRAMS, PROGRAM_UNKNOWN, CYCLES = 0x28A, 0x28B, 0x287, 0x288, 0x254


class Cell(CellTestCase):
    # --- All goes well.
    def test_runs_all_robots_which_wait_for_each_other_and_never_meet(self):
        sent = self.send_run(RunCellGoal(cycles=2))
        result = self.assert_done(sent.finish())
        self.assertEqual((result.robots, list(result.cycles_done)), (list(NAMES), [2, 2]))
        self.assertGreater(result.makespan.to_sec(), 1.0)
        self.assertEqual(result.least_distance, -1.0, "no monitor was heard")
        waits = [r.reason for f in sent.feedback for r in f.state.robots if r.state == CellRobot.WAITING]
        self.assertIn(CellRobot.ZONE_HELD, waits)
        self.wait_for_mode(CellState.READY)

    def test_takes_nothing_that_is_not_the_program_of_a_robot(self):
        outcome = self.robots["RA"].run(turn(5, 0, 0, 0, 0, 0))
        self.assert_rejected(outcome, ONLY_PROGRAMS)

    def test_holds_what_is_not_granted_yet_and_goes_on(self):
        self.assert_granted(self.ask("hold", True))
        sent = self.send_programs(cycles=1)
        self.wait_for_mode(CellState.HOLDING)
        self.wait_for_robot("RA", lambda r: r.reason == CellRobot.HOLDING, "held")
        self.assert_granted(self.ask("hold", False))
        for name in NAMES:
            self.assert_done(sent[name].finish())

    def test_lets_all_finish_at_home(self):
        sent = self.send_programs(cycles=0)
        self.wait_until_it_holds_a_zone("RA")
        self.assert_granted(self.ask("finish", True))
        for name in NAMES:
            self.assert_done(sent[name].finish())
        self.state.wait_for(lambda m: all(z.state == CellZone.FREE for z in m.zones) and
                            all(r.place == "HOME" for r in m.robots), "all at home")
        self.assert_rejected(self.send_run(RunCellGoal(cycles=1)).finish(), NOT_READY, "is finishing")

    # --- Goals that cannot be.
    def test_refuses_runs_that_cannot_be_and_says_why(self):
        for goal, error_id, words in ((RunCellGoal(cycles=-1), CYCLES, "cycles is -1"),
                                      (RunCellGoal(cycles=1, robots=["RC"]), PROGRAM_UNKNOWN, "RA, RB")):
            with self.subTest(words=words):
                self.assert_rejected(self.send_run(goal).finish(), error_id, words)
        first = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        self.assert_rejected(self.send_run(RunCellGoal(cycles=1)).finish(), NOT_READY, "another run_cell is running")
        first.cancel()
        first.finish()
        self.assert_granted(self.ask("hold", True))
        self.assert_rejected(self.send_run(RunCellGoal(cycles=1)).finish(), NOT_READY, "HOLDING")

    def test_builds_a_cell_and_tells_what_is_wrong_with_one(self):
        cells = os.path.join(rospkg.RosPack().get_path("cobot_command"), "config", "cells")
        written = os.path.join(self.folder, "new.artifact")
        sent = self.send_build(BuildCellGoal(cell_file=rospy.get_param("~cell_file"), artifact=written))
        result = self.assert_done(sent.finish())
        self.assertEqual((result.hash, result.stale), (self.state.message.hash, False))
        with open(written, "rb") as new, open(self.artifact, "rb") as known:
            self.assertEqual(new.read(), known.read())
        other = self.assert_done(self.send_build(BuildCellGoal(cell_file=os.path.join(cells, "handover.yaml"))).finish())
        self.assertTrue(other.stale, "the supervisor runs with another cell")
        outcome = self.send_build(BuildCellGoal(cell_file="/no/such.yaml", artifact=written)).finish()
        self.assert_aborted(outcome, NOT_BUILT, "/no/such.yaml")
        self.assert_rejected(self.send_build(BuildCellGoal(cell_file="such.yaml")).finish(), NOT_BUILT, "absolute")

    # --- What people ask for.
    def test_stops_all_whose_zones_stay_their_own_until_they_go_on(self):
        sent = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        self.wait_until_it_holds_a_zone("RA")
        self.assert_granted(self.ask("stop"))
        state, result = sent.finish()
        self.assertEqual(state, GoalStatus.ABORTED, result.error_description)
        for robot in self.robots.values():
            robot.wait_for_standstill()
        held = {z.name: z.owner for z in self.wait_for_mode(CellState.HOLDING).zones if z.owner}
        self.assertTrue(held)
        self.assert_granted(self.ask("hold", False))
        self.recover_all()
        self.assert_done(self.send_run(RunCellGoal(cycles=1)).finish())

    def test_a_cancel_stops_the_robots_and_recovered_they_go_on_home(self):
        sent = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        self.wait_until_it_holds_a_zone("RB")
        sent.cancel()
        self.assertEqual(sent.finish()[0], GoalStatus.PREEMPTED)
        for robot in self.robots.values():
            robot.wait_for_standstill()
        self.recover_all()
        self.assert_done(self.send_run(RunCellGoal(cycles=1)).finish())

    def test_the_example_stops_the_robots_whatever_signals_come_at_once(self):
        example = os.path.join(rospkg.RosPack().get_path("cobot_command"), "examples", "run_cell.py")
        runs = self.start(sys.executable, example, "--cycles", "0")
        self.wait_until_it_holds_a_zone("RA")
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            runs.signal(number)
        self.assertEqual(runs.wait(), 1)
        for robot in self.robots.values():
            robot.wait_for_standstill()
        self.recover_all()
        self.assert_done(self.send_run(RunCellGoal(cycles=1)).finish())

    def test_a_robot_at_home_can_be_taken_out_and_brought_back(self):
        self.assert_denied(self.ask("take_out", "RB", ""), "who")
        self.assert_denied(self.ask("take_out", "RX", "Ann"), "RA, RB")
        self.assert_granted(self.ask("take_out", "RB", "Ann"))
        self.assert_rejected(self.send_run(RunCellGoal(cycles=1)).finish(), NOT_READY, "RB is OUT")
        self.assert_done(self.send_run(RunCellGoal(cycles=1, robots=["RA"])).finish())
        self.assert_denied(self.ask("recover", "RB", "HOME>P +1", "Ann"), "no place")
        self.assert_granted(self.ask("recover", "RB", "HOME", "Ann"))
        self.assert_done(self.send_run(RunCellGoal(cycles=1)).finish())

    # --- What fails.
    def test_a_second_supervisor_does_not_take_the_place_of_the_first(self):
        second = self.start(program("cell_supervisor"), "__ns:=cell", "__name:=second",
                            f"_artifact:={self.artifact}", f"_journal:={self.journal}.other")
        self.assertEqual(second.wait(), 2)
        self.assertIn("another supervisor provides /cell/hold already", second.output())
        self.assert_granted(self.ask("hold", True))
        self.wait_for_mode(CellState.HOLDING)

    def test_a_supervisor_that_is_killed_goes_on_by_its_journal(self):
        sent = self.send_programs(cycles=2)
        self.wait_until_it_holds_a_zone("RA")
        epoch = self.state.message.epoch
        kill("/cell/cell_supervisor")
        self.supervisor.wait()
        self.state.forget()
        self.start_supervisor()
        self.assertEqual(self.state.wait_for(lambda m: m.mode == CellState.RUNNING, "the cell, running").epoch, epoch + 1)
        self.assert_aborted(self.send_run(RunCellGoal(cycles=1)).finish(), NOT_READY, "already runs a program")
        for name in NAMES:
            self.assert_done(sent[name].finish())

    def test_the_zones_of_a_robot_whose_node_died_are_nobodys_until_a_person_says_so(self):
        sent = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        zone = self.wait_until_it_holds_a_zone("RA")
        kill("/RA/command_node")
        self.wait_for_robot("RA", lambda r: r.state == CellRobot.LOST, "lost")
        self.state.wait_for(lambda m: any(z.name == zone and z.state == CellZone.QUARANTINED for z in m.zones), "quarantine")
        hindrances = (CellRobot.QUARANTINED, CellRobot.WOULD_BLOCK)
        self.wait_for_robot("RB", lambda r: r.reason in hindrances and "RA" in r.blocked_by, "waiting for RA")
        self.assert_denied(self.ask("confirm_clear", "RA", "", True), "who")
        self.assert_granted(self.ask("confirm_clear", "RA", "Ann", True))
        self.wait_for_robot("RA", lambda r: r.state == CellRobot.OUT, "out")
        self.wait_for_robot("RB", lambda r: r.state == CellRobot.MOVING, "on its way")
        sent.cancel()
        sent.finish()

    def test_a_robot_that_fails_is_told_while_the_others_are_still_at_it(self):
        sent = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        self.wait_until_it_holds_a_zone("RA")
        self.assert_done(self.robots["RB"].run(StopGoal()))
        wait_until(lambda: any(f.failures for f in sent.feedback), "what has failed")
        told = sent.feedback[-1]
        self.assertEqual((len(told.failures), told.open), (1, 1))
        self.assertTrue(told.failures[0].startswith("RB: "), told.failures)
        sent.cancel()
        result = sent.finish()[1]
        self.assertEqual(result.error_description, told.failures[0])
        self.assertEqual(result.failures, told.failures, "what a cancel stops has not failed")

    def test_a_monitor_that_fell_silent_is_told_of_and_has_measured_no_whole_run(self):
        distances = rospy.Publisher("/cell/distances", CellDistances, queue_size=1, latch=True)
        sent = self.send_run(RunCellGoal(cycles=0)).wait_until_active()
        distances.publish(CellDistances(pairs=[CellDistance(robot="RA", other="RB", known=True, now=0.5)]))
        self.state.wait_for(lambda m: "the monitor publishes nothing" in m.diagnosis, "that it is silent")
        sent.cancel()
        self.assertEqual(sent.finish()[1].least_distance, -1.0)
        distances.publish(CellDistances())
        self.state.wait_for(lambda m: "publishes nothing" not in m.diagnosis, "that it was heard again")
        distances.unregister()

    def test_reports_that_nobody_could_mean_are_counted_and_change_nothing(self):
        diagnosed = []
        rospy.Subscriber("/diagnostics", DiagnosticArray, diagnosed.append)
        reports = rospy.Publisher("/cell/reports", CellReport, queue_size=10)
        wait_until(lambda: reports.get_num_connections() > 0, "the supervisor's ear")
        known = robot_in(self.state.message, "RA")
        for bad in (CellReport(robot="RA", session=known.session, number=2 ** 60, joints=[float("nan")] * 6),
                    CellReport(robot="x" * 10000, session=1, number=1), CellReport(robot="RX", session=1, number=1)):
            reports.publish(bad)
        wait_until(lambda: any("malformed or of unknown robots" in s.message for m in diagnosed for s in m.status), "the diagnosis")
        self.assertEqual(robot_in(self.wait_for_mode(CellState.READY), "RA").state, CellRobot.READY)
        self.assert_done(self.send_run(RunCellGoal(cycles=1)).finish())


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_test")
    rostest.rosrun("cobot_command", "cell", Cell)
