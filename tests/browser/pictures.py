"""Takes the picture of a report in docs/plots.md: python tests/browser/pictures.py (with the program built: cargo build --release)."""

import os
import pathlib
import shutil
import subprocess
import tempfile

from browser import Browser

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("OSIM_CONTACT_SCALE", ROOT / "target/release/osim-contact-scale"))
WIDTH = 1000
# name: the scheme, the first and the last element of the picture
PICTURES = {
    "glance": ("light", "header", "#glance"),
}


def main():
    with tempfile.TemporaryDirectory() as folder, Browser() as browser:
        folder = pathlib.Path(folder)
        (folder / "models").mkdir()
        fixtures = ROOT / "fixtures"
        odd = ["bad/truncated.osim", "check/sunk_in.osim"]
        for model in [*(fixtures / "table1").glob("*_smooth_sphere.osim"), *(fixtures / name for name in odd)]:
            shutil.copy(model, folder / "models")
        call = [PROGRAM, "models", "--target-mass", "100", "-d", "new", "--report", "page.html", "--quiet"]
        subprocess.run(call, cwd=folder, check=False, stderr=subprocess.DEVNULL)
        for name, (scheme, first, last) in PICTURES.items():
            browser.open(folder / "page.html", WIDTH, scheme)
            browser.picture(ROOT / f"docs/report/{name}.webp", first, last)


if __name__ == "__main__":
    main()
