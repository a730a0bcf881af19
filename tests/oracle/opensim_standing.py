"""Contact forces of whole models in which coordinates have chosen values, and the masses that those move.

A job is `[model, standings]`, and a standing is `[coordinates, alone]`: `[joint, coordinate, value]` each, and the paths of spheres that press
alone while all others are taken a kilometre up, or null for all together. The rest of the model is at its default pose, nothing moves.

Each standing gives `{"forces": {force path: {body: size of the force on it in N}}, "moved": [mass in kg of the bodies that each coordinate moves],
"gravity": m/s2, "slopes": [cosine of the angle between up and the normal of each half-space]}`. At rest there is no friction: a contact
force is along the floor's normal.
"""

from apart import run_one_job
from opensim_feet import matrix

KINDS = ("SmoothSphereHalfSpaceForce", "HuntCrossleyForce")
FAR = 1000.0  # m


def all_standings(model, standings):
    """OpenSim's results for each `(coordinates, alone)` of one model."""
    return run_one_job("opensim_standing", [str(model), standings])


def run_job(job):
    """The standings of one model, computed in this process."""
    path, standings = job
    return [computed(path, values, alone) for values, alone in standings]


def computed(path, values, alone):
    """One standing, in a model that nothing was taken away from before."""
    import opensim

    model = opensim.Model(path)
    state = model.initSystem()
    if alone is not None:
        take_away(model, state, alone)
        state = model.initSystem()
    coordinates = [model.getCoordinateSet().get(k) for k in range(model.getNumCoordinates())]
    chosen = [found_by(coordinates, joint, name) for joint, name, _ in values]
    moved = [mass_moved(model, state, coordinate) for coordinate in chosen]
    for coordinate, (_, _, value) in zip(chosen, values, strict=True):
        coordinate.setValue(state, value, False)
    for coordinate in coordinates:
        if not coordinate.isConstrained(state):
            coordinate.setSpeedValue(state, 0.0)
    model.realizeDynamics(state)
    _, size = gravity_of(model)
    forces = [one for one in model.getComponentsList() if one.getConcreteClassName() in KINDS]
    result = {one.getAbsolutePathString(): record(opensim.Force.safeDownCast(one), state) for one in forces}
    return {"forces": result, "moved": moved, "gravity": size, "slopes": list(slopes(model, state))}


def found_by(coordinates, joint, name):
    """The coordinate of a joint: names that OpenSim makes come more than once. A joint without a name gets one from OpenSim."""
    called = [one for one in coordinates if one.getName() == name]
    (own,) = called if len(called) == 1 else [one for one in called if one.getJoint().getName() == joint]
    return own


def gravity_of(model):
    """The vector, and its size."""
    vector = [model.get_gravity().get(k) for k in range(3)]
    return vector, sum(part * part for part in vector) ** 0.5


def slopes(model, state):
    """The slope of each half-space, whose normal is -x of its frame."""
    import opensim

    gravity, size = gravity_of(model)
    for component in model.getComponentsList():
        if component.getConcreteClassName() == "ContactHalfSpace":
            geometry = opensim.ContactGeometry.safeDownCast(component)
            outer, inner = matrix(geometry.getFrame().getTransformInGround(state)), matrix(geometry.getTransform())
            solid = [sum(row[k] * inner[k][0] for k in range(3)) for row in outer]
            yield sum(gravity[k] * solid[k] for k in range(3)) / size


def take_away(model, state, alone):
    """Moves all spheres but those `alone` up, in their own frames."""
    import opensim

    gravity, size = gravity_of(model)
    up = opensim.Vec3(*[-FAR * part / size for part in gravity])
    model.realizePosition(state)
    for component in model.getComponentsList():
        if component.getConcreteClassName() != "ContactSphere" or component.getAbsolutePathString() in alone:
            continue
        geometry = opensim.ContactGeometry.safeDownCast(component)
        by = model.getGround().expressVectorInAnotherFrame(state, up, geometry.getFrame())
        place = geometry.get_location()
        geometry.set_location(opensim.Vec3(*[place.get(k) + by.get(k) for k in range(3)]))


def mass_moved(model, state, coordinate):
    """The mass of the bodies that a coordinate moves, kg."""
    before = places(model, state)
    was = coordinate.getValue(state)
    coordinate.setValue(state, was + 0.125, False)
    after = places(model, state)
    coordinate.setValue(state, was, False)
    moves = [name for name, place in before.items() if max(abs(a - b) for a, b in zip(place, after[name])) > 1e-3]
    return sum(body.getMass() for body in model.getBodyList() if body.getName() in moves)


def places(model, state):
    model.realizePosition(state)
    result = {}
    for body in model.getBodyList():
        place = body.getPositionInGround(state)
        result[body.getName()] = [place.get(k) for k in range(3)]
    return result


def record(force, state):
    """The size of the force on each body, N."""
    labels, values = force.getRecordLabels(), force.getRecordValues(state)
    parts = {}
    for k in range(values.size()):
        *_, body, kind, axis = labels.get(k).split(".")
        if kind == "force":
            # The force on a body stands there once for each surface of it.
            parts.setdefault(body, {})[axis] = values.get(k)
    return {body: sum(part * part for part in vector.values()) ** 0.5 for body, vector in parts.items()}
