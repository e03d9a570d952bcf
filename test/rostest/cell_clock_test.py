#!/usr/bin/env python3
"""A cell while the ROS time jumps by an hour, or stands still (oracle 41): leases, ages and waits go by clocks that do neither."""
import rospy

from cobot_command.msg import CellRobot, CellState, RunCellGoal
from jumping_clock import AN_HOUR, JumpingClock
from own_cell import CellTestCase
from waiting import wait_until


class CellClock(CellTestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = JumpingClock()
        cls.clock.start()
        wait_until(lambda: rospy.get_time() > 0, "the first /clock")
        super().setUpClass()

    def test_runs_its_robots_while_the_time_jumps_and_stands_still(self):
        self.state.forget()
        sent = self.send_run(RunCellGoal(cycles=4)).wait_until_active()
        for seconds in (AN_HOUR, -AN_HOUR):
            self.wait_until_it_holds_a_zone("RA")
            self.clock.jump(seconds)
        self.clock.set_running(False)
        try:
            result = self.assert_done(sent.finish())
        finally:
            self.clock.set_running(True)
        self.assertEqual(list(result.cycles_done), [4, 4])
        self.wait_for_mode(CellState.READY)
        lost = [r.text for m in self.state.all() for r in m.robots if r.state in (CellRobot.LOST, CellRobot.FAULT)]
        self.assertEqual(lost, [])


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_clock_test")
    rostest.rosrun("cobot_command", "cell_clock", CellClock)
