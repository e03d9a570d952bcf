"""Notes which rows of the error tables a test has really seen, for the check that none is left out.

Each test program writes its own file, of lines "block id", into the folder COBOT_PROVOKED_ERRORS if that is set.
"""
import os
import pathlib
import re
import sys

_folder = os.environ.get("COBOT_PROVOKED_ERRORS")
_file = None


def block_of(message):
    """"change_tcp" of a ChangeTCPResult or a ChangeTCPGoal."""
    name = re.sub(r"(Result|Goal|Action)$", "", type(message).__name__)
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def note(block, error_id):
    global _file
    if not _folder:
        return
    if _file is None:
        folder = pathlib.Path(_folder)
        folder.mkdir(parents=True, exist_ok=True)
        _file = (folder / f"{pathlib.Path(sys.argv[0]).stem}.txt").open("w", encoding="utf-8")
    print(block, hex(error_id), file=_file, flush=True)
