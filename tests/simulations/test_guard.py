"""A program without `if __name__ == "__main__":` ends with one line, and is run once."""

import subprocess
import sys

import pytest
from conftest import HUMAN, script

GUARD = 'if __name__ == "__main__":\n    '
PROGRAM = """
import sys
from osim_contact_scale import simulate
print("begins", flush=True)

def task(path):
    return {{"answer": 42}}

def main():
    print(simulate.run([{{"path": {path!r}}}], task, results={results!r}, workers=1).table["answer"][0])

{guard}main()
"""


@pytest.mark.parametrize("guarded", [True, False])
def test_the_guard_is_asked_for(tmp_path, guarded):
    text = PROGRAM.format(path=str(HUMAN), results=str(tmp_path / "r"), guard=GUARD if guarded else "")
    process = subprocess.run([sys.executable, script(tmp_path, text)], capture_output=True, text=True, cwd=tmp_path)
    if guarded:
        assert process.returncode == 0, process.stderr
        assert process.stdout.splitlines()[-1] == "42"
    else:
        assert process.returncode == 1
        (line,) = process.stderr.splitlines()
        assert line.startswith("program.py, line 12: put this call under `if __name__ ==")
        assert process.stdout == "begins\n"
        assert not (tmp_path / "r").exists() or not list((tmp_path / "r").rglob("*.parquet"))


@pytest.mark.parametrize(
    ("guard", "is_right"),
    [
        ('if "__main__" == __name__:\n    ', True),
        ('if __name__ == "__main__" and True:\n    ', True),
        ('if __name__ != "__main__":\n    pass\nelse:\n    ', True),
        ('try:\n  if __name__ == "__main__":\n    main()\nfinally:\n    pass\nif 0:\n    ', True),
        ('if __name__ != "__main__":\n    pass\n', False),
        ("if True:\n    ", False),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
def test_other_ways_to_say_it(tmp_path, guard, is_right, encoding):
    text = (
        """
from osim_contact_scale.simulate._guard import refuse_unguarded

def main():
    refuse_unguarded()

"""
        + f"{guard}main()\n"
    )
    program = tmp_path / "program.py"
    program.write_text(text, encoding=encoding)
    process = subprocess.run([sys.executable, program], capture_output=True, text=True, cwd=tmp_path)
    assert (process.returncode == 0) == is_right, process.stderr
    assert len(process.stderr.splitlines()) == (0 if is_right else 1)


def test_a_program_from_the_standard_input(tmp_path):
    text = PROGRAM.format(path=str(HUMAN), results=str(tmp_path / "r"), guard=GUARD)
    process = subprocess.run([sys.executable, "-"], input=text, capture_output=True, text=True, cwd=tmp_path)
    assert process.returncode == 1
    assert (
        process.stderr
        == 'a program from the standard input has no file for workers: save it, or say scheduler="here"\n'
    )


def test_a_task_cannot_begin_a_run(tmp_path):
    """Else a module without the guard would begin runs in its own models, without end."""
    text = """
from osim_contact_scale import simulate

def task(path):
    simulate.run([{"path": path}], task, results="inner", scheduler="here")

if __name__ == "__main__":
    print(simulate.run([{"path": PATH}], task, results=RESULTS, scheduler="here", workers=1).table["error"][0])
"""
    program = script(tmp_path, text.replace("PATH", repr(str(HUMAN))).replace("RESULTS", repr(str(tmp_path / "r"))))
    process = subprocess.run([sys.executable, program], capture_output=True, text=True, cwd=tmp_path, timeout=60)
    assert (
        process.stdout.startswith("a task cannot begin a run")
        or "RequestError: a task cannot begin a run" in process.stdout
    )
