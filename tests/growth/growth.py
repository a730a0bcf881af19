#!/usr/bin/env python3
"""How the work of every verb grows with the size of what it is given: counted in instructions, not timed.

    tests/growth/growth.py PROGRAM [--only VERB_OR_KIND...]

Valgrind's callgrind counts what each function of the program executes, at N and 4 N of a kind (forces, bodies, ...), less
what it executes for a model of next to nothing. The whole may grow with an exponent of at most 1.1, and no function of weight
with more than 1.35: a loop within a loop shows there long before it shows in the whole. (Sorting grows with 1.16 here.)
"""

import argparse
import collections
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import models

LEAST, N, TIMES = 4, 64, 4
MOTION = Path(__file__).resolve().parents[2] / "fixtures/motion"
LIMIT, LIMIT_OF_FUNCTION = 1.1, 1.35
# No loops within loops grow so fast: what does so is hardly called at N, such as for the first long label of a picture.
JUMP = 4
# Of the whole at 4 N, and in instructions; less than this is noise, such as of tables whose hashes differ from run to run.
WEIGHT, LEAST_WEIGHT = 0.01, 250_000
# Functions whose work comes in jumps: short lists are sorted in another way, freed memory is joined now and then, lines are
# broken (smawk, optimal fit) only where they are long, tanh calls expm1 near 0 only, long labels are written where there are
# some, and longer vectors are copied when they grow. What they do is counted in the whole.
IN_JUMPS = re.compile(
    r"expm1|fmt::write|sort|smawk|optimal_fit|malloc|free|alloc|unlink_chunk|hash.*(reserve|rehash|resize)|grow|drop_in_place|memset|memcpy"
)

