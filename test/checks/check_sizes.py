#!/usr/bin/env python3
"""Fails when a class of src/ or include/ has more methods, or a folder of them more files, than may be. With --largest N it prints the N
largest classes and fullest folders instead.

Methods are the member functions that a class declares, public and private, static ones too; neither constructors, destructors and
operators nor what is deleted or defaulted, nor those of a class within it, which is a class of its own."""
import argparse
import re
import sys

from project import project_root

MOST_METHODS = 35
MOST_FILES = 20
PLACES = ("include/cobot_command", "src")

# What looks like code and is none: comments, texts, characters; and what the preprocessor is told.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])\'|^\s*#(?:\\\n|[^\n])*',
                     re.DOTALL | re.MULTILINE)
CLASS = re.compile(r"(?<!enum )\b(?:class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?(?P<name>\w+(?:::\w+)*)(?:\s*<[^;{}()]*>)?(?:\s+final)?\s*(?::[^;{}()]*)?\{")
ATTRIBUTE = re.compile(r"\[\[.*?\]\]|\b(?:public|private|protected)\s*:")
NO_METHOD = re.compile(r"\s*(?:using|typedef|friend|static_assert|enum|class|struct|union)\b")
CALLED = re.compile(r"(~?\w+)\s*\(")


def code_of(text):
    return NO_CODE.sub(lambda found: '""' if found.group().startswith(('"', "R")) else " ", text)


def end_of(code, start, opening="{", closing="}"):
    """Behind what closes the bracket that is open at `start`."""
    depth = 0
    for at in range(start, len(code)):
        depth += {opening: 1, closing: -1}.get(code[at], 0)
        if depth == 0:
            return at + 1
    return len(code)


def without_angles(text):
    """Templates have brackets in their arguments that are no parameters: std::function<void(int)>."""
    previous = None
    while previous != text:
        previous, text = text, re.sub(r"<[^<>;{}]*>", " ", text)
    return text


def declarations_of(body):
    """What stands directly in the class, each up to its `;` or the body of its function."""
    part, at = "", 0
    while at < len(body):
        if body[at] == "{":
            at = end_of(body, at)
            part += "{}"
            if re.search(r"\)[^=]*\{\}$", part) and not re.match(r"\s*,|\s*\{", body[at:]) or NO_METHOD.match(part):
                yield part
                part = ""
        elif body[at] == ";":
            yield part
            part, at = "", at + 1
        else:
            part += body[at]
            at += 1


def is_method(declaration, name):
    text = without_angles(ATTRIBUTE.sub(" ", declaration))
    text = re.sub(r"^\s*template\b", " ", text)
    if NO_METHOD.match(text) or re.search(r"\boperator\b", text) or re.search(r"=\s*(?:delete|default)\s*$", text):
        return False
    head = re.split(r"=|\{", text, maxsplit=1)[0]  # of a value that is made by a call
    called = CALLED.search(head)
    return bool(called) and called.group(1).lstrip("~") != name and bool(head[:called.start()].strip())


def classes_of(file):
    code = code_of(file.read_text(encoding="utf-8"))
    for found in CLASS.finditer(code):
        body = code[found.end():end_of(code, found.end() - 1) - 1]
        methods = [declaration for declaration in declarations_of(body) if is_method(declaration, found["name"])]
        yield found["name"], len(methods)


def sources(root):
    for place in PLACES:
        yield from (file for file in sorted((root / place).rglob("*")) if file.suffix in (".h", ".cpp"))


def measured(root):
    """Methods by class, files by folder."""
    classes, folders = [], {}
    for file in sources(root):
        classes += [(count, f"{file.relative_to(root)}: {name}") for name, count in classes_of(file)]
        folder = str(file.parent.relative_to(root))
        folders[folder] = folders.get(folder, 0) + 1
    return classes, [(count, folder) for folder, count in folders.items()]


def faults(root):
    classes, folders = measured(root)
    yield from (f"{place} has {count} methods, more than {MOST_METHODS}" for count, place in classes if count > MOST_METHODS)
    yield from (f"{place}/ has {count} files, more than {MOST_FILES}" for count, place in folders if count > MOST_FILES)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("root", type=project_root)
    arguments.add_argument("--largest", type=int, metavar="N")
    given = arguments.parse_args()
    if given.largest:
        for all_of_a_kind in measured(given.root):
            print("\n".join(f"{count:3} {place}" for count, place in sorted(all_of_a_kind, reverse=True)[:given.largest]))
        return 0
    found = list(faults(given.root))
    print("\n".join(found) or "no class and no folder is too large")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
