"""Is all of the run in the bag? What is missing, and what is worth a look."""
from flight.tags import REPLY, SCRIPT

MOST_TOLD = 20


def faults(run):
    """Sentences about what is missing; none: the recording is whole."""
    found = [f"{loss.count} of {loss.topic} lost before {loss.time:.3f} s" for loss in run.losses]
    found += [f"{count} of {topic} cannot be used: their numbers are invalid or out of range" for topic, count in run.unusable.items()]
    if not run.frames:
        found.append("there are no frames: no link was made during the recording")
    for goal in run.goals:
        if goal.end is None:
            found.append(f"{goal.action}, a goal of {goal.begun:.3f} s, has no result: the recording ended before it did")
    return found


def remarks(run):
    """Sentences about what is no fault of the recording."""
    said = [f"{goal.action}, a goal of {goal.begun:.3f} s: its message was sent before the recorder was connected to its client"
            for goal in run.goals if goal.message is None]
    said += [f"at {frame.time:.3f} s the command layer received what it could not read: {frame.meaning}"
             for frame in run.frames if frame.refused]
    said += [f"script {identity} of {time:.3f} s has no reply" for identity, time in unanswered(run.script_frames)]
    if run.far_stamps:
        said.append(f"{run.far_stamps} messages have stamps of another time, and are shown at the time of recording: the clocks of node and"
                    " recorder differ, or one was set meanwhile")
    if not run.axes:
        said.append("robot_data is not in the bag, or the command node has no model: no limits are drawn")
    return said[:MOST_TOLD] + ([f"and {len(said) - MOST_TOLD} more"] if len(said) > MOST_TOLD else [])


def unanswered(frames):
    """(id, time) of the scripts that nobody has answered by their id."""
    asked = {}
    for frame in frames:
        script, reply = SCRIPT.match(frame.data), REPLY.match(frame.data)
        if frame.sent and script:
            asked[script[1].decode()] = frame.time
        elif not frame.sent and reply:
            asked.pop(reply[1].decode(), None)
    return list(asked.items())
