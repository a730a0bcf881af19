"""Texts that Python and a notebook show: those of the command, short `repr`s, cells of at most 60 kB, names, DataFrames."""

import contextlib
import copy
import difflib
import logging
import os
import pickle
import re
import shutil
import subprocess
import sys

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN, corpus, fixtures, name_of, program
from osim_contact_scale._frames import MissingPackage, unit_from_name
from osim_contact_scale._html import html_table

TABLE1 = FIXTURES / "table1"
MOTION = FIXTURES / "motion"

#: Letters that a cell of a notebook may have.
CELL = 60_000


def command(verb, *models):
    """The text that the command prints on standard output."""
    ran = subprocess.run([program(), verb, *map(str, models)], capture_output=True, encoding="utf-8")
    return ran.stdout


def words(text):
    """The words of a text, without the lines of remedies: lines end elsewhere where a call is longer."""
    return " ".join(line for line in text.splitlines() if not line.startswith("$ ")).split()


def differing_lines(expected, actual):
    """The lines that differ and are no call or option, which each front end spells in its own way."""
    one, other = words(expected), words(actual)
    changes = difflib.SequenceMatcher(None, one, other, autojunk=False).get_opcodes()
    pairs = [(" ".join(one[a:b]), " ".join(other[c:d])) for kind, a, b, c, d in changes if kind != "equal"]
    return [pair for pair in pairs if not re.search(r"ocs\.|=", pair[1])]


@pytest.mark.parametrize("path", fixtures() + corpus(), ids=name_of)
def test_print_says_what_the_command_says_of_a_model(path):
    for verb in ("check", "inspect"):
        expected = command(verb, path)
        if expected:
            assert differing_lines(expected, str(getattr(ocs, verb)(path))) == []
        else:
            with pytest.raises(ocs.ContactScaleError):
                getattr(ocs, verb)(path)


@pytest.mark.parametrize("verb", ["check", "inspect"])
@pytest.mark.parametrize("folder", ["table1", "check", "format", "bad"])
def test_print_says_what_the_command_says_of_several_models(verb, folder):
    """A folder with models that cannot be read, too."""
    logging.getLogger("osim_contact_scale").setLevel(logging.CRITICAL)
    try:
        found = str(getattr(ocs, verb)(FIXTURES / folder))
    finally:
        logging.getLogger("osim_contact_scale").setLevel(logging.NOTSET)
    expected = command(verb, FIXTURES / folder)
    # Tables are the same to the letter. Calls are spelled as in Python: the remedy, and what follows the table.
    remedy = re.compile(r"^(\$ osim-contact-scale|ocs\.).*", re.M)
    ends = re.compile(r"^(What to do|In full|One model in full)", re.M)
    found, expected = (ends.split(remedy.sub("REMEDY", text))[0] for text in (found, expected))
    assert expected and found == expected


def test_print_of_several_models_ends_with_the_calls_of_python():
    said = str(ocs.check(FIXTURES / "check"))
    assert "fix=True" in said and "osim-contact-scale" not in said.replace("fixtures", "")
    inspected = str(ocs.inspect([HUMAN, HUMAN.read_bytes()]))
    # `full` is an option of the command alone.
    assert (
        inspected.count("human_62kg") == 1
        and "One model in full: ocs.inspect(" in inspected
        and "full=" not in inspected
    )
    # With another model it is each in full, as the factors of bodies have no room in a row.
    both = [FIXTURES / "scale_tool" / f"scaled_{kind}.osim" for kind in ("smooth", "smooth")]
    generic = FIXTURES / "scale_tool" / "generic_smooth.osim"
    assert str(ocs.inspect(both, from_=generic)).count("scaled_smooth.osim") >= 2
    assert pickle.loads(pickle.dumps(ocs.check(HUMAN))).text == ocs.check(HUMAN).text


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such names of files")
def test_print_steers_no_terminal(tmp_path):
    path = shutil.copy(HUMAN, tmp_path / "a\x1b[31m.osim")
    for survey in (ocs.check(path), ocs.inspect(path), ocs.check([path, HUMAN])):
        assert "\x1b" not in str(survey) + repr(survey)


