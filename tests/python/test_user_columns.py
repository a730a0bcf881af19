"""The user's own columns of a table, its index, and its gaps: what comes back from `rescale_many`, and what is said."""

import shutil
import subprocess
import sys
import warnings

import osim_contact_scale as ocs
import pytest
from conftest import HUMAN
from osim_contact_scale._option_names import ROW_OPTIONS, RUN_OPTIONS

pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")
np = pytest.importorskip("numpy")

#: Columns of the user, of all kinds that pandas has.
OWN_COLUMNS = {
    "age": pd.array([31, None, 7, 40], dtype="Int64"),
    "height": [1.5, float("nan"), 1.75, 1.6],
    "site": pd.Categorical(["Ghent", "Utrecht", "Ghent", "Utrecht"]),
    "is_left": pd.array([True, None, False, True], dtype="boolean"),
    "born": pd.to_datetime(["1990-01-01", None, "2000-02-29", "1981-12-24"]),
    "note": ["=1", "~/notes", "", None],
    "anything": [{"a": 1}, [1, 2], b"x", None],
}


def subjects(**columns):
    """A table of four subjects with columns of the user, whose index is not a number and names some rows twice."""
    index = pd.MultiIndex.from_tuples([("a", 1), ("a", 1), ("b", 2), ("b", 3)], names=["group", "trial"])
    options = {
        "model": [str(HUMAN)] * 4,
        "target_mass": [70, 80, 90, 100],
        "output": [f"{number}.osim" for number in range(4)],
    }
    return pd.DataFrame({**options, **OWN_COLUMNS, **columns}, index=index)


@pytest.mark.parametrize(
    "keep", [True, list(OWN_COLUMNS), tuple(OWN_COLUMNS), pd.Index(list(OWN_COLUMNS)), [*OWN_COLUMNS, "target_mass"]]
)
def test_columns_and_index_come_back_untouched(keep):
    table = subjects()
    before = table.copy()
    results = ocs.rescale_many(table, keep=keep, dry_run=True)
    remaining = [name for name in table if name in OWN_COLUMNS or (keep is not True and name in [*keep])]
    pd.testing.assert_frame_equal(results[remaining], table[remaining])
    pd.testing.assert_frame_equal(table, before)
    assert list(results.columns[: len(remaining)]) == remaining
    assert list(results["target_mass_kg"]) == [70, 80, 90, 100] and results.columns.is_unique


def test_one_column_may_be_named_by_itself():
    table = subjects()[["model", "target_mass", "output", "site"]]
    assert list(ocs.rescale_many(table, keep="site", dry_run=True)["site"]) == list(table["site"])


def test_an_index_of_numbers_stays_what_it_is():
    for index in (
        pd.RangeIndex(4),
        pd.RangeIndex(10, 2, -2),
        pd.Index([3, 3, 1, 0], name="id"),
        pd.Index(list("abca")),
    ):
        table = subjects()[["model", "target_mass", "output"]].set_axis(index)
        pd.testing.assert_index_equal(ocs.rescale_many(table, dry_run=True).index, index, exact=True)


@pytest.fixture
def lab(tmp_path, monkeypatch):
    """A folder with models and a table of six rows: one row is empty, and the model of another row is broken."""
    monkeypatch.chdir(tmp_path)
    for number in range(6):
        shutil.copy(HUMAN, f"{number}.osim")
    (tmp_path / "3.osim").write_bytes(b"<OpenSimDocument")
    table = pd.DataFrame(
        {"model": [f"{number}.osim" for number in range(6)], "target_mass": np.arange(50.0, 56), "id": range(6)}
    )
    table.loc[1, ["model", "target_mass"]] = None
    table["id"] = table["id"].astype("Int64").where(table.index != 1)
    return table.set_axis(list("ABCDEF"))


@pytest.mark.parametrize(
    ("call", "status"),
    [
        ({}, {"A": "written", "C": "written", "D": "failed", "E": "written", "F": "written"}),
        ({"shard": "2/2"}, {"D": "failed", "F": "written"}),
        ({"dry_run": True}, {"A": "dry-run", "C": "dry-run", "D": "failed", "E": "dry-run", "F": "dry-run"}),
    ],
)
def test_rows_are_those_of_the_table_where_some_fail(call, status, lab):
    keywords = {"keep": True, "output_dir": "new", "summary": "run.csv", **call}
    for second in ({}, {} if "dry_run" in call else {"resume": True}):
        results = ocs.rescale_many(lab, **keywords, **second, force=True)
        assert dict(results["status"]) == status
        assert dict(results["model"]) == dict(lab["model"][list(status)])
        pd.testing.assert_series_equal(results["id"], lab["id"][list(status)])


