"""tm_simulator as its users meet it: a process with options, output, signals and an exit status.

Usage: tm_simulator_test.py PROGRAM [unittest options]
"""
import re
import signal
import socket
import subprocess
import sys
import unittest

PROGRAM = ''
DEADLINE = 60  # seconds; reached only when something is broken


def frame(header, data):
    body = '%s,%d,%s,' % (header, len(data), data)
    checksum = 0
    for byte in body.encode():
        checksum ^= byte
    return ('$%s*%02X\r\n' % (body, checksum)).encode()


def run(*options):
    """A run that is expected to end by itself."""
    return subprocess.run([PROGRAM, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=DEADLINE)


class Simulator:
    """A running tm_simulator on free ports."""

    def __init__(self, *options):
        self.process = subprocess.Popen([PROGRAM, '--script-port', '0', '--status-port', '0', *options],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        universal_newlines=True)
        self.lines = []
        for line in self.process.stdout:
            self.lines.append(line)
            ports = re.fullmatch(r'listening script=(\d+) status=(\d+)\n', line)
            if ports:
                self.script, self.status = (int(port) for port in ports.groups())
                return
        raise AssertionError('never listened: %s' % self.lines)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def say(self, command):
        """The answer to a line of --control."""
        self.process.stdin.write(command + '\n')
        self.process.stdin.flush()
        return self.process.stdout.readline().rstrip('\n')

    def end(self, signal_number):
        self.process.send_signal(signal_number)
        output, _ = self.process.communicate(timeout=DEADLINE)
        self.lines += output.splitlines(keepends=True)
        return self.process.returncode


class Client:
    def __init__(self, port):
        self.socket = socket.create_connection(('127.0.0.1', port), timeout=DEADLINE)
        self.received = b''

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()

    def send(self, header, data):
        self.socket.sendall(frame(header, data))

    def read_to_the_end(self):
        while self.socket.recv(4096):
            pass
        return 'closed'

    def read_until(self, expected):
        while expected not in self.received:
            piece = self.socket.recv(4096)
            if not piece:
                raise AssertionError('closed after %r' % self.received)
            self.received += piece


class Serving(unittest.TestCase):
    def test_says_that_it_listens(self):
        with Simulator() as simulator, Client(simulator.script) as client:
            client.send('TMSTA', '00')
            client.read_until(frame('TMSTA', '00,true,Listen1'))

    def test_says_the_message_of_its_listen_node(self):
        with Simulator('--listen-node', 'Cell, left') as simulator, Client(simulator.script) as client:
            client.send('TMSTA', '00')
            client.read_until(frame('TMSTA', '00,true,Cell, left'))

    def test_streams_its_status(self):
        with Simulator() as simulator, Client(simulator.status) as client:
            client.read_until(b'Joint_Angle')

    def test_moves_each_model_and_reports_the_tag(self):
        models = re.search(r'--model TEXT:\{([^}]*)\}', run('--help').stdout).group(1).split(',')
        self.assertIn('tm5-900', models)
        for model in models:
            with self.subTest(model), Simulator('--model', model, '--time-scale', 'max') as simulator, \
                    Client(simulator.script) as client:
                client.send('TMSCT', '7,PTP("JPP",30,0,90,0,90,0,35,200,0,false)\r\nQueueTag(8)')
                client.read_until(frame('TMSCT', '7,OK'))
                client.read_until(frame('TMSTA', '01,08,true'))

    def test_prints_the_traffic_when_asked_to(self):
        with Simulator('--log-traffic') as simulator:
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))
            self.assertEqual(simulator.end(signal.SIGINT), 0)
            self.assertRegex(''.join(simulator.lines), 'in a Listen node')

    def test_prints_nothing_else_when_not(self):
        with Simulator() as simulator:
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))
            simulator.end(signal.SIGINT)
            self.assertEqual(len(simulator.lines), 1)


