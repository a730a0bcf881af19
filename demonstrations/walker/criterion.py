"""Decides whether a search is a success, and computes the confidence interval of a share of successes.

A solution counts if the solver says so, if searched once more with twice the mesh its effort changes by less than 2 %, and if the walker,
driven by its controls alone, stays near it for one step. Forces do not count: meshes this coarse do not settle them (`mesh.csv`).
"""

import math

import pandas as pd

CHANGE = 0.02  # of effort, between the meshes
HOLDS = 0.05  # of the leg: how far the hips may be off in the forward simulation
ANGLES = 0.1  # rad: how far a joint may be off


def checked(path, first, series, mesh, max_iterations):
    """A search that was solved, once more with twice the mesh, and forward from there: the columns of a row that say so."""
    from walk import solved

    finer, series = solved(path, pd.DataFrame(series), 2 * mesh, max_iterations=max_iterations, is_warm_start=True)
    return {
        "solved_twice": finer["converged"],
        "effort_change": first["effort"] / finer["effort"] - 1,
        "held": forward(path, series),
    }


def forward(path, series):
    """The share of the step for which a forward simulation stays near a solution."""
    import opensim
    from model import LEG
    from problem import control_name, coordinates, speed_name, torques, value_name

    walker = opensim.Model(str(path))
    controller = opensim.PrescribedController()
    for name, where in torques().items():
        line = opensim.PiecewiseLinearFunction()
        for at, value in zip(series["time_s"], series[control_name(name)]):
            line.addPoint(float(at), float(value))
        controller.addActuator(opensim.Actuator.safeDownCast(walker.updComponent(where)))
        controller.prescribeControlForActuator(where.split("/")[-1], line)
    walker.addController(controller)
    state = walker.initSystem()
    for name, where in coordinates().items():
        walker.setStateVariableValue(state, f"{where}/value", float(series[value_name(name)][0]))
        walker.setStateVariableValue(state, f"{where}/speed", float(series[speed_name(name)][0]))
    manager = opensim.Manager(walker)
    manager.setIntegratorAccuracy(1e-6)
    manager.initialize(state)
    for index, at in enumerate(series["time_s"][1:], start=1):
        now = manager.integrate(float(at))
        for name, where in coordinates().items():
            off = abs(walker.getStateVariableValue(now, f"{where}/value") - series[value_name(name)][index])
            if not off < (HOLDS * LEG if name in ("forward", "up") else ANGLES):
                return float(series["time_s"][index - 1] / series["time_s"][-1])
    return 1.0


def succeeded(row):
    """The two counts of a row: at twice the mesh the effort is the same, and the controls hold for the step."""
    effort = int(row["solved"]) == 1 and row["solved_twice"] == "1" and abs(float(row["effort_change"])) < CHANGE
    return effort, effort and float(row["held"]) == 1.0


def wilson(count, total, z=1.959963984540054):
    """Wilson's confidence interval of a share, 95 %.

    >>> [round(end, 4) for end in wilson(15, 20)]
    [0.5313, 0.8881]
    """
    share, square = count / total, z * z / total
    middle = (share + square / 2) / (1 + square)
    half = z / (1 + square) * math.sqrt(share * (1 - share) / total + square / (4 * total))
    return middle - half, middle + half


def in_words(count, total):
    """A count with its interval in percent, in words."""
    low, high = wilson(count, total)
    return f"{count} ({100 * low:.0f}..{100 * high:.0f})"
