"""Numbers at the edge of a double in recordings, measurements and sweeps: as in `test_edges.py`, what is not finite is not written, and
every JSON is one of its schema, which `command.run` looks at.

`ORACLE_MUTANTS` / 8 times; `ORACLE_SEED` says where to begin.
"""

import os
import random

import command
import pytest
from models import FIXTURES
from test_edges import EDGES, CONFIRMED, NOT_FINITE, SELDOM, model, with_edges

COUNT = max(int(os.environ.get("ORACLE_MUTANTS", "200")) // 8, 1)
FIRST = int(os.environ.get("ORACLE_SEED", "1"))
MOTION = FIXTURES / "motion"
MEASURED = FIXTURES / "measured" / "heel_pad.csv"


def spoiled(draw, text, first, separator):
    """A table with one to three cells at the edge, but for its times; `first` is its first row of numbers."""
    lines = text.splitlines()
    for _ in range(draw.randint(0, 3)):
        row = draw.randrange(first, len(lines))
        cells = lines[row].split(separator)
        cells[draw.randrange(1, len(cells))] = draw.choice(EDGES if draw.random() < 0.9 else SELDOM)
        lines[row] = separator.join(cells)
    return "\n".join([*lines, ""])


def tables(draw, folder, count=60):
    """A short recording and a measurement, spoiled; and where they are."""
    written = {}
    for name, per_frame in (("walk.mot", 1), ("plates.sto", 5)):
        lines = (MOTION / name).read_text().splitlines()
        head = lines.index("endheader") + 2
        text = "\n".join([*lines[: head + count * per_frame], ""])
        written[name] = folder / name
        written[name].write_text(spoiled(draw, text, head, "\t"))
    (folder / "plates.xml").write_text((MOTION / "plates.xml").read_text())
    measured = folder / "measured.csv"
    measured.write_text(spoiled(draw, MEASURED.read_text(), 1, ","))
    return written["walk.mot"], ("--plates", written["plates.sto"], "--loads", folder / "plates.xml"), measured


def numbers_of(text):
    """The count of numbers that are not finite in a table or a model."""
    return len(NOT_FINITE.findall(text))


@pytest.mark.parametrize("seed", range(FIRST, FIRST + COUNT))
def test_nothing_that_is_not_finite_is_written(seed, tmp_path):
    draw = random.Random(f"edges of recordings {seed}")
    motion, measured, curve = tables(draw, tmp_path)
    walker, other = tmp_path / "walker.osim", tmp_path / "other.osim"
    walker.write_text(with_edges(draw, (MOTION / "walker.osim").read_text()))
    other.write_text(model(draw))

    def edge():
        return draw.choice(EDGES)

    def out(name):
        return tmp_path / "out" / name

    out("").mkdir()
    fitted = ("--fit", draw.choice(["stiffness", "dissipation", "height"]))
    calls = [
        ("motion", walker, motion),
        ("motion", walker, motion, *measured, "--low-pass", draw.choice(["6", edge()])),
        ("motion", walker, motion, "--belt", edge(), "-o", out("grf.sto")),
        ("check", walker, "--motion", motion, *measured),
        ("fit", walker, "--motion", motion, *measured, *fitted, "-o", out("fitted.osim"), *CONFIRMED),
        ("fit", curve, "--indentation-unit", "mm", "--radius", draw.choice(["0.03", edge()])),
        ("fit", curve, "--indentation-unit", "mm", "--radius", "0.03", "--onset", draw.choice(["fit", edge()]), "--spheres", edge()),
        ("sweep", other, "--grid", f"stiffness=x1,x{edge()}", "--grid", f"dissipation={edge()},{edge()}", "-d", out("grid"), *CONFIRMED),
        ("sweep", other, "--grid", f"target_mass={edge()},{edge()}", "-d", out("masses"), *CONFIRMED),
        ("sweep", other, "--ladder", "2", "--indentation", edge(), "--restitution", "0.5", "-d", out("ladder"), *CONFIRMED),
    ]
    for call in calls:
        assert command.run(*call).status in (0, 1, 2), call
    # What each is made from; forces are calculated, and have no number of a file.
    first = {"grf.sto": None, "grf.xml": None, "fitted.osim": walker, "grid": other, "masses": other, "ladder": other}
    for path in sorted(out("").rglob("*")):
        # The summary of a sweep names what the first file has.
        if path.suffix in (".osim", ".sto", ".mot", ".xml"):
            source = first[path.relative_to(out("")).parts[0]]
            before = numbers_of(source.read_text()) if source else 0
            assert numbers_of(path.read_text()) <= before, path
