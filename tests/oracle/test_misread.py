"""Numbers, flags and sockets that OpenSim cannot read: where one changes a pose, a mass or a contact force of OpenSim's, `check` has an error there.

In six published models, one element of each property is damaged; `ORACLE_ELEMENTS=all` damages each element outside muscles.
"""

import json
import os
import random
import re
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import apart
import command
import opensim_shifts
from models import CORPUS, FIXTURES, NO_CORPUS
from opensim_shapes import pressed

MODELS = (
    "v40000_falisse_2022_human",
    "v40000_human_12_hunt_crossley",
    "v40000_dhondt_2024_3seg_human",
    "v40000_opencap_lai_arnold_crlf",
    "v30000_scone_h0914m",
    "v20302_dynamic_jumper",
)
ALL = os.environ.get("ORACLE_ELEMENTS") == "all"
# Numbers of muscles are left out, and texts in words.
WITHOUT_EFFECT = re.compile("Muscle|credits|publications")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


def leaves(text):
    """`(class of the owner, tag, start, end)` of the texts of elements that are numbers or flags, outside of what has no effect."""
    stack = []
    for tag in re.finditer(r"<!--.*?-->|<\?.*?\?>|<(/?)([\w:]+)[^<>]*?(/?)>", text, re.DOTALL):
        if tag[2] is None or tag[3]:
            continue
        if not tag[1]:
            stack.append((tag[2], tag.end()))
            continue
        name, start = stack.pop()
        content = text[start : tag.start()]
        above = [one for one, _ in stack]
        if "<" in content or "defaults" in above or any(WITHOUT_EFFECT.search(one) for one in above):
            continue
        words = content.split()
        if words and (all(map(NUMBER.fullmatch, words)) or words[0].lower() in ("true", "false")):
            yield above[-1], name, start, tag.start()


def damaged(owner, value, draw):
    """A text that looks like `value` and that OpenSim reads as another one, or not at all."""
    words = value.split()
    if words[0].lower() in ("true", "false"):
        return draw.choice(["no", "yes", "ja", "", "falsch", "2", "true false"]) if words[0].lower() == "true" else draw.choice(["yes", "on", "t", "ja"])
    poison = draw.choice(["nan", "inf"])
    if len(words) == 1:
        return draw.choice([words[0].replace(".", ",") if "." in words[0] else "x", "1e400", "", "\u2212" + words[0].lstrip("-"), "None", poison])
    first = [" ".join([word, *words[1:]]) for word in ("x", poison)]
    if owner == "PolynomialFunction":  # with fewer numbers it is another polynomial
        return draw.choice([*first, "1,5 2", ",".join(words), "(" + " ".join(words) + ")", "[" + ", ".join(words) + "]"])
    return draw.choice([*first, ",".join(words), "(" + " ".join(words) + ")", " ".join(words[:-1]), " ".join([*words, "0"]), ""])


def is_telling(value):
    """Whether a value is probably not the default."""
    return value.split()[0].lower() == "true" or any(float(word) != 0 for word in value.split() if NUMBER.fullmatch(word))


def chosen(text):
    """All leaves, or one of each property: the first whose value is probably not the default."""
    found = list(leaves(text))
    if ALL:
        return found
    by_property = {}
    for leaf in found:
        key, value = leaf[:2], text[leaf[2] : leaf[3]]
        if key not in by_property or (is_telling(value) and not by_property[key][0]):
            by_property[key] = (is_telling(value), leaf)
    return [leaf for _, leaf in by_property.values()]


