"""Moco's tracking problem, at any size: the published one, with every number that has dimensions given those of the size.

It is the first part of Moco's example2DWalking: half a stride of a reference walk, whose coordinates, speeds and ground reaction forces are
tracked, with little effort, and the second half the mirror image of the first. A size changes units and nothing else, so that cost,
weights and bounds are the same numbers without dimensions.
"""

import re
from pathlib import Path

import opensim

COORDINATES = "referenceCoordinates.sto"
FORCES = ("referenceGRF.xml", "referenceGRF.sto")
FILES = ("2D_gait.osim", COORDINATES, *FORCES)

END = 0.470089  # of half a stride, s: the filter resamples the reference, which then ends so
CUTOFF = 6.0  # of the reference's low-pass filter, Hz
EFFORT, TRACKING, GROUND_WEIGHT = 10.0, 1.0, 1.0  # weights
ROOT = "/jointset/groundPelvis/"
LENGTHS = (f"{ROOT}pelvis_tx", f"{ROOT}pelvis_ty")
DEGREE = 3.14159265358979 / 180
BOUNDS = {
    f"{ROOT}pelvis_tilt": (-20 * DEGREE, -10 * DEGREE),
    f"{ROOT}pelvis_tx": (0.0, 1.0),
    f"{ROOT}pelvis_ty": (0.75, 1.25),
    "/jointset/lumbar/lumbar": (0.0, 20 * DEGREE),
}
for _side in "lr":
    BOUNDS[f"/jointset/hip_{_side}/hip_flexion_{_side}"] = (-10 * DEGREE, 60 * DEGREE)
    BOUNDS[f"/jointset/knee_{_side}/knee_angle_{_side}"] = (-50 * DEGREE, 0.0)
    BOUNDS[f"/jointset/ankle_{_side}/ankle_angle_{_side}"] = (-15 * DEGREE, 25 * DEGREE)
SPEED = 50.0  # bound of every speed, rad/s or m/s: Moco's default
# Parts of its cost.
TERMS = ("state_tracking", "control_effort", "contact")
GROUPS = {side: [f"contact{place}_{side}" for place in ("Heel", "Front")] for side in "rl"}


def unit(path, size):
    """The unit of a state of this path, at this size: angles and activations have none."""
    length = size.length if path.startswith(LENGTHS) else 1.0
    return length / size.time if path.endswith("/speed") else length


def reference(folder, size):
    """The walk to track, as a table of coordinates: filtered at its own size, then given that of the body."""
    processor = opensim.TableProcessor(str(Path(folder) / COORDINATES))
    processor.append(opensim.TabOpLowPassFilter(CUTOFF))
    table = processor.process()
    labels = table.getColumnLabels()
    scaled = opensim.TimeSeriesTable()
    scaled.setColumnLabels(labels)
    scaled.addTableMetaDataString("inDegrees", "no")
    columns = [table.getDependentColumn(label).to_numpy() * unit(label, size) for label in labels]
    for time, *values in zip(table.getIndependentColumn(), *columns):
        scaled.appendRow(time * size.time, opensim.RowVector(values))
    return scaled


def ground_reaction(source, folder, size):
    """The forces to track, written at the body's size; the path of their ExternalLoads."""
    source, folder = Path(source), Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lines = (source / FORCES[1]).read_text().splitlines()
    start = 2 + next(index for index, line in enumerate(lines) if line.strip() == "endheader")
    rows = lines[start:]
    scaled = []
    for row in filter(None, rows):
        time, *forces = map(float, row.split())
        scaled.append("\t".join(f"{value:.17g}" for value in (time * size.time, *(f * size.mass for f in forces))))
    (folder / FORCES[1]).write_text("\n".join([*lines[:start], *scaled, ""]))
    (folder / FORCES[0]).write_bytes((source / FORCES[0]).read_bytes())
    return folder / FORCES[0]


