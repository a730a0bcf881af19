"""The paper's scaling rule in NumPy, written from its equations and from nothing of this project.

mu = M_b/M_a, nu = n_a/n_b, rho = R_b/R_a. (10): E1* goes with mu nu / rho^2; (14): alpha with rho^(-1/2);
(C.2): cf with rho^2; (C.5): bd with 1/rho; (C.10): bv with rho^(-1/2). An isometric animal has rho = mu^(1/3).
"""

import numpy as np

SMOOTH_SET = "SmoothSphereHalfSpaceForce"
TOLERANCE = 1e-14
PROPERTIES = (
    "stiffness",
    "dissipation",
    "constant_contact_force",
    "hertz_smoothing",
    "hunt_crossley_smoothing",
    "radius",
)


def isometric(mu):
    """rho of an animal of the same build."""
    return np.cbrt(np.float64(mu))


def factors(mu, rho, nu=1.0):
    """The factor of each property."""
    mu, rho, nu = np.float64(mu), np.float64(rho), np.float64(nu)
    return {
        "stiffness": mu * nu / rho**2,
        "dissipation": rho**-0.5,
        "constant_contact_force": rho**2,
        "hertz_smoothing": 1 / rho,
        "hunt_crossley_smoothing": rho**-0.5,
        "radius": rho,
    }


def scaled_properties(force_type):
    """The properties of a force the rule speaks of: HuntCrossleyForce has no smoothing."""
    names = ["stiffness", "dissipation"]
    if force_type == SMOOTH_SET:
        names += ["constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing"]
    return names


def close(value, expected):
    """Equal within TOLERANCE, relatively."""
    return bool(np.isclose(value, expected, rtol=TOLERANCE, atol=0.0))
