"""What was sent to the controller is sent to a fresh simulator, in its order, and the answers are laid beside the recorded ones.

A frame is sent when all that was received before it has come here as well, and the recorded pause in front of it is over, shortened
by the time scale of the simulator. Where the link was lost or closed the replay connects anew."""
import dataclasses
import time

from flight import tags, wire
from flight.simulator import Simulator, options_of
from flight.verdict import Difference, Verdict

TIME_SCALE = 10.0
PATIENCE = 3.0  # [s], beside the time that it took in the recording
MOST_MISSING = 5  # then the two have gone apart, and what follows says nothing new
AFTER = 0.3  # [s]; for what nobody has recorded
LAST_MOMENT = 1.0  # [s]; what is asked in it may be answered behind the end of the recording
CONNECTED = 2  # CommandStatus.PROBING, and all above
HEARS_NOTHING = "nothing"


def replay(run, tm_simulator, time_scale=TIME_SCALE, options=()):
    """The Verdict on the answers of the run, by the program tm_simulator."""
    verdict = Verdict("simulator")
    frames = run.script_frames
    if not any(frame.sent for frame in frames):
        verdict.remarks.append("nothing was sent, so there is nothing to replay")
        return verdict
    with Simulator(tm_simulator, [*options_of(run, verdict.remarks), *options], time_scale) as simulator:
        Replay(run, simulator, time_scale, verdict).go()
    return verdict


@dataclasses.dataclass
class Pace:
    """The time of the recording, and that of the replay."""
    scale: float
    recorded: float = 0.0
    here: float = dataclasses.field(default_factory=time.monotonic)

    def due(self, recorded):
        """When something is due here that came then."""
        return self.here + max(0.0, recorded - self.recorded) / self.scale

    def step(self, recorded):
        self.recorded, self.here = recorded, time.monotonic()


class Replay:
    def __init__(self, run, simulator, time_scale, verdict):
        self.run, self.simulator, self.verdict = run, simulator, verdict
        self.frames = run.script_frames
        self.breaks = link_breaks(run.links)
        self.pace = Pace(time_scale, self.frames[0].time)
        self.connection = None
        self.questions = []  # tags that were asked for, and not answered yet
        self.missing = 0

    def go(self):
        try:
            for index, frame in enumerate(self.frames):
                self.connect(index)
                (self.send if frame.sent else self.expect)(frame)
                self.pace.step(frame.time)
                if self.missing >= MOST_MISSING:
                    self.verdict.remarks.append(f"{MOST_MISSING} answers were not received: what was sent from {frame.time:.3f} s on is not replayed")
                    return
            self.hear_the_rest()
        finally:
            if self.connection:
                self.connection.close()

    def connect(self, index):
        """Anew where the recorded link has ended in between."""
        frame, before = self.frames[index], self.frames[index - 1] if index else None
        is_new = before and any(before.time < moment <= frame.time for moment in self.breaks)
        if self.connection and not is_new:
            return
        if self.connection:
            self.connection.close()
        self.connection = wire.Connection(self.simulator.port)
        self.questions.clear()

    def send(self, frame):
        self.connection.listen_until(self.pace.due(frame.time))
        question = tags.TAG.match(frame.data)
        if question and not question[2]:
            self.questions.append(str(int(question[1])))
        if not self.connection.send(frame.data):
            self.tell(frame, "the link", "a frame was sent", "the simulator has closed the connection")
            self.missing = MOST_MISSING

    def expect(self, frame):
        if frame.refused:
            self.verdict.not_compared += 1  # a fault of the wire
            return
        recorded = wire.said(frame.data)
        waited = max(0.0, frame.time - self.pace.recorded) / self.pace.scale
        came = self.connection.take(recorded.about, PATIENCE + 2 * waited)
        if came is None:
            self.missing += 1
            self.tell(frame, about(recorded), recorded.text, f"{HEARS_NOTHING} in {PATIENCE + 2 * waited:.1f} s")
        elif recorded.value is None or self.is_answer(recorded):
            self.verdict.not_compared += 1
        else:
            self.verdict.compared += 1
            if came.value != recorded.value:
                self.tell(frame, about(recorded), recorded.text, came.text)

    def is_answer(self, recorded):
        """Whether a tag is done already depends on the moment of the question."""
        if recorded.about[0] != "tag" or recorded.about[1] not in self.questions:
            return False
        self.questions.remove(recorded.about[1])
        return True

    def hear_the_rest(self):
        """What the simulator says besides, and the controller did not say."""
        self.connection.listen_until(time.monotonic() + AFTER)
        last = self.frames[-1]
        for heard in self.connection.heard:
            if heard.value is not None and not self.may_follow(heard.about):
                self.tell(last, about(heard), HEARS_NOTHING, heard.text)

    def may_follow(self, subject):
        """The recording may have ended before: tags that were open at its end, and replies to its last frames."""
        if subject[0] == "tag":
            return any(tag.end is None and str(tag.number) == subject[1] for tag in tags.tags_in(self.frames))
        sent = {match[1].decode(): frame.time for frame in self.frames if frame.sent
                for match in [tags.SCRIPT.match(frame.data)] if match}
        return subject[0].startswith("reply") and sent.get(subject[1], 0) > self.run.duration - LAST_MOMENT

    def tell(self, frame, what, recorded, came):
        self.verdict.differences.append(Difference(frame.time, what, recorded, came))


def about(said):
    return " ".join(said.about)


def link_breaks(links):
    """The moments at which a connection was not there any more."""
    was_there, moments = False, []
    for moment, state in links:
        is_there = state >= CONNECTED
        if was_there and not is_there:
            moments.append(moment)
        was_there = is_there
    return moments
