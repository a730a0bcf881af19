#!/usr/bin/env python3
"""Builds the command, measures it as a whole process and compares with the limits it is to keep: see README.md."""

import argparse
import os
import shutil
import statistics
import sys
import tempfile
from pathlib import Path

import synthetic
from measure import MIB, ROOT, TARGET_KG, Table, build, opensim_call, opensim_python, peak, rescale, run

CORPUS_MODEL = "v40000_falisse_2022_human.osim"
SMALL = "check/sunk_in.osim"

LIMIT_MS = 4.5
LIMIT_MIB = 16.0
LIMIT_TIMES_FASTER = 50.0
LIMIT_MB_PER_S = 200.0
LIMIT_PEAK_PER_BYTE = 8.0
LIMIT_TO_COPY = 10.0
LIMIT_PEAK_OF_FORCES = 10.0
# Ten times as deep or as many: linear is 10, quadratic 100.
LIMIT_TENFOLD = 25.0


def main():
    options = arguments()
    command = options.command or build()
    table = Table()
    with tempfile.TemporaryDirectory(prefix="osim-bench-", dir=options.folder) as folder:
        folder = Path(folder)
        if "model" in options.parts:
            one_model(table, command, folder, options.rounds)
        if "size" in options.parts:
            sizes(table, command, folder, options.sizes, options.repeats)
        if "forces" in options.parts:
            many_forces(table, command, folder, options.repeats)
        if "odd" in options.parts:
            odd_models(table, command, folder, options.repeats)
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="*", help="model, size, forces, odd; all if none is named")
    parser.add_argument("--rounds", type=int, default=21, help="runs on the corpus model (default 21)")
    parser.add_argument("--repeats", type=int, default=5, help="runs on each synthetic model (default 5)")
    parser.add_argument("--sizes", type=int, nargs="+", default=[1, 3, 10, 30, 100], help="in MB")
    parser.add_argument("--command", help="a command built before, instead of building one")
    parser.add_argument("--folder", help="where the models are written (default: the system's temporary folder)")
    options = parser.parse_args()
    parts = ["model", "size", "forces", "odd"]
    if any(part not in parts for part in options.parts):
        parser.error(f"the parts are {', '.join(parts)}")
    options.parts = options.parts or parts
    return options


def one_model(table, command, folder, rounds):
    """A published model, and the same with OpenSim's API, by turns."""
    model = corpus_model(table)
    table.head(f"{model.name} ({model.stat().st_size / 1000:.0f} kB) to {TARGET_KG} kg, whole process")
    out = folder / "out.osim"
    ours = rescale(command, model, "-o", str(out), "--force")
    python = opensim_python()
    theirs = python and opensim_call(python, model, folder / "opensim.osim")
    times = {"ours": [], "theirs": []}
    for _ in range(rounds):
        times["ours"].append(run(ours, fresh=out))
        if theirs:
            times["theirs"].append(run(theirs))
    wall = statistics.median(wall for wall, _ in times["ours"])
    processor = statistics.median(processor for _, processor in times["ours"])
    table.row(f"time, median of {rounds}", wall * 1e3, "ms", LIMIT_MS)
    table.row("least time", min(wall for wall, _ in times["ours"]) * 1e3, "ms")
    table.row("time on a processor, median", processor * 1e3, "ms")
    table.row("peak memory", peak(ours) / MIB, "MiB", LIMIT_MIB)
    if theirs:
        table.row(
            "with OpenSim's API, time", statistics.median(wall for wall, _ in times["theirs"]) * 1e3, "ms"
        )
        ratio = statistics.median(t[0] / o[0] for t, o in zip(times["theirs"], times["ours"]))
        table.row("times faster, median of pairs", ratio, "x", LIMIT_TIMES_FASTER, at_least=True)
    else:
        print("  no comparison with OpenSim's API: OPENSIM_PYTHON names no Python that can import opensim")


def corpus_model(table):
    corpus = Path(os.environ.get("OSIM_CORPUS", "")) / CORPUS_MODEL
    if "OSIM_CORPUS" in os.environ and corpus.exists():
        return corpus
    largest = max((ROOT / "fixtures").rglob("*.osim"), key=lambda path: path.stat().st_size)
    table.head(f"OSIM_CORPUS names no folder with {CORPUS_MODEL}: the largest fixture stands in for it")
    return largest


