"""The figure of docs/studies/bodies.md."""

import matplotlib
from page import BUILDS, CONTACTS, differences

matplotlib.use("svg")
from matplotlib import pyplot

PANELS = {
    "peak_force_bw": "peak force / original's",
    "depth": "x/R - original's",
    "pressure_m": "pressure too far forward, mm",
}
COLOURS = ("#d55e00", "#e69f00", "#0072b2", "#56b4e9", "#009e73")
TITLES = (
    "left behind",
    "rescaled by mass only",
    "places; radii by foot, α by radius",
    "places; radii by foot, α by mass",
    "places; radii by mass",
)


def draw(rows, folder):
    """Draws each model at each build against its original, which is the line."""
    folder.mkdir(parents=True, exist_ok=True)
    matplotlib.rcParams.update({"svg.hashsalt": "bodies", "font.size": 8})
    figure, axes = pyplot.subplots(
        len(PANELS), len(BUILDS), figsize=(9, 6), sharex=True, sharey="row", layout="constrained"
    )
    for column, build in zip(axes.T, BUILDS):
        column[0].set_title(build)
        for axis, panel in zip(column, PANELS):
            axis.axhline(panel == "peak_force_bw", color="#000000", linewidth=0.8)
            for place, contacts in enumerate(CONTACTS):
                values = [one[panel] for one in differences(rows, build, contacts)]
                axis.plot([place] * len(values), values, "o", markersize=4, alpha=0.6, color=COLOURS[place])
            axis.set_xticks([])
    for row, label in zip(axes, PANELS.values()):
        row[0].set_ylabel(label)
    handles = [pyplot.Line2D([], [], marker="o", linestyle="", color=colour) for colour in COLOURS]
    figure.legend(handles, TITLES, loc="outside lower center", ncols=3)
    figure.savefig(folder / "bodies.svg", metadata={"Date": None})
    pyplot.close(figure)
