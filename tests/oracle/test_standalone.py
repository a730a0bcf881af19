"""A ForceSet and a ContactGeometrySet of their own: read, rescaled together, and read again inside a model."""

import shutil
from pathlib import Path

import pytest

import command
import compare
import models
import rules

FORMAT = models.FIXTURES / "format"
MODEL = FORMAT / "standalone_model_without_contacts.osim"
GEOMETRY = FORMAT / "standalone_ContactGeometrySet.xml"


@pytest.mark.parametrize("name", ["standalone_ForceSet.xml", "standalone_defaults_ForceSet.xml"])
def test_inspect_equals_opensim(name, readings):
    outcome = command.inspect(FORMAT / name, "--geometry", GEOMETRY, "--model", MODEL)
    assert outcome.status == 0, outcome
    sets_are_equal(outcome.report, readings[FORMAT / name], readings[GEOMETRY])


@pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
def test_inspect_equals_opensim_on_moco_3d_walking(readings):
    forces, geometry, model = moco()
    outcome = command.inspect(forces, "--geometry", geometry, "--model", model)
    assert outcome.status == 0, outcome
    sets_are_equal(outcome.report, readings[forces], readings[geometry])


def test_rescaled_sets_are_read_inside_a_model(tmp_path, readings):
    """A model that pulls both sets in from files shows OpenSim the successors."""
    outcome = rescale(FORMAT / "standalone_ForceSet.xml", GEOMETRY, MODEL, tmp_path)
    host = shutil.copy(FORMAT / "file_both_sets.osim", tmp_path)
    before, after = readings[FORMAT / "file_both_sets.osim"], readings[host]
    planned, (contacts, target) = compare.plan(outcome.report), command.masses(outcome.report)
    compare.values_are_what_opensim_reads(planned, before, after)  # OpenSim prints only the files' names
    compare.plan_follows_the_rule(planned, compare.expected(before, target / contacts), before)


@pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS)
def test_rescaled_sets_of_moco_3d_walking(tmp_path, readings):
    forces, geometry, model = moco()
    outcome = rescale(forces, geometry, model, tmp_path)
    contacts, target = command.masses(outcome.report)
    factor = rules.factors(target / contacts, rules.isometric(target / contacts))
    for old, new in zip(readings[forces]["forces"], readings[tmp_path / forces.name]["forces"], strict=True):
        for name, text in old["parameters"].items():
            expected = float.fromhex(text) * factor.get(name, 1.0)
            assert rules.close(float.fromhex(new["parameters"][name]), expected), (old["name"], name)
    for old, new in zip(readings[geometry]["spheres"], readings[tmp_path / geometry.name]["spheres"], strict=True):
        assert rules.close(float.fromhex(new["radius"]), float.fromhex(old["radius"]) * factor["radius"]), old["name"]
        assert old["location"] == new["location"]


def moco():
    """The two sets of Moco's 3D walking and their model."""
    stem = Path(models.CORPUS) / "v40600_moco_3d_walking"
    return [
        stem.with_name(stem.name + end)
        for end in ("_ContactForceSet.xml", "_ContactGeometrySet.xml", "_model_without_contacts.osim")
    ]


def rescale(forces, geometry, model, folder):
    """Rescales both sets to 200 kg, into `folder`."""
    outcome = command.run(forces, "--geometry", geometry, "--model", model, "--target-mass", "200", *command.YES, "-d", folder)
    assert outcome.status == 0, outcome
    return outcome


def sets_are_equal(report, forces, geometry):
    """Compares the sets by names of objects, because a force in a standalone set has no path."""
    theirs = {force["name"]: force["parameters"] for force in forces["forces"]}
    assert {force["name"] for force in report["forces"]} == set(theirs)
    for force in report["forces"]:
        compare.numbers_equal(force["parameters"], theirs[force["name"]], force["name"])
    radii = {sphere["name"]: sphere["radius"] for sphere in geometry["spheres"]}
    assert {sphere["name"]: compare.hexed(sphere["radius_m"]) for sphere in report["spheres"]} == radii
