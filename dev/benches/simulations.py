"""What a run adds to the simulations themselves, and what two workers gain.

    target/python-venv/bin/python dev/benches/simulations.py [--drops N] [--empty N]

Needs the package with its extra `simulate`, and opensim. All is done by `simulate.run` with workers of Dask on this machine, which are
there when a clock begins; that each imports OpenSim is in the time.

- drops: the same N falls, each of at least 0.5 s in OpenSim, by one worker and by two. Overhead: wall time of all workers together, less
  the time of the processes of the models, for each model.
- empty: N tasks that do nothing, each in a process of its own.
- scheduler: as many tasks of Dask that do nothing, without our code.
"""

import argparse
import os
import platform
import tempfile
import time
from contextlib import contextmanager
from pathlib import Path

import distributed
import osim_contact_scale as ocs
from osim_contact_scale import simulate
from osim_contact_scale.simulate import _worker

MODEL = Path(__file__).resolve().parents[2] / "fixtures" / "table1" / "human_62kg_smooth_sphere.osim"


def empty(path):
    return {}


def do_nothing(number):
    return number


@contextmanager
def workers(count):
    """A client of so many workers."""
    with (
        distributed.LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def timed(points, task, count, folder):
    """Wall time, and the table of runs."""
    with workers(count) as client:
        begin = time.perf_counter()
        results = simulate.run(points, task, results=folder, scheduler=client)
        wall = time.perf_counter() - begin
    assert not len(results.failures), results.failures
    return wall, results.runs


def drops(models, scratch):
    # Long and exact enough to take OpenSim half a second.
    task = simulate.Drop(duration=6.0, samples=101, accuracy=1e-10)
    walls = {}
    for count in (1, 2):
        wall, runs = timed(models, task, count, scratch / f"drops{count}")
        walls[count] = wall
        process = runs["process_seconds"]
        over = 1e3 * (wall * count - process.sum()) / len(runs)
        print(
            f"drops: {len(runs)} on {count} workers {wall:.1f} s; OpenSim {runs['task_seconds'].min():.2f} to "
            f"{runs['task_seconds'].max():.2f} s each; overhead {over:.1f} ms each (limit 50)"
        )
    print(f"drops: two workers are {walls[1] / walls[2]:.2f} times as fast as one (at least 1.7)")


def empties(models, scratch):
    wall, runs = timed(models, empty, 2, scratch / "empty")
    print(
        f"empty: {len(runs)} on 2 workers {wall:.1f} s, {1e3 * wall * 2 / len(runs):.1f} ms each and worker (limit 25)"
    )


def scheduler(count):
    with workers(2) as client:
        pool = client.get_executor(pure=False)
        begin = time.perf_counter()
        for future in [pool.submit(do_nothing, number) for number in range(count)]:
            future.result()
        wall = time.perf_counter() - begin
    print(f"scheduler: {count} tasks of Dask {wall:.1f} s, {1e3 * wall / count:.2f} ms each (limit 5)")


def variants(count, scratch):
    """So many models, all of them different, without the time of a sweep."""
    text = MODEL.read_text()
    folder = scratch / f"models{count}"
    folder.mkdir()
    rows = []
    for index in range(count):
        path = folder / f"{index:06d}.osim"
        path.write_text(text.replace('name="human_62kg"', f'name="human_{index}"', 1))
        rows.append({"path": str(path), "index": index})
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--drops", type=int, default=200)
    parser.add_argument("--empty", type=int, default=10000)
    options = parser.parse_args()
    print(f"{platform.processor() or platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    print(
        f"osim-contact-scale {ocs.__version__}, distributed {distributed.__version__}, opensim {_worker.versions('benchmark').opensim}"
    )
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        if options.drops:
            drops(variants(options.drops, scratch), scratch)
        if options.empty:
            empties(variants(options.empty, scratch), scratch)
            scheduler(options.empty)


if __name__ == "__main__":
    main()
