"""Draws docs/pictures/measured-*.svg: the measured trial of docs/motion.md.

    python3 dev/motion_pictures.py PROGRAM TRIALS

TRIALS has the folder subject01_walk_id with subject01.osim, subject01_walk1_ik.mot, subject01_walk1_grf.mot and subject01_walk1_grf.xml
from Applications/ID/tests/resources of opensim-org/opensim-core (Apache-2.0). Nothing is drawn where curves have other errors than the
program prints. Needs what tests/oracle/requirements.txt lists.
"""

import io
import itertools
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy as np
import pandas as pd
from matplotlib import pyplot

PICTURES = Path(__file__).resolve().parent.parent / "docs" / "pictures"
SIDES = {"r": "right foot", "l": "left foot"}
PLATES = {"color": "#aaaaaa", "linewidth": 3.2, "linestyle": "-", "label": "plates"}
BEFORE = {"color": "#d55e00", "linewidth": 1.1, "linestyle": (0, (3, 1)), "label": "contacts before"}
AFTER = {"color": "#0072b2", "linewidth": 1.3, "linestyle": "-", "label": "contacts after the correction"}
SPHERES = {"s1": "heel", "s3": "ball, outside", "s5": "toes, inside", "s6": "toes, outside"}
ANGLES = ("hip_flexion", "knee_angle", "ankle_angle", "subtalar_angle", "mtp_angle", "hip_rotation", "hip_adduction")
COLOURS = ("#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#e69f00")
DASHES = ("-", "-", "--", "-.", "-", "--", "-.")


class Foot:
    """A foot along a motion: places of its spheres, their forces and where these act, by frame, sphere and direction."""

    def __init__(self, rows, side):
        rows = rows[rows["sphere"].str.endswith(f"_{side}")]
        self.names = list(rows["sphere"].unique())
        self.on_heel = rows["body"].str.startswith("calcn").to_numpy()[: len(self.names)]
        self.centres, self.forces, self.places = (
            rows[[name.format(axis) for axis in "xyz"]].to_numpy().reshape(-1, len(self.names), 3)
            for name in ("centre_{}_m", "force_{}_n", "point_{}_m")
        )


