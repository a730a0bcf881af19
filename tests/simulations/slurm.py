"""A Slurm of two nodes, both on this machine, in a folder of its own, for tests: its daemons start with it and end with it.

    with Slurm() as slurm:
        job = slurm.submit("--wrap", "hostname")
        slurm.wait(job)

Needs `slurmctld`, `slurmd`, `munged` (Debian: slurm-wlm, munge) and no rights: it runs as the user who starts it, and only that user can send
jobs. Ports are free ones, so that a Slurm of the machine, or of another test, is not met.
"""

import getpass
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from contextlib import contextmanager, suppress
from pathlib import Path

#: Debian has daemons where only root looks for programs.
SEARCHED = os.pathsep.join([os.environ.get("PATH", ""), "/usr/sbin", "/usr/local/sbin"])

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")

NODES = ("node1", "node2")

#: The names of the daemons' files. They start in this order, and end in the reverse one.
DAEMONS = ("munged", "slurmctld", *(f"slurmd-{node}" for node in NODES))

#: Processors and memory of each node, whatever the machine has: `config_overrides` has Slurm believe it.
CPUS, MEMORY_MB = 2, 8000

_CONF = """\
ClusterName=tests
SlurmctldHost=localhost
SlurmctldPort={controller}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
# cred_expire: seconds until a job that was put back may begin again.
AuthInfo=socket={folder}/munge.sock,cred_expire=5
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdSpoolDir={folder}/spool-%n
StateSaveLocation={folder}/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
DefMemPerCPU=1000
ReturnToService=2
SlurmdParameters=config_overrides
# The next job at once, where a real cluster collects some first.
SchedulerParameters=sched_interval=1,sched_min_interval=1000,bf_interval=1,batch_sched_delay=0
# Seconds from SIGTERM to SIGKILL.
KillWait=10
MinJobAge=300
{nodes}# Jobs in `urgent` take the place of others, which are put back into the queue.
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
PartitionName=tests Nodes=ALL Default=YES MaxTime=INFINITE State=UP PriorityTier=1
PartitionName=urgent Nodes=ALL MaxTime=INFINITE State=UP PriorityTier=2
"""

_NODE = (
    "NodeName={name} NodeHostName={host} NodeAddr=127.0.0.1 Port={port} CPUs={cpus} RealMemory={memory} State=UNKNOWN\n"
)


def missing_programs():
    """Programs of Slurm that are not installed."""
    return [name for name in PROGRAMS if _program(name) is None]


def _program(name):
    return shutil.which(name, path=SEARCHED)


