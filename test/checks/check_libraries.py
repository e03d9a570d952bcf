#!/usr/bin/env python3
"""Fails when a program that is to do without the simulated controller has it nonetheless: in one of the libraries that are loaded with
it, or in a symbol that they or it have or ask for."""
import pathlib
import re
import subprocess
import sys

LIBRARY = re.compile(r"(libcobot_\w+\.so\S*) => (\S+)")
OF_SIMULATION = re.compile(r"libcobot_(simulator|\w*simulation)\.so")
SYMBOL = re.compile(r"\bcobot_command::(simulator::|runtime::Simulat|ros_adapter::Simulat)")


def printed(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def own_libraries(program):
    """Our own, by name: those that it asks for, and those that they ask for in turn."""
    return dict(LIBRARY.findall(printed("ldd", str(program))))


def symbols_of(file):
    # A program has its symbols in the static table, also where all rooms are linked into it.
    table = ["--dynamic"] if ".so" in pathlib.Path(file).name else []
    return [line for line in printed("nm", "--demangle", *table, str(file)).splitlines() if SYMBOL.search(line)]


def faults(program):
    libraries = own_libraries(program)
    for name in sorted(libraries):
        if OF_SIMULATION.match(name):
            yield f"{program} loads {name}"
    for file in [str(program), *libraries.values()]:
        for symbol in symbols_of(file):
            yield f"{file}: {symbol}"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found[:20]) or "nothing of the simulated controller")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
