"""tm_fault_proxy as its users meet it: between two programs, with lines on its standard input.

Usage: tm_fault_proxy_test.py PROGRAM [unittest options]
"""
import socket
import subprocess
import sys
import time
import unittest

PROGRAM = ''
DEADLINE = 60  # seconds; reached only when something is broken
REPLY = b'$TMSCT,4,4,OK,*59\r\n'


class Proxied(unittest.TestCase):
    """A client, the proxy, and a controller that is nothing but a socket."""

    def setUp(self):
        self.listener = socket.create_server(('127.0.0.1', 0))
        self.addCleanup(self.listener.close)
        port = str(self.listener.getsockname()[1])
        self.proxy = subprocess.Popen([PROGRAM, '--script', port, '--status', port], stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, universal_newlines=True)
        self.addCleanup(self.proxy.wait, DEADLINE)
        self.addCleanup(self.proxy.stdout.close)
        self.addCleanup(self.proxy.stdin.close)
        words = self.proxy.stdout.readline().split()
        self.ports = dict(word.split('=') for word in words[1:])

    def say(self, line):
        self.proxy.stdin.write(line + '\n')
        self.proxy.stdin.flush()
        return self.proxy.stdout.readline().rstrip('\n')

    def wait_for_strikes(self, count):
        deadline = time.monotonic() + DEADLINE
        while self.say('strikes') != 'ok: %d frames were struck' % count:
            self.assertLess(time.monotonic(), deadline, 'it never struck')

    def join(self):
        """Both ends of a new connection through the script port."""
        client = socket.create_connection(('127.0.0.1', int(self.ports['script'])), DEADLINE)
        self.addCleanup(client.close)
        controller, _ = self.listener.accept()
        controller.settimeout(DEADLINE)
        self.addCleanup(controller.close)
        return client, controller

    @staticmethod
    def read(end, size):
        received = b''
        while len(received) < size:
            piece = end.recv(size - len(received))
            if not piece:
                break
            received += piece
        return received

    def test_spoils_what_it_is_told_to(self):
        client, controller = self.join()
        self.assertEqual(self.say('script duplicate which=script first=1 count=1'), 'ok')
        controller.sendall(3 * REPLY)
        self.assertEqual(self.read(client, 4 * len(REPLY)), 4 * REPLY)
        self.wait_for_strikes(1)

    def test_drops_connections_and_heals(self):
        client, controller = self.join()
        self.assertEqual(self.say('script drop'), 'ok')
        controller.sendall(REPLY)
        self.wait_for_strikes(1)
        self.assertEqual(self.say('heal'), 'ok: no faults')
        self.assertEqual(self.say('reset'), 'ok: all connections are dropped')
        self.assertRaises(ConnectionResetError, client.recv, 1)
        client, controller = self.join()
        controller.sendall(REPLY)
        self.assertEqual(self.read(client, len(REPLY)), REPLY)

    def test_names_what_it_does_not_understand(self):
        for line, words in (('', 'port ""'), ('script', 'unknown fault'), ('status explode', 'explode'),
                            ('script drop which=all', 'allowed are any'), ('script drop count=-1', 'count=-1'),
                            ('script drop direction=up', 'direction=up'), ('script drop often', 'often')):
            answer = self.say(line)
            self.assertTrue(answer.startswith('error: '), answer)
            self.assertIn(words, answer)


class Alone(unittest.TestCase):
    def run_with(self, *options):
        return subprocess.run([PROGRAM, *options], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=DEADLINE)

    def test_ends_with_its_input(self):
        self.assertEqual(self.run_with().returncode, 0)

    def test_says_when_a_port_is_taken(self):
        with socket.create_server(('127.0.0.1', 0)) as taken:
            run = self.run_with('--listen-script', str(taken.getsockname()[1]))
        self.assertEqual(run.returncode, 1)
        self.assertIn('in use', run.stderr)

    def test_knows_its_options(self):
        self.assertEqual(self.run_with('--script', '70000').returncode, 2)
        self.assertIn('heal', self.run_with('--help').stdout)


if __name__ == '__main__':
    PROGRAM = sys.argv.pop(1)
    unittest.main()
