"""Notes which rows of the error tables a test has really seen, for the check that none is left out.

Each test program writes its own file, of lines "block id", into the folder COBOT_PROVOKED_ERRORS if that is set.
"""
import os
import pathlib
import re
import sys


def _open_notes():
    folder = os.environ.get("COBOT_PROVOKED_ERRORS", "")
    if not folder:
        return None
    os.makedirs(folder, exist_ok=True)
    return (pathlib.Path(folder) / f"{pathlib.Path(sys.argv[0]).stem}.txt").open("w", encoding="utf-8")


_notes = _open_notes()  # at once: what an earlier run noted counts no more, and who notes nothing has a file as well


def block_of(message):
    """"change_tcp" of a ChangeTCPResult or a ChangeTCPGoal."""
    name = re.sub(r"(Result|Goal|Action)$", "", type(message).__name__)
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


# By which load_path tells of what any block may have to tell of.
OF_LOAD_PATH = {0x10: 1001, 0x99: 1002, 0x216: 1000, 0x220: 1003, 0x221: 1005, 0x222: 1002}


def own_number(goal, error_id):
    return OF_LOAD_PATH.get(error_id, error_id) if block_of(goal) == "load_path" else error_id


def note(block, error_id):
    if _notes:
        print(block, hex(error_id), file=_notes, flush=True)