class Slurm:
    """A controller, two nodes, and munge."""

    def __init__(self):
        # Not in pytest's folders: munge wants one that all users may enter, and its socket's path must be short.
        self.folder = Path(tempfile.mkdtemp(prefix="slurm-"))
        self.folder.chmod(0o755)
        self.conf = self.folder / "slurm.conf"
        #: With this in the environment, all of Slurm's programs mean this one.
        self.environment = {"SLURM_CONF": str(self.conf)}

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *error):
        self.stop()

    def _start(self):
        (self.folder / "state").mkdir()
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        controller, *ports = free_ports(1 + len(NODES))
        host = socket.gethostname().split(".")[0]
        nodes = [
            _NODE.format(name=name, host=host, port=port, cpus=CPUS, memory=MEMORY_MB)
            for name, port in zip(NODES, ports)
        ]
        self.conf.write_text(
            _CONF.format(folder=self.folder, user=getpass.getuser(), controller=controller, nodes="".join(nodes))
        )
        files = {"key-file": ".key", "socket": ".sock", "seed-file": ".seed", "pid-file": "d.pid", "log-file": "d.log"}
        self._call("munged", *(f"--{word}={self.folder}/munge{name}" for word, name in files.items()))
        self._call("slurmctld", "-c")
        for node in NODES:
            (self.folder / f"spool-{node}").mkdir()
            self._call("slurmd", "-N", node)
        until = time.monotonic() + 60
        while set(self.call("sinfo", "--noheader", "--Node", "--format", "%T").split()) != {"idle"}:
            if time.monotonic() > until:
                raise RuntimeError(f"the nodes do not come up: {self._logs()}")
            time.sleep(0.1)

    def stop(self):
        """Ends all jobs, then the daemons, and removes the folder."""
        try:
            with suppress(Exception):
                self.cancel_all()
        finally:
            for name in reversed(DAEMONS):
                _end(self.folder / f"{name}.pid")
            self._end_left()
            shutil.rmtree(self.folder, ignore_errors=True)

    def _end_left(self):
        """Ends programs that jobs left: without rights, Slurm cannot find programs whose parent has ended."""
        mark = f"SLURM_CONF={self.conf}".encode()
        for folder in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):
                if mark in (folder / "environ").read_bytes().split(b"\0"):
                    os.kill(int(folder.name), signal.SIGKILL)

    def cancel_all(self):
        """Ends every job with its processes, and waits for it."""
        jobs = [job for job, state in self.states(*self.jobs()).items() if state in _GOING_ON]
        if jobs:
            # To the processes themselves, which would have some seconds else.
            self._call("scancel", "--full", "--signal=KILL", *jobs, check=False)
            self._call("scancel", *jobs, check=False)
            self.wait(*jobs, seconds=20)

    def submit(self, *words, cwd=None, environment=None):
        """`sbatch`: the number of the job."""
        done = self._call("sbatch", "--parsable", *words, cwd=cwd, environment=environment)
        return done.stdout.strip().split(";")[0]

    def jobs(self):
        """Numbers of all jobs of the last minutes; an array is one."""
        return sorted(set(self.call("squeue", "--noheader", "--array", "--states=all", "--format", "%F").split()))

    def states(self, *jobs):
        """The states of jobs in Slurm, such as `RUNNING` or `COMPLETED`: by their number, or number_index in an array."""
        if not jobs:
            return {}
        said = self.call(
            "squeue", "--noheader", "--array", "--states=all", "--format", "%i %T", "--jobs", ",".join(jobs)
        )
        return dict(line.split() for line in said.splitlines())

    def nodes(self, job):
        """The nodes on which a job, or the jobs of an array, ran."""
        return set(
            self.call("squeue", "--noheader", "--array", "--states=all", "--format", "%N", "--jobs", job).split()
        )

    def wait(self, *jobs, seconds=60):
        """Until jobs are over: their states.

        Raises
        ------
        AssertionError
            They are not, after so many seconds.
        """
        until = time.monotonic() + seconds
        while True:
            states = self.states(*jobs)
            if states and not [state for state in states.values() if state in _GOING_ON]:
                return states
            assert time.monotonic() < until, f"jobs do not end: {states}: {self._logs()}"
            time.sleep(0.1)

    def call(self, name, *words, **options):
        """The output of one of Slurm's programs."""
        return self._call(name, *words, **options).stdout

    def _call(self, name, *words, cwd=None, environment=None, check=True):
        env = {**os.environ, **self.environment, **(environment or {})}
        program = _program(name)
        process = subprocess.run([program, *map(str, words)], env=env, cwd=cwd, text=True, capture_output=True)
        if check and process.returncode != 0:
            raise RuntimeError(f"{name}: exit status {process.returncode}: {process.stderr.strip()}{self._logs()}")
        return process

    def _logs(self):
        logs = [self.folder / f"{name}.log" for name in DAEMONS]
        return "".join(f"\n-- {path.name}\n{_tail(path)}" for path in logs if path.exists())


_GOING_ON = {"PENDING", "RUNNING", "COMPLETING", "CONFIGURING", "SUSPENDED", "REQUEUED", "STAGE_OUT", "SIGNALING"}


def _tail(path):
    return "\n".join(path.read_text(errors="replace").splitlines()[-8:])


def _end(pid_file):
    """Ends the daemon whose number is in the file, and waits for it."""
    try:
        number = int(pid_file.read_text())
    except (OSError, ValueError):
        return
    for kind, seconds in ((signal.SIGTERM, 10), (signal.SIGKILL, 5)):
        if not _lives(number):
            return
        with suppress(ProcessLookupError):
            os.kill(number, kind)
        until = time.monotonic() + seconds
        while _lives(number) and time.monotonic() < until:
            time.sleep(0.05)


def _lives(number):
    """Whether a process with this number runs; a process that has ended but was not waited for does not count."""
    try:
        return Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except OSError:
        return False


def free_ports(count):
    """Ports of TCP that nobody listens on."""
    with _sockets(count) as sockets:
        return [one.getsockname()[1] for one in sockets]


@contextmanager
def _sockets(count):
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        yield sockets
    finally:
        for one in sockets:
            one.close()
