"""Calls about particular things: libraries, manifests, sweeps, followed bodies, plots, measurements, presets, help.

The language of the lines: `calls.py`. What stands under which short name: `store.py` and `texts.py`.
"""

import json
import re
import shlex
import subprocess
from collections.abc import Iterator
from pathlib import Path

from calls import VERBS, Case
from files_tables import FILES, LIBRARIES, SETS
from models import lines
from other_tables import SHEETS
from store import Store
from texts import MANIFESTS, MEASUREMENTS, PRESETS
from verb_tables import FIT, FOLLOW, PLOTS, SWEEPS

SHELLS = ("bash", "elvish", "fish", "powershell", "zsh")
EXAMPLE = "$ osim-contact-scale "


def cases(store: Store, program: Path) -> Iterator[Case]:
    """All of them; `program` is asked what it can explain."""
    tables = {
        "files": FILES,
        "libraries": LIBRARIES,
        "standalone sets": SETS,
        "followed bodies": FOLLOW,
        "sweeps": SWEEPS,
        "plots": PLOTS,
        "measurements": FIT,
        "calculator, drops, presets": SHEETS,
    }
    for family, table in tables.items():
        for line in lines(table):
            yield store.case(family, line)
    for family, calls in (
        ("manifests", manifests()),
        ("measurements", measurements()),
        ("presets", presets()),
        ("moved spheres", moved_spheres()),
        ("explain", explanations(program)),
        ("help", help_texts()),
        ("documents", documents(store.fixtures.parent)),
        ("calculator, drops, presets", calculations()),
    ):
        for call in calls:
            yield store.case(family, call)


def manifests() -> Iterator[str]:
    """Every manifest, good or wrong, in the ways to run one."""
    ways = (
        "batch {}",
        "batch {} -d out --format json",
        "batch {} -d out --dry-run --diff",
        "batch {} -d out --summary s.csv && batch {} -d out --summary s.csv --resume",
        "batch {} --in-place --report page.html --format lines",
        "batch - -d out < {}",
        "batch deep/{} -d out --quiet",
    )
    for name in [*MANIFESTS, "table1.csv"]:
        yield from (way.replace("{}", name) for way in ways)
    yield "batch table1.csv --jobs 1 --summary s.ndjson --format table"
    yield ":put wide.csv 'm\\x00o\\x00' && batch wide.csv"
    yield ":put latin.csv 'model,target-mass\\ncaf\\xe9.osim,5\\n' && batch latin.csv"
    yield "batch nowhere.csv"
    yield "batch lib"
    yield "batch masses.csv -o x.osim"
    yield "batch masses.csv masses.csv"
    yield "batch masses.csv --summary masses.csv --force"
    yield "batch masses.csv --target-mass 5"
    failing = "batch failing.csv -d out --summary s.csv"
    yield f"{failing} && :copy model.osim truncated.osim && {failing} --resume"
    yield "batch outputs.csv --shard 1/2 && batch outputs.csv --shard 2/2"
    yield "batch seven.csv --report page.html --jobs 3"
    yield "COLUMNS=60 batch wrong.csv"


def measurements() -> Iterator[str]:
    """Every measurement, good or wrong."""
    ways = (
        "fit {} --radius 0.032",
        "fit {} --radius 0.032 --spheres 6 --onset fit --speed-column speed --format json",
        "fit {} --radius 0.032 --onset 0.0005 --time-column time --branch loading",
        "fit - --radius 0.032 --branch unloading --format json < {}",
    )
    for name in [*MEASUREMENTS, "heel.csv", "heel_eu.csv", "bad_cell.csv"]:
        yield from (way.replace("{}", name) for way in ways)


def presets() -> Iterator[str]:
    """Every file of presets, good or wrong, where one can be named."""
    ways = (
        "presets --presets {}",
        "presets lab_heel --presets {}",
        "presets --presets {} --format json",
        "transfer model.osim --from lab_heel --presets {} --format json",
        "drop-test lab_heel --presets {} --samples 5 --format csv",
        "plot force lab_heel --presets {} -o -",
    )
    for name in [*PRESETS, "lab2.toml", "lab.toml", "bad_key.toml", "nowhere.toml"]:
        yield from (way.replace("{}", name) for way in ways)


