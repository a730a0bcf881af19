"""Builds everything that people download for this machine, each file with its checksum; what the builders in this folder share.

    python3 dev/release/building.py [--out FOLDER] [--again]

Writes the archive, the package for MATLAB, the page, the wheel, the sdist, and SHA256SUMS. With --again all is compiled a second time, in a
clone, and must be the same, byte for byte. Needs what the builders need: Python 3.10, pip, Rust, and what `dev/install.sh web` installs.
"""

import argparse
import hashlib
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMMAND = "osim-contact-scale"


def host():
    """The target of this machine, as Rust calls it."""
    try:
        lines = subprocess.run(["rustc", "-vV"], check=True, capture_output=True, text=True).stdout.splitlines()
    except FileNotFoundError:
        raise SystemExit("this is compiled with Rust, which is not on the PATH: see https://rustup.rs") from None
    return next(line.removeprefix("host: ") for line in lines if line.startswith("host: "))


def version():
    """The version of the project."""
    return re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]


def time_of_sources():
    """The time of the sources, in seconds since 1970. With it, not with the time of the build, the same sources give the same bytes."""
    if os.environ.get("SOURCE_DATE_EPOCH"):
        return int(os.environ["SOURCE_DATE_EPOCH"])
    if not (ROOT / ".git").exists():
        # An unpacked sdist, whose files have it.
        return int((ROOT / "Cargo.toml").stat().st_mtime)
    last = ["git", "log", "-1", "--format=%ct"]
    return int(subprocess.run(last, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)


def write(path, data):
    """Writes a file that people download, and its checksum beside it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)
    digest = hashlib.sha256(data).hexdigest()
    # Bytes, not text: sha256sum reads a carriage return as part of the name.
    path.with_name(path.name + ".sha256").write_bytes(f"{digest}  {path.name}\n".encode())
    print(f"{path}: {len(data)} bytes, SHA-256 {digest}")


def environment(target):
    """The variables under which Cargo builds for `target`.

    Where this machine keeps its sources is nobody's business, and would differ from machine to machine. Libraries keep what the last
    step of a program needs to optimize across them; Python's module, which is made of the same ones, does without.
    """
    cargo = os.environ.get("CARGO_HOME") or Path.home() / ".cargo"
    flags = ["-Cembed-bitcode=yes", f"--remap-path-prefix={ROOT}=.", f"--remap-path-prefix={cargo}=cargo"]
    # Those of a distribution, such as conda-forge, stay.
    encoded = os.environ.get("CARGO_ENCODED_RUSTFLAGS")
    given = encoded.split("\x1f") if encoded else os.environ.get("RUSTFLAGS", "").split()
    flags = [flag for flag in given if flag not in flags] + flags
    # With a target the flags are for what is built, not for what runs while it is built.
    return os.environ | {"CARGO_ENCODED_RUSTFLAGS": "\x1f".join(flags), "CARGO_BUILD_TARGET": target}


def program(target, target_directory, *, static, names=False):
    """Builds the command in the release profile; returns its path.

    It is built with the Python package's own libraries, so that they are compiled once. A `static` program needs no library of the
    system, and only its last step is another one: the libraries of Linux and Windows are chosen there. In that step the names of functions
    are left out, too, a fifth of the program, unless it is asked for them: they show where time goes (tests/growth). Optimized across
    crates, it is a fifth smaller, and a model or a library takes 6 to 9 % less time.
    """
    command = ["cargo", "rustc", "--release", "--locked", "--package", COMMAND, "--bin", COMMAND]
    flags = ["-C", "lto=fat"]
    flags += ["-C", "target-feature=+crt-static"] if static and ("linux" in target or "windows" in target) else []
    # At a fixed place in memory its start fills in no addresses, which took a sixth of the time of one small model.
    flags += ["-C", "relocation-model=static"] if static and "linux" in target else []
    flags += [] if names else ["-C", "strip=symbols"]
    subprocess.run([*command, "--", *flags], cwd=ROOT, check=True, env=environment(target))
    return Path(target_directory) / target / "release" / (COMMAND + (".exe" if "windows" in target else ""))


def build_everything(root, out):
    """Runs each builder of the project in `root`; returns the lines of all checksums."""
    def run(script, *words):
        command = [sys.executable, root / "dev/release" / script, *words, "--out", out]
        print("+", *command[1:], flush=True)
        subprocess.run(command, cwd=root, check=True)

    for old in out.glob("*.sha256"):
        old.unlink()
    with tempfile.TemporaryDirectory() as folder:
        run("build_archive.py", "--program", folder)
        (built,) = Path(folder).iterdir()
        run("build_wheel.py", "--program", built)
    run("build_wheel.py", "--sdist")
    run("build_matlab.py")
    run("build_page.py")
    return sorted(path.read_text(encoding="utf-8") for path in out.glob("*.sha256"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    parser.add_argument("--again", action="store_true", help="compile all a second time and compare")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    sums = build_everything(ROOT, out)
    (out / "SHA256SUMS").write_bytes("".join(sums).encode())
    print(f"{out / 'SHA256SUMS'}: {len(sums)} files")
    if arguments.again:
        with tempfile.TemporaryDirectory() as folder:
            clone = Path(folder) / "clone"
            subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
            subprocess.run([clone / "dev/install.sh", "web"], cwd=clone, check=True)
            differ = set(sums) ^ set(build_everything(clone, Path(folder) / "dist"))
        if differ:
            sys.exit("not the same a second time:\n" + "".join(sorted(differ)))
        print("the same a second time, byte for byte")


if __name__ == "__main__":
    main()
