"""Every example in the help of a function runs as it stands, from a copy of the project's top folder."""

import doctest
import inspect
import shutil

import osim_contact_scale as ocs
import pytest
from conftest import TOP
from osim_contact_scale import scaling

pytest.importorskip("pandas", reason="pandas is not installed: the examples show its tables")

FUNCTIONS = [name for name in (*ocs.__all__, "set") if inspect.isfunction(getattr(ocs, name))]


@pytest.fixture(scope="module")
def top(tmp_path_factory):
    """A temporary folder with the files of the top folder that the examples need."""
    folder = tmp_path_factory.mktemp("top")
    shutil.copytree(TOP / "fixtures", folder / "fixtures")
    return folder


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_examples_of_a_function(name, top, monkeypatch):
    monkeypatch.chdir(top)
    run_the_examples(getattr(ocs, name), name)


@pytest.mark.parametrize("name", scaling.__all__)
def test_the_examples_of_an_equation(name):
    run_the_examples(getattr(scaling, name), name)


def run_the_examples(function, name):
    (test,) = doctest.DocTestFinder(recurse=False).find(function, name, globs={"ocs": ocs, "scaling": scaling})
    assert test.examples, f"{name} has no example"
    said = []
    ran = doctest.DocTestRunner(verbose=False).run(test, out=said.append)
    assert ran.failed == 0, "".join(said)
