"""Unpacks the zip of the MATLAB package and has GNU Octave run its tests, tests/matlab/.

    python3 dev/release/test_matlab.py FOLDER [PROGRAM]

FOLDER holds osim-contact-scale-matlab-VERSION.zip; PROGRAM is target/release/osim-contact-scale by default.
Needs Octave 7.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from test_archive import unpack

ROOT = Path(__file__).resolve().parents[2]
EXPECTED = ["README.md", "LICENSE-MIT", "LICENSE-APACHE", "+osimcontact/rescale.m", "+osimcontact/Contents.m"]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    archives = list(Path(sys.argv[1]).glob("osim-contact-scale-matlab-*.zip"))
    assert len(archives) == 1, f"one zip is expected, not {archives}"
    program = Path(sys.argv[2] if len(sys.argv) == 3 else ROOT / "target/release/osim-contact-scale").resolve()
    with tempfile.TemporaryDirectory() as folder:
        top = unpack(archives[0], Path(folder) / "unpacked")
        missing = [name for name in EXPECTED if not (top / name).is_file()]
        assert not missing, f"not in the zip: {missing}"
        environment = os.environ | {"OSIMCONTACT_FOLDER": str(top), "OSIM_CONTACT_SCALE": str(program)}
        environment.pop("DISPLAY", None)
        # --traditional: as near to MATLAB as Octave can be.
        call = ["octave", "--traditional", "--no-gui", "--norc", "--no-history", "--eval", "cd tests/matlab; run_tests"]
        return subprocess.run(call, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL).returncode


if __name__ == "__main__":
    sys.exit(main())
