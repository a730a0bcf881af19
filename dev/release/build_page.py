"""Builds the page for browsers, one HTML file which is the same for every system.

    python3 dev/release/build_page.py [--out FOLDER] [--skip-build]

Needs what `dev/install.sh web` installs. Writes osim-contact-scale-page-VERSION.html and the same with .sha256; --skip-build takes the
page that `node web/build.mjs` made last.
"""

import argparse
import hashlib
import re
import subprocess
import sys
from pathlib import Path

from building import COMMAND, ROOT

PAGE = ROOT / "target/web" / f"{COMMAND}.html"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "target/dist", help="folder [default: target/dist]")
    parser.add_argument("--skip-build", action="store_true", help="take the page that was built last")
    words = parser.parse_args()
    if not words.skip_build:
        subprocess.run(["node", "web/build.mjs"], cwd=ROOT, check=True)
    version = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
    data = PAGE.read_bytes()
    if f'<span id="version">{version}</span>'.encode() not in data:
        raise SystemExit(f"{PAGE} is not of version {version}: build it without --skip-build")
    words.out.mkdir(parents=True, exist_ok=True)
    file = words.out / f"{COMMAND}-page-{version}.html"
    file.write_bytes(data)
    digest = hashlib.sha256(data).hexdigest()
    file.with_name(file.name + ".sha256").write_bytes(f"{digest}  {file.name}\n".encode())
    print(f"{file}: {len(data)} bytes, SHA-256 {digest}")


if __name__ == "__main__":
    sys.exit(main())
