#!/usr/bin/env python3
"""Checks that a robot, or the simulator, speaks the protocol of the TM controllers.

Exit status: 0 if every check is kept (or is known not to be, see not_yet.txt), 1 if one is not, 2 on bad usage.
"""
import argparse
import concurrent.futures
import fnmatch
import pathlib
import sys
import time
import traceback

import report
import suite
from robot import RealRobot, Simulator

HERE = pathlib.Path(__file__).resolve().parent

WARNING = """
WARNING: --all makes the robot at {host} MOVE, stop, leave its Listen node, and switch its outputs.
It moves to the posture 0,0,90,0,90,0 deg from its present posture, turns J1 by up to 90 deg and some joints to far
ends of their ranges, and moves at full speed. The checks do not know what is mounted on the arm or what is around it.
Is everybody out of its reach? Is a hand on the emergency stop? Then type the address of the robot again.
"""


def main():
    options = parse()
    checks = [check for check in suite.load() if not options.only or matches(check, options.only)]
    if not checks:
        return usage('no check is called %s; --list names them all' % ', '.join(options.only))
    not_yet = read_not_yet(options.not_yet)
    if options.list:
        sys.stdout.write(report.as_markdown(checks, not_yet) if options.markdown else report.as_list(checks))
        return 0
    if options.spawn:
        subject, results = options.spawn, on_simulators(checks, Simulator(options.spawn), not_yet, options)
    elif options.host:
        if options.all and not confirmed(options.host):
            return usage('not confirmed: nothing was sent')
        subject, results = options.host, on_robot(checks, options)
    else:
        return usage('--spawn PROGRAM, --host ADDRESS or --list: what is to be done?')
    return conclude(results, subject, options)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('--spawn', metavar='PROGRAM', help='start this tm_simulator, a new one for each check')
    parser.add_argument('--host', help='check the robot at this address: the safe checks only')
    parser.add_argument('--port', type=int, default=5890, help='its script port (%(default)s)')
    parser.add_argument('--status-port', type=int, default=5891, help='its status port (%(default)s)')
    parser.add_argument('--tmflow', choices=suite.VERSIONS, help='its version; read from the robot if not given')
    parser.add_argument('--all', action='store_true', help='the unsafe checks too: the robot WILL MOVE')
    parser.add_argument('--only', metavar='ID', action='append', help='only these checks; TM-1.3.* is a pattern')
    parser.add_argument('--list', action='store_true', help='list the checks, run none')
    parser.add_argument('--markdown', action='store_true', help='with --list: as the table of doc/conformance.md')
    parser.add_argument('--not-yet', metavar='FILE', default=HERE / 'not_yet.txt', type=pathlib.Path,
                        help='checks that the simulator is known to fail, with reasons (%(default)s)')
    parser.add_argument('--jobs', type=int, default=4, help='simulators at a time (%(default)s)')
    parser.add_argument('--json', metavar='FILE', help='write the results there')
    parser.add_argument('--junit', metavar='FILE', help='write the results there')
    parser.add_argument('--verbose', action='store_true', help='list the checks that pass, too')
    return parser.parse_args()


def usage(message):
    print('run_conformance: ' + message, file=sys.stderr)
    return 2


def matches(check, patterns):
    return any(fnmatch.fnmatchcase(check.id, pattern) for pattern in patterns)


def read_not_yet(file):
    """Id -> reason, of the lines `ID reason`."""
    entries = {}
    for line in file.read_text(encoding='utf-8').splitlines():
        if line.strip() and not line.startswith('#'):
            identity, _, reason = line.partition(' ')
            if identity not in suite.CHECKS or identity in entries or not reason.strip():
                raise SystemExit('%s: unknown or repeated id, or no reason: %s' % (file, line))
            entries[identity] = reason.strip()
    return entries


def confirmed(host):
    print(WARNING.format(host=host), file=sys.stderr)
    return sys.stdin.readline().strip() == host


def attempt(check, robot, prepare=False):
    """None, or why the promise is not kept."""
    try:
        if prepare:
            robot.prepare()
        check.function(robot)
    except AssertionError as error:
        return str(error) or 'an assertion without a text'
    except Exception as error:  # a broken peer may break a check in any way, and must not end the run
        where = traceback.extract_tb(error.__traceback__)[-1]
        return '%s: %s (%s:%d)' % (type(error).__name__, error, pathlib.Path(where.filename).name, where.lineno)
    finally:
        robot.close()
    return None


def on_simulators(checks, simulator, not_yet, options):

    def run(check):
        begin = time.monotonic()
        try:
            robot = simulator.start(check)
        except AssertionError as error:
            failure = str(error)
        else:
            failure = attempt(check, robot)
        if failure is None:
            outcome = report.UNEXPECTED if check.id in not_yet else report.PASSED
            message = 'delete its line in %s' % options.not_yet.name if check.id in not_yet else ''
        else:
            outcome = report.KNOWN if check.id in not_yet else report.FAILED
            message = not_yet.get(check.id, failure)
            if check.id in not_yet and options.verbose:
                message += ' [%s]' % failure
        return report.Result(check, outcome, message, time.monotonic() - begin)

    without = {option for check in checks for option in simulator.missing(check)}
    if without:
        print('The program has no %s; checks that want them run without.' % ', '.join(sorted(without)))
    with concurrent.futures.ThreadPoolExecutor(max(options.jobs, 1)) as pool:
        return list(pool.map(run, checks))


def on_robot(checks, options):
    addresses = (options.host, options.port), (options.host, options.status_port)
    version = options.tmflow or ask_version(*addresses)
    results = []
    for check in checks:
        reason = why_not(check, version, options)
        if reason:
            results.append(report.Result(check, report.SKIPPED, reason))
            continue
        begin = time.monotonic()
        failure = attempt(check, RealRobot(*addresses, version), prepare=not check.safe)
        bad = report.DIFFERS if check.certainty == suite.CHOICE else report.FAILED
        results.append(report.Result(check, bad if failure else report.PASSED, failure or '', time.monotonic() - begin))
    return results


def ask_version(*addresses):
    robot = RealRobot(*addresses, suite.DEFAULT_VERSION)
    try:
        return robot.value('TMflow_Version')
    except (AssertionError, OSError) as error:
        print('TMflow_Version cannot be read (%s): %s is assumed; --tmflow tells it.' % (error, suite.DEFAULT_VERSION))
        return suite.DEFAULT_VERSION
    finally:
        robot.close()


def why_not(check, version, options):
    """Why the check is not for this robot, or None."""
    if not check.holds_in(version):
        return 'not in TMflow ' + version
    if not check.safe and not options.all:
        return 'not safe; --all runs it'
    needed = sorted(set(check.setup) - {'time_scale'})
    return 'needs a robot that is set up with: ' + ', '.join(needed) if needed else None


def conclude(results, subject, options):
    for result in results:
        if result.outcome in report.BAD + (report.DIFFERS, ) or options.verbose:
            print(result.line())
    print('%s: %s' % (subject, report.summary(results)))
    for file, text in ((options.json, report.as_json), (options.junit, report.as_junit)):
        if file:
            pathlib.Path(file).write_text(text(results, subject), encoding='utf-8')
    return 1 if any(result.outcome in report.BAD for result in results) else 0


if __name__ == '__main__':
    sys.exit(main())
