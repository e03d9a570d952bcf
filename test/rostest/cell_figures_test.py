#!/usr/bin/env python3
"""What a supervisor costs over ROS (P5): from a frame that is wanted to its first byte, while nobody holds what it needs. `scripts/figures cell`
runs it. Parameters: ~robots, a number that the artifact has, in a ring; ~cycles."""
import rospy

from cobot_command.msg import CellEvent, CellReport, RunProgramGoal
from figure import print_figure
from own_cell import CellTestCase
from waiting import wait_until

START = 300.0  # [s] for many nodes on few cores
CYCLES = 1200.0  # [s]


class CellFigures(CellTestCase):
    time_scale = 1

    @classmethod
    def setUpClass(cls):
        cls.names = [f"R{number + 1}" for number in range(rospy.get_param("~robots"))]
        super().setUpClass()

    def setUp(self):
        self.asked = {}
        super().setUp()
        self.reports = rospy.Subscriber("/cell/reports", CellReport, self.take, queue_size=1000)

    def take(self, report):
        """A booking or go that it waits for."""
        for event in report.events:
            if event.kind == CellEvent.WANTED:
                self.asked.setdefault(report.robot, set()).add(event.number)

    def wait_for_mode(self, mode):
        wait_until(lambda: self.state.message and self.state.message.mode == mode, f"the mode {mode} of the cell", START)

    def test_of_frames_that_nobody_is_in_the_way_of(self):
        free = self.names[::2] if len(self.names) > 4 else self.names[:1]
        sent = {name: self.robots[name].send(RunProgramGoal(cycles=rospy.get_param("~cycles"))) for name in free}
        wait_until(lambda: all(one.ended() for one in sent.values()), "the end of the cycles", CYCLES)
        waits = []
        for name in free:
            result = sent[name].handle.get_result()
            self.assertEqual(result.error_id, 0, result)
            each = len(self.asked[name]) / result.cycles_done
            waits += [1000 * w.to_sec() / each for w in result.waited[:result.cycles_done]]
        print_figure("P5", f"{len(self.names)} robots over ROS, a frame that is wanted to its first byte", waits, "ms",
                     10 if len(self.names) < 32 else 20)


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_figures_test")
    rostest.rosrun("cobot_command", "cell_figures", CellFigures)
