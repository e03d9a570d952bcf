"""A small client of the TM robot's script and status ports, written from the facts (doc/tm-robot.md, doc/conformance.md) alone.

It shares nothing with the sources of this project, so that both can be wrong only independently. It is strict: bytes
from the robot that break the grammar of frames (TM 1.1) are an error wherever they turn up.
"""
import re
import select
import socket
import struct
import time

DEADLINE = 10.0  # seconds for one answer; reached only when something is broken


class Violation(AssertionError):
    """The robot sent what the grammar of frames forbids."""


class NoAnswer(AssertionError):
    """The robot did not send what was waited for."""


class Closed(AssertionError):
    """The robot closed the connection."""


def checksum(body):
    """XOR of every byte strictly between `$` and `*`."""
    bits, size = int.from_bytes(body, 'big'), len(body)
    while size > 1:  # one half upon the other: much faster than byte by byte
        half = size // 2
        bits = bits >> 8 * half ^ bits & (1 << 8 * half) - 1
        size -= half
    return bits


def encode(header, data, length=None, check=None):
    """One frame. `length` and `check` replace the right texts of the length field and the checksum."""
    data = data.encode() if isinstance(data, str) else data
    length = str(len(data)) if length is None else length
    body = header.encode() + b',' + length.encode() + b',' + data + b','
    check = '%02X' % checksum(body) if check is None else check
    return b'$' + body + b'*' + check.encode() + b'\r\n'


class Frame:
    """A frame of the robot. `time` is when it was received, in seconds of the monotonic clock."""

    def __init__(self, header, data):
        self.header, self.data, self.time = header, data, time.monotonic()

    @property
    def text(self):
        return self.data.decode('utf-8', 'backslashreplace')

    def __str__(self):
        return '%s,%s' % (self.header, self.text)

    def __repr__(self):
        return repr(str(self)[:300])


class FrameReader:
    """Bytes in, frames out. DATA is cut by the length field, as it may hold any byte."""

    HEAD = re.compile(rb'\$([A-Z]+),(0|[1-9][0-9]*),')
    LONGEST_HEAD = 24

    def __init__(self):
        self._bytes = b''

    def feed(self, more):
        self._bytes += more
        frames, start = [], 0
        while start < len(self._bytes):
            end, frame = self._next(start)
            if frame is None:
                break
            frames.append(frame)
            start = end
        self._bytes = self._bytes[start:]
        return frames

    def _next(self, start):
        head = self.HEAD.match(self._bytes, start)
        if not head:
            begin = self._bytes[start:start + self.LONGEST_HEAD]
            if not begin.startswith(b'$') or begin.count(b',') >= 2 or len(begin) == self.LONGEST_HEAD:
                raise Violation('the robot sent no head of a frame: %r' % begin)
            return start, None
        data_end = head.end() + int(head.group(2))
        end = data_end + len(b',*00\r\n')
        if len(self._bytes) < end:
            return start, None
        tail = self._bytes[data_end:end]
        expected = b',*%02X\r\n' % checksum(self._bytes[start + 1:data_end + 1])
        if tail != expected:
            raise Violation('the robot ended a frame with %r where %r was due: %r' %
                            (tail, expected, self._bytes[start:end][:200]))
        return end, Frame(head.group(1).decode(), self._bytes[head.end():data_end])


class Connection:
    """One TCP connection to a port of the robot. `frames` holds everything received on it.

    `beside`: connections that are read too while this one waits, as the robot drops whoever does not read its stream."""

    def __init__(self, address, beside=()):
        self.frames = []
        self.beside = beside
        self._reader = FrameReader()
        self._read = 0  # of `frames`
        self._socket = socket.create_connection(address, timeout=DEADLINE)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def close(self):
        self._socket.close()

    def send_bytes(self, raw):
        self._socket.sendall(raw)

    def send(self, header, data, **damage):
        self.send_bytes(encode(header, data, **damage))

    def receive(self, deadline=None):
        """The next frame."""
        deadline = time.monotonic() + DEADLINE if deadline is None else deadline
        while self._read == len(self.frames):
            self._take(max(deadline - time.monotonic(), 0))
        self._read += 1
        return self.frames[self._read - 1]

    def _read_others(self, timeout):
        """Until there is something to read here, or the time is over."""
        deadline = time.monotonic() + timeout
        others = [other for other in self.beside if other is not self and other._socket.fileno() >= 0]
        while others:
            sockets = [self._socket, *(other._socket for other in others)]
            ready, _, _ = select.select(sockets, [], [], max(deadline - time.monotonic(), 0))
            if not ready or self._socket in ready:
                return
            others = [other for other in others if other._socket not in ready or other._goes_on()]

    def _goes_on(self):
        """Takes what has arrived; False at the end of the connection, which shows when it is read itself."""
        try:
            self.poll()
        except Closed:
            return False
        return True

    def _take(self, timeout):
        if timeout > 0:
            deadline = time.monotonic() + timeout
            self._read_others(timeout)
            timeout = max(deadline - time.monotonic(), 0)
        try:
            self._socket.settimeout(timeout)
            piece = self._socket.recv(1 << 16)
        except (socket.timeout, BlockingIOError):
            raise NoAnswer('no answer in time; received so far: %r' % self.frames[-8:]) from None
        except ConnectionError as error:
            raise Closed('%s; received before: %r' % (error, self.frames[-8:])) from None
        if not piece:
            raise Closed('the robot closed the connection; received before: %r' % self.frames[-8:])
        self.frames += self._reader.feed(piece)

    def poll(self):
        """Takes what has arrived, without waiting."""
        try:
            self._take(0)
        except NoAnswer:
            pass

    def until(self, wanted, seconds=DEADLINE):
        """The frames up to and with the first that is `wanted`: its text (`TMSCT,1,OK`), or a predicate."""
        matches = wanted if callable(wanted) else lambda frame: str(frame) == wanted
        deadline, seen = time.monotonic() + seconds, []
        while True:
            try:
                seen.append(self.receive(deadline))
            except (NoAnswer, Closed) as error:
                raise type(error)('waited for %s: %s' % ('it' if callable(wanted) else wanted, error)) from None
            if matches(seen[-1]):
                return seen

    def until_closed(self):
        """Reads until the robot closes the connection."""
        try:
            self.until(lambda frame: False)
        except Closed:
            return


