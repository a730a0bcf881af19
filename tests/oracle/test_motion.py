"""Spheres and contact forces along motions: the command's rows against the real OpenSim in the same states."""

import csv
import io
import itertools
import os
import random
import re
import subprocess
from pathlib import Path

import command
import numpy as np
import opensim_motion
import pytest
from models import CORPUS, corpus, fixtures, label

LENGTH = 1e-9  # m, m/s
SHARE = 1e-9  # of the largest force (or torque) of the motion
FRAMES = 24
ROTATIONAL, TRANSLATIONAL = 1, 2  # OpenSim's motion types

MODES = ("given", "splined", "rest")


# What `motion` has nothing to say of: no contact acts, or nothing weighs anything.
REFUSED = ("no applied force presses a sphere on the ground", "a moving sphere meets a half-space", "has no gravity")


def rows(model, motion, *more):
    arguments = ["motion", str(model), str(motion), "--format", "csv", "--select", "*", *more]
    process = subprocess.run([str(command.BINARY), *arguments], capture_output=True, timeout=60)
    output = process.stderr.decode("utf-8", "replace")
    if process.returncode and any(reason in output for reason in REFUSED):
        return None
    assert process.returncode == 0, output
    return list(csv.DictReader(io.StringIO(process.stdout.decode("utf-8"))))


def smooth(coordinates, seed):
    """Times, and values and speeds of all coordinates: sines around the defaults."""
    chance = random.Random(seed)
    times = [frame / 50 for frame in range(FRAMES)]
    values, speeds = {}, {}
    for name, default, kind in coordinates:
        size = 0.4 if kind == ROTATIONAL else 0.03
        rate, phase = chance.uniform(2, 12), chance.uniform(0, 6)
        values[name] = [default + size * np.sin(rate * time + phase) for time in times]
        speeds[name] = [chance.uniform(-2, 2) * np.cos(rate * time) for time in times]
    return times, values, speeds


def storage(path, times, values, speeds):
    """A `.sto` of values, with speeds where they are given."""
    names = list(values)
    columns = {f"/jointset/{name}/value": values[name] for name in names}
    if speeds is not None:
        columns |= {f"/jointset/{name}/speed": speeds[name] for name in names}
    lines = ["motion", "version=1", "inDegrees=no", "endheader", "\t".join(["time", *columns])]
    for frame, time in enumerate(times):
        lines.append("\t".join(repr(float(value)) for value in (time, *(column[frame] for column in columns.values()))))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def vector(row, name):
    unit = {"centre": "_m", "velocity": "_m_s", "force": "_n", "point": "_m"}[name]
    return np.array([float(row[f"{name}_{axis}{unit}"]) for axis in "xyz"])


def compared(ours, theirs, times):
    """How many forces agree, after all places and velocities did."""
    by_time = {}
    for row in ours:
        by_time.setdefault(row["time_s"], []).append(row)
    assert len(by_time) == len(times)
    records = [one for frame in theirs for force in frame["forces"].values() for one in force.values()]
    largest = max((abs(value) for record in records for value in record[:3]), default=1.0)
    count = 0
    for own, frame in zip(by_time.values(), theirs, strict=True):
        on_bodies = {}
        for row in own:
            place, speed = frame["spheres"][row["sphere"]]
            assert np.allclose(vector(row, "centre"), place, rtol=0, atol=LENGTH), (row, place)
            assert np.allclose(vector(row, "velocity"), speed, rtol=0, atol=LENGTH), (row, speed)
            if row["applies"] == "true":
                on_bodies.setdefault(row["force"], []).append((row, wrench(row, frame["origins"])))
        for force, pairs in on_bodies.items():
            count += agrees(pairs, frame["forces"][force], SHARE * largest)
    return count


def wrench(row, origins):
    """Force, and torque about the origin of the body."""
    force = vector(row, "force")
    return np.concatenate([force, np.cross(vector(row, "point") - origins[row["body"]], force)])


def agrees(pairs, record, tolerance):
    """1 if a force agrees on all bodies. Simbody leaves out pairs of one force that come after one that pulls, in an order of its own."""
    pulls = any(float(row["indentation_m"]) > 0 and not any(vector(row, "force")) for row, _ in pairs)
    if np.isnan(np.array(list(record.values()))).any():
        return 0  # OpenSim divides by 0: check says it of such contacts
    touching = [number for number, (row, _) in enumerate(pairs) if any(vector(row, "force"))]
    chosen = [touching]
    if pulls:
        chosen = [part for size in range(len(touching), -1, -1) for part in itertools.combinations(touching, size)]
    moving = {row["body"] for row, _ in pairs}
    # A fixed body that touches another one pushes nothing that moves.
    record = {body: values for body, values in record.items() if body in moving or body == "Sphere"}
    assert any(all_agree([pairs[number] for number in part], record, tolerance) for part in chosen), (pairs, record)
    return 1


