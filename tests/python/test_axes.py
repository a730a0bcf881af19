"""Figures drawn with matplotlib: all numbers of a figure are on the axes, with labels and units."""

import functools
import pickle

import osim_contact_scale as ocs
import pytest
from conftest import FIXTURES, HUMAN
from osim_contact_scale._axes import draw_panel

matplotlib = pytest.importorskip("matplotlib", reason="matplotlib is not installed")
matplotlib.use("Agg")
pyplot = pytest.importorskip("matplotlib.pyplot", reason="matplotlib is not installed")

MOTION = FIXTURES / "motion"
MESHES = {"geometry_dir": FIXTURES / "feet" / "Geometry"}
FEET = [FIXTURES / "drawn_feet" / f"{name}.osim" for name in ("six_spheres", "left_behind")]

#: A figure of every kind.
FIGURES = {
    "force": lambda: ocs.plot("force", HUMAN),
    "force of two": lambda: ocs.plot("force", "falisse2022", target_mass=1190),
    "force, x from to": lambda: ocs.plot("force", "falisse2022", x_range="-0.1..0.3", y_range="0..50"),
    "state": lambda: ocs.plot("state", HUMAN),
    "loop": lambda: ocs.plot("loop", "falisse2022"),
    "drop": lambda: ocs.plot("drop", HUMAN, "falisse2022"),
    "sweep of one": lambda: ocs.plot("sweep", "falisse2022", quantity="indentation"),
    "sweep of two": lambda: ocs.plot("sweep", "falisse2022", quantity="peak-force", stiffness="x0.1..x10/5", dissipation="0.5..2/4"),
    "sweep of restitution": lambda: ocs.plot("sweep", "falisse2022", quantity="restitution", stiffness="x0.1..x10/5", dissipation="0.1..2/6"),
    "table": lambda: ocs.plot("sweep", table=FIXTURES / "plots" / "walking_speeds.csv", value_column="walking_speed"),
    "feet": lambda: ocs.plot("feet", FEET[0], **MESHES),
    "feet before and after": lambda: ocs.plot("feet", *FEET, **MESHES),
    "fig4": lambda: ocs.plot("fig4"),
    "fig-c5": lambda: ocs.plot("fig-c5"),
    "motion": lambda: ocs.plot("motion", MOTION / "walker.osim", motion=MOTION / "walk.mot", plates=MOTION / "plates.sto"),
}  # fmt: skip


@functools.cache
def figure_of(kind):
    """The figure of a kind, which is made only once."""
    return FIGURES[kind]()


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def points_on(axes):
    """The number of points of all curves and marks on axes, without lines across a panel and legend entries."""
    return sum(len(line.get_xdata()) for line in axes.lines if line.get_linewidth() != 0.8)


@pytest.mark.parametrize("kind", FIGURES)
def test_every_kind_of_figure_is_drawn_completely(kind):
    figure = figure_of(kind)
    drawn = figure.plot()
    every = [drawn] if len(figure.panels) == 1 else list(drawn)
    assert len(every) == len(figure.panels)
    rows = figure._rows()[0]
    for name, axes in zip(figure.panels, every):
        selected = [row for row in rows if row["panel"] == name]
        assert (axes.get_xlabel(), axes.get_ylabel()) == (selected[0]["x_axis"], selected[0]["y_axis"])
        assert axes.get_title() == name
        assert points_on(axes) == sum(row["kind"] in ("curve", "point") for row in selected)
        assert len(axes.patches) == sum(row["kind"] == "sphere" for row in selected) + len(
            {row["name"] for row in selected if row["kind"] == "outline"}
        )
        named = {row["name"] for row in selected if row["kind"] in ("curve", "limit", "level") and row["name"]}
        legend = axes.get_legend()
        assert named <= {text.get_text() for text in legend.get_texts()} if named else True
    every[0].figure.canvas.draw()


def test_curves_of_one_name_are_not_joined():
    """Steps of one side over strides: each is a line of its own, in one look, with one entry in the legend."""
    axes = figure_of("motion").plot(panel="F")
    assert len(axes.lines) > 20 and all(len(line.get_xdata()) < 60 for line in axes.lines)


def test_one_panel_by_its_letter_or_name():
    figure = figure_of("fig4")
    assert figure.plot(panel="C").get_xlabel() == figure.plot(panel=figure.panels[2]).get_xlabel()
    assert figure.panels[2].startswith("C ")
    with pytest.raises(ocs.RequestError, match="panel='E': expected one of 'A α = 2 s/m for both'") as caught:
        figure.plot(panel="E")
    assert caught.value.keyword == "panel"


def test_axes_may_be_given():
    figure = figure_of("drop")
    _, axes = pyplot.subplots(2, 1)
    assert list(figure.plot(axes)) == list(axes) and axes[1].lines
    _, one = pyplot.subplots()
    assert figure_of("force").plot(one) is one and figure.plot(ax=one, panel="B") is one
    with pytest.raises(ocs.RequestError, match="1 axes for 2 panels"):
        figure.plot(one)


def test_scales_and_limits_are_those_of_the_picture():
    axes = figure_of("force, x from to").plot()
    assert axes.get_xlim() == (-0.1, 0.3) and axes.get_ylim() == (0, 50)
    assert figure_of("sweep of two").plot().get_xscale() == "log"
    assert figure_of("force").plot().get_xscale() == "linear"
    from_above = figure_of("feet").plot(panel="calcn_r, right, from above")
    assert from_above.yaxis_inverted() and from_above.get_aspect() == 1


def test_a_heat_map_has_its_values_and_a_bar():
    figure = figure_of("sweep of two")
    axes = figure.plot()
    (mesh,) = (one for one in axes.collections if hasattr(one, "get_coordinates"))
    assert mesh.get_array().size == 20
    assert "peak force / body weight (–)" in [one.get_ylabel() for one in axes.figure.axes]
    table = figure_of("table").plot()
    (mesh,) = (one for one in table.collections if hasattr(one, "get_coordinates"))
    # Three points have no value.
    assert mesh.get_array().mask.sum() == 3


def test_a_limit_of_a_heat_map_is_a_line_in_it_and_on_its_bar():
    panel = figure_of("sweep of two")._panels()[0]
    limit = {**panel.rows[-1], "kind": "limit", "name": "at most 2.5", "x": None, "y": None, "value": 2.5}
    _, axes = pyplot.subplots()
    draw_panel(panel._replace(rows=[*panel.rows, limit]), axes)
    assert "at most 2.5" in [text.get_text() for text in axes.get_legend().get_texts()]
    bar = axes.figure.axes[-1]
    assert [list(line.get_ydata()) for line in bar.lines] == [[2.5, 2.5]]


def test_names_from_outside_are_text():
    """No mathematics, no steering letters; an underscore does not keep a name out of the legend."""
    axes = ocs.plot("force", HUMAN, "falisse2022", label=["_a$x^2$b", "c$\\alpha$"]).plot()
    axes.figure.canvas.draw()
    texts = [text.get_text() for text in axes.get_legend().get_texts()]
    assert texts[:2] == [r" _a\$x^2\$b", r"c\$\alpha\$"]


def test_a_figure_that_was_sent_is_drawn_too():
    figure = pickle.loads(pickle.dumps(figure_of("drop")))
    assert len(figure.plot()) == 2 and figure.panels == ("A", "B")


def test_a_figure_is_saved_as_pdf(tmp_path):
    path = figure_of("force").save(tmp_path / "x.pdf")
    data = path.read_bytes()
    assert data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF") and b"/FontFile" in data
