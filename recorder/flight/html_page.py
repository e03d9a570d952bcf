"""The report as one HTML file that needs nothing beside it: pictures and tables."""
import base64
import html

from flight import commands
from flight.analysis import kind_of, outcome_of
from flight.drawing import page, style, tables
from flight.drawing.times import label, later

MOST_FRAMES = 3000  # rows; a browser shows more, but slowly
MOST_LETTERS = 400  # of a frame
CSS = f"""
body {{ font: 14px/1.45 "DejaVu Sans", Verdana, sans-serif; color: {style.INK}; background: {style.PAPER} }}
body {{ margin: 2em auto; max-width: 1400px; padding: 0 1.5em }}
h1 {{ margin-bottom: 0 }} h2 {{ margin-top: 2em; font-size: 1.15em }} p.facts {{ color: #6b7885; margin-top: .3em }}
img {{ width: 100%; height: auto }}
.pill {{ display: inline-block; color: white; border-radius: 5px; padding: .2em .7em; margin-right: .8em; font-weight: bold }}
table {{ border-collapse: collapse; width: 100% }} th {{ text-align: left; color: #6b7885; font-weight: normal }}
td, th {{ border-bottom: 1px solid {style.FAINT}; padding: .25em .7em .25em 0; vertical-align: top }}
td.n {{ text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums }}
td.code {{ font-family: "DejaVu Sans Mono", monospace; font-size: .85em; word-break: break-all }}
li {{ margin: .2em 0 }}
"""


def page_of(analysis):
    """The text of the file."""
    parts = [head(analysis), *findings(analysis)]
    for title, picture in page.single_pictures(analysis):
        data = base64.b64encode(picture.encode()).decode()
        parts.append(f'<h2>{escaped(title)}</h2><img alt="{escaped(title)}" src="data:image/svg+xml;base64,{data}">')
    parts += [goal_table(analysis), command_table(analysis), joint_table(analysis), tag_table(analysis), event_table(analysis),
              frame_table(analysis)]
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Flight report of {escaped(analysis.title)}</title>'
            f"<style>{CSS}</style></head><body>\n" + "\n".join(part for part in parts if part) + "\n</body></html>\n")


def head(analysis):
    pills = "".join(f'<span class="pill" style="background:{colour}">{escaped(words)}</span>' for words, colour in tables.verdict_words(analysis))
    file = f"recorded in {analysis.run.file}"
    return (f"<h1>Flight report of {escaped(analysis.title)}</h1><p class=facts>{escaped(' · '.join([*tables.facts(analysis), file]))}</p>"
            f"<p>{pills}</p>")


def findings(analysis):
    """What is missing, what the replays have found otherwise, and what else is worth a look."""
    if analysis.faults:
        yield "<h2>Missing in the recording</h2>" + items(analysis.faults)
    for verdict in analysis.verdicts:
        if verdict.differences:
            rows = [(seconds(d.time), d.what, code(d.recorded), code(d.came)) for d in verdict.differences]
            yield table(f"Replay: differences ({verdict.name})", ("time", "what", "recorded", "received"), rows)
    if analysis.remarks:
        yield "<h2>Remarks</h2>" + items(analysis.remarks)


def goal_table(analysis):
    rows = []
    for goal in analysis.run.goals:
        outcome = outcome_of(goal)
        number, words = commands.error_of(goal)
        rows.append((seconds(goal.begun), goal.action, commands.target_of(goal),
                     Markup(f'<td><b style="color:{style.KINDS[kind_of(goal)]}">{escaped(outcome)}</b></td>'), number, words,
                     seconds(goal.end.time - goal.begun) if goal.end else "", str(len(goal.feedback))))
    return table("Goals", ("begun", "action", "goal", "outcome", "error", "message", "ended after", "feedbacks"), rows)


def command_table(analysis):
    rows = [(label(row) if not row.part_of else f"– {label(row)}", seconds(row.planned), seconds(row.actual), later(row),
             f"{100 * row.later / row.planned:+.1f} %") for row in analysis.commands]
    return table("Planned and actual time", ("command", "planned", "actual", "later by", "of the plan"), rows)


def joint_table(analysis):
    rows = []
    for use in analysis.uses:
        limits = (f"{use.axis.lower:g}° to {use.axis.upper:g}°", f"{use.margin:.1f}°", f"{use.axis.rated_speed:g}°/s",
                  f"{use.share:.1f} %") if use.axis else ("", "", "", "")
        rows.append((use.name, f"{use.least:.2f}° to {use.most:.2f}°", limits[0], limits[1], f"{use.fastest:.1f}°/s", limits[2], limits[3]))
    return table("Joints", ("joint", "went", "limits", "left", "fastest", "rated", "share"), rows)


def tag_table(analysis):
    rows = [(str(tag.number), tag.script, tag.motion, seconds(tag.sent), "" if tag.accepted is None else seconds(tag.accepted),
             "" if tag.end is None else seconds(tag.end), tag.outcome)
            for tag in analysis.tags]
    return table("Queue tags", ("tag", "script", "motion", "sent", "accepted", "ended", ""), rows)


def event_table(analysis):
    return table("Messages", ("time", "severity", "text"), [(seconds(e.time), str(e.severity), e.text) for e in analysis.run.events])


def frame_table(analysis):
    frames = analysis.run.frames
    rows = [(seconds(frame.time), "→" if frame.sent else "←", frame.meaning, code(style.shortened(frame.text, MOST_LETTERS)))
            for frame in frames[:MOST_FRAMES]]
    more = f", the first {MOST_FRAMES}" if len(frames) > MOST_FRAMES else ""
    return f"<details><summary><b>Frames ({len(frames)}{more})</b></summary>{table('', ('time', '', 'meaning', 'text'), rows)}</details>"


class Markup(str):
    """A cell that is HTML already."""


def code(text):
    return Markup(f'<td class="code">{escaped(text)}</td>')


def table(title, names, rows):
    """Nothing without rows."""
    if not rows:
        return ""
    titled = f"<h2>{escaped(title)}</h2>" if title else ""
    head_row = "".join(f"<th>{escaped(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(cell(value) for value in row) + "</tr>\n" for row in rows)
    return f"{titled}<table><tr>{head_row}</tr>\n{body}</table>"


def cell(value):
    if isinstance(value, Markup):
        return value
    is_number = value[:1] in "+-±0123456789" and value.endswith((" s", " ms", "%"))
    return f'<td{" class=n" if is_number else ""}>{escaped(value)}</td>'


def items(sentences):
    return "<ul>" + "".join(f"<li>{escaped(sentence)}</li>" for sentence in sentences) + "</ul>"


def seconds(value):
    return f"{value:.3f} s"


def escaped(text):
    return html.escape(str(text))