def all_agree(pairs, record, tolerance):
    sums = {}
    for row, one in pairs:
        sums[row["body"]] = sums.get(row["body"], 0) + one
    # The only sphere of a SmoothSphereHalfSpaceForce has no body in its record.
    theirs = {(next(iter(sums), body) if body == "Sphere" else body): values for body, values in record.items()}
    return all(
        np.allclose(sums.get(body, np.zeros(6)), values, rtol=0, atol=tolerance) for body, values in theirs.items()
    )


def followed():
    """Models with spheres on planes that OpenSim reads."""
    followed_models = []
    for path in fixtures("reads") + corpus():
        outcome = command.inspect(path)
        report = outcome.report or {}
        named = all(one["name"] for kind in ("spheres", "forces") for one in report.get(kind, ()))
        if path.parent.name != "bad" and outcome.status == 0 and report.get("forces") and report.get("mass_kg") and named:
            followed_models.append(path)
    return followed_models


@pytest.mark.parametrize("path", followed(), ids=label)
def test_spheres_and_forces_are_those_of_opensim(path, tmp_path):
    coordinates = opensim_motion.coordinates(path)
    times, values, given = smooth(coordinates, os.environ.get("ORACLE_SEED", "1"))
    for mode in MODES:
        still = {name: [0.0] * len(times) for name in values}
        speeds = {"given": given, "splined": None, "rest": still}[mode]
        motion = tmp_path / f"{mode}.sto"
        storage(motion, times, values, speeds)
        theirs = opensim_motion.follow(path, times, values, "splined" if mode == "splined" else speeds)
        ours = rows(path, motion)
        if ours is None:
            return
        agreed = compared(ours, theirs, times)
        assert agreed > 0 or path.stem == "zero_dissipation", mode  # a constant_contact_force of 0, too: NaN at no slip


# Written reactions are tried on models of both classes, with one and with several bodies in a foot.
LOADED = ("human_62kg_hunt_crossley", "horse_smooth_sphere", "v40000_falisse_2022_human", "v40000_moco_2d_gait")


@pytest.mark.parametrize("path", [path for path in followed() if path.stem in LOADED], ids=label)
def test_written_reactions_need_the_same_joint_moments(path, tmp_path):
    coordinates = opensim_motion.coordinates(path)
    times, values, speeds = smooth(coordinates, "2")
    motion, written = tmp_path / "motion.sto", tmp_path / "made.sto"
    storage(motion, times, values, speeds)
    rows(path, motion, "-o", str(written))
    own = np.array(opensim_motion.needed(path, times, values, speeds))
    loaded = np.array(opensim_motion.needed(path, times, values, speeds, written.with_suffix(".xml")))
    assert np.abs(own - loaded).max() < 1e-6 * np.abs(own).max()


# Models without contacts that get them by `add`: with toes, with a coupled patella, and with neither.
RECORDED_MODELS = ("v40000_gait10dof18musc_without_contacts", "v40000_gait2392_without_contacts", "v40000_rajagopal_2016_without_contacts")


@pytest.mark.parametrize("path", [path for path in corpus() if path.stem in RECORDED_MODELS], ids=label)
def test_contacts_given_by_add_are_those_of_opensim(path, tmp_path):
    model = tmp_path / "with.osim"
    command.run("add", path, "--from", "falisse2022", "-o", model)
    times, values, speeds = smooth(opensim_motion.coordinates(model), "3")
    motion = tmp_path / "motion.sto"
    storage(motion, times, values, speeds)
    theirs = opensim_motion.follow(model, times, values, speeds)
    assert compared(rows(model, motion), theirs, times) > 0


def trials():
    """Public recordings: a model and its motion."""
    names = {"example2DWalking": ("2D_gait.osim", "referenceCoordinates.sto"), "subject01_walk_id": ("subject01.osim", "subject01_walk1_ik.mot")}
    for folder, (model, motion) in names.items():
        place = Path(CORPUS).parent / "trials" / folder if CORPUS else Path(folder)
        if (place / model).exists():
            yield pytest.param(place / model, place / motion, id=folder)


@pytest.mark.parametrize(("model", "motion"), list(trials()))
def test_public_recordings_are_followed_like_opensim(model, motion, tmp_path):
    """At all frames, from the file as it is; OpenSim's speeds are splined by itself."""
    if not command.inspect(model).report["forces"]:
        command.run("add", model, "--from", "falisse2022", "-o", tmp_path / "with.osim")
        model = tmp_path / "with.osim"
    times, columns, degrees = table(motion)
    values = {}
    for name, default, kind in opensim_motion.coordinates(model):
        joint, coordinate = name.split("/")
        named = (f"/jointset/{joint}/{coordinate}/value", f"{joint}/{coordinate}/value", coordinate)
        column = next((columns[one] for one in named if one in columns), [default] * len(times))
        is_angle = degrees and kind == ROTATIONAL and any(one in columns for one in named)
        values[name] = [float(np.radians(value)) if is_angle else value for value in column]
    speeds = {
        f"{joint}/{coordinate}": columns.get(f"/jointset/{joint}/{coordinate}/speed")
        for joint, coordinate in (name.split("/") for name in values)
    }
    theirs = opensim_motion.follow(model, times, values, speeds if all(speeds.values()) else "splined")
    assert compared(rows(model, motion), theirs, times) > 0


