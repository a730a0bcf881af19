"""Judges a solution: the bounds that it touches, and its cost."""

import numpy as np
from model import GRAVITY, JOINTS, MASS, SIDES, TORQUE
from problem import control_name, speed_name

BOUND_TOLERANCE = 0.01  # of a bound's range


def distances(series, limits):
    """How near a solution comes to each bound.

    Parameters
    ----------
    series : mapping of str to sequence of float
        A solution: `time_s`, which counts with its last value, and states and controls.
    limits : mapping of str to (float, float)
        Lower and upper bound of each.

    Returns
    -------
    dict of str to float
        Of each name the smallest distance to one of its two bounds, as a share of the distance between them. Below 0: beyond it.
    """
    result = {}
    for name, (low, high) in limits.items():
        values = np.asarray(series[name], dtype=float)
        if name == "time_s":
            values = values[-1:]
        elif name == "forward_m":
            values = values[1:]  # It starts at 0, which is said and is not a bound.
        result[name] = float(min(np.min(values) - low, high - np.max(values)) / (high - low))
    return result


def active(series, limits, tolerance=BOUND_TOLERANCE):
    """Names of the bounds that are active: the solution comes nearer to them than this share of their range."""
    return sorted(name for name, distance in distances(series, limits).items() if not distance >= tolerance)


def cost_of_transport(series, length=1.0):
    """Mechanical work of the torques, both signs positive, over body weight × distance."""
    power = sum(
        np.abs(np.asarray(series[control_name(name)]) * np.asarray(series[speed_name(name)]))
        for name in (f"{joint}_{side}" for joint in JOINTS for side in SIDES)
    )
    work = np.trapezoid(TORQUE * length**4 * power, np.asarray(series["time_s"]))
    distance = series["forward_m"][-1] - series["forward_m"][0]
    return float(work / (MASS * length**3 * GRAVITY * distance))
