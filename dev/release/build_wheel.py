"""Builds the wheel that people install with pip, with the program of the archive in its scripts; or the sdist.

    python3 dev/release/build_wheel.py --program PATH [--target TRIPLE] [--out FOLDER]
    python3 dev/release/build_wheel.py --sdist [--out FOLDER]

On Linux the module runs wherever glibc is 2.17 or later (manylinux2014), with a target of musl where musl is 1.2 or later (Alpine): zig
links it. The same sources give the same file, byte for byte. Writes NAME and NAME.sha256.
Needs Python 3.10, pip and Rust.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

import building
from building import ROOT

MATURIN = "maturin==1.16.0"
ZIG = "ziglang==0.15.2"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=Path, help="the program of the archive, for the wheel's scripts")
    parser.add_argument("--target", help="what to build for [default: this machine]")
    parser.add_argument("--sdist", action="store_true", help="the sources instead")
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    arguments = parser.parse_args()
    if bool(arguments.program) == arguments.sdist:
        parser.error("say either --program PATH or --sdist")
    with tempfile.TemporaryDirectory() as folder:
        venv.create(folder, with_pip=True)
        scripts = Path(folder) / ("Scripts" if os.name == "nt" else "bin")
        python = scripts / "python"
        environment = os.environ | {"PATH": f"{scripts}{os.pathsep}{os.environ['PATH']}"}
        linux = sys.platform == "linux" and not arguments.sdist
        subprocess.run([python, "-m", "pip", "install", "--quiet", MATURIN, "build==1.6.1", *([ZIG] if linux else [])], check=True)
        if arguments.target:
            environment["CARGO_BUILD_TARGET"] = arguments.target
        if arguments.program:
            environment["OSIM_WHEEL_PROGRAM"] = str(arguments.program.resolve())
        environment["SOURCE_DATE_EPOCH"] = str(building.time_of_sources())
        libc = "musllinux_1_2" if "musl" in (arguments.target or "") else "manylinux2014"
        settings = [f"--config-setting=build-args=--zig --compatibility {libc}"] if linux else []
        kind = "--sdist" if arguments.sdist else "--wheel"
        with tempfile.TemporaryDirectory() as made:
            command = [python, "-m", "build", "--no-isolation", kind, *settings, "--outdir", made, ROOT]
            subprocess.run(command, check=True, env=environment)
            (path,) = Path(made).iterdir()
            building.write(arguments.out / path.name, path.read_bytes())


if __name__ == "__main__":
    sys.exit(main())
