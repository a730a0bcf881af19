"""Every failure is an exception with code, message and place, and never ends Python."""

import io
import os
import pickle
import subprocess
import sys

import numpy as np
import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN


def test_line_and_column():
    with pytest.raises(ocs.ModelError) as caught:
        ocs.rescale(FIXTURES / "bad" / "tags_crossed.osim", target_mass=80)
    error = caught.value
    assert (error.code, error.line, error.column) == ("malformed-xml", 30, 26)
    assert error.excerpt is not None and "</dissipation>" in error.excerpt
    assert str(error).startswith(f"{error.path}:30:26: ")
    back = pickle.loads(pickle.dumps(error))
    assert (type(back), str(back), back.__dict__) == (type(error), str(error), error.__dict__)


def test_files_that_are_missing_or_there_already(tmp_path):
    for call in (ocs.check, lambda path: ocs.rescale(path, target_mass=80), lambda path: ocs.fit(path, radius=0.01)):
        with pytest.raises(FileNotFoundError, match="there is no such file") as caught:
            call(tmp_path / "gone.osim")
        assert isinstance(caught.value, ocs.ModelError) and caught.value.errno == 2
    with pytest.raises(FileNotFoundError, match="is not expanded"):
        ocs.check(tmp_path / "*.osim")
    back = pickle.loads(pickle.dumps(caught.value))
    assert (type(back), str(back)) == (type(caught.value), str(caught.value))
    (tmp_path / "there.osim").touch()
    with pytest.raises(FileExistsError, match="exists already") as existing:
        ocs.rescale(HUMAN, target_mass=80).write(tmp_path / "there.osim")
    assert isinstance(existing.value, ocs.OutputError) and existing.value.errno == 17


def test_open_files_are_taken_or_refused_by_name():
    expected = ocs.rescale(HUMAN, target_mass=80)
    with open(HUMAN, "rb") as file:
        result = ocs.rescale(file, target_mass=80)
    assert (result.path, result.to_bytes()) == (str(HUMAN), expected.to_bytes())
    assert len(ocs.check(io.BytesIO(HUMAN.read_bytes()))) == 1
    with open(HUMAN) as file:
        with pytest.raises(TypeError, match=r'TextIOWrapper reads text: .*open\(path, "rb"\)'):
            ocs.check(file)
        with pytest.raises(TypeError, match="not TextIOWrapper: give the path"):
            ocs.rescale_many(file)


def test_arrays_of_xarray_are_no_tables_and_say_how_to_make_one():
    class DataArray(list):
        def to_dataframe(self):
            raise AssertionError("a value of several dimensions is no table of its own")

    for call in (ocs.rescale_many, lambda table: ocs.fit(table, radius=0.03), lambda table: ocs.motion(HUMAN, table)):
        with pytest.raises(TypeError, match="not DataArray: to_dataframe"):
            call(DataArray())


def test_a_warning_has_a_category_and_the_line_of_the_call():
    with pytest.warns(ocs.ContactScaleWarning) as caught:
        ocs.set(HUMAN, constant_contact_force=1e-4)
    assert {warning.filename for warning in caught} == {__file__}


def test_missing_keywords_are_named():
    with pytest.raises(ocs.NeedsAnswer) as caught:
        ocs.rescale(HUMAN, target_mass=62_000)
    assert caught.value.code == "implausible-mass"
    assert caught.value.keyword == "yes"
    assert ocs.rescale(HUMAN, target_mass=62_000, radius="keep", yes=caught.value.code).changes is not None
    massless = FIXTURES / "format" / "standalone_ForceSet.xml"
    with pytest.raises(ocs.NeedsAnswer) as caught:
        ocs.design(massless, geometry=FIXTURES / "format" / "standalone_ContactGeometrySet.xml", indentation=0.1)
    assert caught.value.keyword == "spheres"


