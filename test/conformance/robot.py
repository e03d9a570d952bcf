"""The robot that is checked: a simulator started for one check, or a real one."""
import os
import re
import select
import struct
import subprocess
import time
import uuid

import suite
import tm_client
import tm_items

STARTING = 30.0  # seconds a simulator may need to start on a busy machine
STREAM_PERIOD = 0.015  # seconds of the robot's time between two frames of the status stream
TIME_SCALE = 20  # of a simulator, for checks that do not ask for another

# How a check sets up a simulator: the key of `suite.check`, and the option of tm_simulator that it stands for. The
# program is started without an option that it does not have: the check then meets whatever it does.
OPTIONS = {
    'accept_empty_length': '--accept-empty-length',  # flag
    'base': '--base',  # NAME=X,Y,Z,RX,RY,RZ
    'connection_timeout': '--connection-timeout',  # ms, of the Listen node
    'data_timeout': '--data-timeout',  # ms, of the Listen node
    'licence': '--velocity-licence',  # flag
    'listen_node': '--listen-node',  # text of the entry message
    'model': '--model',
    'point': '--point',  # NAME=J1,..,J6
    'reentry_delay': '--reentry-delay',  # ms, from leaving the Listen node to the next entry
    'stream_format': '--stream-format',  # binary, string, json
    'stream_items': '--stream-items',  # names, separated by commas
    'tcp': '--tcp',  # NAME=X,Y,Z,RX,RY,RZ
    'time_scale': '--time-scale',
    'tmflow': '--tmflow-version',
    'variable': '--variable',  # a global variable: TYPE NAME=VALUE
    'write_clients': '--write-clients',  # all, none
}

CONTROL = '--control'  # lets the program take the operator's commands, a line each; `operator` of a check is such a line


