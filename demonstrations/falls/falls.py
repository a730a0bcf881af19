"""One fall at six sizes: `python demonstrations/falls/falls.py --results FOLDER`

A body of our own (`body.py`), from mouse to giraffe, falls in OpenSim from a tenth of its hip height, with joints locked and free, on
contacts that were rescaled or left. It also slides (`slide.py`), on contacts rescaled with `--friction` and without it. Made of the
results: `falls.csv` and `slides.csv` beside this program, the figures of `docs/studies/falls.md`, and its tables. With `--resume` it goes
on where it was stopped.
"""

import argparse
from pathlib import Path

import body
import page
import slide
from animals import ANIMALS, CONTACTS, REFERENCE, SLIDING, length_m, length_ratio, time_unit_s, write_model
from compare import COLUMNS, SLIDES, compared, slides_compared, write_table
from draw import draw
from osim_contact_scale import simulate

HERE = Path(__file__).resolve().parent
COMMITTED = HERE / "falls.csv"
COMMITTED_SLIDES = HERE / "slides.csv"
DOCS = HERE.parents[1] / "docs" / "studies" / "falls"
PAGE = DOCS.with_suffix(".md")

HEIGHT = 0.1  # hip heights
DURATION = 8.0  # units of √(L/g)
SAMPLES = 401
# Of the integrator. It is about metres and radians, so that it must be far below the length of a mouse's leg.
ACCURACY = 1e-10
# Of slides, which are compared in per cent.
SLIDE_ACCURACY = 1e-8


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


def slide_points(folder, animals, laws, motions, duration=slide.AFTER):
    """A row for each slide; the models are made in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    return [
        {
            "path": str(write_model(folder, animal, law, kind)),
            "animal": animal,
            "law": law,
            "contacts": kind,
            "motion": motion,
            "length_ratio": length_ratio(animal),
            "accuracy": SLIDE_ACCURACY,
            "after": duration,
        }
        for law in laws
        if law != "smooth_frictionless"
        for animal in animals
        for kind in (SLIDING[:1] if animal == REFERENCE else SLIDING)
        for motion in motions
    ]


def fall(path, joints, height_m, duration_s, samples, accuracy):
    """A fall in OpenSim."""
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
    parser.add_argument("--only", choices=("falls", "slides"), help="one of the two studies")
    parser.add_argument("--motions", nargs="+", choices=slide.MOTIONS, default=slide.MOTIONS, help="of slides")
    parser.add_argument("--duration", type=float, default=DURATION, help="in units of √(L/g)")
    parser.add_argument("--samples", type=int, default=SAMPLES, help="points of a curve of a fall")
    parser.add_argument("--accuracy", type=float, default=ACCURACY, help="of the integrator, for falls")
    parser.add_argument("--table", type=Path, default=COMMITTED, help="where the table of falls goes")
    parser.add_argument("--slides", type=Path, default=COMMITTED_SLIDES, help="where the table of slides goes")
    parser.add_argument("--figures", type=Path, default=DOCS, help="folder for the figures")
    arguments = parser.parse_args()
    animals = list(dict.fromkeys([REFERENCE, *arguments.animals]))
    models = arguments.results / "models"
    if arguments.only != "slides":
        rows = points(models, animals, arguments.laws, arguments.duration, arguments.samples, arguments.accuracy)
        results = run(arguments, rows, fall, arguments.results / "runs")
        write_table(arguments.table, compared(results), COLUMNS)
        draw(results, arguments.figures)
    if arguments.only != "falls":
        rows = slide_points(models, animals, arguments.laws, arguments.motions, arguments.duration)
        write_table(
            arguments.slides, slides_compared(run(arguments, rows, slide.slide, arguments.results / "slides")), SLIDES
        )
    if (arguments.table, arguments.slides) == (COMMITTED, COMMITTED_SLIDES):
        page.write(PAGE, COMMITTED, COMMITTED_SLIDES)


def run(arguments, rows, function, results):
    """Simulates all points that have no result yet; ends the program if one of them fails."""
    done = simulate.run(
        rows,
        function,
        results=results,
        workers=arguments.workers,
        scheduler=arguments.scheduler,
        resume=arguments.resume,
        progress=True,
    )
    if len(done.failures):
        raise SystemExit(done.failures[["animal", "law", "contacts", "error"]].to_string())
    return done


if __name__ == "__main__":
    main()
