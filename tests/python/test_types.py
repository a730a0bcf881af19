"""Two type checkers on the package: every example of the documents, and calls that give one thing or another."""

import ast
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
import typing

import osim_contact_scale as ocs
import pytest
from conftest import TOP

pytest.importorskip("mypy", reason="mypy is not installed")

#: A Python block.
BLOCK = re.compile(r"^```python\n(.*?)^```\n", re.M | re.S)
PAGES = [TOP / "README.md", TOP / "python" / "README.md", *sorted((TOP / "docs").rglob("*.md"))]

# OpenSim has no types; those of Dask are not all exported.
CONFIG = """
[mypy]
strict = true
allow_redefinition = true
[mypy-dask.*,dask_jobqueue.*]
follow_imports = skip
[mypy-opensim.*,matplotlib.*,pyarrow.*,cloudpickle.*,tqdm.*]
ignore_missing_imports = true
"""

#: pyright, where dev/install.sh put it, and what runs it.
PYRIGHT = TOP / "tests" / "pyright" / "node_modules" / "pyright" / "index.js"
NODE = shutil.which("node")

#: Packages without types, for pyright: whatever is asked of them is there, and may be anything.
WITHOUT_TYPES = ("opensim", "dask", "dask_jobqueue", "matplotlib", "matplotlib/pyplot")
ANYTHING = "from typing import Any\ndef __getattr__(name: str) -> Any: ...\n"

CALLS = """
from typing import Any, assert_type

import osim_contact_scale as ocs
import pandas as pd
import polars as pl

class Live:
    def printToXML(self, name: str) -> bool:
        return True
    def getInputFileName(self) -> str:
        return ""

live = Live()
frame = pd.DataFrame({"model": ["a.osim"], "target_mass": [70.0]})
assert_type(ocs.rescale("a.osim", target_mass=70), ocs.Result)
assert_type(ocs.rescale(live, target_mass=70), ocs.Result)
assert_type(ocs.rescale(ocs.set(b"", radius="x2"), target_mass=70, only=["radius"]), ocs.Result)
assert_type(ocs.design("a.osim", indentation=0.1), ocs.Result)
assert_type(ocs.design(mass=62, indentation=0.1), ocs.DesignSheet)
assert_type(ocs.fit("curve.csv", radius=0.03), ocs.Fit)
assert_type(ocs.fit(frame, radius=0.03), ocs.Fit)
assert_type(ocs.fit("a.osim", motion=[frame, frame]), ocs.Result)
assert_type(ocs.presets(), ocs.Presets)
assert_type(ocs.presets().frame(), pd.DataFrame)
assert_type(ocs.check(["a.osim", b""]).findings[0], ocs.Finding)
assert_type(ocs.inspect("a.osim")[0], dict[str, Any])
assert_type(ocs.inspect("a.osim").spheres, pd.DataFrame)
assert_type(ocs.rescale_many(frame, keep=["age"]), pd.DataFrame)
assert_type(ocs.rescale_many([{"model": "a.osim", "target_mass": 70}], keep=True), pd.DataFrame)
assert_type(ocs.rescale_many(pl.DataFrame({"model": ["a.osim"]})), pl.DataFrame)
assert_type(ocs.sweep("a.osim", grid={"stiffness": ["x1", 2.0], "radius": 0.1}), ocs.Sweep)
assert_type(ocs.sweep("a.osim", ladder=3, indentation=0.2), ocs.Sweep)
assert_type(ocs.drop_test("a.osim").peak_force_bw, float)
assert_type(ocs.drop_test("a.osim").series, pd.DataFrame)
assert_type(ocs.design(mass=62, indentation=0.1).stiffness, float)
assert_type(ocs.fit(frame, radius=0.03).stiffness["value"], float | None)
assert_type(ocs.motion("a.osim", "a.mot").feet[0]["spheres"][0]["peak_n"], float)
assert_type(ocs.presets()[0].dimensionless["modulus"], float)
ocs.fit(frame, radius=0.03).stiffness["mean"]  # type: ignore[typeddict-item]
assert_type(ocs.check(open("a.osim", "rb")), ocs.Check)
ocs.rescale("a.osim")  # type: ignore[call-arg]
ocs.rescale("a.osim", target_mass=None)  # type: ignore[arg-type]
ocs.rescale("a.osim", target_mass=70, only="radios")  # type: ignore[arg-type]
ocs.rescale("a.osim", target_mass=70, yes=["mass-in-pounds"])
ocs.rescale("a.osim", target_mass=70, yes="mass-in-stones")  # type: ignore[arg-type]
ocs.rescale(3, target_mass=70)  # type: ignore[arg-type]
ocs.transfer("a.osim")  # type: ignore[call-arg]
ocs.convert("a.osim", to="smoth")  # type: ignore[arg-type]
ocs.note("a.osim", stance_limbs=2)
ocs.sweep("a.osim", radius=0.1)  # type: ignore[call-overload]
ocs.fit(3)  # type: ignore[call-overload]
ocs.many("fit", "a.osim")  # type: ignore[arg-type]
ocs.rescael("a.osim")  # type: ignore[attr-defined]
"""


