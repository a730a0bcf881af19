"""Public models at other builds: `write` scales one with OpenSim, and gives it contacts in several ways.

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

# File in the folder that is given: where it is from, and its licence. None of them is part of this project. The sets of contacts of Moco's
# 3-D walking are files beside its model.
MODELS = {
    "v40000_moco_2d_gait.osim": ("opensim-core, Moco's 2-D walker", "Apache-2.0"),
    "v40000_falisse_2022_human.osim": ("PredSim, Falisse et al. (2022)", "AGPL-3.0"),
    "v40000_dhondt_2024_3seg_human.osim": ("PredSim, D'Hondt et al. (2024)", "AGPL-3.0"),
    "v40000_opencap_lai_arnold_crlf.osim": ("OpenCap, Lai-Arnold", "see its LICENSE.md"),
    "v40600_moco_3d_walking_model_without_contacts.osim": ("opensim-core, Moco's 3-D walking", "Apache-2.0"),
    "v40000_human_12_hunt_crossley.osim": ("predictsim_mtp, Falisse et al.", "see its repository"),
    "v40000_scone_h0914m.osim": ("SCONE, H0914M", "GPL-3.0"),
    "v30000_osim_rl_gait9dof18musc_crlf.osim": ("osim-rl, gait9dof18musc", "MIT"),
    "v40000_dynamic_jumper.osim": ("opensim-models, DynamicJumper", "see its repository"),
}
# Options of the transfer with places. With radii by mass, (14) by radius and by mass are one.
PLACES = {
    "places": {"radius": "follow"},
    "places-alpha": {"radius": "follow", "dissipation_by": "mass"},
    "places-radii": {},
}
CONTACTS = ("left", "mass", *PLACES)

LEGS = ("femur", "tibia", "patella")
FEET = ("talus", "calcn", "midfoot", "forefoot", "toes")
# Masses and radii far from the original's are meant here; Moco's 3-D walking has the toe joints of the unscaled foot.
CONFIRMED = ("implausible-mass", "mass-in-pounds", "implausible-radius", "wrong-afterwards")


def original(models, folder, file):
    """The file of a public model; its sets of contacts, if they are files beside it, are put into a copy."""
    model = opensim.Model(str(models / file))
    if model.getContactGeometrySet().getSize() > 0:
        return models / file
    stem = str(models / file).removesuffix("model_without_contacts.osim")
    for ours, theirs in (
        (model.updContactGeometrySet(), opensim.ContactGeometrySet(f"{stem}ContactGeometrySet.xml")),
        (model.updForceSet(), opensim.ForceSet(f"{stem}ContactForceSet.xml")),
    ):
        for number in range(theirs.getSize()):
            ours.cloneAndAppend(theirs.get(number))
    model.finalizeConnections()
    folder.mkdir(parents=True, exist_ok=True)
    model.printToXML(str(folder / file))
    return folder / file


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
    stem = f"{Path(original).stem}_{name}"
    scaled, adapted = (folder / f"{stem}_{way}.osim".replace(" ", "_") for way in ("left", contacts))
    mass = scale(original, scaled, build)
    if contacts == "mass":
        results = ocs.rescale(str(scaled), contacts_mass=mass, target_mass=mass * build.mass, yes=CONFIRMED)
        results.write(str(adapted), force=True)
    elif contacts in PLACES:
        results = ocs.transfer(str(scaled), from_=str(original), follow_bodies=True, yes=CONFIRMED, **PLACES[contacts])
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
