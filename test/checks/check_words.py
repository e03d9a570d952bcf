#!/usr/bin/env python3
"""Finds words in pages, interface files and launch files that readers did not understand, and says what to write in their place.

check_words.py ROOT. CONTRIBUTING.md has the whole table of words; here are those that have no other use in these texts. Code, quoted names and
the changelog are not checked."""
import re
import sys

from project import project_root

# Word -> what to write.
WORDS = {
    r"(?<!mm )behind": "after",
    r"(?<!mm )in front of(?! (?:axis|the shoulder))": "before",
    r"under way": "running, active, in progress",
    r"told": "reported, published, sent",
    r"hears?|heard": "receives, received",
    r"anew": "again",
    r"by and by": "gradually",
    r"many-th": "number",
    r"lifesigns?": "heartbeat",
    r"nobody|somebody|whoever|whomever": "no client, an operator, a node: name who it is",
    r"mend(?:s|ed|ing)?": "fix, correct",
    r"(?:robot|arm|it) stands(?! for)": "is at standstill, has stopped",
    r"stands? (?:in|on) (?:the|a|its|one|this|that) (?:page|file|table|row|list)": "is in",
}
PATTERN = re.compile("|".join(rf"\b(?P<w{number}>{word})\b" for number, word in enumerate(WORDS)), re.IGNORECASE)
CODE = re.compile(r"^```.*?^```$|^(?: {4}|\t).*?$|`[^`\n]*`|\[[^\]]*\]\(|\([^()\s]*\.md[^()\s]*\)|\"[^\"\n]*\"", re.M | re.S)
# Of a page that is made by a program, only what is written by hand.
MADE = re.compile(r"<!-- made by .*", re.S)


def texts_of(root):
    """(file, its prose with the lines where they were)"""
    for page in sorted([root / "README.md", *(root / "doc").rglob("*.md")]):
        if page.is_file():
            yield page, MADE.sub("", without(CODE, page.read_text(encoding="utf-8")))
    for file in sorted(file for kind in ("action", "msg", "srv") for file in (root / kind).glob(f"*.{kind}")):
        lines = file.read_text(encoding="utf-8").split("\n")
        yield file, "\n".join(line.partition("#")[2] for line in lines)
    for file in sorted((root / "launch").glob("*.*ml")) + sorted((root / "launch").glob("*.launch")):
        text = file.read_text(encoding="utf-8")
        said = re.compile(r'doc="[^"]*"|<!--.*?-->', re.S)
        yield file, only(said, text)


def without(pattern, text):
    return pattern.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def only(pattern, text):
    kept, end = [], 0
    for found in pattern.finditer(text):
        kept.append(re.sub(r"[^\n]", " ", text[end:found.start()]) + found[0])
        end = found.end()
    return "".join(kept)


def faults(root):
    instead = list(WORDS.values())
    for file, text in texts_of(root):
        for found in PATTERN.finditer(text):
            line = text.count("\n", 0, found.start()) + 1
            yield f"{file.relative_to(root)}:{line}: \"{found[0]}\": write {instead[int(found.lastgroup[1:])]}"


def main():
    found = list(faults(project_root(sys.argv[1])))
    print("\n".join(found) or "no word that readers did not understand")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
