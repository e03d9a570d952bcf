"""Nodes, and a master, that a test starts, ends and kills by itself."""
import os
import signal
import socket
import subprocess
import tempfile
import time
import xmlrpc.client

import rospy

from cobot_test import DEADLINE, program


class Process:
    """A program of this package, or another, that is gone at the end of the test."""

    def __init__(self, *command, env=None, stdout=None):
        self._process = subprocess.Popen(command, env=env, stdout=stdout)

    def signal(self, number):
        self._process.send_signal(number)

    def is_alive(self):
        return self._process.poll() is None

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


def node(kind, name, master=None, **parameters):
    """Starts a node; its parameters stay on the master."""
    private = [f"_{key}:={value}" for key, value in parameters.items()]
    env = dict(os.environ, ROS_MASTER_URI=master) if master else None
    return Process(program(kind), f"__name:={name}", *private, env=env)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Master(Process):
    """A ROS master beside that of the test."""

    def __init__(self, port=None):
        self.port = port or free_port()
        self.uri = f"http://localhost:{self.port}/"
        super().__init__("rosmaster", "--core", "-p", str(self.port))
        deadline = time.monotonic() + DEADLINE
        while not self._answers():
            if time.monotonic() > deadline:
                raise AssertionError("the master does not answer")
            rospy.sleep(0.05)

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
        return Client(self.uri, *command)


class Client(Process):
    """A program that uses a master; what it has said can be read at any time."""

    def __init__(self, master, *command):
        self._output = tempfile.NamedTemporaryFile("w")
        super().__init__(*command, env=dict(os.environ, ROS_MASTER_URI=master, PYTHONUNBUFFERED="1"),
                         stdout=self._output)

    def output(self):
        with open(self._output.name, encoding="utf-8") as text:
            return text.read()

    def clear_away(self):
        super().clear_away()
        self._output.close()
