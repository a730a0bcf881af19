"""Makes a model passive: its actuators get no commands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ._contacts import Contact


def make_passive(opensim: Any, model: Any, contacts: Sequence[Contact], *, acting: bool) -> None:
    """Switches controllers off, and contact forces that were not chosen; without `acting` also muscles and other actuators.

    Springs, limits, ligaments and bushings still act. Without a controller the control of an actuator is 0, and muscles have their
    least activation.
    """
    selected = {contact.force.getAbsolutePathString() for contact in contacts}
    kinds = ("HuntCrossleyForce", "SmoothSphereHalfSpaceForce")
    for component in list(model.getComponentsList()):
        controller = opensim.Controller.safeDownCast(component)
        if controller is not None:
            controller.setEnabled(False)
        force = opensim.Force.safeDownCast(component)
        if force is None:
            continue
        is_unselected = component.getConcreteClassName() in kinds and component.getAbsolutePathString() not in selected
        if is_unselected or (not acting and opensim.Actuator.safeDownCast(component) is not None):
            force.set_appliesForce(False)
