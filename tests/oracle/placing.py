"""Where contacts of a reference belong on another model, and with which numbers: the rules of `add` in NumPy.

Written from the rules alone. What a model's bones are comes from `opensim_anatomy.py`, what its contacts are from
`opensim_reads.py`; nothing here asks the program.

1. Factors given. 2. Mesh factors of the same bone. 3. In a scaled copy of the reference each axis by itself, from joint offsets.
4. Between different models one factor, the ratio of the distances from the body to a joint below it. 5. A last body takes those of the
body that it hangs on. Left and right use the same source.
"""

import re

import numpy as np

import rules

EXPLAINED = 1e-6  # m
NOTHING = 0.02  # m: a shorter distance says nothing
SIDE = re.compile(r"^[rl]_|_[rl]v?$")


class Unknown(Exception):
    """No mesh, joint or option determines the size of a body."""


def bone(file):
    """The bone of a mesh: its name without folder, ending, case and side."""
    name = file.replace("\\", "/").rsplit("/", 1)[-1].rsplit(".", 1)[0].lower()
    return SIDE.sub("", name)


def without_side(name):
    return re.sub(r"_[rl]$", "", name)


def other_side(name):
    return {"r": name[:-1] + "l", "l": name[:-1] + "r"}.get(name[-1]) if name[-2:-1] == "_" else None


def vector(text):
    return np.array([float.fromhex(one) for one in text])


def seen_from(anatomy, body, other, point):
    """A point of `other` in the frame of `body`, at the default pose."""
    ground = placed(anatomy, other, point)
    rows = np.array(anatomy["bodies"][body])
    return rows[:, :3].T @ (ground - rows[:, 3])


def placed(anatomy, body, point):
    """A point of a body in ground."""
    if body == "ground":
        return np.asarray(point, dtype=float)
    rows = np.array(anatomy["bodies"][body])
    return rows[:, :3] @ point + rows[:, 3]


def above(anatomy, body):
    """The joint that carries a body."""
    return next((joint for joint in anatomy["joints"] if joint["bodies"][1] == body), None)


def is_below(anatomy, joint, body):
    """Whether a joint hangs on `body`, through whatever lies between."""
    while joint is not None:
        if joint["bodies"][0] == body:
            return True
        joint = above(anatomy, joint["bodies"][0])
    return False


class Sizes:
    """The factors of a model's bodies against a reference."""

    def __init__(self, model, reference, given=None, is_copy=None):
        self.model, self.reference, self.given = model, reference, given or {}
        self.is_copy = self.explained() if is_copy is None else is_copy

    def mesh(self, body):
        """Ratio of the factors of the first mesh that shows the same bone; the same file before the same side."""
        there = [(file, factors) for owner, file, factors in self.reference["meshes"] if owner == body]
        for owner, file, new in self.model["meshes"]:
            if owner != body:
                continue
            known = [old for name, old in there if name == file] or [old for name, old in there if bone(name) == bone(file)]
            if known:
                return np.abs(np.array(new) / np.array(known[0]))
        return None

    def offsets(self, body):
        """`(old, new)` of the joints that both models have between the same bodies."""
        for joint in self.model["joints"]:
            for old in self.reference["joints"]:
                if old["name"] == joint["name"] and old["bodies"] == joint["bodies"]:
                    for end in (0, 1):
                        if joint["bodies"][end] == body:
                            yield np.array(old["places"][end]), np.array(joint["places"][end])

    def factors_from_offsets(self, body):
        """A factor for each axis; NaN where no offset says it. And whether they explain all offsets."""
        offsets = list(self.offsets(body))
        mesh = self.mesh(body)
        factors, fits = np.full(3, np.nan), True
        for axis in range(3):
            long = [(old[axis], new[axis]) for old, new in offsets if abs(old[axis]) > EXPLAINED]
            if long:
                old, new = max(long, key=lambda pair: abs(pair[0]))
                factors[axis] = new / old
            factor = factors[axis] if mesh is None else mesh[axis]
            factor = 1.0 if np.isnan(factor) else factor
            fits = fits and factor > 0 and all(abs(new[axis] - factor * old[axis]) <= EXPLAINED for old, new in offsets)
        return factors, fits

    def explained(self):
        """Whether the model is the reference, scaled: joints between the same bodies, all offsets explained."""
        both = set(self.model["bodies"]) & set(self.reference["bodies"])
        old = {joint["name"]: joint["bodies"] for joint in self.reference["joints"]}
        for joint in self.model["joints"]:
            there = old.get(joint["name"], joint["bodies"])
            if there != joint["bodies"] and (set(there) <= both or set(joint["bodies"]) <= both):
                return False
        return all(self.factors_from_offsets(body)[1] for body in both)

    def distance(self, body):
        """Ratio of the distances to the farthest joint of one name that is below the body in both, on it in one."""
        best = None
        for joint in self.model["joints"]:
            for old in self.reference["joints"]:
                if old["name"] != joint["name"] or body not in (old["bodies"][0], joint["bodies"][0]):
                    continue
                if not (is_below(self.reference, old, body) and is_below(self.model, joint, body)):
                    continue
                far = [
                    np.linalg.norm(seen_from(anatomy, body, one["bodies"][0], np.array(one["places"][0])))
                    for anatomy, one in ((self.model, joint), (self.reference, old))
                ]
                if min(far) >= NOTHING and (best is None or far[1] > best[1]):
                    best = far
        return None if best is None else np.full(3, best[0] / best[1])

    def sources(self, body):
        """The factors of a body from each source, in the order of the sources."""
        known = [("mesh", self.mesh(body))]
        known.append(("offsets", self.factors_from_offsets(body)[0]) if self.is_copy else ("distance", self.distance(body)))
        return {name: values for name, values in known if values is not None}

    def of(self, body):
        """The factors of a body along x, y and z."""
        if body in self.given:
            return np.array(self.given[body], dtype=float)
        own, other = self.sources(body), other_side(body)
        shared = {name: own[name] for name in own if name in self.sources(other)} if other in self.model["bodies"] else own
        if self.is_last(body) and not shared:
            return self.factors_from_parent(body)
        factors = np.full(3, np.nan)
        for values in (shared or own).values():
            factors = np.where(np.isnan(factors), values, factors)
        if np.isnan(factors).any():
            raise Unknown(body)
        return factors

    def is_last(self, body):
        """Whether no joint hangs on the body, in a model that is not a scaled copy."""
        return not self.is_copy and all(joint["bodies"][0] != body for joint in self.model["joints"])

    def factors_from_parent(self, body):
        """The factors of the parent body."""
        joint = above(self.model, body)
        if joint is None or joint["bodies"][0] == "ground":
            raise Unknown(body)
        return self.of(joint["bodies"][0])


