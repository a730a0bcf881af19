"""Tasks for tests: small functions, some of which fail."""

import os
import signal
import sys
import time

FACTOR = 2.0


def empty(path):
    return {}


def no_path(*, index):
    return {}


def size(path, grid_stiffness=None, factor=FACTOR):
    """Returns a number from the file, a value of the model's row, and a setting."""
    return {"size_bytes": os.path.getsize(path), "stiffness_n_m2": grid_stiffness, "scaled": scaled(factor)}


def scaled(factor):
    return FACTOR * factor


def series(path, **values):
    return {"columns": len(values)}, {"time_s": [0.0, 0.5, 1.0], "force_n": [0.0, float(values["index"]), 3.0]}


def process(path):
    """The number of the process, and what it found there."""
    import opensim

    before = getattr(opensim, "left_by_another", 0)
    opensim.left_by_another = 1
    return {"pid": os.getpid(), "left_by_another": before, "files": len(os.listdir("."))}


def by_index(path, index, spoil):
    """Fails in a way that `spoil` names for the index of the model."""
    deed = spoil.get(str(index))
    if deed == "raise":
        raise ValueError("it does not\x1b[31m stand in " + os.getcwd())
    if deed == "crash":
        import opensim

        print("about to fall", flush=True)
        state = opensim.Model().initSystem()
        # A model without a system, asked with the state of another one: OpenSim reads through a pointer to nothing.
        opensim.Model(path).getCoordinateSet().get(0).getValue(state)
    if deed == "endless":
        while True:
            time.sleep(0.01)
    if deed == "exit":
        sys.exit(3)
    if deed == "no row":
        return [1, 2]
    if deed == "kill the server":
        os.kill(os.getppid(), signal.SIGKILL)
        time.sleep(20)
    return {"square": index * index}


def marks(path, index, folder, seconds):
    """Writes a mark for each time that it runs, and waits `seconds`, unless a file forbids waiting."""
    with open(os.path.join(folder, f"{index}.{os.getpid()}.{time.monotonic_ns()}"), "w"):
        pass
    if not os.path.exists(folder + ".quick"):
        time.sleep(seconds)
    return {"square": index * index}, {"time_s": [0.0, 1.0], "index_back": [index, index]}
