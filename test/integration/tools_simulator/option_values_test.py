"""Whatever is written on the command line of a program: it ends with 0 or 2, and with 2 it says why.

Usage: option_values_test.py TM_SIMULATOR TM_ARM TM_FRAME TM_FAULT_PROXY [unittest options]

The options are those that each program's --help names, so that a new one is tried without a word here.
"""
import pathlib
import re
import subprocess
import sys
import threading
import typing
import unittest
import xml.etree.ElementTree

PROGRAMS = {}
DEADLINE = 60  # seconds; reached only when something is broken
ENDED, BAD_USAGE = 0, 2

# What a program needs besides for a run that does its work and ends, or serves until it is told to end.
WORK = {
    'tm_simulator': ['--script-port', '0', '--status-port', '0'],
    'tm_arm': ['--model', 'tm5-900', 'fk', '0', '0', '90', '0', '90', '0'],
    'tm_frame': ['decode'],
    'tm_fault_proxy': ['--listen-script', '0'],
}
SUBCOMMANDS = {'tm_arm': ['fk', 'ik', 'urdf'], 'tm_frame': ['encode', 'decode']}

VALUES = ['', 'banana', '2.5', '-1', '99999999999999999999999', 'nan', '1e999', '0x10', '\n', 'a\nb', '\x1b[2J', '\udcff', bytes(range(1, 256)).decode(errors='surrogateescape'),
          '{}', '[1,2]', '[', '"', '=', '%s%n', '--', ',', ' ', 'x' * 5000]
FLAG_VALUES = ['banana', '2', '-1', '99999999999999999999999', '-99999999999999999999999', 'nan', '', 'on', '{}', '\n', 'yes',
               'TRUE', '1e999', '0x10', '=']


class Option(typing.NamedTuple):
    name: str
    is_flag: bool
    subcommand: typing.List[str]  # of which it is; empty: of the program
    names: typing.List[str]  # all that it has