ALL = list(models.KINDS)
# In what every verb may grow that is given a model: forces, spheres, joints and names.
COMMON = ["forces", "spheres", "bodies", "chain", "same name", "named"]
SOME = ["forces", "bodies", "circle", "chain+", "defaults"]
MODEL, OUT = "MODEL", "OUT"
DESIGN_OPTIONS = ["--indentation", "0.3", "--restitution", "0.5"]
SPHERE_OPTIONS = [*DESIGN_OPTIONS, "--spheres", "2", "--class", "smooth"]
# Verb, the call, and in what it may grow. A call that follows bodies is given the model before they were scaled.
VERBS = {
    "inspect": (["inspect", MODEL], ["forces", "spheres", "findings"]),
    "inspect csv": (["inspect", MODEL, "--format", "csv"], ["forces"]),
    "inspect json": (["inspect", MODEL, "--format", "json"], ["bodies"]),
    "inspect --from": (["inspect", MODEL, "--from", "GENERIC"], ["bodies", "chain+"]),
    "inspect mass": (["inspect", MODEL, "--target-mass", "50"], ["forces", "bodies"]),
    "check": (["check", MODEL], ALL),
    "check --from": (["check", MODEL, "--from", "GENERIC"], ["forces", "bodies"]),
    "add": (["add", MODEL, "--from", "GENERIC", "--replace", "-o", OUT], ["forces", "bodies", "foundations"]),
    "add level": (["add", MODEL, "--from", "GENERIC", "--replace", "--level", "-o", OUT], ["forces"]),
    "add table": (["add", MODEL, "--contacts", "PLACES", "--replace", *SPHERE_OPTIONS, "-o", OUT], ["places"]),
    "add table from": (["add", MODEL, "--contacts", "PLACES", "--from", "GENERIC", "--replace", "-o", OUT], ["places"]),
    "motion": (["motion", MODEL, "MOTION"], ["forces", "bodies", "frames"]),
    "motion plates": (["motion", MODEL, "MOTION", "--plates", "PLATES", "--loads", "LOADS", "--format", "csv"], ["frames"]),
    "check --motion": (["check", MODEL, "--motion", "MOTION", "--plates", "PLATES", "--loads", "LOADS"], ["frames"]),
    "fit motion": (["fit", MODEL, "--motion", "MOTION", "--plates", "PLATES", "--loads", "LOADS", "--fit", "height", "--yes", "poor-fit", "-o", OUT], ["frames"]),
    "plot motion": (["plot", "motion", MODEL, "--motion", "MOTION", "-o", "OUT.svg"], ["frames"]),
    "plot force": (["plot", "force", MODEL, "-o", "OUT.svg"], ["forces"]),
    "plot feet": (["plot", "feet", MODEL, "-o", "OUT.svg"], ["forces", "bodies", "chain", "chain+"]),
    "fit": (["fit", "DATA", "--radius", "0.03"], ["rows"]),
    "diff": (["rescale", MODEL, "--target-mass", "500", "--diff", "--dry-run"], ["forces"]),
    "request": (["request", "REQUEST"], ["forces"]),
    "rescale": (["rescale", MODEL, "--target-mass", "500", "-o", OUT], SOME),
    "follow bodies": (["transfer", MODEL, "--from", "GENERIC", "--follow-bodies", "-o", OUT], ["forces", "bodies"]),
    "report": (["rescale", MODEL, "--target-mass", "500", "-o", OUT, "--report", "OUT.html"], ["findings"]),
    "transfer": (["transfer", MODEL, "--from", "GENERIC", "-o", OUT], ["forces", "bodies"]),
    "set level": (["set", MODEL, "radius=x1.1", "--level", "-o", OUT], ["forces"]),
    "set": (["set", MODEL, "stiffness=x2", "-o", OUT], ["forces", "shared"]),
    "design": (["design", MODEL, "--indentation", "0.1", "-o", OUT], ["forces", "chain+"]),
    "note": (["note", MODEL, "--contacts-mass", "80", "-o", OUT], ["bodies", "brackets"]),
    "remove": (["remove", MODEL, "-o", OUT], ["forces", "spheres", "shared"]),
    "remove some": (["remove", MODEL, "--exclude", "f*0", "-o", OUT], ["forces"]),
    "convert": (["convert", MODEL, "--to", "hunt-crossley", "-o", OUT], ["forces", "spheres", "same name", "defaults"]),
    "convert smooth": (["convert", MODEL, "--to", "smooth", "--yes", "wrong-afterwards", "-o", OUT], ["named", "one force", "apart", "many sets", "radii"]),
    "sockets": (["convert", MODEL, "--sockets", "-o", OUT], ["bare sockets"]),
    "sweep": (["sweep", MODEL, "--grid", "stiffness=x1,x2", "-d", OUT, "--jobs", "1"], ["forces"]),
    "ladder": (["sweep", MODEL, "--ladder", "2", *DESIGN_OPTIONS, "-d", OUT, "--jobs", "1"], ["forces"]),
    "steps": (["sweep", "SMALL", "--ladder", "COUNT", *DESIGN_OPTIONS, "-d", OUT, "--jobs", "1"], ["files"]),
    "drop-test": (["drop-test", MODEL, "--duration", "0.01"], ["forces"]),
    "files": (["rescale", "FOLDER", "--target-mass", "500", "-d", OUT, "--summary", "OUT.csv", "--jobs", "1"], ["files"]),
    "inspect files": (["inspect", "FOLDER"], ["files"]),
    "check files": (["check", "FOLDER"], ["files"]),
    "add files": (["add", "FOLDER", "--from", "SMALL", "--replace", "-d", OUT, "--jobs", "1"], ["files"]),
    "convert files": (["convert", "FOLDER", "--to", "hunt-crossley", "-d", OUT, "--jobs", "1"], ["files"]),
    "set files": (["set", "FOLDER", "stiffness=x2", "-d", OUT, "--jobs", "1"], ["files"]),
    "design files": (["design", "FOLDER", "--indentation", "0.1", "-d", OUT, "--jobs", "1"], ["files"]),
    "transfer files": (["transfer", "FOLDER", "--from", "SMALL", "-d", OUT, "--jobs", "1"], ["files"]),
    "note files": (["note", "FOLDER", "--contacts-mass", "80", "-d", OUT, "--jobs", "1"], ["files"]),
    "remove files": (["remove", "FOLDER", "-d", OUT, "--jobs", "1"], ["files"]),
    "batch": (["batch", "TABLE", "-d", OUT, "--jobs", "1"], ["files"]),
    "points": (["sweep", "SMALL", "--grid", "stiffness=x1..x2/COUNT", "-d", OUT, "--jobs", "1"], ["files"]),
}
for words, kinds in VERBS.values():
    if MODEL in words and not {"PLATES", "PLACES", "--sockets"} & set(words):
        kinds += [kind for kind in COMMON if kind not in kinds]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="+", help="only these verbs or kinds")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        print("skipped: growth of the work: no valgrind here to count instructions with")
        return 0
    pairs = [(verb, kind) for verb, (_, kinds) in VERBS.items() for kind in kinds]
    if options.only:
        pairs = [pair for pair in pairs if set(pair) & set(options.only)]
    program = Path(options.program).resolve()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="osim-growth-") as folder:
        with ThreadPoolExecutor(os.cpu_count()) as workers:
            for text, is_bad in workers.map(lambda pair: growth_of_call(program, Path(folder), *pair), pairs):
                failed += is_bad
                print(text, flush=True)
    print(f"\n{failed} grow too fast" if failed else "\neverything grows as it should")
    return 1 if failed else 0


