"""Every Python block of docs/simulations.md is a program that runs as it stands, and prints what the page says.

Files of recipes for clusters are run by test_slurm.py. `UPDATE_DOCS=1` writes what is printed now.
"""

import os
import re
import shutil
import subprocess
import sys

from conftest import TOP, script
from recipes import NAME

PAGE = TOP / "docs" / "simulations.md"

#: A program, and the text block that says what it prints.
BLOCK = re.compile(r"^```python\n(.*?)^```\n\n```text\n(.*?)^```\n", re.M | re.S)


def test_the_programs_of_the_page(tmp_path):
    shutil.copytree(TOP / "fixtures" / "table1", tmp_path / "fixtures" / "table1")
    text = PAGE.read_text(encoding="utf-8")
    found = list(BLOCK.finditer(text))
    files = [code for code in re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S) if NAME.match(code)]
    assert len(found) + len(files) == text.count("```python") > len(files)
    printed = []
    for match in found:
        process = subprocess.run(
            [sys.executable, script(tmp_path, match[1])], cwd=tmp_path, capture_output=True, text=True, timeout=100
        )
        assert process.returncode == 0, process.stderr
        printed.append(process.stdout)
    if os.environ.get("UPDATE_DOCS"):
        for match, new in reversed(list(zip(found, printed))):
            text = text[: match.start()] + f"```python\n{match[1]}```\n\n```text\n{new}```\n" + text[match.end() :]
        PAGE.write_text(text, encoding="utf-8", newline="\n")
    else:
        assert printed == [match[2] for match in found]
