"""Numbers that follow size, as a table: the same as the command's JSON."""

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, asked

FOLDER = FIXTURES / "follows_size"
GENERIC, SCALED = FOLDER / "generic.osim", FOLDER / "scaled.osim"


def test_check_lists_what_the_command_lists():
    setups = {"moco_setup": FOLDER / "scaled.omoco", "from_moco_setup": FOLDER / "generic.omoco"}
    similarity = ocs.check(SCALED, from_=GENERIC, **setups).similarity
    named = {name: str(path) for name, path in setups.items()}
    (record,) = asked(verb="check", models=[str(SCALED)], **{"from": str(GENERIC)}, **named)
    assert similarity[0] == record["similarity"] and len(similarity) == 1
    verdicts = {kind["kind"]: kind["verdict"] for kind in similarity[0]["kinds"]}
    assert verdicts["max_isometric_force"] == "left" and verdicts["optimal_fiber_length"] == "follows"
    assert "bound of time" in similarity._repr_html_() and repr(similarity).startswith("<Similarity")


def test_a_frame_has_a_row_for_each_kind():
    pytest.importorskip("pandas", reason="pandas is not installed")
    frame = ocs.check([SCALED, SCALED], from_=GENERIC).similarity.frame()
    assert len(frame) == 2 * frame["kind"].nunique() and frame["model"].nunique() == 1
    row = frame[frame["kind"] == "bushing_stiffness"].iloc[0]
    assert (row["count"], row["pairs"], row["factor_median"], row["verdict"]) == (3, 3, 1.0, "left")
    # M / L with the child's 20 of 62 kg.
    length = ocs.check(SCALED, from_=GENERIC).similarity[0]["length_ratio"]
    assert row["similarity_factor"] == pytest.approx(20 / 62 / length)


def test_a_mass_alone_and_nothing_at_all():
    similarity = ocs.inspect(GENERIC, target_mass=31).similarity
    (row,) = (kind for kind in similarity[0]["kinds"] if kind["kind"] == "max_isometric_force")
    assert row["similarity_factor"] == pytest.approx(0.5) and row["verdict"] is None
    assert len(ocs.check(SCALED).similarity) == 0 and "from_" in ocs.check(SCALED).similarity._repr_html_()
    assert ocs.check(SCALED).similarity == ocs.inspect(GENERIC).similarity
