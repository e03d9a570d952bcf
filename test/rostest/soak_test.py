#!/usr/bin/env python3
"""Random goals of all actions for minutes or hours, with a fault every now and then; scripts/soak runs it.

Parameters: ~minutes, ~fault_period [s], ~seed (0: another one each time) and ~proxy, the program tm_fault_proxy."""
import random
import time
import unittest

import rospy

import process_watch
from load_run import DEADLINE, Load, ports
from soak_faults import Faults
from soak_wire import Wire
from waiting import wait_until

ROUND = 200  # goals
MOST_SHOWN = 20  # faults
WARM_UP = 1800.0  # [s], or a third of a shorter run
MOST_GROWTH = 4.0  # [MiB] of a run that is too short for a slope
MOST_SLOPE = 0.1  # [MiB/h]
SHORTEST_SLOPE = 3600.0  # [s] of measuring


class SoakTest(unittest.TestCase):
    def test_of_hours_of_goals_and_faults_ends_each_goal_and_leaves_the_node_as_it_was(self):
        wait_until(ports, "the ports of the controller", DEADLINE)
        wire = Wire(rospy.get_param("~proxy"), *ports())
        load = Load(rospy.get_param("~seed") or random.randrange(1, 10**6), lambda: wire.ports, stream_breaks=True)
        faults = Faults(load.seed, rospy.get_param("~fault_period"), load.pid, load.watch.complain, wire)
        start, samples, broken = time.monotonic(), [], []
        seconds = 60 * rospy.get_param("~minutes")
        faults.start()
        while time.monotonic() < start + seconds and len(broken) < MOST_SHOWN:
            broken += load.run_round(ROUND)
            samples.append((time.monotonic() - start, load.samples[-1]))
            print(f"{samples[-1][0]:.0f} s: {load.watch.counts['goals']} goals, {sum(faults.counts.values())} faults, "
                  f"{len(broken)} against the rules; {samples[-1][1]}", flush=True)
        faults.stop()
        load.finish()
        broken += load.judge(closed=True)
        wire.close()
        samples.append((time.monotonic() - start, process_watch.counts_of(load.pid)))
        self.report(load, faults, samples, broken)
        words = [f"{len(broken)} against the rules; seed:={load.seed}", *broken[:MOST_SHOWN]]
        self.assertTrue(not broken, "\n".join(words))
        self.assert_flat(samples)

    @staticmethod
    def report(load, faults, samples, broken):
        told = ", ".join(f"{count} {name}" for name, count in sorted(faults.counts.items()))
        late = settled(samples)
        print(f"\n{load.report()}\n  faults: {sum(faults.counts.values())}: {told}\n"
              f"  against the rules: {len(broken)}, goals without an end: {sum('without an end' in b for b in broken)}\n"
              f"  memory: {slope(late):.2f} MiB/h over the last {len(late)} of {len(samples)} samples", flush=True)

    def assert_flat(self, samples):
        late = settled(samples)
        for name in ("descriptors", "threads"):
            counts = [getattr(counts, name) for _, counts in late]
            self.assertLessEqual(min(counts[-3:]), min(counts[:3]), f"{name} grow: {counts}")
        if late[-1][0] - late[0][0] > SHORTEST_SLOPE:
            self.assertLessEqual(slope(late), MOST_SLOPE, "MiB/h")
        else:
            self.assertLessEqual((late[-1][1].kibibytes - late[0][1].kibibytes) / 1024, MOST_GROWTH, "MiB")


def settled(samples):
    """Those behind the warm-up."""
    warm = min(WARM_UP, samples[-1][0] / 3)
    return [s for s in samples if s[0] >= warm]


def slope(samples):
    """Of the memory [MiB/h], by least squares."""
    times, sizes = [t / 3600 for t, _ in samples], [c.kibibytes / 1024 for _, c in samples]
    mean_time, mean_size = sum(times) / len(times), sum(sizes) / len(sizes)
    spread = sum((t - mean_time)**2 for t in times)
    return sum((t - mean_time) * (s - mean_size) for t, s in zip(times, sizes)) / spread if spread else 0.0


if __name__ == "__main__":
    import rostest

    rospy.init_node("soak_test")
    rostest.rosrun("cobot_command", "soak", SoakTest)
