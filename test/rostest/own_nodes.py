"""Nodes, and a master, that a test starts, ends and kills by itself."""
import os
import random
import signal
import socket
import subprocess
import tempfile
import time
import xmlrpc.client

from cobot_test import program
from waiting import DEADLINE, wait_until


class Process:
    """A program of this package, or another, that is gone at the end of the test."""

    def __init__(self, *command, env=None, stdout=None, stderr=None):
        self._process = subprocess.Popen(command, env=env, stdout=stdout, stderr=stderr)

    def signal(self, number):
        self._process.send_signal(number)

    def is_alive(self):
        return self._process.poll() is None

    def wait_until_it_catches(self, number):
        """Until then a signal ends it as it ends every program."""
        wait_until(lambda: not self.is_alive() or self._catches(number), "a process that catches the signal")

    def _catches(self, number):
        with open(f"/proc/{self._process.pid}/status", encoding="utf-8") as status:
            caught = next(line for line in status if line.startswith("SigCgt:"))
        return bool(int(caught.split()[1], 16) >> (number - 1) & 1)

    def end(self, number):
        """Sends the signal; returns (exit status, seconds until the process was gone)."""
        begun = time.monotonic()
        self.signal(number)
        return self.wait(), time.monotonic() - begun

    def wait(self):
        return self._process.wait(DEADLINE)

    def clear_away(self):
        if self.is_alive():
            self.signal(signal.SIGCONT)
            self.end(signal.SIGKILL)


class Heard(Process):
    """A program; what it has said, also of errors, can be read at any time."""

    def __init__(self, *command, env=None):
        self._output = tempfile.NamedTemporaryFile("w")
        env = dict(env or os.environ, PYTHONUNBUFFERED="1", ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        super().__init__(*command, env=env, stdout=self._output, stderr=subprocess.STDOUT)

    def output(self):
        with open(self._output.name, encoding="utf-8") as text:
            return text.read()

    def clear_away(self):
        super().clear_away()
        self._output.close()


def node(kind, name, master=None, process=Process, **parameters):
    """Starts a node; its parameters stay on the master."""
    private = [f"_{key}:={value}" for key, value in parameters.items()]
    env = dict(os.environ, ROS_MASTER_URI=master) if master else None
    return process(program(kind), f"__name:={name}", *private, env=env)


def free_port():
    """Below those that the system gives out: nobody else gets it before the program it is for has begun to listen."""
    with open("/proc/sys/net/ipv4/ip_local_port_range", encoding="utf-8") as given_out:
        above = int(given_out.read().split()[0])
    while True:
        port = random.randrange(above // 2, above)
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) != 0:
                return port


class Master(Process):
    """A ROS master beside that of the test."""

    def __init__(self, port=None):
        self.port = port or free_port()
        self.uri = f"http://localhost:{self.port}/"
        super().__init__("rosmaster", "--core", "-p", str(self.port))
        try:
            wait_until(self._answers, "the answer of the master")
        except AssertionError:
            self.clear_away()
            raise

    def _answers(self):
        try:
            return xmlrpc.client.ServerProxy(self.uri).getPid("/test")[0] == 1
        except OSError:
            return False

    def is_sent(self, name, topic):
        """Whether somebody is connected to the topic of the node."""
        uri = xmlrpc.client.ServerProxy(self.uri).lookupNode("/test", name)[2]
        connections = xmlrpc.client.ServerProxy(uri).getBusInfo("/test")[2]
        return any(topic in connection for connection in connections)

    def client(self, *command):
        """A program that uses this master."""
        return Heard(*command, env=dict(os.environ, ROS_MASTER_URI=self.uri))
