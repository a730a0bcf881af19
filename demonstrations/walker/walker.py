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


def run(given, stage, points, function, settings, files=()):
    """One stage: all points through the function."""
    done = simulate.run(
        points,
        simulate.Function(function, settings=settings, version=version(*files)),
        results=given.results / stage,
        scheduler=given.scheduler,
        workers=given.workers,
        resume=given.resume,
        progress=True,
    )
    if len(done.failures):
        print(done.failures[["key", "status", "error"]].to_string())
    return done


def write_table(table, stage):
    """The table of a stage, as it is kept beside this program: numbers with six digits, whole ones as they are."""
    table = table.drop(columns=[name for name in LEFT_OUT if name in table])
    for name in table.columns:
        if name.startswith(INTEGERS) and table[name].notna().all():
            table[name] = table[name].astype(int)
    table.to_csv(HERE / f"{stage}.csv", index=False, float_format="%.6g", lineterminator="\n")


def guess(given):
    """The walk that all others start from: that of the grid's middle, from the walk drawn by hand."""
    path = given.results / "models" / "guess.osim"
    contacts.middle(contacts.baseline(given.results / "models"), path)
    done = run(given, "guess", [{"path": str(path)}], walk, {"mesh": MESH, "start": "hand"})
    if not done.table["converged"].all():
        raise SystemExit("the walk drawn by hand did not lead to a solution")
    done.series(0).to_csv(GUESS, index=False, float_format="%.9g", lineterminator="\n")


def grid(given):
    """Panels A and B: 5 × 5 of stiffness and dissipation, from the good guess."""
    points = contacts.grid(given.results / "models")
    write_table(run(given, "grid", points, walk, {"mesh": MESH, "start": GUESS.name}, [GUESS]).table, "grid")


def branch(given):
    """The grid once more, on one branch of walks: from the middle to each point in steps of one point, each solution the next guess."""
    rows = grid_rows(given)
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
    done = run(given, "branch", points, climb, settings, [GUESS, *(Path(path) for path in paths.values())])
    write_table(done.table, "branch")


def steps(values, wanted):
    """From the middle of the values, without it, to the wanted one."""
    middle, place = len(values) // 2, values.index(wanted)
    return values[middle + 1 : place + 1] if place > middle else values[place:middle][::-1]


def mesh(given):
    """The corners and the middle of the grid once more, and with twice the mesh."""
    rows = grid_rows(given)
    ends = [rows[place] for place in (0, 4, 12, 20, 24)]
    settings = {"mesh": MESH, "start": GUESS.name, "double": True}
    write_table(run(given, "mesh", ends, walk, settings, [GUESS]).table, "mesh")


def random(given):
    """Panel C: from random guesses."""
    rows = [{**row, "seed": seed} for seed in range(1, given.seeds + 1) for row in grid_rows(given)]
    settings = {"mesh": COARSE, "start": "random", "max_iterations": MOST_ITERATIONS}
    write_table(run(given, "random", rows, walk, settings).table, "random")


def sizes(given):
    """The same walk at three lengths."""
    rows = contacts.sizes(given.results / "models", LENGTHS)
    done = run(given, "sizes", rows, walk, {"mesh": MESH, "start": GUESS.name}, [GUESS])
    write_table(done.table, "sizes")
    curves = [
        done.series(place).assign(length=row["length"], contacts=row["contacts"]) for place, row in enumerate(rows)
    ]
    pd.concat(curves).to_csv(HERE / "sizes_curves.csv", index=False, float_format="%.6g", lineterminator="\n")
    # The same search at each size: from the guess that was drawn by hand.
    rescaled = [row for row in rows if row["contacts"] == "rescaled"]
    write_table(run(given, "sizes_by_hand", rescaled, walk, {"mesh": MESH, "start": "hand"}).table, "sizes_by_hand")


def grid_rows(given):
    """The grid's models as rows: path, index, and what is at the point."""
    manifest = Path(contacts.grid(given.results / "models").manifest)
    wanted = ["index", "stiffness", "dissipation", "relative_indentation", "dimensionless_stiffness", "restitution"]
    # The committed tables have the shorter name.
    table = pd.read_csv(manifest).rename(columns={"relative_indentation_hertz": "relative_indentation"})
    return [
        {"path": str(manifest.parent / row["file"]), **{name: row[name] for name in wanted}}
        for row in table.to_dict("records")
    ]


def figures(given):
    """Figures and tables of docs/studies/walker.md, from the tables beside this program."""
    import page
    from draw import draw_all

    for name, table in (("effort", page.least()), ("random_points", page.by_point(page.read("random")))):
        table.to_csv(HERE / f"{name}.csv", index=False, float_format="%.6g", lineterminator="\n")
    draw_all(HERE, given.figures)
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
    """Run the stages that are named."""
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
    given = parser.parse_args()
    given.results = given.results.absolute()
    for stage in STAGES if "all" in given.stages else given.stages:
        STAGES[stage](given)


if __name__ == "__main__":
    main()
