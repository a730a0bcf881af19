#!/usr/bin/env python3
"""Builds the command, measures it as a whole process and compares with the limits it is to keep: see README.md."""

import argparse
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import synthetic

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
CORPUS_MODEL = "v40000_falisse_2022_human.osim"
TARGET_KG = "500"
MIB = 1 << 20

LIMIT_MS = 5.0
LIMIT_MIB = 16.0
LIMIT_TIMES_FASTER = 50.0
LIMIT_MB_PER_S = 200.0
LIMIT_PEAK_PER_BYTE = 8.0
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
        if "odd" in options.parts:
            odd_models(table, command, folder, options.repeats)
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("parts", nargs="*", help="model, size, odd; all three if none is named")
    parser.add_argument("--rounds", type=int, default=21, help="runs on the corpus model (default 21)")
    parser.add_argument("--repeats", type=int, default=5, help="runs on each synthetic model (default 5)")
    parser.add_argument("--sizes", type=int, nargs="+", default=[1, 3, 10, 30, 100], help="in MB")
    parser.add_argument("--command", help="a command built before, instead of building one")
    parser.add_argument("--folder", help="where the models are written (default: the system's temporary folder)")
    options = parser.parse_args()
    known = ["model", "size", "odd"]
    if any(part not in known for part in options.parts):
        parser.error(f"the parts are {', '.join(known)}")
    options.parts = options.parts or known
    return options


def build():
    """The path of the release build."""
    call = ["cargo", "build", "--release", "-p", "osim-contact-scale", "--message-format=json-render-diagnostics"]
    lines = subprocess.run(call, cwd=ROOT, stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    built = [json.loads(line).get("executable") for line in lines]
    return [path for path in built if path][-1]


class Table:
    """Prints a row as soon as it is measured, and remembers what failed."""

    def __init__(self):
        self.failed = 0
        print(f"{platform.machine()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")

    def head(self, text):
        print(f"\n{text}")

    def row(self, what, value, unit, limit=None, at_least=False):
        """One figure against its limit, which it must not exceed (or, `at_least`, must reach)."""
        if limit is None:
            verdict = ""
        elif value >= limit if at_least else value <= limit:
            verdict = f"pass ({'at least' if at_least else 'at most'} {limit:g})"
        else:
            verdict = f"FAIL ({'at least' if at_least else 'at most'} {limit:g})"
            self.failed += 1
        print(f"  {what:<52} {value:>10.4g} {unit:<6} {verdict}", flush=True)

    def finish(self):
        print(f"\n{self.failed} limits missed" if self.failed else "\nall limits kept")
        return 1 if self.failed else 0


def run(call, status=0, fresh=None):
    """Wall time in seconds and the time on a processor of one process, start to end, its output thrown away.

    `fresh` is a file the process writes anew: replacing an old one would time the disk, which is told to keep the
    successor before the old contents go.
    """
    if fresh is not None:
        fresh.unlink(missing_ok=True)
    nothing = [(os.POSIX_SPAWN_OPEN, fd, os.devnull, os.O_RDWR, 0) for fd in (0, 1, 2)]
    start = time.perf_counter()
    process = os.posix_spawn(shutil.which(call[0]), call, os.environ, file_actions=nothing)
    _, code, usage = os.wait4(process, 0)
    elapsed = time.perf_counter() - start
    if os.waitstatus_to_exitcode(code) != status:
        sys.exit(f"failed: {' '.join(call)}")
    return elapsed, usage.ru_utime + usage.ru_stime


def peak(call, status=0):
    """Peak memory in bytes, asked of GNU time: what Python itself uses would count as the child's otherwise."""
    timer = shutil.which("time")
    if timer is None:
        sys.exit("GNU time is needed to measure memory, for example from the package 'time'")
    with tempfile.NamedTemporaryFile("r") as report:
        done = subprocess.run(
            [timer, "-q", "-o", report.name, "-f", "%M", *call], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        if done.returncode != status:
            sys.exit(f"failed: {' '.join(call)}")
        return int(report.read()) * 1024


def rescale(command, model, *options):
    return [command, str(model), "--target-mass", TARGET_KG, *options]


def one_model(table, command, folder, rounds):
    """A published model, and the same with OpenSim's API, by turns."""
    model = corpus_model(table)
    table.head(f"{model.name} ({model.stat().st_size / 1000:.0f} kB) to {TARGET_KG} kg, whole process")
    out = folder / "out.osim"
    ours = rescale(command, model, "-o", str(out), "--force")
    theirs = opensim_call(model, folder)
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


def opensim_call(model, folder):
    python = os.environ.get("OPENSIM_PYTHON")
    if not python or subprocess.run([python, "-c", "import opensim"], capture_output=True).returncode != 0:
        return None
    return [python, str(HERE / "rescale_with_opensim.py"), str(model), str(folder / "opensim.osim"), TARGET_KG]


def sizes(table, command, folder, megabytes, repeats):
    """Synthetic models of growing size."""
    table.head(f"synthetic models, whole process, best of {repeats}")
    model, out = folder / "synthetic.osim", folder / "out.osim"
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
            table.row(f"{size} MB, {name}, peak memory", peak(call) / length, "x file", LIMIT_PEAK_PER_BYTE)
            out.unlink(missing_ok=True)
    model.unlink()


def odd_models(table, command, folder, repeats):
    """What nobody writes by hand: 100,000 of it against 10,000."""
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
