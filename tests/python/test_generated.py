"""Generated files are up to date, and every function has complete help."""

import inspect
import subprocess
import sys
from pathlib import Path

import osim_contact_scale as ocs
import pytest
from conftest import TOP


@pytest.mark.parametrize("script", ["generate_python.py", "generate_scaling.py"])
def test_generated_code_is_up_to_date(script):
    ran = subprocess.run([sys.executable, TOP / "dev" / script, "--check"], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_a_new_option_is_noticed(tmp_path):
    """The check fails for an option that the schemas have and the functions have not."""
    import json
    import shutil

    shutil.copytree(TOP / "schemas", tmp_path / "schemas")
    shutil.copytree(TOP / "dev", tmp_path / "dev", ignore=shutil.ignore_patterns("__pycache__", "compare_programs"))
    shutil.copytree(TOP / "python" / "osim_contact_scale", tmp_path / "python" / "osim_contact_scale")
    path = tmp_path / "schemas" / "requests" / "rescale.schema.json"
    schema = json.loads(path.read_text(encoding="utf-8"))
    schema["properties"]["spring"] = {"description": "A new option", "type": ["number", "null"], "default": None}
    path.write_text(json.dumps(schema), encoding="utf-8")
    command = [sys.executable, tmp_path / "dev" / "generate_python.py", "--check"]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 1 and "spring" in ran.stdout


def test_the_stub_of_the_native_half_has_what_it_has():
    stub = (TOP / "python" / "osim_contact_scale" / "_native.pyi").read_text(encoding="utf-8")
    for name, value in vars(ocs._native).items():
        if name.startswith("__"):
            continue
        assert f"def {name}(" in stub or f"class {name}:" in stub or f"{name}:" in stub, name
        for method in vars(value) if inspect.isclass(value) else ():
            assert method.startswith("__") or f"{method}" in stub, (name, method)


def test_everything_public_has_a_docstring_and_is_exported():
    for name in ocs.__all__:
        value = getattr(ocs, name)
        assert name == "__version__" or inspect.getdoc(value), name
    assert {"rescale", "transfer", "add", "remove", "convert", "design", "note", "inspect", "check"} <= {*ocs.__all__}
    # Not for `import *`: see test_types.py.
    assert inspect.getdoc(ocs.set)


def test_the_versions_are_one():
    from importlib.metadata import version

    assert ocs.__version__ == version("osim-contact-scale")


def test_what_type_checkers_see_is_what_there_is():
    """Names are imported when they are used; type checkers see where from."""
    import ast

    tree = ast.parse(Path(ocs.__file__).read_text(encoding="utf-8"))
    (seen,) = (
        node.body for node in tree.body if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    )
    names = {alias.name: node.module for node in seen for alias in node.names}
    assert {*names} == {*ocs.__all__} - {"__version__"} | {"set", "simulate", "types"}
    for name, home in names.items():
        value = getattr(ocs, name)
        where = f"osim_contact_scale.{home}" if home else f"osim_contact_scale.{name}"
        assert value is (getattr(sys.modules[where], name) if home else sys.modules[where]), name
        assert name in dir(ocs)
    assert {*dir(ocs)} == {*ocs.__all__, "scaling", "set", "simulate", "types"}
    assert dir(ocs.simulate) == ["Drop", "Function", "Results", "Stand", "WorkersLost", "run"]
    with pytest.raises(AttributeError, match="rescael"):
        ocs.rescael  # noqa: B018


def test_the_package_runs_as_the_command():
    ran = subprocess.run([sys.executable, "-m", "osim_contact_scale", "--version"], capture_output=True, text=True)
    assert (ran.returncode, ran.stdout) == (0, f"osim-contact-scale {ocs.__version__}\n")
    assert subprocess.run([sys.executable, "-m", "osim_contact_scale", "rescal"], capture_output=True).returncode == 2


def test_importing_waits_for_nothing_that_is_not_used_yet():
    code = "import osim_contact_scale, sys; print([name for name in ('numpy', 'pandas', 'opensim', 'inspect', 'tempfile') if name in sys.modules])"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout == "[]\n"
