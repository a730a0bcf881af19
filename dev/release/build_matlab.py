"""Builds the zip of the package for MATLAB and GNU Octave, which is the same for every system.

    python3 dev/release/build_matlab.py [--out FOLDER]

The same sources give the same zip, byte for byte. The archives of the program hold the package, too: dev/release/build_archive.py.
Needs Python 3.9; writes osim-contact-scale-matlab-VERSION.zip and the same with .sha256.
"""

import argparse
import hashlib
import os
import re
import sys
from pathlib import Path

from build_archive import COMMAND, ROOT, output_of, zipped

LICENCES = ["LICENSE-MIT", "LICENSE-APACHE", "CITATION.cff"]


def contents():
    """Every file of the zip: path, bytes, whether it can be run."""
    names = filter(None, output_of("git", "ls-files", "-z", "matlab").decode().split("\0"))
    files = {name.removeprefix("matlab/"): ((ROOT / name).read_bytes(), False) for name in names}
    return files | {name: ((ROOT / name).read_bytes(), False) for name in LICENCES}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    out = parser.parse_args().out
    version = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
    folder = f"{COMMAND}-matlab-{version}"
    # The time of the sources, not of the build.
    when = int(os.environ.get("SOURCE_DATE_EPOCH") or output_of("git", "log", "-1", "--format=%ct"))
    files = contents()
    data = zipped(files, folder, when)
    out.mkdir(parents=True, exist_ok=True)
    archive = out / f"{folder}.zip"
    archive.write_bytes(data)
    digest = hashlib.sha256(data).hexdigest()
    archive.with_name(archive.name + ".sha256").write_bytes(f"{digest}  {archive.name}\n".encode())
    print(f"{archive}: {len(files)} files, {len(data)} bytes, SHA-256 {digest}")


if __name__ == "__main__":
    sys.exit(main())
