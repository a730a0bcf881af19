"""Places of spheres, joints and floors at the default pose, by OpenSim."""


def vector(vec):
    """Three numbers of a SimTK::Vec3."""
    return [vec.get(k) for k in range(3)]


def run_job(path):
    """The places, read in this process."""
    import opensim

    model = opensim.Model(path)
    state = model.initSystem()
    spheres, floors = [], []
    geometries = model.getContactGeometrySet()
    for geometry in (geometries.get(index) for index in range(geometries.getSize())):
        frame = geometry.getFrame().getTransformInGround(state)
        at = vector(frame.shiftFrameStationToBase(geometry.get_location()))
        sphere = opensim.ContactSphere.safeDownCast(geometry)
        if sphere is not None:
            spheres.append({"name": sphere.getName(), "centre": at, "radius": sphere.getRadius()})
        elif opensim.ContactHalfSpace.safeDownCast(geometry) is not None:
            # The half-space is on the side of its x.
            outward = frame.xformFrameVecToBase(geometry.getTransform().xformFrameVecToBase(opensim.Vec3(-1, 0, 0)))
            floors.append({"at": at, "base": geometry.getFrame().findBaseFrame().getName(), "normal": vector(outward)})
    joints = {}
    for joint in model.getJointList():
        joints[joint.getName()] = vector(joint.getParentFrame().getTransformInGround(state).p())
    return {"spheres": spheres, "joints": joints, "floors": floors}