class Controlling(unittest.TestCase):
    def test_does_what_the_operator_says_and_answers_each_line(self):
        with Simulator('--control') as simulator, Client(simulator.script) as client:
            self.assertEqual(simulator.say('leave'), 'ok: the flow is in another node')
            client.send('TMSTA', '00')
            client.read_until(frame('TMSTA', '00,false,'))
            self.assertEqual(simulator.say('enter'), 'ok: the flow is in the Listen node')
            client.read_until(frame('TMSCT', '0,Listen1'))
            self.assertRegex(simulator.say('dance'), '^error: unknown command "dance"')
            self.assertEqual(simulator.say('fault refuse_script 1 2;3'), 'ok: refuse_script is on for the next 1')
            client.send('TMSCT', '7,Pause()')
            client.read_until(frame('TMSCT', '7,ERROR;2;3'))

    def test_opens_and_closes_its_port_with_the_project(self):
        with Simulator('--control') as simulator:
            self.assertEqual(simulator.say('stop'), 'ok: the project is stopped')
            with self.assertRaises(ConnectionRefusedError):
                Client(simulator.script)
            self.assertEqual(simulator.say('run'), 'ok: the project runs')
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))

    def test_goes_on_when_the_operator_has_nothing_more_to_say(self):
        with Simulator('--control') as simulator:
            simulator.process.stdin.write('speed 50')  # a last line without an end
            simulator.process.stdin.close()
            self.assertEqual(simulator.process.stdout.readline(), 'ok: the project speed is 50 %\n')
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))
            simulator.process.stdin = None  # so that communicate() does not look at it
            self.assertEqual(simulator.end(signal.SIGINT), 0)

    def test_lists_its_commands(self):
        self.assertIn('drop_connections', run('--help').stdout)
        with Simulator('--control') as simulator:
            self.assertRegex(simulator.say('help'), '^ok: run')

    def test_does_not_listen_to_standard_input_unless_asked_to(self):
        with Simulator() as simulator:
            simulator.process.stdin.write('stop\n')
            simulator.process.stdin.flush()
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))


class Ending(unittest.TestCase):
    def test_ends_cleanly_by_signal_also_in_motion_and_with_clients(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number), Simulator() as simulator, Client(simulator.script) as client, \
                    Client(simulator.status):
                client.send('TMSCT', '1,PTP("JPP",90,0,90,0,90,0,1,200,0,false)')
                client.read_until(frame('TMSCT', '1,OK'))
                self.assertEqual(simulator.end(number), 0)


class WithoutAReader(unittest.TestCase):
    def test_serves_on_when_the_reader_of_its_log_is_gone(self):
        with Simulator('--log-traffic', '--control') as simulator, Client(simulator.script) as client:
            simulator.process.stdout.close()
            for question in range(20):
                client.send('TMSTA', '01,%02d' % (question % 15 + 1))
            client.send('TMSTA', '00')
            client.read_until(frame('TMSTA', '00,true,Listen1'))
            simulator.process.stdin.write('speed 50\nstop\n')
            simulator.process.stdin.flush()
            self.assertEqual(client.read_to_the_end(), 'closed')
            simulator.process.send_signal(signal.SIGTERM)
            self.assertEqual(simulator.process.wait(timeout=DEADLINE), 0)
            simulator.process.stdout = None  # so that communicate() does not look at it
            simulator.process.stdin.close()
            simulator.process.stdin = None

    def test_tells_once_that_its_output_is_lost(self):
        with open('/dev/full', 'w') as full:
            process = subprocess.Popen([PROGRAM, '--script-port', '0', '--status-port', '0', '--log-traffic'], stdout=full,
                                       stderr=subprocess.PIPE, universal_newlines=True)
        self.assertIn('standard output cannot be written', process.stderr.readline())
        process.send_signal(signal.SIGTERM)
        _, rest = process.communicate(timeout=DEADLINE)
        self.assertEqual((process.returncode, rest), (0, ''))


class Refusing(unittest.TestCase):
    def assert_bad_usage(self, mention, *options):
        ended = run(*options)
        self.assertEqual(ended.returncode, 2, ended)
        self.assertIn(mention, ended.stderr)
        self.assertEqual(ended.stdout, '')

    def test_bad_usage(self):
        self.assert_bad_usage('tm5-900', '--model', 'tm99')
        self.assert_bad_usage('65535', '--script-port', '65536')
        self.assert_bad_usage('65535', '--status-port', '-1')
        self.assert_bad_usage('--script-port', '--script-port', 'none')
        self.assert_bad_usage('0.01 to 100', '--time-scale', '-1')
        self.assert_bad_usage('0.01 to 100', '--time-scale', 'nan')
        self.assert_bad_usage('--time-scale', '--time-scale', 'fast')
        self.assert_bad_usage('address', '--bind', 'nowhere')
        self.assert_bad_usage('--unknown', '--unknown')

    def test_a_port_in_use(self):
        with Simulator() as first:
            second = run('--script-port', str(first.script), '--status-port', '0')
            self.assertEqual(second.returncode, 1)
            self.assertIn(str(first.script), second.stderr)
            self.assertIn('choose another port', second.stderr)

    def test_helps(self):
        helped = run('--help')
        self.assertEqual(helped.returncode, 0)
        for option in ('--model', '--script-port', '--status-port', '--time-scale', '--listen-node', '--bind', '--control',
                       '--log-traffic'):
            self.assertIn(option, helped.stdout)


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