class ScriptConnection(Connection):
    """To the script port: scripts (TMSCT) and questions (TMSTA)."""

    def script(self, identity, *lines):
        """Sends a script and waits for nothing."""
        self.send('TMSCT', identity + ',' + '\r\n'.join(lines))

    def reply(self, identity, seconds=DEADLINE):
        """The reply to a script, without its id; what comes before it is kept in `frames`."""
        start = identity + ','
        answer = self.until(lambda f: f.header == 'CPERR' or f.header == 'TMSCT' and f.text.startswith(start),
                            seconds)[-1]
        return str(answer) if answer.header == 'CPERR' else answer.text[len(start):]

    def run(self, identity, *lines):
        """Sends a script: its reply."""
        self.script(identity, *lines)
        return self.reply(identity)

    def exchange(self, raw):
        """Sends bytes: the text of the next frame."""
        self.send_bytes(raw)
        return str(self.receive())

    def ask(self, question):
        """Sends a question: the DATA of the answer, or the protocol error."""
        self.send('TMSTA', question)
        start = question[:2] + ','
        answer = self.until(lambda f: f.header == 'CPERR' or f.header == 'TMSTA' and f.text.startswith(start))[-1]
        return str(answer) if answer.header == 'CPERR' else answer.text

    def in_listen_node(self):
        return self.ask('00').startswith('00,true,')

    def so_far(self):
        """The frames not read yet. A question behind them tells when all that is due at once has come."""
        self.send('TMSTA', '00')
        return self.until(lambda f: f.header == 'TMSTA' and f.text.startswith('00,'))[:-1]


class StatusConnection(Connection):
    """To the status port (TMSVR): the stream and requests. Ids of requests hold a letter: none is a stream's."""

    def __init__(self, address, beside=()):
        super().__init__(address, beside)
        self._requests = 0

    def stream_frame(self):
        """The next periodic frame: (id, mode, content)."""
        while True:
            frame = self.receive()
            identity, mode, content = split(frame)
            if identity.isdigit():
                return identity, mode, content

    def request(self, mode, content, identity=None):
        """Sends a request: (mode, content) of the answer, or (None, text) of a protocol error."""
        if identity is None:
            self._requests += 1
            identity = 'Q%d' % self._requests
        content = content.encode() if isinstance(content, str) else content
        self.send('TMSVR', b'%s,%d,%s' % (identity.encode(), mode, content))
        start = identity.encode() + b','
        answer = self.until(lambda f: f.header == 'CPERR' or f.header == 'TMSVR' and f.data.startswith(start))[-1]
        if answer.header == 'CPERR':
            return None, str(answer)
        return split(answer)[1:]

    def refusal(self, mode, content):
        """Sends a request: the text of the status reply (mode 0) to it."""
        mode, content = self.request(mode, content)
        if mode not in (0, None):
            raise AssertionError('answered with mode %d: %r' % (mode, content[:200]))
        return content if mode is None else content.decode()

    def read_bytes(self, *names):
        """The values of items, as the bytes of a BINARY answer."""
        mode, content = self.request(11, b''.join(pack_text(name) for name in names))
        if mode != 11:
            raise AssertionError('reading %s was answered with %r' % (', '.join(names), content))
        return dict(unpack_items(content))


def split(frame):
    """(id, mode, content) of a TMSVR frame."""
    parts = frame.data.split(b',', 2)
    if frame.header != 'TMSVR' or len(parts) != 3 or not parts[1].isdigit():
        raise Violation('no ID,Mode,Content: %r' % frame)
    return parts[0].decode(), int(parts[1]), parts[2]


def pack_text(text):
    """u16 length, little endian, and the bytes."""
    data = text.encode() if isinstance(text, str) else text
    return struct.pack('<H', len(data)) + data


def pack_items(*items):
    """(name, value) pairs as the content of a BINARY frame."""
    return b''.join(pack_text(name) + pack_text(value) for name, value in items)


def unpack_items(content):
    """(name, value bytes) pairs of a BINARY content."""
    pieces, at = [], 0
    while at < len(content):
        if at + 2 > len(content):
            raise Violation('half a length field at the end of %r' % content[:200])
        size = struct.unpack_from('<H', content, at)[0]
        if at + 2 + size > len(content):
            raise Violation('a length of %d where %d bytes are left' % (size, len(content) - at - 2))
        pieces.append(content[at + 2:at + 2 + size])
        at += 2 + size
    if len(pieces) % 2:
        raise Violation('a name without a value: %r' % pieces[-1])
    return [(name.decode(), value) for name, value in zip(pieces[0::2], pieces[1::2])]
