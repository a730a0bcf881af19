"""Checks that a changed program does what the old one did: equal calls give equal bytes.

Both do each call of `calls.txt` (tables, every model of the fixtures and of the corpus, every option that the old
program's help names), each example of the docs, and many of these again as JSON for the verb `request`, in a fresh folder
of the same name. Exit status, both streams and every file that is there afterwards are compared byte by byte, once the
map of what changed on purpose (`renames.py`) was applied to what the old program left. Both need the same version number.
Exit status: 1 if anything differs, or, in a full run, if an entry of the map was never used.
"""

import argparse
import contextlib
import difflib
import functools
import io
import itertools
import json
import multiprocessing
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import zlib
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from renames import Entry, Map

TOP = Path(__file__).resolve().parents[2]
FIXTURES = TOP / "fixtures"
# A quick run does one case in so many; of the calls in turn, each model has one in so many; so many kinds of differences are shown.
QUICK, EVERY, MAX_SHOWN = 10, 12, 20
ENVIRONMENT = {"PATH": "/usr/bin:/bin", "COLUMNS": "100", "NO_COLOR": "1", "LC_ALL": "C.UTF-8", "TERM": "dumb", "TZ": "UTC"}
TOKEN = re.compile(r"[\w./+-]+")
# What the words of a call without an option are in a request; of other verbs they are models.
FIRST = {"batch": "manifest", "drop-test": "subject", "explain": "topics", "fit": "file", "presets": "name", "sweep": "model"}


def main() -> int:
    """Compares both programs in all cases and returns the exit status."""
    args = arguments()
    cases = Cases(args.corpus and args.corpus.resolve(), args.old.resolve())
    chosen = [call for call in dict.fromkeys(cases.all()) if call and all(word in call for word in args.only)]
    chosen = [call for call in chosen if zlib.crc32(call.encode()) % QUICK == 0] if args.quick else chosen
    changed = Map(args.map)
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="compare_programs-", dir="/dev/shm" if Path("/dev/shm").is_dir() else None) as folder:
        comparison = Comparison(cases, args.old.resolve(), args.new.resolve(), changed, Path(folder))
        with multiprocessing.Pool(args.jobs) as pool:
            results = list(pool.imap_unordered(comparison.compare, chosen, chunksize=8))
    differing = sorted((result for result in results if result.differences), key=lambda result: result.call)
    changed.used = sum((result.used for result in results), Counter())
    unused = [] if args.quick or args.only else [entry for entry in changed.entries if not changed.used[entry]]
    total = sum((result.counts for result in results), Counter())
    print("\n".join([*report_lines(differing), *changed.lines(), *(f"error: never used: {entry}" for entry in unused)]))
    counted = ", ".join(f"{total[name]} {name}" for name in ("calls", "calls that fail", "written files", "bytes of files and streams"))
    print(f"{len(results)} cases, {counted}: {len(differing)} cases differ; {time.monotonic() - began:.0f} s")
    return 1 if differing or unused or not results else 0


def arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(prog="compare_programs")
    parser.add_argument("old", type=Path, help="the program as it was")
    parser.add_argument("new", type=Path, help="the program as it is now")
    parser.add_argument("--corpus", type=Path, help="a folder with models of other people")
    parser.add_argument("--map", type=Path, help="what changed on purpose; renames.py says how it is written")
    parser.add_argument("--jobs", type=int, default=2, help="cases at once (default: 2)")
    parser.add_argument("--quick", action="store_true", help=f"one case in {QUICK}, always the same ones")
    parser.add_argument("--only", action="append", default=[], metavar="WORD", help="cases whose call holds WORD")
    return parser.parse_args()


