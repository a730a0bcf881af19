"""The Python of docs/libraries.md and docs/plots.md: pandas reads the CSV of `inspect` and the numbers of a figure."""

import subprocess
import sys

import command
import models

DOCS = models.FIXTURES.parent / "docs"


def read_with_pandas(page, folder):
    """The output of the first Python example of a page, run in a folder."""
    code = (DOCS / page).read_text("utf-8").split("```python\n")[1].split("```")[0]
    (folder / "look.py").write_text(code, encoding="utf-8")
    return subprocess.run(
        [sys.executable, "look.py"],
        cwd=folder,
        env={"MPLBACKEND": "Agg", "MPLCONFIGDIR": str(folder)},
        capture_output=True,
        text=True,
        check=True,
    ).stdout


def test_pandas_reads_the_numbers_of_a_figure(tmp_path):
    call = "plot force falisse2022 --target-mass 1190 --label Human --label Giraffe -o a.svg --data print.csv"
    subprocess.run([str(command.BINARY), *call.split()], cwd=tmp_path, check=True, capture_output=True)
    lines = read_with_pandas("plots.md", tmp_path).splitlines()
    assert [line.split()[0] for line in lines] == ["Giraffe", "Human"]
    # Scaled contacts without dimensions are one curve.
    highest = [float(line.split()[2]) for line in lines]
    assert abs(highest[0] / highest[1] - 1) < 1e-9


def test_pandas_reads_the_table_of_a_folder(tmp_path):
    ran = subprocess.run(
        [str(command.BINARY), "inspect", str(models.FIXTURES / "table1"), "--format", "csv"], capture_output=True, check=True
    )
    (tmp_path / "models.csv").write_bytes(ran.stdout)
    shown = read_with_pandas("libraries.md", tmp_path)
    # All fourteen animals of Table 1 sink in deeper than 0.16; bipeds on one foot by 0.353, as printed.
    assert shown.count(".osim") == 14
    assert "human_62kg_hunt_crossley.osim" in shown and "0.3533" in shown
    assert (tmp_path / "stiffness.png").read_bytes().startswith(b"\x89PNG")
