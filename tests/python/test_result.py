"""Results of planned changes: their texts, their files, their pickles, and refusals."""

import os
import pickle
import re
import shutil

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, asked


def test_nothing_is_written_before_write(human):
    result = ocs.rescale(human, target_mass=500)
    assert sorted(path.name for path in human.parent.iterdir()) == ["human.osim"]
    assert result.write() == [human.with_name("human.scaled.osim")]
    with pytest.raises(ocs.OutputError, match="force=True"):
        result.write()
    assert result.write(force=True) == [human.with_name("human.scaled.osim")]


def test_a_model_is_changed_itself_with_a_backup(human):
    before = human.read_bytes()
    result = ocs.rescale(str(human), target_mass=500)
    result.write(in_place=True)
    assert human.read_bytes() == result.to_bytes() != before
    assert human.with_name("human.osim.bak").read_bytes() == before


def test_a_model_that_changed_since_it_was_planned_is_not_changed(human):
    result = ocs.rescale(human, target_mass=500)
    human.write_bytes(human.read_bytes().replace(b"<gravity>", b"<!-- saved again --><gravity>"))
    saved = human.read_bytes()
    with pytest.raises(ocs.OutputError, match="plan again"):
        result.write(in_place=True)
    assert human.read_bytes() == saved


def test_a_factor_is_not_applied_twice(human):
    ocs.set(human, stiffness="x2", contacts_mass=62).write(in_place=True)
    second = ocs.set(human, stiffness="x2")
    with pytest.raises(ocs.ContactScaleError):
        second.write(in_place=True)
    second.write(human.with_name("twice.osim"))


def test_bytes_and_results_are_models_too(human):
    from_path = ocs.rescale(human, target_mass=500)
    from_bytes = ocs.rescale(human.read_bytes(), target_mass=500)
    assert from_path.to_bytes() == from_bytes.to_bytes()
    assert from_bytes.path == "model.osim"
    # The result of a change is a model for the next one.
    chained = ocs.set(from_path, dissipation=1.5)
    from_path.write(human.with_name("first.osim"))
    assert chained.to_bytes() == ocs.set(human.with_name("first.osim"), dissipation=1.5).to_bytes()
    assert ocs.inspect(from_path)[0]["contacts_mass_kg"]["value"] == 500
    assert ocs.check(from_path).models is not None


def test_a_result_and_its_model_have_different_names(human):
    """A result has the name of its model: read by name alone, a model would be compared with itself."""
    # By (8) with isometric radii: 1190 / 62 of the mass.
    larger, new = ocs.rescale(human, target_mass=1190), 0.032 * (1190 / 62) ** (1 / 3)
    for sources, radii in (
        ([human, larger], [0.032, new]),
        ([larger, human], [new, 0.032]),
        ([larger, human.parent], [new, 0.032]),
    ):
        result = [record["spheres"][0]["radius_m"] for record in ocs.inspect(sources)]
        assert result == pytest.approx(radii, rel=1e-14)
    # Two names are refused where there is one curve.
    assert "old" in ocs.plot("force", human, larger, axes="real", label=["old", "new"]).svg
    assert ocs.transfer(larger, from_=human, mass=1190).record["contacts_mass_kg"]["value"] == 62


def test_other_models_of_a_call_may_be_in_memory():
    path = FIXTURES / "scale_tool" / "scaled_smooth.osim"
    generic = FIXTURES / "scale_tool" / "generic_smooth.osim"
    places = ocs.transfer(path, from_=generic, follow_bodies=True).moves
    levelled = ocs.transfer(path, from_=generic, follow_bodies=True, level=True).moves
    for other in (generic.read_bytes(), ocs.note(generic, contacts_mass=62)):
        assert "spheres-left-behind" in {finding.code for finding in ocs.check(path, from_=other).findings}
        assert str(ocs.transfer(path, from_=other, follow_bodies=True).moves) == str(places)
        remedy = ocs.check(path, from_=other).findings[0].remedy
        assert str(remedy.apply().moves) == str(levelled)
        assert ocs.drop_test(path, compare=other).record["model"] == str(path)


def test_results_travel_without_their_files(human, tmp_path):
    reference = shutil.copy(FIXTURES / "table1" / "horse_hunt_crossley.osim", tmp_path / "horse.osim")
    result = ocs.transfer(human, from_=reference)
    there = pickle.dumps(result)
    human.unlink()
    (tmp_path / "horse.osim").unlink()
    back = pickle.loads(there)
    assert back.to_bytes() == result.to_bytes()
    assert back.record == result.record
    assert back.write(tmp_path / "new.osim") == [tmp_path / "new.osim"]


