"""The figure of docs/studies/muscles.md."""

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot

PANELS = {
    "up_r": "right foot / body weight",
    "knee_angle_r": "right knee, rad",
    "ankle_angle_r": "right ankle, rad",
    "sole_r": "right sole, m / s",
}
COLOURS = {1.0: "#000000", 8.0: "#0072b2", 0.125: "#d55e00"}
NAMES = {1.0: "62 kg", 8.0: "496 kg", 0.125: "7.75 kg"}
TITLES = {"rescaled": "contacts transferred", "left": "contacts left behind"}


STYLES = {
    (1.0, "rescaled"): "60",
    (8.0, "rescaled"): "60",
    (0.125, "rescaled"): "60",
    (8.0, "left"): "60",
    (0.125, "left"): "15",
}


def cases_to_draw(rows):
    """The rows of each case at the mesh that the figure has; from the original's solution where there is such a search."""
    result = {}
    for key, mesh in STYLES.items():
        selected = [row for row in rows if (float(row["mass"]), row["contacts"], row["mesh"]) == (*key, mesh)]
        starts = sorted({row["start"] for row in selected}, key=("reference", "half", "original").index)
        result[key] = [row for row in selected if row["start"] == starts[-1]] if starts else None
    return result


def draw(rows, folder):
    """Draws curves of all cases: transferred contacts left, others right, the original in both."""
    folder.mkdir(parents=True, exist_ok=True)
    matplotlib.rcParams.update({"svg.hashsalt": "muscles", "font.size": 8, "path.simplify_threshold": 0.2})
    figure, axes = pyplot.subplots(len(PANELS), 2, figsize=(7.5, 7.2), sharex=True, sharey="row", layout="constrained")
    cases = cases_to_draw(rows)
    for column, kind in zip(axes.T, TITLES):
        column[0].set_title(TITLES[kind])
        column[-1].set_xlabel("time / s, at the size of the original")
        for mass, colour in COLOURS.items():
            found = cases.get((mass, "rescaled" if mass == 1 else kind))
            if found is not None:
                _curves(column, found, colour, NAMES[mass], mass == 1)
    for row, label in zip(axes, PANELS.values()):
        row[0].set_ylabel(label)
    axes[0][0].legend()
    figure.savefig(folder / "walks.svg", metadata={"Date": None})
    pyplot.close(figure)


def _curves(column, rows, colour, name, original):
    times = [float(row["time"]) for row in rows]
    for axis, panel in zip(column, PANELS):
        values = [float(row[panel]) for row in rows]
        axis.plot(
            times, values, "--" if original else "-", color=colour, linewidth=1.8 if original else 1.0, label=name
        )
