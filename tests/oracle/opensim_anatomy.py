"""Reads with OpenSim where the parts of models are at the default pose.

Bodies in ground; meshes with the body that shows them and their scale factors; joints with the bodies at both ends and their
origins in the frames of these; coordinates; spheres and half-spaces in ground.
"""

from apart import ask
from opensim_feet import matrix
from opensim_reads import downcast_frame


def anatomies(paths):
    """The anatomy of each model, by its path."""
    paths = [str(path) for path in paths]
    return dict(zip(paths, ask("opensim_anatomy", paths), strict=True))


def run_job(path):
    """The anatomy of one model, read in this process."""
    import opensim

    model = opensim.Model(path)
    state = model.initSystem()
    result = {"bodies": {}, "meshes": [], "joints": [], "spheres": [], "half_spaces": []}
    for body in model.getBodyList():
        result["bodies"][body.getName()] = matrix(body.getTransformInGround(state))
    for component in model.getComponentsList():
        if component.getConcreteClassName() == "Mesh":
            mesh = opensim.Mesh.safeDownCast(component)
            factors = mesh.get_scale_factors()
            body = mesh.getFrame().findBaseFrame().getName()
            result["meshes"].append([body, mesh.get_mesh_file(), [factors.get(k) for k in range(3)]])
    for joint in model.getJointList():
        frames = [joint.getParentFrame(), joint.getChildFrame()]
        result["joints"].append(
            {
                "name": joint.getName(),
                "bodies": [frame.findBaseFrame().getName() for frame in frames],
                "places": [origin(matrix(frame.findTransformInBaseFrame())) for frame in frames],
            }
        )
    for component in model.getComponentsList():
        kind = component.getConcreteClassName()
        if kind not in ("ContactSphere", "ContactHalfSpace"):
            continue
        frame = downcast_frame(component.getConnectee("frame"))
        geometry = opensim.ContactGeometry.safeDownCast(component)
        here = {"name": component.getName(), "path": component.getAbsolutePathString()}
        here["body"] = frame.findBaseFrame().getName()
        at = frame.getTransformInGround(state).shiftFrameStationToBase(geometry.get_location())
        here["centre"] = [at.get(k) for k in range(3)]
        if kind == "ContactSphere":
            here["radius"] = opensim.ContactSphere.safeDownCast(component).getRadius()
            result["spheres"].append(here)
        else:
            outer, inner = matrix(frame.getTransformInGround(state)), matrix(geometry.getTransform())
            # Its side of +x.
            here["solid"] = [sum(row[k] * inner[k][0] for k in range(3)) for row in outer]
            result["half_spaces"].append(here)
    gravity = model.get_gravity()
    result["gravity"] = [gravity.get(k) for k in range(3)]
    result["mass"] = model.getTotalMass(state)
    result["coordinates"] = {one.getName(): one.getValue(state) for one in map(model.getCoordinateSet().get, range(model.getNumCoordinates()))}
    return result


def origin(rows):
    """The origin of a transform."""
    return [row[3] for row in rows]
