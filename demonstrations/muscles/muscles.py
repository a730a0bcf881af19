"""Moco's 2-D walker at three masses: `python demonstrations/muscles/muscles.py solve --moco FOLDER --results FOLDER`

FOLDER has OpenSim's example2DWalking (Apache-2.0): 2D_gait.osim, referenceCoordinates.sto, referenceGRF.sto and referenceGRF.xml. They are
not part of this project. `solve` searches one walk after the other, first with 15 mesh intervals, then with twice as many from that
solution, and leaves rows in `muscles.csv` beside this program as they come; a row that is there is not searched again. `--mass` and
`--contacts` choose single ones. `predict` searches walks that nothing is tracked in, from solutions of `solve`, and leaves rows in
`predictions.csv`. `figures` draws from the tables. docs/studies/muscles.md says what was found.
"""

import argparse
import csv
import os
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

HERE = Path(__file__).resolve().parent
TABLE, CURVES = HERE / "muscles.csv", HERE / "curves.csv"
PREDICTIONS, PREDICTED = HERE / "predictions.csv", HERE / "predicted.csv"
FIGURES = HERE.parents[1] / "docs" / "studies" / "muscles"
MASSES = (1.0, 8.0, 0.125)
MESH = 15  # intervals of the first search
MOST = 400  # iterations
PREDICTING = "max_cpu_time 480\n"  # s


def cases(masses=MASSES, contacts=None):
    """Masses with contacts, in the order of the searches: first those that should walk like the original."""
    for kind in contacts or ("rescaled", "left", "no_friction"):
        for mass in masses:
            if mass != 1 or kind == "rescaled":
                yield mass, kind


def solve(arguments):
    """Searches the tracked walks that are not in the table yet."""

    def start(mass, kind, mesh):
        return "original" if arguments.from_original else "reference" if mesh == MESH else "half"

    _fill(arguments, search, arguments.contacts, start)


def _fill(arguments, function, contacts, start_of):
    """Adds to the tables each walk that is not there."""
    for mass, kind in cases(arguments.mass or MASSES, contacts):
        for mesh in arguments.meshes:
            key = {"mass": mass, "contacts": kind, "mesh": mesh, "start": start_of(mass, kind, mesh)}
            if not any(_same(row, key) for row in read(arguments.table)):
                numbers, series = _alone(function, arguments.moco.absolute(), arguments.results.absolute(), **key)
                _append(arguments.table, [key | numbers])
                _append(arguments.curves, [key | one for one in _rows(series)])


def _alone(function, moco, results, **key):
    """Calls it in a process of its own, in the folder for results, where Moco leaves files.

    In OpenSim 4.6 all muscles of a process (DeGrooteFregly2016Muscle) have the activation times of the first one that moves in it, whatever
    its size.
    """
    results.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(1, get_context("spawn"), initializer=os.chdir, initargs=(results,)) as process:
        return process.submit(function, moco, results, **key).result()


def search(moco, results, mass, contacts, mesh, start, most=MOST):
    """One search: its numbers, and its curves without dimensions.

    Parameters
    ----------
    moco, results : Path
        The folder with Moco's files, and that for models and solutions.
    mass : float
        Factor of mass.
    contacts : str
    mesh : int
        Intervals.
    start : str
        `"reference"`; `"half"`, the solution with half the mesh; or `"original"`, that of the original with the same mesh, scaled.
        Solutions have to be in `results`.
    """
    import opensim
    import sizes
    from forward import forward
    from problem import TERMS, tracking
    from solve import WARM_START, scaled
    from solve import solve as solved

    opensim.Logger.setLevelString("Warn")
    size = sizes.Size(mass)
    model = sizes.scale_to_mass(moco / sizes.MODEL, results / "models", size)[contacts]
    name = f"{contacts}_{mass:g}_{mesh}" + "_from_original" * (start == "original")
    guess = None
    if start == "half":
        guess = results / f"{contacts}_{mass:g}_{mesh // 2}.sto"
    elif start == "original":
        guess = scaled(results / f"rescaled_1_{mesh}.sto", results / f"{name}_guess.sto", size)
    study = tracking(model, moco, results / f"reference_{size.mass:g}", size)
    options = "" if guess is None else WARM_START
    numbers, series = solved(study, model, results, size, mesh, most, guess, name, TERMS, options)
    return numbers | forward(model, results / f"{name}.sto", size), series


