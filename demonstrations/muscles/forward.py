"""Integrates a solution forward: the model starts at its first state and only its controls drive it."""

import numpy as np
import opensim
from problem import LENGTHS, unit

ACCURACY = 1e-6
HOLDS = 0.05  # of the body's lengths (the unscaled body's metres): so far the hips may be off
ANGLES = 0.1  # rad: so far every joint may be off


def forward(model, solution, size):
    """Integrates one step.

    Parameters
    ----------
    model, solution : Path
    size : sizes.Size

    Returns
    -------
    dict
        `forward_held`: the share of the step after which the hips or a joint are first further off than they may be, 1 if they never are.
        `forward_hip_m`, `forward_angle_rad`: how far the hips, and the joint that is furthest off, are from the solution's after the step.
    """
    trajectory = opensim.MocoTrajectory(str(solution))
    body = opensim.Model(str(model))
    _drive(body, trajectory)
    state = body.initSystem()
    for name in trajectory.getStateNames():
        body.setStateVariableValue(state, name, float(trajectory.getStateMat(name)[0]))
    manager = opensim.Manager(body)
    manager.setIntegratorMethod(opensim.Manager.IntegratorMethod_RungeKuttaMerson)
    manager.setIntegratorAccuracy(ACCURACY)
    manager.setIntegratorMaximumStepSize(1e-3 * size.time)
    manager.initialize(state)
    names = [name for name in trajectory.getStateNames() if name.startswith("/jointset/") and name.endswith("/value")]
    expected = {name: trajectory.getStateMat(name) / unit(name, size) for name in names}
    times, duration = trajectory.getTimeMat(), 1.0
    for index, time in enumerate(times[1:], start=1):
        now = manager.integrate(float(time))
        off = {
            name: abs(body.getStateVariableValue(now, name) / unit(name, size) - expected[name][index])
            for name in names
        }
        hip = max(value for name, value in off.items() if name.startswith(LENGTHS))
        angle = max(value for name, value in off.items() if not name.startswith(LENGTHS))
        if duration == 1.0 and not (hip < HOLDS and angle < ANGLES):
            duration = float(time / times[-1])
            duration = min(duration, np.nextafter(1.0, 0.0))
    return {"forward_held": duration, "forward_hip_m": float(hip), "forward_angle_rad": float(angle)}


def _drive(body, trajectory):
    """Every actuator by its control, on straight lines between its values."""
    times = trajectory.getTimeMat()
    controller = opensim.PrescribedController()
    for name in trajectory.getControlNames():
        line = opensim.PiecewiseLinearFunction()
        for time, value in zip(times, trajectory.getControlMat(name)):
            line.addPoint(float(time), float(value))
        controller.addActuator(opensim.Actuator.safeDownCast(body.updComponent(name)))
        controller.prescribeControlForActuator(name.split("/")[-1], line)
    body.addController(controller)
