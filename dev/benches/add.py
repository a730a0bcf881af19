#!/usr/bin/env python3
"""Measures `add` on 1000 models without contacts against rescaling the same 1000 models with them: see README.md."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from library import in_turns, median, ratio, warm_memory, write_texts
from measure import ROOT, Table, build, run

LIMIT = 1.3
TARGET_KG = "80"
PRESET = "falisse2022"
FEET = [f"{part}_{side}" for part in ("calcn", "toes") for side in "rl"]


def main():
    options = arguments()
    command = options.command or build()
    table = Table()
    with tempfile.TemporaryDirectory(prefix="osim-add-", dir=options.folder) as folder:
        folder = Path(folder)
        # Every model takes contacts at once, by its meshes or by factors that are given for all.
        more, texts = models(command, folder)
        bare, full = folder / "bare", folder / "full"
        size = write_texts(texts, bare, options.models)
        # Contacts for all, which are rescaled then.
        run([*add(command, bare, full, *more), "--quiet"])
        warm_memory(2 * (options.rounds + 1) * size)
        table.head(f"{options.models} models, {size / 1e6:.0f} MB, medians of {options.rounds} rounds by turns")
        calls = {
            "add": lambda out: add(command, bare, out, *more),
            "add, dry run": lambda out: [*add(command, bare, out, *more), "--dry-run"],
            "rescale": lambda out: rescale(command, full, out),
            "rescale, dry run": lambda out: [*rescale(command, full, out), "--dry-run"],
        }
        times = in_turns(calls, folder / "runs", options.rounds)
        for name in calls:
            table.row(f"{name}, time", median(times[name], 0), "s")
            table.row(f"{name}, time on processors", median(times[name], 1), "s")
        for suffix in ("", ", dry run"):
            ours, theirs = times[f"add{suffix}"], times[f"rescale{suffix}"]
            table.row(f"add against rescaling{suffix}", ratio(ours, theirs, 0), "x", None if suffix else LIMIT)
            table.row(f"add against rescaling{suffix}, by time on processors", ratio(ours, theirs, 1), "x")
    return table.finish()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--models", type=int, default=1000, help="in the library (default 1000)")
    parser.add_argument("--rounds", type=int, default=7, help="of each call (default 7)")
    parser.add_argument("--command", help="a command built before, instead of building one")
    parser.add_argument("--folder", help="where the models are written (default: the system's temporary folder)")
    return parser.parse_args()


def add(command, models, out, *more):
    return [str(command), "add", str(models), "--from", PRESET, *more, "-d", str(out)]


def rescale(command, models, out):
    return [str(command), str(models), "--target-mass", TARGET_KG, "-d", str(out)]


def models(command, folder):
    """Options, and the texts of models without contacts: the corpus', or our own animals without theirs."""
    corpus = os.environ.get("OSIM_CORPUS")
    if corpus:
        result = [path for path in sorted(Path(corpus).glob("*.osim")) if takes(command, path)]
        return [], [path.read_bytes() for path in result]
    print("OSIM_CORPUS is not set: the humans of Table 1 stand in, with factors given")
    texts = []
    for path in sorted((ROOT / "fixtures" / "table1").glob("human_*.osim")):
        bare = folder / path.name
        subprocess.run([str(command), "remove", str(path), "-o", str(bare)], stdout=subprocess.DEVNULL, check=True)
        texts.append(bare.read_bytes())
        bare.unlink()
    return [option for body in FEET for option in ("--body-scale", f"{body}=1.1")], texts


def takes(command, path):
    """Whether a model gets contacts without a question."""
    call = [str(command), "add", str(path), "--from", PRESET, "--dry-run", "--format", "json"]
    process = subprocess.run(call, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    return process.returncode == 0 and bool(json.loads(process.stdout)["changes"])


if __name__ == "__main__":
    sys.exit(main())
