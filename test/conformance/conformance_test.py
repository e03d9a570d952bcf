"""The conformance suite itself: its client, its lists, its verdicts.

Usage: conformance_test.py PROGRAM [unittest options]; PROGRAM is tm_simulator.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import report
import robot
import run_conformance
import suite
import tm_client

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RUNNER = [sys.executable, str(HERE / 'run_conformance.py')]
PROGRAM = ''


def run(*arguments, said=''):
    return subprocess.run([*RUNNER, *arguments], input=said, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=120)


class Client(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.golden = json.loads((ROOT / 'test/data/golden-frames.json').read_text(encoding='utf-8'))

    def test_reads_each_golden_frame_of_a_robot(self):
        frames = [frame for frame in self.golden if frame['valid'] and frame['direction'] == 'robot->client']
        self.assertGreater(len(frames), 20)
        for golden in frames:
            raw = bytes.fromhex(golden['hex'])
            with self.subTest(raw):
                frame, = tm_client.FrameReader().feed(raw)
                self.assertEqual((frame.header, len(frame.data)), (golden['header'], golden['length_actual']))
                self.assertEqual(tm_client.encode(frame.header, frame.data), raw)

    def test_writes_each_golden_frame_of_a_client(self):
        frames = [frame for frame in self.golden if frame['valid'] and frame['direction'] == 'client->robot']
        self.assertGreater(len(frames), 20)
        for golden in frames:
            raw = bytes.fromhex(golden['hex'])
            with self.subTest(raw):
                header, length, rest = raw[1:].split(b',', 2)
                written = tm_client.encode(header.decode(), rest[:int(length)])
                self.assertEqual(written[:-4], raw[:-4])
                self.assertEqual(written[-4:-2].lower(), raw[-4:-2].lower())

    def test_reads_frames_in_any_pieces(self):
        raw = tm_client.encode('TMSTA', '00,true,a') + tm_client.encode('TMSVR', b'0,1,\0$TMSTA,2,00,*41\r\n')
        for size in range(1, len(raw) + 1):
            reader = tm_client.FrameReader()
            frames = [frame for at in range(0, len(raw), size) for frame in reader.feed(raw[at:at + size])]
            self.assertEqual([frame.header for frame in frames], ['TMSTA', 'TMSVR'])

    def test_refuses_what_no_robot_may_send(self):
        good = b'$TMSTA,9,00,false,,*37\r\n'
        for bad in (b'x' + good, good.replace(b'*37', b'*38'), good.replace(b',9,',
                                                                            b',0x9,'), good.replace(b',9,', b',8,'),
                    good.replace(b'\r\n', b'\n\n'), tm_client.encode('CPERR', '04').replace(b'C\r', b'c\r')):
            with self.subTest(bad), self.assertRaises(tm_client.Violation):
                tm_client.FrameReader().feed(bad)

    def test_refuses_items_that_do_not_end(self):
        for bad in (b'\1', b'\5\0Ctrl', b'\1\0a', b'\1\0a\4\0\0'):
            with self.subTest(bad), self.assertRaises(tm_client.Violation):
                tm_client.unpack_items(bad)

    def test_reads_the_items_it_writes(self):
        items = [('Robot_Link', b'\1'), ('g_ss', b'Hello\0\0World')]
        self.assertEqual(tm_client.unpack_items(tm_client.pack_items(*items)), items)


class Lists(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.checks = suite.load()

    def test_every_section_of_the_facts_has_checks(self):
        self.assertEqual({check.section for check in self.checks}, set(report.SECTIONS))

    def test_every_check_says_all_about_itself(self):
        for check in self.checks:
            with self.subTest(check.id):
                self.assertRegex(check.id, r'^TM-[123]\.\d\.\d\d$')
                self.assertIn(check.certainty, suite.CERTAINTIES)
                self.assertIn(check.since, suite.VERSIONS)
                self.assertIn(check.version, suite.VERSIONS)
                self.assertTrue(check.holds_in(check.version))
                self.assertLessEqual(set(check.setup), {*robot.OPTIONS, 'operator'})
                self.assertTrue(check.promise and check.source)

    def test_no_promise_is_made_twice(self):
        promises = [check.promise for check in self.checks]
        self.assertEqual(sorted(set(promises)), sorted(promises))

    def test_a_safe_check_moves_and_writes_nothing(self):
        """As far as the text of a check can tell."""
        words = re.compile(r'ScriptExit\(|StopAndClearBuffer\(|_DO\d+=|Stick_')
        for check in self.checks:
            if check.safe:
                names = set(check.function.__code__.co_names)
                constants = ' '.join(map(str, check.function.__code__.co_consts))
                with self.subTest(check.id):
                    self.assertFalse(
                        names & {'move', 'observe', 'press', 'write', 'LONG', 'SHORT', 'pack_items', 'stop_project'})
                    self.assertIsNone(words.search(constants) if 'refuses' not in names else None)

    def test_the_page_is_current(self):
        page = run('--list', '--markdown').stdout
        self.assertEqual((ROOT / 'doc/conformance.md').read_text(encoding='utf-8'), page,
                         'run_conformance.py --list --markdown > doc/conformance.md')


class FakeSimulator:
    """Robots that are only closed."""

    class Robot:
        closed = False

        def close(self):
            FakeSimulator.Robot.closed = True

    def missing(self, _):
        return []

    def start(self, _):
        return self.Robot()


class Verdicts(unittest.TestCase):
    OPTIONS = argparse.Namespace(jobs=2, verbose=False, not_yet=pathlib.Path('not_yet.txt'), json=None, junit=None)

    def outcomes(self, function, not_yet):
        check = suite.Check('TM-1.1.01', 'a promise', function, '?', suite.CHOICE, '1.68', None, False, {})
        results = run_conformance.on_simulators([check], FakeSimulator(), not_yet, self.OPTIONS)
        return [result.outcome for result in results]

    @staticmethod
    def broken(_):
        raise AssertionError('broken')

    @staticmethod
    def kept(_):
        pass

    @staticmethod
    def crashed(_):
        raise KeyError('Joint_Angle')

    def test_a_promise_that_is_kept(self):
        self.assertEqual(self.outcomes(self.kept, {}), [report.PASSED])
        self.assertTrue(FakeSimulator.Robot.closed)

    def test_a_promise_that_is_broken(self):
        self.assertEqual(self.outcomes(self.broken, {}), [report.FAILED])
        self.assertEqual(self.outcomes(self.crashed, {}), [report.FAILED])
        self.assertIn(report.FAILED, report.BAD)

    def test_what_is_known_not_to_be_done_yet(self):
        self.assertEqual(self.outcomes(self.broken, {'TM-1.1.01': 'no such thing'}), [report.KNOWN])
        self.assertNotIn(report.KNOWN, report.BAD)

    def test_a_known_failure_that_is_none_any_more(self):
        self.assertEqual(self.outcomes(self.kept, {'TM-1.1.01': 'no such thing'}), [report.UNEXPECTED])
        self.assertIn(report.UNEXPECTED, report.BAD)


class Runner(unittest.TestCase):
    """Over loopback, with a simulator that stands for a robot."""

    def at(self, *arguments, said=''):
        simulator = robot.Simulator(PROGRAM)
        check = suite.Check('', '', None, '', '', '1.80', None, True, {})
        target = simulator.start(check)
        try:
            return run('--host', '127.0.0.1', '--port', str(target.script_address[1]), '--status-port',
                       str(target.status_address[1]), *arguments, said=said)
        finally:
            target.close()

    def test_checks_a_robot_at_an_address(self):
        ended = self.at('--only', 'TM-1.1.*', '--verbose')
        self.assertEqual(ended.returncode, 1, ended)  # its ports are not 5890 and 5891, and nothing else is wrong
        self.assertEqual(re.findall(r'^(\S+) +failed', ended.stdout, re.MULTILINE), ['TM-1.1.15'])
        self.assertRegex(ended.stdout, r'TM-1\.1\.02 +skipped .*\n *not safe')

    def test_asks_before_it_moves_a_robot(self):
        for said in ('', 'yes\n'):
            ended = self.at('--all', '--only', 'TM-2.2.70', said=said)
            self.assertEqual(ended.returncode, 2, ended)
            self.assertIn('MOVE', ended.stderr)

    def test_moves_a_robot_when_it_may(self):
        ended = self.at('--all', '--only', 'TM-2.2.70', '--only', 'TM-2.2.84', '--only', 'TM-2.2.40',
                        said='127.0.0.1\n')
        self.assertEqual((ended.returncode, ended.stdout.count('\n')), (0, 1), ended)
        self.assertIn('3 passed', ended.stdout)

    def test_finds_what_is_wrong_with_a_robot(self):
        suite.load()
        simulator = robot.Simulator(PROGRAM)
        for fault, identity in (('corrupt_reply', 'TM-1.1.02'), ('refuse_script 0 1', 'TM-1.3.14'),
                                ('query_none', 'TM-1.5.07'), ('false_tag', 'TM-2.2.40'), ('ignore_stop', 'TM-2.2.84'),
                                ('hide_items 0 Joint_Torque', 'TM-3.2.01'), ('corrupt_stream', 'TM-3.0.01')):
            with self.subTest(fault):
                check = suite.CHECKS[identity]
                target = simulator.start(check)
                target.operate('fault ' + fault)
                self.assertIsNotNone(run_conformance.attempt(check, target))

    def test_writes_reports(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [str(pathlib.Path(folder) / name) for name in ('results.json', 'results.xml')]
            ended = run('--spawn', PROGRAM, '--only', 'TM-1.6.0[1-4]', '--json', files[0], '--junit', files[1])
            self.assertEqual(ended.returncode, 0, ended)
            self.assertIn('4 passed', ended.stdout)
            results = json.loads(pathlib.Path(files[0]).read_text(encoding='utf-8'))['results']
            self.assertEqual([result['outcome'] for result in results], ['passed'] * 4)
            self.assertEqual(len(ElementTree.parse(files[1]).getroot().findall('testcase')), 4)

    def test_bad_usage(self):
        for arguments in ((), ('--only', 'TM-9.*', '--list'), ('--spawn', PROGRAM, '--only', 'none')):
            self.assertEqual(run(*arguments).returncode, 2, arguments)


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
