#!/usr/bin/env python3
"""How the processor time of every verb grows from a thousand of something to a hundred thousand.

    tests/growth/large.py PROGRAM [--only VERB_OR_KIND...]

What grows with the square of a large model alone is not seen by `growth.py`, whose models are small: it counts instructions, and a
hundred thousand forces would take it hours. Here the exponent from N to 100 N may be at most 1.2, without what next to nothing takes.
"""

import argparse
import math
import os
import shutil
import sys
import tempfile
from pathlib import Path

import growth

N, TIMES, LIMIT = 1_000, 100, 1.2
# The shorter run is repeated: its time is that of the quickest.
REPEATED = 3
# Processor time beyond which a run is ended, s, and memory, bytes.
MOST_S, MOST_BYTES = 300, 12 << 30
# A hundred thousand files are a test of the disk.
LEFT_OUT = {"files"}
# What grows in one more thing than forces, where small models cannot show it.
MORE = {"check": ["chain+", "shared", "one force"], "convert smooth": ["apart"], "plot feet": ["chain+"], "inspect": ["spheres"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="+", help="only these verbs or kinds")
    options = parser.parse_args()
    program = str(Path(options.program).resolve())
    pairs = [(verb, kind) for verb, (_, kinds) in growth.VERBS.items() for kind in [kinds[0], *MORE.get(verb, [])]]
    pairs = [(verb, kind) for verb, kind in pairs if kind not in LEFT_OUT]
    if options.only:
        pairs = [pair for pair in pairs if set(pair) & set(options.only)]
    failed = 0
    with tempfile.TemporaryDirectory(prefix="osim-large-") as folder:
        for verb, kind in pairs:
            least = min(seconds(program, folder, verb, kind, growth.LEAST) for _ in range(REPEATED))
            few = min(seconds(program, folder, verb, kind, N) for _ in range(REPEATED))
            many = seconds(program, folder, verb, kind, N * TIMES)
            # A clock that counts hundredths of a second.
            own = math.log((many - least) / max(few - least, 0.01)) / math.log(TIMES) if many > least else 0.0
            bad = not own <= LIMIT
            failed += bad
            print(f"{'FAIL' if bad else 'pass'} {verb:16} {kind:10} {own:5.2f}   {few:6.2f} s, {many:6.2f} s", flush=True)
    print(f"\n{failed} grow too fast" if failed else "\neverything grows as it should")
    return 1 if failed else 0


def seconds(program, folder, verb, kind, size):
    """Processor time of a call; infinite where it is refused or ended."""
    place = Path(tempfile.mkdtemp(dir=folder))
    call = growth.prepared(place, verb, kind, size)
    if (child := os.fork()) == 0:
        begin(program, [str(word) for word in call], place)
    _, status, used = os.wait4(child, 0)
    said = (place / "said").read_bytes()
    refused = os.waitstatus_to_exitcode(status) not in (0, 1) or b"\nerror:" in b"\n" + said
    if refused:
        print(f"{verb}, {kind}, {size}: {os.waitstatus_to_exitcode(status)} {said[-300:].decode(errors='replace')}", file=sys.stderr)
    shutil.rmtree(place)
    return math.inf if refused else used.ru_utime + used.ru_stime


def begin(program, call, place):
    """The child: one thread, and not for ever."""
    import resource

    os.chdir(place)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.dup2(os.open("said", os.O_WRONLY | os.O_CREAT), 2)
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_S, MOST_S))
    resource.setrlimit(resource.RLIMIT_AS, (MOST_BYTES, MOST_BYTES))
    os.execve(program, [program, *call], os.environ | {"RAYON_NUM_THREADS": "1"})


if __name__ == "__main__":
    sys.exit(main())
