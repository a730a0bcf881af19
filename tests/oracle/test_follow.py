"""Models that the real OpenSim has scaled, and contacts that follow: the numbers come from OpenSim and from NumPy.

`Model.scale` with a ScaleSet, preserving the mass distribution, and the Scale Tool from a setup XML: neither touches contacts.
What `transfer --follow-bodies` makes of them is read by OpenSim again.
"""

import json
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

import command
import models
import rules
import schemas
from opensim_scales import scaled

TOLERANCE = 1e-12
AGREEMENT = 1e-9  # of sources of factors: short offsets lose digits
COINCIDENCE = 1e-6  # of dimensionless drops
S = 1.3

OURS = [models.FIXTURES / "scale_tool" / f"generic_{kind}.osim" for kind in ("smooth", "hunt_crossley")]
CORPUS = ("v40000_falisse_2022_human", "v40000_opencap_lai_arnold_crlf", "v30000_osim_rl_gait9dof18musc_crlf")


def generic_models():
    """Ours, and three of other people: new, with CRLF ends, and one of version 3, which OpenSim saves as version 4."""
    yield from (pytest.param(path, id=path.stem) for path in OURS)
    for name in CORPUS:
        path = Path(models.CORPUS or ".") / f"{name}.osim"
        skip = pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
        yield pytest.param(path, id=name, marks=skip)


ALL = list(generic_models())


def bodies_of(reading):
    return [body["path"].rsplit("/", 1)[-1] for body in reading["bodies"]]


def mass_of(reading):
    return float.fromhex(reading["mass_sum"])


def uneven(bodies):
    """Factors that differ between bodies and axes, but are the same in every run."""
    draw = np.random.default_rng(20260521)
    return {body: [round(float(f), 3) for f in draw.uniform(0.8, 1.25, 3)] for body in sorted(bodies)}


def opensim_scales(path, folder, factors, mass):
    """The model as OpenSim has scaled it, where its ScaleSet is, and what OpenSim says of its frames."""
    output = folder / f"scaled_{path.name}"
    scale_result = scaled({"model": str(path), "output": str(output), "factors": factors, "mass": mass})
    return output, Path(f"{output}.scales.xml"), scale_result


def follow(model, generic, output, *more):
    outcome = command.run("transfer", model, "--from", generic, "--follow-bodies", "-o", output, *more)
    assert outcome.status == 0, outcome
    return outcome.report


def numbers(reading):
    """`{(path, set, property): value}` of contacts as OpenSim reads them; locations are arrays."""
    result = {}
    for force in reading["forces"]:
        for name, value in force["parameters"].items():
            result[force["path"], force["set"], name] = float.fromhex(value)
    for sphere in reading["spheres"]:
        result[sphere["path"], None, "radius"] = float.fromhex(sphere["radius"])
        result[sphere["path"], None, "location"] = np.array([float.fromhex(value) for value in sphere["location"]])
    return result


def json_is_what_opensim_reads(report, before, after):
    """Each `from` and `to` bit for bit, and nothing else has changed."""
    old, new = numbers(before), numbers(after)
    planned = {(change["path"], change["set"], change["property"]): change for change in report["changes"]}
    assert len(planned) == len(report["changes"])
    assert set(old) == set(new)
    for place, change in planned.items():
        for side, reading in (("from", old), ("to", new)):
            assert isinstance(change[side], list) == (place[2] == "location")
            assert np.array_equal(np.array(change[side]), reading[place]), (place, side)
    for place in set(old) - set(planned):
        assert np.array_equal(old[place], new[place]), f"not planned, and yet changed: {place}"


def check_near(value, expected, where):
    """Asserts that values are equal relative to the longest vector."""
    value, expected = np.asarray(value), np.asarray(expected)
    assert np.max(np.abs(value - expected)) <= TOLERANCE * np.max(np.abs(expected)), (where, value, expected)


def contacts(reading):
    """Forces of the reading, each with its moving spheres."""
    for force in reading["forces"]:
        paths = set(force["geometry"])
        moving = [s for s in reading["spheres"] if s["path"] in paths and s["base"] not in reading["fixed"]]
        if moving:
            yield force, moving


