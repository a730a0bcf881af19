"""The recipes of docs/simulations.md: one machine, an address, and a real Slurm of two nodes. All give the same tables.

What is put in beside the page's own text is what differs from place to place: where Slurm's configuration and the environment of Python are, the
network, and a port.
"""

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import slurm as slurm_module
from conftest import FIXTURES, models, processes, table_bytes, wait_for
from osim_contact_scale.simulate._store import read_outcomes, read_statuses
from recipes import changed, recipe

COUNT = 8

missing = slurm_module.missing_programs()


def needs_slurm(test):
    """A test on a Slurm that it starts: dev/thorough runs it."""
    skipped = pytest.mark.skipif(bool(missing), reason=f"Slurm is not installed: no {', '.join(missing)}")
    return pytest.mark.slurm(skipped(test))


@pytest.fixture(scope="module")
def slurm():
    """A Slurm for the tests of this file."""
    with slurm_module.Slurm() as started:
        yield started


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    """A home folder with `~/osim`, the environment of Python of the page: here the one that runs the tests."""
    home = tmp_path_factory.mktemp("home")
    activate = home / "osim" / "bin" / "activate"
    activate.parent.mkdir(parents=True)
    activate.write_text(f'export PATH="{Path(sys.executable).parent}:$PATH"\n')
    return {
        **os.environ,
        "HOME": str(home),
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{slurm_module.SEARCHED}",
        "DASK_JOBQUEUE__SLURM__INTERFACE": "lo",
        "DASK_JOBQUEUE__SLURM__SCHEDULER_OPTIONS": "{'interface': 'lo'}",
    }


def type_in(folder, environment, *texts, seconds=90):
    """The output when somebody types this in a folder."""
    for text in texts:
        process = subprocess.run(
            ["bash", "-e", "-c", text], cwd=folder, env=environment, capture_output=True, text=True, timeout=seconds
        )
        assert process.returncode == 0, (text, process.stdout, process.stderr)
    return process.stdout


@pytest.fixture(scope="module")
def falling_models(tmp_path_factory, environment):
    """A folder with the models of the page, and their results without a cluster."""
    folder = tmp_path_factory.mktemp("made")
    shutil.copy(FIXTURES / "table1" / "emu_2_spheres_smooth_sphere.osim", folder / "walker.osim")
    type_in(folder, environment, *recipe("The models").typed)
    (command,) = recipe("One machine").typed
    type_in(folder, environment, changed(command, ("--results", "--scheduler here --results")))
    return folder


@pytest.fixture
def place(tmp_path, falling_models):
    """A folder with the models."""
    shutil.copy(falling_models / "walker.osim", tmp_path)
    shutil.copytree(falling_models / "walker.sweep", tmp_path / "walker.sweep")
    return tmp_path


def assert_same_tables(folder, falling_models):
    assert table_bytes(folder / "walker.results") == table_bytes(falling_models / "walker.results")


def test_the_models_fall(falling_models):
    """The models of the other tests fall, so that comparing them means something."""
    import pandas as pd

    table = pd.read_parquet(falling_models / "walker.results" / "table.parquet")
    assert list(table["status"]) == ["done"] * COUNT
    assert table["peak_force_bw"].nunique() == COUNT and (table["peak_force_bw"] > 1).all()


def test_one_machine(place, falling_models, environment):
    (command,) = recipe("One machine").typed
    # A share first, as the page advises; then all.
    type_in(place, environment, changed(command, ("--results", "--shard 1/8 --results")))
    assert not (place / "walker.results" / "table.csv").exists()
    type_in(place, environment, command)
    assert_same_tables(place, falling_models)


def test_an_address(place, falling_models, environment):
    office = recipe("Other computers: an address")
    office.write(place)
    script = place / "office.sh"
    script.write_text(changed(script.read_text(), ("8786", str(slurm_module.free_ports(1)[0]))))
    type_in(place, {**environment, "HOST": "127.0.0.1"}, *office.typed)
    assert_same_tables(place, falling_models)


@needs_slurm
def test_a_job_array(place, falling_models, environment, slurm):
    sent = recipe("Slurm: a job array")
    sent.write(place)
    array, _ = wait_for_all(slurm, place, {**environment, **slurm.environment}, *sent.typed)
    assert slurm.nodes(array) == set(slurm_module.NODES)
    assert_same_tables(place, falling_models)


@needs_slurm
def test_an_array_that_makes_its_models(place, falling_models, environment, slurm):
    shutil.rmtree(place / "walker.sweep")
    (part,) = recipe("Slurm: each job makes its own models").files.values()
    sent = recipe("Slurm: a job array")
    sent.write(place)
    head, _ = sent.files["array.sh"].split("python -m")
    (place / "array.sh").write_text(head + part)
    wait_for_all(slurm, place, {**environment, **slurm.environment}, *sent.typed)
    assert_same_tables(place, falling_models)
    name = "walker_sweep.csv"
    assert (place / "walker.sweep" / name).read_bytes() == (falling_models / "walker.sweep" / name).read_bytes()


