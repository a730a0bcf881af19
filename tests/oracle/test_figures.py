"""The figures of `inspect` that come from the law of the file, against the forces of the real OpenSim.

Each sphere of a model becomes a body of its own with the same radius and parameters. Pressed in as deep as `inspect` says
that it rests, OpenSim must find the load that it is said to carry; just touching, the force that it is said to have.
"""

import pytest

import command
import models
from opensim_forces import forces
from test_forces import SMOOTHING, Contact, model

TOLERANCE = 1e-9  # of the load
MODELS = models.animals() + sorted((models.FIXTURES / "check").glob("*.osim")) + models.corpus()


def spheres(report):
    """`(figures, contact)` of each sphere that one force of one material presses."""
    for limb in report["figures"]["limbs"]:
        for one in limb["spheres"]:
            pressing = [force for force in report["forces"] if one["sphere"] in force["spheres"] and force["applies"]]
            if len(pressing) != 1 or len([f for f in report["forces"] if f["name"] == pressing[0]["name"]]) != 1:
                continue
            values = pressing[0]["parameters"]
            smoothing = {name: values[name] for name in SMOOTHING if name in values}
            yield one, Contact(
                pressing[0]["type"], one["radius_m"], values["stiffness"], values["dissipation"], smoothing
            )


@pytest.mark.parametrize("path", MODELS, ids=models.label)
def test_opensim_finds_the_load_at_rest(path, tmp_path):
    outcome = command.run("inspect", path)
    if outcome.error or not outcome.report["figures"]["limbs"]:
        pytest.skip("no sphere stands on the floor")
    # One sphere of each kind.
    kinds = {repr(contact): (one, contact) for one, contact in spheres(outcome.report)}
    if not kinds:
        pytest.skip("every sphere is pressed by several forces or materials")
    figures, contacts = zip(*kinds.values())
    document = tmp_path / "contacts.osim"
    document.write_text(model(contacts), encoding="utf-8")
    touching = [[contact.radius, 0.0] for contact in contacts]
    moments, wanted = [touching], [[one["force_just_touching_n"] or 0.0 for one in figures]]
    if figures[0]["load_n"] is not None:
        for end, weights in [("", 1.0), ("_at_two", 2.0)]:
            depth = [one["relative_indentation_model_law" + end] * one["radius_m"] for one in figures]
            moments.append([[contact.radius - x, 0.0] for contact, x in zip(contacts, depth)])
            wanted.append([weights * one["load_n"] for one in figures])
    for found, expected in zip(forces(document, moments), wanted, strict=True):
        for force, load in zip(found, expected, strict=True):
            assert abs(force - load) <= TOLERANCE * max(load, 1e-6), (force, load)