def growth_of_call(program, folder, verb, kind):
    """The line of a verb and kind, and whether it grows too fast."""
    least, few, many = (count_instructions(program, folder, verb, kind, size) for size in (LEAST, N, TIMES * N))
    if None in (least, few, many):
        return f"FAIL {verb:16} {kind:10} the program refused", True
    total = sum(many.values())
    whole = exponent(*(sum(counts.values()) for counts in (least, few, many)))
    fast = []
    for name, count in many.items():
        own = exponent(least[name], few[name], count)
        if count > max(WEIGHT * total, LEAST_WEIGHT) and LIMIT_OF_FUNCTION < own < JUMP and not IN_JUMPS.search(name):
            fast.append((count / total, own, name))
    bad = whole > LIMIT or bool(fast)
    lines = [f"{'FAIL' if bad else 'pass'} {verb:16} {kind:10} {whole:5.2f}   {total / 1e6:7.1f} million instructions"]
    lines += [f"       {share:6.1%} {own:5.2f}  {name[:110]}" for share, own, name in sorted(fast, reverse=True)]
    return "\n".join(lines), bad


def exponent(least, few, many):
    """The exponent with which the instructions grow from N to 4 N; a function that is not called for N grows from 0."""
    if many <= least:
        return 0.0
    return math.log((many - least) / max(few - least, 1)) / math.log(TIMES)


def count_instructions(program, folder, verb, kind, size):
    """Instructions of each function; `None` where the program refuses."""
    place = Path(tempfile.mkdtemp(dir=folder))
    call = prepared(place, verb, kind, size)
    out = place / "callgrind"
    counting = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
    results = run([*counting, program, *call], place)
    if results is None or not out.exists():
        return None
    counts = functions(out)
    shutil.rmtree(place)
    return counts


def run(call, place):
    """The output of the program on one thread; `None` where it refuses."""
    environment = os.environ | {"RAYON_NUM_THREADS": "1"}
    process = subprocess.run(call, cwd=place, env=environment, capture_output=True)
    if process.returncode not in (0, 1) or b"\nerror:" in b"\n" + process.stderr:
        print(process.stderr.decode(errors="replace")[-2000:], file=sys.stderr)
        return None
    return process


