"""The report of a run, as files in a folder."""
from flight.analysis import analyse
from flight.run import RunError

PICTURE, PAGE = "report.png", "report.html"


def write(run, verdicts, folder):
    """(the Analysis, the files that were written)"""
    analysis = analyse(run, verdicts)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        # Only now: who replays needs no matplotlib.
        from flight import html_page
        from flight.drawing import page
        page.write_picture(analysis, folder / PICTURE)
        (folder / PAGE).write_text(html_page.page_of(analysis), encoding="utf-8")
    except OSError as error:
        raise RunError(f"the report cannot be written into {folder}: {error}; give another folder") from None
    except ImportError as error:
        raise RunError(f"the report cannot be drawn: {error} (Debian: python3-matplotlib)") from None
    return analysis, [folder / PICTURE, folder / PAGE]
