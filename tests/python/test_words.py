"""Texts for Python's users name keywords, calls and values of Python: no options, no fields of JSON, no command.

Every function is called with every keyword set to something odd. All that is said about it is read.
"""

import inspect
import logging
import pickle
import re
import shutil

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN, corpus
from osim_contact_scale import simulate

# A star does not import `set`, which would take the place of Python's own.
FUNCTIONS = {name: made for name in (*ocs.__all__, "set") if inspect.isfunction(made := getattr(ocs, name))}
KEYWORDS = {name for made in FUNCTIONS.values() for name in inspect.signature(made).parameters}

#: Words that belong to another front end.
FOREIGN = {
    "an option": r"(?<![\w!-])--[a-z]",
    "a command": r"osim-contact-scale (?:" + "|".join(name.replace("_", "-") for name in FUNCTIONS) + r")\b",
    "a type of JSON": r'\{"bytes"|invalid type|expected a (?:boolean|sequence|string)\b|=(?:true|false|null)\b',
    "a keyword apart from its value": r"\w= '",
    "True where another value was given": r"=True '",
    "a keyword that Python reserves": r"(?<![\w<])(?:from|class)=",
    "a text without quotation marks": r"\b(?:yes|radius|only|keep|to|moved_spheres|rule|dissipation_by)=(?!nan)[a-z]",
    "a request": r"\bin this request\b",
}

#: The name of a field in messages; docstrings have names of keywords in such marks.
FIELD = rf"`(?:{'|'.join(sorted({name.rstrip('_') for name in KEYWORDS} | {'set', 'file', 'models'}))})`"

MODEL = HUMAN.read_text(encoding="utf-8")
ODD = (
    True,
    1,
    -1,
    10**30,
    float("nan"),
    "",
    "x",
    "a=b",
    "0,5",
    ["a", "b"],
    {"a": 1},
    object(),
    b"a",
    "-",
    "y" * 3000,
    MODEL,
)

WALKER = FIXTURES / "motion" / "walker.osim"
WALK = FIXTURES / "motion" / "walk.mot"
PLATES = FIXTURES / "motion" / "plates.sto"
MANY_KEYWORDS = (
    "target_mass",
    "radius",
    "from_",
    "output_dir",
    "in_place",
    "yes",
    "select",
    "jobs",
    "shard",
    "no_such_keyword",
)

#: A call of each function, and keywords that it is given.
CALLS = {
    "rescale": [((HUMAN,), {"target_mass": 80})],
    "transfer": [((HUMAN,), {"from_": "falisse2022"})],
    "add": [((FIXTURES / "feet" / "human_30000.osim",), {"from_": HUMAN}), ((HUMAN,), {"feet": ["calcn_r"], "replace": True})],
    "convert": [((HUMAN,), {"to": "hunt-crossley"})],
    "remove": [((HUMAN,), {})],
    "set": [((HUMAN,), {"stiffness": "x2"})],
    "design": [((HUMAN,), {"indentation": 0.1}), ((), {"mass": 62, "radius": 0.03, "indentation": 0.1, "spheres": 6})],
    "note": [((HUMAN,), {"contacts_mass": 62})],
    "fit": [((FIXTURES / "measured" / "heel_pad.csv",), {"radius": 0.03, "indentation_unit": "mm"})],
    "motion": [((WALKER, WALK), {})],
    "drop_test": [((HUMAN,), {"samples": 11})],
    "plot": [(("force", HUMAN), {}), (("sweep",), {"table": FIXTURES / "plots" / "walking_speeds.csv"})],
    "presets": [((), {})],
    "sweep": [((HUMAN,), {"grid": "stiffness=x1,x2", "dry_run": True})],
    "check": [((HUMAN,), {})],
    "inspect": [((HUMAN,), {})],
    "rescale_many": [((FIXTURES / "libraries" / "table1.csv",), {"dry_run": True})],
    "many": [(("rescale", [HUMAN]), {"target_mass": 80, "dry_run": True}), (("set", [HUMAN]), {"dry_run": True})],
}  # fmt: skip


