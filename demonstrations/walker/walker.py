"""Walks of the planar walker: `python demonstrations/walker/walker.py STAGE ... --results FOLDER`

Stages: guess, grid, branch, mesh, random, sizes, figures; or all. Each stage is a run of `simulate.run`, with its models and
results in the folder, and leaves its table as CSV beside this program (`guess` leaves the good first guess there). With `--resume` it goes
on where it was stopped. docs/studies/walker.md says what was found.
"""

import argparse
from pathlib import Path

import contacts
import pandas as pd
from osim_contact_scale import simulate
from walk import HERE, climb, version, walk

GUESS = HERE / "guess.csv"
MESH = 25  # intervals; half of what the check of the mesh has
COARSE = 12  # intervals of the searches from random guesses
SEEDS = 2  # random guesses for each point of the grid
LENGTHS = (0.25, 4.0)
MOST_ITERATIONS = 3000
BRANCH_ITERATIONS = 300  # of each search on the branch: from a neighbour, most take 20 to 100
INTEGERS = ("converged", "iterations", "active_bounds", "searches", "converged_searches", "seed", "index")
LEFT_OUT = ("path", "rungs", "file", "sha256", "key", "error", "status")


def run(arguments, stage, points, function, settings, files=()):
    """Runs one stage: the function for all points."""
    results = simulate.run(
        points,
        simulate.Function(function, settings=settings, version=version(*files)),
        results=arguments.results / stage,
        scheduler=arguments.scheduler,
        workers=arguments.workers,
        resume=arguments.resume,
        progress=True,
    )
    if len(results.failures):
        print(results.failures[["key", "status", "error"]].to_string())
    return results


def write_table(table, stage):
    """The table of a stage, as it is kept beside this program: numbers with six digits, whole ones as they are."""
    table = table.drop(columns=[name for name in LEFT_OUT if name in table])
    for name in table.columns:
        if name.startswith(INTEGERS) and table[name].notna().all():
            table[name] = table[name].astype(int)
    table.to_csv(HERE / f"{stage}.csv", index=False, float_format="%.6g", lineterminator="\n")


def guess(arguments):
    """The walk that all others start from: that of the grid's middle, from the walk drawn by hand."""
    path = arguments.results / "models" / "guess.osim"
    contacts.middle(contacts.baseline(arguments.results / "models"), path)
    results = run(arguments, "guess", [{"path": str(path)}], walk, {"mesh": MESH, "start": "hand"})
    if not results.table["converged"].all():
        raise SystemExit("the walk drawn by hand did not lead to a solution")
    results.series(0).to_csv(GUESS, index=False, float_format="%.9g", lineterminator="\n")


def grid(arguments):
    """Panels A and B: 5 × 5 of stiffness and dissipation, from the good guess."""
    points = contacts.grid(arguments.results / "models")
    write_table(run(arguments, "grid", points, walk, {"mesh": MESH, "start": GUESS.name}, [GUESS]).table, "grid")