def test_a_column_that_is_not_kept_is_an_error_that_says_how():
    with pytest.raises(ocs.RequestError, match=r"'height' is not an option .*'masss' .* did you mean 'mass'\?.*keep="):
        ocs.rescale_many(subjects(masss=62), dry_run=True, keep=[name for name in OWN_COLUMNS if name != "height"])


def test_a_name_that_is_nearly_an_option_is_reported():
    with pytest.warns(ocs.ContactScaleWarning, match=r"target_mas' .*did you mean 'target_mass'") as caught:
        results = ocs.rescale_many(subjects(target_mas=5), keep=True, dry_run=True)
    assert list(results["target_mas"]) == [5] * 4
    assert [warning.filename for warning in caught] == [__file__]


@pytest.mark.parametrize(
    ("keep", "kind", "message"),
    [
        (["agee"], ocs.RequestError, "no column 'agee': did you mean 'age'"),
        (["status"], ocs.RequestError, "the result has a column 'status' itself"),
        ("stiffness_factor", ocs.RequestError, "'stiffness_factor' itself"),
        (3, TypeError, "not int"),
        ({"age": 1}, TypeError, "not dict"),
        (b"age", TypeError, "not bytes"),
    ],
)
def test_wrong_names_are_refused(keep, kind, message):
    with pytest.raises(kind, match=message):
        ocs.rescale_many(subjects(status="x", stiffness_factor=2), keep=keep, dry_run=True)


def test_columns_of_a_file_are_kept_without_a_keyword(tmp_path):
    with pytest.raises(ocs.RequestError, match="are kept without it") as caught:
        ocs.rescale_many(tmp_path / "table.csv", keep=["age"])
    assert caught.value.keyword == "keep"


def test_every_column_of_a_result_is_known_before():
    """So that a column of the user with such a name is refused before anything is done."""
    results = ocs.rescale_many(subjects(), keep=True, dry_run=True)
    for name in set(results).difference(OWN_COLUMNS, ["model", "output"]):
        with pytest.raises(ocs.RequestError, match="itself"):
            ocs.rescale_many([{"model": HUMAN, "target_mass": 70, name: 1}], keep=[name], dry_run=True)


@pytest.mark.parametrize("form", ["records", "list"])
def test_lists_and_dictionaries_keep_columns_too(form):
    table = subjects()[["model", "target_mass", "output", "site", "born"]].to_dict(form)
    results = ocs.rescale_many(table, keep=["born", "site"], dry_run=True)
    assert list(results["site"]) == ["Ghent", "Utrecht", "Ghent", "Utrecht"] and list(results.columns[:2]) == [
        "site",
        "born",
    ]
    assert results["born"].dtype.kind == "M" and results["born"].isna().tolist() == [False, True, False, False]


def test_without_pandas_rows_are_dictionaries(monkeypatch):
    monkeypatch.setattr("osim_contact_scale._tables.importlib.util.find_spec", lambda name: None)
    (row,) = ocs.rescale_many([{"model": HUMAN, "target_mass": 70, "age": 31}], keep=["age"], dry_run=True)
    assert next(iter(row.items())) == ("age", 31) and row["status"] == "dry-run"


def test_options_are_those_of_the_program():
    """The package knows the columns of a row and of a run as the program does."""
    for option in RUN_OPTIONS:
        with pytest.raises(ocs.RequestError, match=f"the column '{option}' is about the whole run"):
            ocs.rescale_many([{"model": str(HUMAN), "target_mass": 70, option: 1}], dry_run=True)
    names = sorted((ROW_OPTIONS - {"from", "target_mass"}) | {"--model", "target-mass", "from_"})
    with pytest.raises(ocs.RequestError) as caught:
        ocs.rescale_many([{**dict.fromkeys(names, "?"), "unknown": 1}], dry_run=True)
    assert str(caught.value).count("is not an option") == 1 and "'unknown'" in str(caught.value)


def messages(caplog, table, **call):
    """Messages of a run, by their level."""
    caplog.clear()
    with caplog.at_level("INFO", "osim_contact_scale"), warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        ocs.rescale_many(table, dry_run=True, **call)
    said = {str(warning.message): "WARNING" for warning in caught}
    said |= {record.getMessage(): record.levelname for record in caplog.records}
    return {message: level for message, level in said.items() if " rows " in message}


def test_gaps_are_reported_once_for_each_column(caplog):
    gaps = subjects(mass=[62, None, None, 62], geometry=[None, None, None, None])
    assert messages(caplog, gaps, keep=True) == {
        "column mass: 2 of 4 rows are empty (NaN): the option is left out there": "WARNING",
        "column geometry: 4 of 4 rows are empty: the option is left out there": "INFO",
    }
    gaps = subjects(
        radius=["keep", None, "isometric", "keep"], contacts_mass=pd.array([62, None, 62, 62], dtype="Int64")
    )
    assert messages(caplog, gaps, keep=True) == {
        "column radius: 1 of 4 rows is empty (NaN): the option is left out there": "INFO",
        "column contacts_mass: 1 of 4 rows is empty: the option is left out there": "INFO",
    }
    gaps = subjects().to_dict("records")
    assert messages(caplog, [{**row, "mass": None} for row in gaps], keep=True) == {}
    assert messages(caplog, [{**gaps[0], "mass": float("nan")}, gaps[1]], keep=True) == {
        "column mass: 1 of 2 rows is empty (NaN): the option is left out there": "WARNING"
    }