def floor_of(anatomy):
    """The one half-space on ground that faces straight up, or None."""
    up = -np.array(anatomy["gravity"]) / np.linalg.norm(anatomy["gravity"])
    floors = [plane for plane in anatomy["half_spaces"] if plane["body"] == "ground"]
    floors = [plane for plane in floors if np.linalg.norm(np.array(plane["solid"]) + up) <= 1e-6]
    assert len(floors) <= 1, "several floors"
    return floors[0] if floors else None


def reference_contacts(reading):
    """A contact for each moving sphere that a force presses on a half-space, in the order of the forces."""
    planes = {plane["path"] for plane in reading["half_spaces"]}
    spheres = {sphere["path"]: sphere for sphere in reading["spheres"] if sphere["base"] not in reading["fixed"]}
    together = {}
    for force in reading["forces"]:
        together.setdefault(force["path"], set()).update(force["geometry"])
    for force in reading["forces"]:
        if not together[force["path"]] & planes:
            continue
        for path in force["geometry"]:
            if path in spheres:
                yield force, spheres[path]


def expected(reference, model, expected):
    """`{sphere: (body, place, radius, type, parameters)}` that the rules give.

    `reference` and `model` are pairs of reading and anatomy. `wanted` has the masses (`mass`, `reference_mass`), `radius` ("isometric",
    "follow" or metres), `given` factors, `body_map` and `is_copy`.
    """
    sizes = Sizes(model[1], reference[1], expected.get("given"), expected.get("is_copy"))
    mu = expected["mass"] / expected["reference_mass"]
    body_map, found = expected.get("body_map", {}), {}
    # A body that the reference has not takes the place of the first that is mapped to it.
    first = {taker: body for body, taker in reversed(body_map.items()) if taker not in reference[1]["bodies"]}
    for force, sphere in reference_contacts(reference[0]):
        body, place = sphere["base"].rsplit("/", 1)[-1], vector(sphere["centre_in_base"])
        taker = body_map.get(body, body)
        place = seen_from(reference[1], first.get(taker, taker), body, place) if taker != body else place
        body = taker
        factors, radius = sizes.of(body), float.fromhex(sphere["radius"])
        rule = expected.get("radius", "isometric")
        rho = {"isometric": rules.isometric(mu), "follow": np.cbrt(np.prod(factors))}.get(rule, rule)
        rho = rho if rule in ("isometric", "follow") else rule / radius
        numbers = {name: float.fromhex(value) for name, value in force["parameters"].items()}
        factor = rules.factors(mu, rho)
        for name in rules.scaled_properties(force["type"]):
            numbers[name] *= factor[name]
        found[sphere["name"]] = (body, place * factors, radius * rho, force["type"], numbers)
    return found
