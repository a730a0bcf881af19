"""The table of docs/studies/bodies.md, made from `bodies.csv`: `python demonstrations/bodies/page.py` prints it."""

import csv
from pathlib import Path

TABLE = Path(__file__).resolve().parent / "bodies.csv"
BEGIN, END = "<!-- begin bodies -->\n", "<!-- end bodies -->"
# The ways, and what radii and α follow in each.
CONTACTS = {
    "left": "left|–|–",
    "mass": "mass|mass|either",
    "places": "places|foot|radius",
    "places-alpha": "places|foot|mass",
    "places-radii": "places|mass|either",
}
RATIOS = ("peak_force_bw", "time_to_rest_s")
OFFSETS = {"depth": 1, "pressure_m": 1000}
BUILDS = ("similar", "child", "long feet", "short feet")


def read(path):
    """The rows of the table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def differences(rows, build, contacts):
    """For each model at a build, or at all: ratios of peak force and time to rest, differences of depth and pressure (mm)."""
    for row in rows:
        if row["contacts"] == contacts and row["build"] in ((build,) if build != "all" else BUILDS):
            original = next(one for one in rows if (one["model"], one["build"]) == (row["model"], "original"))
            pairs = {name: (float(row[name]), float(original[name])) for name in (*RATIOS, *OFFSETS)}
            ratios = {name: pairs[name][0] / pairs[name][1] for name in RATIOS}
            yield ratios | {name: factor * (pairs[name][0] - pairs[name][1]) for name, factor in OFFSETS.items()}


def block(rows):
    """Each build, and all of them: the range over the models, against each one's original."""
    yield "|build|contacts|radii by|α by|peak force|time to rest|depth off|pressure off (mm)|"
    yield "|---|---|---|---|---|---|---|---|"
    for build in (*BUILDS, "all"):
        for contacts, name in CONTACTS.items():
            found = list(differences(rows, build, contacts))
            cells = [_range([one[what] for one in found]) for what in (*RATIOS, "depth")]
            yield f"|{build}|{name}|{'|'.join([*cells, _range([one['pressure_m'] for one in found], 0)])}|"


def _range(values, digits=2):
    low, high = (f"{round(value, digits) + 0.0:.{digits}f}" for value in (min(values), max(values)))
    return low if low == high else f"{low}..{high}"


def write(path, rows):
    """Writes the table into the page."""
    before, after = path.read_text(encoding="utf-8").split(BEGIN)
    lines = "\n".join(block(rows))
    path.write_text(f"{before}{BEGIN}\n{lines}\n\n{END}{after.split(END)[1]}", encoding="utf-8")


if __name__ == "__main__":
    print("\n".join(block(read(TABLE))))
