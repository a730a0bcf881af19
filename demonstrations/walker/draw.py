"""The figures of `docs/studies/walker.md`, from the tables beside this program."""

import math

import matplotlib
import numpy as np
import osim_contact_scale as ocs
import pandas as pd
from matplotlib import pyplot
from model import ANKLE_HEIGHT, GRAVITY, LEG, RADIUS, SHANK, SIDES, SPHERES, THIGH, TRUNK

MAPS = {
    "effort": ("effort.csv", "effort", "(A) effort per distance"),
    "iterations": ("grid.csv", "iterations", "(B) iterations"),
    "random": ("random_points.csv", "median_iterations", "(C) iterations from random guesses, median"),
}
CURVES = {
    "hip_r_rad": "hip, rad",
    "knee_r_rad": "knee, rad",
    "ankle_r_rad": "ankle, rad",
    "force_r_bw": "force of the right foot / body weight",
}
COLOURS = ("#0072b2", "#000000", "#d55e00")


def draw_all(tables, folder):
    """Draws every figure whose table exists."""
    folder.mkdir(parents=True, exist_ok=True)
    matplotlib.use("svg")
    # Fixed ids and dates, so that equal tables give equal bytes.
    matplotlib.rcParams.update({"svg.hashsalt": "walker", "font.size": 8, "path.simplify_threshold": 0.2})
    for name, (table, column, title) in MAPS.items():
        if (tables / table).exists():
            figure = ocs.plot(
                "sweep",
                table=str(tables / table),
                value_column=column,
                x_column="stiffness",
                y_column="dissipation",
                title=title,
            )
            figure.save(str(folder / f"{name}.svg"), force=True)
    if (tables / "guess.csv").exists():
        _save(_sticks(pd.read_csv(tables / "guess.csv")), folder / "walk.svg")
    if (tables / "sizes_curves.csv").exists():
        _save(_sizes(pd.read_csv(tables / "sizes_curves.csv")), folder / "sizes.svg")


def _save(figure, path):
    figure.savefig(path, metadata={"Date": None})
    pyplot.close(figure)


def _sticks(walk, pictures=6):
    """Draws half a cycle as stick figures, the right leg darker."""
    figure, axis = pyplot.subplots(figsize=(7, 2.6), layout="constrained")
    for number, row in enumerate(np.linspace(0, len(walk) - 1, pictures).round().astype(int)):
        frame = walk.iloc[row]
        # The pictures stand further apart than the walker goes, so that none hides another.
        hip = np.array([frame["forward_m"] + 0.45 * number, frame["up_m"]])
        axis.plot(*zip(hip, hip + TRUNK * _along(frame["tilt_rad"], up=True)), color="#000000", linewidth=2)
        for side, colour in zip(reversed(SIDES), ("#999999", "#0072b2")):
            _leg(axis, hip, frame, side, colour)
    axis.axhline(0, color="#000000", linewidth=0.5)
    axis.set_aspect("equal")
    axis.set_axis_off()
    return figure


def _leg(axis, hip, frame, side, colour):
    thigh = frame["tilt_rad"] + frame[f"hip_{side}_rad"]
    shank = thigh + frame[f"knee_{side}_rad"]
    foot = shank + frame[f"ankle_{side}_rad"]
    knee = hip + THIGH * _along(thigh)
    ankle = knee + SHANK * _along(shank)
    axis.plot(*zip(hip, knee, ankle), color=colour, linewidth=1.5)
    down, forward = _along(foot), np.array([math.cos(foot), math.sin(foot)])
    for place in SPHERES.values():
        centre = ankle + place * forward + (ANKLE_HEIGHT - RADIUS) * down
        axis.add_patch(pyplot.Circle(centre, RADIUS, fill=False, color=colour, linewidth=0.8))
        axis.plot(*zip(ankle, centre), color=colour, linewidth=1)


def _along(angle, up=False):
    """Direction of a segment that hangs down, or stands up, at this angle from the vertical."""
    return np.array([math.sin(angle), -math.cos(angle)]) * (-1 if up else 1)


def _sizes(curves):
    """Joint angles and the force under a foot over time without dimensions: rescaled contacts left, others right."""
    figure, axes = pyplot.subplots(len(CURVES), 2, figsize=(7, 7), sharex=True, sharey="row", layout="constrained")
    lengths = sorted(curves["length"].unique())
    for column, kind in zip(axes.T, ("rescaled", "left")):
        column[0].set_title({"rescaled": "contacts rescaled", "left": "contacts left as they were"}[kind])
        column[-1].set_xlabel("t / √(l/g)")
        for length, colour in zip(lengths, COLOURS):
            chosen = curves[
                (curves["length"] == length) & (curves["contacts"] == ("rescaled" if length == 1 else kind))
            ]
            time = chosen["time_s"] / math.sqrt(LEG * length / GRAVITY)
            for axis, name in zip(column, CURVES):
                axis.plot(
                    time,
                    chosen[name],
                    "--" if length == 1 else "-",
                    color=colour,
                    linewidth=1.6 if length == 1 else 1.0,
                    label=f"length × {length:g}",
                )
    for row, label in zip(axes, CURVES.values()):
        row[0].set_ylabel(label)
    axes[0][-1].legend(fontsize=7)
    return figure
