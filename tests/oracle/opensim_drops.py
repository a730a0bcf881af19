"""Drops in the real OpenSim.

A drop is a body on a slider and a force for each of its spheres, all of them level:
`{"class", "mass", "gravity", "height", "accuracy", "times", "spheres": [{"radius", "stiffness", ...}]}`, in SI units.
Each drop gives `{"heights", "forces"}` at the given times, the forces summed.

Down is x, the side on which OpenSim's half-space is solid: so the slider needs no rotation, and its coordinate is the
indentation, with bottoms at -height in the beginning. `Manager` stops at each time asked for; nothing is interpolated.
"""

from apart import run_each_job

SMOOTH = "SmoothSphereHalfSpaceForce"


def drops(jobs):
    """`[{"heights", "forces"}]`; the caller's process stays free of OpenSim."""
    return run_each_job("opensim_drops", jobs)


def run_job(job):
    """Runs a drop in this process."""
    import opensim

    model, down = build(opensim, job)
    state = model.initSystem()
    down.setValue(state, -job["height"])
    manager = opensim.Manager(model)
    manager.setWriteToStorage(False)
    manager.setPerformAnalyses(False)
    manager.setIntegratorMethod(opensim.Manager.IntegratorMethod_RungeKuttaMerson)
    manager.setIntegratorAccuracy(job["accuracy"])
    manager.initialize(state)
    heights, forces = [], []
    for time in job["times"]:
        if time > 0:
            state = manager.integrate(time)
        model.realizeDynamics(state)
        heights.append(-down.getValue(state))
        forces.append(upward(model, state))
    return {"heights": heights, "forces": forces}


def build(opensim, job):
    """The model and its coordinate."""
    model = opensim.Model()
    model.set_gravity(opensim.Vec3(job["gravity"], 0, 0))
    body = opensim.Body("body", job["mass"], opensim.Vec3(0), opensim.Inertia(1))
    slider = opensim.SliderJoint("slider", model.getGround(), body)
    model.addBody(body)
    model.addJoint(slider)
    floor = opensim.ContactHalfSpace(opensim.Vec3(0), opensim.Vec3(0), model.getGround(), "floor")
    model.addContactGeometry(floor)
    for k, one in enumerate(job["spheres"]):
        place = opensim.Vec3(-one["radius"], 3 * k * one["radius"], 0)
        sphere = opensim.ContactSphere(one["radius"], place, body, f"sphere{k}")
        model.addContactGeometry(sphere)
        model.addForce((smooth if job["class"] == SMOOTH else hunt_crossley)(opensim, one, sphere, floor))
    return model, slider.updCoordinate()


def smooth(opensim, one, sphere, floor):
    """A SmoothSphereHalfSpaceForce without friction."""
    force = opensim.SmoothSphereHalfSpaceForce(f"contact_{sphere.getName()}", sphere, floor)
    force.set_stiffness(one["stiffness"])
    force.set_dissipation(one["dissipation"])
    force.set_static_friction(0)
    force.set_dynamic_friction(0)
    force.set_viscous_friction(0)
    force.set_constant_contact_force(one["constant_contact_force"])
    force.set_hertz_smoothing(one["hertz_smoothing"])
    force.set_hunt_crossley_smoothing(one["hunt_crossley_smoothing"])
    return force


def hunt_crossley(opensim, one, sphere, floor):
    """A HuntCrossleyForce without friction."""
    force = opensim.HuntCrossleyForce()
    force.setName(f"contact_{sphere.getName()}")
    force.addGeometry(floor.getName())
    force.addGeometry(sphere.getName())
    force.setStiffness(one["stiffness"])
    force.setDissipation(one["dissipation"])
    return force


def upward(model, state):
    """The force of all spheres on the body, against gravity."""
    total, forces = 0.0, model.getForceSet()
    for k in range(forces.getSize()):
        labels, values = forces.get(k).getRecordLabels(), forces.get(k).getRecordValues(state)
        words = [labels.get(i).split(".") for i in range(values.size())]
        (place,) = [i for i, (_, on, *rest) in enumerate(words) if rest == ["force", "X"] and on in ("body", "Sphere")]
        total -= values.get(place)
    return total
