"""The same fall at six sizes: `python demonstrations/falls/falls.py --results FOLDER`

A body of our own (`body.py`), from mouse to giraffe, falls in OpenSim from a tenth of its hip height, with joints locked and free, on
contacts that were rescaled or left. Made of the results: `falls.csv` beside this program, and the figures of `docs/studies/falls.md`. With
`--resume` it goes on where it was stopped. The tables of the page are made, too.
"""

import argparse
from pathlib import Path

import body
import page
from animals import ANIMALS, CONTACTS, REFERENCE, length_m, time_unit_s, write_model
from compare import compared, write_table
from draw import draw
from osim_contact_scale import simulate

HERE = Path(__file__).resolve().parent
COMMITTED = HERE / "falls.csv"
DOCS = HERE.parents[1] / "docs" / "studies" / "falls"
PAGE = DOCS.with_suffix(".md")

HEIGHT = 0.1  # hip heights
DURATION = 8.0  # units of √(L/g)
SAMPLES = 401
# Of the integrator. It is about metres and radians, so that it must be far below the length of a mouse's leg.
ACCURACY = 1e-10


def points(folder, animals=tuple(ANIMALS), laws=body.LAWS, duration=DURATION, samples=SAMPLES, accuracy=ACCURACY):
    """A row for each fall; the models are made in the folder.

    Falls on rescaled contacts are done once more with a tenth of the accuracy's number, to show that it does not matter.
    """
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for law in laws:
        for animal in animals:
            # Without friction it is only to be seen what of the rescaled fall is due to friction.
            for kind in ("rescaled",) if animal == REFERENCE or law == "smooth_frictionless" else CONTACTS:
                path = write_model(folder, animal, law, kind)
                for joints in ("locked", "free"):
                    for share in (1, 10) if kind == "rescaled" else (1,):
                        rows.append(
                            {
                                "path": str(path),
                                "animal": animal,
                                "law": law,
                                "contacts": kind,
                                "joints": joints,
                                "accuracy": accuracy / share,
                                "height_m": HEIGHT * length_m(animal),
                                "duration_s": duration * time_unit_s(animal),
                                "samples": samples,
                            }
                        )
    return rows


def fall(path, joints, height_m, duration_s, samples, accuracy):
    """One fall, in OpenSim."""
    return simulate.Drop(height=height_m, duration=duration_s, joints=joints, samples=samples, accuracy=accuracy)(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", type=Path, required=True, help="folder for models and results")
    parser.add_argument("--workers", type=int, default=None, help="models at a time; all cores by default")
    parser.add_argument("--scheduler", default=None, help="address of a Dask scheduler, or here")
    parser.add_argument("--resume", action="store_true", help="go on in a folder that has results")
    parser.add_argument(
        "--animals", nargs="+", choices=ANIMALS, default=list(ANIMALS), help="only these, and the reference"
    )
    parser.add_argument("--laws", nargs="+", choices=body.LAWS, default=body.LAWS)
    parser.add_argument("--duration", type=float, default=DURATION, help="in units of √(L/g)")
    parser.add_argument("--samples", type=int, default=SAMPLES, help="points of a curve")
    parser.add_argument("--accuracy", type=float, default=ACCURACY, help="of the integrator")
    parser.add_argument("--table", type=Path, default=COMMITTED, help="where the table goes")
    parser.add_argument("--figures", type=Path, default=DOCS, help="folder for the figures")
    given = parser.parse_args()
    animals = list(dict.fromkeys([REFERENCE, *given.animals]))
    rows = points(given.results / "models", animals, given.laws, given.duration, given.samples, given.accuracy)
    done = simulate.run(
        rows,
        fall,
        results=given.results / "runs",
        workers=given.workers,
        scheduler=given.scheduler,
        resume=given.resume,
        progress=True,
    )
    if len(done.failures):
        raise SystemExit(done.failures[["animal", "law", "contacts", "joints", "error"]].to_string())
    write_table(given.table, compared(done))
    draw(done, given.figures)
    if given.table == COMMITTED:
        page.write(PAGE, page.read(COMMITTED))


if __name__ == "__main__":
    main()
