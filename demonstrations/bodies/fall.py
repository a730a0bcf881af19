"""A fall and a stand of a model, in OpenSim, with numbers that do not depend on size."""

import numpy as np
import opensim
from osim_contact_scale import simulate

HEIGHT = 0.25  # radii of the original's spheres, times the factor of length
DURATION = 2.0  # s, of the original
SETTLED = 0.05  # of body weight: a body is at rest when its force stays so near to its weight
SOFTEST = 0.02  # the share of the load below which a sphere does not count as carrying


def fall(path, radius_m, build):
    """Drop a model straight down with its joints locked, and stand it on its contacts.

    Parameters
    ----------
    path : Path
        The model.
    radius_m : float
        Mean radius of the original's spheres, m.
    build : builds.Build

    Returns
    -------
    dict
        `peak_force_bw`; `time_to_rest_s` over the factor of time; `depth`, the largest x/R at rest; `carrying`, the spheres that carry at
        rest, of `spheres`; and `pressure`, how far in front of the ankle the pressure is, over the factor of length of the foot, m.
    """
    time = build.length**0.5
    drop = simulate.Drop(
        height=HEIGHT * radius_m * build.length, duration=DURATION * time, joints="locked", accuracy=1e-9
    )
    figures, series = drop(str(path))
    standing, spheres = simulate.Stand()(str(path))
    loads, places = _standing(path, spheres["indentation_m"])
    return {
        "mass_kg": figures["mass_kg"],
        "radius_m": figures["reference_radius_m"],
        "peak_force_bw": figures["peak_force_bw"],
        "time_to_rest_s": _settling_time(series) / time,
        "depth": standing["largest_relative_indentation"],
        "spheres": len(loads),
        "carrying": int(np.sum(loads > SOFTEST)),
        "pressure_m": float(loads @ places) / build.foot,
    }


def _settling_time(series):
    """Time until the force stays near body weight, s; NaN if it does not."""
    times, away = np.array(series["time_s"]), np.abs(np.array(series["force_bw"]) - 1) > SETTLED
    if not away.any():
        return 0.0  # Smoothed forces can carry a body before it touches the ground.
    last = np.nonzero(away)[0][-1]
    return float(times[last + 1]) if last + 1 < len(times) else float("nan")


def _standing(path, depths):
    """For each sphere at rest: its share of the load, by (C.1) to (C.4) of the paper, and its place in front of the ankles, m."""
    model = opensim.Model(str(path))
    state = model.initSystem()
    model.realizePosition(state)
    bodies = model.getBodySet()
    ankles = [f"{'talus' if bodies.contains('talus_r') else 'calcn'}_{side}" for side in "rl"]
    ankle = np.mean([bodies.get(name).getPositionInGround(state).get(0) for name in ankles])
    loads, places = [], []
    for depth, (sphere, stiffness, constant, hertz) in zip(depths, _contacts(model), strict=True):
        begun = 0.5 + 0.5 * np.tanh(hertz * depth)
        loads.append(stiffness * sphere.getRadius() ** 0.5 * (depth**2 + constant) ** 0.75 * begun)
        places.append(sphere.getFrame().findStationLocationInGround(state, sphere.get_location()).get(0) - ankle)
    return np.array(loads) / np.sum(loads), np.array(places)


def _contacts(model):
    """Each sphere, in the order of forces, with its stiffness, constant_contact_force and hertz_smoothing."""
    for component in list(model.getComponentsList()):
        if component.getConcreteClassName() == "SmoothSphereHalfSpaceForce":
            force = opensim.SmoothSphereHalfSpaceForce.safeDownCast(component)
            sphere = opensim.ContactSphere.safeDownCast(force.getConnectee("sphere"))
            yield sphere, force.get_stiffness(), force.get_constant_contact_force(), force.get_hertz_smoothing()
        elif component.getConcreteClassName() == "HuntCrossleyForce":
            force = opensim.HuntCrossleyForce.safeDownCast(component)
            material = force.updPropertyByName("contact_parameters").updValueAsObject().updPropertyByName("objects")
            names = material.updValueAsObject(0).updPropertyByName("geometry")
            for name in (opensim.PropertyHelper.getValueString(names, number) for number in range(names.size())):
                sphere = opensim.ContactSphere.safeDownCast(model.getContactGeometrySet().get(name))
                if sphere is not None:
                    yield sphere, force.getStiffness(), 0.0, np.inf
