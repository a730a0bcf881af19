"""Builds the zip of the package for MATLAB and GNU Octave, which is the same for every system.

    python3 dev/release/build_matlab.py [--out FOLDER]

The same sources give the same zip, byte for byte. The archives of the program hold the package, too: dev/release/build_archive.py.
Needs Python 3.9; writes osim-contact-scale-matlab-VERSION.zip and the same with .sha256.
"""

import argparse
import sys
from pathlib import Path

import building
from build_archive import COMMAND, ROOT, tracked, zipped

LICENCES = ["LICENSE-MIT", "LICENSE-APACHE", "CITATION.cff"]


def contents():
    """Every file of the zip: path, bytes, whether it can be run."""
    files = {name.removeprefix("matlab/"): ((ROOT / name).read_bytes(), False) for name in tracked("matlab")}
    return files | {name: ((ROOT / name).read_bytes(), False) for name in LICENCES}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    out = parser.parse_args().out
    folder = f"{COMMAND}-matlab-{building.version()}"
    building.write(out / f"{folder}.zip", zipped(contents(), folder, building.time_of_sources()))


if __name__ == "__main__":
    sys.exit(main())
