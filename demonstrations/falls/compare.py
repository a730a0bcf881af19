"""How far falls lie apart, once lengths are divided by L, forces by body weight and times by √(L/g)."""

import csv

import numpy as np
from animals import ANIMALS, REFERENCE, length_m, time_unit_s

CURVES = {"height": "height_m", "force": "force_bw", "centre_of_mass": "com_height_m"}
COLUMNS = (
    "law",
    "joints",
    "contacts",
    "animal",
    "mass_kg",
    "hip_height_m",
    "sphere_radius_m",
    "peak_force_bw",
    "peak_time_over_time_unit",
    "final_indentation_over_hip_height",
    *(f"{name}_apart" for name in CURVES),
    *(f"{name}_integrator" for name in CURVES),
)

# Of slides: what is measured, and how far it is off from what the reference has, as a share of that.
MEASURES = ("slide_over_hip_height", "along_bw", "up_bw")
SLIDES = ("law", "motion", "contacts", "animal", "mass_kg", *MEASURES, *(f"{name}_off" for name in MEASURES))


def curve(series, name, animal):
    """A dimensionless curve of a fall; None if the fall has no such curve."""
    if CURVES[name] not in series:
        return None
    values = np.asarray(series[CURVES[name]], dtype=float)
    return values if name == "force" else values / length_m(animal)


def apart(ours, theirs):
    """The largest difference of two curves, as a share of the second one's range."""
    if ours is None or theirs is None:
        return None
    return float(np.max(np.abs(ours - theirs)) / np.ptp(theirs))


def compared(done):
    """Rows of the table: each fall against that of the reference, and against itself with a stricter integrator."""
    table = done.table
    falls = {}
    for place, row in enumerate(table.to_dict("records")):
        key = (row["law"], row["joints"], row["contacts"], row["animal"])
        falls.setdefault(key, []).append((row, done.series(place)))
    rows = []
    for (law, joints, contacts, animal), runs in falls.items():
        runs.sort(key=lambda run: -run[0]["accuracy"])
        row, series = runs[0]
        _, reference = falls[law, joints, "rescaled", REFERENCE][0]
        result = {
            "law": law,
            "joints": joints,
            "contacts": contacts,
            "animal": animal,
            "mass_kg": ANIMALS[animal],
            "hip_height_m": length_m(animal),
            "sphere_radius_m": row["reference_radius_m"],
            "peak_force_bw": row["peak_force_bw"],
            "peak_time_over_time_unit": row["peak_time_s"] / time_unit_s(animal),
            "final_indentation_over_hip_height": -series["height_m"].iloc[-1] / length_m(animal),
        }
        for name in CURVES:
            ours = curve(series, name, animal)
            result[f"{name}_apart"] = apart(ours, curve(reference, name, REFERENCE))
            stricter = curve(runs[1][1], name, animal) if len(runs) > 1 else None
            result[f"{name}_integrator"] = apart(ours, stricter)
        rows.append(result)
    return rows


def slides_compared(done):
    """Rows of the table of slides: each against the same motion of the reference."""
    rows = done.table.to_dict("records")
    reference = {(row["law"], row["motion"]): row for row in rows if row["animal"] == REFERENCE}
    for row in rows:
        theirs = reference[row["law"], row["motion"]]
        row["mass_kg"] = ANIMALS[row["animal"]]
        row.update({f"{name}_off": row[name] / theirs[name] - 1 for name in MEASURES})
    return rows


def write_table(path, rows, columns):
    """Writes a CSV table with six digits; missing values are empty cells."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: _text(row[name]) for name in columns})


def _text(value):
    if value is None:
        return ""
    return f"{value:.6g}" if isinstance(value, float) else value