@needs_slurm
def test_workers_of_dask(place, falling_models, environment, slurm):
    sent = recipe("Slurm: workers of Dask")
    sent.write(place)
    assert "8 done" in type_in(place, {**environment, **slurm.environment}, *sent.typed)
    assert_same_tables(place, falling_models)
    # They were jobs.
    assert [path.name for path in (place / "logs").iterdir()]


def wait_for_all(slurm, folder, environment, *typed):
    """Types it, and waits until all jobs that it sent are done: their numbers."""
    before = set(slurm.jobs())
    type_in(folder, environment, *typed)
    sent = sorted(set(slurm.jobs()) - before, key=int)
    states = slurm.wait(*sent)
    assert set(states.values()) == {"COMPLETED"}, (states, [path.read_text() for path in folder.glob("*.log")])
    return sent


#: As long as there is a file `wait`, models of the second half of the table do. Each run of a model leaves a mark.
WAITING = """
import os, time

def waiting(path, index, folder):
    with open(os.path.join(folder, f"{index}.{time.monotonic_ns()}"), "w"):
        pass
    while index > 12 and os.path.exists(os.path.join(folder, "..", "wait")):
        time.sleep(0.05)
    return {"square": index * index}
"""


class Killed:
    """The array of the page with another task: three shares of eight models, each of which waits at its fifth."""

    shares = (1, 2, 3)

    def __init__(self, folder, environment):
        self.folder, self.environment = folder, environment
        self.marks = folder / "marks"
        self.marks.mkdir()
        (folder / "waiting.py").write_text(WAITING)
        rows = models(folder / "models", 24)
        (folder / "table.csv").write_text("path,index\n" + "".join(f"{row['path']},{row['index']}\n" for row in rows))
        task = f"--task waiting.py:waiting --set folder={self.marks}"
        page = recipe("Slurm: a job array")
        self.typed = page.typed
        for name, text in page.files.items():
            text = changed(
                text, ("walker.sweep/walker_sweep.csv", "table.csv"), ("--task drop --set duration=0.5", task)
            )
            # These models are no sweep: the last job has none to make.
            lines = [line for line in text.splitlines(True) if not line.startswith("osim-contact-scale sweep")]
            text = "".join(lines)
            (folder / name).write_text(text.replace("--array=1-4", "--array=1-3").replace("ID/4", "ID/3"))
        # What a run gives that nobody stops.
        call = f"python -m osim_contact_scale.simulate table.csv {task} --scheduler here --workers 2 --results whole"
        type_in(folder, environment, call)
        for mark in self.marks.iterdir():
            mark.unlink()
        (folder / "wait").touch()

    def begun(self, share):
        """How often a model of this share was begun."""
        return sum(int(mark.name.split(".")[0]) % 3 == share % 3 for mark in self.marks.iterdir())

    def wait_for_the_fifth(self, share):
        wait_for(lambda: self.begun(share) == 5)

    def written(self, share):
        """How many rows of this share are in the results."""
        results = self.folder / "walker.results"
        done = [
            row.numbers["square"]
            for row in read_outcomes(results, read_statuses(results)).values()
            if row.status == "done"
        ]
        return sum(round(square**0.5) % 3 == share % 3 for square in done)


@needs_slurm
def test_jobs_that_are_ended(tmp_path, environment, slurm):
    """A job is cancelled, one is killed, one has to make room and begins again: the table is that of a run that nobody stopped."""
    killed = Killed(tmp_path, environment)
    job = slurm.submit("array.sh", cwd=tmp_path, environment=environment)
    killed.wait_for_the_fifth(1)
    slurm.call("scancel", f"{job}_1")
    killed.wait_for_the_fifth(2)
    for pid in processes("table.csv"):
        if b"\0SLURM_ARRAY_TASK_ID=2\0" in Path(f"/proc/{pid}/environ").read_bytes():
            os.kill(pid, signal.SIGKILL)
    slurm.wait(f"{job}_1", f"{job}_2")
    killed.wait_for_the_fifth(3)
    everything = ("--partition=urgent", f"--nodes={len(slurm_module.NODES)}", f"--ntasks-per-node={slurm_module.CPUS}")
    slurm.wait(slurm.submit(*everything, "--output=/dev/null", "--wrap", "true"))
    written = {share: killed.written(share) for share in killed.shares}
    begun = {share: killed.begun(share) for share in killed.shares}
    # SIGTERM comes before the end of a job that is cancelled or makes room. Where it does not, the last second is lost.
    assert written[1] == written[3] == 4
    assert written[2] <= 4
    (tmp_path / "wait").unlink()
    assert slurm.wait(job) == {f"{job}_1": "CANCELLED", f"{job}_2": "FAILED", f"{job}_3": "COMPLETED"}
    assert killed.written(3) == 8
    again = [changed(text, ("array.sh", "--array=1,2 array.sh")) for text in killed.typed]
    wait_for_all(slurm, tmp_path, {**environment, **slurm.environment}, *again)
    assert table_bytes(tmp_path / "walker.results") == table_bytes(tmp_path / "whole")
    # What was written was not done again.
    assert {share: killed.begun(share) for share in killed.shares} == {
        share: begun[share] + 8 - written[share] for share in killed.shares
    }
