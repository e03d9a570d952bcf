"""A fresh simulated controller for a replay, set up like the robot of the recording."""
import re
import subprocess

from flight.run import RunError
from flight.tags import REPLY, SCRIPT

VERSIONS = ("1.68", "1.72", "1.76", "1.80", "1.82", "1.84")
LISTENING = re.compile(r"listening script=(\d+) status=\d+")
DIGITS = 6  # of an angle [deg]: less than what a joint tells


def options_of(run, remarks):
    """What tm_simulator has to be told, as far as it can be seen in the recording."""
    posture = ",".join(f"{angle:.{DIGITS}f}" for angle in run.joints.angles[0])
    options = [f"--start-posture-deg={posture}"] if len(run.joints.names) == 6 else []
    model = run.identity.get("model")
    if model:
        options.append(f"--model={model}")
    else:
        remarks.append("the recording does not name the arm; the default arm of tm_simulator is simulated")
    version = version_of(run.identity.get("tmflow_version", ""))
    if version:
        options.append(f"--tmflow-version={version}")
    if takes_velocities(run.script_frames):
        options.append("--velocity-licence")
    return options


def takes_velocities(frames):
    """Whether the controller has accepted a script of continuous velocities, for which it needs a licence."""
    asked = {script[1] for frame in frames if frame.sent and b"ContinueV" in frame.data for script in [SCRIPT.match(frame.data)] if script}
    replies = [REPLY.match(frame.data) for frame in frames if not frame.sent]
    return any(reply and reply[1] in asked and reply[2] == b"OK" for reply in replies)


def version_of(text):
    """The newest that is not newer: '1.82.5100' is a 1.82."""
    number = re.match(r"(\d+)\.(\d+)", text)
    if not number:
        return None
    recorded = (int(number[1]), int(number[2]))
    return max((v for v in VERSIONS if tuple(map(int, v.split("."))) <= recorded), default=VERSIONS[0],
               key=lambda v: tuple(map(int, v.split("."))))


class Simulator:
    """The program tm_simulator on a free port, for a `with`."""

    def __init__(self, program, options, time_scale):
        self.command = [str(program), "--script-port=0", "--status-port=0", f"--time-scale={time_scale:g}", *options]
        self.process = None
        self.port = None

    def __enter__(self):
        try:
            self.process = subprocess.Popen(self.command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        except OSError as error:
            raise RunError(f"{self.command[0]} cannot be started: {error}") from None
        # Its first line, or its end: it serves, or says why not.
        line = self.process.stdout.readline()
        listening = LISTENING.match(line)
        if not listening:
            reason = self.process.communicate()[1].strip()
            raise RunError(f"the simulator does not accept {' '.join(self.command[1:])}: {reason}")
        self.port = int(listening[1])
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.communicate()
