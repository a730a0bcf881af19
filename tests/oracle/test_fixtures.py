"""The fixtures are what their generators write, and OpenSim makes of each what the README says."""

import importlib
import sys

import pytest

import models
from models import FIXTURES, animals


@pytest.fixture(scope="module")
def written_anew(tmp_path_factory):
    """All fixtures, written again into a folder of their own."""
    root = tmp_path_factory.mktemp("fixtures")
    sys.path.insert(0, str(FIXTURES))
    try:
        (root / "table1").mkdir()
        importlib.import_module("make_table1").write_all(root / "table1")
        importlib.import_module("make_format").write_all(root)
    finally:
        sys.path.remove(str(FIXTURES))
    return root


@pytest.mark.parametrize("folder", ["table1", "format", "bad", "check"])
def test_generators_write_what_is_committed(folder, written_anew):
    anew = {path.name: path.read_bytes() for path in (written_anew / folder).iterdir()}
    # What OpenSim logs where it runs is nobody's fixture.
    own = (path for path in (FIXTURES / folder).iterdir() if path.name != "opensim.log")
    committed = {path for path in own if not path.stem.endswith(".scaled")}
    assert anew == {path.name: path.read_bytes() for path in committed}
    assert (written_anew / "README.md").read_bytes() == (FIXTURES / "README.md").read_bytes()


def test_tables_of_contacts_are_what_their_generator_writes(tmp_path):
    own = FIXTURES / "contact_tables"
    sys.path.insert(0, str(own))
    try:
        importlib.import_module("make_contact_tables").write_all(tmp_path)
    finally:
        sys.path.remove(str(own))
    committed = [path for kind in ("*.csv", "*.osim") for path in own.rglob(kind)]
    assert {path.relative_to(own): path.read_bytes() for path in committed} == {
        path.relative_to(tmp_path): path.read_bytes() for path in tmp_path.rglob("*.*") if path.is_file()
    }


def test_bones_are_what_their_generator_writes(tmp_path):
    """All but what zlib packs: another version of it packs otherwise."""
    sys.path.insert(0, str(FIXTURES / "feet"))
    try:
        importlib.import_module("make_feet").write_all(tmp_path)
    finally:
        sys.path.remove(str(FIXTURES / "feet"))
    files = {path.relative_to(tmp_path) for path in tmp_path.rglob("*.*") if path.is_file()}
    committed = {path.relative_to(FIXTURES / "feet") for path in (FIXTURES / "feet").rglob("*.*") if path.is_file()}
    assert files == {path for path in committed if path.suffix not in (".py", ".pyc")}
    packed = ("packed", "huge", "lz4")
    for path in sorted(path for path in files if not any(word in path.name for word in packed)):
        assert (tmp_path / path).read_bytes() == (FIXTURES / "feet" / path).read_bytes(), path


def test_opensim_makes_of_each_what_the_readme_says(readings):
    rows = list(models.readme_rows())
    readings.fetch([FIXTURES / folder / file for folder, file, _ in rows])
    assert {file: verdict(file, readings[FIXTURES / folder / file]) for folder, file, _ in rows} == {
        file: opensim for _, file, opensim in rows
    }


def verdict(file, reading):
    """A verdict in the words of the README."""
    if not reading["loads"]:
        return "refuses"
    if file.endswith(".xml"):
        return "reads as a set"
    return "reads" if reading["builds"] else "loads"


@pytest.mark.parametrize("path", animals(), ids=lambda path: path.stem)
def test_bodies_of_an_animal_weigh_exactly_its_mass(path, readings):
    masses = {
        "human_62kg": 62.0,
        "human_500kg": 500.0,
        "mouse": 0.0209,
        "emu_10_spheres": 37.80,
        "emu_2_spheres": 37.80,
        "horse": 545.0,
        "giraffe": 1190.0,
    }
    animal = next(name for name in masses if path.name.startswith(name))
    assert float.fromhex(readings[path]["mass_sum"]) == masses[animal]
