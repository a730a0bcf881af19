"""Runs a case with both programs, one after the other in the same folder, and compares what came of it."""

import contextlib
import os
import resource
import shutil
import signal
import stat
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import changes
from calls import Case, Step
from differ import Difference, Files, Outcome, differences
from same import Rules
from streams import Feeder, Terminal, standard_input, standard_output

NAME = "osim-contact-scale"
ENVIRONMENT = {
    "PATH": "/usr/bin:/bin",
    "COLUMNS": "100",
    "NO_COLOR": "1",
    "LC_ALL": "C.UTF-8",
    "TERM": "dumb",
    "TZ": "UTC",
}
# Variables of a step that are for this script, not for the program.
LIMIT, FEED, STOP = "FILE_LIMIT", "FEED", "STOP"


@dataclass(frozen=True)
class Settings:
    """What is compared, and how."""

    old: Path
    new: Path
    folder: Path
    time_limit: float
    rules: Rules


@dataclass
class Result:
    """The comparison of one case."""

    case: int
    files: int = 0
    bytes: int = 0
    differences: list[Difference] = field(default_factory=list)
    # The old program, asked twice, did not do the same.
    unsteady: bool = False


class Ground:
    """The folder of one worker: programs run in `here`, and find a home and a place for temporary files beside it."""

    def __init__(self, settings: Settings, number: int) -> None:
        self.settings = settings
        self.top = settings.folder / f"worker{number}"
        self.here = self.top / "here"
        homes = {"HOME": str(self.top / "home"), "TMPDIR": str(self.top / "tmp")}
        self.environment = ENVIRONMENT | homes
        self.kept: dict[Path, bytes] = {}

    def compare(self, number: int, case: Case) -> Result:
        """Both programs do the case."""
        old = self.outcomes(self.settings.old, case)
        new = self.outcomes(self.settings.new, case)
        result = Result(number, sum(outcome.count() for outcome in old), sum(outcome.size() for outcome in old))
        result.differences = differences(old, new, self.settings.rules)
        if result.differences:
            again = self.outcomes(self.settings.old, case)
            result.unsteady = bool(differences(old, again, Rules()))
        return result

    def outcomes(self, program: Path, case: Case) -> list[Outcome]:
        """What `program` leaves after each call of the case, begun in a fresh folder."""
        self._prepare(case)
        outcomes = []
        for step in case.steps:
            if step.prepares:
                changes.do(self.here, step.words)
            else:
                status, out, err = self._call(program, step)
                outcomes.append(Outcome(status, out, err, self._files()))
        return outcomes

    def _prepare(self, case: Case) -> None:
        remove(self.top)
        for folder in (self.here, self.top / "home", self.top / "tmp"):
            folder.mkdir(parents=True)
        for name, content in case.files:
            changes.write(self.here / name, content if isinstance(content, bytes) else self._bytes(content))

    def _bytes(self, path: Path) -> bytes:
        """A file that many cases need, read once."""
        if path not in self.kept:
            self.kept[path] = path.read_bytes()
        return self.kept[path]

    def _call(self, program: Path, step: Step) -> tuple[str, bytes, bytes]:
        """One call; a program that does not end in time is ended."""
        variables = dict(step.environment)
        limit = variables.pop(LIMIT, None)
        feeder = self._feeder(variables)
        terminal = Terminal() if step.stdout == "terminal" else None
        with contextlib.ExitStack() as streams:
            path = self.here / step.stdin if step.stdin else None
            stdin = streams.enter_context(standard_input(path))
            stdout = terminal.theirs if terminal else streams.enter_context(standard_output(step.stdout))
            child = subprocess.Popen(
                [NAME, *step.words],
                executable=program,
                cwd=self.here,
                env=self.environment | variables,
                stdin=stdin,
                stdout=stdout,
                stderr=subprocess.PIPE,
                start_new_session=True,
                preexec_fn=limited(int(limit)) if limit else None,
            )
        if terminal:
            terminal.start()
        if feeder:
            feeder.start(child)
        status, out, err = self._ended(child)
        if feeder:
            feeder.end()
        return status, terminal.text() if terminal else out, err

    def _ended(self, child: "subprocess.Popen[bytes]") -> tuple[str, bytes, bytes]:
        """Exit status and streams of a call."""
        try:
            out, err = child.communicate(timeout=self.settings.time_limit)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            child.communicate()
            return f"no end after {self.settings.time_limit:g} s", b"", b""
        return str(child.returncode), out or b"", err

    def _feeder(self, variables: dict[str, str]) -> Feeder | None:
        """What `FEED=PIPE:FILE` or `STOP=PIPE:FILE` asks for."""
        for name in (FEED, STOP):
            if name in variables:
                pipe, source = variables.pop(name).split(":")
                return Feeder(self.here / pipe, (self.here / source).read_bytes(), name == STOP)
        return None

    def _files(self) -> Files:
        """Everything in the folder: what it is, with its permissions, and its bytes."""
        found: Files = {}
        for path in sorted(self.top.rglob("*")):
            name = str(path.relative_to(self.top)).removeprefix("here/")
            found[name] = kind_and_bytes(path)
        return found


def kind_and_bytes(path: Path) -> tuple[str, bytes]:
    """What lies at `path`."""
    status = path.lstat()
    mode = f"{stat.S_IMODE(status.st_mode):o}"
    if stat.S_ISLNK(status.st_mode):
        return "link", os.fsencode(os.readlink(path))
    if stat.S_ISDIR(status.st_mode):
        return f"folder {mode}", b""
    if not stat.S_ISREG(status.st_mode):
        return f"other {mode}", b""
    try:
        return f"file {mode}", path.read_bytes()
    except PermissionError:
        return f"file {mode}, unreadable", b""


def remove(top: Path) -> None:
    """Removes a folder, also where permissions are in the way."""
    if not top.exists():
        return
    try:
        shutil.rmtree(top)
    except PermissionError:
        for folder, _, _ in os.walk(top):
            os.chmod(folder, 0o700)
            for entry in os.scandir(folder):
                if entry.is_dir(follow_symlinks=False):
                    os.chmod(entry.path, 0o700)
        shutil.rmtree(top)


def limited(size: int) -> Callable[[], None]:
    """Limits the size of files that a child may write."""
    return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
