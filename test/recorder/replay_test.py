#!/usr/bin/env python3
"""Replays find what is otherwise: each kind is made here once. Uses the programs tm_frame and tm_simulator. Needs no master.

Usage: replay_test.py TM_FRAME TM_SIMULATOR"""
import pathlib
import subprocess
import sys
import unittest

from bags import HOME, SOURCES, encoded, write_short_run
from flight import decoder_replay, simulator_replay
from flight.simulator import version_of
from reading_test import BagTestCase

TM_FRAME, TM_SIMULATOR = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))


class DecoderReplay(BagTestCase):
    def verdict(self, fill):
        def filled(maker):
            maker.joints(0)
            fill(maker)

        return decoder_replay.replay(self.made(filled), TM_FRAME)

    def assert_differs(self, what, came, fill):
        verdict = self.verdict(fill)
        self.assertEqual(len(verdict.differences), 1, verdict.differences)
        self.assertIn(what, verdict.differences[0].what)
        self.assertRegex(verdict.differences[0].came, came)
        return verdict.differences[0]

    def test_agrees_with_what_was_recorded(self):
        verdict = self.verdict(write_short_run)
        self.assertEqual((verdict.compared, verdict.differences), (5, []))

    def test_finds_a_damaged_frame(self):
        def fill(maker):
            maker.question(1)
            maker.frame(2, False, b"$TMSTA,15,00,true,Listen2,*79\r\n", "in a Listen node: Listen1", r"$TMSTA,15,00,true,Listen1,*79\r\n")

        difference = self.assert_differs("bytes of a frame that was received", r"Listen2.*checksum", fill)
        self.assertAlmostEqual(difference.time, 2, 3)
        self.assertIn("Listen1", difference.recorded)

    def test_finds_a_frame_that_is_damaged_with_its_text(self):
        self.assert_differs("meaning of a frame", "checksum", lambda maker: maker.receive(1, b"$TMSTA,2,00,*42\r\n", "in a Listen node?"))

    def test_finds_another_meaning(self):
        self.assert_differs("meaning of a frame that was sent", "in a Listen node", lambda maker: maker.send(1, b"$TMSTA,2,00,*41\r\n", "tag 1 complete?"))

    def test_what_was_damaged_on_the_wire_stays_so(self):
        def fill(maker):
            maker.receive(1, b"$TMSTA,2,00,*42\r\n", "not understood: checksum is 42, expected 41")
            maker.receive(2, encoded("TMSCT", "5,OK"), "script 5 accepted (no request waits for it)")

        self.assertEqual(self.verdict(fill).differences, [])

    def test_finds_what_was_refused_and_is_a_frame(self):
        self.assert_differs("a frame that was received", "script 5 accepted",
                            lambda maker: maker.receive(1, encoded("TMSCT", "5,OK"), "not understood: length"))

    def test_reads_frames_of_the_status_port(self):
        def fill(maker):
            maker.frame(1, True, encoded("TMSVR", "Q1,13,[]"), 'asks for items, as "Q1"', topic="status_frames")
            maker.question(2)

        verdict = self.verdict(fill)
        self.assertEqual((verdict.compared, verdict.differences), (3, []))