def drop():
    return ocs.drop_test(HUMAN)


def sheet():
    return ocs.design(mass=62, spheres=6, radius=0.032, indentation=0.16, gravity=9.81)


def measured():
    return ocs.fit(
        FIXTURES / "measured" / "heel_pad.csv", radius=0.03, indentation_unit="mm", time_column="time", onset="fit"
    )


def recorded():
    return ocs.motion(MOTION / "walker.osim", MOTION / "walk.mot", plates=MOTION / "plates.sto")


def sunk_in():
    return ocs.check(FIXTURES / "check" / "sunk_in.osim")


#: Everything that has a class of its own, but a sweep, which makes files.
THINGS = {
    "Result": lambda: ocs.rescale(HUMAN, target_mass=1190),
    "Result that moves spheres": lambda: ocs.set(FIXTURES / "check" / "uneven_bottoms.osim", level=True),
    "Result that removes objects": lambda: ocs.remove(HUMAN),
    "Check": lambda: ocs.check(HUMAN),
    "Check of many": lambda: ocs.check(FIXTURES / "check"),
    "Inspection": lambda: ocs.inspect(HUMAN),
    "Inspection of many": lambda: ocs.inspect(TABLE1),
    "Findings": lambda: sunk_in().findings,
    "Finding": lambda: sunk_in().findings[0],
    "Remedy": lambda: next(finding.remedy for finding in sunk_in().findings if finding.remedy),
    "Figure": lambda: ocs.plot("force", HUMAN),
    "DropTest": drop,
    "Motion": recorded,
    "Fit": measured,
    "DesignSheet": sheet,
    "Presets": ocs.presets,
    "Preset": lambda: ocs.presets("falisse2022")[0],
    "Reproduction": ocs.reproduce,
    "Explanation": lambda: ocs.explain("13")[0],
}  # fmt: skip


@pytest.fixture(scope="module")
def shown_objects():
    """The objects whose texts the tests read, made once."""
    things = {}

    def thing(name):
        if name not in things:
            things[name] = THINGS[name]()
        return things[name]

    return thing


@pytest.fixture
def swept_human(human):
    return ocs.sweep(human, grid={"stiffness": "x0.1..x10/3"}, output_dir=human.parent / "variants")


@pytest.mark.parametrize("name", THINGS)
def test_representations_are_short(shown_objects, name):
    thing = shown_objects(name)
    said = repr(thing)
    assert len(said.splitlines()) <= 10 and len(said) < 2000 and said.startswith("<")
    assert type(thing).__name__ in said
    # The year in a source is not a number of the object.
    assert not re.search(r"\d…", said.replace("(2…", "")), said
    if name != "Figure":
        assert 20 < len(thing._repr_html_()) <= CELL and "style=" not in thing._repr_html_()


def test_a_sweep_shows_its_table(swept_human):
    assert repr(swept_human).startswith("<Sweep: 3 models in ") and swept_human._repr_html_().count("<tr>") == 4
    assert (
        list(swept_human.frame()["path"]) == list(swept_human["table"]["path"])
        and swept_human["models"] == swept_human.models == 3
    )
    assert swept_human.frame().attrs["units"] == {} or "stiffness" not in swept_human.frame().attrs["units"]
    assert pickle.loads(pickle.dumps(swept_human)).record == copy.copy(swept_human).record == swept_human.record


@pytest.mark.parametrize("path", fixtures() + corpus(), ids=name_of)
def test_a_cell_about_a_model_is_small(path):
    for look in (ocs.check, ocs.inspect, lambda path: ocs.rescale(path, target_mass=70, contacts_mass=62)):
        # Some of the fixtures are wrong on purpose.
        with contextlib.suppress(ocs.ContactScaleError):
            assert len(look(path)._repr_html_()) <= CELL


