#!/usr/bin/env python3
"""Checks that each published package compiles by itself, without the rest of the project. Uploads nothing.

    dev/check_packages.py

Cargo packs every crate, as it does before it publishes them. The packages are unpacked beside each other, with the versions
and profiles of the project and nothing else of it, and each is checked by itself: it must ask for every file, crate and feature
that it needs. (`cargo publish --dry-run` would build each, from the start, which takes seven times as long.)
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()


def cargo(*words, cwd):
    print("+ cargo", *words, flush=True)
    # What was compiled for the lints is of the same profile, and is taken from there.
    subprocess.run(["cargo", *words], cwd=cwd, check=True, env=os.environ | {"CARGO_TARGET_DIR": str(TARGET)})


def packed():
    """Makes the packages again."""
    folder = TARGET / "package"
    shutil.rmtree(folder, ignore_errors=True)
    cargo("publish", "--workspace", "--dry-run", "--no-verify", "--locked", "--allow-dirty", cwd=ROOT)
    return sorted(folder.rglob("*.crate")) or sys.exit("error: cargo made no package")


def unpacked(packages, folder):
    """A workspace of nothing but `packages`; their names."""
    shutil.rmtree(folder, ignore_errors=True)
    names = {}
    for package in packages:
        with tarfile.open(package) as archive:
            archive.extractall(folder / "crates", filter="data")
        place = f"crates/{package.stem}"
        for licence in ("LICENSE-MIT", "LICENSE-APACHE"):
            if (folder / place / licence).read_bytes() != (ROOT / licence).read_bytes():
                sys.exit(f"error: {place}/{licence} is not the project's")
        names[tomllib.loads((folder / place / "Cargo.toml").read_text())["package"]["name"]] = place
    text = (ROOT / "Cargo.toml").read_text()
    profiles = text[text.index("[profile.") :]
    patches = "".join(f'{name} = {{ path = "{place}" }}\n' for name, place in names.items())
    head = '[workspace]\nresolver = "3"\nmembers = ["crates/*"]\n\n[patch.crates-io]\n'
    (folder / "Cargo.toml").write_text(f"{head}{patches}\n{profiles}")
    shutil.copy(ROOT / "Cargo.lock", folder)
    return list(names)


def main():
    folder = TARGET / "packed"
    for name in unpacked(packed(), folder):
        cargo("check", "--package", name, cwd=folder)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.returncode)
