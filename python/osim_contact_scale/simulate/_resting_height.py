"""Finds the height at which contacts carry a body at rest."""

from __future__ import annotations

from typing import Any

from ._contacts import model_error
from ._root import find_root
from ._scene import Scene

#: Share of the body weight within which a force equals it.
_FORCE_TOLERANCE = 1e-12
#: Greatest indentation that is tried, in radii.
_MAX_DEPTH = 1e6


def resting_height(scene: Scene, state: Any) -> float:
    """Height of the lowest sphere's lowest point above the ground at which ΣF = M g at speed 0, m; negative if it is pressed in.

    The state is left at that height.

    Raises
    ------
    ModelError
        The contacts do not carry the body at any height.
    """

    def surplus_force_n(depth: float) -> float:
        scene.place(state, -depth)
        return scene.force_n(state) - scene.weight_n

    radius = scene.reference_radius_m
    # A smoothed force acts before contact, too: it may carry a light body above the ground.
    above, below = 0.0, 0.1 * radius
    while surplus_force_n(above) > 0:
        above = -2 * (0.1 * radius - above)
        if above < -_MAX_DEPTH * radius:
            raise model_error("the contact forces carry more than the body weight wherever it is")
    while surplus_force_n(below) < 0:
        below *= 2
        if below > _MAX_DEPTH * radius:
            raise model_error(
                "the contact forces do not carry the body weight however deep it sinks: is the stiffness 0?"
            )
    depth = find_root(surplus_force_n, above, below, close=_FORCE_TOLERANCE * scene.weight_n)
    scene.place(state, -depth)
    return -depth
