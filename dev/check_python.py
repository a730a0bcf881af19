#!/usr/bin/env python3
"""The wheel in other environments than that of the tests: other versions of CPython, an old NumPy, no opensim, no pandas.

    python3 dev/check_python.py WHEEL          every interpreter that is here
    python3 dev/check_python.py --here FILE    only the one that runs this; FILE may be an sdist, too

Each environment is new. An interpreter that this machine does not have is named, and left out. Exits with 1 where a test fails.
"""

import glob
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent

# Version of CPython, and what is installed beside the wheel: NumPy before its second version has another ABI.
ENVIRONMENTS = [
    ("3.10", ["numpy==1.26.4", "pandas==2.1.4"]),
    ("3.11", ["numpy==1.26.4"]),
    ("3.12", ["numpy==2.4.6", "pandas==3.1.1"]),
    ("3.13", ["numpy==2.4.6", "pandas==3.1.1"]),
]
#: Parts of names of files that a wheel must contain.
PARTS = ["_native", "py.typed", ".pyi", "scripts/osim-contact-scale", "LICENSE-MIT", "LICENSE-APACHE", "LICENSES-OF-LIBRARIES"]
TESTS = ["test_errors.py", "test_result.py", "test_scaling.py", "test_scaling_pandas.py", "test_many.py"]


def main() -> int:
    """Runs the tests everywhere."""
    *options, wheel = sys.argv[1:]
    missing = [] if wheel.endswith(".tar.gz") else complaints(wheel)
    for complaint in missing:
        print(f"error: {wheel}: {complaint}")
    if missing:
        return 1
    if options == ["--here"]:
        return 0 if passes(sys.executable, wheel, ["numpy"], "this interpreter with NumPy") else 1
    # Two at once: most of the time packages are unpacked.
    with ThreadPoolExecutor(2) as pool:
        passed = list(pool.map(lambda environment: passes_everywhere(wheel, *environment), ENVIRONMENTS))
    return 0 if all(passed) else 1


def passes_everywhere(wheel: str, version: str, packages: list[str]) -> bool:
    """Whether the tests pass with a version of CPython, if it is installed."""
    label = f"CPython {version} with {', '.join(packages)}"
    python = interpreter(version)
    if python is None:
        print(f"skipped: {label}: this machine does not have that interpreter", flush=True)
        return True
    return passes(python, wheel, packages, label)


def complaints(wheel: str) -> list[str]:
    """Parts that a wheel lacks or should not have."""
    with zipfile.ZipFile(wheel) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    result = [f"no {part}" for part in PARTS if not any(part in name for name in files)]
    texts = b"".join(data for name, data in files.items() if "LICENSES-OF-LIBRARIES" in name)
    result += [f"no licence of {name}" for name in (b"pyo3 ", b"rayon ", b"Arimo ") if name not in texts]
    # Where it was built is nobody's business.
    return result + [f"{name} names the folder {TOP}" for name, data in files.items() if str(TOP).encode() in data]


def interpreter(version: str) -> str | None:
    """An interpreter of this version: on the path, or one of pyenv's."""
    path = shutil.which(f"python{version}")
    # pyenv's own commands are there for versions that are not switched on, too.
    if path and "shims" not in path:
        return path
    root = os.environ.get("PYENV_ROOT", os.path.expanduser("~/.pyenv"))
    return max(glob.glob(f"{root}/versions/{version}.*/bin/python"), default=None)


def passes(python: str, wheel: str, packages: list[str], label: str) -> bool:
    """Whether the tests pass in a new environment."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([python, "-m", "venv", folder], check=True)
        python_of_venv = Path(folder) / ("Scripts" if os.name == "nt" else "bin") / "python"
        install = [python_of_venv, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*install, wheel, "pytest==9.2.0", "mpmath==1.4.1", *packages], check=True)
        tests = [str(TOP / "tests" / "python" / test) for test in TESTS]
        command = [python_of_venv, "-m", "pytest", "-q", "-rs", "--no-fold-skipped", "-p", "no:cacheprovider", *tests]
        process = subprocess.run(command, cwd=TOP, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    # In one piece: two of them run at once.
    print(f"\n{label}: {python}\n{process.stdout}", end="", flush=True)
    if process.returncode:
        print(f"error: {label}: tests failed", flush=True)
    return process.returncode == 0


if __name__ == "__main__":
    sys.exit(main())