class Robot:
    """Connections to a robot, opened when they are first used, and what many checks do with them."""

    def __init__(self, script_address, status_address, version):
        self.script_address, self.status_address, self.version = script_address, status_address, version
        self._connections = []
        self._listen = self._svr = None

    def close(self):
        for connection in self._connections:
            connection.close()

    @property
    def listen(self):
        """The check's first connection to the script port."""
        if self._listen is None:
            self._listen = self.connect_script()
        return self._listen

    @property
    def svr(self):
        """The check's first connection to the status port."""
        if self._svr is None:
            self._svr = self.connect_status()
        return self._svr

    def connect_script(self):
        return self._opened(tm_client.ScriptConnection(self.script_address, self._connections))

    def connect_status(self):
        return self._opened(tm_client.StatusConnection(self.status_address, self._connections))

    def _opened(self, connection):
        self._connections.append(connection)
        return connection

    # The script port -----------------------------------------------------------------------------

    def faulty(self, *lines):
        """The numbers of the lines that the robot calls faulty. None is executed: a last line is wrong on purpose."""
        reply = self.listen.run('1', *lines, 'NoSuchFunction()')
        match = re.fullmatch(r'ERROR((?:;\d+)+)', reply)
        suite.true(match, 'a script with an unknown function was answered with %s' % reply)
        numbers = [int(number) for number in match.group(1)[1:].split(';')]
        suite.true(len(lines) + 1 in numbers, 'the unknown function of line %d is not in %s' % (len(lines) + 1, reply))
        return [number for number in numbers if number <= len(lines)]

    def accepts(self, *lines):
        """Each of the lines is correct; none is executed."""
        faulty = self.faulty(*lines)
        suite.true(not faulty, 'refused: %s' % '; '.join(lines[number - 1] for number in faulty))

    def refuses(self, *lines):
        """Each of the lines is an error; none is executed."""
        faulty = self.faulty(*lines)
        accepted = [line for number, line in enumerate(lines, 1) if number not in faulty]
        suite.true(not accepted, 'accepted: %s' % '; '.join(accepted))

    def sent_by(self, *lines):
        """What a script sends with ListenSend(90, …): the payloads. The script must be accepted without a warning."""
        before = len(self.listen.frames)
        suite.equal(self.listen.run('1', *lines), 'OK', 'reply to ' + '; '.join(lines))
        frames = self.listen.frames[before:]
        return [frame.data[3:] for frame in frames if frame.header == 'TMSTA' and frame.data.startswith(b'90,')]

    def evaluate(self, expression, *before):
        """The text of an expression, as GetString writes it, after the lines `before`."""
        sent = self.sent_by(*before, 'ListenSend(90,GetString(%s))' % expression)
        suite.equal(len(sent), 1, 'messages of ListenSend')
        return sent[0].decode()

    def evaluates(self, *pairs):
        """Each pair is an expression and its text."""
        for expression, expected in pairs:
            suite.equal(self.evaluate(expression), expected, expression)

    def numbers(self, expression, *before):
        """The numbers of an expression that is a number or an array."""
        return [float(number) for number in self.evaluate(expression, *before).strip('{}').split(',')]

    @staticmethod
    def name():
        """A name for a variable that no earlier script has declared."""
        return 'v' + uuid.uuid4().hex[:8]

    def move(self, *lines, tag=15):
        """Runs motions and returns when the arm has made them."""
        suite.equal(self.listen.run('1', *lines, 'QueueTag(%d,1)' % tag), 'OK', 'reply to ' + '; '.join(lines))
        suite.equal(self.listen.ask('01,%02d' % tag), '01,%02d,true' % tag, 'the tag behind ' + '; '.join(lines))

    # The status port -----------------------------------------------------------------------------

    def value(self, name):
        return self.values(name)[0]

    def values(self, *names):
        data = self.svr.read_bytes(*names)
        return [tm_items.decode(name, data[name]) for name in names]

    def stream(self, connection=None):
        """The next frame of a BINARY stream: name -> value."""
        _, mode, content = (connection or self.svr).stream_frame()
        suite.equal(mode, 1, 'mode of the stream')
        items = dict(tm_client.unpack_items(content))
        return {name: tm_items.decode(name, value) for name, value in items.items() if name in tm_items.TYPES}

    def observe(self, *lines):
        """Runs motions: the frames of the stream from standstill to standstill, one each STREAM_PERIOD."""
        stream, frames, reply = self.connect_status(), [], len(self.listen.frames)
        stream.stream_frame()  # it is served before anything moves
        self.listen.script('1', *lines, 'QueueTag(15,1)')
        while not any(frame.header != 'TMSTA' for frame in self.listen.frames[reply:]):
            frames.append(self.stream(stream))
            self.listen.poll()
        suite.equal(self.listen.reply('1'), 'OK', 'reply to ' + '; '.join(lines))
        end = self.value('Joint_Angle')
        while not frames or frames[-1]['Joint_Angle'] != end or any(frames[-1]['Joint_Speed']):
            frames.append(self.stream(stream))
        return frames

    def later(self, seconds):
        """Returns when the robot's clock has advanced, as the stream tells."""
        self.value('Robot_Link')  # behind what has been streamed so far
        for _ in range(int(seconds / STREAM_PERIOD) + 1):
            self.svr.stream_frame()

    def wait_for(self, name, expected, seconds):
        """Reads an item until it has a value, for a time of the robot's clock."""
        frames = int(seconds / STREAM_PERIOD) + 1
        for _ in range(frames):
            if self.value(name) == expected:
                return
            self.svr.stream_frame()
        suite.equal(self.value(name), expected, '%s after %s s' % (name, seconds))

    def write(self, name, data):
        """Writes an item over the status port, in BINARY."""
        suite.equal(self.svr.refusal(1, tm_client.pack_items((name, data))), '00,OK', 'writing ' + name)

    def press(self, button):
        """Presses a button of the stick over the status port."""
        self.write(button, b'\1')