def test_an_error_about_a_row_says_what_is_empty_in_it():
    with pytest.raises(ocs.RequestError) as caught:
        ocs.rescale_many(subjects(target_mass=[70, None, 90, 100], mass=[62, None, 62, 62]), keep=True, dry_run=True)
    assert "table: ('a', 1) (row 1): what to do is missing" in str(caught.value)
    assert "(empty there: target_mass (NaN), mass (NaN))" in str(caught.value)
    table = subjects(model=[str(HUMAN), None, str(HUMAN), str(HUMAN)])
    with pytest.raises(ocs.RequestError, match=r"\(row 1\), column 'model': empty, .*\(empty there: model \(NaN\)\)"):
        ocs.rescale_many(table, keep=True, dry_run=True)


def test_a_row_with_only_user_columns_is_an_error_and_an_empty_one_is_left_out(caplog):
    rows = [{"model": HUMAN, "target_mass": 70, "id": 1}, {"model": None, "target_mass": None, "id": 2}]
    with pytest.raises(ocs.RequestError, match=r"1 row is wrong, .*\ntable: row 1, column 'model': empty"):
        ocs.rescale_many(rows, keep=["id"], dry_run=True)
    rows[1]["id"] = None
    assert messages(caplog, rows, keep=["id"]) == {"1 of 2 rows is empty and left out": "INFO"}


def test_polars_comes_out_as_polars():
    polars = pytest.importorskip("polars", reason="polars is not installed")
    own = {"age": [31, None, 7], "site": ["Ghent", None, "Utrecht"], "born": [None, None, None]}
    types = {"age": polars.Int16, "site": polars.Categorical, "born": polars.Date}
    table = polars.DataFrame(
        {"model": [str(HUMAN)] * 3, "output": ["a", "b", "c"], "target_mass": [70, 80, 90], **own}
    ).cast(types)
    results = ocs.rescale_many(table, keep=True, dry_run=True)
    assert isinstance(results, polars.DataFrame) and results[[*own]].equals(table[[*own]])
    assert results[[*own]].schema == table[[*own]].schema and results.columns[:3] == list(own)
    assert results["target_mass_kg"].to_list() == [70, 80, 90] and results["status"].dtype == polars.String
    assert results["viscous_friction_factor"].dtype == polars.Float64 and results["changes"].dtype == polars.Int64
    plain = ocs.rescale_many(table.select("model", "output", "target_mass"), dry_run=True)
    assert plain.columns[0] == "row" and len(plain) == 3
    with pytest.raises(TypeError, match=r"collect\(\)"):
        ocs.rescale_many(table.lazy(), dry_run=True)
    # Other tables are read, too.
    falling = polars.DataFrame({"indentation": [0.001, 0.002, 0.004, 0.006], "force": [10.0, 30.0, 80.0, 150.0]})
    assert ocs.fit(falling, radius=0.03).record == ocs.fit(falling.to_dict(as_series=False), radius=0.03).record


@pytest.mark.filterwarnings("ignore:The Dataframe Interchange Protocol")
@pytest.mark.parametrize("interface", ["__arrow_c_stream__", "__dataframe__"])
def test_tables_of_other_libraries_are_read(interface, monkeypatch):
    pytest.importorskip("pyarrow", reason="pyarrow is not installed")
    table = subjects()[["model", "target_mass", "output", "age", "site"]].reset_index(drop=True)

    class Foreign:
        """A table of a library that nobody knows."""

    setattr(Foreign, interface, lambda self, *given, **named: getattr(table, interface)(*given, **named))
    results = ocs.rescale_many(Foreign(), keep=True, dry_run=True)
    assert list(results["site"]) == list(table["site"]) and list(results["age"][[0, 2]]) == [31, 7]
    monkeypatch.setattr("osim_contact_scale._rows.importlib.util.find_spec", lambda name: None)
    with pytest.raises(TypeError, match="is read by pandas"):
        ocs.rescale_many(Foreign(), keep=True, dry_run=True)


def test_polars_is_not_imported_for_others():
    code = (
        "import sys, osim_contact_scale as ocs\n"
        f"ocs.rescale_many([{{'model': {str(HUMAN)!r}, 'target_mass': 70, 'age': 1}}], keep=True, dry_run=True)\n"
        "print('polars' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "False\n"
