"""Write the data of ten_subjects.ipynb: a generic model, a table of ten subjects, and what the real OpenSim makes of them.

Run it as `python docs/notebooks/make_subjects.py` with OpenSim 4.6 installed. `generic.osim` is the human of 62 kg of
fixtures/scale_tool; `subjects/*.osim` are written by OpenSim's Scale Tool, untouched: their bodies have the size and the mass of
each subject, their contacts are those of the generic model. The subjects are made up, and no data of anybody: plausible statures,
foot lengths and masses.
"""

import csv
import os
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
FIXTURES = HERE.parent.parent / "fixtures"
sys.path[:0] = [str(FIXTURES), str(FIXTURES / "scale_tool")]

import make_scale_tool as tool  # noqa: E402
import model_text as text  # noqa: E402

# The generic model, as if somebody had measured it.
GENERIC_KG, STATURE_M, FOOT_M = 62.0, 1.70, 0.255

# subject, group, mass [kg], stature [m], length of the foot [m]
SUBJECTS = (
    ("S01", "adult", 71.4, 1.78, 0.268),
    ("S02", "adult", 58.2, 1.64, 0.241),
    ("S03", "adult", 84.9, 1.86, 0.285),
    ("S04", "adult", 66.0, 1.71, 0.252),
    ("S05", "adult", 93.5, 1.80, 0.276),
    ("S06", "adult", 52.7, 1.59, 0.233),
    ("S07", "child", 31.6, 1.35, 0.212),
    ("S08", "child", 38.3, 1.46, 0.227),
    ("S09", "child", 44.8, 1.55, 0.240),
    ("S10", "child", 35.1, 1.41, 0.218),
)


def factors(mass, stature, foot):
    """Scale factors by body, x forward, y up, z to the right: lengths by stature, girths by what is left of the mass."""
    length = stature / STATURE_M
    girth = (mass / GENERIC_KG / length) ** 0.5
    trunk = tuple(round(factor, 3) for factor in (girth, length, girth))
    whole = tuple(round(factor, 3) for factor in (foot / FOOT_M, length, (foot / FOOT_M * girth) ** 0.5))
    return {"pelvis": trunk, "femur": trunk, "tibia": trunk, "calcn": whole, "toes": whole}


def scaled(folder, subject, mass, stature, foot):
    """What the Scale Tool makes of the generic model."""
    import opensim

    tool.FACTORS, tool.MASS = factors(mass, stature, foot), mass
    document = text.document(tool.setup("generic.osim", "scaled.osim", "scale_set.xml")).replace("human_52kg", subject)
    (folder / "setup.xml").write_text(document, encoding="utf-8", newline="\n")
    # Its `run` gives False when no markers are placed, whatever else it did: what counts is the file.
    opensim.ScaleTool(str(folder / "setup.xml")).run()
    return (folder / "scaled.osim").read_bytes()


def main():
    """Everything."""
    import opensim

    opensim.Logger.removeFileSink()
    opensim.Logger.setLevelString("Error")
    generic = text.document(tool.smooth())
    (HERE / "generic.osim").write_text(generic, encoding="utf-8", newline="\n")
    (HERE / "subjects").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        os.chdir(name)  # OpenSim leaves log files where it runs
        (Path(name) / "generic.osim").write_text(generic, encoding="utf-8", newline="\n")
        for subject, _, *measures in SUBJECTS:
            (HERE / "subjects" / f"{subject}.osim").write_bytes(scaled(Path(name), subject, *measures))
    with open(HERE / "subjects.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["subject", "group", "mass_kg", "stature_m", "foot_m"])
        writer.writerows(SUBJECTS)


if __name__ == "__main__":
    main()
