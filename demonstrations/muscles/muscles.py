"""Moco's 2-D walker at three masses: `python demonstrations/muscles/muscles.py solve --moco FOLDER --results FOLDER`

FOLDER has OpenSim's example2DWalking (Apache-2.0): 2D_gait.osim, referenceCoordinates.sto, referenceGRF.sto and referenceGRF.xml. They are
not part of this project. `solve` searches one walk after the other, first with 15 mesh intervals, then with twice as many from that
solution, and leaves rows in `muscles.csv` beside this program as they come; a row that is there is not searched again. `--mass` and
`--contacts` choose single ones. `figures` draws from the tables. docs/studies/muscles.md says what was found.
"""

import argparse
import csv
from pathlib import Path

HERE = Path(__file__).resolve().parent
TABLE, CURVES = HERE / "muscles.csv", HERE / "curves.csv"
FIGURES = HERE.parents[1] / "docs" / "studies" / "muscles"
MASSES = (1.0, 8.0, 0.125)
MESH = 15  # intervals of the first search
MOST = 400  # iterations


def cases(masses=MASSES, contacts=None):
    """Masses with contacts, in the order of the searches: first those that should walk like the original."""
    for kind in contacts or ("rescaled", "left", "no_friction"):
        for mass in masses:
            if mass != 1 or kind == "rescaled":
                yield mass, kind


def solve(given):
    """Search the walks that are not in the table yet."""
    import opensim

    opensim.Logger.setLevelString("Warn")
    for mass, kind in cases(given.mass or MASSES, given.contacts):
        for mesh in given.meshes:
            start = "original" if given.from_original else "reference" if mesh == MESH else "half"
            key = {"mass": mass, "contacts": kind, "mesh": mesh, "start": start}
            if not any(_same(row, key) for row in read(given.table)):
                numbers, series = search(given.moco, given.results, **key)
                _append(given.table, [key | numbers])
                _append(given.curves, [key | one for one in _rows(series)])


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
    import sizes
    from forward import forward
    from track import scaled
    from track import solve as solved

    moco, results = Path(moco).absolute(), Path(results).absolute()
    size = sizes.Size(mass)
    model = sizes.of_mass(moco / sizes.MODEL, results / "models", size)[contacts]
    name = f"{contacts}_{mass:g}_{mesh}" + "_from_original" * (start == "original")
    guess = None
    if start == "half":
        guess = results / f"{contacts}_{mass:g}_{mesh // 2}.sto"
    elif start == "original":
        guess = scaled(results / f"rescaled_1_{mesh}.sto", results / f"{name}_guess.sto", size)
    numbers, series = solved(model, moco, results, size, mesh, most, guess, name)
    return numbers | forward(model, results / f"{name}.sto", size), series


def _same(row, key):
    return all(
        str(row[name]) == f"{value:g}" if name == "mass" else row[name] == str(value) for name, value in key.items()
    )


def _rows(series):
    return [dict(zip(series, values)) for values in zip(*series.values())]


def read(path):
    """The rows of a table; none where it is not there."""
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _append(path, rows):
    begun = path.exists()
    with open(path, "a", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        if not begun:
            writer.writeheader()
        writer.writerows(
            {name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows
        )


def figures(given):
    """The figure and the tables of the page."""
    import page
    from draw import draw

    draw(read(CURVES), given.figures)
    page.write(FIGURES.with_suffix(".md"), read(TABLE), read(CURVES))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(required=True)
    one = verbs.add_parser("solve", help="search walks")
    one.add_argument("--moco", type=Path, required=True, help="folder with OpenSim's example2DWalking")
    one.add_argument("--results", type=Path, required=True, help="folder for models and solutions")
    one.add_argument("--mass", type=float, nargs="+", help="only these factors of mass")
    one.add_argument("--contacts", nargs="+", choices=("rescaled", "left", "no_friction"))
    one.add_argument("--meshes", type=int, nargs="+", default=(MESH, 2 * MESH), help="15, then 30, then 60 intervals")
    one.add_argument("--from-original", action="store_true", help="start from the original's solution, scaled")
    one.add_argument("--table", type=Path, default=TABLE)
    one.add_argument("--curves", type=Path, default=CURVES)
    one.set_defaults(run=solve)
    other = verbs.add_parser("figures", help="draw from the tables")
    other.add_argument("--figures", type=Path, default=FIGURES)
    other.set_defaults(run=figures)
    given = parser.parse_args()
    given.run(given)


if __name__ == "__main__":
    main()