@pytest.mark.skipif(not CORPUS, reason=NO_CORPUS)
@pytest.mark.parametrize("name", MODELS)
def test_misread_values_are_reported(name, tmp_path):
    source = Path(CORPUS, f"{name}.osim")
    text = source.read_bytes().decode("utf-8")
    ((rest, *_),) = opensim_shifts.shifted([(source, opensim_shifts.at([0.0]))])
    heights = [0.0, 0.01 - min(rest["heights"].values())]
    states = opensim_shifts.at(heights) + opensim_shifts.moving(heights)
    draw = random.Random(name)
    damages = []
    for owner, tag, start, end in chosen(text):
        new = damaged(owner, text[start:end], draw)
        path = tmp_path / f"{len(damages)}.osim"
        path.write_bytes((text[:start] + new + text[end:]).encode())
        damages.append((f"{tag} of {owner}: {text[start:end].strip()!r} -> {new!r}", text.count("\n", 0, start) + 1, path))
    assert len(damages) > 20
    whole, *changed = apart.ask("opensim_effects", [[str(path), states] for path in (source, *(path for _, _, path in damages))])
    assert "error" not in whole, whole
    with ThreadPoolExecutor(2) as pool:
        reports = list(pool.map(errors, [path for _, _, path in damages]))
    wrong, effects = [], 0
    for (what, line, _), result, lines in zip(damages, changed, reports, strict=True):
        if json.dumps(result) != json.dumps(whole):
            effects += 1
            if line not in lines:
                wrong.append(f"line {line}: {what}: errors in {lines}; OpenSim: {result.get('error', 'other numbers')[:200]}")
    print(f"{name}: {len(damages)} damaged, {effects} with an effect")
    assert effects > 5
    assert not wrong, "\n".join(wrong)


def errors(path):
    """The lines in which `check` has an error."""
    outcome = command.run("check", path)
    if outcome.error:
        return [outcome.error.get("line")]
    return [finding["line"] for finding in outcome.report["findings"] if finding["severity"] == "error"]


OLD, ELASTIC = "format/v30000.osim", "shapes/elastic_foundation.osim"
ENABLED, OFF, DISABLED = "<isDisabled>false</isDisabled>", "<appliesForce>false</appliesForce>", "<isDisabled>true</isDisabled>"
MESH = '<ElasticFoundationForce name="mesh">'
SMOOTH = '<SmoothSphereHalfSpaceForce name="contact_heel_r">'


@pytest.mark.parametrize(
    ("model", "old", "new", "is_on", "is_said"),
    [
        (OLD, ENABLED, ENABLED, True, False),
        (OLD, ENABLED, DISABLED, False, False),
        (OLD, ENABLED, OFF, False, False),
        (OLD, ENABLED, ENABLED + OFF, True, True),  # the first of both counts
        (OLD, ENABLED, OFF + ENABLED, False, False),
        (ELASTIC, MESH, MESH + DISABLED, True, True),  # documents from 30509 on have no isDisabled
        (ELASTIC, MESH, MESH + OFF, False, False),
        (ELASTIC, MESH, MESH + OFF.replace("false", "no"), True, True),
        ("check/within_limits.osim", SMOOTH, SMOOTH + DISABLED, True, True),
        ("check/within_limits.osim", SMOOTH, SMOOTH + OFF, False, False),
    ],
)
def test_flags_are_read_as_opensim_reads_them(model, old, new, is_on, is_said, tmp_path):
    shutil.copy(FIXTURES / "shapes/sole.obj", tmp_path)
    path, text = tmp_path / "model.osim", (FIXTURES / model).read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    name = "mesh" if model == ELASTIC else "contact_heel_r"
    assert (pressed(path, [0.01])[0][name] > 1.0) == is_on
    assert bool(errors(path)) == is_said


def test_exchanged_sockets_are_refused_and_said_to_be_that(tmp_path):
    text = (FIXTURES / "check/within_limits.osim").read_text()
    sphere, plane = "/contactgeometryset/heel_r<", "/contactgeometryset/floor<"
    path = tmp_path / "exchanged.osim"
    path.write_text(text.replace(sphere, "@").replace(plane, sphere).replace("@", plane))
    with pytest.raises(apart.Refused, match="Socket 'sphere' of type ContactSphere|Socket 'half_space' of type ContactHalfSpace"):
        pressed(path, [0.025])
    outcome = command.run("check", path)
    assert outcome.status == 1 and "the sockets of sphere and half-space are exchanged" in outcome.error["message"]
