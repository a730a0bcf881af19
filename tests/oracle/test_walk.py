"""A walk through the Scale Tool case: the real OpenSim scales published models, and whoever follows only what `check` prints
ends with contacts that are right.

For each model, scaled alike along all axes and not: `check SCALED --from GENERIC` finds the spheres that stayed behind, and its
command is run as it stands. Without `--level` each centre is the factors times the generic's, with it each bottom is; and
`check` has no error and no warning left. Numbers are those that OpenSim reads.
"""

import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import command
import models
from opensim_scales import scaled

TOLERANCE = 1e-12  # m
UNIFORM = 0.69
MASS = 20.0  # kg
NAMES = (
    "v40000_falisse_2022_human",
    "v40000_dhondt_2024_3seg_human",
    "v40000_human_12_hunt_crossley",
    "v40000_opencap_lai_arnold_crlf",
    "v40000_moco_2d_gait",
    "v30000_osim_rl_gait9dof18musc_crlf",
    "v40000_scone_h0914m",
    "v40000_toy_landing",
)
KINDS = ("alike", "uneven")


def factors_of(bodies, kind):
    """By body: one factor for all, or x, y and z of their own, always the same and alike left and right."""
    if kind == "alike":
        return {body: [UNIFORM] * 3 for body in bodies}
    sizes = {stem: np.random.default_rng(sum(stem.encode())).uniform(0.62, 0.76, 3) for stem in map(stem_of, bodies)}
    return {body: [round(float(f), 3) for f in sizes[stem_of(body)]] for body in bodies}


def stem_of(body):
    return body.removesuffix("_r").removesuffix("_l")


@pytest.fixture(scope="module")
def walk(tmp_path_factory, readings):
    """The scaled file and the factors for each model and kind. Scaled all at once, because OpenSim is slow to start."""
    if not models.CORPUS:
        pytest.skip(models.NO_CORPUS)
    folder = tmp_path_factory.mktemp("walk")
    paths = {name: Path(models.CORPUS) / f"{name}.osim" for name in NAMES}
    readings.fetch(paths.values())
    result = {}
    for name, path in paths.items():
        bodies = sorted(body["path"].rsplit("/", 1)[-1] for body in readings[path]["bodies"])
        for kind in KINDS:
            output = folder / f"{name}_{kind}.osim"
            result[name, kind] = path, output, factors_of(bodies, kind)
    jobs = [
        {"model": str(path), "output": str(output), "factors": factors, "mass": MASS}
        for path, output, factors in result.values()
    ]
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(scaled, jobs))
    return result


def checked(model, *more):
    outcome = command.run("check", model, *more)
    assert outcome.report is not None, outcome
    return outcome.report


def printed_codes(findings):
    """The one command that `check` prints."""
    commands = {finding["command"] for finding in findings if finding["command"]}
    assert len(commands) == 1, commands
    words = shlex.split(commands.pop())
    assert words.pop(0) == "osim-contact-scale"
    return words


def run_as_printed(words, output):
    process = subprocess.run([str(command.BINARY), *words, "-o", str(output)], capture_output=True, timeout=60)
    assert process.returncode == 0, process.stderr.decode()


def places(reading, model):
    """Centre, radius and body of each sphere, as OpenSim reads them; bodies by `inspect`."""
    body = {sphere["path"]: sphere["body"] for sphere in command.inspect(model).report["spheres"]}
    return {
        sphere["path"].rsplit("/", 1)[-1]: (
            np.array([float.fromhex(value) for value in sphere["location"]]),
            float.fromhex(sphere["radius"]),
            body[sphere["path"]],
        )
        for sphere in reading["spheres"]
        if sphere["base"] not in reading["fixed"]
    }


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", NAMES)
def test_who_follows_what_check_prints_ends_with_contacts_that_are_right(name, kind, walk, readings, tmp_path):
    generic, model, factors = walk[name, kind]
    alone = checked(model)["findings"]
    # One file alone says that something is wrong, too, and prints nothing that would keep the old places.
    assert any(finding["code"].startswith("spheres-misplaced") for finding in alone), alone
    assert not any("--contacts-mass" in (finding["command"] or "") for finding in alone), alone

    compared = checked(model, "--from", generic)["findings"]
    behind = [finding for finding in compared if finding["code"] == "spheres-left-behind"]
    words = printed_codes(compared)
    assert words[0] == "transfer" and "--follow-bodies" in words and behind
    assert "--level" in words

    old = places(readings[generic], generic)
    plain, level = tmp_path / "plain.osim", tmp_path / "level.osim"
    without = [word for word in words if word != "--level"]
    run_as_printed([*without, "--radius", "follow"], plain)
    run_as_printed(words, level)
    readings.fetch([plain, level])
    for centre, bottoms in ((plain, False), (level, True)):
        now = places(readings[centre], centre)
        assert set(now) == set(old)
        for sphere, (place, radius, body) in now.items():
            was, old_radius, _ = old[sphere]
            down, old_down = np.array([0, radius, 0]) * bottoms, np.array([0, old_radius, 0]) * bottoms
            expected = np.array(factors[body]) * (was - old_down)
            assert np.max(np.abs(place - down - expected)) <= TOLERANCE, (sphere, place, expected)
        for more in ((), ("--from", generic)):
            remaining = checked(centre, *more)
            assert (remaining["counts"]["error"], remaining["counts"]["warning"]) == (0, 0), remaining["findings"]
