#!/usr/bin/env python3
"""An iris for minutes or hours, as nodes, with a fault every now and then and a person who sets right what that has left;
`scripts/soak cell` runs it. Parameters: ~minutes, ~fault_period [s], ~seed (0: another one each time)."""
import random
import time

import rospy
from std_srvs.srv import Trigger

import process_watch
from cell_faults import CellFaults
from cobot_command.msg import CellDistances, CellRobot, CellState, RunProgramGoal
from cobot_test import Latest, Robot, program
from own_cell import CellTestCase, robot_in
from soak_test import settled, slope

PATIENCE = 300.0  # [s] within which each robot ends a goal, whatever fails
MARGIN = 0.02  # [m]
LOOK_EVERY = 0.5  # [s]; as a person looks, and no condition to wait for
MOST_SLOPE = 0.1  # [MiB/h]
MOST_GROWTH = 4.0  # [MiB] of a run that is too short for a slope
SHORTEST_SLOPE = 2400.0  # [s] of measuring
WATCHED = ("/cell/cell_monitor", "/R1/command_node")
TO_RECOVER = (CellRobot.LOST, CellRobot.FAULT, CellRobot.OFF_PATH)


class CellSoak(CellTestCase):
    names = ("R1", "R2", "R3")
    time_scale = 1

    def setUp(self):
        super().setUp()
        self.start(program("cell_monitor"), "__ns:=cell", "__name:=cell_monitor",
                   f"_cell_file:={rospy.get_param('~cell_file')}", f"_artifact:={self.artifact}")
        self.distances = Latest("/cell/distances", CellDistances)
        self.distances.wait_for(lambda m: all(p.known for p in m.pairs), "the distances")
        self.seed = rospy.get_param("~seed") or random.randrange(1, 10**6)
        self.random = random.Random(self.seed)
        self.sent = dict.fromkeys(self.names)
        self.ended = dict.fromkeys(self.names, time.monotonic())
        self.goals, self.cycles, self.recoveries, self.alarms, self.least = 0, 0, 0, 0, float("inf")
        self.samples = {name: [] for name in WATCHED}

    def test_of_hours_with_faults_ends_every_goal_within_the_margin(self):
        faults = CellFaults(self, self.seed)
        begin = time.monotonic()
        end = begin + 60 * rospy.get_param("~minutes")
        due = begin + rospy.get_param("~fault_period")
        while time.monotonic() < end:
            self.attend()
            self.take_samples(begin)
            if time.monotonic() >= due:
                due += rospy.get_param("~fault_period")
                name = faults.make()
                print(f"{time.monotonic() - begin:.0f} s: {name}; {self.goals} goals, {self.cycles} cycles, {self.recoveries} recoveries, "
                      f"least distance {1000 * self.least:.1f} mm", flush=True)
            time.sleep(LOOK_EVERY)
        told = ", ".join(f"{count} {name}" for name, count in sorted(faults.counts.items()))
        print(f"\nseed {self.seed}: {self.goals} goals, {self.cycles} cycles, {self.recoveries} recoveries, "
              f"{self.alarms} alarms of the monitor, least distance {1000 * self.least:.1f} mm\n  faults: {told}", flush=True)
        self.assert_flat()

    # --- What the faults need of the cell.
    def cancel(self, robot):
        if self.sent[robot]:
            self.sent[robot].cancel()

    def forget(self, robot):
        """Its node is another one: what was sent to the one before has no end."""
        self.robots[robot] = Robot("/" + robot)
        self.sent[robot] = None

    # --- The person.
    def attend(self):
        state, distances = self.state.message, self.distances.message
        self.least = min([self.least, *(p.least for p in distances.pairs if p.known)])
        self.assertGreaterEqual(self.least, MARGIN, distances)
        if distances.alarmed:  # as it has to, where one that moves is not heard; refused while that lasts
            self.alarms += rospy.ServiceProxy("/cell/reset_monitor", Trigger)().success
        for name in self.names:
            robot = robot_in(state, name)
            unheard = state.mode == CellState.RECOVERY and robot.state == CellRobot.ABSENT
            if robot.state in TO_RECOVER or unheard:
                self.recover(name, robot.place)
            self.attend_to_goal(name)

    def attend_to_goal(self, name):
        sent = self.sent[name]
        if sent and sent.ended():
            result = sent.handle.get_result()
            self.goals += 1
            self.cycles += result.cycles_done if result else 0
            self.ended[name] = time.monotonic()
            self.sent[name] = None
        if not self.sent[name]:
            self.sent[name] = self.robots[name].send(RunProgramGoal(cycles=self.random.randint(1, 4)))
        self.assertLess(time.monotonic() - self.ended[name], PATIENCE, f"{name} has ended no goal; {self.state.message}")

    def recover(self, name, place):
        places = [place]
        for one in places:
            answer = self.ask("recover", name, one, "the test")
            if answer.success:
                self.recoveries += 1
                return
            # "by its joints it can be at P, W>1"
            words = answer.message.split("it can be at ")
            places += words[1].split(", ") if len(words) > 1 and len(places) < 20 else []

    # --- What it takes of the machine.
    def take_samples(self, begin):
        for name in WATCHED:
            if self.samples[name] and time.monotonic() - begin < self.samples[name][-1][0] + 10:
                continue
            self.samples[name].append((time.monotonic() - begin, process_watch.counts_of(process_watch.pid_of(name))))

    def assert_flat(self):
        for name in WATCHED:
            late = settled(self.samples[name])
            print(f"  {name}: {slope(late):.3f} MiB/h over {late[-1][0] - late[0][0]:.0f} s, {late[-1][1]}", flush=True)
            third = len(late) // 3  # those of nodes that are dead at the moment are missing
            self.assertLessEqual(max(c.descriptors for _, c in late[-third:]), max(c.descriptors for _, c in late[:third]), name)
            if late[-1][0] - late[0][0] > SHORTEST_SLOPE:
                self.assertLessEqual(slope(late), MOST_SLOPE, f"{name} [MiB/h]")
            else:
                self.assertLessEqual((late[-1][1].kibibytes - late[0][1].kibibytes) / 1024, MOST_GROWTH, f"{name} [MiB]")


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_soak_test")
    rostest.rosrun("cobot_command", "cell_soak", CellSoak)
