"""The pictures of docs/glossary.md are those that the script beside them draws."""

import subprocess
import sys

import models

FOLDER = models.FIXTURES.parent / "docs/glossary"


def test_the_pictures_are_those_of_the_script(tmp_path):
    subprocess.run([sys.executable, str(FOLDER / "draw.py"), str(tmp_path)], check=True)
    drawn = {path.name: path.read_bytes() for path in tmp_path.glob("*.svg")}
    assert drawn == {path.name: path.read_bytes() for path in FOLDER.glob("*.svg")}
    page = (FOLDER.parent / "glossary.md").read_text("utf-8")
    assert all(f"](glossary/{name})" in page for name in drawn)
