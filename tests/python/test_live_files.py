"""Files that are made from live models: OpenSim opens them in another process, and reads the same values.

They are written in one process, which has read defaults of many classes before, and read in another one, which has read nothing else. What
is compared is all that OpenSim prints, with all defaults: it prints 17 digits, so that equal texts are equal numbers.
"""

import contextlib
import itertools
import multiprocessing
import re
import shutil
from concurrent.futures import ProcessPoolExecutor

import pytest
from conftest import FIXTURES, HUMAN, corpus, fixtures, kind_of, name_of

opensim = pytest.importorskip("opensim", reason="opensim is not installed: it needs CPython 3.11 to 3.13 and NumPy 2")
import osim_contact_scale as ocs  # noqa: E402
from osim_contact_scale import _live, _live_print  # noqa: E402

CONFIRMED = ("implausible-mass", "mass-in-pounds", "implausible-radius")

#: Defaults that OpenSim keeps for later files. None of them is the default in OpenSim's code; the force of a PointActuator nearly is.
DEFAULTS = """<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="40500">
    <Model name="before">
        <defaults>
            <Body name="default"><mass>7.25</mass><mass_center>0.125 0 0</mass_center><inertia>3 2 1 0 0 0</inertia></Body>
            <Coordinate name="default"><default_value>0.03125</default_value><range>-2 2.5</range></Coordinate>
            <PhysicalOffsetFrame name="default"><translation>0 0.0625 0</translation></PhysicalOffsetFrame>
            <Marker name="default"><location>1 2 3</location></Marker>
            <PathPoint name="default"><location>0.001 0.002 0.003</location></PathPoint>
            <Thelen2003Muscle name="default"><max_isometric_force>1234.5</max_isometric_force></Thelen2003Muscle>
            <Schutte1993Muscle_Deprecated name="default"><activation1>7.75</activation1></Schutte1993Muscle_Deprecated>
            <DeGrooteFregly2016Muscle name="default"><tendon_slack_length>0.3</tendon_slack_length></DeGrooteFregly2016Muscle>
            <CoordinateActuator name="default"><optimal_force>2.00000001</optimal_force></CoordinateActuator>
            <PointActuator name="default"><optimal_force>1.00000001</optimal_force></PointActuator>
            <WrapCylinder name="default"><radius>0.0875</radius></WrapCylinder>
            <ContactSphere name="default"><radius>0.0123</radius></ContactSphere>
            <SmoothSphereHalfSpaceForce name="default"><hertz_smoothing>299</hertz_smoothing></SmoothSphereHalfSpaceForce>
            <HuntCrossleyForce name="default"><transition_velocity>0.02</transition_velocity></HuntCrossleyForce>
        </defaults>
    </Model>
</OpenSimDocument>
"""


#: The credits that OpenSim gives to models without any. A note comes after them.
AUTHORS = re.compile("<credits>(Frank Anderson, [^;<]*)")


def text_with_defaults(model, path):
    """The text that OpenSim prints of a model, all defaults with it. The clone has no `<defaults>` and no other files."""
    clone = _live_print.connected_clone(model)
    opensim.OpenSimObject.setSerializeAllDefaults(True)
    try:
        clone.printToXML(str(path))
    finally:
        opensim.OpenSimObject.setSerializeAllDefaults(False)
    return path.read_text(encoding="utf-8", errors="replace")


def starts(model):
    """Whether a model can be simulated."""
    try:
        model.initSystem()
    except RuntimeError:
        return False
    return True


def without_contacts(text):
    """The text of a printed model without contact objects, and without credits, which contain the note of this package."""
    names = "|".join([*_live_print.CONTACTS, "credits"])
    return re.sub(rf"\t*<({names})\b.*?</\1>\n", "", text, flags=re.S)


def written(paths, folder, has_defaults, system):
    """Writes a file from each model that OpenSim reads; returns the values of the live models."""
    quiet()
    if has_defaults:
        before = folder / "before.osim"
        before.write_text(DEFAULTS, encoding="utf-8")
        opensim.Model(str(before))
    result = {}
    for number, path in enumerate(paths):
        try:
            model = opensim.Model(str(path))
        except RuntimeError:
            continue
        # OpenSim finds the meshes of contacts beside the file.
        for mesh in path.parent.glob("*.obj"):
            shutil.copy(mesh, folder)
        if model.getBodySet().getSize():
            body = model.getBodySet().get(0)
            body.setMass(1.0625 * body.getMass() + 1 / 3)
        result[number] = write(model, folder / f"{number}.osim", system)
    return result