class Cases:
    """All calls, and the files that each names."""

    def __init__(self, corpus: Path | None, old: Path) -> None:
        self.old = old
        self.tables: dict[str, list[str]] = defaultdict(list)
        for line in (Path(__file__).parent / "calls.txt").read_text("utf-8").splitlines():
            if line.startswith("== "):
                name = line.removeprefix("== ")
            elif line and not line.startswith("#"):
                self.tables[name].append(line)
        self.texts = dict(line.split(" ", 1) for line in self.tables["tables"])
        result = [path for top in (FIXTURES, corpus) if top for path in sorted(top.rglob("*")) if path.is_file()]
        self.models = sorted({path.name for path in result if path.suffix in (".osim", ".xml")})
        short = dict(word.split("=") for line in self.tables["files"] for word in line.split())
        self.files = {path.name: path for path in reversed(result)} | {name: FIXTURES / path for name, path in short.items()}

    def all(self) -> Iterator[str]:
        """Every call."""
        pages = [page.read_text("utf-8") for page in [TOP / "README.md", *sorted((TOP / "docs").rglob("*.md"))]]
        documents = [re.findall(r"^\$ osim-contact-scale (.*)", page, re.MULTILINE) for page in pages]
        typed = [*self.tables["once"], *itertools.chain(*documents), *map(" && ".join, documents), *self.with_options()]
        yield from (line for call in typed for line in (call, self.as_json(call)))
        yield from (line.replace("{t}", name) for line in self.tables["each table"] for name in self.texts)
        for number, model in enumerate(self.models):
            step = 3 if self.files[model].parent.name == "bad" else 1
            yield from (line.replace("{m}", model) for line in self.tables["each model"][number % step :: step])
            for line in self.tables["each model in turn"][number % EVERY :: EVERY]:
                yield from (line.replace("{m}", model), self.as_json(line.replace("{m}", model)))

    def with_options(self) -> Iterator[str]:
        """Every option of every verb: with a value that makes sense, twice, with another one, and with wrong values."""
        values = dict(word.split("=", 1) for line in self.tables["values"] for word in line.split())
        for base in self.tables["options"]:
            verb = base.split()[0]
            yield from (f"{verb} --help", f"COLUMNS=60 {verb} -h", f"man {verb}", verb)
            valued = options(self.old, verb)
            good = [f"{name}={values.get(name, 1)}" if takes else name for name, takes in valued.items()]
            for at, option in enumerate(good):
                yield from (f"{base} {option} {other}" for other in ("", option, good[(at * 7 + 3) % len(good)]))
            for line in self.tables["wrong"]:
                yield from (line.replace("{base}", base).replace("{option}", name) for name, takes in valued.items() if takes)

    def as_json(self, call: str) -> str:
        """The call as a request in JSON; empty if JSON cannot express it."""
        verb, *words = shlex.split(call) or [""]
        if verb not in {base.split()[0] for base in self.tables["options"]} or {"&&", "<", ">"}.intersection(words):
            return ""
        with contextlib.suppress(SystemExit), contextlib.redirect_stderr(io.StringIO()):
            result = {name: value for name, value in vars(parser(self.old, verb).parse_intermixed_args(words)).items() if value}
            first = result.pop("first", [])
            if verb == "set":
                result["set"] = [dict(word.split("=", 1) for word in first if "=" in word)]
            if verb == "plot" and first:
                result["kind"] = [first.pop(0)]
            result[FIRST.get(verb, "models")] = [word for word in first if verb != "set" or "=" not in word]
            lists = {name: [number(word) for word in value] for name, value in result.items() if value}
            request = {"verb": verb} | {name: value[0] if len(value) == 1 and name != "models" else value for name, value in lists.items()}
            return f":put request.json {shlex.quote(json.dumps(request))} && request request.json"
        return ""

    def write_input(self, text: str, here: Path) -> None:
        """Copies the files that a call or a table names into a folder."""
        for token in dict.fromkeys(TOKEN.findall(re.sub(r"\\[nrt]", " ", text))):
            name = token.removeprefix("./")
            for folder in (name.split("/")[1], "table1", "scale_tool") if name.startswith("fixtures/") else ():
                if (FIXTURES / folder).is_dir():
                    shutil.copytree(FIXTURES / folder, here / "fixtures" / folder, dirs_exist_ok=True)
            for inner in [name] if name in self.files else [one for one in self.files if one.startswith(f"{name.split('/')[0]}/")]:
                self.put_file(self.files[inner], here / inner)
            if name in self.texts:
                write(here / name, bytes_of(self.texts[name]))
                self.write_input(self.texts[name], here)

    def put_file(self, source: Path, target: Path) -> None:
        """A file with what it includes; meshes beside a model are linked."""
        data = source.read_bytes()
        write(target, data)
        for included in re.findall(r'\bfile="([\w.-]+)"', data.decode("latin-1")) if source.suffix in (".osim", ".xml") else ():
            if (source.parent / included).is_file():
                write(target.parent / included, (source.parent / included).read_bytes())
        if (source.parent / "Geometry").is_dir() and not (target.parent / "Geometry").exists():
            (target.parent / "Geometry").symlink_to(source.parent / "Geometry")