class SimulatorReplay(BagTestCase):
    def verdict(self, fill, **options):
        return simulator_replay.replay(self.made(fill), TM_SIMULATOR, **options)

    def assert_differs(self, verdict, *expected):
        self.assertEqual([(d.what, d.recorded, d.came.partition(" in ")[0]) for d in verdict.differences], list(expected))

    def test_agrees_with_a_run_that_the_simulator_makes_as_well(self):
        verdict = self.verdict(write_short_run)
        self.assertEqual(verdict.differences, [])
        self.assertEqual((verdict.compared, verdict.not_compared), (2, 1))  # reply and tag; the lifesign is only to be answered

    def test_finds_another_reply(self):
        verdict = self.verdict(lambda maker: write_short_run(maker, "ERROR;1"))
        self.assert_differs(verdict, ("reply to script 1", "TMSCT 1,ERROR;1", "TMSCT 1,OK"))

    def test_finds_a_tag_of_another_state(self):
        def fill(maker):
            maker.joints(0, HOME)
            maker.question(0)
            maker.script(0.1, "1", ['PTP("CPP",5000,0,0,0,0,0,50,200,0,false)', "QueueTag(2,0)"])  # out of reach
            maker.tag(0.2, 2)

        self.assert_differs(self.verdict(fill), ("tag 2", "TMSTA 01,02,true", "TMSTA 01,02,false"))

    def test_finds_what_does_not_come(self):
        def fill(maker):
            write_short_run(maker)
            maker.tag(1.4, 9)

        self.assert_differs(self.verdict(fill), ("tag 9", "TMSTA 01,09,true", "nothing"))

    def test_finds_what_nobody_has_recorded(self):
        def fill(maker):
            maker.joints(0)
            maker.send(0.1, encoded("TMSCT", "7,QueueTag(5,0)"), "run script 7: QueueTag(5,0)")
            maker.tag(0.2, 5)
            maker.question(3)

        self.assert_differs(self.verdict(fill), ("reply to script 7", "nothing", "TMSCT 7,OK"))

    def test_connects_anew_where_the_link_was_lost(self):
        def fill(maker):
            write_short_run(maker)
            for time, state in ((2.0, 0), (2.1, 1), (2.2, 2)):
                maker.link(time, state)
            maker.question(2.3)

        self.assertEqual(self.verdict(fill).differences, [])

    def test_begins_where_the_recorded_robot_stood(self):
        def fill(maker):
            maker.data()
            maker.joints(0, [10, -20, 100, 10, 80, -45])
            maker.joints(1, HOME)
            # A line of nothing: planned only from the posture that it ends in.
            maker.script(0.1, "1", ['PTP("JPP",10,-20,100,10,80,-45,50,200,0,false)', "QueueTag(2,0)"])
            maker.tag(0.15, 2)

        self.assertEqual(self.verdict(fill).differences, [])

    def test_tells_options_that_the_simulator_does_not_take(self):
        from flight.run import RunError
        with self.assertRaisesRegex(RunError, "does not accept"):
            self.verdict(write_short_run, options=["--no-such-option"])

    def test_takes_the_version_that_is_next(self):
        self.assertEqual([version_of(text) for text in ("1.80", "1.82.5100", "1.10", "2.14", "")], ["1.80", "1.82", "1.68", "1.84", None])


class Program(BagTestCase):
    def run_it(self, *arguments, stdout=subprocess.PIPE):
        return subprocess.run([sys.executable, SOURCES / "recorder/flight_replay.py", self.file, "--programs", self.programs(), *arguments],
                              stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=60, check=False)

    def programs(self):
        folder = pathlib.Path(self.file).parent
        for program in (TM_FRAME, TM_SIMULATOR):
            if not (folder / program.name).exists():
                (folder / program.name).symlink_to(program)
        return folder

    def test_ends_with_0_when_all_is_the_same(self):
        self.made(write_short_run)
        done = self.run_it()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("decoder: 5 compared, 0 differ", done.stdout)
        self.assertIn("simulator: 2 compared, 1 may differ, 0 differ", done.stdout)

    def test_ends_with_1_and_prints_when_what_was_recorded_and_what_came(self):
        self.made(lambda maker: write_short_run(maker, "ERROR;1"))
        done = self.run_it("--only", "simulator")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"0\.301 s  reply to script 1\n +recorded: TMSCT 1,ERROR;1\n +received: TMSCT 1,OK\n")
        self.assertNotIn("decoder", done.stdout)

    def test_ends_with_3_when_its_output_cannot_be_written(self):
        self.made(write_short_run)
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = self.run_it("--only", "decoder", stdout=full)
        self.assertEqual((done.returncode, done.stderr),
                         (3, "flight_replay.py: the output cannot be written: No space left on device\n"))

    def test_ends_with_2_when_the_bag_cannot_be_used(self):
        done = self.run_it()
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertRegex(done.stderr, "flight_replay.py: there is no bag")


if __name__ == "__main__":
    unittest.main()
