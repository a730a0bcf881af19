"""Proves that a changed program does what the old one did: the same calls, the same bytes.

    python3 dev/compare_programs OLD NEW --fixtures fixtures [--corpus FOLDER] [--jobs 2] [--quick]

Both programs do thousands of cases, each in a fresh folder of the same name with the same files. Exit status, both
streams and every file that is there afterwards are compared byte for byte. Both programs need the same version number,
since files record it. Exit status: 0 if nothing differs, else 1.

`--map MAP.json` is for fields of JSON that changed on purpose: {"old_name": "new_name", "added": ["only_in_new"]}
(also "columns" and "added_columns", the same for tables). Which options there are, and what can be explained, is read
from the old program.

The modules: `calls` (how a case is written), `store` and `texts` (files), `models`, `particular`, `options` and
`damaged` (the cases; tables of them in `files_tables`, `verb_tables` and `other_tables`), `run` with `changes` and
`streams` (one case), `differ` and `same` (what counts as the same), `report`.
"""

import argparse
import math
import multiprocessing
import sys
import tempfile
import time
import zlib
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import damaged
import models
import options
import particular
import report
from calls import Case
from run import Ground, Result, Settings, remove
from same import Map, Rules
from store import Store

QUICK = 10
# A device that is always full; not every system has one.
FULL = Path("/dev/full")
# A folder in memory: the programs wait for the disk after each file.
MEMORY = Path("/dev/shm")


def main() -> int:
    """Does all of it; gives the exit status."""
    args = arguments()
    sys.stdout.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    store = Store(args.fixtures.resolve(), args.corpus and args.corpus.resolve())
    chosen = all_cases(store, args.old.resolve())
    chosen = quick(chosen) if args.quick else chosen
    chosen = [case for case in chosen if all(word in case.call for word in args.only)]
    if args.list:
        print("\n".join(case.call for case in chosen))
        return 0
    changed = Map.read(args.map) if args.map else Map()
    print("\n".join([f"{len(chosen)} cases", *changed.lines()]), flush=True)
    began = time.monotonic()
    results = compare(chosen, args, Rules(changed, args.ignore_settings, args.models_only))
    print(report.table(chosen, results))
    print(f"{time.monotonic() - began:.0f} s")
    found = report.groups(results)
    if found:
        print("\nWhat differs, by its first differing line:\n" + report.told_groups(chosen, found))
        print("\nSome of it in full:\n" + report.told_cases(chosen, found, args.show))
    return 1 if found else 0


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(prog="compare_programs", description="Compare two builds of osim-contact-scale.")
    parser.add_argument("old", type=Path, help="the program as it was")
    parser.add_argument("new", type=Path, help="the program as it is now")
    parser.add_argument("--fixtures", type=Path, required=True, help="the project's folder of fixtures")
    parser.add_argument("--corpus", type=Path, help="a folder with models of other people")
    parser.add_argument("--jobs", type=int, default=2, help="cases at once (default: 2)")
    parser.add_argument("--quick", action="store_true", help=f"one case in {QUICK}, some of each kind")
    parser.add_argument("--only", action="append", default=[], metavar="WORD", help="cases whose call holds WORD")
    parser.add_argument("--list", action="store_true", help="print the cases and do nothing")
    parser.add_argument("--map", type=Path, help="names of JSON fields that changed on purpose")
    parser.add_argument("--ignore-settings", action="store_true", help="do not compare the digest of settings in summaries")
    parser.add_argument("--models-only", action="store_true", help="compare exit statuses and models, not what is said")
    parser.add_argument("--show", type=int, default=10, metavar="N", help="differing cases shown in full (default: 10)")
    parser.add_argument("--time-limit", type=float, default=60, metavar="S", help="for each call (default: 60 s)")
    parser.add_argument("--work", type=Path, default=MEMORY if MEMORY.is_dir() else None, help="where to make folders")
    return parser.parse_args()


def all_cases(store: Store, old: Path) -> list[Case]:
    """Every case, no call twice."""
    cases: dict[str, Case] = {}
    for source in (models.cases(store), particular.cases(store, old), options.cases(store, old), damaged.cases(store)):
        for case in source:
            if not case.call.endswith("> full") or FULL.exists():
                cases.setdefault(case.call, case)
    return list(cases.values())


def quick(cases: list[Case]) -> list[Case]:
    """A tenth of the cases of each family and verb, always the same ones."""
    kinds: dict[tuple[str, str], list[Case]] = defaultdict(list)
    for case in cases:
        kinds[case.family, case.verb].append(case)
    kept: set[str] = set()
    for members in kinds.values():
        mixed = sorted(members, key=lambda case: zlib.crc32(case.call.encode("utf-8", "surrogateescape")))
        kept.update(case.call for case in mixed[: math.ceil(len(mixed) / QUICK)])
    return [case for case in cases if case.call in kept]


def compare(cases: list[Case], args: argparse.Namespace, rules: Rules) -> list[Result]:
    """The results of all cases, in their order."""
    folder = Path(tempfile.mkdtemp(prefix="compare_programs-", dir=args.work)).resolve()
    settings = Settings(args.old.resolve(), args.new.resolve(), folder, args.time_limit, rules)
    number = multiprocessing.Value("i", 0)
    try:
        with multiprocessing.Pool(args.jobs, begin, (settings, number)) as pool:
            done = pool.imap_unordered(one, enumerate(cases), chunksize=4)
            return sorted(watched(done, len(cases)), key=lambda result: result.case)
    finally:
        remove(folder)


def begin(settings: Settings, number) -> None:  # type: ignore[no-untyped-def]
    """Gives a worker its folder."""
    global ground
    with number.get_lock():
        number.value += 1
        ground = Ground(settings, number.value)


def one(numbered: tuple[int, Case]) -> Result:
    """One case, in a worker."""
    return ground.compare(*numbered)


def watched(results: Iterator[Result], count: int) -> Iterator[Result]:
    """Tells on a terminal how far it is."""
    differ = 0
    for done, result in enumerate(results, start=1):
        differ += bool(result.differences)
        if sys.stderr.isatty() and (done % 50 == 0 or done == count):
            end = "\n" if done == count else ""
            print(f"\r{done} of {count}, {differ} differ", end=end, file=sys.stderr, flush=True)
        yield result


ground: Ground

if __name__ == "__main__":
    sys.exit(main())
