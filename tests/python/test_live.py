"""Live models: an `opensim.Model` in, and a change applied to one equals the file that would be written."""

import re
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import FIXTURES, HUMAN, corpus, fixtures, kind_of, name_of

opensim = pytest.importorskip("opensim", reason="opensim is not installed: it needs CPython 3.11 to 3.13 and NumPy 2")
import osim_contact_scale as ocs  # noqa: E402

# A sphere inside of its force, as Moco once wrote it: OpenSim 4.2 and later cannot read it.
UNREADABLE = {"moco_sphere_in_force.osim"}

FOLDERS = {"table1", "format", "walks", "scale_tool", "check"}
MODELS = [path for path in fixtures() if kind_of(path) in FOLDERS and path.name not in UNREADABLE] + corpus()

CONFIRMED = ("implausible-mass", "mass-in-pounds", "implausible-radius")
CHANGES = {
    "rescale": lambda model: ocs.rescale(model, target_mass=500.5, friction=True, level=True, yes=CONFIRMED),
    "rescale a few": lambda model: ocs.rescale(model, target_mass=500.5, only=["stiffness"], yes=CONFIRMED),
    "set": lambda model: ocs.set(model, stiffness="x1.1", dissipation=1.25, transition_velocity=0.123),
    "design": lambda model: ocs.design(model, indentation=0.13),
    "convert to smooth": lambda model: ocs.convert(model, to="smooth"),
    "convert to Hunt-Crossley": lambda model: ocs.convert(model, to="hunt-crossley"),
    "remove": lambda model: ocs.remove(model),
    "add": lambda model: ocs.add(model, from_="falisse2022"),
    "add again": lambda model: ocs.add(model, from_="falisse2022", replace=True),
    "note": lambda model: ocs.note(model, contacts_mass=61.9),
    "transfer": lambda model: ocs.transfer(model, from_="falisse2022", spheres=6, radius="isometric", level=True),
    "transfer from another model": lambda model: ocs.transfer(model, from_=HUMAN),
    "follow": lambda model: ocs.transfer(model, from_=ORIGINALS[model.name], follow_bodies=True, level=True),
}

#: Models that the Scale Tool made, and what they were made from.
ORIGINALS = {
    f"scaled_{kind}.osim": FIXTURES / "scale_tool" / f"generic_{kind}.osim" for kind in ("smooth", "hunt_crossley")
}


#: Whole objects that OpenSim's bindings cannot exchange in a live model: outside of its two sets, without a name of their own, or with
#: names that occur twice.
REFUSED = {
    ("components_deep.osim", "convert to Hunt-Crossley"),
    ("components_deep.osim", "remove"),
    ("components_force.osim", "convert to Hunt-Crossley"),
    ("components_force.osim", "remove"),
    ("components_force_and_sphere.osim", "convert to Hunt-Crossley"),
    ("components_force_and_sphere.osim", "remove"),
    ("components_hunt_crossley.osim", "convert to smooth"),
    ("components_hunt_crossley.osim", "remove"),
    ("components_in_body.osim", "convert to Hunt-Crossley"),
    ("components_in_body.osim", "remove"),
    ("components_of_forceset.osim", "convert to Hunt-Crossley"),
    ("components_of_forceset.osim", "remove"),
    ("geometry_by_component_name.osim", "remove"),
    ("geometry_by_component_path.osim", "remove"),
    ("geometry_by_nested_name.osim", "remove"),
    ("geometry_two_of_a_name.osim", "remove"),
    ("same_force_name_twice.osim", "convert to Hunt-Crossley"),
    ("same_sphere_name_twice.osim", "remove"),
    ("unnamed_force.osim", "convert to Hunt-Crossley"),
    ("v40000_moco_2d_gait.osim", "convert to Hunt-Crossley"),
    ("v40000_moco_2d_gait.osim", "remove"),
    ("v40000_moco_2d_gait.osim", "add again"),
}


