"""The figure of docs/studies/bodies.md."""

import matplotlib
from page import BUILDS, CONTACTS, MODELS

matplotlib.use("svg")
from matplotlib import pyplot

PANELS = {
    "peak_force_bw": "peak force / body weight",
    "depth": "x/R of the deepest sphere",
    "pressure_m": "pressure before the ankle, m / foot",
}
COLOURS = {"left": "#d55e00", "mass": "#e69f00", "places": "#0072b2"}
TITLES = {"left": "left behind", "mass": "rescaled by mass only", "places": "transferred with places"}


def draw(rows, folder):
    """Draws the numbers of each model for each build, and those of its original as a line."""
    folder.mkdir(parents=True, exist_ok=True)
    matplotlib.rcParams.update({"svg.hashsalt": "bodies", "font.size": 8})
    figure, axes = pyplot.subplots(
        len(PANELS), len(MODELS), figsize=(9, 6), sharex=True, sharey="row", layout="constrained"
    )
    for column, (model, name) in zip(axes.T, MODELS.items()):
        column[0].set_title(name)
        selected = [row for row in rows if row["model"] == model]
        for axis, panel in zip(column, PANELS):
            _points(axis, selected, panel)
        column[-1].tick_params(axis="x", rotation=45)
    for row, label in zip(axes, PANELS.values()):
        row[0].set_ylabel(label)
    axes[0][0].legend(fontsize=7)
    figure.savefig(folder / "bodies.svg", metadata={"Date": None})
    pyplot.close(figure)


def _points(axis, rows, panel):
    by_key = {(row["build"], row["contacts"]): float(row[panel]) for row in rows}
    axis.axhline(by_key["original", "left"], color="#000000", linewidth=0.8)
    for place, contacts in enumerate(CONTACTS):
        across = [index + 0.2 * (place - 1) for index in range(len(BUILDS))]
        values = [by_key[build, contacts] for build in BUILDS]
        axis.plot(across, values, "o", markersize=4, color=COLOURS[contacts], label=TITLES[contacts])
    axis.set_xticks(range(len(BUILDS)), BUILDS)
