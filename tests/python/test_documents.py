"""Every Python example of the pages about the package runs as it stands, from a copy of the project's top folder.

The blocks of a page run in its order, in one namespace. A text block right after one is what it prints; `UPDATE_DOCS=1` writes what
is printed now. A block that imports a package that is not installed is left out, and the test says so.
"""

import ast
import contextlib
import importlib.util
import io
import os
import re
import shutil
import warnings

import pytest
from conftest import TOP

pytest.importorskip("pandas", reason="pandas is not installed: the pages show its tables")

PAGES = ("docs/tutorial.md", "docs/python.md", "docs/work.md", "python/README.md")

#: A Python block, and the text block that says what it prints.
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.M | re.S)


def missing(code):
    """Packages that a block imports and that are not installed."""
    nodes = ast.walk(ast.parse(code))
    names = [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
    return [name for name in names if importlib.util.find_spec(name.split(".")[0]) is None]


@pytest.fixture
def top(tmp_path, monkeypatch):
    """A temporary folder with the files of the top folder that the examples need."""
    shutil.copytree(TOP / "fixtures", tmp_path / "fixtures")
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("page", PAGES)
def test_the_examples_of_a_page(page, top):
    text = (TOP / page).read_text(encoding="utf-8")
    namespace, result = {"__name__": page}, list(BLOCK.finditer(text))
    assert result, f"{page} has no Python"
    outputs = []
    for match in result:
        code, expected = match.groups()
        absent = missing(code)
        if absent:
            warnings.warn(f"{page}: an example was left out: {' and '.join(absent)} not installed", stacklevel=1)
            continue
        # Lines of a traceback are those of the page.
        above = "\n" * text[: match.start(1)].count("\n")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(above + code, str(TOP / page), "exec"), namespace)
        outputs.append((match, printed.getvalue()))
        if not os.environ.get("UPDATE_DOCS"):
            assert printed.getvalue() == (expected or ""), code
    if os.environ.get("UPDATE_DOCS"):
        for match, printed in reversed(outputs):
            shown = f"\n```text\n{printed}```\n" if printed else ""
            text = text[: match.start()] + f"```python\n{match[1]}```\n{shown}" + text[match.end() :]
        (TOP / page).write_text(text, encoding="utf-8", newline="\n")
