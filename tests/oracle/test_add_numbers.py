"""Masses, counts, notes and names that `add` has to take into account, beside its places: what the real OpenSim reads of them."""

import pytest

import add_variants
import command
import dumps
import placing
import rules
from add_cases import HUMAN, PRESET
from test_add import contacts

TOLERANCE = 1e-12
NAMES = ("stiffness", "dissipation", "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing")


def model(folder, text=None):
    path = folder / "model.osim"
    path.write_text(text or add_variants.document(40000, "empty_sets"), encoding="utf-8")
    return path


def added(path, output, *options):
    outcome = command.run("add", path, *options, "-o", output)
    assert outcome.status == 0, outcome
    return output


def numbers(reading):
    """`{sphere: (radius, parameters)}`"""
    return {
        name: (float.fromhex(sphere["radius"]), {key: float.fromhex(value) for key, value in force["parameters"].items()})
        for name, (force, sphere) in contacts(reading).items()
    }


@pytest.mark.parametrize(
    "options, mass, share",
    [
        (("--mass", "90"), 90.0, 1.0),
        (("--mass", "0.02"), 0.02, 1.0),
        (("--spheres", "12"), 54.5, 0.5),
        (("--stance-limbs", "2"), 54.5, 0.5),
        (("--stance-limbs", "2", "--reference-spheres", "12"), 54.5, 1.0),
        (("--exclude-body", "pelvis"), 4.25, 1.0),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_masses_and_counts(options, mass, share, tmp_path, readings):
    """(10) with the mass and the count that are said; radii isometric; the note has the mass."""
    path = added(model(tmp_path), tmp_path / "added.osim", "--from", "falisse2022", *options)
    factor = rules.factors(mass / 62, rules.isometric(mass / 62), share)
    reference = numbers(readings[PRESET])
    for sphere, (radius, own) in numbers(readings[path]).items():
        assert radius == pytest.approx(reference[sphere][0] * factor["radius"], rel=TOLERANCE)
        for name in NAMES:
            assert own[name] == pytest.approx(reference[sphere][1][name] * factor[name], rel=TOLERANCE), (sphere, name)
    assert command.inspect(path).report["contacts_mass_kg"] == {"value": pytest.approx(mass, rel=1e-14), "source": "note"}


def test_a_reference_with_a_note_is_made_for_that_mass(tmp_path, readings):
    """The human of 62 kg with contacts for 124 kg: they lead to the same numbers as its own."""
    human, heavier = HUMAN / "human_62kg_smooth_sphere.osim", tmp_path / "heavier.osim"
    assert command.rescale(human, 124.0, heavier).status == 0
    factors = [f"--body-scale={part}_{side}=1.1" for part in ("calcn", "toes") for side in "rl"]
    path = model(tmp_path)
    one, two = (readings[added(path, tmp_path / f"{k}.osim", "--from", own, *factors)] for k, own in enumerate((human, heavier)))
    for sphere, (radius, own) in numbers(one).items():
        other = numbers(two)[sphere]
        assert radius == pytest.approx(other[0], rel=TOLERANCE)
        assert own == pytest.approx(other[1], rel=TOLERANCE)


TAKEN_NAMES = """<ForceSet>
	<objects>
		<PointActuator name="SmoothSphereHalfSpaceForce_s1_r"><body>pelvis</body></PointActuator>
	</objects>
</ForceSet>
<ContactGeometrySet>
	<objects>
		<ContactHalfSpace name="floor"><socket_frame>/ground</socket_frame><location>1 0 0</location><orientation>0 0 0</orientation></ContactHalfSpace>
		<ContactSphere name="s1_r"><socket_frame>/bodyset/pelvis</socket_frame><location>0 0 0</location><radius>0.1</radius></ContactSphere>
	</objects>
</ContactGeometrySet>
"""


def test_names_that_are_taken(tmp_path, readings):
    """A wall called floor, a sphere and a force of the reference's names: OpenSim would rename the second of each without a word."""
    text = add_variants.document(40000, "no_sets").replace("\t</Model>", f"{TAKEN_NAMES}\t</Model>")
    path = model(tmp_path, text)
    output, back = added(path, tmp_path / "added.osim", "--from", "falisse2022"), tmp_path / "back.osim"
    before, after = readings[path], readings[output]
    assert after["builds"]
    made = contacts(after)
    assert len(made) == 12 and "s1_r" not in made
    names = [one["name"] for kind in ("spheres", "half_spaces", "forces") for one in after[kind]]
    assert len(names) == len(set(names)) == 12 + 1 + 2 + 12
    # What OpenSim has renamed would not have the name that the report says.
    planned = {change["path"] for change in command.run("add", path, "--from", "falisse2022", "--dry-run").report["changes"]}
    assert planned == {one["path"] for force, sphere in made.values() for one in (force, sphere)}
    assert {one["path"] for one in before["spheres"]} <= {one["path"] for one in after["spheres"]}
    kinds = ("ContactSphere", "ContactHalfSpace", rules.SMOOTH_SET)
    old = {one["name"] for kind in ("spheres", "half_spaces") for one in before[kind]}
    assert dumps.without_elements(after["dump"], lambda tag, name: tag in kinds and name not in old) == dumps.without_elements(before["dump"], lambda *_: False)
    assert command.run("remove", output, "-o", back).status == 0
    assert back.read_bytes() == path.read_bytes()


def test_members_of_groups_are_renamed(tmp_path, readings):
    """A group of forces calls those that took the place of divided ones."""
    human = HUMAN / "human_500kg_hunt_crossley.osim"
    spheres = {}
    for force, sphere in placing.reference_contacts(readings[human]):
        spheres.setdefault(force["name"], []).append(sphere["name"])
    assert len(spheres) == 2
    text = human.read_text(encoding="utf-8")
    at = text.rindex("<groups />", 0, text.index("</ForceSet>"))
    group = f'<groups><ObjectGroup name="feet"><members> {" ".join(spheres)}</members></ObjectGroup></groups>'
    path, output = model(tmp_path, text[:at] + group + text[at + len("<groups />") :]), tmp_path / "converted.osim"
    assert command.run("convert", path, "--to", "smooth", "-o", output).status == 0
    reading = readings[output]
    members = dumps.parsed(reading["dump"]).findtext("ForceSet/groups/ObjectGroup/members").split()
    assert members == [f"{name}_{sphere}" for name, own in spheres.items() for sphere in own]
    assert members == [force["name"] for force in reading["forces"]]