def branch(arguments):
    """The grid once more, on one branch of walks: from the middle to each point in steps of one point, each solution the next guess."""
    rows = grid_rows(arguments)
    stiffnesses = sorted({row["stiffness"] for row in rows})
    dissipations = sorted({row["dissipation"] for row in rows})
    paths = {(row["stiffness"], row["dissipation"]): row["path"] for row in rows}
    points = []
    for row in rows:
        ways = steps(stiffnesses, row["stiffness"]), steps(dissipations, row["dissipation"])
        passed = [(value, dissipations[len(dissipations) // 2]) for value in ways[0]]
        passed += [(row["stiffness"], value) for value in ways[1]]
        points.append({**row, "rungs": ";".join(paths[point] for point in passed[:-1])})
    settings = {"mesh": MESH, "start": GUESS.name, "max_iterations": BRANCH_ITERATIONS}
    results = run(arguments, "branch", points, climb, settings, [GUESS, *(Path(path) for path in paths.values())])
    write_table(results.table, "branch")


def steps(values, expected):
    """The values from the middle, which is left out, to the given one."""
    middle, place = len(values) // 2, values.index(expected)
    return values[middle + 1 : place + 1] if place > middle else values[place:middle][::-1]


def mesh(arguments):
    """The corners and the middle of the grid once more, and with twice the mesh."""
    rows = grid_rows(arguments)
    ends = [rows[place] for place in (0, 4, 12, 20, 24)]
    settings = {"mesh": MESH, "start": GUESS.name, "double": True}
    write_table(run(arguments, "mesh", ends, walk, settings, [GUESS]).table, "mesh")


def random(arguments):
    """Panel C: from random guesses."""
    rows = [{**row, "seed": seed} for seed in range(1, arguments.seeds + 1) for row in grid_rows(arguments)]
    settings = {"mesh": COARSE, "start": "random", "max_iterations": MOST_ITERATIONS}
    write_table(run(arguments, "random", rows, walk, settings).table, "random")


def sizes(arguments):
    """Computes one walk at three lengths."""
    rows = contacts.sizes(arguments.results / "models", LENGTHS)
    results = run(arguments, "sizes", rows, walk, {"mesh": MESH, "start": GUESS.name}, [GUESS])
    write_table(results.table, "sizes")
    curves = [
        results.series(place).assign(length=row["length"], contacts=row["contacts"]) for place, row in enumerate(rows)
    ]
    pd.concat(curves).to_csv(HERE / "sizes_curves.csv", index=False, float_format="%.6g", lineterminator="\n")
    # The search at each size begins with the guess that was drawn by hand.
    rescaled = [row for row in rows if row["contacts"] == "rescaled"]
    write_table(run(arguments, "sizes_by_hand", rescaled, walk, {"mesh": MESH, "start": "hand"}).table, "sizes_by_hand")


def grid_rows(arguments):
    """The grid's models as rows: path, index, and what is at the point."""
    manifest = Path(contacts.grid(arguments.results / "models").manifest)
    expected = ["index", "stiffness", "dissipation", "relative_indentation", "dimensionless_stiffness", "restitution"]
    # The committed tables have the shorter name.
    table = pd.read_csv(manifest).rename(columns={"relative_indentation_hertz": "relative_indentation"})
    return [
        {"path": str(manifest.parent / row["file"]), **{name: row[name] for name in expected}}
        for row in table.to_dict("records")
    ]


def figures(arguments):
    """Figures and tables of docs/studies/walker.md, from the tables beside this program."""
    import page
    from draw import draw_all

    for name, table in (("effort", page.least()), ("random_points", page.by_point(page.read("random")))):
        table.to_csv(HERE / f"{name}.csv", index=False, float_format="%.6g", lineterminator="\n")
    draw_all(HERE, arguments.figures)
    page.write(HERE.parents[1] / "docs" / "studies" / "walker.md")


STAGES = {
    "guess": guess,
    "grid": grid,
    "branch": branch,
    "mesh": mesh,
    "random": random,
    "sizes": sizes,
    "figures": figures,
}


def main():
    """Runs the stages of the command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stages", nargs="+", choices=[*STAGES, "all"])
    parser.add_argument("--results", type=Path, required=True, help="folder for models and results")
    parser.add_argument("--workers", type=int, default=None, help="walks at a time; all cores by default")
    parser.add_argument("--scheduler", default=None, help="address of a Dask scheduler, or here")
    parser.add_argument("--seeds", type=int, default=SEEDS, help="random guesses for each point of the grid")
    parser.add_argument("--resume", action="store_true", help="go on in a folder that has results")
    parser.add_argument(
        "--figures", type=Path, default=HERE.parents[1] / "docs" / "studies" / "walker", help="folder for the figures"
    )
    arguments = parser.parse_args()
    arguments.results = arguments.results.absolute()
    for stage in STAGES if "all" in arguments.stages else arguments.stages:
        STAGES[stage](arguments)


if __name__ == "__main__":
    main()
