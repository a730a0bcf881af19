"""The note survives the real OpenSim: what a model's contacts were made for is known after a save and after scaling.

Documents of every version from 1.9 to 4.6, five ways through OpenSim. Nothing is scaled twice in silence.
"""

import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import command
import models
from opensim_saves import FACTOR, save

TIMES = 4.0
WAYS = ("save", "init", "scale", "tool", "processor")
WORKERS = 2
DIGITS = 1e-14  # a note has 15 of them
OURS = [
    "format/v10905.osim",
    "format/v20001.osim",
    "format/v20302.osim",
    "format/v30000.osim",
    "format/v30500.osim",
    "format/v30505.osim",
    "format/v30508.osim",
    "format/v30510.osim",
    "format/v30516.osim",
    "format/v30517.osim",
    "format/v40600.osim",
    "format/credits_some.osim",
    "scale_tool/generic_smooth.osim",
    "scale_tool/generic_hunt_crossley.osim",
    "format/credits_in_defaults.osim",
    "format/credits_semicolon.osim",
    "format/credits_lines.osim",
    "format/credits_comment_behind.osim",
    "format/credits_cdata.osim",
]
OTHERS = (
    "v40000_falisse_2022_human",
    "v40000_opencap_lai_arnold_crlf",
    "v30000_osim_rl_gait9dof18musc_crlf",
    "v20001_bouncing_ball_hunt_crossley",
    "v20302_dynamic_jumper",
)


def all_models():
    """Ours, and some of other people."""
    for name in OURS:
        yield pytest.param(models.FIXTURES / name, id=name)
    for name in OTHERS:
        path = Path(models.CORPUS or ".") / f"{name}.osim"
        yield pytest.param(path, id=name, marks=pytest.mark.skipif(not models.CORPUS, reason=models.NO_CORPUS))


def note_of(path):
    """The note in a model's credits, as text."""
    match = re.findall(r"\[contacts made for [^\]]*\]", path.read_text(encoding="utf-8", errors="replace"))
    assert len(match) == 1, f"{len(match)} notes in {path.name}"
    return match[0]


def contacts_mass(path):
    report = command.inspect(path).report
    return report["contacts_mass_kg"]["value"], report["contacts_mass_kg"]["source"]


@pytest.fixture(scope="module")
def walks(tmp_path_factory):
    """The rescaled copy of each model with the target, and that copy after each way through OpenSim."""
    folder = tmp_path_factory.mktemp("notes")
    done = {}
    jobs = []
    for param in all_models():
        (path,) = param.values
        if not path.exists():
            continue
        here = folder / path.parent.name / path.stem
        here.mkdir(parents=True)
        target = TIMES * command.inspect(path).report["mass_kg"]
        noted = here / "noted.osim"
        outcome = command.rescale(path, target, noted)
        assert outcome.status == 0, outcome
        done[path] = noted, target
        jobs += [(noted, here / f"{how}.osim", how) for how in WAYS]
    with ThreadPoolExecutor(WORKERS) as pool:
        list(pool.map(lambda job: save(*job), jobs))
    return done


@pytest.mark.parametrize("how", WAYS)
@pytest.mark.parametrize("path", all_models())
def test_what_contacts_were_made_for_is_known_afterwards(path, how, walks):
    noted, target = walks[path]
    saved = noted.with_name(f"{how}.osim")
    assert note_of(saved) == note_of(noted)
    assert contacts_mass(saved) == (pytest.approx(target, rel=DIGITS), "note")
    # Repeating the call changes nothing, even if OpenSim has scaled the bodies.
    second = noted.with_name(f"{how}_again.osim")
    outcome = command.rescale(saved, target, second)
    assert outcome.status == 0, outcome
    assert outcome.report["changes"] == [] and second.read_bytes() == saved.read_bytes()


@pytest.mark.parametrize("path", all_models())
def test_a_scaled_model_needs_no_contacts_mass(path, walks):
    noted, target = walks[path]
    scaled = noted.with_name("tool.osim")
    child = command.inspect(scaled).report["mass_kg"]
    outcome = command.rescale(scaled, child, noted.with_name("child.osim"))
    assert outcome.status == 0, outcome
    assert command.masses(outcome.report) == (pytest.approx(target, rel=DIGITS), child)
    assert 0.9 < child / (target / TIMES * FACTOR**3) < 1.1, "OpenSim has scaled the masses"


@pytest.mark.parametrize("path", all_models())
def test_a_hand_edit_after_the_note_makes_it_ask(path, walks):
    noted, target = walks[path]
    edited = noted.with_name("edited.osim")
    text = noted.with_name("save.osim").read_text(encoding="utf-8")
    edited.write_text(re.sub(r"<stiffness>([^<]+)<", lambda match: f"<stiffness>{2 * float(match[1])!r}<", text), encoding="utf-8")
    outcome = command.rescale(edited, 2 * target, noted.with_name("refused.osim"))
    assert outcome.status == 1 and outcome.error["code"] == "stale-note", outcome
    assert not noted.with_name("refused.osim").exists()


def test_what_is_written_down_survives_too(tmp_path):
    """`note` changes no number; OpenSim keeps it."""
    model = models.FIXTURES / "scale_tool" / "generic_smooth.osim"
    noted = tmp_path / "noted.osim"
    outcome = command.run("note", model, "--contacts-mass", "62", "-o", noted)
    assert outcome.status == 0 and outcome.report["changes"] == [], outcome
    for how in WAYS:
        saved = save(noted, tmp_path / f"{how}.osim", how)
        assert contacts_mass(saved) == (62.0, "note")