def thousand(survey):
    """A survey of a thousand copies of the model in `survey`, with the requests of their findings."""
    return [({**survey[0], "model": f"folder/{number}.osim"}, []) for number in range(1000)]


def test_a_cell_about_a_large_folder_is_small_and_says_where_the_rest_is():
    one = ocs.check(FIXTURES / "check" / "sunk_in.osim")
    many = type(one)(thousand(one), [], {})
    seen = ocs.inspect(HUMAN)
    inspected = type(seen)(thousand(seen), [], {})
    for survey in (many, inspected):
        page = survey._repr_html_()
        assert len(page) <= CELL and re.search(r"… and \d+ more: \.models has all", page)
    assert "<td>1000</td>" in many._repr_html_() and len(repr(many.findings).splitlines()) == 10


def test_long_texts_have_an_end_in_a_table():
    page = html_table(["a", "b"], [["'" * 100_000, number] for number in range(500)], "there")
    assert len(page) < 12_000 and "more: there" in page


def test_models_that_cannot_be_read_are_in_the_cell():
    logging.getLogger("osim_contact_scale").setLevel(logging.CRITICAL)
    try:
        check = ocs.check([HUMAN, FIXTURES / "no_such_<b>.osim"])
    finally:
        logging.getLogger("osim_contact_scale").setLevel(logging.NOTSET)
    assert "no_such_&lt;b&gt;.osim" in check._repr_html_() and "1 not read" in repr(check)


NAMES = {
    "Result": ("changes", "target_mass_kg", "path"),
    "Check": ("findings", "models", "errors"),
    "Inspection": ("spheres", "records"),
    "Findings": ("table", "code"),
    "Finding": ("code", "severity", "spheres", "remedy"),
    "Remedy": ("call",),
    "Figure": ("svg", "data"),
    "DropTest": ("peak_force_bw", "series", "text"),
    "Motion": ("weight_n", "rows"),
    "DesignSheet": ("stiffness", "radius_m", "figures"),
}


@pytest.mark.parametrize("name", NAMES)
def test_names_are_attributes_and_keys_alike(shown_objects, name):
    thing = shown_objects(name)
    for key in NAMES[name]:
        one, other = thing[key], getattr(thing, key)
        assert one.equals(other) if hasattr(one, "equals") else one == other, key
        assert key in dir(thing)
    with pytest.raises(KeyError, match=f"there is no nonsense; there are .*{NAMES[name][0]}"):
        thing["nonsense"]
    with pytest.raises(AttributeError, match=f"there is no nonsense; there are .*{NAMES[name][0]}"):
        _ = thing.nonsense
    with pytest.raises(AttributeError):
        _ = thing._ipython_display_
    for other in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
        assert type(other) is type(thing) and repr(other) == repr(thing)


def test_numbers_still_count():
    check = sunk_in()
    assert check[0] is check.records[0] and check.findings[0] == check.findings[:1][0]
    with pytest.raises(IndexError):
        check[7]
    assert check.findings.code == tuple(finding.code for finding in check.findings)


def test_a_design_sheet_is_asked_for_its_quantities():
    design = sheet()
    (stiffness,) = (figure["value"] for figure in design.record["figures"] if figure["name"] == "stiffness")
    assert design["stiffness"] == design.stiffness == stiffness
    assert {"stiffness", "figures", "remarks"} <= {*design} and len(design) == len([*design])
    assert dict(design)["stiffness"] == stiffness and "nonsense" not in design


FRAMES = {
    "Result": "changes", "Check": "table", "Inspection": "models", "Findings": "table", "Figure": "data", "DropTest": "series",
    "Motion": "rows",
}  # fmt: skip


@pytest.mark.parametrize("name", FRAMES)
def test_a_frame_is_the_table(shown_objects, name):
    pytest.importorskip("pandas", reason="pandas is not installed")
    frame = shown_objects(name).frame()
    assert frame.equals(getattr(shown_objects(name), FRAMES[name])) and len(frame) > 0