def foreign_in(text, more=()):
    """The words of another front end in a text."""
    result = [(name, match[0]) for name, pattern in FOREIGN.items() for match in re.finditer(pattern, text)]
    return result + [match[0] for pattern in more for match in re.finditer(pattern, text)]


def is_right(error):
    """Checks an exception: its words, its length, its keywords, and that it can be pickled."""
    text = str(error)
    assert not foreign_in(text, [FIELD]), text
    lines = text.splitlines()
    assert len(lines) <= 25 and max(map(len, lines)) <= 1300, text[:2000]
    if isinstance(error, ocs.ContactScaleError):
        assert not {"from", "class", "set", "file", "models"} & set(error.keywords), text
        back = pickle.loads(pickle.dumps(error))
        assert (type(back), str(back), back.__dict__) == (type(error), text, error.__dict__)


def copied(arguments, folder):
    """The arguments with a copy of the model: some functions write beside it."""
    copy = folder / HUMAN.name
    shutil.copy(HUMAN, copy)
    return [copy if item == HUMAN else [copy] if item == [HUMAN] else item for item in arguments]


def keywords_of(name):
    parameters = inspect.signature(FUNCTIONS[name]).parameters.values()
    names = [item.name for item in parameters if item.kind is item.KEYWORD_ONLY and item.name != "progress"]
    return MANY_KEYWORDS if name == "many" else names


@pytest.mark.parametrize("name", CALLS)
def test_messages_about_wrong_keywords(name, tmp_path, monkeypatch, caplog):
    monkeypatch.chdir(tmp_path)
    caplog.set_level(logging.INFO, logger="osim_contact_scale")
    for named, keywords in CALLS[name]:
        arguments = copied(named, tmp_path)
        for keyword in keywords_of(name):
            for value in ODD:
                try:
                    FUNCTIONS[name](*arguments, **{**keywords, keyword: value})
                except (ocs.ContactScaleError, TypeError, OSError) as error:
                    is_right(error)
    logged = {record.getMessage() for record in caplog.records}
    assert not [text for text in logged if foreign_in(text, [FIELD])]


