"""Solves one problem: `solve` returns numbers and writes the solution as a file of OpenSim."""

import contextlib
import os
import tempfile
import time
from pathlib import Path

import numpy as np
import opensim
from problem import GROUPS, solver, unit

# IPOPT keeps six steps for its picture of the second derivatives, and with six these searches wander. Moco has no setting for it, but IPOPT
# reads a file of options where it is started. What it writes there has the violation of constraints, which Moco does not give.
OPTIONS = "limited_memory_max_history 100\noutput_file found.txt\nfile_print_level 5\n"
# From a solution of a coarser mesh: a small barrier from the start, because a large one drives the search away from it.
WARM_START = "mu_strategy monotone\nmu_init 1e-5\n"
# From what should be a solution: it stays where it is, at its bounds, too.
THERE = "mu_strategy monotone\nmu_init 1e-7\nbound_push 1e-8\nbound_frac 1e-8\n"
GRAVITY = 9.80665  # m/s2


def solve(
    study, model, folder, size, mesh=15, most=400, guess=None, name="solution", terms=(), options="", tolerance=1e-3
):
    """Searches the walk.

    Parameters
    ----------
    study : MocoStudy
        The problem.
    model, folder : Path
        Its model, and where files go.
    size : sizes.Size
    mesh : int
        Mesh intervals.
    most : int
        Iterations after which the search is given up.
    guess : Path, optional
        A solution to start from; without it, the guess of the problem.
    name : str
        Of the solution's file.
    terms : sequence of str
        Parts of the cost that are given.
    options : str
        Further ones for IPOPT, a line each: `NEAR`, `THERE`, or a limit of time.
    tolerance : float
        Of convergence.

    Returns
    -------
    numbers : dict
        `solved` (what the solver says), `iterations`, `cpu_s`, `violation` (the largest of a constraint), `cost` with its parts, and what
        `judged` finds in the last iteration.
    series : dict
        The `curves` of the last iteration.
    """
    folder = Path(folder).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    search = solver(study, mesh, most, tolerance)
    if guess is not None:
        search.setGuessFile(str(Path(guess).absolute()))
    cpu = time.process_time()
    with _ipopt(options) as place:
        solution = study.solve()
        violation = _violation(place / "found.txt")
    cpu = time.process_time() - cpu
    solved = solution.success()
    if not solved:
        solution.unseal()
    solution.write(str(folder / f"{name}.sto"))
    numbers = {
        "solved": int(solved),
        "iterations": solution.getNumIterations(),
        "cpu_s": cpu,
        "violation": violation,
        "cost": solution.getObjective(),
        **{f"cost_{term}": solution.getObjectiveTerm(term) for term in terms},
    }
    series = curves(model, study, solution, size)
    return numbers | judged(series), series


def scaled(solution, target, size):
    """Writes a solution of the original as a guess for another size."""
    walk = opensim.MocoTrajectory(str(solution))
    walk.setTime(walk.getTimeMat() * size.time)
    for name in walk.getStateNames():
        walk.setState(name, walk.getStateMat(name) * unit(name, size))
    walk.write(str(target))
    return target


@contextlib.contextmanager
def _ipopt(options):
    """A folder of its own with the file of options, in which IPOPT is to be started."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "ipopt.opt").write_text(OPTIONS + options)
        os.chdir(folder)
        try:
            yield Path(folder)
        finally:
            os.chdir(before)


def _violation(solution):
    """The last violation of the constraints that IPOPT prints, in their units."""
    (line,) = [line for line in solution.read_text().splitlines() if line.startswith("Constraint violation")]
    return float(line.split()[-1])


def curves(model, study, solution, size):
    """A walk without dimensions: times, coordinates, forces over body weight, and depths over radii.

    Times are over those of the unscaled body, lengths over its lengths.
    """
    body = opensim.Model(str(model))
    state = body.initSystem()
    weight = body.getTotalMass(state) * GRAVITY
    states = solution.exportToStatesTrajectory(study.getProblem())
    result = {"time": np.array(solution.getTimeMat()) / size.time}
    for name in solution.getStateNames():
        if name.startswith("/jointset/") and name.endswith("/value"):
            result[name.split("/")[-2]] = np.array(solution.getStateMat(name)) / unit(name, size)
    contacts = {side: [_contact(body, name) for name in names] for side, names in GROUPS.items()}
    heights = {f"sole_{side}": [] for side in GROUPS}
    forces = {f"{axis}_{side}": [] for side in GROUPS for axis in ("along", "up")}
    depths = {f"depth_{side}": [] for side in GROUPS}
    for index in range(states.getSize()):
        now = states.get(index)
        body.realizeVelocity(now)
        for side, pairs in contacts.items():
            values = [force.getRecordValues(now) for force, _ in pairs]
            forces[f"along_{side}"].append(sum(value.get(0) for value in values) / weight)
            forces[f"up_{side}"].append(sum(value.get(1) for value in values) / weight)
            depths[f"depth_{side}"].append(max(_depth(sphere, now) for _, sphere in pairs))
            heights[f"sole_{side}"].append(min(_sole(body, side, size, now)) / size.length)
    return {name: np.asarray(values, dtype=float) for name, values in (result | forces | depths | heights).items()}


def _contact(body, name):
    force = opensim.SmoothSphereHalfSpaceForce.safeDownCast(body.getComponent(f"/{name}"))
    sphere = opensim.ContactSphere.safeDownCast(force.getConnectee("sphere"))
    return force, sphere


def _depth(sphere, state):
    """Depth of a sphere in the ground, over its radius; below 0: above it."""
    centre = sphere.getFrame().findStationLocationInGround(state, sphere.get_location())
    return 1 - centre.get(1) / sphere.getRadius()


# Lowest points of the unscaled spheres: where the sole is, whatever spheres a model has. m, in the axes of the heel bone, with their radii.
SOLE = (
    ((0.031307527581931796, 0.010435842527310599, 0.0), 0.035),
    ((0.17740932296428019, -0.015653763790965898, 0.0), 0.015),
)


def _sole(body, side, size, state):
    """Heights above ground of the sole's two ends, m: those of the spheres that would have grown with the foot."""
    foot = body.getBodySet().get(f"calcn_{side}")
    for centre, radius in SOLE:
        place = opensim.Vec3(*(value * size.length for value in centre))
        yield foot.findStationLocationInGround(state, place).get(1) - radius * size.length


def judged(series):
    """The largest force in body weights, the largest depth over radius, and the lowest sole over the unscaled body's lengths."""
    both_feet = np.concatenate([series["up_r"], series["up_l"]])
    return {
        "peak_force_bw": float(both_feet.max()),
        "deepest_x_over_r": float(max(series["depth_r"].max(), series["depth_l"].max())),
        "lowest_sole_m": float(min(series["sole_r"].min(), series["sole_l"].min())),
    }
