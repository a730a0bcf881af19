"""The tables of docs/studies/muscles.md, from the tables beside this program."""

import numpy as np

ANGLES = ("hip_flexion_r", "knee_angle_r", "ankle_angle_r", "hip_flexion_l", "knee_angle_l", "ankle_angle_l")
NAMES = {"rescaled": "transferred", "left": "left", "no_friction": "no `--friction`"}
MESHES = ("15", "30", "60")
HEAD = ("kg", "contacts", "first search", *(f"cost, {mesh}" for mesh in MESHES), "angles off", "x/R", "sole", "forward")
STARTS = {"tracked": "tracked walk", "half": "coarser mesh", "original": "original, scaled"}
PREDICTED = (
    "kg",
    "contacts",
    "from",
    "mesh",
    "iterations",
    "cost",
    "angles off",
    "half stride",
    "peak",
    "sole",
    "forward",
)


def block(table, curves):
    """Each case: its costs at the meshes, and of the finest one how far the walk is from the original's and where its feet are."""
    yield from _table(HEAD, (_cells(rows, curves) for rows in cases(table).values()))


def predicted(table, curves):
    """Each predicted walk, and how far it is from the original's with the same mesh."""
    return _table(PREDICTED, (_predicted(row, curves) for row in table))


def _predicted(row, curves):
    ours, theirs = (_curves(curves, key) for key in (key_of(row), (1.0, "rescaled", row["mesh"])))
    yield f"{62 * float(row['mass']):g}"
    yield NAMES[row["contacts"]]
    yield STARTS[row["start"]]
    yield row["mesh"]
    yield row["iterations"]
    yield f"{float(row['cost']):.4f}" + ("" if int(row["solved"]) else f", not solved, {float(row['violation']):.0e}")
    yield apart([one for one in ours if one["start"] == row["start"]], theirs)
    yield f"{float(row['half_stride_s']):.3f}"
    yield f"{float(row['peak_force_bw']):.2f}"
    yield f"{1000 * float(row['lowest_sole_m']):.0f}"
    yield f"{100 * float(row['forward_held']):.0f} %"


def _table(head, rows):
    yield f"|{'|'.join(head)}|"
    yield "|---" * len(head) + "|"
    for row in rows:
        yield f"|{'|'.join(row)}|"


def cases(table):
    """Rows of one case together: mass, contacts, and whether it starts from the original's solution."""
    result = {}
    for row in table:
        result.setdefault((float(row["mass"]), row["contacts"], row["start"] == "original"), []).append(row)
    return result


def _cells(rows, curves):
    first, last = rows[0], rows[-1]
    by_mesh = {row["mesh"]: row for row in rows}
    ours, theirs = (_curves(curves, key) for key in (key_of(last), (1.0, "rescaled", last["mesh"])))
    yield f"{62 * float(first['mass']):g}"
    yield NAMES[first["contacts"]] + ", from original" * (first["start"] == "original")
    yield first["iterations"]
    for mesh in MESHES:
        yield _cost(by_mesh[mesh]) if mesh in by_mesh else ""
    yield apart([row for row in ours if row["start"] == last["start"]], theirs)
    yield f"{float(last['deepest_x_over_r']):.2f}"
    yield f"{1000 * float(last['lowest_sole_m']):.0f}"
    yield f"{100 * float(last['forward_held']):.0f} %"


def _cost(row):
    return f"{float(row['cost']):.4f}" if int(row["solved"]) else f"{float(row['cost']):.2f}, not solved"


def key_of(row):
    """Mass, contacts, mesh."""
    return float(row["mass"]), row["contacts"], row["mesh"]


def _curves(curves, key):
    return [row for row in curves if key_of(row) == key]


def apart(ours, theirs):
    """The largest difference of the legs' angles at equal times without dimensions, rad; nothing for the original itself."""
    if not theirs or ours == theirs:
        return ""
    pairs = [[np.array([float(row[name]) for row in each]) for each in (ours, theirs)] for name in ANGLES]
    value = max(float(np.max(np.abs(one - other))) for one, other in pairs)
    return f"{value:.2f}" if value > 0.01 else f"{value:.4f}"


def write(path, table, curves, predictions, theirs):
    """Writes the tables into the page."""
    text = path.read_text(encoding="utf-8")
    for name, lines in (("muscles", block(table, curves)), ("predictions", predicted(predictions, theirs))):
        begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
        before, after = text.split(begin)
        text = "\n".join((f"{before}{begin}", *lines, f"\n{end}{after.split(end)[1]}"))
    path.write_text(text, encoding="utf-8")
