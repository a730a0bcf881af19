"""Scale every model of a table, and write a table of what came of it.

    python3 table_of_masses.py masses.csv scaled

The table is a CSV file with the columns model, contacts_mass and target_mass. A model that fails does not stop
the others. The result goes to scaled/summary.csv.
"""

import csv
import sys
from pathlib import Path

from contact_scale import ModelError, UsageError, contact_scale


def scaled(row, folder):
    """One model: what came of it, as a row of the summary."""
    model, to = Path(row["model"]), row["target_mass"]
    output = folder / f"{model.stem}_{to}kg.osim"
    try:
        (done,) = contact_scale(
            model, "--contacts-mass", row["contacts_mass"], "--target-mass", to, "-o", output, "--force"
        )
    except (ModelError, UsageError) as problem:
        return {"model": model, "problem": problem}
    stiffness = [change for change in done["changes"] if change["property"] == "stiffness"]
    return {
        "model": model,
        "output": done["output"],
        "stiffness": stiffness[0]["to"] if stiffness else None,
        "equation": stiffness[0]["equation"] if stiffness else None,
        "warnings": " ".join(warning["code"] for warning in done["warnings"]),
    }


def main(table, folder):
    folder = Path(folder)
    folder.mkdir(exist_ok=True)
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = [scaled(row, folder) for row in csv.DictReader(file)]
    with open(folder / "summary.csv", "w", newline="", encoding="utf-8") as file:
        columns = ["model", "output", "stiffness", "equation", "warnings", "problem"]
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
    return any("problem" in row for row in rows)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
