"""Frames of the script port as a replay sees them: cut out of a stream, and what of them is compared."""
import dataclasses
import re
import select
import socket
import time

FRAME = re.compile(rb"\$([A-Z]+),(\d+),")
TAIL = len(b",*00\r\n")
PIECE = 1 << 16


@dataclasses.dataclass(frozen=True)
class Said:
    """What a controller has said: what it is about, and the part of it that has to be the same; None: nothing has."""
    about: tuple
    value: str = None
    text: str = ""


def said(data):
    """Of the bytes of a frame. Compared are replies to scripts with their lines, tags with their states, and codes of CPERR.

    That something came is all that is asked of the rest: what the Listen node is called, whether the flow was in it at that
    moment, and what scripts send of themselves depends on the project and on the time."""
    head = FRAME.match(data)
    if not head:
        return Said(("bytes",), None, shown(data))
    header, content = head[1].decode(), data[head.end():head.end() + int(head[2])].decode("utf-8", "backslashreplace")
    first, _, rest = content.partition(",")
    text = f"{header} {content}"
    if header == "CPERR":
        return Said(("CPERR",), content, text)
    if header == "TMSCT":
        return Said(("Listen node",), None, text) if first == "0" else Said(("reply to script", first), rest, text)
    if header == "TMSTA" and first == "01":
        number, _, state = rest.partition(",")
        return Said(("tag", str(int(number)) if number.isdigit() else number), state, text)
    return Said((header, first), None, text)


def shown(data):
    return data.decode("utf-8", "backslashreplace").encode("unicode_escape").decode()


class Connection:
    """To the script port of a controller. What has come waits in `heard` until somebody takes it."""

    def __init__(self, port, host="127.0.0.1", seconds=10.0):
        self.socket = socket.create_connection((host, port), timeout=seconds)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.bytes = b""
        self.heard = []
        self.is_open = True

    def close(self):
        self.socket.close()

    def send(self, data):
        """False when the controller has closed the connection."""
        try:
            self.socket.sendall(data)
        except OSError:
            self.is_open = False
        return self.is_open

    def listen(self, seconds):
        """For so long, or until something has come; whether it has."""
        if not self.is_open or not select.select([self.socket], [], [], max(0.0, seconds))[0]:
            return False
        try:
            piece = self.socket.recv(PIECE)
        except OSError:
            piece = b""
        self.is_open = bool(piece)
        self.bytes += piece
        self.cut()
        return True

    def listen_until(self, moment):
        """The moment is of time.monotonic()."""
        while self.is_open and time.monotonic() < moment:
            self.listen(moment - time.monotonic())

    def cut(self):
        while True:
            head = FRAME.search(self.bytes)
            if not head:
                return
            end = head.end() + int(head[2]) + TAIL
            if len(self.bytes) < end:
                return
            self.heard.append(said(self.bytes[head.start():end]))
            self.bytes = self.bytes[end:]

    def take(self, about, seconds):
        """The first that was said about it, now or within the time; None: nothing was."""
        deadline = time.monotonic() + seconds
        while True:
            found = next((one for one in self.heard if one.about == about), None)
            if found:
                self.heard.remove(found)
                return found
            left = deadline - time.monotonic()
            if left <= 0 or not self.is_open:
                return None
            self.listen(left)