@functools.cache
def options(program: Path, verb: str) -> dict[str, bool]:
    """The long options of a verb, and whether each takes a value."""
    help_text = subprocess.run([program, verb, "--help"], capture_output=True, check=True, text=True).stdout
    match = re.findall(r"^(?:  -\w, |      )(--[a-z-]+)( <)?", help_text, re.MULTILINE)
    return {name: bool(value) for name, value in match if name not in ("--help", "--version")}


@functools.cache
def parser(program: Path, verb: str) -> argparse.ArgumentParser:
    """Reads the words of a verb; each option is a list."""
    argument_parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    argument_parser.add_argument("first", nargs="*")
    for name, takes in options(program, verb).items():
        short = {"--output": ["-o"], "--output-dir": ["-d"]}.get(name, [])
        argument_parser.add_argument(*short, name, **({"action": "append"} if takes else {"action": "store_const", "const": [True]}))
    return argument_parser


def number(word: object) -> object:
    """A word as JSON has it: what is written as a number is one."""
    return json.loads(word) if isinstance(word, str) and re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", word) else word


@dataclass
class Result:
    """The result of a case."""

    call: str
    counts: Counter[str]
    used: Counter[Entry]
    # Each: what differs, old, new.
    differences: list[tuple[str, bytes, bytes]] = field(default_factory=list)


@dataclass
class Comparison:
    """The folders in which both programs do each case, one after the other: each process has its own folder."""

    cases: Cases
    old: Path
    new: Path
    map: Map
    folder: Path

    @property
    def top(self) -> Path:
        """The folder of this process."""
        return self.folder / f"worker{os.getpid()}"

    def compare(self, call: str) -> Result:
        """Lets both programs do the case; files that the case itself put there are compared without the map."""
        self.map.used = Counter()
        (old, given), (new, _) = self.run(self.old, call), self.run(self.new, call)
        failed = sum(left["exit status"] != b"0" for left in old)
        result = Result(call, Counter({"calls": len(old), "calls that fail": failed}), self.map.used)
        for step, (mine, theirs) in enumerate(zip(old, new, strict=True)):
            for name in sorted({*mine, *theirs}):
                one, other = mine.get(name, b"(absent)"), theirs.get(name, b"(absent)")
                if (name, one) not in given:
                    is_new = step == 0 or old[step - 1].get(name) != one
                    result.counts["written files"] += is_new and name.startswith("file ")
                    result.counts["bytes of files and streams"] += len(one) * is_new
                    one, other = self.map.apply(one, name, True), self.map.apply(other, name, False)
                if one != other:
                    result.differences.append((f"call {step + 1}: {name}", one, other))
        if result.differences and self.run(self.old, call)[0] != old:
            result.differences.insert(0, ("the old program does not do the same twice", b"", b""))
        return result

    def run(self, program: Path, call: str) -> tuple[list[dict[str, bytes]], set[tuple[str, bytes]]]:
        """The outputs of each call of a case, by their kind; and the files that were put into the folder before."""
        shutil.rmtree(self.top, ignore_errors=True)
        for name in ("here", "home", "tmp"):
            (self.top / name).mkdir(parents=True)
        here = self.top / "here"
        self.cases.write_input(call, here)
        left: list[dict[str, bytes]] = []
        given: set[tuple[str, bytes]] = set()
        for step in call.split(" && "):
            words = shlex.split(step)
            if words and words[0].startswith(":"):
                with contextlib.suppress(FileNotFoundError):
                    change(here, *words)
            else:
                given.update(set(self.files().items()) - set(left[-1].items() if left else ()))
                left.append(self.call(program, words) | self.files())
        return left, given

    def call(self, program: Path, words: list[str]) -> dict[str, bytes]:
        """Exit status and both streams of a call."""
        environment = ENVIRONMENT | {"HOME": str(self.top / "home"), "TMPDIR": str(self.top / "tmp")}
        while words and re.match(r"[A-Z][A-Z_]*=", words[0]):
            environment.update([words.pop(0).split("=", 1)])
        here = self.top / "here"
        stdin = (here / words[-1]).read_bytes() if words[-2:-1] == ["<"] else b""
        with open("/dev/full", "wb") if words[-2:-1] == [">"] else contextlib.nullcontext(subprocess.PIPE) as stdout:
            process = subprocess.run(
                ["osim-contact-scale", *(words[:-2] if words[-2:-1] in (["<"], [">"]) else words)],
                executable=program, cwd=here, env=environment, input=stdin, stdout=stdout, stderr=subprocess.PIPE, timeout=120, check=False,
            )  # fmt: skip
        return {"exit status": b"%d" % process.returncode, "standard output": process.stdout or b"", "standard error": process.stderr}

    def files(self) -> dict[str, bytes]:
        """Everything in the folder, by kind, permissions and name."""
        result = {}
        for path in self.top.rglob("*"):
            kind = "link" if path.is_symlink() else "folder" if path.is_dir() else "file"
            name = f"{kind} {path.lstat().st_mode & 0o777:o} {path.relative_to(self.top)}"
            result[name] = path.read_bytes() if kind == "file" else b""
        return result


