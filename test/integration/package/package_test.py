#!/usr/bin/env python3
"""What another project finds of the build: its headers, its targets, and that a program made of them runs.

Usage: package_test.py CMAKE SOURCES BUILD PackageOfCatkin|PackageWithoutRos; CONSUMER_OPTIONS: how the other project is configured
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE, SOURCES, BUILD = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
OPTIONS = os.environ["CONSUMER_OPTIONS"].split(";")
CONSUMER = pathlib.Path(__file__).parent / "consumer"
# What a workspace that was sourced offers shall not be found in place of what is looked for.
PLAIN = {name: value for name, value in os.environ.items() if name not in ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "DESTDIR")}


def run(*words):
    done = subprocess.run(words, env=PLAIN, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=200, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


def headers_in(folder):
    return {str(header.relative_to(folder)) for header in folder.rglob("*.h")}


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = cls.folder / "prefix"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)

    def use(self, space, *options):
        """What a program says that is made with the package in this space."""
        built = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        run(CMAKE, "-S", CONSUMER, "-B", built, f"-DCMAKE_PREFIX_PATH={space}", *OPTIONS, *options)
        self.assertIn(f"cobot_command_DIR:PATH={space}/", (built / "CMakeCache.txt").read_text(encoding="utf-8"))
        run(CMAKE, "--build", built)
        return run(built / "consumer")

    def assert_works(self, said):
        self.assertEqual(said.splitlines()[0], "$TMSCT,14,1,ScriptExit(),*67")
        self.assertIn("16#255", said.splitlines()[1])


class PackageWithoutRos(Package):
    def test_is_found_where_it_is_installed(self):
        self.assert_works(self.use(self.prefix))

    def test_has_the_public_headers_and_no_others(self):
        rooms = {header for header in headers_in(SOURCES / "include") if not header.startswith("cobot_command/ros/")}
        installed = headers_in(self.prefix / "include")
        self.assertEqual({header for header in installed if not header.split("/")[1][0].isupper()}, rooms)

    def test_has_programs_that_find_their_libraries(self):
        program = next(self.prefix.rglob("tm_frame"))
        self.assertIn("usage", run(program, "--help").lower())


class PackageOfCatkin(PackageWithoutRos):
    def test_is_found_in_the_devel_space(self):
        self.assert_works(self.use(BUILD / "devel", "-DWITH_CATKIN=ON"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
