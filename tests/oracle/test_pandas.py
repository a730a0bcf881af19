"""The Python of docs/libraries.md: pandas reads the CSV of `inspect`, selects and draws."""

import subprocess
import sys

import command
import models

PAGE = models.FIXTURES.parent / "docs" / "libraries.md"


def test_pandas_reads_the_table_of_a_folder(tmp_path):
    ran = subprocess.run(
        [str(command.BINARY), "inspect", str(models.FIXTURES / "table1"), "--format", "csv"], capture_output=True, check=True
    )
    (tmp_path / "models.csv").write_bytes(ran.stdout)
    code = PAGE.read_text("utf-8").split("```python\n")[1].split("```")[0]
    (tmp_path / "look.py").write_text(code, encoding="utf-8")
    shown = subprocess.run(
        [sys.executable, "look.py"],
        cwd=tmp_path,
        env={"MPLBACKEND": "Agg", "MPLCONFIGDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    # All fourteen animals of Table 1 sink in deeper than 0.16; bipeds on one foot by 0.353, as printed.
    assert shown.count(".osim") == 14
    assert "human_62kg_hunt_crossley.osim" in shown and "0.3533" in shown
    assert (tmp_path / "stiffness.png").read_bytes().startswith(b"\x89PNG")