def bytes_of(text: str) -> bytes:
    """The bytes of a text with \\n, \\t, \\r and \\xHH."""
    return re.sub(rb"\\(n|t|r|x[0-9a-f]{2})", lambda match: match.group().decode("unicode_escape").encode("latin-1"), text.encode())


def write(path: Path, data: bytes) -> None:
    """Writes a file, with the folders above it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def change(here: Path, verb: str, name: str, *rest: str) -> None:
    """A step that changes the folder."""
    path = here / name
    if verb in (":mkdir", ":rm"):
        path.mkdir() if verb == ":mkdir" else path.unlink()
        return
    old = b"" if verb == ":put" else path.read_bytes()
    word = bytes_of(rest[0])
    changed = {":put": (path, word), ":copy": (here / rest[0], old), ":edit": (path, old.replace(word, rest[-1].encode()))}
    write(*changed.get(verb) or (path, old[: -int(word)]))


def report_lines(differing: list[Result]) -> list[str]:
    """A report of the differing cases, by what differs first: how many cases, some of them, and what differs in one of them."""
    groups: dict[tuple[str, str], list[Result]] = defaultdict(list)
    for result in differing:
        part, old, new = result.differences[0]
        kind = re.sub(r".*(\.\w+)$", r"file *\1", re.sub(r"^call \d+: ", "", part))
        groups[kind, re.sub(r"[\w./]*\d[\w.]*|[\w/-]+\.\w+", "#", " ".join(changes(old, new)[:2]))[:200]].append(result)
    lines = []
    for (kind, _), members in sorted(groups.items(), key=lambda item: -len(item[1]))[:MAX_SHOWN]:
        lines += [f"{len(members)} cases differ in {kind}:", *(f"    {member.call[:300]}" for member in members[:4])]
        for part, old, new in members[0].differences[:3]:
            lines += [f"  {part}", *(f"    {line[:300]}" for line in changes(old, new)[:8])]
    return lines + ([f"... and {len(groups) - MAX_SHOWN} more kinds of differences"] if len(groups) > MAX_SHOWN else [])


def changes(old: bytes, new: bytes) -> list[str]:
    """The lines that differ; of long ones the part that does."""
    sides = [re.split(r"\n|(?<=[,>;]) ?(?=.{80})", side[:300_000].decode("utf-8", "backslashreplace")) for side in (old, new)]
    return [line for line in difflib.unified_diff(*sides, n=0, lineterm="") if line[:2] not in ("--", "++", "@@")]


if __name__ == "__main__":
    sys.exit(main())