def run(program, *words):
    """(status, standard output, standard error); who serves is ended as soon as it says so."""
    process = subprocess.Popen([PROGRAMS[program], *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
    killer = threading.Timer(DEADLINE, process.kill)
    killer.start()
    said = b''
    if program == 'tm_simulator':
        for line in process.stdout:
            said += line
            if line.startswith(b'listening'):
                process.terminate()
    out, err = process.communicate()
    killer.cancel()
    return process.returncode, (said + out).decode(errors='replace'), err.decode(errors='replace')


def options(program):
    """Those in --help of the program and of each thing that it can do."""
    found = {}
    for words in [[]] + [[subcommand] for subcommand in SUBCOMMANDS.get(program, [])]:
        status, text, _ = run(program, *words, '--help')
        assert status == ENDED, text
        for line in text.splitlines():
            # Defaults stand behind the type as TEXT=0, 0, 90, and since CLI11 2.4 as TEXT [0, 0, 90].
            named = re.match(r'  (-[^ ]*)( [A-Z].*?)?(  |$)', line + '  ')
            names = re.findall(r'--[a-z][a-z-]*', named.group(1)) if named else []
            found.update({name: (named.group(2) is None, words, names) for name in names})
    return [Option(name, *rest) for name, rest in sorted(found.items())]


def placed(program, subcommand, words):
    """The words where the option is known: in front, or behind its subcommand; in place of what is there of it."""
    work = list(WORK[program])
    name = words[0].split('=')[0] if words else ''
    if name in work:
        at = work.index(name)
        del work[at:at + 2]
    if not subcommand:
        return [*words, *work]
    if subcommand == ['urdf']:
        return ['--model', 'tm5-900', 'urdf', *words]
    return [*work, *words]


class AnyValue(unittest.TestCase):
    def assert_ends_well(self, program, option, *written):
        words = placed(program, option.subcommand, written)
        status, out, err = run(program, *words)
        self.assertIn(status, (ENDED, BAD_USAGE), (words, out, err))
        if status == BAD_USAGE:
            self.assertTrue(any(name in err for name in option.names), err)
            self.assertEqual(out, '')
            self.assertEqual([c for c in err if c != '\n' and (c == '\ufffd' or not c.isprintable())], [])
            self.assertNotRegex(err, 'stoll|what\\(\\)|terminate|At Most|Could not convert|\x1b')
        else:
            self.assertEqual(err, '')
        return status, err

    def for_each(self, is_flag, values, check):
        """All options of all programs that are of the one kind, with each of the values."""
        for program in PROGRAMS:
            for option in options(program):
                for value in values if option.is_flag == is_flag else ():
                    with self.subTest(program=program, option=option.name, value=value):
                        check(program, option, value)

    def test_of_a_flag_is_refused_unless_it_is_true_or_false(self):
        def check(program, option, value):
            status, err = self.assert_ends_well(program, option, '%s=%s' % (option.name, value))
            self.assertEqual(status, BAD_USAGE)
            self.assertIn('true or false', err)

        self.for_each(True, FLAG_VALUES, check)

    def test_of_a_flag_is_true_or_false(self):
        def check(program, option, value):
            self.assertEqual(self.assert_ends_well(program, option, '%s=%s' % (option.name, value)), (ENDED, ''))

        self.for_each(True, ('true', 'false', '1', '0'), check)

    def test_of_an_option_is_taken_or_refused_by_name(self):
        def check(program, option, value):
            self.assert_ends_well(program, option, '%s=%s' % (option.name, value))
            self.assert_ends_well(program, option, option.name, value)

        self.for_each(False, VALUES, check)

    def test_is_missed_by_name(self):
        def check(program, option, _):
            status, out, err = run(program, *placed(program, option.subcommand, []), option.name)
            self.assertEqual((status, out), (BAD_USAGE, ''))
            self.assertTrue(any(name + ': has no value' in err for name in option.names), err)

        self.for_each(False, ('',), check)

    def test_is_given_once(self):
        for program, name, value in (('tm_simulator', '--project-speed', '50'), ('tm_fault_proxy', '--seed', '7'),
                                     ('tm_arm', '--model', 'tm12')):
            status, err = self.assert_ends_well(program, Option(name, False, [], [name]), name, value, name, value)
            self.assertEqual(status, BAD_USAGE)
            self.assertIn('times; allowed: once', err)


class StrayWords(unittest.TestCase):
    def test_are_named(self):
        for program, words in WORK.items():
            for stray in ('stray', '--stray', 'two words', '-x', '--stray=1'):
                with self.subTest(program=program, stray=stray):
                    status, out, err = run(program, *words, stray)
                    self.assertEqual((status, out), (BAD_USAGE, ''), err)
                    self.assertIn(stray, err)
                    self.assertNotIn('At Most', err)

    def test_that_are_nearly_an_option_are_told_of_it(self):
        for program, stray, meant in (('tm_simulator', '--listen-nod', '--listen-node'), ('tm_arm', '--jsn', '--json'),
                                      ('tm_frame', '--hax', '--hex'), ('tm_fault_proxy', '--sead=1', '--seed')):
            status, _, err = run(program, *WORK[program], stray)
            self.assertEqual(status, BAD_USAGE)
            self.assertIn('%s is near' % meant, err)

    def test_behind_a_switch_are_no_value_of_it(self):
        status, _, err = run('tm_simulator', '--velocity-licence', 'true')
        self.assertEqual(status, BAD_USAGE)
        self.assertIn('unexpected argument "true"', err)

    def test_that_are_misspelt_options_are_told_before_what_is_missing(self):
        for program, words, stray, meant in (('tm_arm', ['--modle', 'tm12', 'fk', *'000000'], '--modle', '--model'),
                                             ('tm_arm', ['--modle', 'tm12'], '--modle', '--model'),
                                             ('tm_frame', ['encode', '--hex', 'TMSCT'], '--hex', ''),
                                             ('tm_frame', ['decode', '--trace-of', 'client', '--hax'], '--hax', '--hex')):
            with self.subTest(program=program, words=words):
                status, out, err = run(program, *words)
                self.assertEqual((status, out), (BAD_USAGE, ''))
                self.assertIn('%s: there is no option "%s"' % (program, stray), err)
                self.assertNotIn('required', err)
                self.assertIn('%s is near' % meant if meant else '', err)


class Help(unittest.TestCase):
    def test_names_the_program_and_its_numbers(self):
        for program in PROGRAMS:
            for words in [[]] + [[subcommand] for subcommand in SUBCOMMANDS.get(program, [])]:
                with self.subTest(program=program, words=words):
                    status, text, _ = run(program, *words, '--help')
                    self.assertEqual(status, ENDED)
                    self.assertRegex(text, r'(?m)^Usage: %s \[OPTIONS\]' % ' '.join([program, *words]))
                    # A default is written as =5890, by later versions of CLI11 as [5890]. Of these the text is no number, though it looks like one.
                    self.assertEqual(set(re.findall(r'(--[a-z-]+)\S* TEXT(?:=| \[)-?[0-9.]+(?:\s|\]|$)', text)) - {'--bind', '--tmflow-version'}, set())
        self.assertRegex(run('tm_simulator', '--help')[1], r'--script-port INT(=| \[)5890\b')
        self.assertRegex(run('tm_simulator', '--help')[1], r'--time-scale FLOAT(=| \[)1\b')

    def test_has_the_version_of_the_package(self):
        package = xml.etree.ElementTree.parse(pathlib.Path(__file__).resolve().parents[3] / 'package.xml').getroot()
        for program in PROGRAMS:
            self.assertEqual(run(program, '--version'), (ENDED, '%s (cobot_command) %s\n' % (program, package.findtext('version')), ''))


if __name__ == '__main__':
    for program in WORK:
        PROGRAMS[program] = sys.argv.pop(1)
    unittest.main()