@pytest.mark.parametrize(
    ("keywords", "keyword"),
    [
        ({"target_mass": float("nan")}, "target_mass"),
        ({"target_mass": np.inf}, "target_mass"),
        ({"target_mass": -1}, "target_mass"),
        ({"target_mass": 80, "radius": "big"}, "radius"),
        ({"target_mass": 80, "level_axis": "y"}, "level_axis"),
        ({"target_mass": None}, "target_mass"),
    ],
)
def test_a_wrong_call_names_its_keyword(keywords, keyword):
    with pytest.raises(ocs.RequestError) as caught:
        ocs.rescale(HUMAN, **keywords)
    assert caught.value.keyword == keyword
    assert isinstance(caught.value, ValueError)


def test_a_keyword_that_is_always_needed_is_a_type_error():
    with pytest.raises(TypeError, match="target_mass"):
        ocs.rescale(HUMAN)


def test_a_keyword_that_there_is_not_is_a_type_error():
    with pytest.raises(TypeError, match="taget_mass"):
        ocs.rescale(HUMAN, taget_mass=80)


@pytest.mark.parametrize("before", ["", "\ufeff", "\n  "])
@pytest.mark.parametrize(
    "call",
    [
        lambda text: ocs.rescale(text, target_mass=80),
        lambda text: ocs.rescale(HUMAN, target_mass=80, geometry=text),
        lambda text: ocs.transfer(HUMAN, from_=text),
        lambda text: ocs.inspect([HUMAN, text]),
        lambda text: ocs.check(text),
    ],
)
def test_the_text_of_a_model_is_no_path(call, before):
    with pytest.raises(ocs.RequestError) as caught:
        call(before + HUMAN.read_text(encoding="utf-8"))
    assert str(caught.value) == "this is the text of a model: give its path, or bytes"


def test_no_text_is_echoed_whole():
    with pytest.raises(ocs.RequestError, match="a text of 53000 characters is no path") as caught:
        ocs.rescale("mass,N\n" + 52_993 * "1", target_mass=80)
    assert len(str(caught.value)) < 100
    for data in (HUMAN.read_bytes()[:-30], HUMAN.read_bytes().replace(b"\n", b"")[:-30], b"<xml " + 53_000 * b"y"):
        with pytest.raises(ocs.ModelError) as broken:
            ocs.rescale(data, target_mass=80)
        assert len(str(broken.value)) < 500


@pytest.mark.parametrize("source", ["-", ["a.osim"], 12, None, FIXTURES])
def test_what_is_no_model_is_refused_with_a_sentence(source):
    with pytest.raises((ocs.RequestError, TypeError), match=r"standard input|expected|folder"):
        ocs.rescale(source, target_mass=80)


def test_standard_input_is_not_waited_for():
    code = (
        "import osim_contact_scale as ocs\ntry: ocs.inspect('-')\nexcept ocs.ContactScaleError as error: print(error)"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, capture_output=True, text=True, timeout=60
    )
    assert "no model on its standard input" in ran.stdout


@pytest.mark.parametrize("threads", [1, 2])
def test_a_panic_is_an_exception(threads):
    with pytest.raises(ocs.ContactScaleError, match="asked for by a test") as caught:
        ocs._native.defect(threads)
    assert caught.value.code == "internal" and isinstance(caught.value, Exception)
    assert len(ocs.rescale(HUMAN, target_mass=80).changes) > 0


@pytest.mark.parametrize("name", ["two words", "Mäuse & Füße", 'it\'s "quoted"', "d" * 120 + os.sep + "e" * 120])
def test_names_of_folders(name, tmp_path):
    if os.name == "nt" and '"' in name:
        pytest.skip("Windows has no quotation marks in names of files")
    folder = tmp_path / name
    folder.mkdir(parents=True)
    path = folder / "Läufer 1.osim"
    path.write_bytes(HUMAN.read_bytes())
    assert len(str(path)) > 40
    (written,) = ocs.rescale(path, target_mass=80).write()
    assert written.parent == folder
    # A folder's results are no models of its own.
    assert [record["model"] for record in ocs.inspect(folder)] == [str(path)]


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="this system has no names that are not text")
def test_a_name_that_is_no_text(tmp_path):
    path = os.fsencode(tmp_path) + b"/m\xe4use.osim"
    with open(path, "wb") as file:
        file.write(HUMAN.read_bytes())
    (written,) = ocs.rescale(os.fsdecode(path), target_mass=80).write()
    assert os.fsencode(written).endswith(b"m\xe4use.scaled.osim")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such names of files")
