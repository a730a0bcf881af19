"""The sizes of Table 1 of the paper, and the models of this demonstration."""

from pathlib import Path

import body
import osim_contact_scale as ocs

# Mass in kg; the reference comes first. The emu of the table is there once.
ANIMALS = {
    "human_62kg": 62.0,
    "mouse": 0.0209,
    "emu": 37.80,
    "human_500kg": 500.0,
    "horse": 545.0,
    "giraffe": 1190.0,
}
REFERENCE = "human_62kg"

# What is done with the contacts of the 62 kg body when the body gets another size.
CONTACTS = {
    "rescaled": "contacts by the paper's rules",
    "radii": "spheres grow, parameters stay",
    "kept": "spheres and parameters stay",
}
# Where feet slide: with all that is rescaled, and without `--friction`.
SLIDING = ("rescaled", "no_friction")

# Masses and radii far from those of the model are meant here.
CONFIRMED = ("implausible-mass", "mass-in-pounds", "implausible-radius")


def length_ratio(animal: str) -> float:
    """Ratio of the lengths of this animal and the reference, which are geometrically similar and of one density."""
    return (ANIMALS[animal] / ANIMALS[REFERENCE]) ** (1 / 3)


def length_m(animal: str) -> float:
    """L, the height of the hips."""
    return body.LENGTH * length_ratio(animal)


def time_unit_s(animal: str) -> float:
    """√(L/g)."""
    return (length_m(animal) / body.GRAVITY) ** 0.5


def write_model(folder: Path, animal: str, law: str, contacts: str) -> Path:
    """Writes the body of an animal, with its contacts adapted as `contacts` says."""
    unchanged = folder / f"{animal}_{law}_kept.osim"
    body.make(unchanged, length_ratio(animal), law)
    if animal == REFERENCE or contacts == "kept":
        return unchanged
    more = {"rescaled": {"friction": True}, "no_friction": {}, "radii": {"only": ["radius"]}}[contacts]
    adapted = ocs.rescale(
        unchanged, contacts_mass=ANIMALS[REFERENCE], target_mass=ANIMALS[animal], yes=CONFIRMED, **more
    )
    path = folder / f"{animal}_{law}_{contacts}.osim"
    adapted.write(path, force=True)
    return path
