#!/usr/bin/env python3
"""What a supervisor costs over ROS (P5): from a frame that is wanted to its first byte, while nobody holds what it needs. `scripts/figures cell`
runs it. Parameters: ~robots, a number that the artifact has, in a ring; ~cycles."""
import time

import rospy

from cobot_command.msg import CellEvent, CellReport, RunProgramGoal
from own_cell import CellTestCase

START = 300.0  # [s] for many nodes on few cores


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
        begin = time.monotonic()
        while not self.state.message or self.state.message.mode != mode:
            self.assertLess(time.monotonic() - begin, START, self.state.message)
            time.sleep(0.1)

    def test_of_frames_that_nobody_is_in_the_way_of(self):
        free = self.names[::2] if len(self.names) > 4 else self.names[:1]
        sent = {name: self.robots[name].send(RunProgramGoal(cycles=rospy.get_param("~cycles"))) for name in free}
        begin = time.monotonic()
        while not all(s.ended() for s in sent.values()):
            self.assertLess(time.monotonic() - begin, 1200, "the end of the cycles")
            time.sleep(0.5)
        waits = []
        for name in free:
            result = sent[name].handle.get_result()
            self.assertEqual(result.error_id, 0, result)
            each = len(self.asked[name]) / result.cycles_done
            waits += [1000 * w.to_sec() / each for w in result.waited[:result.cycles_done]]
        self.print_figure(sorted(waits))

    def print_figure(self, waits):
        limit = 10 if len(self.names) < 32 else 20  # [ms]
        late = waits[(99 * len(waits) + 99) // 100 - 1]
        print(f"figure: | P5 | {len(self.names)} robots over ROS, a frame that is wanted to its first byte | {len(waits)} | "
              f"{waits[len(waits) // 2]:.3g} | {late:.3g} | {waits[-1]:.3g} | ms | 99 % {limit} | "
              f"{'holds' if late <= limit else 'OVER'} |", flush=True)


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_figures_test")
    rostest.rosrun("cobot_command", "cell_figures", CellFigures)