@pytest.mark.parametrize("path", ALL)
def test_a_uniform_factor_scales_every_number_by_its_exponent(path, tmp_path, readings):
    generic = readings[path]
    output, _, _ = opensim_scales(path, tmp_path, {body: [S] * 3 for body in bodies_of(generic)}, mass_of(generic) * S**3)
    followed = tmp_path / "followed.osim"
    report = follow(output, path, followed)
    json_is_what_opensim_reads(report, readings[output], readings[followed])
    before, after = numbers(generic), numbers(readings[followed])
    exponents = {
        "stiffness": 1,
        "dissipation": -0.5,
        "constant_contact_force": 2,
        "hertz_smoothing": -1,
        "hunt_crossley_smoothing": -0.5,
    }
    for force, spheres in contacts(generic):
        for name in rules.scaled_properties(force["type"]):
            place = force["path"], force["set"], name
            check_near(after[place], before[place] * S ** exponents[name], place)
        for sphere in spheres:
            for name in ("radius", "location"):
                place = sphere["path"], None, name
                check_near(after[place], before[place] * S, place)

    # The contacts are those of the generic model, scaled by mass.
    alone = tmp_path / "by_mass.osim"
    assert command.rescale(path, mass_of(generic) * S**3, alone).status == 0
    for place, value in numbers(readings[alone]).items():
        if place[2] != "location":
            check_near(after[place], value, place)


RADII = {"mass": (), "bones": ("--radius", "follow")}


def axis_up(turned):
    """The axis of a frame that is nearest to the y axis of its body."""
    up = turned.T @ [0, 1, 0]
    axis = np.argmax(np.abs(up))
    return np.sign(up[axis]) * np.eye(3)[axis]


def expected(generic, scaled_reading, factors, rotations, radii):
    """The numbers by the rule of radii and R^T S R, computed in NumPy. With radii by mass, lowest points stay on the scaled sole."""
    mu = mass_of(scaled_reading) / mass_of(generic)
    old, wanted = numbers(generic), {}
    for force, spheres in contacts(generic):
        before, after = [], []
        for sphere in spheres:
            frame = rotations[sphere["path"].rsplit("/", 1)[-1]]
            turned, scale = np.array(frame["rows"]), np.array(factors[frame["body"]])
            radius, location = old[sphere["path"], None, "radius"], old[sphere["path"], None, "location"]
            stretch = turned.T @ np.diag(scale) @ turned
            before.append(radius)
            after.append(radius * (mu if radii == "mass" else np.prod(scale)) ** (1 / 3))
            down = axis_up(turned) * (radii == "mass")
            wanted[sphere["path"], None, "radius"] = after[-1]
            wanted[sphere["path"], None, "location"] = stretch @ (location - radius * down) + after[-1] * down
        rho = np.sqrt(np.mean(np.square(after)) / np.mean(np.square(before)))
        factor = rules.factors(mu, rho)
        for name in rules.scaled_properties(force["type"]):
            place = force["path"], force["set"], name
            wanted[place] = old[place] * factor[name]
    return wanted


@pytest.mark.parametrize("radii", RADII)
@pytest.mark.parametrize("path", ALL)
def test_uneven_factors_and_turned_frames(path, radii, tmp_path, readings):
    generic = readings[path]
    factors = uneven(bodies_of(generic))
    output, scale_file, scale_result = opensim_scales(path, tmp_path, factors, 0.8 * mass_of(generic))
    followed = tmp_path / "followed.osim"
    report = follow(output, path, followed, "--body-scale-file", scale_file, *RADII[radii])
    json_is_what_opensim_reads(report, readings[output], readings[followed])
    after = numbers(readings[followed])
    for place, value in expected(generic, readings[output], factors, scale_result["rotations"], radii).items():
        check_near(after[place], value, place)


@pytest.mark.parametrize("path", ALL)
def test_sources_of_factors_agree(path, tmp_path, readings):
    """Scale file, meshes and joint offsets, wherever they determine an axis; each alone gives what it determines."""
    factors = uneven(bodies_of(readings[path]))
    output, scale_file, _ = opensim_scales(path, tmp_path, factors, 0.8 * mass_of(readings[path]))
    outcome = command.inspect(output, "--from", path, "--body-scale-file", scale_file)
    assert outcome.status == 0
    factors_by_source = {}
    for body in outcome.report["body_factors"]:
        for source, values in body["by_source"].items():
            told = [(body["body"], axis, value) for axis, value in zip("xyz", values) if value is not None]
            factors_by_source.setdefault(source, []).extend(told)
    assert factors_by_source["joint offset"] and factors_by_source["scale file"]
    if path in OURS:
        assert len(factors_by_source["mesh"]) == 3 * len(factors)
    for source, values in factors_by_source.items():
        for body, axis, value in values:
            assert np.isclose(value, factors[body]["xyz".index(axis)], rtol=AGREEMENT, atol=0), (source, body, axis)
    assert not [finding for finding in outcome.report["findings"] if finding["code"] == "factors-disagree"]


