"""The vertical force of each contact force on the body of a model with one FreeJoint, with the body's origin at given heights; 0 if it is off."""

import os
from pathlib import Path

from apart import run_one_job
from opensim_forces import FIXED


def pressed(model, heights):
    """`[height]{name of the force: N}`; the caller's process stays free of OpenSim."""
    return run_one_job("opensim_shapes", [str(Path(model).absolute()), heights])


def run_job(job):
    """Computes the forces in this process."""
    import opensim

    path, heights = job
    os.chdir(Path(path).parent)  # OpenSim looks for meshes there
    model = opensim.Model(path)
    state = model.initSystem()
    up = model.getCoordinateSet().get(4)
    return [at_height(model, state, up, height) for height in heights]


def at_height(model, state, up, height):
    up.setValue(state, height)
    model.realizeDynamics(state)
    result = {}
    for k in range(model.getForceSet().getSize()):
        force = model.getForceSet().get(k)
        labels, values = force.getRecordLabels(), force.getRecordValues(state)
        names = [labels.get(place).split(".") for place in range(values.size())]
        of_body = [place for place, (_, on, *rest) in enumerate(names) if rest == ["force", "Y"] and on not in FIXED]
        result[force.getName()] = sum(values.get(place) for place in of_body) if force.appliesForce(state) else 0.0
    return result
