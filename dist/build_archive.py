"""Builds the archive that people download: the program, its pages, completions, manual and licences.

    python3 dist/build_archive.py [--target TRIPLE] [--out FOLDER] [--program FOLDER]

On Linux and Windows the program is static: it needs no library that may be missing or of another version. The same
sources, compiler and target give the same archive, byte for byte: names are sorted, owners and times are fixed.
Needs Python 3.9 and Rust; writes NAME.tar.gz (Windows: NAME.zip) and NAME.tar.gz.sha256.
"""

import argparse
import gzip
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COMMAND = "osim-contact-scale"
SHELLS = {"bash": f"{COMMAND}.bash", "zsh": f"_{COMMAND}", "fish": f"{COMMAND}.fish",
          "powershell": f"{COMMAND}.ps1", "elvish": f"{COMMAND}.elv"}
LICENCE_FILES = re.compile(r"(LICEN[CS]E|COPYING|COPYRIGHT|NOTICE|UNLICENSE)", re.IGNORECASE)


def output_of(*command, **options):
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, **options).stdout


def host():
    lines = output_of("rustc", "-vV").decode().splitlines()
    return next(line.removeprefix("host: ") for line in lines if line.startswith("host: "))


def build(target, metadata):
    """Builds the program for `target`; returns its path."""
    flags = []
    if "linux" in target or "windows" in target:
        flags += ["-C", "target-feature=+crt-static"]
    # Where this machine keeps its sources is nobody's business, and would differ from machine to machine.
    cargo = os.environ.get("CARGO_HOME") or Path.home() / ".cargo"
    flags += [f"--remap-path-prefix={ROOT}=.", f"--remap-path-prefix={cargo}=cargo"]
    environment = os.environ | {"CARGO_ENCODED_RUSTFLAGS": "\x1f".join(flags)}
    # With --target the flags are for the program alone, not for what runs while it is built.
    command = ["cargo", "build", "--release", "--locked", "--package", COMMAND, "--target", target]
    subprocess.run(command, cwd=ROOT, check=True, env=environment)
    suffix = ".exe" if "windows" in target else ""
    return Path(metadata["target_directory"]) / target / "release" / f"{COMMAND}{suffix}"


def linked(metadata):
    """Packages of other people that the program is built from, sorted by name."""
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    packages = {package["id"]: package for package in metadata["packages"]}
    ours = next(p["id"] for p in packages.values() if p["name"] == COMMAND)
    seen, todo = set(), [ours]
    while todo:
        node = nodes[todo.pop()]
        if node["id"] not in seen:
            seen.add(node["id"])
            todo += [d["pkg"] for d in node["deps"] if any(k["kind"] is None for k in d["dep_kinds"])]
    foreign = [packages[i] for i in seen if packages[i]["source"]]
    return sorted(foreign, key=lambda package: (package["name"], package["version"]))


def licences(metadata, target):
    """Names, licences and licence texts of everything in the program; a text that is the same stands once."""
    texts, head = {}, ["The program contains these libraries. Their licence texts follow.\n"]
    for package in linked(metadata):
        name = f"{package['name']} {package['version']}"
        head.append(f"{name}: {package['license']}")
        for file in sorted(Path(package["manifest_path"]).parent.iterdir()):
            if file.is_file() and LICENCE_FILES.match(file.name):
                text = file.read_text(encoding="utf-8", errors="replace").strip()
                texts.setdefault(text, []).append(f"{name} ({file.name})")
    # The font of PNG pictures is compiled in, but is no library.
    font = ROOT / "crates/contact-plots/fonts/OFL.txt"
    head.append("Arimo 1.33: OFL-1.1")
    texts.setdefault(font.read_text(encoding="utf-8").strip(), []).append("Arimo 1.33 (OFL.txt)")
    head.append("\nThe standard library of Rust: MIT OR Apache-2.0 (https://www.rust-lang.org).")
    if target.endswith("linux-gnu"):
        head.append("The GNU C Library: LGPL-2.1-or-later (https://www.gnu.org/software/libc). The program's sources are\n"
                    "open: dist/build_archive.py links them with any other version of it.")
    if target.endswith("linux-musl"):
        head.append("musl: MIT (https://musl.libc.org).")
    parts = ["\n".join(head)]
    parts += ["\n".join(names) + "\n\n" + text for text, names in texts.items()]
    return ("\n\n" + "=" * 80 + "\n\n").join(parts).encode() + b"\n"


