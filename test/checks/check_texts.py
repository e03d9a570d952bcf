#!/usr/bin/env python3
"""Finds texts that leave a program for people without having gone through common/foreign_text.

Usage: check_texts.py ROOT

What comes from outside (a controller, a client, a file, a goal, a parameter, a URDF) may have any bytes. So every statement
that logs, prints to standard error, or fills a text of a ROS message, answer or diagnostic consists of literals alone, or
passes through one of forPeople(), foreignText(), escaped() and quoted(). Names of states, made by toString(), and numbers
do no harm.
"""

import re
import sys

from project import project_root

# Folder -> what begins a statement with a text for people.
LOG = r"\bROS_(?:DEBUG|INFO|WARN|ERROR|FATAL)(?:_STREAM)?(?:_NAMED|_THROTTLE|_ONCE)*\s*\("
ERROR_OUTPUT = r"std::cerr\s*<<|fmt::print\(\s*stderr|std::fprintf\(\s*stderr"
FIELD = r"\b\w+(?:\.\w+|->\w+)*(?:\.|->)(?:message|error_description|error_string|remedy|diagnosis|text)\s*\+?=(?!=)"
END = r"\.set(?:Aborted|Rejected|Canceled|Succeeded)\s*\("
DIAGNOSTIC = r"\bstatus\.(?:summary|summaryf|mergeSummary)\s*\("
PLACES = {
    "src/ros": [LOG, ERROR_OUTPUT, FIELD, END, DIAGNOSTIC],
    "src/nodes": [LOG, ERROR_OUTPUT],
    "src/tools": [ERROR_OUTPUT],
}
THROUGH = re.compile(r"\b(?:forPeople|foreignText|escaped|quoted|traceText)\s*\(")
# What remains of a statement that has no foreign text in it: literals, numbers, and names of constants.
LITERAL = r'"(?:\\.|[^"\\\n])*"'
HARMLESS = re.compile(rf"{LITERAL}|\bresult_?(?:\.error_description)?\b(?!\.)|\btoString\([^()]*\)|\bk[A-Z]\w*|\b\w*(?:Level|DiagnosticStatus)::\w+|\b\d[\w.]*")


# Of numbers and of our own words alone; what begins with one of these is passed over.
OWN = (
    "response.message = are_claims_wanted_",
    'response.message = fmt::format("after is',
    'response.message = fmt::format("min_severity is',
    "response.message = request.data != 0",
    'response.message = std::string("not offered: ") + capabilities::kNoArm',
    'status.summary(DiagnosticStatus::OK, view.command.queue_depth == 0',
    'status.summary(DiagnosticStatus::OK, fmt::format("{:.0f} frames a second"',
    'ROS_ERROR_STREAM_THROTTLE(10, "position is " << position',
    'fmt::print(stderr, "{} s were not enough',
    'ROS_INFO("simulated controller: listening script=%d status=%d"',
    "result_.remedy = feedback_.done < feedback_.stages",
    "result.remedy = fault->remedy",
    "result_.remedy = fault_->remedy",
    'std::cerr << "tm_frame: DATA has " << data.size()',
    'std::fprintf(stderr, "%s: standard output cannot be written',
    'std::fprintf(stderr, "%s: the answer cannot be written',
)


def without_comments(text):
    return re.sub(rf"({LITERAL})|//[^\n]*|/\*(?:.|\n)*?\*/", lambda m: m.group(1) or re.sub(r"[^\n]", " ", m.group()), text)


def statement_at(code, start):
    depth = 0
    in_text = False
    for i in range(start, len(code)):
        if code[i] == '"' and code[i - 1] != "\\":
            in_text = not in_text
        if in_text:
            continue
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(code[i], 0)
        if depth < 0 or (code[i] == ";" and depth <= 0):
            return code[start:i]
    return code[start:]


def foreign(statement, begin):
    rest = HARMLESS.sub("", statement[len(" ".join(begin.split())):])
    return re.search(r"[A-Za-z_]\w*", rest) is not None


def findings(text, patterns):
    code = without_comments(text)
    for pattern in patterns:
        for match in re.finditer(pattern, code):
            statement = " ".join(statement_at(code, match.start()).split())
            if not THROUGH.search(statement) and foreign(statement, match.group()) and not statement.startswith(OWN):
                yield code.count("\n", 0, match.start()) + 1, statement


def main(root):
    found = []
    for folder, patterns in PLACES.items():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".h"):
                for line, statement in findings(path.read_text(encoding="utf-8"), patterns):
                    found.append(f"{path.relative_to(root)}:{line}: {statement[:150]}")
    for line in found:
        print(line)
    if found:
        print(f"{len(found)} texts for people that do not go through forPeople() (common/foreign_text.h)")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(project_root(sys.argv[1])))
