"""Scale models with the real OpenSim.

A job is `{"model", "output", "factors": {body: [x, y, z]}, "mass"}`: `Model.scale` with a ScaleSet, preserving the mass
distribution; or `{"setup", "output"}`: the Scale Tool from a setup XML, run in the folder of `output`. Each job
gives the bodies' masses and, per sphere, the rotation of its frame in its body, row by row.
"""

import os
from pathlib import Path

from apart import run_one_job


def scaled(job):
    """The result of one job; the caller's process stays free of OpenSim."""
    return run_one_job("opensim_scales", job)


def run_job(job):
    """Runs a job in this process."""
    import opensim

    if "setup" in job:
        os.chdir(Path(job["output"]).parent)
        opensim.ScaleTool(job["setup"]).run()  # its answer is about markers
        return described(opensim, opensim.Model(job["output"]))
    model = opensim.Model(job["model"])
    state = model.initSystem()
    scales = opensim.ScaleSet()
    for body, factors in job["factors"].items():
        scale = opensim.Scale()
        scale.setSegmentName(body)
        scale.setScaleFactors(opensim.Vec3(*factors))
        scale.setApply(True)
        scales.cloneAndAppend(scale)
    if not model.scale(state, scales, True, job["mass"]):
        raise RuntimeError("Model.scale failed")
    model.printToXML(job["output"])
    scales.printToXML(job["output"] + ".scales.xml")
    return described(opensim, model)


def described(opensim, model):
    """Masses and the frames of spheres."""
    state = model.initSystem()
    model.realizePosition(state)
    bodies = model.getBodySet()
    result = {"bodies": {bodies.get(i).getName(): bodies.get(i).getMass() for i in range(bodies.getSize())}}
    result["rotations"] = {}
    for component in list(model.getComponentsList()):
        if component.getConcreteClassName() == "ContactSphere":
            frame = opensim.PhysicalFrame.safeDownCast(component.getConnectee("frame"))
            base = opensim.PhysicalFrame.safeDownCast(frame.findBaseFrame())
            # Where the frame's axes point in the body: the columns.
            axes = [opensim.Vec3(*(float(i == j) for i in range(3))) for j in range(3)]
            axes = [frame.expressVectorInAnotherFrame(state, axis, base) for axis in axes]
            rows = [[axis.get(i) for axis in axes] for i in range(3)]
            result["rotations"][component.getName()] = {"body": base.getName(), "rows": rows}
    return result
