"""Every verb over fixtures and corpus: what Python has equals what the command prints and writes, bit for bit."""

import math

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN, asked, corpus, fixtures, kind_of, name_of, needs_corpus, unspelled

MODELS = [path for path in fixtures() if kind_of(path) != "bad"]

# Each changing verb, as Python and the command are asked.
CHANGES = {
    "rescale": {"target_mass": 500.5, "friction": True},
    "transfer": {"from": "falisse2022", "spheres": 6},
    "set": {"set": {"stiffness": "x1.1", "dissipation": 1.25}},
    "design": {"indentation": 0.13, "constant_indentation": 0.05},
    "note": {"contacts_mass": 61.9},
    "convert": {"to": "hunt-crossley"},
    "remove": {},
}


def call(verb, fields, path):
    """The plan of a function of the package."""
    fields = dict(fields)
    if verb == "set":
        return ocs.set(path, **fields["set"])
    if "from" in fields:
        fields["from_"] = fields.pop("from")
    return getattr(ocs, verb.replace("-", "_"))(path, **fields)


def bits(record):
    """Numbers by their bits, so that -0.0 and 0.0 differ and no tolerance hides anything."""
    if isinstance(record, dict):
        return {key: bits(value) for key, value in record.items()}
    if isinstance(record, list):
        return [bits(item) for item in record]
    if isinstance(record, float):
        # JSON has no number that is not finite, and says null. Python has.
        return record.hex() if math.isfinite(record) else None
    return record


def check_change(verb, path, tmp_path):
    fields = CHANGES[verb]
    (record,) = asked(verb=verb, models=[path], dry_run=True, **fields)
    if "error" in record:
        with pytest.raises(ocs.ContactScaleError) as caught:
            call(verb, fields, path)
        error = caught.value
        assert (error.code, error.line, error.column) == tuple(
            record["error"][key] for key in ("code", "line", "column")
        )
        return False
    result = call(verb, fields, path)
    assert bits(unspelled(result.record)) == bits(unspelled(record))
    output = tmp_path / "of_command.osim"
    if not record["changes"] and not record["objects"] and verb != "note":
        assert result.to_bytes() == path.read_bytes()
        return True
    (written,) = asked(verb=verb, models=[path], output=output, **fields)
    if "error" in written:  # It includes files that are not where it would be written.
        with pytest.raises(ocs.ContactScaleError):
            result.write(tmp_path / "of_python.osim")
        return True
    assert result.to_bytes() == output.read_bytes()
    assert result.write(tmp_path / "of_python.osim") == [tmp_path / "of_python.osim"]
    assert (tmp_path / "of_python.osim").read_bytes() == output.read_bytes()
    return True


@pytest.mark.parametrize("path", MODELS, ids=name_of)
def test_changes_of_a_fixture(path, tmp_path):
    for verb in CHANGES:
        folder = tmp_path / verb
        folder.mkdir()
        check_change(verb, path, folder)


@needs_corpus
@pytest.mark.parametrize("path", corpus(), ids=name_of)
def test_changes_of_a_model_by_other_people(path, tmp_path):
    done = []
    for verb in CHANGES:
        folder = tmp_path / verb
        folder.mkdir()
        done.append(check_change(verb, path, folder))
    assert any(done) or "no_contacts" in path.name or not ocs.inspect(path)[0]["forces"]


@needs_corpus
def test_add_to_every_model_without_contacts(tmp_path):
    count = 0
    for path in fixtures() + corpus():
        (record,) = asked(verb="add", models=[path], **{"from": "falisse2022"}, dry_run=True)
        if "error" in record:
            with pytest.raises(ocs.ContactScaleError) as caught:
                ocs.add(path, from_="falisse2022")
            assert caught.value.code == record["error"]["code"]
            continue
        count += 1
        result = ocs.add(path, from_="falisse2022")
        assert bits(unspelled(result.record)) == bits(unspelled(record))
        output = tmp_path / f"{count}.osim"
        (written,) = asked(verb="add", models=[path], output=output, **{"from": "falisse2022"})
        if "error" not in written:
            assert result.to_bytes() == output.read_bytes()
    assert count > 2