def test_a_result_that_travelled_is_not_written_beside_another_model(human, tmp_path, monkeypatch):
    monkeypatch.chdir(human.parent)
    there = pickle.dumps(ocs.rescale(human.name, target_mass=500))
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    back = pickle.loads(there)
    with pytest.raises(ocs.RequestError, match="was named in the folder"):
        back.write()
    assert back.write(tmp_path / "new.osim") == [tmp_path / "new.osim"]


@pytest.mark.parametrize(
    "make",
    [
        lambda path: ocs.set(path, stiffness="x2", dissipation=1.5),
        lambda path: ocs.transfer(path, from_="falisse2022", spheres=6),
    ],
)
def test_the_call_on_a_page_can_be_made(human, make):
    result = make(human)
    second = eval(result._call(), {"ocs": ocs})
    assert second.to_bytes() == result.to_bytes() and str(human) in result._call()


def test_a_model_of_bytes_has_no_file_yet(human, tmp_path, monkeypatch):
    (tmp_path / "empty").mkdir()
    monkeypatch.chdir(tmp_path / "empty")
    result = ocs.rescale(human.read_bytes(), target_mass=500)
    with pytest.raises(ocs.OutputError, match=r"came from memory, and has no file .*output="):
        result.write(in_place=True)
    with pytest.raises(ocs.OutputError, match=r"came from memory, and has no file yet: .*output="):
        result.write()
    assert [path.name for path in result.write("model.osim")] == ["model.osim"]
    with pytest.raises(ocs.OutputError):
        result.write("model.osim")


def test_a_model_in_memory_is_not_its_file(human):
    before = human.read_bytes()
    chained = ocs.design(ocs.rescale(human, target_mass=50), indentation=0.16)
    with pytest.raises(
        ocs.OutputError, match=r"planned for a model in memory, and .* holds another one: write a new file"
    ):
        chained.write(in_place=True)
    assert human.read_bytes() == before


def test_a_standalone_set_and_its_geometry(tmp_path):
    for name in ("standalone_ForceSet.xml", "standalone_ContactGeometrySet.xml"):
        shutil.copy(FIXTURES / "format" / name, tmp_path / name)
    result = ocs.design(
        tmp_path / "standalone_ForceSet.xml", geometry=tmp_path / "standalone_ContactGeometrySet.xml",
        mass=61.5, spheres=1, gravity=9.81, indentation=0.16, radius=0.04,
    )  # fmt: skip
    assert len(result.files) == 2
    written = result.write(output_dir=tmp_path / "new")
    assert [path.read_bytes() for path in written] == list(result.files.values())


def test_findings_have_remedies_that_can_be_applied():
    model = FIXTURES / "check" / "sunk_in.osim"
    (record,) = asked(verb="check", models=[str(model)])
    check = ocs.check(model)
    assert [finding.code for finding in check.findings] == [finding["code"] for finding in record["findings"]]
    finding = next(finding for finding in check.findings if finding.code == "sunk-in")
    fixed = finding.remedy.apply()
    assert "sunk-in" in {finding.code for finding in fixed.findings_before}
    assert "sunk-in" not in {finding.code for finding in (*fixed.findings, *fixed.findings_after)}
    # The call that it shows is the same as what it does.
    second = eval(finding.remedy.call, {"ocs": ocs})
    assert second.to_bytes() == fixed.to_bytes()
    # Applied to a result, it builds on it.
    result = ocs.rescale(model, target_mass=90)
    more = next(finding for finding in result.findings_after if finding.code == "sunk-in").remedy.apply()
    assert more.record["model"] == result.path and more.to_bytes() != fixed.to_bytes()


def test_what_a_notebook_shows(human):
    result = ocs.rescale(human, target_mass=500)
    page = result._repr_html_()
    # The rows of the text: each way in which a number changes once, beside how many do.
    assert "<td>radius</td><td>12</td><td>0.032</td>" in page and "beyond-hertz" in page
    assert "<td>standing</td>" in page and "<script" not in page + result.html()
    assert "<table>" in ocs.check(human)._repr_html_() and "<table>" in ocs.inspect(human)._repr_html_()
    assert "beyond-hertz" in ocs.check(human).findings._repr_html_()
    assert ocs.plot("force", human)._repr_svg_().startswith("<svg")
    # The name of (13), in words.
    assert "Coefficient of restitution" in ocs.explain("13")[0]._repr_html_()


