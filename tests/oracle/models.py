"""The models that OpenSim reads in these tests: every fixture of the project, and the corpus if it is available."""

import os
import re
from pathlib import Path

from command import ROOT

FIXTURES = ROOT / "fixtures"
CORPUS = os.environ.get("OSIM_CORPUS")
NO_CORPUS = "OSIM_CORPUS is not set: the models of other people are not part of this project"


def readme_rows():
    """`(folder, file, what OpenSim makes of it)` for each row of the generated tables in fixtures/README.md."""
    text = (FIXTURES / "README.md").read_text(encoding="utf-8")
    for folder in ("format", "bad", "check"):
        table = text.split(f"<!-- {folder}: begin -->")[1].split(f"<!-- {folder}: end -->")[0]
        for file, opensim in re.findall(r"^\| `([^`]+)` \|.*\| ([^|]+) \|$", table, re.MULTILINE):
            yield folder, file, opensim


def animals():
    """Table 1's animals; what README's first command writes beside them is none."""
    return sorted(path for path in (FIXTURES / "table1").glob("*.osim") if not path.stem.endswith(".scaled"))


def fixtures(*kinds):
    """Fixtures of which OpenSim makes one of `kinds`; Table 1's animals all read."""
    table1 = animals() if "reads" in kinds else []
    return table1 + [FIXTURES / folder / file for folder, file, opensim in readme_rows() if opensim in kinds]


def corpus():
    """The corpus models; standalone sets have tests of their own."""
    return sorted(Path(CORPUS).glob("*.osim")) if CORPUS else []


def label(path):
    """A test's name for a model."""
    return f"{path.parent.name}/{path.name}"
