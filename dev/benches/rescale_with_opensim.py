"""Rescales contacts with OpenSim's API, for a comparison of speed: `python rescale_with_opensim.py MODEL OUTPUT TARGET_MASS_KG`, or
`... FOLDER OUTPUT_FOLDER TARGET_MASS_KG` for all models of a folder.

The script a user would write without this project: load, multiply by the paper's ratios, print. Equations (10), (14),
(C.2), (C.5) and (C.10), with radii that follow the body.
"""

import sys
from pathlib import Path

import opensim


def main(path, output, target_mass):
    opensim.Logger.setLevelString("off")
    if not Path(path).is_dir():
        rescale(path, output, target_mass)
        return
    for model in sorted(Path(path).glob("*.osim")):
        rescale(str(model), str(Path(output) / model.name), target_mass)


def rescale(path, output, target_mass):
    model = opensim.Model(path)
    bodies = model.getBodySet()
    mass = sum(bodies.get(i).getMass() for i in range(bodies.getSize()))
    mu = target_mass / mass
    rho = mu ** (1 / 3)
    factors = {
        "stiffness": mu / rho**2,
        "dissipation": rho**-0.5,
        "constant_contact_force": rho**2,
        "hertz_smoothing": 1 / rho,
        "hunt_crossley_smoothing": rho**-0.5,
    }
    geometries = model.updContactGeometrySet()
    for i in range(geometries.getSize()):
        sphere = opensim.ContactSphere.safeDownCast(geometries.get(i))
        if sphere is not None:
            sphere.setRadius(sphere.getRadius() * rho)
    forces = model.updForceSet()
    for i in range(forces.getSize()):
        smooth = opensim.SmoothSphereHalfSpaceForce.safeDownCast(forces.get(i))
        hunt_crossley = opensim.HuntCrossleyForce.safeDownCast(forces.get(i))
        if smooth is not None:
            for name, factor in factors.items():
                getattr(smooth, f"set_{name}")(getattr(smooth, f"get_{name}")() * factor)
        elif hunt_crossley is not None:
            hunt_crossley.setStiffness(hunt_crossley.getStiffness() * factors["stiffness"])
            hunt_crossley.setDissipation(hunt_crossley.getDissipation() * factors["dissipation"])
    model.printToXML(output)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
