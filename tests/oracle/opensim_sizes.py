"""Reads with the real OpenSim the numbers of a model that depend on its size.

`run_job(path)` gives mass and gravity, the longest distance between two joints of each body, and each number by class, object and
property. Nothing of it is ours but the names of the properties, which are OpenSim's.
"""

from apart import run_each_job

NUMBERS = (
    "max_isometric_force", "optimal_fiber_length", "tendon_slack_length", "max_contraction_velocity",
    "activation_time_constant", "deactivation_time_constant", "resting_length", "pcsa_force", "slack_length",
    "linear_stiffness", "damping_coefficient", "stiffness", "dissipation", "rest_length", "viscosity", "upper_stiffness",
    "lower_stiffness", "damping", "upper_limit", "lower_limit", "transition", "optimal_force",
)  # fmt: skip
TRIPLES = ("rotational_stiffness", "translational_stiffness", "rotational_damping", "translational_damping")


def read_sizes(paths):
    """Several models, each in a process of its own."""
    return run_each_job("opensim_sizes", [str(path) for path in paths])


def run_job(path):
    import opensim

    model = opensim.Model(path)
    state = model.initSystem()
    gravity = model.getGravity()
    result = {"mass": sum(body.getMass() for body in model.getBodyList()), "objects": []}
    result["gravity"] = sum(gravity.get(axis) ** 2 for axis in range(3)) ** 0.5
    result["inertia"] = {
        body.getName(): sum(body.get_inertia().get(axis) for axis in range(3)) for body in model.getBodyList()
    }
    result["distances"] = distances(opensim, model, state)
    for component in list(model.getComponentsList()):
        if opensim.Force.safeDownCast(component) is not None:
            result["objects"].append(described(opensim, model, component))
    return result


def described(opensim, model, force):
    """Class, name, whether its coordinate turns, and the numbers that it has."""
    numbers = {}
    for name in (*NUMBERS, *TRIPLES):
        if force.hasProperty(name):
            prop = force.getPropertyByName(name)
            if name in TRIPLES:
                concrete = getattr(opensim, force.getConcreteClassName()).safeDownCast(force)
                value = getattr(concrete, f"get_{name}")()
                numbers[name] = [value.get(axis) for axis in range(3)]
            else:
                numbers[name] = [opensim.PropertyHelper.getValueDouble(prop)]
    turns = None
    if force.hasProperty("coordinate"):
        name = opensim.PropertyHelper.getValueString(force.getPropertyByName("coordinate"))
        motion = model.getCoordinateSet().get(name).getMotionType()
        turns = {1: True, 2: False}.get(motion)
    return {"class": force.getConcreteClassName(), "name": force.getName(), "turns": turns, "numbers": numbers}


def distances(opensim, model, state):
    """The longest distance between two joints on each body."""
    model.realizePosition(state)
    places = {}
    joints = model.getJointSet()
    bodies = {body.getName() for body in model.getBodyList()}
    # A joint counts where it is between two bodies.
    for joint in (joints.get(index) for index in range(joints.getSize())):
        frames = [joint.getParentFrame(), joint.getChildFrame()]
        if all(frame.findBaseFrame().getName() in bodies for frame in frames):
            for frame in frames:
                origin = frame.findTransformInBaseFrame().p()
                place = tuple(origin.get(axis) for axis in range(3))
                places.setdefault(frame.findBaseFrame().getName(), []).append(place)
    apart = {}
    for body, found in places.items():
        longest = max(sum((a - b) ** 2 for a, b in zip(one, other, strict=True)) ** 0.5 for one in found for other in found)
        if longest > 0:
            apart[body] = longest
    return apart