def write(model, new, system=False):
    """Plans a live model, writes that, and applies it: what was alive before and after, and whether it can be simulated."""
    scratch = new.with_suffix(".printed")
    before = text_with_defaults(model, scratch)
    try:
        planned = ocs.rescale(model, target_mass=321.5, yes=CONFIRMED)
    except ocs.ContactScaleError:
        # Without contacts, or with some that are refused. What a plan would start from is a file, too.
        new.write_bytes(_live.to_bytes(model)[1])
    else:
        planned.write(new)
        planned.apply(model)
    assert b"<defaults" not in new.read_bytes() and b' file="' not in new.read_bytes(), new
    return before, text_with_defaults(model, scratch), system and starts(model)


def read_files(files, system):
    """Reads files: what OpenSim has of each, and whether it can be simulated. A text is what OpenSim says if it cannot read one."""
    quiet()
    result = {}
    for number, path in files.items():
        try:
            model = opensim.Model(str(path))
        except RuntimeError as error:
            result[number] = str(error)
        else:
            result[number] = text_with_defaults(model, path.with_suffix(".read")), system and starts(model)
    return result


def quiet():
    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Off")


def in_new_process(function, *arguments):
    """The result of a function in a new process."""
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        return pool.submit(function, *arguments).result()


def compare(result, folder, label, system=False):
    """Compares files with the models that they were made from."""
    opened = in_new_process(read_files, {number: folder / f"{number}.osim" for number in result}, system)
    for number, (before, after, is_simulated) in result.items():
        assert isinstance(opened[number], tuple), (label(number), opened[number])
        text, is_simulated_again = opened[number]
        assert text == after, label(number)
        assert without_contacts(text) == without_contacts(before), label(number)
        assert set(AUTHORS.findall(before)) == set(AUTHORS.findall(text)), label(number)
        assert is_simulated_again or not is_simulated, label(number)


MODELS = [*corpus(), *fixtures()]


@pytest.mark.parametrize("has_defaults", [False, True], ids=["", "after other defaults"])
def test_files_of_live_models_are_those_models(has_defaults, tmp_path):
    result = in_new_process(written, MODELS, tmp_path, has_defaults, not has_defaults)
    assert len(result) > 250
    compare(result, tmp_path, lambda number: name_of(MODELS[number]), not has_defaults)


def test_a_file_is_the_live_model_in_the_same_process_too(tmp_path):
    paths = [path for path in MODELS if kind_of(path) in (None, "table1", "scale_tool")]
    for number, (_, after, _) in written(paths, tmp_path, False, False).items():
        model = opensim.Model(str(tmp_path / f"{number}.osim"))
        assert text_with_defaults(model, tmp_path / "read.osim") == after, paths[number]


def write_all_classes(folder, has_defaults):
    """A model for each class of components that Python can make and put into a model, and a file from each."""
    quiet()
    if has_defaults:
        before = folder / "before.osim"
        before.write_text(DEFAULTS, encoding="utf-8")
        opensim.Model(str(before))
    names = opensim.ArrayStr()
    opensim.OpenSimObject.getRegisteredTypenames(names)
    result, classes = {}, []
    for name in sorted(names.get(place) for place in range(names.getSize())):
        member = opensim.Component.safeDownCast(opensim.OpenSimObject.newInstanceOfType(name))
        # A coordinate without its joint ends OpenSim. A model in a model is none.
        if member is None or name in ("Coordinate", "Model"):
            continue
        model = opensim.Model()
        member = member.clone()
        member.setName("member")
        member.thisown = False
        with contextlib.suppress(RuntimeError):  # Some need other objects.
            model.addComponent(member)
            result[len(classes)] = write(model, folder / f"{len(classes)}.osim")
            classes.append(name)
    return result, classes


