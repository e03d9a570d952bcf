#!/usr/bin/env python3
"""What is worked out of a run: tags, times, speeds and paths. Needs no master."""
import math
import unittest

from actionlib_msgs.msg import GoalStatus

from bags import HOME, duration, encoded, write_short_run
from flight import commands, motion, tags
from flight.analysis import analyse
from reading_test import BagTestCase


class Tags(BagTestCase):
    def tags_of(self, fill):
        def filled(maker):
            maker.joints(0)
            fill(maker)

        return tags.tags_in(self.made(filled).script_frames)

    def test_goes_from_the_acceptance_of_its_script_to_its_report(self):
        tag, = tags.tags_in(self.made(write_short_run).script_frames)
        self.assertEqual((tag.number, tag.script, tag.motion, tag.outcome), (3, "1", "PTP", tags.DONE))
        self.assertEqual([round(t, 3) for t in (tag.sent, tag.accepted, tag.begun, tag.end)], [0.3, 0.301, 0.301, 1.3])

    def test_begins_behind_the_one_in_front_of_it(self):
        def fill(maker):
            maker.script(1, "1", ['PTP("JPP",1)', "QueueTag(1,0)", 'Line("CPP",1)', "QueueTag(2)"])
            maker.tag(2, 1)
            maker.tag(5, 2)

        first, second = self.tags_of(fill)
        self.assertEqual((first.motion, second.motion), ("PTP", "Line"))
        self.assertEqual([round(tag.begun, 3) for tag in (first, second)], [1.001, 2.0])

    def test_uses_its_number_again(self):
        def fill(maker):
            for begin in (1, 2):
                maker.script(begin, str(begin), ["QueueTag(1,0)"])
                maker.tag(begin + 0.5, 1)

        self.assertEqual([(tag.script, round(tag.end, 3)) for tag in self.tags_of(fill)], [("1", 1.5), ("2", 2.5)])

    def test_fails_when_it_is_told_false_and_nobody_has_asked(self):
        def fill(maker):
            maker.script(1, "1", ["QueueTag(1,0)"])
            maker.send(1.1, encoded("TMSTA", "01,01"), "tag 1 complete?")
            maker.tag(1.2, 1, "false")  # not yet
            maker.tag(1.3, 1, "false")

        tag, = self.tags_of(fill)
        self.assertEqual((tag.outcome, round(tag.end, 3)), (tags.FAILED, 1.3))

    def test_ends_when_its_script_is_refused_or_a_stop_drops_it(self):
        def fill(maker):
            maker.script(1, "1", ["PTP(", "QueueTag(1,0)"], "ERROR;1")
            maker.script(2, "2", ["QueueTag(2,0)"])
            maker.script(3, "3", ["StopAndClearBuffer()", "QueueTag(3,0)"])

        self.assertEqual([(tag.outcome, tag.end and round(tag.end, 3)) for tag in self.tags_of(fill)],
                         [(tags.REFUSED, 1.001), (tags.DROPPED, 3.001), (tags.OPEN, None)])


