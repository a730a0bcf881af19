"""The contact forces of the real OpenSim in given states.

The model has bodies on PlanarJoints of the ground and forces, the k-th force for the k-th body. A state is a list with one
`[height, rate of the indentation]` for each body. All of them also slide along the ground at 1 m/s, which changes no
normal force and keeps Simbody from dividing 0 by 0: SmoothSphereHalfSpaceForce divides by the square root of
constant_contact_force plus the squared slip speed, even without friction, so that cf = 0 at no slip is NaN.

Each state gives a list of the vertical forces on the bodies, or of those along the ground (X).
"""

from pathlib import Path

from apart import run_one_job

SLIDE = 1.0  # m/s
FIXED = ("ground", "HalfSpace")  # in the records of HuntCrossleyForce and of SmoothSphereHalfSpaceForce


def forces(model, states, axis="Y"):
    """`[state][body]`, in N; the caller's process stays free of OpenSim."""
    return run_one_job("opensim_forces", [str(Path(model).absolute()), states, axis])


def run_job(job):
    """Computes the forces in this process."""
    import opensim

    path, states, axis = job
    model = opensim.Model(path)
    state = model.initSystem()
    joints, contacts = model.getJointSet(), model.getForceSet()
    places = [planar(joints.get(k)) for k in range(joints.getSize())]
    contacts = [contacts.get(k) for k in range(contacts.getSize())]
    assert len(places) == len(contacts)
    result = []
    for one in states:
        for (along, up), (height, rate) in zip(places, one, strict=True):
            along.setSpeedValue(state, SLIDE)
            up.setValue(state, height, False)
            up.setSpeedValue(state, -rate)
        model.realizeDynamics(state)
        result.append([along_axis(force, state, axis) for force in contacts])
    return result


def planar(joint):
    """The coordinates of a PlanarJoint along the ground and upwards."""
    import opensim

    joint = opensim.PlanarJoint.safeDownCast(joint)
    return [joint.get_coordinates(k) for k in (1, 2)]


def along_axis(force, state, axis):
    """The force on the moving body along an axis, out of the record of the forces and torques on both."""
    labels, values = force.getRecordLabels(), force.getRecordValues(state)
    words = [labels.get(k).split(".") for k in range(values.size())]
    (place,) = [k for k, (_, on, *rest) in enumerate(words) if rest == ["force", axis] and on not in FIXED]
    return values.get(place)
