"""The forces of spheres at rest on a half-space, in NumPy: (1), (A.3), (A.4) and (C.1) to (C.9) at speed 0."""

import numpy as np

import rules


def force(kind, radius, parameters, x):
    """The force of one sphere at the indentation `x` (m), in N."""
    modulus = parameters["stiffness"] / 2**1.5
    if kind != rules.SMOOTH_SET:
        return 4 / 3 * modulus * np.sqrt(radius) * np.maximum(x, 0.0) ** 1.5
    constant, along = parameters["constant_contact_force"], parameters["hertz_smoothing"]
    alpha, speed = parameters["dissipation"], parameters["hunt_crossley_smoothing"]
    damped = 0.5 + 0.5 * np.tanh(2 * speed / (3 * alpha)) if alpha else 1.0
    return 4 / 3 * modulus * np.sqrt(radius) * (x * x + constant) ** 0.75 * (0.5 + 0.5 * np.tanh(along * x)) * damped


def resting(total, load, low, high):
    """The place at which the increasing function `total` equals `load`, between two values, to the last bit but a few."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if total(middle) < load else (low, middle)
    return 0.5 * (low + high)
