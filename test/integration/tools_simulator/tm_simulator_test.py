"""tm_simulator as its users meet it: a process with options, output, signals and an exit status.

Usage: tm_simulator_test.py PROGRAM [unittest options]
"""
import re
import signal
import socket
import subprocess
import sys
import threading
import unittest

PROGRAM = ''
DEADLINE = 60  # seconds; reached only when something is broken


def frame(header, data):
    body = '%s,%d,%s,' % (header, len(data), data)
    checksum = 0
    for byte in body.encode():
        checksum ^= byte
    return ('$%s*%02X\r\n' % (body, checksum)).encode()


def raw_frame(header, data):
    body = header + b',%d,' % len(data) + data + b','
    checksum = 0
    for byte in body:
        checksum ^= byte
    return b'$' + body + b'*%02X\r\n' % checksum


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
        models = re.findall(r'tm\d+\w*(?:-\d+)?', re.search(r'--model.*\n.*\((.*), or empty\)', run('--help').stdout).group(1))
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

    def test_prints_no_byte_of_a_client_that_steers_the_terminal(self):
        with Simulator('--log-traffic') as simulator:
            printed = []
            reader = threading.Thread(target=lambda: printed.extend(simulator.process.stdout))
            reader.start()
            for byte in range(256):
                with Client(simulator.script) as client:
                    client.socket.sendall(raw_frame(b'TMSCT', b'1,ChangeBase("A' + bytes([byte]) + b'[31mB")'))
                    client.socket.sendall(raw_frame(b'TM' + bytes([byte]), b'1') + bytes([byte]) + b'\r\n')
                    client.socket.shutdown(socket.SHUT_WR)
                    client.read_to_the_end()
            simulator.process.terminate()
            reader.join(DEADLINE)
            self.assertEqual(simulator.process.wait(DEADLINE), 0)
        text = ''.join(printed)
        self.assertIn(r'ChangeBase("A\x1B[31mB")', text)
        self.assertEqual([c for c in text if c != '\n' and not c.isprintable()], [])

    def test_prints_nothing_else_when_not(self):
        with Simulator() as simulator:
            with Client(simulator.script) as client:
                client.send('TMSTA', '00')
                client.read_until(frame('TMSTA', '00,true,Listen1'))
            simulator.end(signal.SIGINT)
            self.assertEqual(len(simulator.lines), 1)


class Settings(unittest.TestCase):
    """Each is tried on its own in test/unit; here: that options of every form arrive."""

    def read(self, simulator, item):
        with Client(simulator.status) as client:
            client.send('TMSVR', 'q,12,%s' % item)
            answer = ('q,12,%s=' % item).encode()
            client.read_until(answer)
            client.received = client.received.split(answer)[1]
            client.read_until(b',*')
            return client.received.split(b',*')[0].decode()

    def test_are_taken_under_either_name(self):
        for options in (['--base', 'a=1,2,3,0,0,0', '--base', 'b=4,5,6,0,0,0', '--bind', '127.0.0.1', '--any-payload'],
                        ['--bases', 'a=1,2,3,0,0,0', 'b=4,5,6,0,0,0', '--bind-address', '127.0.0.1',
                         '--checks-payload=false', '--robot-model', 'tm12', '--verbose']):
            with self.subTest(options), Simulator(*options) as simulator, Client(simulator.script) as client:
                client.send('TMSCT', '7,ChangeBase("a")\r\nChangeBase("b")\r\nChangeLoad(20)')
                client.read_until(frame('TMSCT', '7,OK'))

    def test_name_the_project_and_what_it_does_on_an_error(self):
        with Simulator('--project-name', 'Cell 7', '--on-motion-error', 'stop_project', '--stop-time', '50') as simulator:
            self.assertEqual(self.read(simulator, 'Project_Name'), '"Cell 7"')
            with Client(simulator.script) as client:
                client.send('TMSCT', '7,PTP("JPP",30,0,170,0,90,0,35,200,0,false)\r\nQueueTag(8)')
                client.read_until(frame('TMSTA', '01,08,false'))
                self.assertEqual(client.read_to_the_end(), 'closed')

    def test_pause_the_project_behind_a_safeguard_that_does_not_reset_itself(self):
        for option, expected in (([], 'false'), (['--no-safeguard-resets-itself'], 'true')):
            with self.subTest(option), Simulator('--control', *option) as simulator:
                simulator.say('safeguard open')
                simulator.say('safeguard close')
                self.assertEqual(self.read(simulator, 'Project_Pause'), expected)

    def test_turn_a_fault_on_from_the_start(self):
        with Simulator('--fault', 'refuse_script 1 2;3') as simulator, Client(simulator.script) as client:
            client.send('TMSCT', '7,Pause()')
            client.read_until(frame('TMSCT', '7,ERROR;2;3'))

    def test_start_elsewhere_and_not_at_all(self):
        with Simulator('--start-posture-deg', '10, 0.5,90,0,90,0', '--no-project-running') as simulator:
            self.assertTrue(self.read(simulator, 'Joint_Angle').startswith('{10,0.5,90,0,90,0'))
            self.assertEqual(self.read(simulator, 'Project_Run'), 'false')


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

    def test_settings_by_name_that_cannot_be(self):
        numbers = '1,2,3,4,5,6'
        for mention, options in (
                ('--script-port: is 5890.7; allowed: a whole number, 0 to 65535', ['--script-port', '5890.7']),
                ('--status-port: is 7000, the same as script_port', ['--script-port', '7000', '--status-port', '7000']),
                ('--status-period: is 0.5; allowed: a number, 1 to 1000 ms', ['--status-period', '0.5']),
                ('--stop-time: is nan', ['--stop-time', 'nan']),
                ('--connection-timeout: is -1', ['--connection-timeout', '-1']),
                ('--project-speed: is 7', ['--project-speed', '7']),
                ('--listen-node', ['--listen-node']),
                ('--write-clients: names "999.1.1.1"', ['--write-clients', '999.1.1.1']),
                ('--stream-items: names no item', ['--stream-items', '']),
                ('--stream-items: names "Bogus"', ['--stream-items', 'Bogus']),
                ('--variable: holds "int PTP": PTP is a function', ['--variable', 'int PTP']),
                ('--base: names "a" twice', ['--base', 'a=' + numbers, '--base', 'a=' + numbers]),
                ('--tcp: names NOTOOL', ['--tcp', 'NOTOOL=' + numbers]),
                ('--point: "P" has joint 3 at 170 deg', ['--point', 'P=0,0,170,0,0,0']),
                ('--start-posture-deg: is a list of 5', ['--start-posture-deg', '0,0,90,0,90']),
                ('--start-posture-deg: has joint 3', ['--start-posture-deg', '0,0,170,0,90,0']),
                ('--fault: holds "drop"', ['--fault', 'drop']),
                ('--on-motion-error: is the text "explode"', ['--on-motion-error', 'explode'])):
            with self.subTest(options):
                self.assert_bad_usage(mention, *options)

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
