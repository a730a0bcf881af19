"""Tables in memory: how DataFrames, dictionaries and lists are read, and the tables that are returned."""

import csv
import io
import os
import shutil
import typing

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN
from osim_contact_scale import _cells, _rows, _tables

pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")
np = pytest.importorskip("numpy")

GENERIC = FIXTURES / "scale_tool" / "generic_smooth.osim"


def result_of_row(**cells):
    """The result of a table with one row, which rescales the human to 70 kg without writing a file."""
    return ocs.rescale_many([{"model": HUMAN, "target_mass": 70, **cells}], dry_run=True)


# The human has 12 spheres, each with a force, and rescaling changes 6 numbers of each pair: 72.
@pytest.mark.parametrize(
    ("cells", "changes"),
    [
        ({}, 72),
        ({"exclude": ["contact_s1_r", "contact_s2_r"]}, 60),
        ({"exclude": ("contact_s1_r",)}, 66),
        ({"exclude": np.array(["contact_s1_r", "contact_s2_r", "contact_s3_r"])}, 54),
        ({"exclude": "contact_s1_r;contact_s2_r"}, 60),
        ({"exclude": []}, 72),
        ({"select": ["contact_s1_*", "contact_s2_*"]}, 24),
        ({"only": ["radius", "stiffness"]}, 24),
        ({"keep": ["stiffness", "dissipation"], "only": None}, 48),
        ({"exclude_body": ["toes_r", "toes_l"], "contacts_mass": 62}, 72),
        ({"yes": ["implausible-mass", "implausible-radius"]}, 72),
    ],
)
def test_lists_of_a_cell_arrive_as_lists(cells, changes):
    assert list(result_of_row(**cells)["changes"]) == [changes]


def test_lists_answer_every_question_that_they_name():
    with pytest.raises(ocs.NeedsAnswer):
        ocs.rescale(HUMAN, target_mass=62_000, radius="keep")
    row = {"model": HUMAN, "target_mass": 62_000, "radius": "keep", "yes": ["implausible-radius", "implausible-mass"]}
    assert list(ocs.rescale_many([row], dry_run=True)["status"]) == ["dry-run"]


def test_a_mapping_gives_each_body_its_factors(tmp_path):
    scales = {"calcn_r": [1.1, 1.05, 1.2], "calcn_l": 1.3, "toes_r": 1, "toes_l": np.array([1.0, 1.0, 1.0])}
    row = {"model": HUMAN, "from_": HUMAN, "follow_bodies": True, "body_scale": scales, "output": tmp_path / "new.osim"}
    frame = ocs.rescale_many([row], output_dir=tmp_path, yes="implausible-mass")
    assert list(frame["status"]) == ["written"]
    old, new = (ocs.inspect(path).spheres.set_index("name") for path in (HUMAN, tmp_path / "new.osim"))
    factors = new["location_x_m"] / old["location_x_m"]
    for body, factor in {"calcn_r": 1.1, "calcn_l": 1.3, "toes_r": 1.0, "toes_l": 1.0}.items():
        own_names = factors[[path.endswith(body) for path in old["body"]]]
        assert len(own_names) > 0 and own_names.to_list() == pytest.approx([factor] * len(own_names), rel=1e-9), body


def test_assignments_may_be_a_mapping_or_a_list():
    for assignments in (
        {"stiffness": "x2", "dissipation": 1},
        ["stiffness=x2", "dissipation=1"],
        "stiffness=x2 dissipation=1",
    ):
        frame = ocs.rescale_many([{"model": HUMAN, "set": assignments}], dry_run=True)
        assert list(frame["stiffness_factor"]) == [2.0] and list(frame["dissipation_to"]) == [1.0]


@pytest.mark.parametrize("item", ["a;b", "", " a", "a "])
def test_items_that_cannot_be_separated_again_are_refused(item):
    with pytest.raises(ocs.RequestError, match=r"row 0, column 'exclude'.*item of a list"):
        result_of_row(exclude=["contact_s1_r", item])


def test_gaps_in_columns_of_counts_and_of_yes_and_no():
    table = pd.DataFrame(
        {
            "model": [HUMAN] * 2,
            "from": "falisse2022",
            "spheres": [6, None],
            "stance_limbs": [1, None],
            "friction": [True, None],
            "strict": [0.0, float("nan")],
            "output": ["a.osim", "b.osim"],
        }
    )
    table["friction"] = table["friction"].astype("float64")
    assert table["stance_limbs"].dtype == "float64"
    assert list(ocs.rescale_many(table, dry_run=True)["status"]) == ["dry-run"] * 2


def test_numbers_stay_what_they_are_beside_texts_with_commas():
    """A text such as `0,5` makes `71.125` ambiguous in a file; a number of Python is not."""
    assert list(result_of_row(target_mass=71.125, **{"#dose": "0,5"})["target_mass_kg"]) == [71.125]


