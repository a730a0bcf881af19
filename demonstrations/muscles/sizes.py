"""Moco's 2-D walker at another mass: `scale_to_mass` makes the models that the study compares.

Bodies are geometrically similar, under one gravity: with a factor of mass m, lengths grow with m^(1/3), times with the root of lengths,
forces with m. OpenSim's own scaling, which its Scale Tool uses, makes the bones, the joints, the masses, and the paths and lengths of
muscles. It leaves forces, times and contacts; here the forces and times of muscles follow. What is left are the contacts.
"""

from dataclasses import dataclass
from pathlib import Path

import opensim
import osim_contact_scale as ocs

MODEL = "2D_gait.osim"
LUMBAR = "/lumbarAct"  # the one actuator that is not a muscle
CONTACTS = ("rescaled", "left", "no_friction")


@dataclass(frozen=True)
class Size:
    """A factor of mass, and what follows from it."""

    mass: float

    @property
    def length(self):
        return self.mass ** (1 / 3)

    @property
    def time(self):
        return self.length**0.5

    @property
    def torque(self):
        return self.mass * self.length


def scale_to_mass(original, folder, size):
    """Writes the model at another size: with old contacts, and with contacts from this project's `transfer`, with and without `--friction`.

    Parameters
    ----------
    original : Path
        Moco's model.
    folder : Path
        Where the models go.
    size : Size

    Returns
    -------
    dict of str to Path
        The model for each of `CONTACTS`. At a factor of 1 all are the original.
    """
    original, folder = Path(original), Path(folder)
    if size.mass == 1:
        return dict.fromkeys(CONTACTS, original)
    folder.mkdir(parents=True, exist_ok=True)
    paths = {kind: folder / f"{kind}_{size.mass:g}.osim" for kind in CONTACTS}
    model = _scaled(original, size)
    _stronger(model, size)
    model.printToXML(str(paths["left"]))
    for kind, friction in (("rescaled", True), ("no_friction", False)):
        transferred = ocs.transfer(str(paths["left"]), from_=str(original), follow_bodies=True, friction=friction)
        transferred.write(str(paths[kind]), force=True)
    return paths


def _scaled(original, size):
    """Scales bodies, joints, masses and paths with OpenSim, but not the contacts."""
    model = opensim.Model(str(original))
    state = model.initSystem()
    factors = opensim.ScaleSet()
    bodies = model.getBodySet()
    for index in range(bodies.getSize()):
        scale = opensim.Scale()
        scale.setSegmentName(bodies.get(index).getName())
        scale.setScaleFactors(opensim.Vec3(size.length))
        scale.setApply(True)
        factors.cloneAndAppend(scale)
    model.scale(state, factors, True, model.getTotalMass(state) * size.mass)
    return model


def _stronger(model, size):
    """Scales forces and times of the actuators, which OpenSim's scaling does not change."""
    for muscle in _muscles(model):
        muscle.set_max_isometric_force(muscle.get_max_isometric_force() * size.mass)
        muscle.set_max_contraction_velocity(muscle.get_max_contraction_velocity() / size.time)
        muscle.set_activation_time_constant(muscle.get_activation_time_constant() * size.time)
        muscle.set_deactivation_time_constant(muscle.get_deactivation_time_constant() * size.time)
    lumbar = opensim.CoordinateActuator.safeDownCast(model.updComponent(LUMBAR))
    lumbar.setOptimalForce(lumbar.getOptimalForce() * size.torque)


def _muscles(model):
    for component in model.getMuscleList():
        yield opensim.DeGrooteFregly2016Muscle.safeDownCast(model.updComponent(component.getAbsolutePathString()))