class Trial:
    """What the program says of the trial: dictionaries of feet have sides as keys."""

    def __init__(self, program, folder):
        def run(*words):
            return subprocess.run([program, *words, "--quiet"], cwd=folder, stdout=subprocess.PIPE, check=True, text=True).stdout

        def feet(motion, *plates):
            rows = pd.read_csv(io.StringIO(run("motion", "feet.osim", motion, *plates, "--format", "csv")))
            return {side: Foot(rows, side) for side in SIDES}

        run("add", "subject01.osim", "--from", "falisse2022", "-o", "feet.osim")
        plates = ("--plates", "subject01_walk1_grf.mot", "--loads", "subject01_walk1_grf.xml")
        call = ("feet.osim", "subject01_walk1_ik.mot", *plates, "--correct", "corrected.sto", "--format", "json")
        answer = json.loads(run("motion", *call))
        self.weight, self.result = answer["weight_n"], answer["consistency"]
        spheres = json.loads(run("inspect", "feet.osim", "--format", "json"))["spheres"]
        self.radii = {each["name"]: each["radius_m"] for each in spheres}
        raw, corrected, plates = map(table, (folder / "subject01_walk1_ik.mot", folder / "corrected.sto", folder / "corrected.plates.sto"))
        self.time, self.turns = corrected["time"], np.degrees(corrected) - raw
        self.root = corrected["pelvis_ty"] - raw["pelvis_ty"] + self.result["floor_up_m"]
        # On a treadmill the corrected root moves against the belt: so does it here before the correction.
        raw[["pelvis_tx", "pelvis_tz"]] = corrected[["pelvis_tx", "pelvis_tz"]]
        for name, motion in (("uncorrected.mot", raw), ("flat.mot", raw[["time", "pelvis_tx"]])):
            (folder / name).write_text("inDegrees=yes\nendheader\n" + motion.to_csv(sep="\t", index=False), encoding="utf-8")
        moved = ("--plates", "corrected.plates.sto", "--loads", "corrected.plates.xml")
        self.before, self.after = feet("uncorrected.mot", *moved), feet("corrected.sto", *moved)
        # Without columns of their own, angles are those of the default pose, 0: the soles are flat.
        self.soles = {side: flat(foot.centres[0] - foot.centres[0, 0]) for side, foot in feet("flat.mot").items()}
        self.plates, self.plate_places = (
            {side: plates[[f"ground_force_calcn_{side}_{what}{axis}" for axis in "xyz"]].to_numpy() for side in SIDES} for what in "vp"
        )
        self.stance = {side: plate[:, 1] > 0.05 * self.weight for side, plate in self.plates.items()}

    def lifts(self, side):
        """How far the spheres move up while they carry the foot, without the floor's correction, in m."""
        up = self.after[side].centres[:, :, 1] - self.before[side].centres[:, :, 1] + self.result["floor_up_m"]
        loaded = self.stance[side][:, None] & (self.after[side].forces[:, :, 1] > 0.02 * self.weight)
        return np.where(loaded, up, np.nan)

    def on_sole(self, foot, side):
        """Centres of pressure of contacts and plates on the flat sole, where both carry 5 % of the weight: x + iz from the heel sphere.

        They are as far from each other as along the floor; both follow the mean of the spheres, each with its share of the force.
        """
        up = foot.forces[:, :, 1]
        share, sole = up / up.sum(1, keepdims=True), self.soles[side]
        level, hind = flat(foot.centres), foot.on_heel
        heading = ((level - level[:, hind].mean(1, keepdims=True))[:, hind] * np.conj(sole[hind] - sole[hind].mean())).sum(1)
        loaded = self.stance[side] & (up.sum(1) > 0.05 * self.weight)
        for forces, places in ((foot.forces, foot.places), (self.plates[side][:, None], self.plate_places[side][:, None])):
            moment = forces[:, :, 1] * flat(places) - flat(forces) * places[:, :, 1]
            centre = np.divide(moment.sum(1), forces[:, :, 1].sum(1), where=loaded, out=np.full(len(loaded), np.nan + 0j))
            yield share @ sole + (centre - (share * level).sum(1)) * np.conj(heading) / abs(heading)

    def check(self):
        """Ends the script where curves have other errors than the program prints."""
        pairs, rms = [], lambda values: np.sqrt(np.nanmean(np.abs(values) ** 2))
        for (number, side), when in itertools.product(enumerate(SIDES), ("before", "after")):
            error = (getattr(self, when)[side].forces.sum(1) - self.plates[side]) / self.weight
            for name, part in (("vertical", error[:, 1]), ("horizontal", flat(error))):
                pairs.append((rms(part), self.result[f"{name}_rms_bw"][number][when]))
        lifts = np.concatenate([self.lifts(side).ravel() for side in SIDES])
        pairs += [(rms(lifts), self.result["lift_rms_m"]), (np.nanpercentile(abs(lifts), 95), self.result["lift_p95_m"])]
        pairs.append((max(rms(np.subtract(*self.on_sole(self.after[side], side))) for side in SIDES), self.result["cop_rms_m"]))
        if not np.allclose(*zip(*pairs), rtol=0, atol=1e-6):
            sys.exit(f"errors of the curves, and those that the program prints: {pairs}")


def table(path):
    return pd.read_csv(io.StringIO(path.read_text(encoding="utf-8").split("endheader")[1]), sep=r"\s+")


def flat(vectors):
    """Vectors along the floor as x + iz."""
    return vectors[..., 0] + 1j * vectors[..., 2]


def with_legend(figure, axis):
    figure.legend(*axis.get_legend_handles_labels(), loc="outside upper center", ncols=3, frameon=False)
    return figure


