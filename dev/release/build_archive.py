"""Builds the archive that people download: the program, its pages with their examples' models, completions, manual and licences.

    python3 dev/release/build_archive.py [--target TRIPLE] [--out FOLDER] [--program FOLDER] [--names FOLDER]

On Linux and Windows the program is static: it needs no library that may be missing or of another version. The same
sources, compiler and target give the same archive, byte for byte: names are sorted, owners and times are fixed.
Needs Python 3.9 and Rust; writes NAME.tar.gz (Windows: NAME.zip) and NAME.tar.gz.sha256.
"""

import argparse
import gzip
import io
import json
import posixpath
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import zipfile
from pathlib import Path

import building
import console_examples
from building import COMMAND, ROOT
from licences import licences

SHELLS = {"bash": f"{COMMAND}.bash", "zsh": f"_{COMMAND}", "fish": f"{COMMAND}.fish",
          "powershell": f"{COMMAND}.ps1", "elvish": f"{COMMAND}.elv"}
#: `[text](path)` and `[text](path#anchor)`, not addresses and not anchors of the page itself.
LINK = re.compile(rb"\[(?P<text>[^\[\]]*)\]\((?P<path>[^\s():#]+)(?:#[^\s()]*)?\)")
#: What of a page is only for those who have the sources.
FOR_SOURCES = {
    r"README\.md": rb"(?ms)^## From the sources$.*?(?=^## )",
    r"docs/README\.md": rb"(?m)^- Develop: .*\n",
    r"docs/studies/.*\.md": rb"(?ms)^## Doing it again$.*?(?=^## |\Z)",
}


def output_of(*command, **options):
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, **options).stdout


def tracked(*folders):
    """The files of these folders that belong to the project."""
    return list(filter(None, output_of("git", "ls-files", "-z", *folders).decode().split("\0")))


def contents(program, target, metadata):
    """Every file of the archive: path, bytes, whether it can be run."""
    files = {program.name: (program.read_bytes(), True)}

    def add(path, data):
        files[path] = (data, False)

    for name in ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-MIT", "LICENSE-APACHE"]:
        add(name, (ROOT / name).read_bytes())
    # The pages, the schemas of the JSON that they describe, and the package for MATLAB, which finds the program beside itself.
    for name in tracked("docs", "schemas", "matlab"):
        # Developers have the sources.
        if not name.startswith("docs/developers/"):
            add(name, (ROOT / name).read_bytes())
    for pages, sources in FOR_SOURCES.items():
        for page in [path for path in files if re.fullmatch(pages, path)]:
            add(page, re.sub(sources, b"", files[page][0]))
    # What the examples of the pages name, so that each can be tried: whole folders, because files there name one another.
    folders = {name for page in console_examples.pages(ROOT) for name in console_examples.folders(page.read_text("utf-8"))}
    for name in tracked("fixtures"):
        if name.split("/")[1] in folders:
            add(name, (ROOT / name).read_bytes())
    add("LICENSES-OF-LIBRARIES.txt", licences(metadata, COMMAND, target))
    for shell, name in SHELLS.items():
        add(f"completions/{name}", output_of(str(program), "completions", shell))
    for name in tracked("dev/release/opensim-gui"):
        add(f"opensim-gui/{Path(name).name}", (ROOT / name).read_bytes())
    if "windows" in target:
        add("check.bat", (ROOT / "dev/release/check.bat").read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
    else:
        with tempfile.TemporaryDirectory() as folder:
            output_of(str(program), "man", "--output-dir", folder)
            for page in sorted(Path(folder).iterdir()):
                add(f"man/{page.name}", page.read_bytes())
    return {path: (without_dead_links(path, data, files) if path.endswith(".md") else data, runs) for path, (data, runs) in files.items()}


def without_dead_links(page, data, files):
    """The text of a page, where links to files that are not in the archive are plain text."""

    def kept(link):
        path = posixpath.normpath(posixpath.join(posixpath.dirname(page), link["path"].decode()))
        there = any(name == path or name.startswith(f"{path}/") for name in files)
        return link[0] if there else link["text"]

    return LINK.sub(kept, data)


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


def copy_to_cache(program, folder):
    """Copies a program into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    # Cargo links the name there to its own copy, which is not to be changed along.
    (folder / program.name).unlink(missing_ok=True)
    shutil.copy2(program, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--target", help="what to build for [default: this machine]")
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    parser.add_argument("--program", type=Path, help="folder that gets the program as well, as it is in the archive")
    parser.add_argument("--names", type=Path, help="folder that gets the same program with the names of its functions")
    arguments = parser.parse_args()
    target = arguments.target or building.host()
    metadata = json.loads(output_of("cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", target))
    folder = f"{COMMAND}-{building.version()}-{target}"
    if arguments.names:
        copy_to_cache(building.program(target, metadata["target_directory"], static=True, names=True), arguments.names)
    program = building.program(target, metadata["target_directory"], static=True)
    pack, ending = (zipped, ".zip") if "windows" in target else (tar_gz, ".tar.gz")
    data = pack(contents(program, target, metadata), folder, building.time_of_sources())
    building.write(arguments.out / f"{folder}{ending}", data)
    if arguments.program:
        copy_to_cache(program, arguments.program)


if __name__ == "__main__":
    sys.exit(main())
