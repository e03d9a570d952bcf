#!/usr/bin/env python3
"""Fails when a picture of the pages is not made by scripts/pictures, is not shown on any page, or is too large."""
import pathlib
import re
import subprocess
import sys

SHOWN = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")
MOST_BYTES = 1 << 20


def made_by(root):
    listed = subprocess.run(["bash", str(root / "scripts" / "pictures"), "--list"], capture_output=True, text=True, check=True)
    return set(listed.stdout.split())


def shown_on(root):
    for page in [root / "README.md", *(root / "doc").rglob("*.md")]:
        for target in SHOWN.findall(page.read_text(encoding="utf-8")):
            yield page, (page.parent / target).resolve()


def faults(root, made):
    root = root.resolve()
    folder = root / "doc" / "images"
    shown = list(shown_on(root))
    for page, picture in shown:
        if not picture.is_file():
            yield f"{page}: there is no {picture}"
    for picture in sorted(folder.iterdir()):
        if picture.name not in made:
            yield f"{picture} is not made by scripts/pictures: nobody will make it anew when what it shows has changed"
        if picture not in {target for _, target in shown}:
            yield f"{picture} is on no page: remove it"
        if picture.stat().st_size > MOST_BYTES:
            yield f"{picture} has {picture.stat().st_size} bytes, at most {MOST_BYTES} are allowed: make it smaller"
    for name in sorted(made - {picture.name for picture in folder.iterdir()}):
        yield f"{folder} has no {name}: run scripts/pictures"


def main():
    root = pathlib.Path(sys.argv[1])
    found = list(faults(root, made_by(root)))
    for fault in found:
        print(fault)
    if not found:
        print("every picture is made by scripts/pictures, shown, and small")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