def test_texts_from_outside_are_escaped(human):
    name = "<img src=x onerror=alert(1)>"
    model = human.read_bytes().replace(b'name="contact_s1_r"', f'name="{name}"'.replace("<", "&lt;").encode())
    page = ocs.rescale(model, target_mass=500)._repr_html_()
    assert "<img" not in page and "<img" not in ocs.check(model)._repr_html_()


def test_a_report_is_a_file_of_its_own(human, tmp_path):
    page = ocs.rescale(human, target_mass=500).report(tmp_path / "report.html")
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    with pytest.raises(ocs.OutputError):
        ocs.rescale(human, target_mass=500).report(page)
    assert len(ocs.check(human, report=tmp_path / "check.html")) == 1
    assert (tmp_path / "check.html").stat().st_size > 10_000


FORCES = FIXTURES / "format" / "standalone_ForceSet.xml"
SPHERES = FIXTURES / "format" / "standalone_ContactGeometrySet.xml"
MASSES = {"target_mass": 70, "contacts_mass": 62}


def radii(result):
    return {change["from"] for change in result.record["changes"] if change["property"] == "radius"}


def test_files_beside_a_model_are_those_that_were_given(tmp_path, monkeypatch):
    """Bytes are read, and no file of the disk that has the same name."""
    (number,) = {float(text) for text in re.findall(r"<radius>(.*?)</radius>", SPHERES.read_text(encoding="utf-8"))}
    other = SPHERES.read_bytes().replace(str(number).encode(), b"0.05")
    assert radii(ocs.rescale(FORCES, geometry=SPHERES, **MASSES)) == {number}
    monkeypatch.chdir(tmp_path)
    for name in ("model.osim", SPHERES.name):
        (tmp_path / name).write_bytes(SPHERES.read_bytes())
        assert radii(ocs.rescale(FORCES, geometry=other, **MASSES)) == {0.05}
        assert {sphere["radius_m"] for sphere in ocs.inspect(FORCES, geometry=other)[0]["spheres"]} == {0.05}


def test_a_force_set_keeps_its_new_spheres(tmp_path):
    """The next change of a result sees what is in the files when they are written."""
    forces, spheres = shutil.copy(FORCES, tmp_path / "forces.xml"), shutil.copy(SPHERES, tmp_path / "spheres.xml")
    first = ocs.rescale(forces, geometry=spheres, target_mass=500, contacts_mass=62, yes="implausible-mass")
    first.write(tmp_path / "new.xml", geometry_output=tmp_path / "new_spheres.xml")
    question = {"indentation": 0.1, "spheres": 1, "mass": 500}
    from_files = ocs.design(tmp_path / "new.xml", geometry=tmp_path / "new_spheres.xml", **question)
    for chained in (ocs.design(first, **question), ocs.design(first, geometry=spheres, **question)):
        assert chained.to_bytes() == from_files.to_bytes()
    (record,) = ocs.inspect(first)
    assert record["forces"] == ocs.inspect(tmp_path / "new.xml", geometry=tmp_path / "new_spheres.xml")[0]["forces"]


def test_remedies_of_the_model_as_it_was(human):
    human.write_bytes((FIXTURES / "check" / "sunk_in.osim").read_bytes())
    result = ocs.rescale(human, target_mass=62.5)
    (remedy, *_) = [finding.remedy for finding in result.findings_before if finding.remedy]
    (same, *_) = [finding.remedy for finding in ocs.check(human).findings if finding.remedy]
    assert remedy.apply().to_bytes() == same.apply().to_bytes()


def test_another_current_folder(human, tmp_path, monkeypatch):
    """A file is never written beside another one that has the same name."""
    monkeypatch.chdir(human.parent)
    result = ocs.rescale(human.name, target_mass=500)
    (tmp_path / "elsewhere").mkdir()
    monkeypatch.chdir(tmp_path / "elsewhere")
    for output in ({}, {"output": "here.osim"}, {"in_place": True}):
        with pytest.raises(ocs.RequestError, match="no longer the current one"):
            result.write(**output)
    assert result.write(tmp_path / "whole.osim") == [tmp_path / "whole.osim"]
    monkeypatch.chdir(human.parent)
    assert [path.name for path in result.write()] == ["human.scaled.osim"]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such names of files")
def test_names_of_files_cannot_command_a_terminal(human, caplog):
    name = human.with_name("a\x1b[31m\n.osim")
    human.rename(name)
    result = ocs.rescale(name, target_mass=500)
    with caplog.at_level("INFO"):
        result.write()
    assert not any(sign in repr(result) + caplog.text.replace("\n", "") for sign in "\x1b\n")
    assert r"a\u{1b}[31m\n.osim" in repr(result)