def test_frames_have_units():
    pytest.importorskip("pandas", reason="pandas is not installed")
    units = drop().frame().attrs["units"]
    assert units == {"time_s": "s", "height_m": "m", "speed_m_s": "m/s", "force_n": "N", "force_bw": "body weight"}
    assert ocs.inspect(HUMAN).frame().attrs["units"]["gravity_m_s2"] == "m/s2"
    assert recorded().frame().attrs["units"]["velocity_x_m_s"] == "m/s"
    assert unit_from_name("equilibrium_stiffness_n_m") == "N/m" and unit_from_name("name") is None


def test_frames_of_answers_have_a_row_for_each_number():
    pytest.importorskip("pandas", reason="pandas is not installed")
    design = sheet().frame().set_index("name")
    assert design.loc["stiffness", "unit"] == "N/m2" and design.loc["stiffness", "value"] == sheet().stiffness
    assert design.loc["relative_indentation", "limit"] == "at most 0.16"
    fit = measured().frame().set_index("name")
    assert fit.loc["stiffness", "value"] == measured().stiffness["value"] and fit.loc["onset_m", "unit"] == "m"
    assert fit.loc["dissipation", "unit"] == "s/m" and fit["low_95"].lt(fit["high_95"]).all()
    presets = ocs.presets().frame()
    assert len(presets) == len(ocs.presets()) and "dimensionless_modulus" in presets
    assert ocs.presets("falisse2022")[0].frame()["stiffness"][0] == 1e6
    assert len(ocs.reproduce().frame()) == ocs.reproduce().numbers


def test_without_pandas_a_frame_says_what_to_install(shown_objects, monkeypatch):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    for name in (*FRAMES, "DesignSheet", "Fit", "Presets", "Preset", "Reproduction"):
        with pytest.raises(ocs.ContactScaleError, match=r'pip install "osim-contact-scale\[pandas\]"') as caught:
            shown_objects(name).frame()
        assert isinstance(caught.value, ImportError)
        assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(MissingPackage, match=r'pip install "osim-contact-scale\[plot\]"'):
        shown_objects("Figure").plot()


def test_matplotlib_is_loaded_by_plot_alone():
    code = "import sys, osim_contact_scale as ocs; ocs.plot('force', 'falisse2022').svg; print('matplotlib' in sys.modules)"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "False"


@pytest.mark.parametrize("verb", ["inspect", "check", "many", "rescale_many", "sweep"])
def test_progress_is_a_bar_of_tqdm(human, monkeypatch, verb):
    pytest.importorskip("tqdm", reason="tqdm is not installed")
    bars = []

    class Bar:
        def __init__(self, **options):
            self.options, self.count = options, 0
            bars.append(self)

        def __enter__(self):
            return self

        def __exit__(self, *error):
            self.is_closed = True

        def update(self, count):
            self.count += count

    import tqdm.auto

    monkeypatch.setattr(tqdm.auto, "tqdm", Bar)
    models = [human, shutil.copy(HUMAN, human.with_name("other.osim"))]
    folder = human.parent / "new"
    {
        "inspect": lambda: ocs.inspect(models, progress=True),
        "check": lambda: ocs.check(models, progress=True),
        "many": lambda: ocs.many("set", models, stiffness="x2", output_dir=folder, progress=True),
        "rescale_many": lambda: ocs.rescale_many(
            [{"model": model, "target_mass": 70} for model in models], output_dir=folder, progress=True
        ),
        "sweep": lambda: ocs.sweep(human, grid={"stiffness": [1e5, 1e6]}, output_dir=folder, progress=True),
    }[verb]()
    (bar,) = bars
    assert bar.count == 2 and bar.is_closed
    # Of a list it is known how many there are.
    assert bar.options["total"] == (2 if verb in ("inspect", "check", "rescale_many") else None)
