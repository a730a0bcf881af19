"""Prints the licences of everything in the page's engine."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "dev/release"))
sys.dont_write_bytecode = True

from licences import licences  # noqa: E402

TARGET = "wasm32-unknown-unknown"

if __name__ == "__main__":
    words = ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", TARGET]
    metadata = json.loads(subprocess.run(words, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)
    sys.stdout.buffer.write(licences(metadata, "osim-web", TARGET))