def test_own_columns_come_back_as_they_were():
    subjects = pd.DataFrame(
        {
            "model": [HUMAN] * 3,
            "target_mass": [70.0, 80.0, 90.0],
            "output": ["a.osim", "b.osim", "c.osim"],
            "#id": [11, 12, 13],
            "#height": [1.5, float("nan"), 1.75],
            "#text": ["=1", "~/notes", ""],
            "#count": pd.array([1, None, 3], dtype="Int64"),
            "#sex": pd.Categorical(["f", "m", "f"]),
            "#born": pd.to_datetime(["1990-01-01", None, "2000-02-29"]),
        },
        index=[5, 5, 0],
    )
    results = ocs.rescale_many(subjects, dry_run=True)
    own_names = [name for name in subjects if name.startswith("#")]
    pd.testing.assert_frame_equal(results[own_names], subjects[own_names])
    assert len(results.merge(subjects, on="#id")) == 3


def test_own_columns_of_a_list_come_back_as_they_were(monkeypatch):
    rows = [
        {"model": HUMAN, "target_mass": 70, "output": "a.osim", "#id": 7, "#line": "a\rb\nc"},
        {"model": HUMAN, "target_mass": 80, "output": "b.osim", "#id": 8, "#line": None},
    ]
    results = ocs.rescale_many(iter(rows), dry_run=True)
    assert list(results["#id"]) == [7, 8] and results["#id"].dtype == "int64" and results["#line"][0] == "a\rb\nc"
    monkeypatch.setattr(_tables.importlib.util, "find_spec", lambda name: None)
    results = ocs.rescale_many(rows, dry_run=True)
    assert [(record["#id"], record["#line"]) for record in results] == [(7, "a\rb\nc"), (8, None)]


def test_own_columns_stay_with_their_models_where_rows_are_empty_or_fail(tmp_path):
    broken = tmp_path / "broken.osim"
    broken.write_bytes(b"<OpenSimDocument")
    rows = [
        {"model": broken, "target_mass": 70, "#id": 1},
        {"model": None, "#id": None},
        {"model": HUMAN, "target_mass": 80, "#id": 3},
    ]
    results = ocs.rescale_many(rows, dry_run=True)
    assert dict(zip(results["model"], results["#id"])) == {str(broken): 1, str(HUMAN): 3}


def test_only_paths_have_a_home_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    shutil.copy(HUMAN, tmp_path / "human.osim")
    row = {"model": "~/human.osim", "target_mass": 70, "#note": "~/x"}
    results = ocs.rescale_many([row], dry_run=True, summary=tmp_path / "s.csv")
    assert list(results["model"]) == [str(tmp_path / "human.osim")] and list(results["#note"]) == ["~/x"]


@pytest.mark.parametrize(
    "text", ["=1", "-a", "'=1", "''@x", "'a", "-5", "\\u{1b}", "\x1b[2J", "a\rb", "\u202e", "Füße\xa0", ""]
)
def test_cells_can_be_read_back(text):
    written = _cells.to_cell(text)
    assert _cells.from_cell(written) == text
    assert not any(letter in written for letter in "\r\n\t\x1b\u202e")


# From the documentation of `cell` and `from_cell` in crates/osim-planning/src/sheet.rs.
@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("a\x1b[2J.osim", r"a\u{1b}[2J.osim"),
        ('=HYPERLINK("http://a.example")', '\'=HYPERLINK("http://a.example")'),
        (r"C:\models\heel_r.osim", r"C:\models\heel_r.osim"),
        (r"\u{1b}", r"\u{5c}u{1b}"),
        ("two\nlines\u202e", r"two\u{a}lines\u{202e}"),
        ("-0.05", "-0.05"),
        ("=1+1", "'=1+1"),
    ],
)
def test_cells_are_written_by_the_rule_of_the_program(text, cell):
    assert _cells.to_cell(text) == cell and _cells.from_cell(cell) == text


def test_a_letter_that_is_seen_is_not_written_by_its_number():
    assert _cells.from_cell(r"a\u{41}.osim") == r"a\u{41}.osim"
    assert _cells.from_cell(r"a\u{d800}\u{110000}\u{}") == r"a\u{d800}\u{110000}\u{}"


def test_the_summary_has_texts_that_look_like_formulas(tmp_path):
    """A text in a column of the user is the same in the table and in the file of the summary."""
    row = {"model": HUMAN, "target_mass": 70, "output": tmp_path / "a.osim", "#a": "=1", "#b": "two\rlines"}
    ocs.rescale_many([row], summary=tmp_path / "summary.ndjson", output_dir=tmp_path)
    text = (tmp_path / "summary.ndjson").read_text()
    assert '"#a":"=1"' in text and '"#b":"two\\rlines"' in text


def test_rows_are_one_line_each():
    written = _rows.to_csv([{"a": "x\ry", "b": 1.0}, {"a": "x\n", "b": True}])
    assert list(csv.reader(io.StringIO(written.decode()))) == [["a", "b"], [r"x\u{d}y", "1"], [r"x\u{a}", "true"]]


