"""A case: what is typed, in which folder, with which files.

A case is written as one line, nearly as a person would type it, without the program's name:

    human.osim --target-mass 5 -o small.osim && inspect small.osim --format json

`&&` separates its steps; all of them run, whatever became of those before. A step may begin with environment variables
(`COLUMNS=60`), take a file as its standard input (`< human.osim`), write to a full device, a pipe that nobody reads or
a terminal (`> full`, `> closed`, `> terminal`). It may run under a limit on the size of files (`FILE_LIMIT=BYTES`),
with a pipe that is fed with a file when the program reads it (`FEED=PIPE:FILE`), and be interrupted then
(`STOP=PIPE:FILE`). A step that begins with a colon is no call but prepares or changes the folder:

    :put NAME TEXT         writes a file; \\n, \\t, \\r, \\xHH in TEXT stand for bytes, @HOST@ in NAME for this computer
    :copy FROM TO          copies a file                  :rm NAME          removes a file or folder
    :edit NAME OLD NEW     replaces OLD everywhere        :once NAME O N    replaces the first only
    :cut NAME COUNT        takes COUNT bytes off the end  :mkdir NAME       makes a folder
    :link TO NAME          a symbolic link                :hard TO NAME     a hard link
    :pipe NAME             a pipe with a name             :chmod MODE NAME  sets permissions (octal)

Files are not listed: whatever name a line holds that the store knows is put into the folder (`store.py`).
"""

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

VERBS = (
    *("rescale", "transfer", "design", "set", "batch", "sweep", "inspect", "check"),
    *("drop-test", "plot", "fit", "presets", "explain", "completions", "man"),
)
VARIABLE = re.compile(r"[A-Z][A-Z_]*=")
ESCAPE = re.compile(r"\\(n|t|r|\\|x[0-9a-fA-F]{2})")
ESCAPED = {"n": b"\n", "t": b"\t", "r": b"\r", "\\": b"\\"}

Content = Path | bytes


@dataclass(frozen=True)
class Step:
    """One call of the program, or, where the first word begins with a colon, one thing done to the folder."""

    words: tuple[str, ...]
    environment: tuple[tuple[str, str], ...] = ()
    stdin: str | None = None
    stdout: str | None = None

    @property
    def prepares(self) -> bool:
        """Whether this is no call of the program."""
        return bool(self.words) and self.words[0].startswith(":")


@dataclass(frozen=True)
class Case:
    """A folder with files, and the steps that are done in it."""

    call: str
    family: str
    steps: tuple[Step, ...]
    files: tuple[tuple[str, Content], ...]

    @property
    def verb(self) -> str:
        """The verb of the last call; what has none rescales or, like `--version`, is about the program."""
        calls = [step.words for step in self.steps if not step.prepares]
        first = calls[-1][0] if calls and calls[-1] else ""
        if first in VERBS:
            return first
        return "(no verb)" if first.startswith("-") or not first else "rescale"


def steps_of(call: str) -> tuple[Step, ...]:
    """Reads the steps of a line."""
    return tuple(_step(part.strip()) for part in call.split(" && "))


def _step(text: str) -> Step:
    words = shlex.split(text)
    environment = []
    while words and VARIABLE.match(words[0]):
        name, _, value = words.pop(0).partition("=")
        environment.append((name, value))
    stdin = _taken(words, "<")
    stdout = _taken(words, ">")
    return Step(tuple(words), tuple(environment), stdin, stdout)


def _taken(words: list[str], sign: str) -> str | None:
    """Takes `sign` and the word behind it out of `words`."""
    if sign not in words or words[0].startswith(":"):
        return None
    at = words.index(sign)
    _, name = words.pop(at), words.pop(at)
    return name


def bytes_of(text: str) -> bytes:
    """The bytes that a text of `:put` stands for."""

    def plain(match: re.Match[str]) -> str:
        code = match.group(1)
        data = ESCAPED.get(code) or bytes.fromhex(code[1:])
        return data.decode("latin-1") if data < b"\x80" else data.decode("utf-8", "surrogateescape")

    return ESCAPE.sub(plain, text).encode("utf-8", "surrogateescape")