def forget_defaults():
    """Makes OpenSim's defaults those of a new process: it keeps the `<defaults>` of every model that it reads."""
    force = opensim.HuntCrossleyForce()
    force.addGeometry("any")
    materials = force.updPropertyByName("contact_parameters").updValueAsObject()
    material = materials.updPropertyByName("objects").updValueAsObject(0)
    material.updPropertyByName("geometry").clear()
    bare = opensim.HuntCrossleyForce()
    kinds = (opensim.SmoothSphereHalfSpaceForce(), bare, material, opensim.ContactSphere(), opensim.ContactHalfSpace())
    for kind in kinds:
        opensim.OpenSimObject.registerType(kind)


def loaded(path):
    """The model at `path`, loaded as in a new process."""
    forget_defaults()
    return opensim.Model(path)


def text_of_model(model, folder):
    """Everything in a model, defaults spelled out."""
    opensim.OpenSimObject.setSerializeAllDefaults(True)
    try:
        path = folder / "printed.osim"
        model.printToXML(str(path))
        return path.read_text(encoding="utf-8", errors="replace")
    finally:
        opensim.OpenSimObject.setSerializeAllDefaults(False)


@pytest.mark.parametrize("path", MODELS, ids=name_of)
def test_apply_equals_writing_and_loading(path, tmp_path):
    applied = set()
    for name, change in CHANGES.items():
        if name == "follow" and path.name not in ORIGINALS:
            continue
        try:
            result = change(path)
        except ocs.ContactScaleError:
            continue  # The model has no contacts, or something has to be said: test_same_as_command has those.
        if (path.name, name) in REFUSED:
            live = loaded(str(path))
            before = text_of_model(live, tmp_path)
            with pytest.raises(ocs.ContactScaleError, match="write it to a file"):
                result.apply(live)
            assert text_of_model(live, tmp_path) == before, name
            continue
        text = result.to_bytes()
        new = tmp_path / path.name
        new.write_bytes(text)
        if b"file=" in text and kind_of(path) == "format":
            continue
        live = loaded(str(path))
        result.apply(live)
        assert text_of_model(live, tmp_path) == text_of_model(loaded(str(new)), tmp_path), name
        applied.add(name)
    if kind_of(path) == "table1":
        # They have contacts, and were not made by the Scale Tool.
        assert CHANGES.keys() - applied <= {"add", "add again", "follow"}
    elif path.name in ORIGINALS:
        assert "follow" in applied
    elif path in corpus() and ocs.inspect(path)[0]["forces"]:
        assert applied


def test_a_live_model_is_a_model(tmp_path):
    model = loaded(str(HUMAN))
    from_live, from_path = ocs.rescale(model, target_mass=500.5), ocs.rescale(HUMAN, target_mass=500.5)
    assert from_live.path == from_path.path == str(HUMAN)
    numbers = [
        [(change["path"], change["property"], change["to"]) for change in result.record["changes"]]
        for result in (from_live, from_path)
    ]
    assert numbers[0] == numbers[1]
    from_live.apply(model)
    model.initSystem()
    force = opensim.SmoothSphereHalfSpaceForce.safeDownCast(model.getComponent("/forceset/contact_s1_r"))
    assert force.get_stiffness() == next(value for path, name, value in numbers[1] if name == "stiffness")
    assert ocs.inspect(model)[0]["contacts_mass_kg"]["value"] == 500.5


def test_a_model_made_in_memory():
    model = opensim.Model()
    model.setName("empty")
    with pytest.raises(ocs.ModelError) as caught:
        ocs.rescale(model, target_mass=80)
    assert caught.value.code == "no-contacts" and caught.value.path == "model.osim"


def test_another_model_is_left_as_it_was(tmp_path):
    other = loaded(str(FIXTURES / "format" / "v40000.osim"))
    before = text_of_model(other, tmp_path)
    with pytest.raises(ocs.ContactScaleError, match="model"):
        ocs.rescale(HUMAN, target_mass=500).apply(other)
    assert text_of_model(other, tmp_path) == before


def test_what_is_there_already_is_refused(tmp_path):
    model = loaded(str(HUMAN))
    same = [f"{body}_{side}=1,1,1" for body in ("calcn", "toes") for side in "lr"]
    added = ocs.add(ocs.remove(HUMAN), from_=HUMAN, body_scale=same)
    before = text_of_model(model, tmp_path)
    assert {change["change"] for change in added.record["objects"]} == {"added"}
    with pytest.raises(ocs.ContactScaleError, match="would not be"):
        added.apply(model)
    assert text_of_model(model, tmp_path) == before


