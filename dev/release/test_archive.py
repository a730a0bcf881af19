"""Unpacks an archive and runs the program as on a machine that has nothing else.

    python3 dev/release/test_archive.py ARCHIVE|FOLDER...

Checks the checksum, the files, every console example of the pages, and one scaling from start to end, with an empty environment;
on Linux also in a root folder that holds the program and a model and nothing else.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from decimal import Decimal, getcontext
from pathlib import Path

import console_examples

COMMAND = "osim-contact-scale"
MODEL = "human_62kg_smooth_sphere.osim"
EXPECTED = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE", "LICENSES-OF-LIBRARIES.txt", "docs/README.md",
            "docs/install.md", "schemas/README.md", "matlab/+osimcontact/rescale.m", "opensim-gui/RescaleContacts.py",
            f"completions/{COMMAND}.bash", f"completions/_{COMMAND}", f"completions/{COMMAND}.fish"]


def unpack(archive, into):
    checksum = archive.with_name(archive.name + ".sha256").read_text().split()
    assert checksum == [hashlib.sha256(archive.read_bytes()).hexdigest(), archive.name], "the checksum is wrong"
    if archive.suffix == ".zip":
        with zipfile.ZipFile(archive) as packed:
            packed.extractall(into)
    else:
        with tarfile.open(archive) as packed:
            packed.extractall(into)
    tops = list(into.iterdir())
    assert len(tops) == 1, f"one folder is expected, not {tops}"
    return tops[0]


def dead_links(page):
    """The links of a page to files that do not exist."""
    links = re.findall(r"\]\(([^\s():#]+)(?:#[^\s()]*)?\)", page.read_text(encoding="utf-8"))
    return [link for link in links if not (page.parent / link).exists()]


def empty_environment():
    # Windows loads no program without it.
    return {"SystemRoot": os.environ["SystemRoot"]} if os.name == "nt" else {}


def run(command, **options):
    process = subprocess.run(command, capture_output=True, env=empty_environment(), timeout=60, **options)
    assert process.returncode == 0, f"{command}: status {process.returncode}\n{process.stdout}\n{process.stderr}"
    return process.stdout.decode("utf-8")


def check_scaling(out, before, after):
    """The numbers of equations (8), (10) and (14), here from 30 digits; every other byte as it was."""
    getcontext().prec = 30
    length = (Decimal(1190) / Decimal(62)) ** (Decimal(1) / 3)
    expected = {"radius": Decimal("0.032") * length, "stiffness": Decimal(1_000_000) * length,
              "dissipation": 2 / length.sqrt()}
    changes = json.loads(out)["changes"]
    for name, value in expected.items():
        written = [change["to"] for change in changes if change["property"] == name]
        assert len(written) == 12, f"{name}: {len(written)} changes"
        assert all(abs(Decimal(to) / value - 1) < Decimal("1e-14") for to in written), f"{name}: {written}, not {value}"
        text = f"<{name}>{repr(written[0])}</{name}>".encode()
        assert after.count(text) == 12, f"{text} is not in the file"
    remaining = [line for line in before.splitlines() if not any(f"<{name}>".encode() in line for name in expected)]
    # The note ends the credits.
    note = re.compile(rb"(; )?\[contacts made for 1190 kg at [^\]]*\)\]")
    assert len(note.findall(after)) == 1, "there is not one note"
    lines = set(note.sub(b"", after).splitlines())
    assert all(line in lines for line in remaining), "lines were lost"


def scale(runner, folder, subfolder="."):
    """Scales the model in `folder`, which the program sees as `subfolder`."""
    before = (folder / MODEL).read_bytes()
    call = ["--target-mass", "1190", "--format", "json"]
    out = runner([f"{subfolder}/{MODEL}", *call, "-o", f"{subfolder}/scaled.osim"])
    check_scaling(out, before, (folder / "scaled.osim").read_bytes())
    (folder / "scaled.osim").unlink()


def in_an_empty_root(program, model, folder):
    """Scales a model in a file system that has only the program and the model."""
    root = folder / "root"
    root.mkdir()
    shutil.copy(program, root / COMMAND)
    shutil.copy(model, root / MODEL)
    assert sorted(os.listdir(root)) == sorted([COMMAND, MODEL])
    if os.geteuid() == 0:
        change = ["chroot", str(root), f"/{COMMAND}"]
    else:
        change = ["unshare", "--map-root-user", f"--root={root}", f"/{COMMAND}"]
    change[0] = shutil.which(change[0]) or change[0]
    try:
        print("  in an empty root:", run([*change, "--version"]).strip())
    except (AssertionError, OSError) as error:
        if os.geteuid() == 0:
            raise
        print(f"skipped: the program in an empty root: it takes root or user namespaces: {error}")
        return
    scale(lambda arguments: run([*change, *arguments]), root, subfolder="")


def needs_no_library(program):
    headers = subprocess.run(["readelf", "--wide", "--segments", "--dynamic", program], capture_output=True, text=True)
    if headers.returncode == 0:
        assert "INTERP" not in headers.stdout and "(NEEDED)" not in headers.stdout, headers.stdout


def test(archive):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        top = unpack(archive, folder / "unpacked")
        program = next(top / name for name in [COMMAND, f"{COMMAND}.exe"] if (top / name).exists())
        missing = [name for name in EXPECTED if not (top / name).is_file()]
        missing += [] if (top / ("check.bat" if os.name == "nt" else f"man/{COMMAND}.1")).is_file() else ["manual"]
        assert not missing, f"not in the archive: {missing}"
        dead = [f"{page.relative_to(top)}: {link}" for page in sorted(top.rglob("*.md")) for link in dead_links(page)]
        assert not dead, f"links to files that are not in the archive: {dead}"
        named = {page: re.findall(r"\b(?:crates|demonstrations|dev|tests)/\S+", page.read_text(encoding="utf-8")) for page in top.rglob("*.md")}
        named = {page.relative_to(top): paths for page, paths in named.items() if paths and page.name != "install.md"}
        assert not named, f"files of the sources, which are not in the archive: {named}"
        assert "cargo" not in (top / "README.md").read_text(encoding="utf-8"), "README.md has what needs the sources"
        print(f"{archive.name}: {run([program, '--version']).strip()}, {program.stat().st_size} bytes")
        model = top / "fixtures/table1" / MODEL
        work = folder / "a folder with spaces"
        work.mkdir()
        shutil.copy(model, work)
        scale(lambda arguments: run([program, *arguments], cwd=work), work)
        assert "R_a" in run([program, "explain", "10"])
        print(f"  {console_examples.compare(program, top)} console examples are true")
        if sys.platform == "linux":
            needs_no_library(program)
            in_an_empty_root(program, model, folder)
    print("  all as expected")


def archives_of(folder):
    # The package for MATLAB holds no program: dev/release/test_matlab.py tests it. Sources of the Python package have another name.
    result = [path for path in sorted(folder.iterdir()) if path.name.endswith((".tar.gz", ".zip"))]
    archives = [path for path in result if path.name.startswith(f"{COMMAND}-")]
    return [path for path in archives if not path.name.startswith(f"{COMMAND}-matlab-")]


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    found = [Path(name).resolve() for name in sys.argv[1:]]
    archives = [a for path in found for a in (archives_of(path) if path.is_dir() else [path])]
    if not archives:
        sys.exit("no archive found")
    for archive in archives:
        test(archive)
