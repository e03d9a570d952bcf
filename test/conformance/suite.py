"""The checks, and what they are made with.

A check is a function of a robot that raises AssertionError when a promise is not kept. Its id is stable: it is never
given to another promise, and it says nothing that may change (how certain the fact is may).
"""
import importlib
import pathlib
import re

DOCUMENTED = 'documented'  # a manual, a data sheet, or a capture of a real robot says so
DERIVED = 'derived'  # inferred, computed, or seen only through what other clients do
CHOICE = 'choice'  # the facts end; the simulator chose (doc/simulator.md). A real robot may differ
CERTAINTIES = (DOCUMENTED, DERIVED, CHOICE)

VERSIONS = ('1.68', '1.72', '1.76', '1.80', '1.82', '1.84')  # of TMflow
DEFAULT_VERSION = '1.80'

CHECKS = {}


class Check:
    """One promise.

    since, until: the TMflow versions in which the promise holds, both included; until None: all later ones.
    safe: may run on a real robot: it moves nothing, stops nothing, leaves no Listen node and writes no output.
    setup: how a simulator is to be set up for it (robot.OPTIONS, and `operator`: a command of the operator).
    """

    def __init__(self, identity, promise, function, source, certainty, since, until, safe, setup):
        self.id, self.promise, self.function, self.source = identity, promise, function, source
        self.certainty, self.since, self.until, self.safe, self.setup = certainty, since, until, safe, setup

    @property
    def section(self):
        return self.id.split('-')[1].rsplit('.', 1)[0]

    @property
    def version(self):
        """The version to check a simulator in: the default one where the promise holds in it."""
        if older(DEFAULT_VERSION, self.since):
            return self.since
        return self.until if self.until and older(self.until, DEFAULT_VERSION) else DEFAULT_VERSION

    def holds_in(self, version):
        return not older(version, self.since) and not (self.until and older(self.until, version))


def older(one, other):
    return _numbers(one) < _numbers(other)


def _numbers(version):
    return [int(number) for number in re.findall(r'\d+', version)[:2]]


def check(identity, promise, source, certainty=DOCUMENTED, since='1.68', until=None, safe=False, **setup):
    """Makes the function below it a check."""

    def add(function):
        if identity in CHECKS:
            raise ValueError('two checks are called ' + identity)
        CHECKS[identity] = Check(identity, promise, function, source, certainty, since, until, safe, setup)
        return function

    return add


def load():
    """All checks, in the order of their ids."""
    for file in sorted((pathlib.Path(__file__).parent / 'facts').glob('[a-z]*.py')):
        importlib.import_module('facts.' + file.stem)
    return [CHECKS[identity] for identity in sorted(CHECKS)]


# What checks say when a promise is broken -------------------------------------------------------


def true(condition, otherwise):
    if not condition:
        raise AssertionError(otherwise)


def equal(found, expected, what=''):
    if found != expected:
        raise AssertionError('%s%r, expected %r' % (what and what + ': ', found, expected))


def near(found, expected, tolerance, what=''):
    """Numbers, or lists of numbers."""
    one, other = (found, expected) if isinstance(expected, (list, tuple)) else ([found], [expected])
    if len(one) != len(other) or any(not abs(a - b) <= tolerance for a, b in zip(one, other)):
        raise AssertionError('%s%s, expected %s within %s' % (what and what + ': ', found, expected, tolerance))
