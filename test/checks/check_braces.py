#!/usr/bin/env python3
"""Finds bodies of if, else, for and while that stand on a line of their own without braces.

Usage: check_braces.py [--fix] FILE...
With --fix they get them; clang-format then puts the lines right.
"""

import pathlib
import re
import sys

KEYWORD = re.compile(r"\b(if|for|while|else)\b")


def blanked(text):
    """The same text with comments, literals and preprocessor lines as blanks, so that only code is left."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group())

    raw = r'R"(?P<tag>[^()\\\s]{0,16})\((?:.|\n)*?\)(?P=tag)"'
    rest = r'//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*'
    return re.sub(f"{raw}|{rest}", blank, text, flags=re.MULTILINE)


def behind_parentheses(code, start):
    depth = 0
    for i in range(start, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            return i + 1
    raise ValueError("parentheses without an end")


def behind_head(code, match):
    """Where the body of a keyword may begin; nothing where it has none of its own."""
    if match.group() == "else":
        return None if re.match(r"\s+if\b", code[match.end():]) else match.end()
    head = re.compile(r"\s*(constexpr\s*)?\(").match(code, match.end())
    return behind_parentheses(code, head.end() - 1) if head else None


def behind_statement(code, start):
    """The end of the statement that begins there."""
    start = re.compile(r"\s*").match(code, start).end()
    keyword = KEYWORD.match(code, start)
    if keyword:
        if keyword.group() == "else" and re.match(r"\s+if\b", code[keyword.end():]):
            return behind_statement(code, keyword.end())
        end = behind_statement(code, behind_head(code, keyword))
        other = re.compile(r"\s*else\b").match(code, end)
        return behind_statement(code, other.end() - 4) if keyword.group() == "if" and other else end
    depth = 0
    for i in range(start, len(code)):
        depth += {"(": 1, "{": 1, "[": 1, ")": -1, "}": -1, "]": -1}.get(code[i], 0)
        if depth == 0 and (code[i] == ";" or (code[start] == "{" and code[i] == "}")):
            return i + 1
    raise ValueError("a statement without an end")


def bare_bodies(text):
    """Pairs of where a brace has to be put in, and behind what the other one."""
    code = blanked(text)
    for match in KEYWORD.finditer(code):
        head = behind_head(code, match)
        if head is None:
            continue
        body = re.compile(r"\s*").match(code, head).end()
        if "\n" in code[head:body] and code[body] not in "{;":
            yield head, behind_statement(code, body)


def fixed(text):
    inserts = []
    for head, end in bare_bodies(text):
        inserts += [(head, " {"), (end + len(re.match(r"[ \t]*(//[^\n]*)?", text[end:]).group()), "\n}")]
    for place, brace in sorted(inserts, key=lambda insert: insert[0], reverse=True):
        text = text[:place] + brace + text[place:]
    return text


def main():
    fix = "--fix" in sys.argv
    found = 0
    for name in (argument for argument in sys.argv[1:] if argument != "--fix"):
        text = pathlib.Path(name).read_text()
        for head, _ in bare_bodies(text):
            found += 1
            if not fix:
                print(f"{name}:{text.count(chr(10), 0, head) + 1}: the body on the next line has no braces")
        if fix:
            pathlib.Path(name).write_text(fixed(text))
    return 1 if found and not fix else 0


if __name__ == "__main__":
    sys.exit(main())
