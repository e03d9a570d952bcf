#!/usr/bin/env python3
"""Every command of doc/cell.md does what the page says: those in blocks in their order, those in its text with names put in."""
import os
import pathlib
import re
import shlex
import signal
import subprocess
import tempfile
import unittest

import rospkg
import rospy

from cobot_command.msg import CellDistances, CellRobot, CellState, CommandStatus
from cobot_test import Latest, program
from own_cell import kill, robot_in
from own_nodes import Heard

PACKAGE = pathlib.Path(rospkg.RosPack().get_path("cobot_command"))
PAGE = (PACKAGE / "doc" / "cell.md").read_text(encoding="utf-8")
BLOCK = re.compile(r"^ *```sh\n(.*?)^ *```$", re.M | re.S)
SPAN = re.compile(r"(?<!`)`((?:tm_cell|scripts/\w+|examples/\w+\.\w+|rosrun|roslaunch|rosservice|cell_monitor)(?: [^`]*)?)`(?!`)")
# Those of the page, in its words.
LAUNCH = "roslaunch cobot_command cell.launch "
AGAIN = "roslaunch cobot_command cell_robot.launch "
MONITOR = "cell_monitor "
WITH_A_LONG_LEASE = "parameters: {lease: 5}\n"
COMMAND_DEADLINE = 120  # [s]


def commands():
    """Those in blocks, in their order, each in one line and without its comment."""
    found = []
    for block in BLOCK.findall(PAGE):
        for line in block.replace("\\\n", " ").splitlines():
            words = shlex.split(line, comments=True)
            if words:
                found.append(line.split(" #")[0].strip())
    return found


class CellPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.environment = dict(os.environ, PATH=f"{os.path.dirname(program('tm_cell'))}:{os.environ['PATH']}")
        self.state = Latest("/cell/state", CellState)
        self.under_way = {}

    # --- What it checks.
    def test_the_commands_of_its_blocks_do_what_they_say_one_after_the_other(self):
        all_of_them = commands()
        self.assertGreater(len(all_of_them), 10)
        for command in all_of_them:
            with self.subTest(command=command):
                self.before(command)
                if command.startswith((LAUNCH, AGAIN, MONITOR)):
                    self.start(command)
                else:
                    self.succeed(command)
                self.after(command)
        self.end_all()

    def test_its_launch_runs_a_cell_with_a_mechanism_too(self):
        text = (PACKAGE / "config/cells/pallet.yaml").read_text(encoding="utf-8")
        cell = pathlib.Path(self.folder, "pallet.yaml")
        cell.write_text(text.replace("cell: pallet\n", "cell: pallet\n" + WITH_A_LONG_LEASE), encoding="utf-8")
        artifact = os.path.join(self.folder, "pallet.artifact")
        self.run_shell(f"tm_cell build {cell} -o {artifact}")
        launch = next(c for c in commands() if c.startswith(LAUNCH))
        self.start(re.sub(r"cell_file:=\S+ artifact:=\S+", f"cell_file:={cell} artifact:={artifact}", launch))
        self.wait_for_mode(CellState.READY)
        self.assertEqual([r.name for r in self.state.message.robots], ["RA", "PALLET"])
        self.run_shell("rosrun cobot_command run_cell.py --cycles 1")
        self.end_all()

    def test_the_commands_in_its_text_are_such_as_there_are(self):
        artifact = os.path.join(self.folder, "handover")
        cell = PACKAGE / "config/cells/handover.yaml"
        self.run_shell(f"tm_cell build {cell} -o {artifact}")
        mesh = os.path.join(self.folder, "plate.stl")
        with open(mesh, "w", encoding="utf-8") as file:
            file.write("solid plate\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 300 0 0\nvertex 0 200 0\nendloop\n"
                       "endfacet\nendsolid\n")
        names = {"FILE.stl": mesh, "FILE": artifact, "ARTIFACT": artifact, "CELL": str(cell), "FOLDER": self.folder,
                 "EVENTS": "RA_g_T1", "EVENT": "RA_b_Z1", "ROBOT": "RA"}
        spans = SPAN.findall(PAGE)
        self.assertGreater(len(spans), 20)
        for span in spans:
            with self.subTest(command=span):
                words = [names.get(word, word) for word in span.split()]
                if words[0] == "tm_cell":
                    if words[1:2] == ["build"] and "-o" in words:
                        words[-1] += ".new"
                    # The bare name of a command is no whole command line.
                    self.run_shell(shlex.join(words if len(words) > 2 else [*words, "--help"]))
                elif len(words) > 1 and not words[0].startswith(("scripts/", "examples/")):
                    self.fail("write it into a block: there it is run")
                elif words[0].startswith(("scripts/", "examples/")):
                    # They take from half a minute to hours; that they know the word is seen from what they say of themselves.
                    self.assertTrue(os.access(PACKAGE / words[0], os.X_OK), words[0])
                    if words[1:2] == ["cell"]:
                        self.assertIn("cell", (PACKAGE / words[0]).read_text(encoding="utf-8"))

    # --- What a reader would have done before, and sees behind it.
    def before(self, command):
        if command.startswith(f"{AGAIN}robot:=RA seat:=false") or command.startswith("rosservice call /cell/confirm_clear"):
            if AGAIN in self.under_way:
                self.under_way.pop(AGAIN).end(signal.SIGINT)
            else:
                kill("/RA/command_node")
            self.state.wait_for(lambda m: robot_in(m, "RA").state == CellRobot.LOST, "RA, lost")
        elif command.startswith(AGAIN) and AGAIN in self.under_way:
            self.under_way.pop(AGAIN).end(signal.SIGINT)
        elif command.startswith(MONITOR):
            self.end_all()

    def after(self, command):
        if command.startswith(LAUNCH):
            self.wait_for_mode(CellState.READY)
        elif command.startswith(AGAIN):
            status = Latest("/RA/command_status", CommandStatus)
            status.wait_for(lambda s: s.link_state == CommandStatus.READY, "a ready link")
        elif command.startswith(MONITOR):
            Latest("/cell/distances", CellDistances).wait_for(lambda m: m.pairs, "distances")

    # --- How they are run.
    def start(self, command):
        command = self.put_in(command)
        kind = next(k for k in (LAUNCH, AGAIN, MONITOR) if command.startswith(k))
        process = Heard("bash", "-c", f"exec {command}", env=self.environment)
        self.under_way[kind] = process
        self.addCleanup(self.clear, process)

    def clear(self, process):
        if process.is_alive():
            process.end(signal.SIGINT)
        process.clear_away()

    def end_all(self):
        for process in reversed(list(self.under_way.values())):
            if process.is_alive():
                process.end(signal.SIGINT)
        self.under_way.clear()

    def succeed(self, command):
        output = self.run_shell(self.put_in(command))
        if command.startswith("rosservice call"):
            self.assertIn("success: True", output)

    def put_in(self, command):
        """The same in a folder of the test, without a window, faster, and with a lease that a busy machine keeps."""
        command = re.sub(r"/tmp/(?=\w+\.artifact)", f"{self.folder}/", command)
        command = re.sub(r"(\$PWD/)?config/cells/head_on\.yaml", rospy.get_param("~cell_file"), command)
        if command.startswith(LAUNCH):
            command = command.replace("rviz:=true", "rviz:=false") + " time_scale:=10"
        return command

    def run_shell(self, command):
        ran = subprocess.run(["bash", "-c", command], cwd=PACKAGE, env=self.environment, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True, timeout=COMMAND_DEADLINE, check=False)
        self.assertEqual(ran.returncode, 0, ran.stdout)
        return ran.stdout

    def wait_for_mode(self, mode):
        self.state.forget()
        try:
            self.state.wait_for(lambda _: True, "a supervisor")
            self.state.wait_for(lambda m: m.mode == mode, f"the mode {mode} of the cell")
        except AssertionError as missing:
            said = "\n".join(process.output() for process in self.under_way.values())
            raise AssertionError(f"{missing}; it has said:\n{said}") from missing


if __name__ == "__main__":
    import rostest

    rospy.init_node("cell_page_test")
    rostest.rosrun("cobot_command", "cell_page", CellPage)
