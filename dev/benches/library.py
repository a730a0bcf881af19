#!/usr/bin/env python3
"""Compares the speed of the command on a library of 1000 models with a plain copy and with OpenSim's API: see README.md."""

import argparse
import itertools
import json
import mmap
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import synthetic
from measure import MIB, ROOT, Table, build, opensim_call, opensim_python, peak, rescale, run

LIMIT_TO_COPY = 1.5
LIMIT_DRY_TO_COPY = 1.3
# A study's own models, where the start of the program counts.
LIMIT_FEW_TO_COPY = 3.0
LIMIT_TIMES_FASTER = 40.0
LIMIT_MIB = 64.0
# Ten times as many models, against what a copy takes longer for them.
LIMIT_TENFOLD_TO_COPY = 1.1
# The names of all models are compared before the first is written; nothing else is kept of a model.
LIMIT_KIB_PER_MODEL = 0.5
MEAN_BYTES = 300_000
SMALL_ROUNDS = 3
FEW_MODELS = 200
SMALL = "table1/emu_2_spheres_hunt_crossley.osim"


def main():
    options = arguments()
    command = options.command or build()
    table = Table()
    with tempfile.TemporaryDirectory(prefix="osim-library-", dir=options.folder) as folder:
        folder = Path(folder)
        library = folder / "library"
        size = write_library(command, library, options.models)
        # What all rounds write, and the small models after them.
        warm_memory((3 * options.rounds + 3) * size)
        table.head(f"{options.models} models, {size / 1e6:.0f} MB, medians of {options.rounds} rounds by turns")
        times = by_turns(command, library, folder / "runs", options.rounds)
        against_copy(table, times, {"rescale": LIMIT_TO_COPY, "dry run": LIMIT_DRY_TO_COPY})
        report_peak(table, command, library, folder / "peak")
        against_opensim(table, library, folder, command, options.opensim_rounds)
        few_models(table, command, folder, options.rounds)
        ten_times_as_many(table, command, folder, options)
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", type=int, default=1000, help="in the library (default 1000)")
    parser.add_argument("--rounds", type=int, default=7, help="of copy, rescaling and dry run (default 7)")
    parser.add_argument("--opensim-rounds", type=int, default=3, help="of OpenSim's API (default 3)")
    parser.add_argument("--command", help="a command built before, instead of building one")
    parser.add_argument("--folder", help="where the models are written (default: the system's temporary folder)")
    return parser.parse_args()


def write_library(command, library, count):
    """`count` files that can be rescaled; their bytes in all."""
    with tempfile.TemporaryDirectory(dir=library.parent) as spare:
        texts = [path.read_bytes() for path in models(command, Path(spare))]
    return write_texts(texts, library, count)


def write_texts(texts, library, count):
    """`count` files, no two alike, of `MEAN_BYTES` in the mean where texts are both below and above; their bytes in all."""
    library.mkdir()
    small = itertools.cycle([text for text in texts if len(text) < MEAN_BYTES] or texts)
    large = itertools.cycle([text for text in texts if len(text) >= MEAN_BYTES] or texts)
    size = 0
    for number in range(count):
        text = next(large if size <= MEAN_BYTES * number else small)
        text += b"<!-- model %d -->\n" % number
        # A folder for every hundred, as libraries have them.
        path = library / f"{number // 100:02d}" / f"model_{number:05d}.osim"
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(text)
        size += len(text)
    return size


def models(command, spare):
    """Fixtures and models of the corpus that can be rescaled without a question."""
    corpus = os.environ.get("OSIM_CORPUS")
    paths = sorted((ROOT / "fixtures" / "table1").glob("*.osim"))
    if corpus:
        paths += sorted(Path(corpus).glob("*.osim"))
    else:
        print("OSIM_CORPUS is not set: synthetic models stand in for large ones")
        for size in (400_000, 600_000, 800_000):
            paths.append(spare / f"{size}.osim")
            synthetic.write(paths[-1], size)
    return [path for path in paths if is_rescaled(command, path)]


