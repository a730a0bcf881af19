"""The walk as an optimal control problem: half a cycle at a given speed, with as little effort per distance as possible.

All numbers are those of the walker of length factor 1; `length` gives them the dimensions of another size, so that the problem
stays the same one: lengths grow with it, times and speeds with its square root, angles and controls stay.
"""

import contextlib
import math
import os
import tempfile
from pathlib import Path

import opensim as osim
from model import GRAVITY, JOINTS, LEG, LIMITS, MASS, SIDES, TORQUE

SPEED = 1.2  # m/s; a Froude number v²/(g × leg) of 0.16
# IPOPT keeps six steps for its picture of the second derivatives, and with six these searches wander. Moco has no setting for it, but IPOPT
# reads a file of options where it is started.
IPOPT_OPTIONS = "limited_memory_max_history 200\n"
# From a solution that was found before: a small barrier from the start, because a large one drives the search away from the guess.
IPOPT_NEAR = "mu_strategy monotone\nmu_init 1e-6\n"
TIMES = (0.2, 1.4)  # of half a cycle, s
BEYOND = 0.4  # how far a joint may go beyond its limits, rad: never reached, because it pushes back
RATE = 20.0  # of a joint, rad/s
ROOT = {"tilt": (-0.8, 0.8), "forward": (-0.3, 2.0), "up": (0.5, 1.2)}  # rad, m, m
ROOT_SPEEDS = {"tilt": (-10.0, 10.0), "forward": (-1.0, 4.0), "up": (-3.0, 3.0)}


def coordinates():
    """Names of the coordinates with their paths in the model."""
    paths = {name: f"/jointset/root/{name}" for name in ROOT}
    return paths | {f"{joint}_{side}": f"/jointset/{joint}_{side}/{joint}_{side}" for joint in JOINTS for side in SIDES}


def torques():
    """Names of the joints with the paths of their torques in the model."""
    return {f"{joint}_{side}": f"/forceset/torque_{joint}_{side}" for joint in JOINTS for side in SIDES}


def bounds(length=1.0):
    """Lower and upper bound of every state, control and of the time, by what it is called in a solution's series."""
    root = math.sqrt(length)
    result = {"time_s": tuple(root * time for time in TIMES)}
    for name in coordinates():
        joint = name.split("_")[0]
        if name in ROOT:
            size, rate = (1.0, 1 / root) if name == "tilt" else (length, root)
            result[value_name(name)] = tuple(size * bound for bound in ROOT[name])
            result[speed_name(name)] = tuple(rate * bound for bound in ROOT_SPEEDS[name])
        else:
            low, high = LIMITS[joint]
            result[value_name(name)] = (low - BEYOND, high + BEYOND)
            result[speed_name(name)] = (-RATE / root, RATE / root)
    return result | {control_name(name): (-1.0, 1.0) for name in torques()}


def value_name(coordinate):
    """The name of a coordinate's value in a series."""
    return f"{coordinate}_m" if coordinate in ("forward", "up") else f"{coordinate}_rad"


def speed_name(coordinate):
    """The name of a coordinate's speed in a series."""
    return f"{coordinate}_m_s" if coordinate in ("forward", "up") else f"{coordinate}_rad_s"


def control_name(joint):
    """The name of a torque's control in a series; 1 is `model.TORQUE` × length⁴."""
    return f"{joint}_control"


def effort_weight(length=1.0):
    """What makes the integral of squared controls, over the distance, the effort.

    effort = 100 √(g l) / distance × ∫ Σ (torque / (M g l))² dt, with l the length of the leg: without dimensions.
    """
    unit = TORQUE / (MASS * GRAVITY * LEG)
    return 100 * unit**2 * math.sqrt(GRAVITY * LEG * length)


def study(path, length=1.0):
    """The problem for the model at this path.

    Returns
    -------
    opensim.MocoStudy
        Without a solver.
    """
    moco_study = osim.MocoStudy()
    problem = moco_study.updProblem()
    problem.setModelProcessor(osim.ModelProcessor(str(path)))
    problem.addGoal(_symmetry())
    speed = osim.MocoAverageSpeedGoal("speed")
    speed.set_desired_average_speed(SPEED * math.sqrt(length))
    problem.addGoal(speed)
    effort = osim.MocoControlGoal("effort", effort_weight(length))
    effort.setDivideByDisplacement(True)
    problem.addGoal(effort)
    _set_bounds(problem, bounds(length))
    return moco_study


def solver(study, mesh, scheme="hermite-simpson", convergence=1e-3, constraints=1e-4, max_iterations=3000):
    """Moco's solver with CasADi and IPOPT, as all solutions have it.

    Forward differences: central ones take two to three times as long for each iteration, and found the same solution.
    """
    moco_solver = study.initCasADiSolver()
    moco_solver.set_num_mesh_intervals(mesh)
    moco_solver.set_transcription_scheme(scheme)
    moco_solver.set_multibody_dynamics_mode("explicit")
    moco_solver.set_optim_finite_difference_scheme("forward")
    moco_solver.set_scale_variables_using_bounds(True)
    moco_solver.set_optim_convergence_tolerance(convergence)
    moco_solver.set_optim_constraint_tolerance(constraints)
    moco_solver.set_optim_max_iterations(max_iterations)
    moco_solver.set_parallel(0)
    moco_solver.set_verbosity(0)
    return moco_solver


@contextlib.contextmanager
def ipopt_options(is_warm_start=False):
    """An empty folder with the file of options, in which IPOPT is to be started; `is_warm_start`: for a guess that is near a solution."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "ipopt.opt").write_text(IPOPT_OPTIONS + IPOPT_NEAR * is_warm_start)
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


def _symmetry():
    """Half a cycle later the left side does what the right side did, and the other way round; only `forward` has moved on."""
    goal = osim.MocoPeriodicityGoal("symmetry")
    for name, path in coordinates().items():
        for what in ("value", "speed"):
            if (name, what) != ("forward", "value"):
                goal.addStatePair(_pair(f"{path}/{what}", f"{coordinates()[_mirrored(name)]}/{what}"))
    for name, path in torques().items():
        goal.addControlPair(_pair(path, torques()[_mirrored(name)]))
    return goal


def _pair(first, second):
    return osim.MocoPeriodicityGoalPair(first, second) if first != second else osim.MocoPeriodicityGoalPair(first)


def _mirrored(name):
    joint, _, side = name.partition("_")
    return f"{joint}_{'l' if side == 'r' else 'r'}" if side else name


def _set_bounds(problem, limits):
    problem.setTimeBounds(osim.MocoInitialBounds(0), osim.MocoFinalBounds(*limits["time_s"]))
    for name, path in coordinates().items():
        value = osim.MocoBounds(*limits[value_name(name)])
        if name == "forward":
            problem.setStateInfo(f"{path}/value", value, osim.MocoInitialBounds(0))
        else:
            problem.setStateInfo(f"{path}/value", value)
        problem.setStateInfo(f"{path}/speed", osim.MocoBounds(*limits[speed_name(name)]))
    for name, path in torques().items():
        problem.setControlInfo(path, osim.MocoBounds(*limits[control_name(name)]))