def checked(folder):
    """The messages of mypy about the Python files in a folder."""
    (folder / "mypy.ini").write_text(CONFIG, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--cache-dir", folder / "cache", *sorted(folder.glob("*.py"))]
    environment = {**os.environ, "MYPYPATH": str(TOP / "python")}
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


def program(text):
    """The Python blocks of a page, each in its own lines: they share their names, as where they run."""
    lines = [""] * text.count("\n")
    for match in BLOCK.finditer(text):
        code, first = match[1].splitlines(), text[: match.start(1)].count("\n")
        lines[first : first + len(code)] = code
    return "\n".join(lines) + "\n"


def found_by_pyright(folder):
    """The messages of pyright about the Python files in a folder, in its strictest mode: place and message."""
    for package in WITHOUT_TYPES:
        (folder / "stubs" / package).mkdir(parents=True)
        (folder / "stubs" / package / "__init__.pyi").write_text(ANYTHING, encoding="utf-8")
    # A line that a call must be refused on is a finding of its own where it is not.
    config = {"typeCheckingMode": "strict", "stubPath": "stubs", "extraPaths": [str(TOP / "python")]}
    config |= {"include": ["*.py"], "enableTypeIgnoreComments": True, "reportUnnecessaryTypeIgnoreComment": "error"}
    (folder / "pyrightconfig.json").write_text(json.dumps(config), encoding="utf-8")
    command = [NODE, PYRIGHT, "--project", folder, "--pythonpath", sys.executable, "--outputjson"]
    output = json.loads(subprocess.run(command, capture_output=True, text=True, check=False).stdout)
    assert output["summary"]["filesAnalyzed"] >= len(list(folder.glob("*.py")))
    for finding in output["generalDiagnostics"]:
        line = finding["range"]["start"]["line"] + 1
        yield f"{os.path.basename(finding['file'])}:{line}: {finding['message']} [{finding.get('rule')}]"


@pytest.fixture(scope="module")
def programs(tmp_path_factory):
    """A folder with the programs of all pages, and with the calls."""
    folder = tmp_path_factory.mktemp("programs")
    for page in PAGES:
        code = program(page.read_text(encoding="utf-8"))
        if code.strip():
            name = page.relative_to(TOP).with_suffix("").as_posix()
            (folder / f"{re.sub('[^a-zA-Z]', '_', name)}.py").write_text(code, encoding="utf-8")
    (folder / "calls.py").write_text(CALLS, encoding="utf-8")
    assert len(list(folder.glob("*.py"))) > 5
    return folder


def test_mypy_finds_nothing_in_examples_and_calls(programs):
    ran = checked(programs)
    assert ran.returncode == 0, ran.stdout + ran.stderr


@pytest.mark.skipif(NODE is None or not PYRIGHT.is_file(), reason="pyright is not installed: dev/install.sh python")
def test_pyright_finds_nothing_in_examples_and_calls(programs):
    assert "\n".join(found_by_pyright(programs)) == ""


def signatures():
    """Every public function and method, each with its annotations and the names of the arguments."""
    for name in (*ocs.__all__, "set"):
        value = getattr(ocs, name)
        parts = {name: value}
        if inspect.isclass(value):
            parts = {f"{name}.{part}": member for part, member in vars(value).items() if not part.startswith("_")}
        for label, part in parts.items():
            function = part.fget if isinstance(part, property) else getattr(part, "__func__", part)
            if inspect.isfunction(function):
                yield from ((label, what, kind) for what, kind in function.__annotations__.items())
    tree = ast.parse(inspect.getsource(sys.modules[ocs.rescale.__module__]))
    for node in (node for node in tree.body if isinstance(node, ast.FunctionDef)):
        for argument in (*node.args.posonlyargs, *node.args.kwonlyargs):
            yield node.name, argument.arg, ast.unparse(argument.annotation)


def test_no_signature_says_any():
    """But of what a record of JSON has, and of matplotlib, which need not be there."""
    said = [(label, what, kind) for label, what, kind in signatures()]
    assert len(said) > 500
    for label, what, kind in said:
        rest = kind.replace("dict[str, Any]", "").replace("Mapping[str, Any]", "")
        assert not re.search(r"\bAny\b", rest) or label == "Figure.plot", (label, what, kind)


def test_all_annotations_mean_something_where_they_run():
    for name in (name for name in (*ocs.__all__, "set") if inspect.isfunction(getattr(ocs, name))):
        assert "return" in typing.get_type_hints(getattr(ocs, name)), name


@pytest.mark.parametrize("module", ["osim_contact_scale", "osim_contact_scale._verbs"])
def test_a_star_leaves_the_set_of_python_alone(module):
    names = {}
    exec(f"from {module} import *", names)
    assert "rescale" in names and "set" not in names
    assert ocs.set is not set
