"""Contact forces of whole models, moved up or down from the default pose.

A job is `[model, states]`, a state `{"up": metres, "speeds": seed or null, "fastest": speed}`: all bodies are moved along y by the one
coordinate that moves them so, and every free coordinate gets a speed drawn from the seed, up to the fastest in m/s or rad/s, or none.
The body stays where it was put: nothing is integrated.

Each state of each model gives `{"heights": {sphere: y of its centre}, "forces": {force path: {"label": value}}}`, the record of each
force without its name, in N and N m.
"""

import random

from apart import ask

KINDS = ("SmoothSphereHalfSpaceForce", "HuntCrossleyForce")


def shifted(jobs):
    """OpenSim's results in the states of each `(model, states)`."""
    return ask("opensim_shifts", [[str(model), states] for model, states in jobs])


def at(heights):
    """States at rest."""
    return [{"up": float(up), "speeds": None} for up in heights]


def moving(heights, fastest=1.0):
    """States in motion, each with speeds of its own."""
    return [{"up": float(up), "speeds": seed, "fastest": fastest} for seed, up in enumerate(heights)]


def run_job(job):
    """OpenSim's results in the states of one model, computed in this process."""
    import opensim

    path, states = job
    model = opensim.Model(path)
    state = model.initSystem()
    coordinates = list(model.getCoordinateSet().get(k) for k in range(model.getCoordinateSet().getSize()))
    components = list(model.getComponentsList())
    forces = [opensim.Force.safeDownCast(one) for one in components if one.getConcreteClassName() in KINDS]
    spheres = [opensim.ContactSphere.safeDownCast(one) for one in components if one.getConcreteClassName() == "ContactSphere"]
    up = vertical(model, state, coordinates, spheres)
    start = up.getValue(state)
    locked = {coordinate.getName(): coordinate.getLocked(state) for coordinate in coordinates}
    up.setLocked(state, False)
    result = []
    for one in states:
        up.setValue(state, start + one["up"], False)
        draw = random.Random(one["speeds"])
        for coordinate in coordinates:
            if not locked[coordinate.getName()]:
                speed = one["fastest"] * draw.uniform(-1, 1) if one["speeds"] is not None else 0.0
                coordinate.setSpeedValue(state, speed)
        model.realizeDynamics(state)
        result.append({"heights": heights(state, spheres), "forces": {force.getAbsolutePathString(): record(force, state) for force in forces}})
    return result


def heights(state, spheres):
    result = {}
    for sphere in spheres:
        place = sphere.getFrame().getTransformInGround(state).shiftFrameStationToBase(sphere.get_location())
        result[sphere.getName()] = place.get(1)
    return result


def record(force, state):
    """Labels without the force's name."""
    labels, values = force.getRecordLabels(), force.getRecordValues(state)
    return {labels.get(k).split(".", 1)[-1]: values.get(k) for k in range(values.size())}


def vertical(model, state, coordinates, spheres):
    """The coordinate that moves all spheres up by what it is changed."""
    model.realizePosition(state)
    before = heights(state, spheres)
    for coordinate in coordinates:
        was, locked = coordinate.getValue(state), coordinate.getLocked(state)
        coordinate.setLocked(state, False)
        coordinate.setValue(state, was + 0.1, False)
        model.realizePosition(state)
        moved = {name: y - before[name] for name, y in heights(state, spheres).items()}
        coordinate.setValue(state, was, False)
        coordinate.setLocked(state, locked)
        # Terrain stays.
        if any(abs(y) > 0.05 for y in moved.values()) and all(min(abs(y), abs(y - 0.1)) < 1e-12 for y in moved.values()):
            return coordinate
    raise ValueError("no coordinate moves the model up")
