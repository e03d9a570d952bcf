"""What a run found, for people and for programs."""
import json
import xml.etree.ElementTree as ElementTree

PASSED, FAILED, SKIPPED = 'passed', 'failed', 'skipped'
KNOWN = 'not yet'  # fails, as not_yet.txt says
UNEXPECTED = 'unexpectedly passed'  # passes, although not_yet.txt says that it cannot
DIFFERS = 'differs'  # a real robot does not do what the simulator chose
BAD = (FAILED, UNEXPECTED)


class Result:

    def __init__(self, check, outcome, message='', seconds=0.0):
        self.check, self.outcome, self.message, self.seconds = check, outcome, message, seconds

    def line(self):
        return '%-9s %-20s %s%s' % (self.check.id, self.outcome, self.check.promise,
                                    '\n' + ' ' * 10 + self.message if self.message else '')


def summary(results):
    counts = {}
    for result in results:
        counts[result.outcome] = counts.get(result.outcome, 0) + 1
    return ', '.join('%d %s' % (counts[key], key) for key in sorted(counts)) or 'nothing to check'


def as_json(results, subject):
    return json.dumps(
        {
            'subject': subject,
            'results': [{
                'id': result.check.id,
                'promise': result.check.promise,
                'source': result.check.source,
                'certainty': result.check.certainty,
                'version': result.check.version,
                'outcome': result.outcome,
                'message': result.message,
                'seconds': round(result.seconds, 3)
            } for result in results]
        }, indent=1, ensure_ascii=False) + '\n'


def as_junit(results, subject):
    suite = ElementTree.Element(
        'testsuite', {
            'name': 'conformance of ' + subject,
            'tests': str(len(results)),
            'failures': str(sum(result.outcome in BAD for result in results)),
            'skipped': str(sum(result.outcome in (SKIPPED, KNOWN, DIFFERS) for result in results)),
            'time': '%.3f' % sum(result.seconds for result in results)
        })
    for result in results:
        case = ElementTree.SubElement(
            suite, 'testcase', {
                'classname': 'conformance.' + result.check.section,
                'name': '%s %s' % (result.check.id, result.check.promise),
                'time': '%.3f' % result.seconds
            })
        if result.outcome in BAD:
            ElementTree.SubElement(case, 'failure',
                                   {'message': '%s: %s' % (result.outcome, _printable(result.message))})
        elif result.outcome != PASSED:
            ElementTree.SubElement(case, 'skipped',
                                   {'message': '%s: %s' % (result.outcome, _printable(result.message))})
    return ElementTree.tostring(suite, encoding='unicode') + '\n'


def _printable(text):
    return ''.join(letter if letter.isprintable() else '\\x%02x' % ord(letter) for letter in text)


def as_list(checks):
    return ''.join('%-9s %-10s %s%s %s\n' %
                   (check.id, check.certainty, _versions(check), ' safe' if check.safe else '     ', check.promise)
                   for check in checks)


def _versions(check):
    return '%s-%s' % (check.since, check.until or '    ')


SECTIONS = {
    '1.1': 'Grammar of frames',
    '1.2': 'Connection life cycle',
    '1.3': 'TMSCT: scripts',
    '1.4': 'Priority commands',
    '1.5': 'TMSTA: questions',
    '1.6': 'CPERR',
    '2.1': 'Language core',
    '2.2': 'Motion and control',
    '2.3': 'General functions',
    '2.4': 'Parameterised items',
    '2.5': 'Speed, acceleration, blending',
    '2.6': 'Failure codes',
    '3.0': 'TMSVR: the status port',
    '3.1': 'Items',
    '3.2': 'Table of the vendor driver'
}

_INTRODUCTION = """\
# What is checked of the protocol

Made by `test/conformance/run_conformance.py --list --markdown`; a test holds it against the checks. Each check is one
fact of doc/tm-robot.md (sections 1 to 3), seen by a small client in Python that shares no code with this project. The
number in an id is the section. How to run them, also against a real robot: `test/conformance/README.md`.

- **certainty**: *documented*: by a manual, a data sheet or a capture of a real robot. *Derived*: inferred, computed, or
  seen only through what other clients do. *Choice*: the facts end; the simulator chose (`doc/simulator.md`), and a real
  robot that differs is not wrong.
- **source**: M, M84: the manual I848-E-03 for TMflow 1.80 and 1.84, with the chapter. FB: the vendor's function block
  document. DS: data sheet. L: a log or capture of a real robot. D: the vendor's drivers. C, P, T, W: other clients.
  I: our inference. ?: nothing was found.
- **TMflow**: the versions in which the promise holds.
- **robot**: *safe*: also runs on a real robot without being asked for: it moves nothing, stops nothing, leaves no
  Listen node and writes no output.
- **simulator**: *not yet*: `tm_simulator` does not keep the promise yet; why: `test/conformance/not_yet.txt`.
"""


def as_markdown(checks, not_yet):
    text = [
        _INTRODUCTION,
        '%d checks: %s. %d of them not yet.\n' %
        (len(checks), ', '.join('%d %s' % (sum(check.certainty == certainty for check in checks), certainty)
                                for certainty in ('documented', 'derived', 'choice')), len(not_yet))
    ]
    for section, title in SECTIONS.items():
        text.append('\n## %s %s\n' % (section, title))
        text.append('| id | promise | certainty | source | TMflow | robot | simulator |')
        text.append('|---|---|---|---|---|---|---|')
        text += [
            '| %s | %s | %s | %s | %s | %s | %s |' %
            (check.id, _cell(check.promise), check.certainty, _cell(check.source), _range(check),
             'safe' if check.safe else '', 'not yet' if check.id in not_yet else 'kept') for check in checks
            if check.section == section
        ]
    return '\n'.join(text) + '\n'


def _cell(text):
    return text.replace('|', '\\|')


def _range(check):
    if check.since == '1.68':
        return 'to %s' % check.until if check.until else 'all'
    return 'from %s' % check.since if not check.until else '%s to %s' % (check.since, check.until)