def moved_spheres() -> Iterator[str]:
    """A scaled model whose spheres, meshes or factors were changed by hand."""
    call = "transfer scaled.osim --from generic.osim --follow-bodies"
    edits = (
        ":edit scaled.osim '-0.01 -0.040000000000000001 0.0050000000000000001' '-0.012 -0.04 0.005'",
        ":edit scaled.osim '<radius>0.032' '<radius>0.03'",
        ":edit scaled.osim '\"ball_r\"' '\"forefoot_r\"'",
        ":edit scaled.osim '_frame>/bodyset/toes_r<' '_frame>/bodyset/calcn_r<'",
        ":edit scaled.osim '<Mesh name=' '<Brick name=' && :edit scaled.osim '</Mesh>' '</Brick>'",
        ":edit generic.osim '<Mesh name=' '<Brick name=' && :edit generic.osim '</Mesh>' '</Brick>'",
        ":edit applied.xml ' 1.02 0.9 0.95' ' 1.02 0 0.95'",
        ":edit applied.xml ' 1.02 0.9 0.95' ' 1.02 NaN 0.95'",
        ":edit applied.xml ' 1.02 0.9 0.95' ' 1.05 0.95 0.95'",
        ":once scaled.osim '<scale_factors>' '<scale_factors>1.1 '",
        ":copy none.osim generic.osim",
        ":copy generic_hunt.osim generic.osim",
        ":edit generic.osim 0.12 0.0000001",
    )
    ways = (
        "",
        " --level --dry-run --format json",
        " --moved-spheres keep",
        " --moved-spheres replace --level",
        " --body-scale-file applied.xml --format json",
        " --body-scale toes_r=1.02,0.9,0.95 --body-scale toes_l=1.02,0.9,0.95 --dry-run",
        " --rule predsim",
    )
    for edit in edits:
        yield from (f"{edit} && {call}{way}" for way in ways)
        yield f"{edit} && inspect scaled.osim --from generic.osim --format json"
        yield f"{edit} && inspect scaled.osim --from generic.osim --body-scale-file applied.xml"


def calculations() -> Iterator[str]:
    """The calculator with every choice of things that are known: too few, enough, and too many."""
    known = (
        "--load 300 --spheres 1",
        "--radius 0.03",
        "--indentation 0.1",
        "--stiffness 2e7",
        "--contact-stiffness 150000",
        "--restitution 0.8",
    )
    for number in range(2 ** len(known)):
        chosen = " ".join(option for bit, option in enumerate(known) if number >> bit & 1)
        yield f"design {chosen} --format json" if number % 3 == 0 else f"design {chosen}"
        yield f"design {chosen.replace('--stiffness 2e7', '--young 1e6 --poisson 0.4')} --gravity 1.62"


def explanations(program: Path) -> Iterator[str]:
    """Each thing that can be explained, in each form."""
    told = subprocess.run([program, "explain", "--format", "json"], capture_output=True, check=True, timeout=60)
    topics = [json.loads(line) for line in told.stdout.splitlines()]
    names = sorted({topic.get("label") or topic.get("name") or topic["code"] for topic in topics})
    words = [shlex.quote(name) for name in names]
    words += [
        "'(C.10)'",
        "11, B.2",
        "'11, B.2'",
        "given out-of-domain",
        "c.5",
        "exact law",
        "'exact law'",
        "(A.1, A.5)",
    ]
    words += ["nosuch", "sunkin", "''", "10 10", "*", "--", "C.99", "-1"]
    for way in ("", " --ascii", " --format json"):
        yield f"explain{way}"
        yield from (f"explain {word}{way}" for word in words)


def help_texts() -> Iterator[str]:
    """Help, version, manual pages and completions."""
    yield from ("", "-h", "--help", "-V", "--version", "help", "help transfer", "--version human.osim", "-hh")
    for verb in VERBS:
        for width in ("100", "60", "200", "20"):
            yield from (f"COLUMNS={width} {verb} {flag}" for flag in ("-h", "--help"))
        yield from (f"{verb} human.osim --help", f"{verb} --version", verb, f"man {verb}", f"man {verb} -h")
    yield from ("COLUMNS=60 --help", "COLUMNS=200 -h")
    yield from ("CLICOLOR_FORCE=1 NO_COLOR= --help", "CLICOLOR_FORCE=1 NO_COLOR= transfer -h")
    for shell in SHELLS:
        yield f"completions {shell}"
        yield f"completions {shell} > closed"
    yield from ("completions", "completions tcsh", "completions bash zsh", "completions bash > full")
    yield from ("man", "man -d pages", "man -d pages && man -d pages", "man -d pages && man -d pages --force")
    yield from (
        "man no-such-verb",
        "man --force",
        "man transfer -d pages",
        ":put pages x && man -d pages",
        "man > full",
    )


def documents(top: Path) -> Iterator[str]:
    """The examples of each page of the documents, one after the other as a reader would type them."""
    for page in [top / "README.md", *sorted((top / "docs").glob("*.md"))]:
        if page.is_file():
            found = re.findall(r"^```console\n(.*?)^```", page.read_text("utf-8"), re.DOTALL | re.MULTILINE)
            typed = (line for line in "".join(found).splitlines() if line.startswith(EXAMPLE))
            examples = [line.removeprefix(EXAMPLE) for line in typed]
            yield from examples
            if len(examples) > 1:
                yield " && ".join(examples)
