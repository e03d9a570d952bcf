"""Queue tags on the wire: which script has queued one, when it was accepted, when it came back, and as what."""
import dataclasses
import re
import typing

SCRIPT = re.compile(rb"\$TMSCT,\d+,(\w+),(.*),\*[0-9A-Fa-f]{2}\r?\n?\Z", re.DOTALL)
REPLY = re.compile(rb"\$TMSCT,\d+,(\w+),(OK|ERROR)((?:;\d+)*),\*")
TAG = re.compile(rb"\$TMSTA,\d+,01,0*(\d+)(?:,(true|false|none))?,\*")
QUEUED = re.compile(rb"^\s*QueueTag\(\s*(\d+)", re.MULTILINE)
MOTION = re.compile(rb"^\s*(?:Move_)?(PTP|Line|Circle|PLine|PVTEnter|ContinueV\w+)\(", re.MULTILINE)
STOP = re.compile(rb"^\s*StopAndClearBuffer\(", re.MULTILINE)


# How a tag can end: it was reached; a stop has dropped what was queued; its script was refused; its motion has failed.
OPEN, DONE, DROPPED, REFUSED, FAILED = "open", "done", "dropped by a stop", "refused", "failed"


@dataclasses.dataclass
class Tag:
    """One queue tag, from its script to its end. `end` is None while nobody knows it.

    `begun` is when its motion could begin: it was accepted, and the tag in front of it in the queue was reached."""
    number: int
    script: str
    motion: str  # PTP, Line ...; empty: none
    sent: float
    accepted: typing.Optional[float] = None
    end: typing.Optional[float] = None
    outcome: str = OPEN
    begun: float = 0.0

    def finish(self, time, outcome):
        self.end, self.outcome = time, outcome


def tags_in(frames):
    """All tags of the frames of a script port, in the order in which they were queued."""
    book = TagBook()
    for frame in frames:
        (book.take_sent if frame.sent else book.take_received)(frame)
    for before, tag in zip([None, *book.tags], book.tags):
        tag.begun = tag.sent if tag.accepted is None else tag.accepted
        if before and before.end is not None and (tag.end is None or before.end <= tag.end):
            tag.begun = max(tag.begun, before.end)
    return book.tags


class TagBook:
    def __init__(self):
        self.tags = []
        self.asked = []  # numbers of tags, asked for and not answered yet
        self.stops = set()  # ids of scripts that stop

    def open_tags(self):
        return [tag for tag in self.tags if tag.end is None]

    def take_sent(self, frame):
        script = SCRIPT.match(frame.data)
        if not script:
            question = TAG.match(frame.data)
            if question and not question[2]:
                self.asked.append(int(question[1]))
            return
        identity, text = script[1].decode(), script[2]
        if STOP.search(text):
            self.stops.add(identity)
        before = 0
        for queued in QUEUED.finditer(text):
            motions = MOTION.findall(text, before, queued.start())
            before = queued.end()
            self.tags.append(Tag(int(queued[1]), identity, words(motions), frame.time))

    def take_received(self, frame):
        reply, tag = REPLY.match(frame.data), TAG.match(frame.data)
        if reply:
            self.take_reply(reply[1].decode(), reply[2] == b"OK", frame.time)
        elif tag and tag[2]:
            self.take_report(int(tag[1]), tag[2], frame.time)

    def take_reply(self, identity, is_taken, time):
        if is_taken and identity in self.stops:
            # What was queued before is dropped, and its tags are never told.
            for tag in self.open_tags():
                if tag.script != identity:
                    tag.finish(time, DROPPED)
        for tag in self.open_tags():
            if tag.script == identity and tag.accepted is None:
                if is_taken:
                    tag.accepted = time
                else:
                    tag.finish(time, REFUSED)

    def take_report(self, number, state, time):
        is_answer = number in self.asked
        if is_answer:
            self.asked.remove(number)
        if state != b"true" and is_answer:
            return  # not yet
        tag = next((tag for tag in self.open_tags() if tag.number == number), None)
        if tag:
            tag.finish(time, DONE if state == b"true" else FAILED)


def words(motions):
    """PVTEnter is what a PVT begins with."""
    names = [motion.decode().replace("PVTEnter", "PVT") for motion in motions]
    return names[0] if len(names) == 1 else f"{len(names)} motions" if names else ""