@pytest.mark.parametrize("has_defaults", [False, True], ids=["", "after other defaults"])
def test_files_with_an_object_of_each_class(has_defaults, tmp_path):
    result, classes = in_new_process(write_all_classes, tmp_path, has_defaults)
    assert len(classes) > 120
    assert {"DeGrooteFregly2016Muscle", "Millard2012EquilibriumMuscle", "ExpressionBasedBushingForce"} <= set(classes)
    compare(result, tmp_path, lambda number: classes[number])


def test_only_contacts_are_spelled_out(tmp_path):
    model = opensim.Model(str(HUMAN))
    muscle = opensim.DeGrooteFregly2016Muscle()
    muscle.setName("muscle")
    muscle.thisown = False
    model.addForce(muscle)
    text = _live.to_bytes(model)[1].decode()
    one = re.search(r"<SmoothSphereHalfSpaceForce .*?</SmoothSphereHalfSpaceForce>", text, re.S)[0]
    assert "<constant_contact_force>" in one and "<hertz_smoothing>" in one
    one = re.search(r"<DeGrooteFregly2016Muscle .*?(/>|</DeGrooteFregly2016Muscle>)", text, re.S)[0]
    assert "optimal_force" not in one


def test_a_set_of_another_file_is_in_the_model_as_it_is_in_memory(tmp_path):
    for name in ("file_forceset.osim", "standalone_ForceSet.xml"):
        (tmp_path / name).write_bytes((FIXTURES / "format" / name).read_bytes())
    other = (tmp_path / "standalone_ForceSet.xml").read_bytes()
    model = opensim.Model(str(tmp_path / "file_forceset.osim"))
    opensim.SmoothSphereHalfSpaceForce.safeDownCast(model.getForceSet().get(0)).set_stiffness(54321.0)
    assert ocs.inspect(model)[0]["forces"][0]["parameters"]["stiffness"] == 54321.0
    assert (tmp_path / "standalone_ForceSet.xml").read_bytes() == other


def settings():
    """OpenSim's settings for the whole process, and the registered defaults of some classes."""
    own = opensim.OpenSimObject
    kinds = [own.getDefaultInstanceOfType(name) for name in ("Body", "ContactSphere", "SmoothSphereHalfSpaceForce")]
    values = [kind.getPropertyByIndex(index).toString() for kind in kinds for index in range(kind.getNumProperties())]
    return own.getSerializeAllDefaults(), opensim.IO.GetPrintOfflineDocuments(), values, [*map(marks_of, kinds)]


@pytest.mark.parametrize(("defaults", "offline"), [*itertools.product((False, True), repeat=2)])
def test_settings_are_as_before(defaults, offline, monkeypatch):
    model, unfinished = opensim.Model(str(HUMAN)), opensim.Model()
    frame = opensim.PhysicalOffsetFrame("frame", unfinished.getGround(), opensim.Transform())
    frame.thisown = False
    unfinished.addComponent(frame)
    opensim.OpenSimObject.setSerializeAllDefaults(defaults)
    opensim.IO.SetPrintOfflineDocuments(offline)
    try:
        before = settings()
        marks = marks_of(model)
        ocs.inspect(model)
        assert (settings(), marks_of(model)) == (before, marks)
        with pytest.raises(ocs.ContactScaleError, match="Call finalizeConnections"):
            ocs.inspect(unfinished)
        assert settings() == before
        monkeypatch.setattr(opensim.Model, "printToXML", lambda self, path: False)
        with pytest.raises(ocs.ContactScaleError, match="could not print this model"):
            ocs.inspect(model)
        assert settings() == before
    finally:
        opensim.OpenSimObject.setSerializeAllDefaults(False)
        opensim.IO.SetPrintOfflineDocuments(True)


def marks_of(owner):
    """The properties of an object, and of all in it, that no file and no call has set; and whether it counts as changed."""
    marks = [owner.isObjectUpToDateWithProperties()]
    for index in range(owner.getNumProperties()):
        own = owner.getPropertyByIndex(index)
        marks.append(own.getValueIsDefault())
        if own.isObjectProperty():
            marks += [marks_of(own.getValueAsObject(place)) for place in range(own.size())]
    return marks
