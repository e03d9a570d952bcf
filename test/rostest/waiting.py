"""For what comes in its own time: no test sleeps for as long as something should take."""

import time

DEADLINE = 30.0  # [s] of wall time; far beyond what anything here takes


def wait_until(condition, what, seconds=DEADLINE):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"{what} did not come within {seconds} s")
        time.sleep(0.01)
