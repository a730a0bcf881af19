"""Integrates the motion of a falling body with OpenSim."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ._root import find_root
from ._scene import Scene

#: The time around the largest force is divided into so many parts, so many times.
_PARTS, _TIMES = 16, 3
#: Share of R within which a height is 0.
_HEIGHT_TOLERANCE = 1e-13


@dataclass(frozen=True)
class Moment:
    """A time and state that the integration can continue from."""

    time_s: float
    values: Any


@dataclass(frozen=True)
class Event:
    """A crossing of height 0."""

    time_s: float
    speed_m_s: float


@dataclass
class Record:
    """The recorded series and events of a motion."""

    series: dict[str, list[float]] = field(default_factory=dict)
    peak_force_n: float = 0.0
    peak_time_s: float = 0.0
    touch: Event | None = None
    lift_off: Event | None = None


class Motion:
    """Integrates a scene from its state, by Runge-Kutta-Merson with a relative `accuracy`."""

    def __init__(self, scene: Scene, accuracy: float) -> None:
        self._scene, self._accuracy = scene, accuracy
        self._state = scene.opensim.State(scene.state)
        self._manager: Any = None
        self.start = self.moment(scene.state)

    def moment(self, state: Any) -> Moment:
        """The moment of a state, for `begin`."""
        return Moment(state.getTime(), self._scene.opensim.Vector(state.getY()))

    def begin(self, moment: Moment) -> Any:
        """Starts the integration from a moment; states that earlier calls returned are no longer valid."""
        opensim, state = self._scene.opensim, self._state
        state.setTime(moment.time_s)
        state.setY(moment.values)
        manager = opensim.Manager(self._scene.model)
        manager.setWriteToStorage(False)
        manager.setPerformAnalyses(False)
        manager.setIntegratorMethod(opensim.Manager.IntegratorMethod_RungeKuttaMerson)
        manager.setIntegratorAccuracy(self._accuracy)
        manager.initialize(state)
        self._manager = manager
        return state

    def to(self, time_s: float) -> Any:
        """The state at a later time; valid until the next call."""
        return self._manager.integrate(time_s)

    def state_at(self, moment: Moment, time_s: float) -> Any:
        """The state at a time, integrated from an earlier moment."""
        state = self.begin(moment)
        return self.to(time_s) if time_s > moment.time_s else state


class Observer:
    """Follows a motion from stop to stop: records series, and finds touch-down, lift-off and the largest force.

    Parameters
    ----------
    columns : dict
        The series to record: their names, and functions of a state.
    """

    def __init__(self, scene: Scene, motion: Motion, columns: Mapping[str, Callable[[Any], float]]) -> None:
        self._scene, self._motion, self._columns = scene, motion, columns
        self.record = Record(series={name: [] for name in ("time_s", *columns)})

    def follow(self, duration_s: float, samples: int, longest_s: float) -> Record:
        """The record of a motion, with `samples` points at equal steps, both ends included; stops are at most `longest_s` apart."""
        stops = max(1, -int(-duration_s / (samples - 1) // longest_s))
        count = (samples - 1) * stops
        state = self._motion.begin(self._motion.start)
        height, before = self._scene.lowest_m(state), [self._motion.start] * 2
        if height <= 0:
            self.record.touch = Event(0.0, 0.0)
        self._sample(0.0, state)
        peak_range = (self._motion.start, 0.0)
        for number in range(1, count + 1):
            time = duration_s * (number / count)
            state = self._motion.to(time)
            current = self._motion.moment(state)
            last, height = height, self._scene.lowest_m(state)
            force = self._scene.force_n(state)
            if force > self.record.peak_force_n:
                self.record.peak_force_n, self.record.peak_time_s = force, time
                peak_range = (before[0], duration_s * min((number + 1) / count, 1.0))
            if number % stops == 0:
                self._sample(time, state)
            if (last > 0) != (height > 0) and self.record.lift_off is None:
                self._find_crossing(before[1], time, upward=height > 0)
                self._motion.begin(current)
            before = [before[1], current]
        if self.record.peak_force_n > 0:
            self._refine_peak(*peak_range)
        return self.record

    def _sample(self, time: float, state: Any) -> None:
        self.record.series["time_s"].append(time)
        for name, value in self._columns.items():
            self.record.series[name].append(value(state))

    def _find_crossing(self, before: Moment, until: float, *, upward: bool) -> None:
        """Finds when height 0 was crossed. Only the first contact counts."""

        def height(at: float) -> float:
            return self._scene.lowest_m(self._motion.state_at(before, at))

        time, close = until, _HEIGHT_TOLERANCE * self._scene.reference_radius_m
        # The last step has another length, so that rounding may leave the body on the first side.
        if (height(until) > 0) == upward:
            time = find_root(height, before.time_s, until, close=close)
        event = Event(time, self._scene.speed_m_s(self._motion.state_at(before, time)))
        if not upward:
            self.record.touch = event
        else:
            self.record.lift_off = event

    def _refine_peak(self, before: Moment, until: float) -> None:
        """Finds the largest force between two stops."""
        for _ in range(_TIMES):
            moments, forces = [before], [self._scene.force_n(self._motion.begin(before))]
            for number in range(1, _PARTS + 1):
                state = self._motion.to(before.time_s + (until - before.time_s) * number / _PARTS)
                moments.append(self._motion.moment(state))
                forces.append(self._scene.force_n(state))
            best = max(range(len(forces)), key=forces.__getitem__)
            if forces[best] > self.record.peak_force_n:
                self.record.peak_force_n, self.record.peak_time_s = forces[best], moments[best].time_s
            before, until = moments[max(best - 1, 0)], moments[min(best + 1, _PARTS)].time_s