def prepared(place, verb, kind, size):
    """Writes the files that the call needs into `place`, and returns the arguments of the call."""
    written = {"GENERIC": place / "generic.osim", OUT: place / "out", "FOLDER": place / "library"}
    if kind == "files":
        small = models.KINDS["forces"](LEAST)
        (place / "library").mkdir()
        names = [f"model{number:05}.osim" for number in range(size)]
        for name in names:
            (place / "library" / name).write_text(small)
        rows = [f"library/{name},{500 + number}" for number, name in enumerate(names)]
        (place / "table.csv").write_text("\n".join(["model,target-mass", *rows, ""]))
        written |= {"TABLE": place / "table.csv", "SMALL": place / "library" / names[0]}
    elif kind == "rows":
        # (3) of a sphere of 1 MN/m2, with the noise of an instrument.
        steps = [(i / size, 1e-3 * math.sin(math.pi * i / size)) for i in range(1, size)]
        rows = [f"{t},{x},{4 / 3 * 1e6 * math.sqrt(0.03) * x**1.5 + 0.01 * (-1) ** i}" for i, (t, x) in enumerate(steps)]
        (place / "data.csv").write_text("\n".join(["time,indentation,force", *rows, ""]))
        written["DATA"] = place / "data.csv"
    elif kind == "frames":
        # Eight frames of the walk for each, because a spline needs some, with five rows of plates for each frame.
        size *= 8
        for name in ("walker.osim", "plates.xml"):
            shutil.copy(MOTION / name, place)
        (place / "motion.mot").write_text(repeat_rows(MOTION / "walk.mot", size, 0.01))
        (place / "plates.sto").write_text(repeat_rows(MOTION / "plates.sto", 5 * size, 0.002))
        written |= {MODEL: place / "walker.osim", "MOTION": place / "motion.mot"}
        written |= {"PLATES": place / "plates.sto", "LOADS": place / "plates.xml"}
    else:
        kind, least = ("forces", LEAST) if kind == "places" else (kind, size)
        (place / "model.osim").write_text(models.KINDS[kind](least))
        (place / "generic.osim").write_text(models.KINDS[kind](size))
        # In rows and columns under each foot, so that no two are at the same place.
        width = math.isqrt(size) + 1
        rows = [
            f"n{i // 2}_{'rl'[i % 2]},foot0_{'rl'[i % 2]},{i // 2 % width / width / 5},-0.02,{i // 2 // width / width / 5},0.03" for i in range(size)
        ]
        (place / "places.csv").write_text("\n".join(["name,body,x,y,z,radius", *rows, ""]))
        (place / "motion.mot").write_text(models.STILL)
        (place / "request.json").write_text(json.dumps({"verb": "set", "models": ["model.osim"], "set": {"stiffness": "x2"}, "dry_run": True}))
        written |= {MODEL: place / "model.osim", "MOTION": place / "motion.mot", "PLACES": place / "places.csv"}
        written["REQUEST"] = place / "request.json"
    return [filled(word, written, size) for word in VERBS[verb][0]]


def repeat_rows(path, rows, step):
    """The table at `path`, which repeats itself, with so many rows, `step` seconds apart."""
    lines = path.read_text().splitlines()
    head = lines.index("endheader") + 2
    cells = [line.split("\t")[1:] for line in lines[head:-1]]
    longer_rows = ["\t".join([f"{row * step:.9g}", *cells[row % len(cells)]]) for row in range(rows)]
    return "\n".join([*lines[:head], *longer_rows, ""])


def filled(word, written, size):
    for name, path in written.items():
        if word == name or word.startswith(f"{name}."):
            return word.replace(name, str(path), 1)
    return word.replace("COUNT", str(size))


COST = re.compile(r"^(?:\+|-|\*|\d)\S* (\d+)$")


def functions(out):
    """The instructions that each function executes itself, without those that it calls, from callgrind's file."""
    counts, names = collections.Counter(), {}
    current, skip = None, False
    with open(out, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            line = line.rstrip("\n")
            if line.startswith("fn="):
                number, _, name = line[3:].partition(" ")
                current = names.setdefault(number, re.sub(r"'\d+$", "", name))
            elif line.startswith("cfn="):
                number, _, name = line[4:].partition(" ")
                if name:
                    names.setdefault(number, re.sub(r"'\d+$", "", name))
            elif line.startswith("calls="):
                skip = True
            elif cost := COST.match(line):
                if not skip and current is not None:
                    counts[current] += int(cost[1])
                skip = False
    return counts


if __name__ == "__main__":
    sys.exit(main())