def with_contacts_and_plates(model, folder):
    """The model, with contacts, the plates, and their ExternalLoads."""
    (plates,) = [path for path in model.parent.glob("*[gG][rR][fF]*") if path.suffix != ".xml"]
    (loads,) = model.parent.glob("*[gG][rR][fF]*.xml")
    if not command.inspect(model).report["forces"]:
        command.run("add", model, "--from", "falisse2022", "-o", folder / "with.osim")
        model = folder / "with.osim"
    return model, plates, loads


@pytest.mark.parametrize("late_ms", [0, 20, 50, 100])
@pytest.mark.parametrize(("model", "motion"), list(trials()))
def test_late_plates_are_said_to_be_late(model, motion, late_ms, tmp_path):
    model, plates, loads = with_contacts_and_plates(model, tmp_path)
    times, columns, _ = table(plates)
    late = tmp_path / "late.sto"
    lines = ["late", "endheader", "\t".join(["time", *columns])]
    lines += ["\t".join(map(repr, row)) for row in zip([time + late_ms / 1000 for time in times], *columns.values(), strict=True)]
    late.write_text("\n".join(lines) + "\n", encoding="utf-8")
    why = command.run("motion", model, motion, "--plates", late, "--loads", loads, "--correct", tmp_path / "corrected.sto").report["consistency"]["why"]
    said = re.search(r"the plates are (\d+) ms later", why)
    assert (said is None) if late_ms == 0 else abs(int(said[1]) - late_ms) <= 5, why


@pytest.mark.parametrize(("model", "motion"), list(trials()))
def test_a_corrected_motion_has_the_forces_of_the_plates_in_opensim(model, motion, tmp_path):
    """AnalyzeTool reads the written file, and its forces are those that the correction reports."""
    model, plates, loads = with_contacts_and_plates(model, tmp_path)
    corrected = tmp_path / "corrected.sto"
    result = command.run("motion", model, motion, "--plates", plates, "--loads", loads, "--correct", corrected).report
    residuals_agree(model, corrected, loads, result, tmp_path)
    theirs = opensim_motion.analysed(model, corrected, tmp_path)
    times = theirs.pop("time")
    ours = {}
    for row in rows(model, corrected):
        ours[row["time_s"]] = ours.get(row["time_s"], 0.0) + float(row["force_y_n"])
    assert len(ours) == len(times)
    assert np.allclose(list(ours.values()), np.sum(list(theirs.values()), axis=0), rtol=0, atol=0.5)  # N


def residuals_agree(model, corrected, loads, result, folder):
    """Root residuals of the correction are those of OpenSim's InverseDynamicsTool on the written files, without the contacts of the model."""
    bare, reactions = folder / "bare.osim", folder / "reactions.sto"
    command.run("remove", model, "-o", bare)
    command.run("motion", model, corrected, "-o", reactions)
    moved = corrected.with_suffix(".plates.xml")
    weight, found = result["weight_n"], result["consistency"]["root_residual"]
    for of, file in (("after", reactions.with_suffix(".xml")), ("with_plates", moved if moved.exists() else loads)):
        needed = opensim_motion.inverse_dynamics(bare, corrected, file, folder)
        inner = slice(3, result["frames"] - 3)
        parts = {"vertical": ("_ty_",), "horizontal": ("_tx_", "_tz_"), "moment": ("_moment",)}
        for part, names in parts.items():
            columns = [np.array(column)[inner] for name, column in needed.items() if name.startswith("pelvis") and any(one in name for one in names)]
            theirs = np.sqrt(sum(np.mean(column**2) for column in columns)) / weight
            if (ours := found[part][of]) is not None:
                assert abs(ours - theirs) < 1e-3, (part, of)


def table(path):
    """Times, columns by name, and whether angles are degrees, of a `.mot` or `.sto`: they are where a `.mot` has no version."""
    head, _, body = path.read_text(encoding="utf-8").partition("endheader")
    names, *lines = [line.split("\t") for line in body.splitlines() if line.strip()]
    columns = list(zip(*[[float(cell) for cell in line if cell.strip()] for line in lines], strict=True))
    named = dict(zip((name.strip() for name in names), columns, strict=False))
    return list(named.pop("time")), {name: list(column) for name, column in named.items()}, "inDegrees=yes" in head or "version" not in head