class Times(BagTestCase):
    def commands_of(self, fill):
        def filled(maker):
            maker.joints(0)
            maker.question(0)
            fill(maker)

        run = self.made(filled)
        return commands.commands_of(run, tags.tags_in(run.script_frames))

    def test_planned_and_actual_are_those_of_the_result(self):
        run = self.made(write_short_run)
        command, = commands.commands_of(run, tags.tags_in(run.script_frames))
        self.assertEqual((command.label, command.planned, command.actual, command.tag), ("move_absolute", 1.1, 1.0, 3))
        self.assertAlmostEqual(command.later, -0.1)

    def test_a_blended_one_is_timed_by_its_tag(self):
        def fill(maker):
            maker.goal(0.5, "move_absolute", blending_enable=True)
            maker.script(1, "1", ["QueueTag(4,0)"])
            maker.result(1.1, "move_absolute", planned_duration=duration(2), actual_duration=duration(0.001), command_id_ack=4)
            maker.tag(3.001, 4)

        command, = self.commands_of(fill)
        self.assertAlmostEqual(command.actual, 2.0, 3)

    def test_steps_of_a_cycle_are_timed_by_their_tags(self):
        def fill(maker):
            maker.goal(0.5, "pick_and_place")
            for step, begin in enumerate((1, 2, 3)):
                maker.script(begin, str(step + 1), ['Line("CAP",1)', f"QueueTag({step % 2 + 1},0)"])
                for time in (0.01, 0.2):
                    maker.feedback(begin + time, "pick_and_place", cycle=1, step=step, command_id_ack=step % 2 + 1, planned_duration=duration(0.5))
                maker.tag(begin + 0.501 + 0.1 * step, step % 2 + 1)
            maker.result(4, "pick_and_place", cycles_done=2, planned_duration=duration(2), actual_duration=duration(4.2))

        *steps, whole = self.commands_of(fill)
        self.assertEqual([(step.label, step.planned, round(step.actual, 3)) for step in steps],
                         [(f"cycle 1, step {i + 1}: Line", 0.5, round(0.5 + 0.1 * i, 3)) for i in range(3)])
        self.assertEqual((whole.label, whole.planned, whole.actual), ("pick_and_place, 2 cycles", 4, 4.2))

    def test_points_of_a_path_are_timed_from_one_to_the_next(self):
        def fill(maker):
            from cobot_command.msg import StepReport
            points = [StepReport(start=duration(start), duration=duration(1), done=duration(done)) for start, done in ((0, 1.1), (0.8, 2.0))]
            maker.result(4, "load_path", points=points, planned_duration=duration(1.8), actual_duration=duration(2))

        first, second, _ = self.commands_of(fill)
        self.assertEqual([round(v, 3) for v in (first.planned, first.actual, second.planned, second.actual)], [1, 1.1, 0.8, 0.9])

    def test_what_was_stopped_or_only_checked_says_nothing_of_its_plan(self):
        def fill(maker):
            maker.result(1, "move_absolute", "a", GoalStatus.PREEMPTED, planned_duration=duration(1), actual_duration=duration(0.2))
            maker.result(2, "move_absolute", "b", planned_duration=duration(1))

        self.assertEqual(self.commands_of(fill), [])

    def test_goals_that_failed_show_their_error(self):
        def fill(maker):
            maker.goal(1, "move_absolute", "a")
            maker.result(1.1, "move_absolute", "a", GoalStatus.REJECTED, error_id=0x205, error_description="out of reach", remedy="move it")
            maker.result(2, "load_path", "b", GoalStatus.REJECTED, error_id=1007, error_description="stopped")
            maker.question(0)
            maker.joints(0)

        refused, path = self.made(fill).goals
        self.assertEqual(commands.error_of(refused), ("16#205", "out of reach → move it"))
        self.assertEqual(commands.error_of(path), ("1007", "stopped"))


class Motion(BagTestCase):
    def test_limits_are_those_of_robot_data(self):
        def fill(maker):
            write_short_run(maker)
            maker.joints(2, [45, 0, 156, 0, 90, 0], [0, 0, 90, 0, 0, -450])

        uses = analyse(self.made(fill)).uses
        self.assertAlmostEqual(uses[0].margin, 225, 6)
        self.assertAlmostEqual(uses[2].margin, -1, 6)
        self.assertAlmostEqual(uses[2].share, 50, 6)
        self.assertAlmostEqual(uses[5].share, 200, 6)

    def test_without_robot_data_there_are_no_limits(self):
        def fill(maker):
            maker.joints(0)
            maker.question(0)

        use = analyse(self.made(fill)).uses[0]
        self.assertIsNone(use.margin)
        self.assertIsNone(use.share)

    def made_track(self, places, turning=True):
        def fill(maker):
            maker.question(0)
            for i, place in enumerate(places):
                late = 0.004 * (-1) ** i  # as the stream is late now and then
                maker.joints(0.015 * i + late, [0.3 * i if turning else 0, *HOME[1:]], [20 if turning else 0] * 6)
                maker.tool(0.015 * i + late, *place)

        return self.made(fill)

    def test_speed_of_the_tool_is_steady_though_the_stream_is_not(self):
        _, speeds = motion.tool_speed(self.made_track([(3.0 * i, 0, 0) for i in range(40)]))
        self.assertLess(max(abs(speed - 200) for speed in speeds[4:-4]), 12)

    def test_a_change_of_the_tool_is_no_motion(self):
        run = self.made_track([(0, 0, 100 if i < 20 else 220) for i in range(40)], turning=False)
        self.assertLess(max(motion.tool_speed(run)[1]), 1e-6)
        self.assertEqual(sum(math.isnan(row[0]) for row in motion.tool_path(run)), 1)

    def test_tells_how_far_the_tool_was_from_the_plan(self):
        def fill(maker):
            write_short_run(maker)
            for i in range(8):
                maker.tool(1.4 + i / 10, 500 * math.sqrt(0.5), 500 * math.sqrt(0.5), 300 + i)

        self.assertAlmostEqual(motion.deviation(self.made(fill)), 6, delta=1.1)


if __name__ == "__main__":
    unittest.main()
