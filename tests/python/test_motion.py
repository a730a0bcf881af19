"""`motion`: recordings as files and as tables give what the command gives."""

import math

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, asked, unspelled
from test_same_as_command import bits

FOLDER = FIXTURES / "motion"
WALKER, WALK = FOLDER / "walker.osim", FOLDER / "walk.mot"
PLATES, LOADS = FOLDER / "plates.sto", FOLDER / "plates.xml"


def table(path, factor=lambda name: 1.0):
    """The columns of a file, each multiplied by a factor."""
    lines = path.read_text(encoding="utf-8").split("endheader\n")[1].splitlines()
    names = lines[0].split("\t")
    rows = [[float(cell) for cell in line.split("\t")] for line in lines[1:]]
    return {name: [row[place] * factor(name) for row in rows] for place, name in enumerate(names)}


def test_files_are_those_of_the_command():
    (record,) = asked(verb="motion", subject=WALKER, motion=WALK, plates=PLATES, loads=LOADS)
    motion = ocs.motion(WALKER, WALK, plates=PLATES, loads=LOADS)
    assert bits(unspelled(motion.record)) == bits(unspelled(record))
    assert "right foot: up to 7.6 body weights" in str(motion)


def test_tables_say_the_same():
    pandas = pytest.importorskip("pandas")
    angles = ("pelvis_tilt", "ankle_r", "ankle_l")
    in_radians = table(WALK, lambda name: math.pi / 180 if name in angles else 1.0)
    from_files = ocs.motion(WALKER, WALK, plates=PLATES, loads=LOADS)
    from_tables = ocs.motion(
        WALKER, pandas.DataFrame(in_radians), plates=pandas.DataFrame(table(PLATES)).set_index("time"), loads=LOADS
    )
    assert from_tables.feet == from_files.feet
    in_degrees = ocs.motion(WALKER, table(WALK), angles="degrees")
    pandas.testing.assert_frame_equal(in_degrees.rows, from_files.rows)
    rows = from_files.rows
    assert len(rows) == 241 * 4 and set(rows["sphere"]) == {"heel_r", "ball_r", "heel_l", "ball_l"}
    assert rows["force_y_n"].max() == max(sphere["peak_n"] for foot in from_files.feet for sphere in foot["spheres"])


def test_what_is_no_table_over_time_is_refused():
    with pytest.raises(ocs.RequestError, match="a column 'time'"):
        ocs.motion(WALKER, {"x": [1.0]})
    with pytest.raises(ocs.RequestError, match="row 1 has a cell that is not a number"):
        ocs.motion(WALKER, {"time": [0.0, 1.0], "ankle_r": [0.0, "up"]})
    with pytest.raises(ocs.ContactScaleError, match="times must rise"):
        ocs.motion(WALKER, {"time": [0.0, 0.0], "ankle_r": [0.0, 0.1]})
