"""Fixtures of several tests: OpenSim's readings of models, each made once, by two processes at a time."""

import pytest

import command
from opensim_reads import read_models


class Readings:
    """OpenSim's readings by path; `fetch` reads many at once, and what is missing is read on demand."""

    def __init__(self):
        self.known = {}

    def fetch(self, paths):
        missing = [path for path in map(str, paths) if path not in self.known]
        if missing:
            self.known |= read_models(missing, dump=True)

    def __getitem__(self, path):
        self.fetch([path])
        return self.known[str(path)]


@pytest.fixture(scope="session")
def readings():
    return Readings()


@pytest.fixture(scope="session", autouse=True)
def binary():
    """The command under test must be there: an oracle that compares nothing proves nothing."""
    if not command.BINARY.exists():
        pytest.exit(f"{command.BINARY} is not there: build it (cargo build --release) or set OSIM_CONTACT_SCALE", 2)