def draw_forces(trial):
    figure, axes = pyplot.subplots(3, 2, figsize=(7.2, 5.2), sharex=True, sharey="row", layout="constrained")
    for column, (side, name) in zip(axes.T, SIDES.items()):
        column[0].set_title(name)
        column[-1].set_xlabel("time, s")
        curves = (trial.plates[side], PLATES), (trial.before[side].forces.sum(1), BEFORE), (trial.after[side].forces.sum(1), AFTER)
        for (direction, axis), (curve, style) in itertools.product(enumerate(column), curves):
            axis.plot(trial.time, curve[:, direction] / trial.weight, **style)
    for axis, direction in zip(axes[:, 0], ("forward", "up", "to the right")):
        axis.set_ylabel(f"{direction},\nbody weights", linespacing=1.5)
    figure.align_ylabels()
    return with_legend(figure, axes[0, 0])


def draw_correction(trial):
    side = "l"
    figure, axes = pyplot.subplots(2, 1, figsize=(7.2, 4.8), sharex=True, layout="constrained")
    axes[0].plot(trial.time, 1000 * trial.root, label="root")
    for name, move in zip(trial.after[side].names, 1000 * trial.lifts(side).T):
        if name[:2] in SPHERES:
            axes[0].plot(trial.time, move, label=SPHERES[name[:2]])
    for name in ANGLES:
        axes[1].plot(trial.time, trial.turns[f"{name}_{side}"], label=name.removesuffix("_angle").replace("_", " ").replace("mtp", "toes"))
    starts = np.flatnonzero(np.diff(trial.stance[side], prepend=False, append=False)).reshape(-1, 2)
    for axis, label, title in zip(axes, ("move up, mm", "turn, degrees"), ("root, left foot", "left leg")):
        for start, end in starts:
            axis.axvspan(trial.time[start], trial.time[end - 1], color="#eeeeee", linewidth=0)
        axis.set_ylabel(label)
        axis.yaxis.set_major_locator(matplotlib.ticker.MultipleLocator(5))
        axis.legend(title=title, alignment="left", loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    axes[1].set_xlabel("time, s (grey: the left foot stands)")
    return figure


def draw_sole(trial):
    figure, axes = pyplot.subplots(1, 2, figsize=(7.2, 2.6), sharex=True, sharey=True, layout="constrained")
    for axis, (side, title) in zip(axes, SIDES.items()):
        for name, place in zip(trial.after[side].names, 1000 * trial.soles[side]):
            axis.add_patch(pyplot.Circle((place.real, place.imag), 1000 * trial.radii[name], fill=False, color="#666666"))
        before, (after, plates) = next(trial.on_sole(trial.before[side], side)), trial.on_sole(trial.after[side], side)
        for path, style in ((plates, PLATES), (before, BEFORE), (after, AFTER)):
            axis.plot(1000 * path.real, 1000 * path.imag, **style)
        axis.set_aspect("equal")
        axis.set_title(f"{title} from below")
        axis.set_xlabel("forward, mm")
    axes[0].set_ylabel("to the right, mm")
    return with_legend(figure, axes[0])


def main(program, trials):
    # Fixed ids and no date, so that equal numbers give equal bytes.
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "motion", "svg.fonttype": "none", "font.size": 9, "path.simplify_threshold": 0.4})
    matplotlib.rcParams["axes.prop_cycle"] = matplotlib.cycler(color=COLOURS, linestyle=DASHES)
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(Path(trials) / "subject01_walk_id", folder, dirs_exist_ok=True)
        trial = Trial(str(Path(program).resolve()), Path(folder))
    trial.check()
    for name, draw in (("forces", draw_forces), ("correction", draw_correction), ("pressure", draw_sole)):
        drawn = io.StringIO()
        draw(trial).savefig(drawn, metadata={"Date": None, "Creator": None})
        # A tenth of a point is enough.
        text = re.sub(r"\d+\.\d{2,}", lambda number: f"{float(number[0]):.1f}", drawn.getvalue())
        (PICTURES / f"measured-{name}.svg").write_text(re.sub(r" +\n", "\n", text), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
