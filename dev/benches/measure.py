"""Functions of the benchmarks: they build the command, run whole processes, and print the table of figures and limits."""

import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT / "dev/release"))
import building  # noqa: E402
TARGET_KG = "500"
MIB = 1 << 20


def build():
    """The path of the program that people download."""
    call = ["cargo", "metadata", "--format-version", "1", "--no-deps"]
    metadata = json.loads(subprocess.run(call, cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout)
    return str(building.program(building.host(), metadata["target_directory"], static=True))


def rescale(command, model, *options):
    return [str(command), str(model), "--target-mass", TARGET_KG, *options]


class Table:
    """Prints a row as soon as it is measured, and remembers what failed."""

    def __init__(self):
        self.failed = 0
        print(f"{platform.machine()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")

    def head(self, text):
        print(f"\n{text}")

    def row(self, what, value, unit, limit=None, at_least=False):
        """Writes a figure against its limit, which it must not exceed (or, `at_least`, must reach)."""
        if limit is None:
            verdict = ""
        elif value >= limit if at_least else value <= limit:
            verdict = f"pass ({'at least' if at_least else 'at most'} {limit:g})"
        else:
            verdict = f"FAIL ({'at least' if at_least else 'at most'} {limit:g})"
            self.failed += 1
        print(f"  {what:<52} {value:>10.4g} {unit:<6} {verdict}", flush=True)

    def finish(self):
        print(f"\n{self.failed} limits missed" if self.failed else "\nall limits kept")
        return 1 if self.failed else 0


def run(call, status=0, fresh=None):
    """Wall time in seconds and the time on a processor of one process, start to end, its output thrown away.

    `fresh` is a file the process writes anew: replacing an old one would time the disk, which is told to keep the
    successor before the old contents go.
    """
    if fresh is not None:
        fresh.unlink(missing_ok=True)
    nothing = [(os.POSIX_SPAWN_OPEN, fd, os.devnull, os.O_RDWR, 0) for fd in (0, 1, 2)]
    start = time.perf_counter()
    process = os.posix_spawn(shutil.which(call[0]), call, os.environ, file_actions=nothing)
    _, code, usage = os.wait4(process, 0)
    elapsed = time.perf_counter() - start
    if os.waitstatus_to_exitcode(code) != status:
        sys.exit(f"failed: {' '.join(call)}")
    return elapsed, usage.ru_utime + usage.ru_stime


def peak(call, status=0):
    """Peak memory in bytes, asked of GNU time: what Python itself uses would count as the child's otherwise."""
    timer = shutil.which("time")
    if timer is None:
        sys.exit("GNU time is needed to measure memory, for example from the package 'time'")
    with tempfile.NamedTemporaryFile("r") as report:
        process = subprocess.run(
            [timer, "-q", "-o", report.name, "-f", "%M", *call], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        if process.returncode != status:
            sys.exit(f"failed: {' '.join(call)}")
        return int(report.read()) * 1024


def opensim_python():
    """A Python that can import opensim, as OPENSIM_PYTHON names it."""
    python = os.environ.get("OPENSIM_PYTHON")
    if not python or subprocess.run([python, "-c", "import opensim"], capture_output=True).returncode != 0:
        return None
    return python


def opensim_call(python, model, output):
    return [python, str(HERE / "rescale_with_opensim.py"), str(model), str(output), TARGET_KG]
