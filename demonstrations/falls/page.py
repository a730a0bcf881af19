"""The tables of `docs/studies/falls.md`, made from `falls.csv`: `python demonstrations/falls/page.py TABLE` prints them."""

import csv
import sys
from pathlib import Path

from animals import ANIMALS, CONTACTS, REFERENCE

LAWS = {
    "hunt_crossley": "Hunt–Crossley",
    "smooth": "smooth",
    "smooth_frictionless": "smooth, without friction",
}
BEGIN, END = "<!-- begin falls -->\n", "<!-- end falls -->"
CURVES = ("height_apart", "force_apart", "centre_of_mass_apart")
INTEGRATOR = ("height_integrator", "force_integrator", "centre_of_mass_integrator")


def read(path):
    """The rows of the table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def block(rows):
    """Both tables, in Markdown."""
    return "\n".join([*_apart(rows), "", *_peaks(rows)])


def _apart(rows):
    yield "|law|joints|contacts|height|force|centre of mass|"
    yield "|---|---|---|---|---|---|"
    for law, law_name in LAWS.items():
        # With joints locked nothing slides: friction makes no difference there.
        for joints in ("free",) if law == "smooth_frictionless" else ("locked", "free"):
            for contacts in CONTACTS:
                own = [row for row in rows if (row["law"], row["joints"], row["contacts"]) == (law, joints, contacts)]
                others = [row for row in own if row["animal"] != REFERENCE]
                if others:
                    worst = "|".join(_share([row[curve] for row in others]) for curve in CURVES)
                    yield f"|{law_name}|{joints}|{contacts}|{worst}|"
            own = [row for row in rows if (row["law"], row["joints"], row["contacts"]) == (law, joints, "rescaled")]
            yield f"|{law_name}|{joints}|*integrator*|{'|'.join(_share([row[c] for row in own]) for c in INTEGRATOR)}|"


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
    known = {(row["joints"], row["contacts"], row["animal"]): row for row in rows if row["law"] == "hunt_crossley"}
    for animal in sorted(ANIMALS, key=ANIMALS.get):
        first = known["locked", "rescaled", animal]
        cells = [animal.split("_")[0], f"{ANIMALS[animal]:g}", f"{float(first['hip_height_m']):.3f}"]
        for joints in ("locked", "free"):
            for kind in CONTACTS:
                row = known.get((joints, "rescaled" if animal == REFERENCE else kind, animal))
                cells.append(f"{float(row['peak_force_bw']):.2f}")
        yield f"|{'|'.join(cells)}|"


def write(path, rows):
    """Puts the tables into the page."""
    text = path.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    path.write_text(f"{before}{BEGIN}\n{block(rows)}\n\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    print(block(read(Path(sys.argv[1]))))
