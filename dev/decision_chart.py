"""Draws docs/chart.svg, the decision chart, from the list under "What do you have?" in docs/README.md.

    python3 dev/decision_chart.py
"""

import html
import re
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "docs"
HEADING = "## What do you have?"
CASE = re.compile(r"    - (?P<question>.+): `(?P<call>[^`]+)`, \[(?P<page>[^\]]+)\]\(.*\)")

# Places in units of the picture, about a pixel each.
ROW, GAP, TOP = 30, 14, 14
GROUP, QUESTION, CALL, PAGE, WIDTH = 12, 280, 524, 944, 1064
GROUP_WIDTH = 226
STYLE = """
text { font: 14px Arial, Helvetica, 'Liberation Sans', sans-serif; fill: #1b1b1f; dominant-baseline: middle }
.group { font-weight: bold } .call { font: 13px 'Liberation Mono', Consolas, monospace } .page { fill: #0b57a4 }
rect { fill: #eef3fa; stroke: #0b57a4 } path { fill: none; stroke: #74777f }
"""


def cases(text):
    """The groups of the list, each with its questions, calls and pages."""
    groups = []
    for line in text.split(HEADING, 1)[1].split("\n## ", 1)[0].splitlines():
        if line.startswith("- **"):
            groups.append((line.strip("-* "), []))
        elif match := CASE.fullmatch(line):
            groups[-1][1].append(match.groups())
    return groups


def drawn(groups):
    """The chart: a box for each group, and from it a line to each of its questions with what to type."""
    parts, top = [], TOP
    for name, leaves in groups:
        middle = top + ROW * len(leaves) / 2
        parts += [box(GROUP, middle, GROUP_WIDTH), label("group", GROUP + 10, middle, name)]
        for row, leaf in enumerate(leaves):
            parts += one_case(leaf, top + ROW * (row + 0.5), middle)
        top += ROW * len(leaves) + GAP
    height = top + TOP - GAP
    head = f'<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}">'
    return "\n".join([head, "<title>What do you have?</title>", f"<style>{STYLE}</style>",
                      f'<rect width="{WIDTH}" height="{height}" style="fill: #ffffff; stroke: none"/>', *parts, "</svg>\n"])


def one_case(leaf, y, from_y):
    question, call, page = leaf
    start, end = GROUP + GROUP_WIDTH, QUESTION - 6
    half = (start + end) / 2
    return [f'<path d="M{start} {from_y:g} C{half:g} {from_y:g} {half:g} {y:g} {end} {y:g}"/>',
            label("question", QUESTION, y, question), box(CALL, y, PAGE - CALL - 12), label("call", CALL + 8, y, call),
            label("page", PAGE, y, page)]


def box(x, y, width):
    return f'<rect x="{x}" y="{y - 12:g}" width="{width}" height="24" rx="5"/>'


def label(kind, x, y, text):
    return f'<text class="{kind}" x="{x}" y="{y:g}">{html.escape(text)}</text>'


def chart():
    return drawn(cases((DOCS / "README.md").read_text(encoding="utf-8")))


if __name__ == "__main__":
    (DOCS / "chart.svg").write_text(chart(), encoding="utf-8", newline="\n")
