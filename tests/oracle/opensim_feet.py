"""Places of the bodies and meshes of a model at the default pose, by OpenSim."""


def matrix(transform):
    """The 3 by 4 matrix of a SimTK::Transform."""
    rotation, origin = transform.R(), transform.p()
    return [[*(rotation.get(i, j) for j in range(3)), origin.get(i)] for i in range(3)]


def run_job(path):
    """The places, read in this process."""
    import opensim

    model = opensim.Model(path)
    state = model.initSystem()
    bodies = {body.getName(): matrix(body.getTransformInGround(state)) for body in model.getBodyList()}
    meshes = []
    for component in model.getComponentsList():
        if component.getConcreteClassName() != "Mesh":
            continue
        mesh = opensim.Mesh.safeDownCast(component)
        frame, factors = mesh.getFrame(), mesh.get_scale_factors()
        meshes.append(
            {
                "body": frame.findBaseFrame().getName(),
                "file": mesh.get_mesh_file(),
                "factors": [factors.get(k) for k in range(3)],
                "frame": matrix(frame.getTransformInGround(state)),
            }
        )
    gravity = model.get_gravity()
    gravity = [gravity.get(k) for k in range(3)]
    return {"bodies": bodies, "meshes": meshes, "gravity": gravity}
