"""Builds the page for browsers, one HTML file which is the same for every system.

    python3 dev/release/build_page.py [--out FOLDER] [--skip-build]

Needs what `dev/install.sh web` installs. Writes osim-contact-scale-page-VERSION.html and the same with .sha256; --skip-build takes the
page that `node web/build.mjs` made last.
"""

import argparse
import subprocess
import sys
from pathlib import Path

import building
from building import COMMAND, ROOT

PAGE = ROOT / "target/web" / f"{COMMAND}.html"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    parser.add_argument("--skip-build", action="store_true", help="take the page that was built last")
    words = parser.parse_args()
    if not words.skip_build:
        subprocess.run(["node", "web/build.mjs"], cwd=ROOT, check=True)
    version = building.version()
    data = PAGE.read_bytes()
    if f'<span id="version">{version}</span>'.encode() not in data:
        raise SystemExit(f"{PAGE} is not of version {version}: build it without --skip-build")
    building.write(words.out / f"{COMMAND}-page-{version}.html", data)


if __name__ == "__main__":
    sys.exit(main())
