"""Guesses for searches: a walk drawn by hand, a random motion, or an earlier solution."""

import math

import numpy as np
import pandas as pd
from model import ANKLE_HEIGHT, JOINTS, SHANK, SIDES, SPHERES, THIGH
from problem import SPEED, control_name, coordinates, speed_name, torques, value_name

POINTS = 41
SINK = 0.02  # how deep the lowest sphere is below the ground in a guess, m


def by_hand():
    """A walk of sines: legs swing against each other, the swinging knee bends, feet stay level, and one foot is on the ground.

    Returns
    -------
    pandas.DataFrame
        Series of half a cycle at length factor 1: time, states and controls, which are 0.
    """
    phase = np.linspace(0, math.pi, POINTS)
    joints = {}
    for side, start in zip(SIDES, (0.0, math.pi)):
        swing = np.maximum(0, -np.sin(phase + start)) ** 2
        joints[f"hip_{side}"] = 0.1 + 0.35 * np.cos(phase + start)
        joints[f"knee_{side}"] = -0.1 - 0.9 * swing
    tilt = np.full(POINTS, -0.05)
    for side in SIDES:
        joints[f"ankle_{side}"] = np.clip(-(tilt + joints[f"hip_{side}"] + joints[f"knee_{side}"]), -0.5, 0.5)
    return _series(phase / math.pi * 0.5, tilt, joints)


def at_random(seed):
    """A random motion: each joint a random mean and two random sines, the left side half a cycle after the right one.

    Only that a foot is on the ground, that both sides do the same and how fast it goes is taken from a walk: what one knows of a
    model that never walked. One seed is one motion, on every machine.
    """
    random = np.random.default_rng(seed)
    phase = np.linspace(0, math.pi, POINTS)
    means = {"hip": (-0.1, 0.5), "knee": (-0.9, -0.1), "ankle": (-0.3, 0.3)}
    joints = {}
    for joint in JOINTS:
        mean = random.uniform(*means[joint])
        sizes, starts = random.uniform(0, 0.3, 2), random.uniform(0, 2 * math.pi, 2)
        for side, later in zip(SIDES, (0.0, math.pi)):
            waves = (size * np.sin(n * (phase + later) + start) for n, size, start in zip((1, 2), sizes, starts))
            joints[f"{joint}_{side}"] = mean + sum(waves)
    tilt = np.full(POINTS, random.uniform(-0.3, 0.2))
    return _series(phase / math.pi * random.uniform(0.35, 0.9), tilt, joints)


def from_file(path):
    """A solution that was written as CSV."""
    return pd.read_csv(path)


def scaled(series, length):
    """A motion scaled to a walker that is `length` times as long: lengths grow with it, times and speeds with its square root."""
    root = math.sqrt(length)
    ends = {"_m_s": root, "_rad_s": 1 / root, "_s": root, "_m": length}
    copy = series.copy()
    for name in copy.columns:
        copy[name] *= next((factor for end, factor in ends.items() if name.endswith(end)), 1.0)
    return copy


def trajectory(solver, series):
    """The series as a trajectory of Moco."""
    import opensim as osim

    guess = solver.createGuess("bounds")
    guess.setNumTimes(len(series))
    guess.setTime(_vector(osim, series["time_s"]))
    for name, path in coordinates().items():
        guess.setState(f"{path}/value", _vector(osim, series[value_name(name)]))
        guess.setState(f"{path}/speed", _vector(osim, series[speed_name(name)]))
    for name, path in torques().items():
        guess.setControl(path, _vector(osim, series[control_name(name)]))
    return guess


def _vector(osim, values):
    return osim.Vector.createFromMat(np.array(values, dtype=float))


def _series(time, tilt, joints):
    values = {"tilt": tilt, "forward": SPEED * time, "up": _hip_height(tilt, joints), **joints}
    result = {"time_s": time}
    for name, value in values.items():
        result[value_name(name)] = value
        result[speed_name(name)] = np.gradient(value, time)
    return pd.DataFrame(result | {control_name(name): np.zeros(len(time)) for name in torques()})


def _hip_height(tilt, joints):
    """The height of the hip at which the lowest sphere is a little below the ground."""
    lowest = []
    for side in SIDES:
        thigh = tilt + joints[f"hip_{side}"]
        shank = thigh + joints[f"knee_{side}"]
        foot = shank + joints[f"ankle_{side}"]
        ankle = -THIGH * np.cos(thigh) - SHANK * np.cos(shank)
        lowest += [ankle + forward * np.sin(foot) - ANKLE_HEIGHT * np.cos(foot) for forward in SPHERES.values()]
    return -np.min(lowest, axis=0) - SINK
