"""Contacts of the real OpenSim along a motion: where the spheres are, how they move, and the forces there.

A motion gives each coordinate, by `joint/coordinate`, its values; speeds are given, splined by OpenSim (`GCVSpline`), or 0. Coordinates
that a CoordinateCouplerConstraint makes depend on another are set as its own function says.
"""

import os
from pathlib import Path

import numpy as np
from apart import run_one_job

ANGULAR = ("FreeJoint", "BallJoint", "EllipsoidJoint")  # their speeds are angular velocities, not derivatives of angles


def coordinates(model):
    """`joint/coordinate`, its default and OpenSim's motion type for each coordinate of a model file."""
    return run_one_job("opensim_motion", ["coordinates", str(Path(model).absolute())])


def follow(model, times, values, speeds):
    """Spheres and forces in each frame; `values` has a list for each coordinate, and `speeds` too, or is "splined" or "rest"."""
    return run_one_job("opensim_motion", ["follow", str(Path(model).absolute()), list(times), values, speeds])


def needed(model, times, values, speeds, loads=None):
    """Generalized forces that OpenSim's inverse dynamics finds without acceleration, in each frame; with `loads`, an ExternalLoads file, for
    the contacts."""
    loads = loads and str(Path(loads).absolute())
    return run_one_job("opensim_motion", ["needed", str(Path(model).absolute()), list(times), values, speeds, loads])


def analysed(model, motion, folder):
    """The upward force of each contact along a motion file by OpenSim's AnalyzeTool: lists by the names of forces, with `time`."""
    return run_one_job("opensim_motion", ["analysed", str(model), str(motion), str(folder)])


def inverse_dynamics(model, motion, loads, folder):
    """Generalized forces along a motion file by OpenSim's InverseDynamicsTool, with an ExternalLoads file: lists by the names of columns."""
    return run_one_job("opensim_motion", ["inverse_dynamics", str(model), str(motion), str(loads), str(folder)])


def run_job(job):
    """Follows the motion in this process."""
    what, path, *rest = job
    jobs = {"coordinates": coordinates_here, "follow": follow_here, "needed": needed_here, "analysed": analysed_here,
            "inverse_dynamics": inverse_dynamics_here}
    return jobs[what](path, *rest)


def analysed_here(path, motion, folder):
    import opensim

    times = opensim.Storage(motion)
    tool = opensim.AnalyzeTool()
    tool.setName("analysed")
    tool.setModelFilename(path)
    tool.setCoordinatesFileName(motion)
    tool.setLowpassCutoffFrequency(-1)
    tool.setInitialTime(times.getFirstTime())
    tool.setFinalTime(times.getLastTime())
    tool.setResultsDir(folder)
    reporter = opensim.ForceReporter()
    reporter.setStepInterval(1)
    tool.getAnalysisSet().cloneAndAppend(reporter)
    setup = str(Path(folder) / "analysed.xml")
    tool.printToXML(setup)
    opensim.AnalyzeTool(setup).run()
    (found,) = Path(folder).glob("*ForceReporter_forces.sto")
    forces = opensim.TimeSeriesTable(str(found))
    upward = {label: list(forces.getDependentColumn(label).to_numpy()) for label in forces.getColumnLabels() if label.endswith("Sphere.force.Y")}
    return upward | {"time": list(forces.getIndependentColumn())}


def inverse_dynamics_here(path, motion, loads, folder):
    import opensim

    times = opensim.Storage(motion)
    tool = opensim.InverseDynamicsTool()
    tool.setModelFileName(path)
    tool.setCoordinatesFileName(motion)
    tool.setExternalLoadsFileName(loads)
    tool.setStartTime(times.getFirstTime())
    tool.setEndTime(times.getLastTime())
    excluded = opensim.ArrayStr()
    excluded.append("ALL")
    tool.setExcludedForces(excluded)
    tool.setResultsDir(folder)
    tool.setOutputGenForceFileName("needed.sto")
    setup = str(Path(folder) / "needed.xml")
    tool.printToXML(setup)
    answers = os.dup(1)
    os.dup2(2, 1)  # the tool prints about the model where the answer of this process belongs
    opensim.InverseDynamicsTool(setup).run()
    os.dup2(answers, 1)
    table = opensim.TimeSeriesTable(str(Path(folder) / "needed.sto"))
    return {label: list(table.getDependentColumn(label).to_numpy()) for label in table.getColumnLabels()}


def opened(path):
    import opensim

    model = opensim.Model(path)
    return model, model.initSystem()


def all_coordinates(model):
    for joint in model.getJointList():
        for place in range(joint.numCoordinates()):
            yield joint, joint.get_coordinates(place)


def coordinates_here(path):
    model, _ = opened(path)
    return [
        [f"{joint.getName()}/{coordinate.getName()}", coordinate.getDefaultValue(), coordinate.getMotionType()]
        for joint, coordinate in all_coordinates(model)
    ]


def follow_here(path, times, values, speeds):
    import opensim

    model, state = opened(path)
    found = list(all_coordinates(model))
    if speeds == "rest":
        speeds = {name: [0.0] * len(times) for name in values}
    elif speeds == "splined":
        speeds = {name: splined(times, values[name]) for name in values}
        rates_to_speeds(found, values, speeds)
    move = mover(model, state, values, speeds)
    forces = contact_forces(model)
    spheres = contact_spheres(model)
    frames = []
    for frame in range(len(times)):
        move(frame)
        model.realizeDynamics(state)
        frames.append({
            "spheres": {name: sphere_state(one, state) for name, one in spheres.items()},
            "forces": {force.getName(): record(force, state) for force in forces},
            "origins": {body.getName(): numbers(body.getPositionInGround(state)) for body in model.getBodyList()},
        })
    return frames


