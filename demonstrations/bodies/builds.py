"""Public models at other builds: `write` scales one with OpenSim, and gives it contacts in three ways.

OpenSim's Scale Tool has a factor for each bone. Here trunk, legs and feet have one each, and the mass another. Contacts stay behind; then
they are left, rescaled by mass alone, or transferred from the original model with their places.
"""

from dataclasses import dataclass
from pathlib import Path

import opensim
import osim_contact_scale as ocs


@dataclass(frozen=True)
class Build:
    """Factors of mass, and of length for trunk, legs and feet, over those of the original."""

    mass: float
    trunk: float
    leg: float
    foot: float

    @property
    def length(self):
        return self.mass ** (1 / 3)


BUILDS = {
    "original": Build(1, 1, 1, 1),
    "similar": Build(1 / 8, 0.5, 0.5, 0.5),
    "child": Build(0.26, 0.64, 0.56, 0.61),
    "long feet": Build(1 / 8, 0.5, 0.5, 0.9),
    "short feet": Build(8, 2, 2, 1.2),
}

# File below the folder that is given: where it is from, and its licence. None of them is part of this project.
MODELS = {
    "v40000_moco_2d_gait.osim": ("opensim-core, Moco's 2-D walker", "Apache-2.0"),
    "v40000_falisse_2022_human.osim": ("PredSim, Falisse et al. (2022)", "AGPL-3.0"),
    "v40000_dhondt_2024_3seg_human.osim": ("PredSim, D'Hondt et al. (2024)", "AGPL-3.0"),
    "v40000_opencap_lai_arnold_crlf.osim": ("OpenCap, Lai-Arnold", "see its LICENSE.md"),
}
CONTACTS = {"left": "left behind", "mass": "rescaled by mass only", "places": "transferred with places"}

LEGS = ("femur", "tibia", "patella")
FEET = ("talus", "calcn", "midfoot", "forefoot", "toes")
# Masses and radii far from the original's are meant here.
CONFIRMED = ("implausible-mass", "mass-in-pounds", "implausible-radius")


def write(original, folder, name, build, contacts):
    """The model of a build, with its contacts.

    Parameters
    ----------
    original : Path
        A public model.
    folder : Path
        Where the files go.
    name : str
        Of the build, for the file.
    build : Build
    contacts : str
        One of `CONTACTS`.

    Returns
    -------
    Path
        For the original build, the original.
    """
    if name == "original":
        return Path(original)
    folder.mkdir(parents=True, exist_ok=True)
    stem = f"{Path(original).stem}_{name.replace(' ', '_')}"
    scaled, adapted = folder / f"{stem}_left.osim", folder / f"{stem}_{contacts}.osim"
    mass = scale(original, scaled, build)
    if contacts == "mass":
        results = ocs.rescale(str(scaled), contacts_mass=mass, target_mass=mass * build.mass, yes=CONFIRMED)
        results.write(str(adapted), force=True)
    elif contacts == "places":
        results = ocs.transfer(str(scaled), from_=str(original), follow_bodies=True, yes=CONFIRMED)
        results.write(str(adapted), force=True)
    return adapted


def scale(original, path, build):
    """Scales a model with OpenSim and returns the mass of the original, kg."""
    model = opensim.Model(str(original))
    state = model.initSystem()
    mass = model.getTotalMass(state)
    factors = opensim.ScaleSet()
    for body in model.getBodyList():
        one = opensim.Scale()
        one.setSegmentName(body.getName())
        one.setScaleFactors(opensim.Vec3(_factor(body.getName(), build)))
        one.setApply(True)
        factors.cloneAndAppend(one)
    model.scale(state, factors, True, mass * build.mass)
    model.printToXML(str(path))
    return mass


def _factor(body, build):
    if body.startswith(LEGS):
        return build.leg
    return build.foot if body.startswith(FEET) else build.trunk
