"""Models for the tests of Drop and Stand, made with OpenSim alone; called in processes of their own."""

import os

RIGHT_ANGLE = 1.5707963267948966
KINDS = ("smooth", "hunt_crossley")


def quiet():
    import opensim

    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Off")
    return opensim


def level(source, target, spheres=True):
    """Writes a model whose half-spaces are turned by a whole right angle where it was nearly one (1.5708).

    With `spheres` these are moved up or down in their bodies, until their bottoms are as high as the first one's at the default pose.
    """
    opensim = quiet()
    model = opensim.Model(source)
    state = model.initSystem()
    model.realizePosition(state)
    components = list(model.getComponentsList())
    places = list(moved(opensim, components, state)) if spheres else []
    for sphere, place in places:
        sphere.set_location(opensim.Vec3(*place))
    for floor in map(opensim.ContactHalfSpace.safeDownCast, components):
        if floor is not None and abs(floor.get_orientation().get(2) + RIGHT_ANGLE) < 1e-4:
            floor.set_orientation(opensim.Vec3(0, 0, -RIGHT_ANGLE))
    model.printToXML(target)


def moved(opensim, components, state):
    """The spheres, each with its new place in its body."""
    expected = None
    for sphere in map(opensim.ContactSphere.safeDownCast, components):
        if sphere is not None:
            frame = sphere.getFrame().getTransformInGround(state)
            bottom = frame.shiftFrameStationToBase(sphere.get_location()).get(1) - sphere.getRadius()
            expected = bottom if expected is None else expected
            upright = [frame.R().asMat33().get(1, axis) for axis in range(3)]
            yield (
                sphere,
                [sphere.get_location().get(axis) + upright[axis] * (expected - bottom) for axis in range(3)],
            )


def write(target, change):
    """Writes a body of 10 kg with four spheres, changed in one way."""
    opensim = quiet()
    model = opensim.Model()
    model.setName("table")
    model.set_gravity(opensim.Vec3(0, -change.get("gravity", 9.81), 0))
    body = opensim.Body("body", 10, opensim.Vec3(0), opensim.Inertia(0.3, 0.4, 0.5))
    model.addBody(body)
    joint = {"free": opensim.FreeJoint, "pin": opensim.PinJoint}[change.get("joint", "free")]
    model.addJoint(joint("root", model.getGround(), body))
    if change.get("contacts", True):
        contacts(opensim, model, body, change)
    if change.get("driven"):
        drive(opensim, model, body)
    model.finalizeConnections()
    model.printToXML(os.fspath(target))


def contacts(opensim, model, body, change):
    on = body if change.get("floor_on") == "body" else model.getGround()
    turned = opensim.Vec3(0, 0, -RIGHT_ANGLE + change.get("tilt", 0.0))
    floor = opensim.ContactHalfSpace(opensim.Vec3(0), turned, on, "floor")
    model.addContactGeometry(floor)
    for number, (x, z) in enumerate([(0.2, 0.1), (0.2, -0.1), (-0.2, 0.1), (-0.2, -0.1)]):
        sphere = opensim.ContactSphere(change.get("radius", 0.03), opensim.Vec3(x, -0.25, z), body, f"sphere{number}")
        model.addContactGeometry(sphere)
        force = (smooth if change.get("kind", "smooth") == "smooth" else hunt_crossley)(opensim, sphere, floor, change)
        force.setName(f"contact{number}")
        force.set_appliesForce(change.get("applies", True))
        model.addForce(force)


def smooth(opensim, sphere, floor, change):
    force = opensim.SmoothSphereHalfSpaceForce("contact", sphere, floor)
    force.set_stiffness(change.get("stiffness", 3e5))
    force.set_dissipation(1.0)
    force.set_constant_contact_force(change.get("constant", 1e-5))
    return force


def hunt_crossley(opensim, sphere, floor, change):
    force = opensim.HuntCrossleyForce()
    force.addGeometry(floor.getName())
    force.addGeometry(sphere.getName())
    force.setStiffness(change.get("stiffness", 3e5))
    force.setDissipation(1.0)
    return force


def drive(opensim, model, body):
    """A second body on a hinge with a spring, and a torque that a controller asks for."""
    arm = opensim.Body("arm", 1, opensim.Vec3(0, 0.1, 0), opensim.Inertia(0.01))
    model.addBody(arm)
    none = opensim.Vec3(0)
    hinge = opensim.PinJoint("hinge", body, opensim.Vec3(0, 0.1, 0), none, arm, none, none)
    hinge.updCoordinate().setName("angle")
    model.addJoint(hinge)
    model.addForce(opensim.SpringGeneralizedForce("angle"))
    model.getForceSet().get(model.getForceSet().getSize() - 1).setName("spring")
    motor = opensim.CoordinateActuator("angle")
    motor.setName("motor")
    motor.setOptimalForce(5)
    model.addForce(motor)
    controller = opensim.PrescribedController()
    controller.setName("controller")
    controller.addActuator(motor)
    controller.prescribeControlForActuator("motor", opensim.Constant(1.0))
    model.addController(controller)


def locked_fall(path, lifting, height, times):
    """Heights of a coordinate over where it was, when OpenSim's own constraints lock all others; nothing of the tasks is used."""
    opensim = quiet()
    model = opensim.Model(path)
    state = model.initSystem()
    coordinates = model.getCoordinateSet()
    for place in range(coordinates.getSize()):
        coordinates.get(place).setLocked(state, coordinates.get(place).getName() != lifting)
    lift = coordinates.get(lifting)
    start = lift.getValue(state)
    lift.setValue(state, start + height, False)
    manager = opensim.Manager(model)
    manager.setIntegratorMethod(opensim.Manager.IntegratorMethod_RungeKuttaMerson)
    manager.setIntegratorAccuracy(1e-9)
    manager.initialize(state)
    return [height] + [lift.getValue(manager.integrate(time)) - start for time in times[1:]]