def mover(model, state, values, speeds):
    """A function that puts a state into a frame of a motion."""
    import opensim

    found = list(all_coordinates(model))
    joints = {f"{joint.getName()}/{coordinate.getName()}": coordinate for joint, coordinate in found}
    for coordinate in joints.values():
        # A recording moves what is locked or prescribed, too.
        coordinate.setLocked(state, False)
        coordinate.setIsPrescribed(state, False)
    couplers = list(all_couplers(model))
    along = opensim.StdVectorInt()
    along.append(0)

    def move(frame):
        for name, coordinate in joints.items():
            coordinate.setValue(state, values[name][frame], False)
            coordinate.setSpeedValue(state, speeds[name][frame])
        for _, function, scale, independent, dependent in couplers:
            at = opensim.Vector(1, independent.getValue(state))
            dependent.setValue(state, scale * function.calcValue(at), False)
            dependent.setSpeedValue(state, scale * function.calcDerivative(along, at) * independent.getSpeedValue(state))

    return move


def needed_here(path, times, values, speeds, loads):
    import os

    import opensim

    model = opensim.Model(path)
    if loads:
        os.chdir(Path(loads).parent)  # where its data file is
        for force in contact_forces(model):
            force.set_appliesForce(False)
        model.addModelComponent(opensim.ExternalLoads(loads, True))
    state = model.initSystem()
    move = mover(model, state, values, speeds)
    solver = opensim.InverseDynamicsSolver(model)
    frames = []
    for frame, time in enumerate(times):
        state.setTime(time)
        move(frame)
        model.realizeDynamics(state)
        forces = solver.solve(state, opensim.Vector(state.getNU(), 0.0))
        frames.append([forces.get(k) for k in range(forces.size())])
    return frames


CONTACTS = ("HuntCrossleyForce", "SmoothSphereHalfSpaceForce")


def numbers(vector):
    return [vector.get(k) for k in range(3)]


def splined(times, values):
    import opensim

    spline = opensim.GCVSpline()
    spline.setDegree(5)
    for time, value in zip(times, values, strict=True):
        spline.addPoint(time, value)
    along = opensim.StdVectorInt()
    along.append(0)
    return [spline.calcDerivative(along, opensim.Vector(1, time)) for time in times]


def rates_to_speeds(found, values, speeds):
    """Angular velocities where OpenSim's speeds are such, from derivatives of body-fixed angles about x, y and z."""
    joints = {joint.getName(): joint.getConcreteClassName() for joint, _ in found}
    for joint, kind in joints.items():
        if kind not in ANGULAR:
            continue
        names = [f"{joint}/{coordinate.getName()}" for one, coordinate in found if one.getName() == joint][:3]
        for frame in range(len(values[names[0]])):
            x, y, _ = (values[name][frame] for name in names)
            rates = [speeds[name][frame] for name in names]
            about_x = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
            about_y = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
            axes = np.column_stack([[1, 0, 0], about_x @ [0, 1, 0], about_x @ about_y @ [0, 0, 1]])
            for name, speed in zip(names, axes @ rates, strict=True):
                speeds[name][frame] = float(speed)


def all_couplers(model):
    import opensim

    by_name = {coordinate.getName(): coordinate for _, coordinate in all_coordinates(model)}
    constraints = model.getConstraintSet()
    for place in range(constraints.getSize()):
        coupler = opensim.CoordinateCouplerConstraint.safeDownCast(constraints.get(place))
        if coupler is None or not coupler.get_isEnforced():
            continue
        independent = coupler.getIndependentCoordinateNames().get(0)
        function = opensim.Function.safeDownCast(coupler.getPropertyByName("coupled_coordinates_function").getValueAsObject(0))
        yield (coupler, function, opensim.PropertyHelper.getValueDouble(coupler.getPropertyByName("scale_factor")), by_name[independent], by_name[coupler.getDependentCoordinateName()])


def contact_forces(model):
    import opensim

    result = []
    for component in model.getComponentsList():
        if component.getConcreteClassName() in CONTACTS:
            result.append(opensim.Force.safeDownCast(component))
    return result


def contact_spheres(model):
    import opensim

    result = {}
    for component in model.getComponentsList():
        sphere = opensim.ContactSphere.safeDownCast(component)
        if sphere is not None:
            result[sphere.getName()] = sphere
    return result


def sphere_state(sphere, state):
    frame, place = sphere.getFrame(), sphere.get_location()
    return [numbers(frame.findStationLocationInGround(state, place)), numbers(frame.findStationVelocityInGround(state, place))]


def record(force, state):
    """Force and torque on each body, in ground; the sphere of a SmoothSphereHalfSpaceForce is called `Sphere` there."""
    labels, values = force.getRecordLabels(), force.getRecordValues(state)
    result = {}
    for k in range(values.size()):
        body, what, axis = labels.get(k).split(".")[-3:]
        result.setdefault(body, {})[what, axis] = values.get(k)
    parts = [(what, axis) for what in ("force", "torque") for axis in "XYZ"]
    return {body: [one[part] for part in parts] for body, one in result.items()}
