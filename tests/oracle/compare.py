"""Compares the output of `inspect` with OpenSim's reading of a model, and a rescaled model with its plan."""

import math
import re
from collections import Counter

import rules

NOTE = re.compile(r"(; )?\[contacts made for [^\]]*\(osim-contact-scale [^\]]*\)\]$")
NO_CREDITS = "Frank Anderson, Peter Loan, Ayman Habib, Ajay Seth, Michael Sherman"  # what OpenSim prints where there are none
MASS_TOLERANCE = 1e-12  # OpenSim adds masses in another order than the file's


def hexed(value):
    """A JSON number in the form of OpenSim's reading (all bits); null means a number that is not finite."""
    return None if value is None else float(value).hex()


def readable(name):
    """A name as JSON can tell it: a byte that is not UTF-8 becomes `?` or U+FFFD."""
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "replace").replace("\ufffd", "?")


def finite(text):
    """OpenSim's bits as JSON can tell them."""
    return text if math.isfinite(float.fromhex(text)) else None


def by_place(entries):
    """`{(path, set): entry}`."""
    result = {(entry["path"], entry.get("set")): entry for entry in entries}
    assert len(result) == len(entries), "two entries of one path"
    return result


def ground_contacts(reading):
    """The forces `inspect` must know: those in which a moving sphere meets a half-space. Keys of `by_place`."""
    planes = {plane["path"] for plane in reading["half_spaces"]}
    spheres = {sphere["path"] for sphere in reading["spheres"] if sphere["base"] not in reading["fixed"]}
    together = {}
    for force in reading["forces"]:
        together.setdefault(force["path"], set()).update(force["geometry"])
    return {
        (force["path"], force["set"])
        for force in reading["forces"]
        if together[force["path"]] & planes and together[force["path"]] & spheres
    }


def inspect_equals_opensim(report, reading):
    """Every number `inspect` gives is OpenSim's, bit for bit; no ground contact is missing, none is invented."""
    ours, theirs = by_place(report["forces"]), by_place(reading["forces"])
    assert set(ours) <= set(theirs), f"forces OpenSim does not know: {set(ours) - set(theirs)}"
    assert ground_contacts(reading) <= set(ours), f"forces not listed: {ground_contacts(reading) - set(ours)}"
    spheres = {sphere["path"]: sphere for sphere in reading["spheres"]}
    for place, force in ours.items():
        other = theirs[place]
        assert (force["name"], force["type"], force["applies"]) == (other["name"], other["type"], other["applies"])
        numbers_equal(force["parameters"], other["parameters"], place)
        assert force["spheres"] == [spheres[path]["name"] for path in other["geometry"] if path in spheres], place
    listed = {sphere["path"]: sphere for sphere in report["spheres"]}
    assert set(listed) <= set(spheres), f"spheres OpenSim does not know: {set(listed) - set(spheres)}"
    used = {path for place in ours for path in theirs[place]["geometry"] if path in spheres}
    assert used <= set(listed), f"spheres not listed: {used - set(listed)}"
    for path, sphere in listed.items():
        sphere_equals(sphere, spheres[path])
        lowest_point_equals(sphere, spheres[path], reading)
    model_equals(report, reading)


def numbers_equal(ours, theirs, where):
    """Two dicts of parameters, name by name."""
    assert {name: hexed(value) for name, value in ours.items()} == {
        name: finite(text) for name, text in theirs.items()
    }, where


def sphere_equals(ours, theirs):
    """Radius, place and frame of a sphere."""
    if "radii" in theirs:  # an ellipsoid
        assert (ours["radius_m"], [hexed(value) for value in ours["radii_m"]]) == (None, theirs["radii"]), ours["path"]
    else:
        assert (hexed(ours["radius_m"]), "radii_m" in ours) == (finite(theirs["radius"]), False), ours["path"]
    assert [hexed(value) for value in ours["location_m"]] == [finite(text) for text in theirs["location"]], ours["path"]
    assert (ours["name"], ours["frame"]) == (theirs["name"], theirs["frame"])


def lowest_point_equals(ours, theirs, reading):
    """The sphere's centre in its body, less the radius along the axis nearest to the opposite of gravity (y for none)."""
    if theirs["centre_in_base"] is None or ours["lowest_point_m"] is None:
        return
    point = [float.fromhex(text) for text in theirs["centre_in_base"]]
    gravity = [float.fromhex(text) for text in reading["gravity"]]
    gravity = gravity if all(map(math.isfinite, gravity)) else [0.0, 0.0, 0.0]
    axis = max((1, 0, 2), key=lambda index: abs(gravity[index]))
    point[axis] += math.copysign(float.fromhex(theirs["radius"]), gravity[axis] if gravity[axis] else -1.0)
    for one, other in zip(ours["lowest_point_m"], point, strict=True):
        assert math.isclose(one, other, rel_tol=1e-14, abs_tol=1e-14), (ours["path"], ours["lowest_point_m"], point)


