"""A walk: the function that `simulate.run` calls for every model."""

import hashlib
import time
from pathlib import Path

import numpy as np
import pandas as pd
from guesses import at_random, by_hand, from_file, scaled, trajectory
from judge import active, cost_of_transport, distances
from model import GRAVITY, MASS, SIDES, SPHERES
from problem import bounds, control_name, coordinates, ipopt_options, solver, speed_name, study, torques, value_name

HERE = Path(__file__).resolve().parent
FAR = ("hand", "random")  # guesses that nothing was solved for
SOURCES = ("guesses.py", "judge.py", "model.py", "problem.py", "walk.py")


def version(*more):
    """What identifies this function in the key of a row: SHA-256 of the programs that it uses, and of further files."""
    digest = hashlib.sha256()
    for path in (*(HERE / name for name in SOURCES), *more):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def walk(path, mesh=30, start="hand", seed=None, length=1.0, double=False, max_iterations=3000):
    """Searches the walk of one model.

    Parameters
    ----------
    path : str
        The model.
    mesh : int
        Mesh intervals.
    start : str
        `"hand"`, `"random"` with a `seed`, or a file of CSV with a solution of length factor 1.
    length : float
        The model's factor of length.
    double : bool
        Search once more with twice the mesh intervals, from the solution.

    Returns
    -------
    numbers : dict
        `converged`, `effort` (without dimensions), `iterations`, `cpu_s`, and what `judge` finds. `effort` is that of the last iteration
        where it did not converge.
    series : dict
        Time, states, controls, and vertical forces under each foot over body weight.
    """
    guess, is_warm_start = scaled(starting(start, seed), length), start not in FAR
    numbers, series = solved(path, guess, mesh, length, max_iterations, is_warm_start)
    if double:
        finer, _ = solved(path, pd.DataFrame(series), 2 * mesh, length, max_iterations, is_warm_start=True)
        numbers |= {f"{name}_at_double_mesh": value for name, value in finer.items()}
    return numbers, {name: [float(value) for value in values] for name, values in series.items()}


def starting(start, seed=None):
    """The guess that `walk` calls `start`, for the length factor 1."""
    if start == "hand":
        return by_hand()
    return at_random(int(seed)) if start == "random" else from_file(HERE / start)


def solved(path, guess, mesh, length=1.0, max_iterations=3000, is_warm_start=False):
    """Numbers and series of a search from a guess, which may be near a solution."""
    problem = study(path, length)
    search = solver(problem, mesh, max_iterations=max_iterations)
    search.setGuess(trajectory(search, guess))
    wall, cpu = time.perf_counter(), time.process_time()
    with ipopt_options(is_warm_start):
        solution = problem.solve()
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    converged = solution.success()
    if not converged:
        solution.unseal()
    series = _series(solution)
    limits = bounds(length)
    series |= _forces(path, problem, solution, length)
    numbers = {
        "converged": int(converged),
        "effort": solution.getObjective(),
        "iterations": solution.getNumIterations(),
        "cpu_s": cpu,
        "wall_s": wall,
        "half_cycle_s": float(series["time_s"][-1]),
        "active_bounds": len(active(series, limits)),
        "nearest_bound": min(distances(series, limits).values()),
        "cost_of_transport": cost_of_transport(series, length),
        # One foot over a cycle: in half a cycle, the left foot does what the right one does in the other half.
        "peak_force_bw": max(max(series[f"force_{side}_bw"]) for side in SIDES),
    }
    return numbers, series


def _series(solution):
    result = {"time_s": np.array(solution.getTimeMat())}
    for name, path in coordinates().items():
        result[value_name(name)] = np.array(solution.getStateMat(f"{path}/value"))
        result[speed_name(name)] = np.array(solution.getStateMat(f"{path}/speed"))
    for name, path in torques().items():
        result[control_name(name)] = np.array(solution.getControlMat(path))
    return result


def _forces(path, problem, solution, length):
    """Vertical force of the ground on each foot, over body weight."""
    import opensim as osim

    model = osim.Model(str(path))
    model.initSystem()
    states = solution.exportToStatesTrajectory(problem.getProblem())
    weight = MASS * length**3 * GRAVITY
    result = {f"force_{side}_bw": [] for side in SIDES}
    contacts = {
        side: [
            osim.SmoothSphereHalfSpaceForce.safeDownCast(model.getComponent(f"/forceset/contact_{name}_{side}"))
            for name in SPHERES
        ]
        for side in SIDES
    }
    for index in range(states.getSize()):
        state = states.get(index)
        model.realizeVelocity(state)
        for side, forces in contacts.items():
            vertical = sum(force.getRecordValues(state).get(1) for force in forces)
            result[f"force_{side}_bw"].append(vertical / weight)
    return result


def climb(path, rungs, mesh=30, start="hand", seed=None, max_iterations=3000):
    """Searches a walk on the first of several models, and from there on one after the other.

    Parameters
    ----------
    path : str
        The last model.
    rungs : str
        Paths of those before it, with `;` between; empty: none, the search starts on the last model.

    Returns
    -------
    numbers : dict
        Those of the last model, with `iterations` and `cpu_s` of all searches together, and `searches` and `converged_searches`: a
        search that did not converge gives its last iteration to the next one.
    series : dict
        Of the last model.
    """
    paths = [*filter(None, rungs.split(";")), path]
    series = scaled(starting(start, seed), 1.0)
    iterations, cpu, converged, is_warm_start = 0, 0.0, 0, start not in FAR
    for rung in paths:
        numbers, series = solved(
            rung, pd.DataFrame(series), mesh, max_iterations=max_iterations, is_warm_start=is_warm_start
        )
        is_warm_start = bool(numbers["converged"])
        iterations += numbers["iterations"]
        cpu += numbers["cpu_s"]
        converged += numbers["converged"]
    total = {"iterations": iterations, "cpu_s": cpu, "searches": len(paths), "converged_searches": converged}
    return numbers | total, {name: [float(value) for value in values] for name, values in series.items()}
