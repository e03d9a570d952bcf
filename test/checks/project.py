"""The folder that a check looks at."""
import pathlib
import sys


def project_root(folder):
    """The path; ends the check with status 2 if it is not the root of the sources, as a check that finds no file finds no fault."""
    root = pathlib.Path(folder)
    missing = [name for name in ("package.xml", "src", "include", "doc") if not (root / name).exists()]
    if missing:
        print(f"{folder} is not the root of the project: it has no {', '.join(missing)}", file=sys.stderr)
        sys.exit(2)
    return root
