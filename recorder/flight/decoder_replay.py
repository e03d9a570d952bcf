"""Every recorded frame is read once more by the decoder, and its reading laid beside what was recorded.

Compared are the readable text of the bytes, whether they are a frame, and what it means. What was no frame when it came has to
be none now; why it is none may be said otherwise, as of faulty bytes only the first are recorded."""
import json
import subprocess

from flight.run import RunError
from flight.verdict import Difference, Verdict

# What the link adds to the meaning of a reply that it does not wait for any more.
LATE = " (no request waits for it)"
SECONDS = 120


def replay(run, tm_frame):
    """The Verdict on all frames of the run, by the program tm_frame."""
    verdict = Verdict("decoder")
    for sender, frames in by_sender(run.frames).items():
        for frame, reading in zip(frames, readings(tm_frame, sender, frames)):
            compare(frame, reading, verdict)
    verdict.differences.sort(key=lambda difference: difference.time)
    return verdict


def by_sender(frames):
    """As they are read: by who gets them, and what port it is."""
    groups = {"client": [], "controller": [], "status": []}
    for frame in frames:
        groups["status" if frame.of_status_port else "client" if frame.sent else "controller"].append(frame)
    return {sender: group for sender, group in groups.items() if group}


def readings(tm_frame, sender, frames):
    """What the decoder says of each frame: {valid, meaning, text}."""
    lines = "".join(frame.data.hex() + "\n" for frame in frames)
    try:
        done = subprocess.run([str(tm_frame), "decode", "--hex", "--trace-of", sender], input=lines, capture_output=True, text=True,
                              timeout=SECONDS, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise RunError(f"{tm_frame} cannot be used: {error}; rebuild it, or give another folder with --programs") from None
    answers = done.stdout.splitlines()
    if done.returncode not in (0, 1) or len(answers) != len(frames):
        raise RunError(f"{tm_frame} has answered {len(answers)} of {len(frames)} frames: {done.stderr.strip() or 'no reason given'}")
    return [json.loads(answer) for answer in answers]


def compare(frame, reading, verdict):
    """Adds what is otherwise."""
    verdict.compared += 1
    who = "sent" if frame.sent else "received"
    if reading["text"] != frame.text:
        verdict.differences.append(Difference(frame.time, f"bytes of a frame that was {who}", f"{frame.text} ({frame.meaning})",
                                              f"{reading['text']} ({reading['meaning']})"))
    elif frame.refused:
        if reading["valid"]:
            verdict.differences.append(Difference(frame.time, f"a frame that was {who}", frame.meaning, reading["meaning"]))
    elif not reading["valid"] or not means(frame, reading["meaning"]):
        verdict.differences.append(Difference(frame.time, f"meaning of a frame that was {who}", frame.meaning, reading["meaning"]))


def means(frame, meaning):
    if frame.of_status_port and frame.sent:
        return True  # the link says why it asks, the decoder what it asks for
    recorded = frame.meaning
    return (recorded[:-len(LATE)] if recorded.endswith(LATE) else recorded) == meaning