class Simulator:
    """The program tm_simulator."""

    def __init__(self, program):
        self.program = program
        helped = subprocess.run([program, '--help'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, timeout=STARTING)
        self.help = helped.stdout
        self.options = set(re.findall(r'^ *(?:-\w,)?(--[\w-]+)', self.help, re.MULTILINE))

    def missing(self, check):
        """The options that the check would like the program to have."""
        return sorted(option for option in self._wanted(check) if option not in self.options)

    @staticmethod
    def _wanted(check):
        setup = {'time_scale': TIME_SCALE, **check.setup}
        if check.version != suite.DEFAULT_VERSION:
            setup.setdefault('tmflow', check.version)
        wanted = {OPTIONS[key]: value for key, value in setup.items() if key != 'operator'}
        return {CONTROL: True, **wanted}

    def start(self, check):
        """A running simulator set up for a check."""
        arguments = []
        for option, value in self._wanted(check).items():
            if option in self.options:
                arguments += [option] if value is True else [option, str(value)]
        robot = SimulatedRobot([self.program, '--script-port', '0', '--status-port', '0', *arguments], check.version,
                               self.help)
        try:
            if 'operator' in check.setup:
                robot.operate(check.setup['operator'])
        except BaseException:
            robot.close()
            raise
        return robot


class SimulatedRobot(Robot):
    """A process of its own, on free ports."""

    def __init__(self, command, version, helped, address='127.0.0.1'):
        self._help = helped
        self._output = b''
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            ports = self._line(rb'listening script=(\d+) status=(\d+)')
            script, status = (int(port) for port in ports.groups())
        except BaseException:
            self._end()
            raise
        super().__init__((address, script), (address, status), version)

    def _line(self, pattern):
        """The match of the next line of its output that is wanted."""
        deadline = time.monotonic() + STARTING
        while True:
            line, end, rest = self._output.partition(b'\n')
            if end:
                self._output = rest
                match = re.fullmatch(pattern, line)
                if match:
                    return match
                continue
            ready, _, _ = select.select([self._process.stdout], [], [], max(deadline - time.monotonic(), 0))
            piece = os.read(self._process.stdout.fileno(), 4096) if ready else b''
            if not piece:
                self._process.kill()
                errors = self._process.communicate()[1].decode(errors='replace').strip()
                raise AssertionError('the simulator is silent: %s' % (errors or 'no line %r' % pattern))
            self._output += piece

    def operate(self, command):
        """Gives the program a command of the operator."""
        suite.true(CONTROL in self._help, 'the program takes no commands of an operator')
        self._process.stdin.write(command.encode() + b'\n')
        self._process.stdin.flush()
        answer = self._line(rb'(ok|error): .*').group().decode()
        suite.true(answer.startswith('ok'), '%s: %s' % (command, answer))

    def run_project(self):
        self.operate('run')

    def stop_project(self):
        self.operate('stop')

    def set_project_speed(self, percent):
        self.operate('speed %d' % percent)

    def default_ports(self):
        """The ports of the script and the status server, where no others are asked for."""
        # CLI11 writes them as TEXT=5890, and since 2.4 as TEXT [5890].
        found = re.findall(r'--(?:script|status)-port \w+(?:=| \[)(\d+)', self._help)
        return tuple(int(port) for port in found)

    def close(self):
        super().close()
        self._end()

    def _end(self):
        self._process.kill()
        self._process.communicate()


class RealRobot(Robot):
    """A robot at an address; its connections are closed after each check, nothing else."""

    def run_project(self):
        self.press('Stick_PlayPause')

    def stop_project(self):
        self.press('Stick_Stop')

    def set_project_speed(self, percent):
        self.write('Project_Speed', struct.pack('<i', percent))

    RECOVERY = 120.0  # seconds that the arm may need to come back, or a script that blocks to end

    def prepare(self):
        """Brings the robot to where checks start. IT MOVES. What the check before has left behind is ended first."""
        try:
            self.listen.ask('00')
        except OSError:  # the project was stopped
            self.run_project()
            self.wait_for('Project_Run', True, 10)
        self.listen.script('home', 'StopAndClearBuffer()', 'Resume()', 'ChangeBase("RobotBase")', 'ChangeTCP("NOTOOL")',
                           'PTP("JPP",0,0,90,0,90,0,10,500,0,false)', 'QueueTag(15,1)')
        suite.equal(self.listen.reply('home', self.RECOVERY), 'OK', 'coming back to 0,0,90,0,90,0')

    def default_ports(self):
        return self.script_address[1], self.status_address[1]