def predict(arguments):
    """Searches the predicted walks that are not in the table yet."""

    def start(mass, kind, mesh):
        return arguments.start or _start(mass, kind, mesh)

    _fill(arguments, prediction, arguments.contacts or ("rescaled", "left"), start)


def _start(mass, kind, mesh):
    if mass != 1 and kind != "left":
        return "original"
    return "tracked" if mesh == MESH else "half"


def prediction(moco, results, mass, contacts, mesh, start, most=500):
    """One predicted walk: its numbers, and its curves without dimensions.

    Parameters
    ----------
    moco, results : Path
        The folder with Moco's files, and that for models and solutions.
    mass : float
        Factor of mass.
    contacts : str
    mesh : int
        Intervals.
    start : str
        `"tracked"`, the tracked walk of the same body and mesh; `"half"`, the predicted one with half the mesh; or `"original"`, the
        predicted one of the original with the same mesh, scaled. They have to be in `results`.
    """
    import opensim
    import predict
    import sizes
    from forward import forward
    from solve import THERE, WARM_START, scaled
    from solve import solve as solved

    opensim.Logger.setLevelString("Warn")
    size = sizes.Size(mass)
    model = sizes.scale_to_mass(moco / sizes.MODEL, results / "models", size)[contacts]
    name = f"predicted_{contacts}_{mass:g}_{mesh}"
    if start == "tracked":
        guess, options = results / f"{contacts}_{mass:g}_{mesh}.sto", ""
    elif start == "half":
        guess, options = results / f"predicted_{contacts}_{mass:g}_{mesh // 2}.sto", WARM_START
    else:
        guess, options = results / f"{name}_guess.sto", THERE
        scaled(results / f"predicted_rescaled_1_{mesh}.sto", guess, size)
    study = predict.prediction(model, size)
    numbers, series = solved(
        study, model, results, size, mesh, most, guess, name, options=PREDICTING + options, tolerance=predict.TOLERANCE
    )
    time = {"half_stride_s": float(series["time"][-1])}
    return numbers | time | forward(model, results / f"{name}.sto", size), series


def _same(row, key):
    return all(
        str(row[name]) == f"{value:g}" if name == "mass" else row[name] == str(value) for name, value in key.items()
    )


def _rows(series):
    return [dict(zip(series, values)) for values in zip(*series.values())]


def read(path):
    """The rows of a table; empty if there is no table."""
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _append(path, rows):
    begun = path.exists()
    columns = path.read_text(encoding="utf-8").split("\n", 1)[0].split(",") if begun else list(rows[0])
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        if not begun:
            writer.writeheader()
        writer.writerows(
            {name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows
        )


def figures(arguments):
    """The figure and the tables of the page."""
    import page
    from draw import draw

    draw(read(CURVES), arguments.figures)
    page.write(FIGURES.with_suffix(".md"), *map(read, (TABLE, CURVES, PREDICTIONS, PREDICTED)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(required=True)
    one = verbs.add_parser("solve", help="search walks that track the reference")
    one.add_argument("--contacts", nargs="+", choices=("rescaled", "left", "no_friction"))
    one.add_argument("--from-original", action="store_true", help="start from the original's solution, scaled")
    one.add_argument("--table", type=Path, default=TABLE)
    one.add_argument("--curves", type=Path, default=CURVES)
    one.set_defaults(run=solve)
    two = verbs.add_parser("predict", help="search walks that track nothing, from solutions of solve")
    two.add_argument("--contacts", nargs="+", choices=("rescaled", "left", "no_friction"))
    two.add_argument("--start", choices=("tracked", "half", "original"), help="what to start from")
    two.add_argument("--table", type=Path, default=PREDICTIONS)
    two.add_argument("--curves", type=Path, default=PREDICTED)
    two.set_defaults(run=predict)
    for each in (one, two):
        each.add_argument("--moco", type=Path, required=True, help="folder with OpenSim's example2DWalking")
        each.add_argument("--results", type=Path, required=True, help="folder for models and solutions")
        each.add_argument("--mass", type=float, nargs="+", help="only these factors of mass")
        each.add_argument(
            "--meshes", type=int, nargs="+", default=(MESH, 2 * MESH), help="15, then 30, then 60 intervals"
        )
    other = verbs.add_parser("figures", help="draw from the tables")
    other.add_argument("--figures", type=Path, default=FIGURES)
    other.set_defaults(run=figures)
    arguments = parser.parse_args()
    arguments.run(arguments)


if __name__ == "__main__":
    main()