def contents(program, target, metadata):
    """Every file of the archive: path, bytes, whether it can be run."""
    files = {program.name: (program.read_bytes(), True)}

    def add(path, data):
        files[path] = (data, False)

    for name in ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-MIT", "LICENSE-APACHE"]:
        add(name, (ROOT / name).read_bytes())
    # The pages, and the schemas of the JSON that they describe.
    tracked = output_of("git", "ls-files", "-z", "docs", "schemas").decode().split("\0")
    for name in filter(None, tracked):
        add(name, (ROOT / name).read_bytes())
    # The model of README's examples, so that they can be tried.
    example = "fixtures/table1/human_62kg_smooth_sphere.osim"
    add(example, (ROOT / example).read_bytes())
    add("LICENSES-OF-LIBRARIES.txt", licences(metadata, target))
    for shell, name in SHELLS.items():
        add(f"completions/{name}", output_of(str(program), "completions", shell))
    if "windows" in target:
        add("inspect.bat", (ROOT / "dist/inspect.bat").read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
    else:
        verbs = re.findall(r"^  ([a-z-]+) ", output_of(str(program), "-h").decode().split("Commands:")[1].split("\n\n")[0], re.M)
        for verb in [None, *verbs]:
            name = f"{COMMAND}-{verb}" if verb else COMMAND
            add(f"man/{name}.1", output_of(str(program), "man", *filter(None, [verb])))
    return files


def tar_gz(files, folder, when):
    raw = io.BytesIO()
    with tarfile.open(fileobj=raw, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for path, (data, runs) in sorted(files.items()):
            entry = tarfile.TarInfo(f"{folder}/{path}")
            entry.size, entry.mtime, entry.mode = len(data), when, 0o755 if runs else 0o644
            archive.addfile(entry, io.BytesIO(data))
    out = io.BytesIO()
    with gzip.GzipFile(filename="", fileobj=out, mode="wb", mtime=when) as packed:
        packed.write(raw.getvalue())
    return out.getvalue()


def zipped(files, folder, when):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, (data, runs) in sorted(files.items()):
            entry = zipfile.ZipInfo(f"{folder}/{path}", time.gmtime(when)[:6])
            entry.create_system, entry.compress_type = 3, zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if runs else 0o100644) << 16
            archive.writestr(entry, data)
    return out.getvalue()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--target", help="what to build for [default: this machine]")
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    parser.add_argument("--program", type=Path, help="folder that gets the program as well, as it is in the archive")
    arguments = parser.parse_args()
    target = arguments.target or host()
    metadata = json.loads(output_of("cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", target))
    version = next(p["version"] for p in metadata["packages"] if p["name"] == COMMAND)
    folder = f"{COMMAND}-{version}-{target}"
    # The time of the sources, not of the build.
    when = int(os.environ.get("SOURCE_DATE_EPOCH") or output_of("git", "log", "-1", "--format=%ct"))
    program = build(target, metadata)
    files = contents(program, target, metadata)
    windows = "windows" in target
    archive = arguments.out / f"{folder}{'.zip' if windows else '.tar.gz'}"
    data = (zipped if windows else tar_gz)(files, folder, when)
    arguments.out.mkdir(parents=True, exist_ok=True)
    archive.write_bytes(data)
    digest = hashlib.sha256(data).hexdigest()
    # Bytes, not text: sha256sum reads a carriage return as part of the name.
    archive.with_name(archive.name + ".sha256").write_bytes(f"{digest}  {archive.name}\n".encode())
    if arguments.program:
        arguments.program.mkdir(parents=True, exist_ok=True)
        # Cargo links the name there to its own copy, which is not to be changed along.
        (arguments.program / program.name).unlink(missing_ok=True)
        shutil.copy2(program, arguments.program)
    print(f"{archive}: {len(files)} files, {len(data)} bytes, SHA-256 {digest}")


if __name__ == "__main__":
    sys.exit(main())
