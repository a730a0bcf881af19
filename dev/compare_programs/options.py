"""Every option of every verb: alone, in pairs, and with values that make no sense.

Which options a verb has is read from the old program's own help, so that none is forgotten.
"""

import re
import subprocess
import zlib
from collections.abc import Iterable, Iterator
from itertools import combinations
from pathlib import Path

from calls import VERBS, Case
from models import lines
from store import Store

# Text that goes on in the next line stands further in.
OPTION = re.compile(r"^(?:  -\w, |      )(--[a-z-]+)(?: <([^>]+)>)?", re.MULTILINE)
NO_OPTION = ("--help", "--version")

# Calls that options are added to; the second number says how many pairs are tried at most.
BASES: dict[str, tuple[tuple[str, int], ...]] = {
    "rescale": (("rescale model.osim --target-mass 500", 250),),
    "transfer": (
        ("transfer scaled.osim --from generic.osim", 200),
        ("transfer scaled.osim --from generic.osim --follow-bodies", 180),
    ),
    "design": (("design model.osim --indentation 0.16", 180), ("design --mass 62 --spheres 6", 150)),
    "set": (("set model.osim stiffness=x2", 200),),
    "batch": (("batch masses.csv", 130),),
    "sweep": (
        ("sweep model.osim --grid stiffness=x1,x2", 180),
        ("sweep model.osim --ladder 3 --indentation 0.16", 120),
    ),
    "inspect": (("inspect scaled.osim", 130),),
    "check": (("check model.osim", 120),),
    "drop-test": (
        ("drop-test model.osim", 150),
        ("drop-test --mass 62 --spheres 6 --radius 0.032 --stiffness 1e6 --dissipation 0.5", 100),
    ),
    "plot": (("plot force model.osim -o figure.svg", 130), ("plot sweep model.osim -o -", 100)),
    "fit": (("fit curve.csv --radius 0.032", 90),),
    "presets": (("presets --presets both.toml", 10),),
    "explain": (("explain C.5 sunk-in", 10),),
    "completions": (("completions bash", 1),),
    "man": (("man", 10),),
}

# Values that make sense; the first is the one of pairs. `VERB OPTION` is about one verb alone.
GOOD: dict[str, tuple[str, ...]] = {
    "--target-mass": ("500", "1e-3", "62."),
    "--contacts-mass": ("70", "53"),
    "--mass": ("70", "0.0209"),
    "--exclude-body": ("toes*", "{}*"),
    "--radius": ("0.05", "keep", "isometric", "x1.5"),
    "drop-test --radius": ("0.05",),
    "fit --radius": ("0.05",),
    "--level-axis": ("z", "y", "-x", "x"),
    "--only": ("stiffness,dissipation", "radius"),
    "--keep": ("hertz_smoothing", "radius,viscous_friction"),
    "--dissipation-by": ("mass", "radius"),
    "--contacts-gravity": ("9.81",),
    "--target-gravity": ("1.62",),
    "--select": ("*_r*", "contact_heel_?", "[!c]*", "{*_r,*_l}"),
    "--exclude": ("*_l*",),
    "--output": ("out.osim", "-", "deep/out.osim"),
    "plot --output": ("second.svg",),
    "--geometry-output": ("g.xml",),
    "--output-dir": ("out", "."),
    "--format": ("json", "table", "lines", "csv"),
    "--report": ("page.html",),
    "--jobs": ("2", "1"),
    "--summary": ("done.csv", "done.ndjson"),
    "--shard": ("1/2", "2/2"),
    "--geometry": ("geometry.xml",),
    "--model": ("bones.osim",),
    "--from": ("generic.osim", "falisse2022"),
    "--presets": ("both.toml",),
    "--spheres": ("2", "12"),
    "--stance-limbs": ("2",),
    "--reference-mass": ("75",),
    "--reference-spheres": ("3",),
    "--reference-gravity": ("1.62",),
    "--reference-select": ("*_r*",),
    "--reference-sphere": ("heel_r",),
    "--body-scale-file": ("applied.xml",),
    "--body-scale": ("calcn_r=1.1,1,0.9",),
    "--radius-axis": ("y", "min", "max", "geomean"),
    "--moved-spheres": ("keep", "replace"),
    "--rule": ("predsim", "paper"),
    "--height-ratio": ("0.95",),
    "--indentation": ("0.1", "1"),
    "--contact-stiffness": ("20000",),
    "--young": ("1e5",),
    "--poisson": ("0.49", "-0.5"),
    "--stiffness": ("2e6",),
    "plot --stiffness": ("x0.5..x2/3", "1e5..1e7/4"),
    "--restitution": ("0.8", "0", "1"),
    "--impact-speed": ("0.4",),
    "--constant-indentation": ("0.05",),
    "--state-width": ("0.3",),
    "--speed-width": ("0.3",),
    "--threshold": ("0.1",),
    "--load": ("700",),
    "--body-weights": ("2",),
    "--gravity": ("1.62",),
    "--grid": ("dissipation=1,x2", "target-mass=70,80"),
    "--ladder": ("3",),
    "--soft": ("1.5",),
    "--deny": ("warn", "error"),
    "--height": ("x0.5", "0.01"),
    "--duration": ("0.5",),
    "--samples": ("5",),
    "--compare": ("falisse2022", "human.osim"),
    "--compare-spheres": ("6",),
    "--dissipation": ("0.7",),
    "plot --dissipation": ("0.5..2/3", "x0.5..x2/3"),
    "--constant-contact-force": ("1e-5",),
    "--hertz-smoothing": ("300",),
    "--hunt-crossley-smoothing": ("50",),
    "--axes": ("real", "dimensionless"),
    "--title": ("A title",),
    "--dpi": ("100",),
    "--quantity": ("restitution", "peak-force", "indentation"),
    "--onset": ("0.0005", "fit"),
    "--branch": ("loading", "unloading", "both"),
    "--indentation-column": ("indentation",),
    "--force-column": ("force",),
    "--speed-column": ("speed",),
    "--time-column": ("time",),
    "--indentation-unit": ("mm", "um"),
    "--force-unit": ("kN", "mN"),
    "--speed-unit": ("mm/s",),
    "--time-unit": ("ms",),
}
BAD = ("nan", "-3", "0", "20kg", "0,02", "1,190", "''", "nothing/there")

