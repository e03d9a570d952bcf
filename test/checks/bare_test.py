#!/usr/bin/env python3
"""Of scripts/bare what needs neither root nor a network: the commands that it reads in the README, its verdict on skipped tests, what it refuses
before it changes anything, and how it unpacks an image."""
import io
import json
import os
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

import check_run_packages

ROOT = pathlib.Path(sys.argv.pop(1))
SIMULATOR = sys.argv.pop(1)
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "scripts"))
import bare  # noqa: E402 # they are found only now
import try_image  # noqa: E402

BY_CTEST = """
  3/9 Test  #1: protocol.Frame.isRead ................   Passed    0.02 sec
  4/9 Test  #2: conformance.techmanpy ................***Skipped   0.10 sec
  5/9 Test  #3: tools.aProgram .......................***Not Run   0.00 sec

The following tests did not run:
\t  2 - conformance.techmanpy (Skipped)
"""
BY_RUNNER = """
skipped: ros.PickAndPlaceFile.aFileWithoutPermissionIsRefused
  root may read all
ros: 41 passed, 0 failed, 1 skipped
"""
LAST_TEST = """
1/2 Testing: checks.what_a_program_has_of_the_simulator_is_found
Ran 2 tests in 0.1s

OK (skipped=1)
2/2 Testing: checks.pages_say_what_is
"""


def archive_of(files):
    with io.BytesIO() as archive:
        with tarfile.open(fileobj=archive, mode="w") as opened:
            for name, content in files.items():
                entry = tarfile.TarInfo(name)
                entry.size, entry.uid, entry.gid = len(content), os.getuid(), os.getgid()
                opened.addfile(entry, io.BytesIO(content))
        return archive.getvalue()


def image_of(layers):
    """An oci-archive, with names in place of digests."""
    blobs = {f"blobs/of/layer{number}": archive_of(files) for number, files in enumerate(layers)}
    manifest = {"layers": [{"digest": f"of:layer{number}"} for number in range(len(layers))], "config": {"digest": "of:config"}}
    blobs |= {"blobs/of/config": json.dumps({"config": {"User": "robot"}}).encode(), "blobs/of/manifest": json.dumps(manifest).encode()}
    return archive_of({**blobs, "index.json": json.dumps({"manifests": [{"digest": "of:manifest"}]}).encode()})


class CommandTest(unittest.TestCase):
    def test_is_the_line_of_the_readme_without_its_comment(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        self.assertEqual(bare.command_of(readme, "demo"), "scripts/demo")
        self.assertEqual(bare.command_of("## Two commands\nAs root:\n\n    scripts/test -R all  # runs\n\n## More\n", "test"), "scripts/test -R all")

    def test_is_not_guessed(self):
        for readme in ("", "## More\n    scripts/demo\n", "## Two commands\n    scripts/demo_cell\n    scripts/test\n## More\n    scripts/demo\n"):
            with self.assertRaisesRegex(ValueError, "has 0 lines"):
                bare.command_of(readme, "demo")


class SkippedTest(unittest.TestCase):
    def test_is_read_from_ctest(self):
        self.assertEqual(set(bare.skipped_in(BY_CTEST)), {"conformance.techmanpy", "tools.aProgram"})

    def test_is_read_from_the_runner_of_tests(self):
        self.assertEqual(bare.skipped_in(BY_RUNNER), ["ros.PickAndPlaceFile.aFileWithoutPermissionIsRefused"])
        self.assertEqual(bare.skipped_in("ros: 41 passed, 0 failed, 2 skipped\n"), ["ros (unnamed tests: 2)"])
        self.assertEqual(bare.skipped_in("ros: 41 passed, 0 failed, 0 skipped\n"), [])

    def test_is_read_from_files_of_the_build(self):
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder)
            (build / "LastTest.log").write_text(LAST_TEST, encoding="utf-8")
            (build / "configure.log").write_text("-- Found OpenSSL\n-- FCL was not found: no second opinion\n", encoding="utf-8")
            self.assertEqual(bare.skipped_in_build(build), ["checks.what_a_program_has_of_the_simulator_is_found (of its tests: 1)",
                                                            "FCL was not found: no second opinion"])

    def test_is_what_python_packages_are_missing_for(self):
        setup = (ROOT / "scripts/setup.sh").read_text(encoding="utf-8")
        self.assertIn(bare.NO_PYTHON_PACKAGES, setup)
        self.assertEqual(len(bare.skipped_in(f"{bare.NO_PYTHON_PACKAGES}\n")), 1)


