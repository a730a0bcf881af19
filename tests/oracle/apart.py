"""Jobs in processes of their own: OpenSim is imported once, and a fork does each job, two at a time.

A script calls `serve(function)`: it reads a list of jobs from standard input and prints what `function` makes of each. `ask(script,
jobs)` runs it, so that the caller's process stays free of OpenSim.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

WORKERS = int(os.environ.get("ORACLE_WORKERS", "2"))


def ask(script, jobs):
    """The answers, in the order of the jobs; `{"error"}` where OpenSim has refused."""
    jobs = list(jobs)
    if not jobs:
        return []
    done = subprocess.run([sys.executable, script], input=json.dumps(jobs), capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def serve(function):
    """Does all jobs of standard input."""
    import opensim

    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Off")
    jobs = json.load(sys.stdin)
    with tempfile.TemporaryDirectory() as folder:
        answers = [Path(folder, f"{number}.json") for number in range(len(jobs))]
        running = set()
        for job, answer in zip(jobs, answers, strict=True):
            if len(running) == WORKERS:
                running.discard(os.wait()[0])
            child = os.fork()
            if child == 0:
                try:
                    os.chdir(tempfile.mkdtemp(dir=folder))
                    answer.write_text(json.dumps(answered(function, job)), encoding="utf-8")
                finally:
                    os._exit(0)
            running.add(child)
        while running:
            running.discard(os.wait()[0])
        silent = {"error": "OpenSim ended without a word"}
        print(json.dumps([json.loads(path.read_text(encoding="utf-8")) if path.exists() else silent for path in answers]))


def answered(function, job):
    try:
        return function(job)
    except Exception as error:  # OpenSim throws its own kinds
        return {"error": str(error)}
