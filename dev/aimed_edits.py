#!/usr/bin/env python3
"""Saves into a model at the moment when it is changed in place, again and again, and looks for every save afterwards.

    dev/aimed_edits.py [PROGRAM] [--edits N] [--jobs N] [--seed N]

A save is a whole model with a mark of its own. Afterwards the mark must be in the model, or in one of its backups: else it
was lost. Savers do what editors do: a new file is renamed over the model; the model is emptied and written; or a program
that has the model open all the time writes at its end. Half of the saves come as soon as the backup has its name, when the
model is about to be replaced; the others at any moment of the run. Exit status 1 where a save was lost.
"""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MODEL = (ROOT / "fixtures/table1/human_62kg_smooth_sphere.osim").read_bytes()
SAVERS = ("renamed", "rewritten", "appended")


def wait(seconds):
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        pass


def save(saver, model, mark, open_file):
    """Saves as an editor does."""
    if saver == "appended":
        open_file.seek(0, os.SEEK_END)
        open_file.write(mark)
        open_file.flush()
        return
    if saver == "rewritten":
        with open(model, "wb") as file:
            file.write(MODEL + mark)
        return
    new = model.with_name("saved.tmp")
    new.write_bytes(MODEL + mark)
    os.replace(new, model)


def run_and_save(number, program, seed, usual):
    """The result of a run and a save: what the run said, and where the save is."""
    dice = random.Random(f"{seed} {number}")
    saver, aimed = SAVERS[number % 3], number % 2 == 0
    mark = f"<!-- saved {number} -->\n".encode()
    with tempfile.TemporaryDirectory(prefix="aimed-") as folder:
        model = pathlib.Path(folder) / "model.osim"
        model.write_bytes(MODEL)
        open_file = open(model, "r+b") if saver == "appended" else None
        call = [program, "model.osim", "--target-mass", "500", "--in-place", "--quiet"]
        run = subprocess.Popen(call, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if aimed:
            backup = str(model) + ".bak"
            while not os.path.exists(backup) and run.poll() is None:
                pass
            wait(dice.uniform(0, 0.0004))
        else:
            wait(dice.uniform(0, usual))
        in_time = run.poll() is None
        save(saver, model, mark, open_file)
        output = run.communicate()[1].decode()
        if open_file:
            open_file.close()
        texts = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
        leftovers = [name for name in texts if name.endswith(".tmp") or ".replaced-" in name]
        where = [name for name, text in texts.items() if mark in text]
        is_complete = MODEL in texts.get("model.osim.bak", MODEL) or "model.osim.bak" in where
    if run.returncode not in (0, 1) or leftovers or not is_complete:
        raise SystemExit(f"save {number} ({saver}): exit status {run.returncode}, left {leftovers}, {output}")
    place = "lost" if not where else "in the model" if "model.osim" in where else "in a backup"
    return saver, "during the run" if in_time else "after it", "changed" if run.returncode == 0 else "refused", place


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="?", default=str(ROOT / "target/release/osim-contact-scale"))
    parser.add_argument("--edits", type=int, default=2000, help="saves while a run is going on")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=time.time_ns() % 1_000_000)
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    begin = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(5):
            (pathlib.Path(folder) / "model.osim").write_bytes(MODEL)
            call = [program, "model.osim", "--target-mass", "500", "--in-place", "--quiet", "--no-backup"]
            subprocess.run(call, cwd=folder, check=True)
    usual = (time.perf_counter() - begin) / 5
    print(f"seed {options.seed}; a run takes {usual * 1000:.0f} ms")
    counts, number, hit = collections.Counter(), 0, 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        while hit < options.edits:
            batch = range(number, number + 100)
            number += 100
            for outcome in pool.map(lambda n: run_and_save(n, program, options.seed, usual), batch):
                counts[outcome] += 1
                hit += outcome[1] == "during the run"
    for outcome, count in sorted(counts.items()):
        print(f"{count:6}  {', '.join(outcome)}")
    lost = sum(count for outcome, count in counts.items() if outcome[3] == "lost")
    print(f"{hit} saves during runs, {number - hit} after them; lost: {lost}")
    sys.exit(1 if lost else 0)


if __name__ == "__main__":
    main()
