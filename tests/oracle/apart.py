"""Jobs in processes of their own: one server imports OpenSim, once for all tests, and a fork of it does each job, two at a time.

`run_each_job(module, jobs)` gives what the function `run_job` of this module makes of each job, so that the caller's process stays free of
OpenSim, and no job sees what OpenSim keeps of another. Both ways go lines of JSON, in which floats keep their bits.
"""

import atexit
import importlib
import json
import os
import subprocess
import sys
import tempfile
import threading
from functools import cache
from pathlib import Path

WORKERS = int(os.environ.get("ORACLE_WORKERS", "2"))
ALONE = threading.Lock()


class Refused(Exception):
    """OpenSim has refused a job."""


def run_one_job(module, job):
    """The result of one job."""
    return run_each_job(module, [job])[0]


def run_each_job(module, jobs):
    """The results of jobs, in their order."""
    answers = ask(module, jobs)
    for answer in answers:
        if isinstance(answer, dict) and answer.keys() == {"error"}:
            raise Refused(answer["error"])
    return answers


def ask(module, jobs):
    """The results of the jobs, with `{"error"}` for those that OpenSim has refused."""
    jobs = list(jobs)
    if not jobs:
        return []
    with ALONE:
        to, answers = server().stdin, server().stdout
        to.write(json.dumps([module, jobs]) + "\n")
        to.flush()
        line = answers.readline()
    if not line:
        raise Refused("the process that imports OpenSim has ended")
    return json.loads(line)


@cache
def server():
    """The process that imports OpenSim; it ends with its caller."""
    started = subprocess.Popen([sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(started.communicate)
    return started


def serve():
    """Does the jobs of each line of standard input."""
    import opensim

    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Off")
    for line in sys.stdin:
        module, jobs = json.loads(line)
        print(json.dumps(forked(importlib.import_module(module).run_job, jobs)), flush=True)


def forked(function, jobs):
    """The results of a function for each job, in a fork and an empty folder, because OpenSim writes files when it prints a model."""
    with tempfile.TemporaryDirectory() as folder:
        answers = [Path(folder, f"{number}.json") for number in range(len(jobs))]
        running = set()
        for job, answer in zip(jobs, answers, strict=True):
            if len(running) == WORKERS:
                running.discard(os.wait()[0])
            child = os.fork()
            if child == 0:
                try:
                    os.dup2(2, 1)  # what OpenSim prints is no answer
                    os.chdir(tempfile.mkdtemp(dir=folder))
                    answer.write_text(json.dumps(answer_of(function, job)), encoding="utf-8")
                finally:
                    os._exit(0)
            running.add(child)
        while running:
            running.discard(os.wait()[0])
        silent = {"error": "OpenSim ended without a word"}
        return [json.loads(path.read_text(encoding="utf-8")) if path.exists() else silent for path in answers]


def answer_of(function, job):
    try:
        return function(job)
    except Exception as error:  # OpenSim throws its own kinds
        return {"error": str(error)}


if __name__ == "__main__":
    serve()
