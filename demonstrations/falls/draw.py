"""The figures of `docs/studies/falls.md`."""

import matplotlib
from animals import ANIMALS, CONTACTS, REFERENCE, time_unit_s
from compare import curve

matplotlib.use("svg")
from matplotlib import pyplot

COLOURS = dict(zip(ANIMALS, ("#000000", "#d55e00", "#e69f00", "#009e73", "#56b4e9", "#0072b2")))
LABELS = {
    "height": "lowest sphere / L",
    "centre_of_mass": "centre of mass / L",
    "force": "force / body weight",
}
# What is shown of each curve; a mouse that is thrown up leaves the picture.
LIMITS = {"height": (-0.06, 0.14), "centre_of_mass": (0.8, 1.15), "force": (-0.2, 10)}
UNTIL = 5  # units of √(L/g)


def draw(rows, folder):
    """Draws curves of all sizes for each law, with joints locked and free; each treatment of the contacts has a column."""
    folder.mkdir(parents=True, exist_ok=True)
    # Fixed ids and dates, so that equal results give equal bytes.
    matplotlib.rcParams.update({"svg.hashsalt": "falls", "font.size": 8, "path.simplify_threshold": 0.2})
    for law in [law for law in rows.table["law"].unique() if law != "smooth_frictionless"]:
        for joints in ("locked", "free"):
            figure = _figure(rows, law, joints)
            figure.savefig(folder / f"{law}_{joints}.svg", metadata={"Date": None})
            pyplot.close(figure)


def _figure(rows, law, joints):
    labels = {name: label for name, label in LABELS.items() if joints == "free" or name != "centre_of_mass"}
    size = (9, 2.1 * len(labels) + 0.4)
    figure, axes = pyplot.subplots(
        len(labels), len(CONTACTS), figsize=size, sharex=True, sharey="row", layout="constrained"
    )
    animals = [animal for animal in ANIMALS if animal in set(rows.table["animal"])]
    for column, contacts in zip(axes.T, CONTACTS):
        column[0].set_title(f"{contacts}: {CONTACTS[contacts]}", fontsize=8)
        column[-1].set_xlabel("t / √(L/g)")
        for animal in reversed(animals):
            series = _series(rows, law, joints, "rescaled" if animal == REFERENCE else contacts, animal)
            for axis, name in zip(column, labels):
                _plot(axis, series, name, animal)
    for row, (name, label) in zip(axes, labels.items()):
        row[0].set_ylabel(label)
        row[0].set_ylim(*LIMITS[name])
    axes[0][0].set_xlim(0, UNTIL)
    axes[0][-1].legend(fontsize=7, loc="upper right")
    return figure


def _series(rows, law, joints, contacts, animal):
    table = rows.table
    expected = {
        "law": law,
        "joints": joints,
        "contacts": contacts,
        "animal": animal,
        "accuracy": table["accuracy"].max(),
    }
    chosen = [all(row[name] == value for name, value in expected.items()) for row in table.to_dict("records")]
    return rows.series(chosen.index(True))


def _plot(axis, series, name, animal):
    is_reference = animal == REFERENCE
    axis.plot(
        series["time_s"] / time_unit_s(animal),
        curve(series, name, animal),
        "--" if is_reference else "-",
        color=COLOURS[animal],
        linewidth=1.6 if is_reference else 1.0,
        label=f"{animal.split('_')[0]} {ANIMALS[animal]:g} kg",
    )