# OpenSim itself cannot: it scales no CoordinateCoupler by uneven factors, and a mesh of the last one is not there.
UNSCALABLE = ("v20302_dynamic_jumper", "v40000_dynamic_jumper", "v30517_elastic_foundation_with_sphere")


def every_model():
    """All models of other people that OpenSim can scale."""
    if not models.CORPUS:
        yield pytest.param(None, id="corpus", marks=pytest.mark.skip(reason=models.NO_CORPUS))
    for path in sorted(Path(models.CORPUS or "/nonexistent").glob("*.osim")):
        if path.stem not in UNSCALABLE:
            yield pytest.param(path, id=path.stem)


@pytest.mark.parametrize("path", every_model())
def test_what_opensim_scaled_is_a_scaled_copy_and_each_axis_exact(path, tmp_path, readings):
    """No axis that is determined is anything else than what OpenSim was given."""
    factors = uneven(bodies_of(readings[path]))
    output, _, _ = opensim_scales(path, tmp_path, factors, 0.8 * mass_of(readings[path]))
    outcome = command.inspect(output, "--from", path)
    assert outcome.status == 0, outcome
    codes = {finding["code"] for finding in outcome.report["findings"]}
    assert not codes & {"not-a-scaled-copy", "factors-disagree"}, outcome.report["findings"]
    for body in outcome.report["body_factors"]:
        for axis, value in zip("xyz", body["factors"]):
            if value is not None:
                expected = factors[body["body"]]["xyz".index(axis)]
                assert np.isclose(value, expected, rtol=AGREEMENT, atol=0), (body["body"], axis, value, expected)


@pytest.mark.parametrize("radii", RADII)
@pytest.mark.parametrize("kind", ["smooth", "hunt_crossley"])
def test_the_scale_tool_from_a_setup(kind, radii, tmp_path, readings):
    """The fixture is what the Scale Tool writes; the applied ScaleSet is read as OpenSim's Scale Tool wrote it."""
    for name in (f"generic_{kind}.osim", f"setup_{kind}.xml"):
        shutil.copy(models.FIXTURES / "scale_tool" / name, tmp_path)
    output = tmp_path / f"scaled_{kind}.osim"
    scale_result = scaled({"setup": str(tmp_path / f"setup_{kind}.xml"), "output": str(output)})
    for name in (output.name, "applied_scale_set.xml"):
        assert (tmp_path / name).read_bytes() == (models.FIXTURES / "scale_tool" / name).read_bytes()
    applied = ElementTree.parse(tmp_path / "applied_scale_set.xml")
    factors = {s.findtext("segment"): [float(f) for f in s.findtext("scales").split()] for s in applied.iter("Scale")}
    generic, followed = tmp_path / f"generic_{kind}.osim", tmp_path / "followed.osim"
    report = follow(output, generic, followed, "--body-scale-file", tmp_path / "applied_scale_set.xml", *RADII[radii])
    json_is_what_opensim_reads(report, readings[output], readings[followed])
    after = numbers(readings[followed])
    wanted = expected(readings[generic], readings[output], factors, scale_result["rotations"], radii)
    for place, value in wanted.items():
        check_near(after[place], value, place)


def distance_of_models(model, other):
    """The largest difference between two drops in dimensionless form: height over radius, force over body weight."""
    call = [str(command.BINARY), "drop-test", str(model), "--compare", str(other), "--format", "json"]
    process = subprocess.run(call, capture_output=True, timeout=120, check=True)
    printed = json.loads(process.stdout)
    schemas.check("drop-test", printed)
    compared = printed["compare"]
    return compared["height_over_radius"], compared["force_bw"]


@pytest.mark.parametrize("kind", ["smooth", "hunt_crossley"])
def test_drops_coincide_when_contacts_follow_and_do_not_otherwise(kind, tmp_path):
    folder = models.FIXTURES / "scale_tool"
    generic, output = folder / f"generic_{kind}.osim", folder / f"scaled_{kind}.osim"
    followed = tmp_path / "followed.osim"
    follow(output, generic, followed)
    assert max(distance_of_models(followed, generic)) < COINCIDENCE
    assert min(distance_of_models(output, generic)) > 0.05
