"""The task Drop: a whole model falls on its contact spheres."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from .._errors import RequestError
from ._contacts import selected_contacts
from ._motion import Motion, Observer, Record
from ._passive import make_passive
from ._resting_height import resting_height
from ._rigid import rigid_copy
from ._scene import Scene, model_errors, open_model, quiet_opensim
from ._settings import as_patterns, check_choice, parse_multiple

#: Longest step between two stops, in units of √(x/g) with the indentation x at rest: 60 stops in one period on the contacts.
_MAX_STEP = 0.1
#: Least indentation for the step, in R.
_MIN_INDENTATION = 1e-3


@dataclass(frozen=True)
class Drop:
    """A whole model falls on its contact spheres, in OpenSim: the drop of van Bijlert (2026), Table 1 and Fig. 4.

    The model begins at rest in its default pose, with the lowest point of its spheres at a height above the ground.

    With locked joints it only moves up and down, as in `ocs.drop_test`: M ẍ = M g − Σ F(x, ẋ), with gravity and contact as the only
    forces. With free joints, every coordinate that the model leaves free moves, and all of its forces act, but its actuators get no
    command: controllers are switched off, muscles have no excitation and begin in equilibrium.

    Parameters
    ----------
    height : float or str
        Height at the start: in m, or in radii, such as "0.25R" (or "x0.25"). R = √(Σ R²/n) of the spheres.
    duration : float or str
        Duration in s, or in units of √(R/g), such as "35T".
    joints : "locked" or "free"
    select : str or tuple of str
        Names of the contact forces that act, with `*` and `?`; the others are switched off. By default all act.
    actuators : "rest" or "off"
        With free joints: muscles and other actuators act without a command ("rest"), or not at all ("off").
    samples : int
        Number of points of the series.
    accuracy : float
        Relative accuracy of OpenSim's integrator (Runge-Kutta-Merson).

    Raises
    ------
    RequestError
        A setting is wrong.
    """

    height: float | str = "0.25R"
    duration: float | str = 2.0
    joints: str = "locked"
    select: str | tuple[str, ...] = ()
    actuators: str = "rest"
    samples: int = 1001
    accuracy: float = 1e-9

    def __post_init__(self) -> None:
        parse_multiple(self.height, "R", "height")
        if not parse_multiple(self.duration, "T", "duration")[0] > 0:
            raise RequestError("usage", "duration=0: expected a time above 0", keywords=("duration",))
        check_choice(self.joints, ("locked", "free"), "joints")
        check_choice(self.actuators, ("rest", "off"), "actuators")
        if not isinstance(self.samples, int) or self.samples < 2:
            message = f"samples={self.samples!r}: expected a whole number of at least 2"
            raise RequestError("usage", message, keywords=("samples",))
        if not isinstance(self.accuracy, float) or not 0 < self.accuracy < 1:
            message = f"accuracy={self.accuracy!r}: expected a number between 0 and 1"
            raise RequestError("usage", message, keywords=("accuracy",))
        object.__setattr__(self, "select", as_patterns(self.select))

    def __call__(self, path: str) -> tuple[dict[str, float | None], dict[str, list[float]]]:
        """Lets the model of a file fall and returns its figures and series.

        Figures have the names that `ocs.drop_test` gives them. Times in s, heights in m above the ground, speeds in m/s upwards,
        forces in N, or in body weights (`bw`). In the series `height_m` is that of the lowest point of all spheres, below 0 in the ground,
        and `speed_m_s` is that of the centre of mass; with free joints its height is `com_height_m`. A figure without a value is None.

        Raises
        ------
        ModelError
            OpenSim cannot read or simulate the model, or the model cannot fall: it has no contacts, no level ground, no gravity, or no
            coordinate that moves it up and down, or its contact forces are NaN.
        """
        opensim = quiet_opensim()
        with model_errors(path, "let this model fall"):
            scene = self._scene(opensim, path)
            return self._fall(scene)

    def _scene(self, opensim: Any, path: str) -> Scene:
        model = open_model(opensim, path)
        contacts = selected_contacts(opensim, model, self.select)
        if self.joints == "free":
            make_passive(opensim, model, contacts, acting=self.actuators == "rest")
            return Scene(opensim, model, contacts)
        scene = Scene(opensim, model, contacts)
        locked_model = rigid_copy(opensim, model, scene.state, scene.moving, contacts, scene.up)
        locked_model.finalizeConnections()
        return Scene(opensim, locked_model, selected_contacts(opensim, locked_model, ()))

    def _fall(self, scene: Scene) -> tuple[dict[str, float | None], dict[str, list[float]]]:
        number, is_in_radii = parse_multiple(self.height, "R", "height")
        height = number * scene.reference_radius_m if is_in_radii else number
        number, is_in_units = parse_multiple(self.duration, "T", "duration")
        duration = number * scene.reference_time_s if is_in_units else number
        rest = resting_height(scene, scene.opensim.State(scene.state))
        scene.place(scene.state, height)
        if self.joints == "free" and self.actuators == "rest":
            scene.model.equilibrateMuscles(scene.state)
        indentation = max(-rest, _MIN_INDENTATION * scene.reference_radius_m)
        columns: dict[str, Callable[[Any], float]] = {
            "height_m": scene.lowest_m,
            "speed_m_s": scene.speed_m_s,
            "force_n": scene.force_n,
        }
        if self.joints == "free":
            columns["com_height_m"] = scene.com_height_m
        observer = Observer(scene, Motion(scene, self.accuracy), columns)
        record = observer.follow(duration, self.samples, _MAX_STEP * (indentation / scene.gravity_m_s2) ** 0.5)
        return self._figures(scene, record, height, duration, rest), _series_of_fall(scene, record)

    def _figures(
        self, scene: Scene, record: Record, height: float, duration: float, rest: float
    ) -> dict[str, float | None]:
        radius, touch, lift_off = scene.reference_radius_m, record.touch, record.lift_off
        figures: dict[str, float | None] = {
            "mass_kg": scene.mass_kg,
            "sphere_count": len(scene.balls),
            "gravity_m_s2": scene.gravity_m_s2,
            "height_m": height,
            "duration_s": duration,
            "reference_radius_m": radius,
            "reference_time_s": scene.reference_time_s,
            "final_relative_indentation": -record.series["height_m"][-1] / radius,
            "relative_indentation_model_law": -rest / radius,
            "peak_force_n": record.peak_force_n,
            "peak_force_bw": record.peak_force_n / scene.weight_n,
            "peak_time_s": record.peak_time_s,
            "impact_speed_m_s": None if touch is None else -touch.speed_m_s,
            "contact_time_s": None if touch is None or lift_off is None else lift_off.time_s - touch.time_s,
            "rebound_speed_m_s": None if lift_off is None else lift_off.speed_m_s,
        }
        if self.joints == "free":
            figures["lowest_com_height_m"] = min(record.series["com_height_m"])
        return figures


def _series_of_fall(scene: Scene, record: Record) -> dict[str, list[float]]:
    return record.series | {
        "force_bw": [force / scene.weight_n for force in record.series["force_n"]],
        "dimensionless_time": [time / scene.reference_time_s for time in record.series["time_s"]],
    }