def test_the_note_survives_opensim(tmp_path):
    model = loaded(str(HUMAN))
    ocs.rescale(model, target_mass=500).apply(model)
    model.printToXML(str(tmp_path / "saved.osim"))
    assert ocs.inspect(tmp_path / "saved.osim")[0]["contacts_mass_kg"] == {"value": 500.0, "source": "note"}
    assert re.search("osim-contact-scale", model.getCredits())


def test_a_note_that_goes_leaves_a_live_model_too(tmp_path):
    noted, without = tmp_path / "noted.osim", tmp_path / "without.osim"
    ocs.note(HUMAN, contacts_mass=62).write(noted)
    model = loaded(str(noted))
    result = ocs.set(noted, stiffness="x2", no_note=True)
    result.write(without)
    result.apply(model)
    assert "contacts made for" not in model.getCredits()
    assert text_of_model(model, tmp_path) == text_of_model(loaded(str(without)), tmp_path)


def test_a_model_that_was_changed_since_is_refused(tmp_path):
    model = loaded(str(HUMAN))
    doubled = ocs.set(model, stiffness="x2")
    own = model.getForceSet().get(0)
    opensim.SmoothSphereHalfSpaceForce.safeDownCast(own).set_stiffness(5.0)
    before = text_of_model(model, tmp_path)
    with pytest.raises(ocs.ContactScaleError, match=r"is 5\.0, not 1000000\.0 as it was"):
        doubled.apply(model)
    assert text_of_model(model, tmp_path) == before


def test_a_body_of_another_mass_is_refused(tmp_path):
    model = loaded(str(HUMAN))
    planned = ocs.transfer(HUMAN, from_="falisse2022", spheres=6)
    for body in model.getBodySet():
        body.setMass(2 * body.getMass())
    before = text_of_model(model, tmp_path)
    with pytest.raises(
        ocs.ContactScaleError, match=r"the mass of /bodyset/.* kg as it was when this change was planned"
    ):
        planned.apply(model)
    assert text_of_model(model, tmp_path) == before


def test_defaults_are_spelled_out_in_every_thread_and_then_as_before():
    defaults = FIXTURES / "format" / "defaults_hold_everything.osim"
    constant = float(re.search("<constant_contact_force>(.*?)<", defaults.read_text(encoding="utf-8"))[1])
    loaded(str(defaults))
    live = [opensim.Model(str(HUMAN)) for _ in range(4)]
    with ThreadPoolExecutor(4) as pool:
        for _ in range(10):
            for seen in pool.map(ocs.inspect, live):
                assert seen[0]["forces"][0]["parameters"]["constant_contact_force"] == constant
            assert not opensim.OpenSimObject.getSerializeAllDefaults()


def test_a_change_is_not_applied_twice(tmp_path):
    model = loaded(str(HUMAN))
    doubled = ocs.set(model, stiffness="x2")
    doubled.apply(model)
    once = text_of_model(model, tmp_path)
    doubled.apply(model)
    assert text_of_model(model, tmp_path) == once


def test_only_models_are_live():
    with pytest.raises(TypeError, match=r"opensim\.Model"):
        ocs.set(HUMAN, stiffness="x2").apply(str(HUMAN))


def test_defaults_of_an_earlier_model_are_seen():
    """OpenSim keeps defaults for the whole process, and does not print values that equal them."""
    defaults = FIXTURES / "format" / "defaults_hold_everything.osim"
    constant = float(re.search("<constant_contact_force>(.*?)<", defaults.read_text(encoding="utf-8"))[1])
    loaded(str(defaults))
    model = opensim.Model(str(HUMAN))
    force = opensim.SmoothSphereHalfSpaceForce.safeDownCast(model.getComponent("/forceset/contact_s1_r"))
    assert force.get_constant_contact_force() == constant != 1e-5
    assert ocs.inspect(model)[0]["forces"][0]["parameters"]["constant_contact_force"] == constant
    ocs.set(model, constant_contact_force="x2").apply(model)
    assert force.get_constant_contact_force() == 2 * constant
    # What was planned for the file is not right for this model.
    with pytest.raises(ocs.ContactScaleError, match="plan it again"):
        ocs.set(HUMAN, constant_contact_force="x7").apply(model)
