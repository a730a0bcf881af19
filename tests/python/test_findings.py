"""Findings, answers and figures as values: compared, kept in sets, cut, sent to other processes, shown."""

import os
import pickle
import shutil

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN
from osim_contact_scale._html import html_table

#: A model whose contacts sink in too deep, for which there is a remedy.
DEEP = FIXTURES / "check" / "sunk_in.osim"


def test_findings_are_values():
    findings = ocs.check(HUMAN).findings
    assert len(findings) > 2 and len({*findings, *ocs.check(HUMAN).findings}) == len(findings)
    back = pickle.loads(pickle.dumps(findings))
    assert back == findings and hash(back) == hash(findings) and type(back) is ocs.Findings


def test_a_part_of_findings_shows_itself_as_a_table():
    findings = ocs.check(HUMAN).findings
    assert type(findings[:2]) is ocs.Findings and type(findings[0]) is ocs.Finding
    assert findings[:2]._repr_html_().count("<tr>") == 3 and len(findings[:2].table) == 2
    assert findings[-1] in findings


@pytest.mark.parametrize("look", [ocs.check, ocs.inspect])
def test_a_survey_of_a_live_model_can_be_sent(look):
    opensim = pytest.importorskip("opensim", reason="opensim is not installed")
    survey = look(opensim.Model(str(DEEP)))
    back = pickle.loads(pickle.dumps(survey))
    assert back.records == survey.records
    if look is ocs.check:
        assert back.findings == survey.findings
        remedy = next(finding.remedy for finding in back.findings if finding.remedy)
        assert len(remedy.apply().changes) > 0


def test_a_survey_of_bytes_can_be_sent():
    check = ocs.check(DEEP.read_bytes())
    remedy = next(finding.remedy for finding in pickle.loads(pickle.dumps(check)).findings if finding.remedy)
    assert len(remedy.apply().changes) > 0


def test_a_figure_can_be_sent():
    figure = ocs.plot("drop", HUMAN)
    back = pickle.loads(pickle.dumps(figure))
    assert (back.svg, back.remarks, back.to_png()) == (figure.svg, figure.remarks, figure.to_png())
    assert back.to_pdf().startswith(b"%PDF") and back.data.equals(figure.data)
    assert pickle.loads(pickle.dumps(back)).svg == figure.svg


def test_each_topic_has_its_explanation():
    equation, finding = ocs.explain("13", "beyond-hertz")
    assert str(equation) == str(ocs.explain("13")[0]) and str(finding) == str(ocs.explain("beyond-hertz")[0])
    assert "beyond-hertz" not in str(equation) and str(finding).startswith("beyond-hertz")
    # One topic in two words.
    assert [str(one) for one in ocs.explain("eq", "13")] == [str(equation)]
    with pytest.raises(ocs.RequestError, match="nothing-such"):
        ocs.explain("13", "nothing-such")


def test_all_that_there_is_has_a_text_each():
    explained = ocs.explain()
    assert len(explained) > 100
    # A finding and an error of the same name share theirs.
    assert len({str(one) for one in explained}) > 0.95 * len(explained)


def test_texts_from_outside_steer_nothing_in_a_notebook():
    shown = html_table(["a"], [["\x1b[31m\u202eheel<b>\x00"], [None]])
    assert not any(letter in shown for letter in "\x1b\u202e\x00") and "heel&lt;b&gt;" in shown


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such names of files")
def test_names_of_files_steer_nothing_in_a_notebook(tmp_path):
    path = shutil.copy(HUMAN, tmp_path / "a\x1b[31m.osim")
    for survey in (ocs.check(path), ocs.inspect(path)):
        assert "\x1b" not in survey._repr_html_() and "[31m.osim" in survey._repr_html_()
    assert "\x1b" not in ocs.check(path).findings._repr_html_()


def test_models_may_come_from_any_iterable(tmp_path):
    folder = FIXTURES / "table1"
    expected = sorted(folder.glob("*.osim"))
    assert len(ocs.inspect(folder.glob("*.osim"))) == len(expected) > 10
    assert len(ocs.check(path for path in expected[:3])) == 3
    pd = pytest.importorskip("pandas", reason="pandas is not installed")
    frame = pd.DataFrame({"model": expected[:2]})
    assert [record["model"] for record in ocs.inspect(frame["model"])] == [str(path) for path in expected[:2]]
    with pytest.raises(TypeError, match=r'expected models, not a DataFrame.*table\["model"\]'):
        ocs.inspect(frame)
    results = ocs.many("rescale", frame["model"], target_mass=80, dry_run=True)
    assert len(results) == 2


def test_a_remedy_is_for_the_model_that_was_checked(human, tmp_path, monkeypatch):
    human.write_bytes(DEEP.read_bytes())
    monkeypatch.chdir(human.parent)
    finding = next(finding for finding in ocs.check(human.name).findings if finding.remedy)
    assert len(finding.remedy.apply().changes) > 0
    (tmp_path / "elsewhere").mkdir()
    # Another model of the same name.
    (tmp_path / "elsewhere" / human.name).write_bytes(human.read_bytes())
    monkeypatch.chdir(tmp_path / "elsewhere")
    with pytest.raises(ocs.RequestError, match=r"was named in the folder .* no longer the current one"):
        finding.remedy.apply()
    assert len(finding.remedy.apply(human).changes) > 0
