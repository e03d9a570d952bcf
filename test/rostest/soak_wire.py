"""The fault proxy (test/integration/hostile/tm_fault_proxy) between the command node and its simulated controller."""
import subprocess

# What TCP cannot do to a stream, as to double what the layer sends, is not among them; nor is what tells lies of a motion.
FAULTS = [f"script {fault}" for fault in (
    "drop count=3", "drop direction=to_controller count=2", "duplicate count=5", "delay time=0.3 jitter=0.2",
    "overtaken time=0.5 count=3", "swap count=3", "byte_by_byte", "byte_by_byte rate=200", "merge time=0.1",
    "cut time=0.2 count=5", "wrong_checksum count=2", "wrong_checksum_then_good count=2", "garbage text=xyz count=3",
    "bad_length text=-1 count=1", "bad_length text=99999999999999999999 count=1", "other_id count=2",
    "cperr text=04 count=1", "reset count=1", "reset direction=to_controller count=1", "close count=1", "refuse",
    "silence", "close_at_once", "never_read")]
FAULTS += [f"status {fault}" for fault in ("drop", "delay time=0.3 jitter=0.2", "byte_by_byte", "wrong_checksum count=50",
                                           "garbage text=xyz count=50", "reset count=1", "refuse", "silence")]


class Wire:
    """Its `ports` are those that clients are to use: (script, status)."""

    def __init__(self, program, script_port, status_port):
        self._proxy = subprocess.Popen([program, "--script", str(script_port), "--status", str(status_port)],
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        told = dict(word.split("=") for word in self._proxy.stdout.readline().split()[1:])
        self.ports = int(told["script"]), int(told["status"])

    def say(self, line):
        """Raises when it does not do so."""
        self._proxy.stdin.write(line + "\n")
        self._proxy.stdin.flush()
        answer = self._proxy.stdout.readline()
        if not answer.startswith("ok"):
            raise RuntimeError(f"{line}: {answer or 'the proxy has ended'}")

    def close(self):
        self._proxy.stdin.close()
        self._proxy.wait()
