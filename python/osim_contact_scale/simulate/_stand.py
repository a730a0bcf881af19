"""The task Stand: places a whole model where its contact spheres carry its weight."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ._contacts import selected_contacts
from ._resting_height import resting_height
from ._scene import Scene, model_errors, open_model, quiet_opensim
from ._settings import as_patterns


@dataclass(frozen=True)
class Stand:
    """Places a whole model where its contact spheres carry its weight at rest, in OpenSim.

    All joints keep the default pose; the body is moved up or down until ΣF = M g at speed 0. Nothing is integrated, and balance is not
    examined: the body cannot tip over. The indentation of each sphere follows from its height. For the forces of one limb, `inspect`
    computes the same number as `relative_indentation_model_law_standing`.

    Parameters
    ----------
    select : str or tuple of str
        Names of the contact forces that carry the body, with `*` and `?`, such as those of one foot. By default all do.
    """

    select: str | tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "select", as_patterns(self.select))

    def __call__(self, path: str) -> tuple[dict[str, float | None], dict[str, list[float]]]:
        """Places the model of a file and returns figures, and lists with one value for each sphere, in the order of the forces.

        `height_m` is the height of the lowest point of all spheres above the ground, `lift_m` the distance that the body was moved up from
        its default pose, `residual_force_n` is ΣF − M g. Each sphere has its `indentation_m` and its relative indentation x/R, negative if
        it does not touch; the names of these figures end with the name of the sphere.

        Raises
        ------
        ModelError
            OpenSim cannot read the model, or the model cannot stand: it has no contacts, no level ground, no gravity, or no coordinate that
            moves it up and down, or its contact forces are NaN or never carry the weight.
        """
        opensim = quiet_opensim()
        with model_errors(path, "place this model"):
            model = open_model(opensim, path)
            return _stand_figures(Scene(opensim, model, selected_contacts(opensim, model, self.select)))


def _stand_figures(scene: Scene) -> tuple[dict[str, float | None], dict[str, list[float]]]:
    start = scene.lowest_m(scene.state)
    height = resting_height(scene, scene.state)
    depths = [-value for value in scene.heights_m(scene.state)]
    relative = [depth / ball.radius_m for depth, ball in zip(depths, scene.balls)]
    figures: dict[str, float | None] = {
        "mass_kg": scene.mass_kg,
        "sphere_count": len(scene.balls),
        "gravity_m_s2": scene.gravity_m_s2,
        "weight_n": scene.weight_n,
        "reference_radius_m": scene.reference_radius_m,
        "height_m": height,
        "lift_m": height - start,
        "residual_force_n": scene.force_n(scene.state) - scene.weight_n,
        "touching_sphere_count": sum(depth > 0 for depth in depths),
        "least_relative_indentation": min(relative),
        "largest_relative_indentation": max(relative),
    }
    for name, depth, share in zip(_sphere_names(scene), depths, relative):
        figures[f"indentation_m_{name}"] = depth
        figures[f"relative_indentation_{name}"] = share
    return figures, {
        "radius_m": [ball.radius_m for ball in scene.balls],
        "indentation_m": depths,
        "relative_indentation": relative,
    }


def _sphere_names(scene: Scene) -> list[str]:
    """Unique names of the spheres for names of columns, in letters, digits and _."""
    names: list[str] = []
    for ball in scene.balls:
        name = re.sub(r"\W", "_", ball.name)
        names.append(name if name not in names else f"{name}_{len(names) + 1}")
    return names
