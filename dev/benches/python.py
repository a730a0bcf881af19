"""The Python package against the command and against opensim's own API, as ratios in one run.

    target/python-venv/bin/python dev/benches/python.py [--models N]

Needs the package, as pip installs it, and models by other people (OSIM_CORPUS); opensim is compared where it is installed.
Each figure is the median of its runs, which take turns, so that a machine that slows down slows down all.
"""

import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import osim_contact_scale as ocs

PROGRAM = Path(sys.executable).with_name("osim-contact-scale" + (".exe" if os.name == "nt" else ""))
TARGET = 500.5


def timed(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def medians(works, runs, at_once=1):
    """The median time of each, in turns. A turn is the middle of `at_once` calls in a row: the first of them reads what it needs into
    caches that another work has just filled."""
    times = {name: [] for name in works}
    for _ in range(runs):
        for name, work in works.items():
            times[name].append(statistics.median(timed(work) for _ in range(at_once)))
    return {name: statistics.median(all_of_it) for name, all_of_it in times.items()}


def by_opensim(path, factor):
    """Load, multiply, print: the program that a user would write for stiffness alone."""
    import opensim

    model = opensim.Model(str(path))
    forces = model.updForceSet()
    for index in range(forces.getSize()):
        force = opensim.SmoothSphereHalfSpaceForce.safeDownCast(forces.get(index))
        if force is not None:
            force.set_stiffness(force.get_stiffness() * factor)
    model.finalizeConnections()
    with tempfile.TemporaryDirectory() as folder:
        model.printToXML(os.path.join(folder, "new.osim"))


def one_model(path):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "new.osim")
        command = [PROGRAM, path, "--target-mass", str(TARGET), "-o", output, "--force", "--quiet"]
        works = {
            "ocs.rescale(path)": lambda: ocs.rescale(path, target_mass=TARGET).record,
            "ocs.rescale(path).write()": lambda: ocs.rescale(path, target_mass=TARGET).write(output, force=True),
            "the command": lambda: subprocess.run(command, check=True),
        }
        try:
            import opensim

            opensim.Logger.setLevelString("Off")
            works["opensim's API, warm"] = lambda: by_opensim(path, 2.0)
        except ImportError:
            print("skipped: opensim: it is not installed")
        found = medians(works, 15, at_once=3)
    base = found["ocs.rescale(path)"]
    print(f"{path.name}, {path.stat().st_size / 1000:.0f} kB")
    for name, seconds in found.items():
        print(f"  {name:<28}{seconds * 1000:9.2f} ms  {seconds / base:7.1f} x ocs.rescale(path)")


def importing():
    code = "import time; begin = time.perf_counter(); import osim_contact_scale; print(time.perf_counter() - begin)"
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout) for _ in range(15)]
    print(f"import osim_contact_scale      {statistics.median(times) * 1000:9.2f} ms (at most 20 is asked for)")


def library(path, count):
    with tempfile.TemporaryDirectory() as folder:
        models = Path(folder) / "models"
        models.mkdir()
        for number in range(count):
            shutil.copy(path, models / f"{number:05}.osim")
        table = Path(folder) / "table.csv"
        rows = "".join(f"models/{number:05}.osim,{60 + number / 100}\n" for number in range(count))
        table.write_text("model,target_mass\n" + rows)
        records = [{"model": models / f"{number:05}.osim", "target_mass": 60 + number / 100} for number in range(count)]

        def by_python(number=[0]):
            number[0] += 1
            ocs.rescale_many(records, output_dir=Path(folder) / f"python{number[0]}")

        def by_command(number=[0]):
            number[0] += 1
            output = Path(folder) / f"command{number[0]}"
            subprocess.run([PROGRAM, "batch", table, "-d", output, "--allow-outside", "--quiet"], check=True, capture_output=True)

        works = {"the command": by_command, "rescale_many": by_python}
        medians(works, 1)
        seconds = medians(works, 5)
    ratio = seconds["rescale_many"] / seconds["the command"]
    print(f"{count} models: the command {seconds['the command']:.2f} s, rescale_many {seconds['rescale_many']:.2f} s: {ratio:.2f} x")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--models", type=int, default=1000, help="models of the library [default: 1000]")
    arguments = parser.parse_args()
    corpus = Path(os.environ["OSIM_CORPUS"])
    path = max((path for path in corpus.rglob("*falisse_2022*.osim")), key=lambda path: path.stat().st_size)
    one_model(path)
    importing()
    library(path, arguments.models)


if __name__ == "__main__":
    main()
