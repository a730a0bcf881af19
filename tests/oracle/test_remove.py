"""`remove` after `add` gives the first file back, byte for byte, also with a `rescale` in between."""

import re

import pytest

import add_variants
import command
import models
from add_cases import CASES, Case



def taken_back(case, reading, folder):
    """Whether the bytes of the model are there again, without and with a rescaling in between."""
    before = case.model
    if case.bare:
        before = folder / "bare.osim"
        assert command.run("remove", case.model, "-o", before).status == 0
    noted, rescaled = folder / "added.osim", folder / "rescaled.osim"
    outcome = command.run("add", before, *case.options(reading), "-o", noted)
    if outcome.status != 0:
        pytest.skip(f"refused: {outcome.error}")
    mass = command.inspect(noted).report["contacts_mass_kg"]["value"]
    outcome = command.rescale(noted, 2.5 * mass, rescaled)
    assert outcome.status == 0 and outcome.report["changes"], outcome
    for path in (noted, rescaled):
        assert path.read_bytes() != before.read_bytes()
        second = path.with_suffix(".removed.osim")
        outcome = command.run("remove", path, "-o", second)
        assert outcome.status == 0, outcome
        assert second.read_bytes() == before.read_bytes(), path.name


# One for each model and way.
ONCE = list({(case.model, case.bare): name for name, case in reversed(CASES.items())}.values())


@pytest.mark.parametrize("name", ONCE)
def test_the_first_file_is_back(name, readings, tmp_path):
    taken_back(CASES[name], readings[CASES[name].reference], tmp_path)


@pytest.mark.parametrize("name, text", add_variants.chosen(), ids=lambda value: value[:40])
def test_the_first_document_is_back(name, text, readings, tmp_path):
    """Every other one with CRLF."""
    ends = "\n" if add_variants.NAMES.index(name) % 2 else "\r\n"
    path = tmp_path / f"{name}.osim"
    path.write_bytes(text.replace("\n", ends).encode())
    taken_back(Case(path), readings[Case(path).reference], tmp_path)


REPLACED = [name for name in ONCE if CASES[name].bare]


@pytest.mark.parametrize("name", REPLACED)
def test_replacing_is_removing_and_adding(name, readings, tmp_path):
    """All bytes but those of the note, which says what was made."""
    case = CASES[name]
    bare, added, replaced = (tmp_path / f"{one}.osim" for one in ("bare", "added", "replaced"))
    options = case.options(readings[case.reference])
    refused = command.run("add", case.model, *options, "-o", replaced)
    assert refused.status == 1 and "--replace" in refused.error["message"] and not replaced.exists()
    for arguments in (
        ("remove", case.model, "-o", bare),
        ("add", bare, *options, "-o", added),
        ("add", case.model, *options, "--replace", "-o", replaced),
    ):
        assert command.run(*arguments).status == 0
    texts = [re.sub(rb"\[contacts made for [^\]]*\]", b"", path.read_bytes()) for path in (added, replaced)]
    assert texts[0] == texts[1]


ONE_FOOT = models.FIXTURES / "format/v40600.osim"
# Bytes, line ends, credits, comments and versions that matter to a writer of text.
KINDS = ("bytes_", "components_", "credits_", "markup_", "set_", "v")
ODD = sorted(path for path in ONE_FOOT.parent.glob("*.osim") if path.name.startswith(KINDS))
# Without a contact; a class of its own.
WITHOUT = {"components_unknown_class"}


@pytest.mark.parametrize("path", [path for path in ODD if path.stem not in WITHOUT], ids=models.label)
def test_odd_bytes_are_back(path, tmp_path):
    """Our own contacts out, another model's in and out again."""
    bare, added, second = (tmp_path / f"{name}.osim" for name in ("bare", "added", "again"))
    assert command.run("remove", path, "-o", bare).status == 0
    options = ["--from", ONE_FOOT, "--reference-mass", "61.5", "--mass", "50", "--body-scale", "calcn_r=1.1,0.9,1.2"]
    if "bare_names" in path.stem:
        # OpenSim does not find the frame of the floor, which no contact used before: one has to confirm it.
        options += ["--yes", "wrong-afterwards"]
    outcome = command.run("add", bare, *options, "-o", added)
    assert outcome.status == 0, outcome
    assert command.run("remove", added, "-o", second).status == 0
    assert second.read_bytes() == bare.read_bytes()