def tracking(model, source, folder, size):
    """The MocoStudy for a model of this size.

    Parameters
    ----------
    model : Path
        The model.
    source : Path
        The folder with Moco's reference.
    folder : Path
        Where the reference of this size goes.
    size : sizes.Size
    """
    track = opensim.MocoTrack()
    track.setName("walk")
    processor = opensim.ModelProcessor(str(model))
    track.setModel(processor)
    track.setStatesReference(opensim.TableProcessor(reference(source, size)))
    track.set_states_global_tracking_weight(TRACKING / size.time)
    track.set_allow_unused_references(True)
    track.set_track_reference_position_derivatives(True)
    track.set_apply_tracked_states_to_guess(True)
    track.set_initial_time(0.0)
    track.set_final_time(END * size.time)
    study = track.initialize()
    problem = study.updProblem()
    names = state_names(processor)
    _track_without_dimensions(problem, names, size)
    problem.addGoal(symmetry(names))
    effort = opensim.MocoControlGoal.safeDownCast(problem.updGoal("control_effort"))
    effort.setWeight(EFFORT / size.time)
    problem.addGoal(_add_ground_goal(ground_reaction(source, folder, size), size))
    set_bounds(problem, size)
    return study


def state_names(processor):
    model = processor.process()
    model.initSystem()
    names = model.getStateVariableNames()
    return [names.get(index) for index in range(names.getSize())]


def _track_without_dimensions(problem, names, size):
    """An error of a coordinate or a speed counts by its square over that of its unit."""
    goal = opensim.MocoStateTrackingGoal.safeDownCast(problem.updGoal("state_tracking"))
    for name in names:
        if name.startswith("/jointset/"):
            goal.setWeightForState(name, unit(name, size) ** -2)


def symmetry(names):
    """Half a stride: what one side ends with, the other begins with; only the way forward goes on."""
    goal = opensim.MocoPeriodicityGoal("symmetry")
    for name in names:
        mirrored = re.sub(r"_([rl])(?=/|$)", lambda side: "_l" if side[1] == "r" else "_r", name)
        if mirrored != name:
            goal.addStatePair(opensim.MocoPeriodicityGoalPair(name, mirrored))
        elif name != f"{LENGTHS[0]}/value":
            goal.addStatePair(opensim.MocoPeriodicityGoalPair(name))
    goal.addControlPair(opensim.MocoPeriodicityGoalPair("/lumbarAct"))
    return goal


def _add_ground_goal(loads, size):
    """Forces of the ground in the plane; Moco divides the square of their error by body weight, so that a force is left."""
    goal = opensim.MocoContactTrackingGoal("contact", GROUND_WEIGHT / size.time / size.mass)
    goal.setExternalLoadsFile(str(loads))
    for side, name in (("r", "Right_GRF"), ("l", "Left_GRF")):
        forces = opensim.StdVectorString()
        for contact in GROUPS[side]:
            forces.append(f"/{contact}")
        goal.addContactGroup(forces, name)
    goal.setProjection("plane")
    goal.setProjectionVector(opensim.Vec3(0, 0, 1))
    return goal


def set_bounds(problem, size):
    for path, (low, high) in BOUNDS.items():
        value, speed = unit(path, size), SPEED * unit(f"{path}/speed", size)
        problem.setStateInfo(f"{path}/value", opensim.MocoBounds(low * value, high * value))
        problem.setStateInfo(f"{path}/speed", opensim.MocoBounds(-speed, speed))


def solver(study, mesh, most, tolerance=1e-3):
    """Moco's solver as all solutions have it: one thread, forward differences, variables scaled by their bounds."""
    moco_solver = opensim.MocoCasADiSolver.safeDownCast(study.updSolver())
    moco_solver.set_num_mesh_intervals(mesh)
    moco_solver.set_transcription_scheme("hermite-simpson")
    moco_solver.set_optim_finite_difference_scheme("forward")
    moco_solver.set_scale_variables_using_bounds(True)
    moco_solver.set_optim_convergence_tolerance(tolerance)
    moco_solver.set_optim_constraint_tolerance(1e-4)
    moco_solver.set_optim_max_iterations(most)
    moco_solver.set_parallel(0)
    return moco_solver
