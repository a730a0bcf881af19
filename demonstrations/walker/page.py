"""The tables of `docs/studies/walker.md`, made from the tables beside this program: `python demonstrations/walker/page.py` prints them."""

from pathlib import Path

import numpy as np
import pandas as pd
import success
from model import GRAVITY, LEG

HERE = Path(__file__).resolve().parent
CURVES = ("hip_r_rad", "knee_r_rad", "ankle_r_rad", "force_r_bw")
CLAIM = 3  # times the error of the mesh: smaller effects are not claimed


def read(name):
    """A table beside this program."""
    return pd.read_csv(HERE / f"{name}.csv")


def mesh_errors(table):
    """Objective at the mesh less that at twice the mesh, over the latter."""
    return table["effort"] / table["effort_at_double_mesh"] - 1


def mesh():
    """The walk at the mesh and at twice the mesh."""
    table = read("mesh")
    yield "|E₁\\* (MPa)|k̂|α (s/m)|effort|doubled|difference|largest force|doubled|step (s)|doubled|"
    yield "|---" * 10 + "|"
    for (_, row), error in zip(table.iterrows(), mesh_errors(table)):
        cells = [_mpa(row), f"{row['dimensionless_stiffness']:.2f}", f"{row['dissipation']:g}", f"{row['effort']:.4f}"]
        cells += [_effort(row, "_at_double_mesh", 4), f"{100 * error:+.2f} %"]
        names = (f"{name}{end}" for name in ("peak_force_bw", "half_cycle_s") for end in ("", "_at_double_mesh"))
        cells += [f"{row[name]:.3f}" for name in names]
        yield f"|{'|'.join(cells)}|"


def least():
    """The effort at each point of the grid: from the one good guess, or on the branch if that is more than 1 % less."""
    guess, branch = (read(name).assign(way=name).set_index(["stiffness", "dissipation"]) for name in ("grid", "branch"))
    branch = branch.loc[guess.index]
    cheaper = (branch["converged"] == 1) & ((guess["converged"] == 0) | (branch["effort"] < guess["effort"] / 1.01))
    table = guess.copy()
    table["dearer_effort"] = table["effort"].combine(branch["effort"], max)
    for name in ("effort", "way", "half_cycle_s", "cost_of_transport"):
        table[name] = table[name].where(~cheaper, branch[name])
    expected = [
        "index",
        "stiffness",
        "dissipation",
        "effort",
        "way",
        "half_cycle_s",
        "cost_of_transport",
        "dearer_effort",
    ]
    return table.reset_index()[expected]


def effort():
    """The table of panel A; in brackets the dearer search, where it is more than 1 % dearer."""
    yield from _grid(least(), _both)


def by_point(table):
    """A row for each point of the grid, about the searches from random guesses."""
    effort_by_index = least().set_index("index")["effort"]
    result = []
    for index, rows in table.groupby("index"):
        converged = rows[rows["converged"] == 1]
        point = {name: rows[name].iloc[0] for name in ("index", "stiffness", "dissipation")}
        point |= {"guesses": len(rows), "converged": len(converged), "median_iterations": rows["iterations"].median()}
        result.append(point | {"least_over_panel_a": converged["effort"].min() / effort_by_index[index]})
    return pd.DataFrame(result)


def sizes():
    """The table of one walk at three lengths."""
    table, curves = read("sizes"), read("sizes_curves")
    human = table[table["length"] == 1].iloc[0]
    yield "|length|mass (kg)|contacts|effort|difference|step / l|largest force|curves apart|iterations|"
    yield "|---|---|---|---|---|---|---|---|---|"
    for _, row in table.sort_values(["contacts", "length"], ascending=[False, True]).iterrows():
        length = row["length"]
        step = 1.2 * np.sqrt(length) * row["half_cycle_s"] / (LEG * length)
        cells = [f"{length:g}", f"{62 * length**3:.4g}", row["contacts"], _effort(row, "", 4)]
        cells += [f"{100 * (row['effort'] / human['effort'] - 1):+.2f} %", f"{step:.3f}", f"{row['peak_force_bw']:.2f}"]
        cells += [_apart(curves, row), str(int(row["iterations"]))]
        yield f"|{'|'.join(cells)}|"


def _effort(row, end, digits):
    """The effort, or that the search did not converge."""
    return f"{row[f'effort{end}']:.{digits}f}" if row[f"converged{end}"] else "not converged"


def _both(row):
    dearer = f" ({row['dearer_effort']:.3f})" if row["dearer_effort"] > 1.01 * row["effort"] else ""
    return f"{row['effort']:.3f}{'*' if row['way'] == 'branch' else ''}{dearer}"


def _mpa(row):
    return f"{row['stiffness'] / 1e6:.3f}"


def _grid(table, cell):
    """A table with a row for each stiffness and a column for each dissipation."""
    dissipations = sorted(table["dissipation"].unique())
    yield f"|E₁\\* (MPa), k̂|{'|'.join(f'α = {value:g}' for value in dissipations)}|"
    yield "|---" * (1 + len(dissipations)) + "|"
    for stiffness, rows in table.groupby("stiffness"):
        by_key = {row["dissipation"]: cell(row) for _, row in rows.iterrows()}
        hat = 9.375 * (stiffness / table["stiffness"].max()) ** (2 / 3)
        yield f"|{stiffness / 1e6:.3f}, {hat:.2f}|{'|'.join(by_key.get(value, '') for value in dissipations)}|"


def apart(curves, row):
    """How far the curves of a walk lie from those of the human, at equal times without dimensions.

    The largest difference of the joints' angles and of the force, each as a share of the human curve's range.
    """
    ours = curves[(curves["length"] == row["length"]) & (curves["contacts"] == row["contacts"])]
    human = curves[(curves["length"] == 1) & (curves["contacts"] == "rescaled")]
    times = [each["time_s"] / np.sqrt(LEG * each["length"] / GRAVITY) for each in (ours, human)]
    common = np.linspace(0, min(times[0].max(), times[1].max()), 400)
    shares = []
    for name in CURVES:
        one, other = (np.interp(common, time, each[name]) for time, each in zip(times, (ours, human)))
        shares.append(float(np.max(np.abs(one - other)) / np.ptp(human[name])))
    return max(shares)


def _apart(curves, row):
    share = apart(curves, row)
    return f"{share:.0e}" if share < 1e-3 else f"{100 * share:.1f} %"


BLOCKS = {
    "mesh": mesh,
    "effort": effort,
    "success": success.summary,
    "sizes": sizes,
    "ladder": success.summary_of_ladder,
}


def write(path):
    """Writes the tables into the page."""
    text = path.read_text(encoding="utf-8")
    for name, block in BLOCKS.items():
        begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
        before, after = text.split(begin)
        lines = "\n".join(block())
        text = f"{before}{begin}\n{lines}\n\n{end}{after.split(end)[1]}"
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    for block in BLOCKS.values():
        print("\n".join(block()), end="\n\n")