def sizes(table, command, folder, megabytes, repeats):
    """Synthetic models of growing size."""
    table.head(f"synthetic models, whole process, best of {repeats}")
    model, out = folder / "synthetic.osim", folder / "out.osim"
    # The program's own code is mapped whatever the model: it would drown what a small model takes.
    base = peak(rescale(command, ROOT / "fixtures" / SMALL, "--dry-run"))
    table.row("peak memory of a model of some kB: the program itself", base / MIB, "MiB")
    for size in megabytes:
        synthetic.write(model, size * 10**6)
        length = model.stat().st_size
        for name, options in [("written", ["-o", str(out), "--force"]), ("dry run", ["--dry-run"])]:
            call = rescale(command, model, *options)
            runs = [run(call, fresh=out) for _ in range(repeats)]
            table.row(
                f"{size} MB, {name}", length / min(wall for wall, _ in runs) / 1e6, "MB/s", LIMIT_MB_PER_S, True
            )
            table.row(f"{size} MB, {name}, by time on a processor", length / min(p for _, p in runs) / 1e6, "MB/s")
            total = peak(call)
            table.row(f"{size} MB, {name}, peak memory", total / length, "x file")
            table.row("  beyond the program itself", (total - base) / length, "x file", LIMIT_PEAK_PER_BYTE)
            out.unlink(missing_ok=True)
    model.unlink()


def many_forces(table, command, folder, repeats):
    """100,000 forces on two feet, against a copy of the file."""
    model, out = folder / "forces.osim", folder / "out.osim"
    synthetic.write_forces(model, 100_000)
    length = model.stat().st_size
    table.head(f"100,000 forces ({length / 1e6:.0f} MB), whole process, best of {repeats} after one that does not count")
    # Its numbers are rolled: nothing is asked about them.
    confirmations = ["--yes", "implausible-mass", "--yes", "mass-in-pounds", "--yes", "implausible-radius"]
    calls = {
        "copy": [shutil.which("cp"), "--reflink=never", str(model), str(out)],
        "rescaled": rescale(command, model, *confirmations, "-o", str(out)),
        "inspected": [str(command), "inspect", str(model)],
    }
    best = {name: min(run(call, fresh=out) for _ in range(repeats + 1)) for name, call in calls.items()}
    copy = best.pop("copy")[0]
    table.row("copy, time", copy, "s")
    for name, (wall, processor) in best.items():
        table.row(f"{name}, time", wall, "s", LIMIT_TO_COPY * copy + 1)
        table.row(f"{name}, time on a processor", processor, "s")
        out.unlink(missing_ok=True)
        table.row(f"{name}, peak memory", peak(calls[name]) / length, "x file", LIMIT_PEAK_OF_FORCES)
    out.unlink(missing_ok=True)
    model.unlink()


def odd_models(table, command, folder, repeats):
    """Measures models that nobody writes by hand: 100,000 of something against 10,000."""
    table.head(f"10,000 and 100,000 of a kind, dry run, best of {repeats}")
    model = folder / "odd.osim"
    kinds = [
        ("levels of nesting", 0, lambda n: synthetic.write_nested(model, n, "a")),
        ("levels of nested components", 0, lambda n: synthetic.write_nested(model, n, 'Component name="c"')),
        ("levels never closed (refused)", 1, lambda n: synthetic.write_nested(model, n, "a", closed=False)),
        ("attributes on the model", 0, lambda n: synthetic.write_attributes(model, n, "Model")),
        ("attributes on a body", 0, lambda n: synthetic.write_attributes(model, n, "Body")),
        ("attributes on a force", 0, lambda n: synthetic.write_attributes(model, n, "SmoothSphereHalfSpaceForce")),
    ]
    call = rescale(command, model, "--dry-run")
    for name, status, write in kinds:
        best = []
        for count in (10_000, 100_000):
            write(count)
            best.append(min(run(call, status)[0] for _ in range(repeats)))
        table.row(f"100,000 {name}", best[1] * 1e3, "ms")
        table.row("  against 10,000", best[1] / best[0], "x", LIMIT_TENFOLD)


if __name__ == "__main__":
    sys.exit(main())