class VerdictTest(unittest.TestCase):
    def status(self, log, user="root"):
        with tempfile.NamedTemporaryFile("w", suffix=".log", encoding="utf-8") as file:
            file.write(log)
            file.flush()
            done = subprocess.run([ROOT / "scripts/bare.py", "skipped", "--user", user, file.name], check=False, capture_output=True, text=True)
            return done.returncode, done.stdout

    def test_is_0_without_a_skipped_test(self):
        self.assertEqual(self.status("100% tests passed\n"), (0, "No test was skipped.\n"))

    def test_is_1_and_names_the_test_otherwise(self):
        self.assertEqual(self.status(BY_CTEST), (1, "skipped: conformance.techmanpy\nskipped: tools.aProgram\n"))

    def test_is_0_for_what_root_cannot_do_and_1_for_another_user(self):
        self.assertEqual(self.status(BY_RUNNER)[0], 0)
        self.assertEqual(self.status(BY_RUNNER, "robot")[0], 1)


class RefusalTest(unittest.TestCase):
    def refusal(self, *options, **programs):
        """What scripts/bare prints; `programs` print these texts in place of the system's."""
        with tempfile.TemporaryDirectory() as folder:
            for name, printed in {"id": "0", "df": "99999", "git": "", "mktemp": "", **programs}.items():
                fake = pathlib.Path(folder) / name
                fake.write_text(f"#!/bin/sh\ncat <<'END'\n{printed}\nEND\n", encoding="utf-8")
                fake.chmod(0o755)
            done = subprocess.run([ROOT / "scripts/bare", *options], env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}, check=False,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            return done.stderr

    def test_names_what_is_allowed(self):
        self.assertIn("needs one of demo, test, root and image", self.refusal())
        self.assertIn("'demos' is unknown", self.refusal("demos"))
        self.assertIn("given are demo and test", self.refusal("demo", "test"))
        self.assertIn("allowed: bookworm, trixie", self.refusal("--suite", "sid", "demo"))
        self.assertIn("--mirror needs a value", self.refusal("demo", "--mirror"))
        self.assertIn("--as-user is for demo and test", self.refusal("image", "--as-user"))

    def test_is_for_users_without_root(self):
        self.assertIn("needs root", self.refusal("demo", id="1000"))

    def test_is_for_computers_without_space(self):
        self.assertIn("has 7 GiB free, and 8 are needed", self.refusal("demo", df="Avail\n  8191"))

    def test_is_for_changes_that_are_not_committed(self):
        self.assertIn("uncommitted changes. Commit them, or include them with --dirty:\n M README.md", self.refusal("demo", git=" M README.md"))


class ImageTest(unittest.TestCase):
    def test_is_unpacked_without_what_a_later_layer_removes(self):
        layers = [{"kept": b"1", "removed": b"2", "folder/old": b"3"}, {".wh.removed": b"", "folder/.wh..wh..opq": b"", "folder/new": b"4"}]
        with tempfile.TemporaryDirectory() as folder:
            archive = pathlib.Path(folder) / "image.tar"
            archive.write_bytes(image_of(layers))
            unpacked = pathlib.Path(folder) / "unpacked"
            unpacked.mkdir()
            with tarfile.open(archive) as opened:
                self.assertEqual(try_image.unpack(opened, unpacked), {"User": "robot"})
            files = {str(file.relative_to(unpacked)): file.read_bytes() for file in unpacked.rglob("*") if file.is_file()}
        self.assertEqual(files, {"kept": b"1", "folder/new": b"4"})


class RunPackagesTest(unittest.TestCase):
    def test_are_found_when_they_are_missing_or_not_needed(self):
        if not check_run_packages.has_packages():
            self.skipTest("dpkg-query is missing")
        faults = "\n".join(check_run_packages.faults(SIMULATOR, "libc6\nlibnothing1 | libnothing2  # of nobody\n"))
        self.assertRegex(faults, "loads .*/libfmt.so.* of libfmt.*, which is not in the list")
        self.assertIn("libnothing1 | libnothing2 is in the list", faults)
        self.assertNotIn("libc6", faults)


if __name__ == "__main__":
    unittest.main()