WRONG = r"""
{base} --nonsense
{base} --nonsense=5
{base} -z
{base} -q
{base} --targetmass 5
{base} --format yaml
{base} --format
{base} --dry-runs
{base} --dry-run=yes
{base} --quiet --quiet
{base} --diff --quiet
{base} -o a.osim -d out
{base} -o a.osim --in-place
{base} -d out --in-place
{base} --no-backup
{base} --resume
{base} --summary s.csv --resume --dry-run
{base} --summary s.txt
{base} -o - --format json
{base} -o - --diff
{base} -o - --report page.html
{base} -oout.osim
{base} -o=out.osim
{base} -dout --format=lines
{base} nowhere.osim
{base} --
{base} -- --format
{base} --jobs 0
{base} --shard 3/2
{base} --level-axis z
{base} --only stifness
{base} --keep ''
{base} --select [
{base} --select ''
{base} --radius 32mm
{base} --radius big
{base} --target-m 500
{base} --geometry geometry.xml
{base} --model bones.osim
"""


def cases(store: Store, program: Path) -> Iterator[Case]:
    """All of them, verb by verb."""
    for verb in VERBS:
        options = options_of(program, verb)
        for base, most in BASES[verb]:
            yield from (store.case("single options", call) for call in singles(verb, base, options))
            yield from (store.case("pairs of options", call) for call in some(pairs(verb, base, options), most))
        base = BASES[verb][0][0]
        yield from (store.case("bad values", call) for call in bad_values(base, options))
        yield from (store.case("wrong usage", line.replace("{base}", base)) for line in lines(WRONG))


def options_of(program: Path, verb: str) -> dict[str, bool]:
    """Long options of a verb, and whether each takes a value."""
    told = subprocess.run([program, verb, "--help"], capture_output=True, check=True, timeout=60)
    found = OPTION.findall(told.stdout.decode("utf-8"))
    return {name: bool(value) for name, value in found if name not in NO_OPTION}


def said(verb: str, option: str, takes_value: bool) -> list[str]:
    """The option with each value that makes sense."""
    if not takes_value:
        return [option]
    values = GOOD.get(f"{verb} {option}") or GOOD.get(option) or ("1",)
    return [f"{option} '{value}'" for value in values]


def singles(verb: str, base: str, options: dict[str, bool]) -> Iterator[str]:
    """Each option with each good value, and twice."""
    for option, takes_value in options.items():
        forms = said(verb, option, takes_value)
        yield from (f"{base} {form}" for form in forms)
        yield f"{base} {forms[0]} {forms[-1]}"
        if takes_value:
            yield f"{base} {forms[0].replace(' ', '=', 1)}"


def pairs(verb: str, base: str, options: dict[str, bool]) -> list[str]:
    """Each option with each other one."""
    first = [said(verb, option, takes_value)[0] for option, takes_value in options.items()]
    return [f"{base} {one} {other}" for one, other in combinations(first, 2)]


def bad_values(base: str, options: dict[str, bool]) -> Iterator[str]:
    """Each option with values that make no sense, and without one."""
    for option, takes_value in options.items():
        if takes_value:
            yield from (f"{base} {option} {value}" for value in BAD)
            yield f"{base} {option}"
        else:
            yield f"{base} {option}=yes"


def some(calls: Iterable[str], most: int) -> list[str]:
    """At most so many of the calls, chosen as if at random, but always the same ones; in their order."""
    found = list(calls)
    chosen = sorted(found, key=lambda call: zlib.crc32(call.encode()))[:most]
    kept = set(chosen)
    return [call for call in found if call in kept]
