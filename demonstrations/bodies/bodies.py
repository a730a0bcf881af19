"""Falls of bodies of other builds: `python demonstrations/bodies/bodies.py --models FOLDER --results FOLDER`

Public models, scaled by OpenSim to builds of which only one is similar to the original's, with contacts left behind, rescaled by mass
only, and transferred with places. Leaves `bodies.csv` beside this program; with `--figures` it draws from it what docs/studies/bodies.md
shows.
"""

import argparse
import csv
from pathlib import Path

HERE = Path(__file__).resolve().parent
TABLE = HERE / "bodies.csv"
FIGURES = HERE.parents[1] / "docs" / "studies" / "bodies"


def rows(models, folder, names=None, build_names=None):
    """A row for each model, build, and way with its contacts."""
    import builds
    import opensim
    from fall import fall

    opensim.Logger.setLevelString("Error")
    for file in names or builds.MODELS:
        if not (models / file).exists():
            print(f"{file} is not in {models}: left out")
            continue
        original = builds.original(models, folder, file)
        at_first = fall(original, 0.03, builds.BUILDS["original"])
        radius = at_first["radius_m"]
        for name in build_names or builds.BUILDS:
            build = builds.BUILDS[name]
            for contacts in builds.CONTACTS if name != "original" else ("left",):
                path = builds.write(original, folder, name, build, contacts)
                yield {"model": file, "build": name, "contacts": contacts, **fall(path, radius, build)}


def write(path, rows):
    """Writes the table with six digits."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow(
                {name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()}
            )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--models", type=Path, help="folder with the public models")
    parser.add_argument("--results", type=Path, default=Path("bodies.results"), help="folder for the models made")
    parser.add_argument("--only", nargs="+", help="only these models")
    parser.add_argument("--builds", nargs="+", help="only these builds")
    parser.add_argument("--table", type=Path, default=TABLE, help="where the table goes")
    parser.add_argument("--figures", action="store_true", help="draw from the table")
    arguments = parser.parse_args()
    if arguments.models:
        write(
            arguments.table,
            list(rows(arguments.models, arguments.results.absolute(), arguments.only, arguments.builds)),
        )
    if arguments.figures or not arguments.models:
        import page
        from draw import draw

        found = page.read(TABLE)
        draw(found, FIGURES)
        page.write(FIGURES.with_suffix(".md"), found)


if __name__ == "__main__":
    main()
