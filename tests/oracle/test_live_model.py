"""A plan made in a live model, by the calls of OpenSim that `osimcontact.apply` makes in MATLAB.

OpenSim's bindings for MATLAB have the same functions under the same names (both are made from one description); they need
MATLAB, which is not here. What the plan says was there before is what OpenSim has, bit by bit; and the model is then the one
that the command writes.
"""

import opensim
import pytest

import command
import models

CALLS = opensim.PropertyHelper
CREDITS = sorted((models.FIXTURES / "format").glob("credits_*.osim"))
NAMES = ("human_62kg_smooth_sphere", "horse_hunt_crossley", "human_500kg_hunt_crossley")


def property_of(model, change):
    holder = model.getComponent(change["path"])
    if change["set"] is not None:
        sets = holder.updPropertyByName("contact_parameters").updValueAsObject(0)
        holder = sets.updPropertyByName("objects").updValueAsObject(change["set"])
    return holder.updPropertyByName(change["property"])


def value_of(prop, count):
    return [CALLS.getValueVec3(prop, axis) for axis in range(3)] if count == 3 else CALLS.getValueDouble(prop)


def set_value(prop, value):
    if isinstance(value, list):
        for axis in range(3):
            CALLS.setValueVec3(value[axis], prop, axis)
    else:
        CALLS.setValueDouble(value, prop)


def count_of(value):
    return len(value) if isinstance(value, list) else 1


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_is_made_in_a_live_model(name, tmp_path):
    path = models.FIXTURES / "table1" / f"{name}.osim"
    output = tmp_path / "written.osim"
    outcome = command.run("rescale", path, "--target-mass", "200", "--friction", "--level", "-o", output, *command.YES)
    changes = outcome.report["changes"]
    live = opensim.Model(str(path))
    live.initSystem()
    for change in changes:
        prop = property_of(live, change)
        assert value_of(prop, count_of(change["from"])) == change["from"], change
        set_value(prop, change["to"])
    live.set_credits(outcome.report["credits"])
    live.initSystem()
    written = opensim.Model(str(output))
    written.initSystem()
    kinds = set()
    for change in changes:
        kinds.add((change["property"], change["set"] is None))
        count = count_of(change["to"])
        values = [value_of(property_of(model, change), count) for model in (live, written)]
        assert values[0] == values[1] == change["to"], change
    assert live.getCredits() == written.getCredits() and "[contacts made for 200 kg" in live.getCredits()
    # Of the force, of its list of parameters, of the sphere, and a place.
    expected = {("radius", True), ("location", True), ("transition_velocity", True), ("stiffness", "smooth" in name)}
    assert expected <= kinds


@pytest.mark.parametrize("path", CREDITS, ids=lambda path: path.stem)
def test_credits_are_those_that_opensim_reads(path, tmp_path):
    for verb in (["rescale", path, "--target-mass", "70", "--contacts-mass", "62"], ["remove", path]):
        output = tmp_path / f"{verb[0]}.osim"
        outcome = command.run(*verb, "-o", output, *command.YES)
        # Of a file without credits OpenSim reads its own.
        expected = opensim.Model().getCredits() if outcome.report["credits"] is None else outcome.report["credits"]
        assert opensim.Model(str(output)).getCredits() == expected, verb[0]