def model_equals(report, reading):
    """Name, the mass of each body, the total and the size of gravity."""
    assert report["name"].replace("\ufffd", "?") == readable(reading["name"])
    assert {body["path"]: hexed(body["mass_kg"]) for body in report["bodies"]} == {
        body["path"]: finite(body["mass"]) for body in reading["bodies"]
    }
    if report["mass_kg"] is None:
        said = {finding["code"] for finding in report["findings"]}
        assert said & {"mass-unknown", "loop-of-joints"}, "no mass, and not a word about it"
    else:
        mass_equals(report, reading)
    gravity = [float.fromhex(text) for text in reading["gravity"]]
    if all(map(math.isfinite, gravity)):
        assert math.isclose(report["gravity_m_s2"], math.hypot(*gravity), rel_tol=1e-15)
    else:
        assert report["gravity_m_s2"] is None


def mass_equals(report, reading):
    """The total with fixed bodies, as a plain sum and as OpenSim's system has it."""
    masses = {body["path"]: float.fromhex(body["mass"]) for body in reading["bodies"]}
    # A plate that carries the floor and no sphere, and that only ground is joined to, is no part of the body.
    plates = {plane["base"] for plane in reading["half_spaces"]} - {sphere["base"] for sphere in reading["spheres"]}
    apart = plates.intersection(reading["jointed_to_ground_alone"]).union(reading["uncounted"])
    weighed = report["mass_kg"] + sum(masses[path] for path in apart)
    assert math.isclose(weighed, float.fromhex(reading["mass_sum"]), rel_tol=MASS_TOLERANCE)
    if reading["total_mass"]:
        assert math.isclose(weighed, float.fromhex(reading["total_mass"]), rel_tol=MASS_TOLERANCE)


def plan(report):
    """`{(path, set, property): change}` of a run."""
    changes = report["changes"]
    planned = {(change["path"], change["set"], change["property"]): change for change in changes}
    assert len(planned) == len(changes), "one value is planned twice"
    return planned


def value(reading, place):
    """The value that OpenSim reads at a place of the plan, with all bits."""
    path, number, name = place
    if name == "radius":
        return next(sphere["radius"] for sphere in reading["spheres"] if sphere["path"] == path)
    return next(
        force["parameters"][name] for force in reading["forces"] if (force["path"], force["set"]) == (path, number)
    )


def plan_is_what_opensim_reads(planned, before, after):
    """OpenSim reads each `from` in the input and each `to` in the output, and nothing else has changed."""
    values_are_what_opensim_reads(planned, before, after)
    expected = Counter(
        (name, change["from"].hex(), change["to"].hex())
        for (_, _, name), change in planned.items()
        if change["from"] != change["to"]
    )
    assert differing_lines(before["dump"], after["dump"]) == expected


def values_are_what_opensim_reads(planned, before, after):
    """OpenSim reads each `from` in the input and each `to` in the output."""
    for place, change in planned.items():
        assert hexed(change["from"]) == value(before, place), f"from of {place}"
        assert hexed(change["to"]) == value(after, place), f"to of {place}"


def differing_lines(before, after):
    """The differences between two full prints of a model, as `(property, old, new)`; any other difference fails."""
    old, new = before.split("\n"), after.split("\n")
    assert len(old) == len(new), "the models' structures differ"
    element = re.compile(r"\s*<(\w+)>([^<]*)</\1>\s*")
    found = Counter()
    for one, other in zip(old, new):
        if one != other:
            left, right = element.fullmatch(one), element.fullmatch(other)
            assert left and right and left[1] == right[1], f"{one.strip()} became {other.strip()}"
            if left[1] == "credits" and only_the_note(left[2], right[2]):
                continue
            assert left[1] in rules.PROPERTIES, f"{left[1]} went from {left[2]} to {right[2]}"
            found[left[1], float(left[2]).hex(), float(right[2]).hex()] += 1
    return found


def only_the_note(old, new):
    """Whether credits differ by the note at their end, which replaces an earlier one; where there were none it is all of them."""
    rest = NOTE.sub("", new)
    return rest != new and rest in (NOTE.sub("", old), "" if old == NO_CREDITS else old)


def moving_spheres(reading, force_path):
    """The spheres of a force that move: terrain on ground or on bodies welded to it is never resized."""
    paths = {path for force in reading["forces"] if force["path"] == force_path for path in force["geometry"]}
    return [
        sphere for sphere in reading["spheres"] if sphere["path"] in paths and sphere["base"] not in reading["fixed"]
    ]


def expected(reading, mu, rho=None):
    """`{(path, set, property): value}` that the rule gives for an animal `mu` times as heavy, isometric unless told."""
    factor = rules.factors(mu, rules.isometric(mu) if rho is None else rho)
    expected = {}
    for force in reading["forces"]:
        if (force["path"], force["set"]) not in ground_contacts(reading):
            continue
        for name in rules.scaled_properties(force["type"]):
            expected[force["path"], force["set"], name] = float.fromhex(force["parameters"][name]) * factor[name]
        for sphere in moving_spheres(reading, force["path"]):
            expected[sphere["path"], None, "radius"] = float.fromhex(sphere["radius"]) * factor["radius"]
    return expected


def plan_follows_the_rule(planned, expected, before):
    """The plan holds the rule's values and no others; a value that stays as it is may be left out."""
    assert set(planned) <= set(expected), f"planned, but not of the rule: {set(planned) - set(expected)}"
    for place, number in expected.items():
        if place in planned:
            assert rules.close(planned[place]["to"], number), (place, planned[place]["to"], number)
        else:
            assert number == float.fromhex(value(before, place)), f"not planned: {place}"
