#!/usr/bin/env python3
"""Compares the speed of two builds of the command, which run alternately: see README.md."""

import argparse
import os
import shutil
import statistics
import sys
import tempfile
from pathlib import Path

from library import write_library
from measure import TARGET_KG, Table, rescale, run
from run import corpus_model

LIMIT = 1.05
# A start shall not be slower at all.
LIMIT_START = 1.0
# One start takes only a few milliseconds, so that many are measured together.
STARTS = 20
WARM_UP = 1


def main():
    options = arguments()
    # Copies in one folder: neither has a longer path, nor lies on another disk.
    with tempfile.TemporaryDirectory(prefix="osim-compare-", dir=options.folder) as folder:
        folder = Path(folder)
        programs = {name: folder / f"{name}-program" for name in ("old", "new")}
        for name, program in programs.items():
            shutil.copy(getattr(options, name), program)
        table = Table()
        pairs = Pairs(table, programs, options.pairs)
        if "start" in options.parts:
            start(pairs)
        if "model" in options.parts:
            model(pairs, table, folder)
        if "library" in options.parts:
            library(pairs, table, programs, folder, options.models)
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("old", type=Path, help="a program built before")
    parser.add_argument("new", type=Path, help="the program that must not be slower")
    parser.add_argument("parts", nargs="*", help="start, model, library; all three if none is named")
    parser.add_argument("--pairs", type=int, default=21, help="runs of each program (default 21)")
    parser.add_argument("--models", type=int, default=1000, help="in the library (default 1000)")
    parser.add_argument("--folder", help="where the models are written (default: the system's temporary folder)")
    options = parser.parse_args()
    parts = ["start", "model", "library"]
    if any(part not in parts for part in options.parts):
        parser.error(f"the parts are {', '.join(parts)}")
    options.parts = options.parts or parts
    return options


class Pairs:
    """Runs both programs alternately, and the old one twice: its two times differ only by noise."""

    def __init__(self, table, programs, count):
        self.table, self.programs, self.count = table, programs, count

    def measure(self, name, once, limit=LIMIT):
        """`once(program, label)` gives wall and processor time of one run; `label` is another for each."""
        runs = {"old": [], "new": [], "old again": []}
        for turn in range(self.count + WARM_UP):
            names = list(runs)
            for who in names[turn % 3 :] + names[: turn % 3]:
                measured = once(self.programs[who.split()[0]], f"{who}-{turn}".replace(" ", "-"))
                if turn >= WARM_UP:
                    runs[who].append(measured)
        for who in ("old", "new"):
            wall = statistics.median(times[0] for times in runs[who])
            self.table.row(f"{name}: {who}, median time", wall * 1e3, "ms")
        self.ratios(f"{name}: new against old", runs["new"], runs["old"], limit)
        self.ratios(f"{name}: old against itself", runs["old again"], runs["old"])

    def ratios(self, what, ours, theirs, limit=None):
        """Median of the pairs' own ratios, which a slow moment touches least, and the middle half of them."""
        for part, suffix in [(0, ""), (1, ", on processors")]:
            ratios = [our[part] / their[part] for our, their in zip(ours, theirs)]
            low, middle, high = statistics.quantiles(ratios, n=4)
            self.table.row(f"{what}{suffix}", middle, "x", limit if part == 0 else None)
            print(f"    middle half of the pairs: {low:.3f} to {high:.3f}", flush=True)


def start(pairs):
    pairs.table.head(f"start: {STARTS} of them at a time, {pairs.count} pairs")
    for option in ("--version", "--help"):

        def once(program, _, option=option):
            runs = [run([str(program), option]) for _ in range(STARTS)]
            return sum(wall for wall, _ in runs) / STARTS, sum(processor for _, processor in runs) / STARTS

        pairs.measure(option, once, LIMIT_START)


def model(pairs, table, folder):
    path, out = corpus_model(table), folder / "out.osim"
    table.head(f"{path.name} ({path.stat().st_size / 1000:.0f} kB) to {TARGET_KG} kg, {pairs.count} pairs")
    pairs.measure("model", lambda program, _: run(rescale(program, path, "-o", str(out), "--force"), fresh=out))


def library(pairs, table, programs, folder, count):
    models = folder / "library"
    size = write_library(programs["old"], models, count)
    table.head(f"{count} models, {size / 1e6:.0f} MB, {pairs.count} pairs")

    def written(program, label):
        out = folder / label
        # What earlier runs wrote is on the disk before this one begins.
        os.sync()
        measured = run(rescale(program, models, "-d", str(out)))
        shutil.rmtree(out)
        return measured

    pairs.measure("library, written", written)
    dry = folder / "nothing"
    pairs.measure("library, dry run", lambda program, _: run(rescale(program, models, "-d", str(dry), "--dry-run")))


if __name__ == "__main__":
    sys.exit(main())