def test_an_error_has_the_name_of_its_file_and_shows_a_harmless_one(tmp_path):
    path = tmp_path / "a\x1b[31m\n.osim"
    path.write_text("no model", encoding="utf-8")
    with pytest.raises(ocs.ModelError) as caught:
        ocs.inspect(path)
    assert caught.value.path == str(path)
    assert "\x1b" not in str(caught.value) and str(caught.value).count(r"a\u{1b}[31m\n.osim") == 1


def test_wrong_rows_have_a_line_each():
    rows = [{"model": HUMAN, "target_mass": "x"}, {"model": "nowhere.osim", "target_mass": 70}]
    with pytest.raises(ocs.RequestError) as caught:
        ocs.rescale_many(rows, dry_run=True)
    assert [line.split(":")[1].split(",")[0] for line in str(caught.value).splitlines()[1:]] == [" row 0", " row 1"]


def test_the_home_folder(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    (tmp_path / "human.osim").write_bytes(HUMAN.read_bytes())
    assert ocs.rescale("~/human.osim", target_mass=80).write("~/new.osim") == [tmp_path / "new.osim"]


@pytest.mark.skipif(os.name == "nt", reason="on Windows the attribute of a folder does not forbid new files in it")
def test_a_read_only_folder(tmp_path):
    code = "import os\nos.setuid(65534)\n" if hasattr(os, "geteuid") and os.geteuid() == 0 else ""
    folder = tmp_path / "closed"
    folder.mkdir()
    for path in (tmp_path, *tmp_path.parents[:2]):
        os.chmod(path, 0o755)
    path = folder / "human.osim"
    path.write_bytes(HUMAN.read_bytes())
    os.chmod(folder, 0o555)
    planned = f"import osim_contact_scale as ocs\nresult = ocs.rescale({str(path)!r}, target_mass=80)\n"
    tried = "try: result.write()\nexcept ocs.OutputError as error: print('refused:', error)\n"
    ran = subprocess.run([sys.executable, "-c", planned + code + tried], capture_output=True, text=True)
    os.chmod(folder, 0o755)
    assert ran.stdout.startswith("refused:"), ran
    assert [entry.name for entry in folder.iterdir()] == ["human.osim"]


@pytest.mark.parametrize("missing", [np.ma.array([80.0, 70.0], mask=[True, False])[0], np.array(None)])
def test_a_missing_number_is_not_taken_for_none(missing):
    with pytest.raises(ocs.RequestError, match="the value is missing") as caught:
        ocs.rescale(HUMAN, target_mass=50, contacts_mass=missing)
    assert caught.value.keyword == "contacts_mass"


def test_numbers_of_numpy_are_numbers():
    for kind in (np.longdouble, np.float32, np.int16, np.array):
        assert ocs.rescale(HUMAN, target_mass=kind(50)).target_mass_kg == 50


def test_names_that_no_file_has(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ocs.RequestError, match="half of a letter"):
        ocs.inspect("\ud800.osim")
    with pytest.raises(ocs.RequestError, match="there is no user nobody_at_all here"):
        ocs.rescale(HUMAN, target_mass=50).write("~nobody_at_all/new.osim")
    with pytest.raises(ocs.RequestError, match=r"\\u\{1b\}.*expected a name that ends in"):
        ocs.plot("force", HUMAN).save("\x1b[31m.gif")
    assert not list(tmp_path.iterdir())


def test_a_number_that_no_float_holds():
    with pytest.raises(ocs.RequestError, match="too large") as caught:
        ocs.scaling.dissipation(radius_ratio=10**400)
    assert caught.value.keyword == "radius_ratio"
