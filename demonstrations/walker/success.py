"""How often a search succeeds, as `criterion.py` counts: `python demonstrations/walker/success.py [guesses] [ladder] --results FOLDER`

`guesses`: from random guesses, on soft, middle and stiff contacts. `ladder`: on the stiffest contacts at once, and by way of softer ones,
from the same random guesses. Each row goes to `success.csv` or `ladder.csv` beside this program as it comes, and a row that is there is
not done again. At the end it prints counts with their confidence intervals.
"""

import argparse
import csv
import time
from pathlib import Path

import contacts
import pandas as pd
from criterion import checked, in_words, succeeded

HERE = Path(__file__).resolve().parent
MESH = 25
MOST = 1000  # iterations of a search
POINTS = ("soft", "middle", "stiff")  # of the grid, with its dissipation of 1 s/m
WAYS = {"at once": 1, "3 rungs": 3}  # models that are searched one after the other; the last is the same
CHECKS = ("solved_twice", "effort_change", "held", "cpu_s")
COLUMNS = {
    "success": ("point", "seed", "solved", "iterations", "effort", *CHECKS),
    "ladder": (
        "way",
        "seed",
        "solved",
        "rungs_solved",
        "iterations",
        "search_cpu_s",
        "effort",
        "active_bounds",
        *CHECKS,
    ),
}


def attempt(path, seed, below=()):
    """The row of a search from a random guess, by way of the models below if there are any, with the check of what it found."""
    from walk import climb

    begun = time.process_time()
    first, series = climb(path, ";".join(below), MESH, "random", seed, MOST)
    row = {
        "solved": first["converged"],
        "rungs_solved": first["converged_searches"],
        "iterations": first["iterations"],
        "search_cpu_s": first["cpu_s"],
        "effort": first["effort"],
        "active_bounds": first["active_bounds"],
    }
    if first["converged"]:
        row |= checked(path, first, series, MESH, MOST)
    return row | {"cpu_s": time.process_time() - begun}


def read(table):
    """The rows of a table; empty if there is no table."""
    path = HERE / f"{table}.csv"
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def append(table, row):
    path = HERE / f"{table}.csv"
    begun = path.exists()
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS[table], lineterminator="\n", restval="", extrasaction="ignore")
        if not begun:
            writer.writeheader()
        writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()})


def guesses(arguments):
    """Searches from random guesses at each stiffness."""
    manifest = Path(contacts.grid(arguments.results / "models", dissipations=(1.0,)).manifest)
    files = in_order(manifest, "stiffness")
    paths = dict(zip(POINTS, (files[0], files[len(files) // 2], files[-1])))
    for seed in range(1, arguments.seeds + 1):
        for point in arguments.points:
            if not is_done("success", point=point, seed=seed):
                append("success", {"point": point, "seed": seed, **attempt(paths[point], seed)})


def ladder(arguments):
    """Searches from the same random guesses: on the stiffest contacts at once, and after softer ones."""
    rungs = {}
    for way, count in WAYS.items():
        # Any ladder has the same last model.
        models = contacts.ladder(arguments.results / "models" / f"rungs_{count}", max(count, 3))
        rungs[way] = in_order(Path(models.manifest), "stiffness")[-count:]
    for seed in range(1, arguments.seeds + 1):
        for way in arguments.ways:
            if not is_done("ladder", way=way, seed=seed):
                *below, last = rungs[way]
                append("ladder", {"way": way, "seed": seed, **attempt(last, seed, below)})


def in_order(manifest, column):
    """The models of a sweep, from the least value of a column to the greatest."""
    return [str(manifest.parent / file) for file in pd.read_csv(manifest).sort_values(column)["file"]]


def is_done(table, **expected):
    return any(all(row[name] == str(value) for name, value in expected.items()) for row in read(table))


def summary():
    """At each stiffness: searches, those that the solver calls solved, and the counts of successes, with intervals."""
    yield "|contacts|guesses|solved|same effort|holds|"
    yield "|---|---|---|---|---|"
    for point in POINTS:
        selected = [row for row in read("success") if row["point"] == point]
        if selected:
            yield f"|{point}|{len(selected)}|{'|'.join(shares(selected))}|"


def summary_of_ladder():
    """The counts of each way, and medians of time, iterations and effort."""
    yield "|way|guesses|solved|same effort|holds|iterations|time|effort|"
    yield "|---|---|---|---|---|---|---|---|"
    for way in WAYS:
        selected = [row for row in read("ladder") if row["way"] == way]
        if selected:
            table = pd.DataFrame(selected)[["iterations", "search_cpu_s", "effort"]].astype(float).median()
            cells = [f"{table['iterations']:.0f}", f"{table['search_cpu_s']:.0f} s", f"{table['effort']:.2f}"]
            yield f"|{way}|{len(selected)}|{'|'.join([*shares(selected), *cells])}|"


def shares(rows):
    """Solved, the same effort at twice the mesh, and held: counts with their intervals."""
    counts = [sum(int(row["solved"]) for row in rows), *(sum(column) for column in zip(*map(succeeded, rows)))]
    return [in_words(count, len(rows)) for count in counts]


PARTS = {"guesses": (guesses, summary), "ladder": (ladder, summary_of_ladder)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", metavar="{guesses,ladder}", help="both without words")
    parser.add_argument("--results", type=Path, required=True, help="folder for the models")
    parser.add_argument("--seeds", type=int, default=20, help="random guesses at each stiffness, and for each way")
    parser.add_argument("--points", nargs="+", choices=POINTS, default=list(POINTS))
    parser.add_argument("--ways", nargs="+", choices=WAYS, default=list(WAYS))
    arguments = parser.parse_args()
    if not set(arguments.parts) <= set(PARTS):
        parser.error(f"parts are {' and '.join(PARTS)}")
    arguments.results = arguments.results.absolute()
    for part in arguments.parts or PARTS:
        make, summarize = PARTS[part]
        make(arguments)
        print("\n".join(summarize()))


if __name__ == "__main__":
    main()