@pytest.mark.parametrize("path", fixtures() + corpus(), ids=name_of)
def test_inspect_and_check(path):
    for verb in ("inspect", "check"):
        (record,) = asked(verb=verb, models=[path])
        if "error" in record:
            with pytest.raises(ocs.ContactScaleError) as caught:
                getattr(ocs, verb)(path)
            assert caught.value.code == record["error"]["code"]
        else:
            assert bits(unspelled(getattr(ocs, verb)(path)[0])) == bits(unspelled(record))


def test_drop_tests():
    for subject in (HUMAN, "falisse2022", *sorted((FIXTURES / "table1").glob("*.osim"))[:6]):
        (record,) = asked(verb="drop-test", subject=subject, height="x0.3", samples=101)
        drop = ocs.drop_test(subject, height="x0.3", samples=101)
        assert bits(unspelled(drop.record)) == bits(unspelled(record))
        assert list(drop.series["force_n"]) == record["series"]["force_n"]


def test_fits():
    path = FIXTURES / "measured" / "heel_pad_european.csv"
    fields = {
        "radius": 0.01, "indentation_column": "Eindringtiefe", "indentation_unit": "mm",
        "force_column": "Kraft", "force_unit": "kN", "time_column": "Zeit",
    }  # fmt: skip
    (record,) = asked(verb="fit", file=path, **fields)
    assert bits(unspelled(ocs.fit(path, **fields).record)) == bits(unspelled(record))


def test_the_calculator_presets_and_table_1():
    fields = {"mass": 62, "spheres": 6, "radius": 0.032, "indentation": 0.16}
    assert bits(unspelled(ocs.design(**fields).record)) == bits(unspelled(asked(verb="design", **fields)[0]))
    assert [bits(unspelled(preset.record)) for preset in ocs.presets()] == bits(unspelled(asked(verb="presets")))
    own, theirs = ocs.reproduce().record, asked(verb="reproduce")[0]
    # What is said of Fig. 1 names calls.
    assert len(own.pop("fig1")) == len(theirs.pop("fig1"))
    assert bits(own) == bits(theirs)
    assert [unspelled(topic.record) for topic in ocs.explain("C.5")] == unspelled(asked(verb="explain", topics=["C.5"]))


def test_cells_of_data_frames_are_the_numbers_of_the_json():
    pd = pytest.importorskip("pandas", reason="pandas is not installed: tables are lists of dictionaries")
    (record,) = asked(verb="rescale", models=[HUMAN], target_mass=500.5, dry_run=True)
    changes = ocs.rescale(HUMAN, target_mass=500.5).changes
    assert isinstance(changes, pd.DataFrame) and changes["new"].dtype == changes["factor"].dtype == "float64"
    assert list(changes["new"]) == [change["to"] for change in record["changes"]]
    (record,) = asked(verb="inspect", models=[HUMAN])
    inspection = ocs.inspect(HUMAN)
    assert list(inspection.forces["stiffness"]) == [force["parameters"]["stiffness"] for force in record["forces"]]
    spheres = [sphere for limb in record["figures"]["limbs"] for sphere in limb["spheres"]]
    own = inspection.spheres.set_index("path")["relative_indentation_hertz"]
    assert {sphere["path"]: sphere["relative_indentation_hertz"] for sphere in spheres} == own.to_dict()


@pytest.mark.parametrize("kind", ["force", "state", "loop", "drop", "sweep", "feet"])
def test_figures(kind, tmp_path):
    import subprocess

    from conftest import program

    figure = ocs.plot(kind, HUMAN)
    for ending in ("svg", "png", "pdf", "csv"):
        own, theirs = tmp_path / f"own.{ending}", tmp_path / f"theirs.{ending}"
        figure.save(own)
        output = ["-o", tmp_path / "other.svg", "--data", theirs] if ending == "csv" else ["-o", theirs]
        subprocess.run([program(), "plot", kind, HUMAN, *output, "--force"], check=True, capture_output=True)
        assert own.read_bytes() == theirs.read_bytes(), ending
