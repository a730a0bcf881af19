"""The table of docs/studies/bodies.md, made from `bodies.csv`: `python demonstrations/bodies/page.py` prints it."""

import csv
from pathlib import Path

TABLE = Path(__file__).resolve().parent / "bodies.csv"
BEGIN, END = "<!-- begin bodies -->\n", "<!-- end bodies -->"
MODELS = {
    "v40000_moco_2d_gait.osim": "Moco 2-D",
    "v40000_falisse_2022_human.osim": "Falisse",
    "v40000_dhondt_2024_3seg_human.osim": "D'Hondt",
    "v40000_opencap_lai_arnold_crlf.osim": "OpenCap",
}
CONTACTS = {"left": "left", "mass": "mass", "places": "places"}
RATIOS = ("peak_force_bw", "time_to_rest_s")
BUILDS = ("similar", "child", "long feet", "short feet")


def read(path):
    """The rows of the table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def block(rows):
    """Each build: the range over the models, against each one's original."""
    yield "|build|contacts|peak force|time to rest|depth off|pressure off (mm)|"
    yield "|---|---|---|---|---|---|"
    for build in BUILDS:
        for contacts, name in CONTACTS.items():
            selected = [row for row in rows if (row["build"], row["contacts"]) == (build, contacts)]
            pairs = [(row, _original(rows, row["model"])) for row in selected]
            cells = [_range([float(ours[what]) / float(theirs[what]) for ours, theirs in pairs]) for what in RATIOS]
            cells.append(_range([float(ours["depth"]) - float(theirs["depth"]) for ours, theirs in pairs]))
            off = [1000 * (float(ours["pressure_m"]) - float(theirs["pressure_m"])) for ours, theirs in pairs]
            yield f"|{build}|{name}|{'|'.join([*cells, _range(off, 0)])}|"


def _original(rows, model):
    return next(row for row in rows if (row["model"], row["build"]) == (model, "original"))


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
