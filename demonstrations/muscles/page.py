"""The table of docs/studies/muscles.md, from the tables beside this program."""

import numpy as np

BEGIN, END = "<!-- begin muscles -->\n", "<!-- end muscles -->"
ANGLES = ("hip_flexion_r", "knee_angle_r", "ankle_angle_r", "hip_flexion_l", "knee_angle_l", "ankle_angle_l")
FORCES = ("up_r", "up_l")
NAMES = {"rescaled": "transferred", "left": "left", "no_friction": "no friction"}
HEAD = ("mass (kg)", "contacts", "mesh", "solved after", "cost", "peak force", "angles off", "force off")
HEAD += ("deepest x/R", "lowest sole (mm)", "forward")


def block(table, curves):
    """Each search: what the solver did, how far its walk is from the original's, and where its feet are."""
    yield f"| {' | '.join(HEAD)} |"
    yield "|---" * len(HEAD) + "|"
    for row in table:
        ours, theirs = (_curves(curves, key) for key in (key_of(row), (1.0, "rescaled", row["mesh"])))
        solved = row["iterations"] if int(row["solved"]) else f"no ({row['iterations']})"
        cells = [f"{62 * float(row['mass']):g}", NAMES[row["contacts"]], row["mesh"], solved]
        cells += [f"{float(row['cost']):.4f}", f"{float(row['peak_force_bw']):.3f}"]
        cells += [apart(ours, theirs, ANGLES), apart(ours, theirs, FORCES)]
        cells += [f"{float(row['deepest_x_over_r']):.2f}", f"{1000 * float(row['lowest_sole_m']):.0f}"]
        yield f"| {' | '.join(cells)} | {100 * float(row['forward_held']):.0f} % |"


def key_of(row):
    """What a search is called: mass, contacts, mesh."""
    return float(row["mass"]), row["contacts"], row["mesh"]


def _curves(curves, key):
    return [row for row in curves if key_of(row) == key]


def apart(ours, theirs, names):
    """The largest difference of these curves at equal times without dimensions; nothing for the original itself."""
    if not theirs or ours == theirs:
        return ""
    pairs = [[np.array([float(row[name]) for row in each]) for each in (ours, theirs)] for name in names]
    value = max(float(np.max(np.abs(one - other))) for one, other in pairs)
    return f"{value:.0e}" if value < 1e-3 else f"{value:.2f}"


def write(path, table, curves):
    """Put the table into the page."""
    before, rest = path.read_text(encoding="utf-8").split(BEGIN)
    lines = "\n".join(block(table, curves))
    path.write_text(f"{before}{BEGIN}\n{lines}\n\n{END}{rest.split(END)[1]}", encoding="utf-8")