def is_rescaled(command, path):
    call = rescale(command, path, "--dry-run", "--format", "json")
    process = subprocess.run(call, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    return process.returncode == 0 and bool(json.loads(process.stdout)["changes"])


def warm_memory(size):
    """Uses `size` bytes once, or half of what is free: a virtual machine is slow to get memory that it never used."""
    with open("/proc/meminfo", encoding="ascii") as lines:
        free = next(int(line.split()[1]) * 1024 for line in lines if line.startswith("MemAvailable"))
    with mmap.mmap(-1, min(size, free // 2)) as memory:
        for at in range(0, len(memory), mmap.PAGESIZE):
            memory[at] = 1


def by_turns(command, library, runs, rounds):
    """Wall and processor times of a copy, of the rescaling and of a dry run."""
    copy = shutil.which("cp")
    calls = {
        "copy": lambda out: [copy, "-r", "--reflink=never", str(library), str(out)],
        "rescale": lambda out: rescale(command, library, "-d", str(out)),
        "dry run": lambda out: rescale(command, library, "-d", str(out), "--dry-run"),
    }
    return in_turns(calls, runs, rounds)


def in_turns(calls, runs, rounds):
    """Wall and processor times of each call, which is given the folder to write into.

    Every run writes into a folder of its own, and all are removed at the end: file systems are slow to use again what
    was removed a moment ago. What earlier runs wrote is on the disk before the next begins.
    """
    runs.mkdir()
    times = {name: [] for name in calls}
    # The first round warms up and does not count.
    for turn in range(rounds + 1):
        names, first = list(calls), turn % len(calls)
        for name in names[first:] + names[:first]:
            os.sync()
            measured = run(calls[name](runs / f"{name} {turn}".replace(" ", "-")))
            if turn:
                times[name].append(measured)
    shutil.rmtree(runs)
    return times


def median(times, part):
    return statistics.median(measured[part] for measured in times)


def ratio(ours, theirs, part):
    """Median of the rounds' own ratios: what slows a round slows both."""
    return statistics.median(our[part] / their[part] for our, their in zip(ours, theirs))


def against_copy(table, times, limits):
    for name in times:
        table.row(f"{name}, time", median(times[name], 0), "s")
        table.row(f"{name}, time on processors", median(times[name], 1), "s")
    for name, limit in limits.items():
        table.row(f"{name} against copy", ratio(times[name], times["copy"], 0), "x", limit)
        table.row(f"{name} against copy, by time on processors", ratio(times[name], times["copy"], 1), "x")


def report_peak(table, command, library, out):
    table.row("peak memory", peak(rescale(command, library, "-d", str(out))) / MIB, "MiB", LIMIT_MIB)
    shutil.rmtree(out)


def against_opensim(table, library, folder, command, rounds):
    """Times of a library, rescaled by one Python process and by the command, one after the other."""
    python = opensim_python()
    if not python:
        print("  no comparison with OpenSim's API: OPENSIM_PYTHON names no Python that can import opensim")
        return
    flat = folder / "flat"
    flat.mkdir()
    for path in library.rglob("*.osim"):
        path.rename(flat / path.name)
    theirs, ours, dry = [], [], []
    for turn in range(rounds):
        out = folder / f"opensim-{turn}"
        out.mkdir()
        os.sync()
        theirs.append(run(opensim_call(python, flat, out)))
        os.sync()
        ours.append(run(rescale(command, flat, "-d", str(folder / f"command-{turn}"))))
        dry.append(run(rescale(command, flat, "-d", str(folder / f"dry-{turn}"), "--dry-run")))
    table.row("OpenSim's API, time", median(theirs, 0), "s")
    table.row("times faster", ratio(theirs, ours, 0), "x", LIMIT_TIMES_FASTER, at_least=True)
    table.row("times faster, dry run", ratio(theirs, dry, 0), "x")
    for turn in range(rounds):
        shutil.rmtree(folder / f"opensim-{turn}")
        shutil.rmtree(folder / f"command-{turn}")
    shutil.rmtree(flat)


def few_models(table, command, folder, rounds):
    """So few small models that the start of the program counts."""
    text = (ROOT / "fixtures" / SMALL).read_bytes()
    library = folder / "few"
    library.mkdir()
    for number in range(FEW_MODELS):
        (library / f"model_{number:05d}.osim").write_bytes(text + b"<!-- model %d -->\n" % number)
    table.head(f"{FEW_MODELS} models of {len(text) / 1000:.0f} kB, medians of {rounds} rounds by turns")
    times = by_turns(command, library, folder / "runs-few", rounds)
    against_copy(table, times, {"rescale": LIMIT_FEW_TO_COPY, "dry run": None})


def ten_times_as_many(table, command, folder, options):
    """Small models, ten times as many: time, also of a copy, and memory."""
    text = (ROOT / "fixtures" / SMALL).read_bytes()
    few, many = options.models, 10 * options.models
    table.head(f"{few} and {many} models of {len(text) / 1000:.0f} kB, medians of {SMALL_ROUNDS} rounds by turns")
    for count in (few, many):
        library = folder / f"small-{count}"
        library.mkdir()
        for number in range(count):
            (library / f"model_{number:05d}.osim").write_bytes(text + b"<!-- model %d -->\n" % number)
    ours, copies, peaks = {few: [], many: []}, {few: [], many: []}, {}
    copy = [shutil.which("cp"), "-r", "--reflink=never"]
    # The first round warms up and does not count.
    for turn in range(SMALL_ROUNDS + 1):
        for count in (few, many):
            library, outs = folder / f"small-{count}", [folder / f"{kind}-{count}-{turn}" for kind in ("copy", "out")]
            calls = [(copies, [*copy, str(library), str(outs[0])]), (ours, rescale(command, library, "-d", str(outs[1])))]
            for times, call in calls if turn % 2 else reversed(calls):
                os.sync()
                measured = run(call)
                if turn:
                    times[count].append(measured)
    for count in (few, many):
        peaks[count] = peak(rescale(command, folder / f"small-{count}", "-d", str(folder / f"peak-{count}")))
        table.row(f"{count} models, copy, time", median(copies[count], 0), "s")
        table.row(f"{count} models, time", median(ours[count], 0), "s")
        table.row(f"{count} models, time on processors", median(ours[count], 1), "s")
        table.row(f"{count} models, peak memory", peaks[count] / MIB, "MiB", LIMIT_MIB)
    growth, copy_growth = (ratio(times[many], times[few], 0) for times in (ours, copies))
    table.row("time against a tenth of the models", growth, "x")
    table.row("the same of copy", copy_growth, "x")
    table.row("one against the other", growth / copy_growth, "x", LIMIT_TENFOLD_TO_COPY)
    table.row("against a tenth, by time on processors", ratio(ours[many], ours[few], 1), "x")
    table.row("the same of copy", ratio(copies[many], copies[few], 1), "x")
    table.row("memory against a tenth of the models", peaks[many] / peaks[few], "x")
    more = (peaks[many] - peaks[few]) / (many - few) / 1024
    table.row("memory for each further model", more, "KiB", LIMIT_KIB_PER_MODEL)


if __name__ == "__main__":
    sys.exit(main())