def test_two_columns_of_one_name_are_refused():
    frame = pd.DataFrame([[HUMAN, 70, 80]], columns=["model", "target_mass", "target_mass"])
    with pytest.raises(ocs.RequestError, match="'target_mass' appears twice"):
        ocs.rescale_many(frame, dry_run=True)
    with pytest.raises(ocs.RequestError, match="'from' appears twice"):
        result_of_row(from_="falisse2022", **{"from": "falisse2022"})


@pytest.mark.parametrize("name", ["#a;b", "#a\tb", "#a\nb"])
def test_names_that_would_change_the_table_are_refused(name):
    with pytest.raises(ocs.RequestError, match="must not contain"):
        result_of_row(**{name: 1})


def test_keywords_with_an_underscore_are_columns(tmp_path):
    frame = ocs.rescale_many([{"model": HUMAN, "from_": "falisse2022", "spheres": 6}], dry_run=True)
    assert list(frame["status"]) == ["dry-run"]
    row = {"model": HUMAN, "from_": "falisse2022", "class_": "smooth", "replace": True, "verb": "add"}
    with pytest.raises(ocs.RequestError) as caught:
        ocs.rescale_many([{**row, "class_": "nothing"}], dry_run=True)
    assert "column 'class'" in str(caught.value)


def test_models_without_a_file_are_refused_with_a_sentence():
    for model in (HUMAN.read_bytes(), ocs.rescale(HUMAN, target_mass=80)):
        with pytest.raises(TypeError, match="row 0, column 'model': a table takes paths"):
            ocs.rescale_many([{"model": model, "target_mass": 70}], dry_run=True)


def test_a_dictionary_of_single_values_is_refused_with_a_sentence():
    with pytest.raises(TypeError, match="a single row is a list with one dictionary"):
        ocs.rescale_many({"model": str(HUMAN), "target_mass": 70}, dry_run=True)
    with pytest.raises(TypeError, match="column 'target_mass'"):
        ocs.rescale_many({"model": [HUMAN], "target_mass": 70}, dry_run=True)


def test_columns_of_numbers_are_float64_also_where_all_is_missing():
    # This human is smooth, and its friction is not changed.
    frame = result_of_row()
    for name in ("static_friction_factor", "transition_velocity_to", "line"):
        assert frame[name].isna().all() and frame[name].dtype == "float64", name
    assert frame["error"].dtype != "float64"
    none = ocs.rescale(HUMAN, target_mass=62).changes
    assert len(none) == 0 and {none[name].dtype.name for name in ("old", "new", "factor")} == {"float64"}


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such names of files")
@pytest.mark.parametrize("name", ["=eq.osim", "-m\x1b[2J.osim", "'=a.osim"])
def test_the_table_of_a_sweep_names_files_that_there_are(name, tmp_path, monkeypatch):
    shutil.copy(HUMAN, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    sweep = ocs.sweep(os.path.join(".", name), grid={"stiffness": "x0.5,x1"}, output_dir="sweep")
    assert sweep.manifest.is_absolute() and "\x1b" not in repr(sweep)
    monkeypatch.chdir(FIXTURES)
    assert len(sweep.table) == 2 and all(os.path.isfile(path) for path in sweep.table["path"])


def test_the_numbers_of_a_figure_have_their_names():
    figure = ocs.plot("drop", HUMAN, label=["-left"])
    assert "-left" in set(figure.data["name"])
    assert figure.data["x"].dtype == figure.data["value"].dtype == "float64"


def hints_of_columns():
    """Every keyword of the verbs that change models, and what it takes."""
    verbs = ("rescale", "transfer", "add", "remove", "convert", "design", "set", "note")
    hints = {name: str(hint) for verb in verbs for name, hint in typing.get_type_hints(getattr(ocs, verb)).items()}
    return {name: hint for name, hint in hints.items() if name not in ("return", "source")}


@pytest.mark.parametrize("name", [name for name, hint in hints_of_columns().items() if "Sequence" in hint])
def test_every_list_is_written_as_docs_batch_says(name):
    mark = "," if name in ("only", "keep") else ";"
    for items in (["a", "b"], ("a", "b"), np.array(["a", "b"])):
        assert _rows.models_csv([{name: items}]).decode() == f'"{name}"\n"a{mark}b"\n'


@pytest.mark.parametrize("name", [name for name, hint in hints_of_columns().items() if "PathLike" in hint])
def test_every_path_has_a_home_folder(name):
    written = _rows.models_csv([{name: "~/a.osim"}]).decode().splitlines()
    assert written == [f'"{name.rstrip("_")}"', f'"{os.path.expanduser("~/a.osim")}"']


def test_a_wrong_cell_of_a_measured_curve_has_its_row():
    force = [0, 1, 3, 5, 8, "x"]
    curve = pd.DataFrame({"indentation": [0, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3], "force": force}, index=list("ABCDEF"))
    with pytest.raises(ocs.ModelError) as failed:
        ocs.fit(curve, radius=0.032)
    assert str(failed.value) == "table: F (row 5), column 'force': 'x' is not a number"
