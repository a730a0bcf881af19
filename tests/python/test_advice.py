"""The advice of a message can be said to the function that gave it, or to the one that it names: each `name=` is one of its keywords."""

import inspect
import re

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN

FOLDERS = ("bad", "check", "drawn_feet", "follows_size", "format", "scale_tool")
GENERIC = FIXTURES / "scale_tool" / "generic_smooth.osim"
FUNCTIONS = {name: made for name in (*ocs.__all__, "set") if inspect.isfunction(made := getattr(ocs, name))}
#: Each with what it cannot do without.
CALLS = [
    ("rescale", {"target_mass": 80}),
    ("rescale", {"target_mass": 80, "follow_bodies": True}),
    ("transfer", {"from_": "falisse2022"}),
    ("transfer", {"from_": GENERIC, "follow_bodies": True}),
    ("add", {"from_": "falisse2022"}),
    ("add", {"from_": HUMAN, "replace": True}),
    ("remove", {}),
    ("convert", {"to": "smooth"}),
    ("design", {"indentation": 0.1}),
    ("set", {"stiffness": "x2"}),
    ("note", {"contacts_mass": 62}),
    ("inspect", {}),
    ("check", {}),
]


#: Methods of results that messages name.
METHODS = {".write(": ocs.Result.write, ".save(": ocs.Figure.save}


def keywords(name):
    return {*inspect.signature(FUNCTIONS[name]).parameters}


def foreign_keywords(text, name):
    """The advised keywords that neither this function takes, nor a function that the sentence names before them."""
    found, name_of_function = [], name
    for word in re.split(r"(?<=[.;])\s|\s", text):
        if (call := re.match(r"\W*(?:ocs\.)?(\w+)\(", word)) and call[1] in FUNCTIONS:
            name_of_function = call[1]
        method = next((made for name, made in METHODS.items() if name in word), None)
        parameters = {*inspect.signature(method).parameters} if method else set()
        # `file="..."` is an attribute of XML.
        for keyword in re.findall(r"(?<![\w.<\"-])([a-z]\w*)=(?!=)", word):
            if keyword not in keywords(name_of_function) | keywords(name) | parameters | {"file"}:
                found.append((keyword, text))
    return found


def try_call(name, path, arguments):
    """All that a call says: its error, or its result; and what `check` finds in a new model, which is what `check` says."""
    try:
        result = FUNCTIONS[name](path, **arguments)
    except ocs.ContactScaleError as error:
        return [(name, str(error))]
    findings = [(name, str(one)) for one in getattr(result, "findings", [])]
    return [(name, str(result)), *findings, *(("check", str(one)) for one in getattr(result, "findings_after", []))]


@pytest.mark.parametrize(("name", "arguments"), CALLS)
def test_advised_calls_are_valid(name, arguments):
    read = 0
    for folder in FOLDERS:
        for path in sorted((FIXTURES / folder).glob("*.osim")):
            texts = try_call(name, path, arguments)
            read += len(texts)
            for by, text in texts:
                # What was written by somebody else stands in excerpts of files.
                own = "\n".join(line for line in text.splitlines() if not re.match(r"\s*\d*\s*\|", line))
                assert not foreign_keywords(own, by), path
    assert read > 200
