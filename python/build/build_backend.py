"""Builds the package: maturin, and beside its module the command, which goes into the wheel's scripts.

A command that starts through Python would need 50 ms for that alone, so the wheel has the program itself.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import maturin

TOP = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(TOP / "dev/release"))

import building  # noqa: E402
from build_archive import tar_gz  # noqa: E402
from licences import licences  # noqa: E402

# Where maturin looks for what goes beside the modules: tool.maturin.data in pyproject.toml.
DATA = TOP / "target" / "wheel-data"
# The licences of all libraries and of the font: project.license-files in pyproject.toml.
LICENCES = TOP / "target" / "wheel-licences" / "LICENSES-OF-LIBRARIES.txt"
# A program that was built already, such as that of the archives, which needs no library of the system.
GIVEN = os.environ.get("OSIM_WHEEL_PROGRAM")
TARGET = os.environ.get("CARGO_BUILD_TARGET") or building.host()

get_requires_for_build_wheel = maturin.get_requires_for_build_wheel
get_requires_for_build_sdist = maturin.get_requires_for_build_sdist


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """The metadata alone (PEP 517)."""
    _write_licences()
    return maturin.prepare_metadata_for_build_wheel(metadata_directory, config_settings)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel with the module and the command (PEP 517)."""
    _prepare()
    return maturin.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds an editable wheel: Python's files stay where they are (PEP 660)."""
    _prepare()
    return maturin.build_editable(wheel_directory, config_settings, metadata_directory)


def build_sdist(sdist_directory, config_settings=None):
    """Everything that is under version control, or that an unpacked sdist has: the crates, and what tests them."""
    metadata = Path(sdist_directory) / "metadata"
    folder = prepare_metadata_for_build_wheel(str(metadata), config_settings)
    name = folder.removesuffix(".dist-info")
    if (TOP / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z"], cwd=TOP, check=True, capture_output=True).stdout
        names = [file for file in listed.decode().split("\0") if file]
    else:
        names = [path.relative_to(TOP).as_posix() for path in TOP.rglob("*") if path.is_file()]
        made = Path(sdist_directory).resolve()
        names = [file for file in names if not re.match(r"(target|\.venv)/|(.*/)?(__pycache__|node_modules)/", file)]
        names = [file for file in names if made not in (TOP / file).resolve().parents]
    files = {file: ((TOP / file).read_bytes(), os.access(TOP / file, os.X_OK)) for file in names}
    files["PKG-INFO"] = ((metadata / folder / "METADATA").read_bytes(), False)
    # Its metadata names the licences, so they are in it.
    files[LICENCES.relative_to(TOP).as_posix()] = (LICENCES.read_bytes(), False)
    (Path(sdist_directory) / f"{name}.tar.gz").write_bytes(tar_gz(files, name, building.time_of_sources()))
    shutil.rmtree(metadata)
    return f"{name}.tar.gz"


def _prepare():
    """Everything that maturin puts beside the module, and the variables under which it builds that."""
    os.environ.update(building.environment(TARGET))
    _write_licences()
    scripts = DATA / "scripts"
    shutil.rmtree(scripts, ignore_errors=True)
    scripts.mkdir(parents=True)
    program = GIVEN or building.program(TARGET, os.environ.get("CARGO_TARGET_DIR", TOP / "target"), static=False)
    shutil.copy2(program, scripts / Path(program).name)


def _write_licences():
    """Writes the licences of everything in the wheel to where maturin takes them from."""
    # maturin wants this folder to be there, also where it only looks at names.
    DATA.mkdir(parents=True, exist_ok=True)
    command = ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", TARGET]
    metadata = json.loads(subprocess.run(command, cwd=TOP, check=True, capture_output=True).stdout)
    LICENCES.parent.mkdir(parents=True, exist_ok=True)
    LICENCES.write_bytes(licences(metadata, "osim-python", TARGET))
