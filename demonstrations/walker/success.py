"""How often a search from a random guess succeeds: `python demonstrations/walker/success.py --results FOLDER`

A solution counts if the solver says so, if searched once more with twice the mesh its effort and its largest force change by less than 2 %,
and if the walker, driven by its controls alone, stays near it for one step. At each stiffness so many seeds; each row goes to `success.csv`
beside this program as it comes, and a row that is there is not done again. At the end it prints counts with their confidence intervals.
"""

import argparse
import csv
import math
import time
from pathlib import Path

import contacts
import pandas as pd

HERE = Path(__file__).resolve().parent
TABLE = HERE / "success.csv"
MESH = 25
MOST = 1000  # iterations of a search
CHANGE = 0.02  # of effort and largest force, between the meshes
HOLDS = 0.05  # of the leg: how far the hips may be off in the forward simulation
ANGLES = 0.1  # rad: how far a joint may be off
POINTS = ("soft", "middle", "stiff")  # of the grid, with its dissipation of 1 s/m


def attempt(path, seed):
    """One search from a random guess, once more with twice the mesh, and forward from there: its row."""
    from walk import solved, starting

    begun = time.process_time()
    first, series = solved(path, starting("random", seed), MESH, max_iterations=MOST)
    row = {
        "solved": first["converged"],
        "iterations": first["iterations"],
        "effort": first["effort"],
        "peak_force_bw": first["peak_force_bw"],
    }
    if first["converged"]:
        finer, series = solved(path, pd.DataFrame(series), 2 * MESH, max_iterations=MOST, near=True)
        row |= {
            "solved_twice": finer["converged"],
            "effort_change": first["effort"] / finer["effort"] - 1,
            "force_change": first["peak_force_bw"] / finer["peak_force_bw"] - 1,
            "held": forward(path, series),
        }
    return row | {"cpu_s": time.process_time() - begun}


def forward(path, series):
    """The share of the step for which the walker stays near a solution without its solver."""
    import opensim
    from model import LEG
    from problem import control_name, coordinates, speed_name, torques, value_name

    walker = opensim.Model(str(path))
    controller = opensim.PrescribedController()
    for name, where in torques().items():
        line = opensim.PiecewiseLinearFunction()
        for at, value in zip(series["time_s"], series[control_name(name)]):
            line.addPoint(float(at), float(value))
        controller.addActuator(opensim.Actuator.safeDownCast(walker.updComponent(where)))
        controller.prescribeControlForActuator(where.split("/")[-1], line)
    walker.addController(controller)
    state = walker.initSystem()
    for name, where in coordinates().items():
        walker.setStateVariableValue(state, f"{where}/value", float(series[value_name(name)][0]))
        walker.setStateVariableValue(state, f"{where}/speed", float(series[speed_name(name)][0]))
    manager = opensim.Manager(walker)
    manager.setIntegratorAccuracy(1e-6)
    manager.initialize(state)
    for index, at in enumerate(series["time_s"][1:], start=1):
        now = manager.integrate(float(at))
        for name, where in coordinates().items():
            off = abs(walker.getStateVariableValue(now, f"{where}/value") - series[value_name(name)][index])
            if not off < (HOLDS * LEG if name in ("forward", "up") else ANGLES):
                return float(series["time_s"][index - 1] / series["time_s"][-1])
    return 1.0


def succeeded(row):
    """The two counts of a row: by the solver and the finer mesh, and by the forward simulation, too."""
    mesh = int(row["solved"]) == 1 and row["solved_twice"] == "1"
    mesh = mesh and all(abs(float(row[name])) < CHANGE for name in ("effort_change", "force_change"))
    return mesh, mesh and float(row["held"]) == 1.0


def wilson(count, total, z=1.959963984540054):
    """Wilson's confidence interval of a share, 95 %.

    >>> [round(end, 4) for end in wilson(15, 20)]
    [0.5313, 0.8881]
    """
    share, square = count / total, z * z / total
    middle = (share + square / 2) / (1 + square)
    half = z / (1 + square) * math.sqrt(share * (1 - share) / total + square / (4 * total))
    return middle - half, middle + half


def read():
    """The rows that are there."""
    if not TABLE.exists():
        return []
    with open(TABLE, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


COLUMNS = (
    "point",
    "seed",
    "solved",
    "iterations",
    "effort",
    "peak_force_bw",
    "solved_twice",
    "effort_change",
    "force_change",
    "held",
    "cpu_s",
)


def append(row):
    begun = TABLE.exists()
    with open(TABLE, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n", restval="")
        if not begun:
            writer.writeheader()
        writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()})


def summary(rows):
    """For each point: searches, those that the solver calls solved, and both counts, with intervals."""
    yield "|contacts|guesses|solved|and the same at twice the mesh|and holds for a step|"
    yield "|---|---|---|---|---|"
    for point in POINTS:
        own = [row for row in rows if row["point"] == point]
        if own:
            counts = [sum(int(row["solved"]) for row in own), *(sum(column) for column in zip(*map(succeeded, own)))]
            yield f"|{point}|{len(own)}|{'|'.join(_share(count, len(own)) for count in counts)}|"


def _share(count, total):
    low, high = wilson(count, total)
    return f"{count} ({100 * low:.0f} to {100 * high:.0f} %)"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", type=Path, required=True, help="folder for the models")
    parser.add_argument("--seeds", type=int, default=20, help="random guesses at each stiffness")
    parser.add_argument("--points", nargs="+", choices=POINTS, default=list(POINTS))
    given = parser.parse_args()
    manifest = Path(contacts.grid(given.results.absolute() / "models", dissipations=(1.0,)).manifest)
    table = pd.read_csv(manifest).sort_values("stiffness")
    files = [str(manifest.parent / file) for file in table["file"]]
    paths = dict(zip(POINTS, (files[0], files[len(files) // 2], files[-1])))
    for seed in range(1, given.seeds + 1):
        for point in given.points:
            if not any((row["point"], row["seed"]) == (point, str(seed)) for row in read()):
                append({"point": point, "seed": seed, **attempt(paths[point], seed)})
    print("\n".join(summary(read())))


if __name__ == "__main__":
    main()
