"""The tables of `docs/studies/falls.md`, made from `falls.csv` and `slides.csv`.

`python demonstrations/falls/page.py FALLS SLIDES` prints them.
"""

import csv
import sys
from pathlib import Path

from animals import ANIMALS, CONTACTS, REFERENCE
from compare import MEASURES

LAWS = {
    "hunt_crossley": "Hunt–Crossley",
    "smooth": "smooth",
    "smooth_frictionless": "smooth, without friction",
}
MOTIONS = {
    "landing_sideways": "lands sideways",
    "landing_forward": "lands forward",
    "push_sideways": "pushed sideways",
    "push_forward": "pushed forward",
}
CURVES = ("height_apart", "force_apart", "centre_of_mass_apart")
INTEGRATOR = ("height_integrator", "force_integrator", "centre_of_mass_integrator")


def read(path):
    """The rows of the table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def blocks(falls, slides):
    """The tables, in Markdown, under the names of their places in the page."""
    falls, slides = read(falls), read(slides)
    return {"falls": "\n".join([*_apart(falls), "", *_peaks(falls)]), "slides": "\n".join(_slides(slides))}


def _apart(rows):
    yield "|law|joints|contacts|height|force|centre of mass|"
    yield "|---|---|---|---|---|---|"
    for law, law_name in LAWS.items():
        # With joints locked nothing slides: friction makes no difference there.
        for joints in ("free",) if law == "smooth_frictionless" else ("locked", "free"):
            for contacts in CONTACTS:
                selected = [
                    row for row in rows if (row["law"], row["joints"], row["contacts"]) == (law, joints, contacts)
                ]
                others = [row for row in selected if row["animal"] != REFERENCE]
                if others:
                    worst = "|".join(_share([row[curve] for row in others]) for curve in CURVES)
                    yield f"|{law_name}|{joints}|{contacts}|{worst}|"
            selected = [
                row for row in rows if (row["law"], row["joints"], row["contacts"]) == (law, joints, "rescaled")
            ]
            yield f"|{law_name}|{joints}|*integrator*|{'|'.join(_share([row[c] for row in selected]) for c in INTEGRATOR)}|"


def _share(texts):
    """The largest of them; small ones as powers of ten, others in per cent."""
    if not all(texts):
        return ""
    value = max(map(float, texts))
    return f"{value:.0e}" if value < 1e-3 else f"{100 * value:.0f} %"


def _peaks(rows):
    """Largest forces of the Hunt-Crossley law, in body weights."""
    yield f"|animal|M (kg)|L (m)|{'|'.join(f'{joints}, {kind}' for joints in ('locked', 'free') for kind in CONTACTS)}|"
    yield "|---" * (3 + 2 * len(CONTACTS)) + "|"
    by_key = {(row["joints"], row["contacts"], row["animal"]): row for row in rows if row["law"] == "hunt_crossley"}
    for animal in sorted(ANIMALS, key=ANIMALS.get):
        first = by_key["locked", "rescaled", animal]
        cells = [animal.split("_")[0], f"{ANIMALS[animal]:g}", f"{float(first['hip_height_m']):.3f}"]
        for joints in ("locked", "free"):
            for kind in CONTACTS:
                row = by_key.get((joints, "rescaled" if animal == REFERENCE else kind, animal))
                cells.append(f"{float(row['peak_force_bw']):.2f}")
        yield f"|{'|'.join(cells)}|"


def _slides(rows):
    yield "|law|motion|slide / L|along|up|with: most|without: slide (%)|along (%)|up (%)|"
    yield "|---" * 9 + "|"
    for law, motion in dict.fromkeys((row["law"], row["motion"]) for row in rows):
        selected = [row for row in rows if (row["law"], row["motion"]) == (law, motion)]
        theirs = next(row for row in selected if row["animal"] == REFERENCE)
        remaining = [row for row in selected if row["contacts"] == "no_friction"]
        most = max(
            abs(float(row[f"{name}_off"])) for row in selected if row["contacts"] == "rescaled" for name in MEASURES
        )
        cells = [LAWS[law], MOTIONS[motion], f"{float(theirs[MEASURES[0]]):.3f}"]
        cells += [f"{float(theirs[name]):.2f}" for name in MEASURES[1:]]
        cells += [f"{most:.0e}", *(_range([float(row[f"{name}_off"]) for row in remaining]) for name in MEASURES)]
        yield f"|{'|'.join(cells)}|"


def _range(values):
    """A range in per cent."""
    low, high = (f"{round(100 * value):+d}".replace("+0", "0") for value in (min(values), max(values)))
    return low if low == high else f"{low}..{high}"


def write(path, falls, slides):
    """Puts the tables into the page."""
    text = path.read_text(encoding="utf-8")
    for name, block in blocks(falls, slides).items():
        begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
        before, after = text.split(begin)
        text = f"{before}{begin}\n{block}\n\n{end}{after.split(end)[1]}"
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    print(*blocks(*map(Path, sys.argv[1:])).values(), sep="\n\n")