@pytest.mark.parametrize("name", sorted(CALLS.keys() - {"design", "drop_test", "presets"}))
@pytest.mark.parametrize("source", [None, 12, "-", "", "nowhere.osim", b"", b"<x>", MODEL, [], [1], {"a": 1}, FIXTURES])
def test_messages_about_wrong_models(name, source, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (arguments, keywords), *_ = CALLS[name]
    place = 1 if name in ("plot", "many") else 0
    arguments = copied(arguments, tmp_path)
    given = [*arguments[:place], source, *arguments[place + 1 :]]
    try:
        done = FUNCTIONS[name](*given, **keywords)
    except (ocs.ContactScaleError, TypeError) as error:
        is_right(error)
    else:
        # Of many models, those that fail are rows or records; a folder of models is nothing odd to such functions.
        assert name == "many" or (source == FIXTURES and name in ("check", "inspect"))
        assert not foreign_in(str(done), [FIELD])


@pytest.mark.parametrize(
    ("call", "message", "keyword"),
    [
        (lambda: ocs.rescale(HUMAN, target_mass=True), "target_mass=True: expected a number or a text", "target_mass"),
        (lambda: ocs.rescale(HUMAN, target_mass="x"), 'target_mass="x": expected a mass in kg', "target_mass"),
        (lambda: ocs.rescale(HUMAN, target_mass=[5]), "target_mass=[5]: a list, expected one number or", "target_mass"),
        (lambda: ocs.rescale(HUMAN, target_mass=10**30), "target_mass: a whole number is too large", "target_mass"),
        (lambda: ocs.rescale(HUMAN, target_mass=80, level=1), "level=1: expected True or False", "level"),
        (lambda: ocs.rescale(HUMAN, target_mass=80, only=1), "only=1: expected a text, or a list of texts", "only"),
        (lambda: ocs.rescale(HUMAN, target_mass=62, body_scale_file=1), "body_scale_file=1: expected the name of a file", "body_scale_file"),
        (lambda: ocs.add(HUMAN, from_=HUMAN, class_="x"), 'class_="x": expected one of smooth,', "class_"),
        (lambda: ocs.transfer(HUMAN, from_="x"), "from_='x': there is no such file", "from_"),
        (lambda: ocs.set(HUMAN, stiffness="a: b"), 'stiffness="a: b": expected a number', "stiffness"),
        (lambda: ocs.set(HUMAN, radius=float("nan")), "radius=nan: expected a finite number", "radius"),
        (lambda: ocs.set(HUMAN, dissipation={"a": 1}), 'dissipation={"a": 1}: expected a number', "dissipation"),
        (lambda: ocs.sweep(HUMAN, grid="stiffness=1,2", point=-1), "point=-1: expected the number of one point, counted from 1", "point"),
        (lambda: ocs.many("rescale", [HUMAN], from_=HUMAN), "there is no keyword 'from_' here", "from_"),
        (lambda: ocs.many("rescale", [HUMAN], target_mas=8), "'target_mas' here: did you mean target_mass=", "target_mas"),
        (lambda: ocs.inspect(""), '"": it is empty, expected the name of a file', None),
        (lambda: ocs.check([]), "there are no models: the list is empty", None),
    ],
)  # fmt: skip
def test_a_value_is_written_as_python_writes_it(call, message, keyword):
    with pytest.raises(ocs.RequestError) as caught:
        call()
    assert message in str(caught.value)
    assert caught.value.keyword == keyword


def test_a_fitted_quantity_may_be_a_text():
    result = ocs.fit(WALKER, motion=WALK, plates=PLATES, fit="stiffness", yes="poor-fit")
    assert set(result.changes["property"]) == {"stiffness"}


def test_messages_shorten_long_texts():
    error = ocs.RequestError("usage", "begin" + "ä" * 50_000 + "end\n" + "next line")
    assert len(str(error)) < 620
    assert str(error).startswith("beginä") and str(error).endswith("äend\nnext line")
    assert "50008 letters in all" in error.message
    shown = str(ocs.ModelError("malformed-xml", "wrong", path="a.osim", line=1, column=2, excerpt="<" * 50_000))
    assert len(shown) < 700 and shown.startswith("a.osim:1:2: wrong\n     1 | <<<")


def test_messages_about_models():
    models = [FIXTURES, *corpus()[:12]]
    checked = ocs.check(models)
    texts = {text for finding in checked.findings for text in (finding.message, finding.why, finding.advice)}
    texts |= {str(finding.remedy) for finding in checked.findings} | {str(error) for error in checked.errors}
    texts |= {remark for record in checked.records for remark in record.get("remarks", ())}
    assert len(texts) > 100
    assert not [text for text in texts if text and foreign_in(text, [FIELD])]


def test_what_is_explained():
    assert not [str(text) for text in ocs.explain() if foreign_in(str(text), [FIELD])]


def documented():
    """Everything that `help` shows, by name."""
    for module in (ocs, ocs.scaling, simulate):
        for name in getattr(module, "__all__", None) or dir(module):
            made = getattr(module, name)
            if inspect.isclass(made):
                yield from ((f"{name}.{part}", value) for part, value in vars(made).items() if not part.startswith("_"))
            yield name, made


def test_docstrings_name_keywords():
    wrong = {name: foreign_in(inspect.getdoc(made) or "") for name, made in documented()}
    assert not {name: found for name, found in wrong.items() if found}
    assert not [name for name, made in documented() if "drop-test" in (inspect.getdoc(made) or "")]
