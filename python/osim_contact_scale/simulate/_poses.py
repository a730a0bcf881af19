"""Poses of frames and places of spheres of an `opensim.Model`, as NumPy arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


def vector_of_vec3(vec3: Any) -> Array:
    """A `Vec3` as an array of three."""
    return np.array([vec3.get(axis) for axis in range(3)])


def matrix_of_rotation(rotation: Any) -> Array:
    """A `Rotation` as an array of 3 × 3."""
    rows = rotation.asMat33()
    return np.array([[rows.get(row, column) for column in range(3)] for row in range(3)])


def angles_of_rotation(rotation: Array) -> Array:
    """Body-fixed angles about X, Y and Z, in rad, of a matrix of 3 × 3: what OpenSim calls an orientation."""
    cosine = np.hypot(rotation[0, 0], rotation[0, 1])
    about_y = np.arctan2(rotation[0, 2], cosine)
    if cosine < 1e-8:
        # X and Z turn about the same axis: one of them is enough.
        return np.array([np.arctan2(rotation[2, 1], rotation[1, 1]), about_y, 0.0])
    about_x = np.arctan2(-rotation[1, 2], rotation[2, 2])
    return np.array([about_x, about_y, np.arctan2(-rotation[0, 1], rotation[0, 0])])


def rotation_along(axis: Array) -> Array:
    """A rotation matrix whose X direction is this axis."""
    other = np.eye(3)[int(np.argmin(np.abs(axis)))]
    third = np.cross(axis, other)
    third /= np.linalg.norm(third)
    return np.column_stack([axis, np.cross(third, axis), third])


@dataclass(frozen=True)
class Pose:
    """Position and orientation of a frame."""

    origin_m: Array
    rotation: Array

    @classmethod
    def of(cls, transform: Any) -> Pose:
        """The pose of a `Transform`."""
        return cls(vector_of_vec3(transform.p()), matrix_of_rotation(transform.R()))

    @classmethod
    def in_ground(cls, frame: Any, state: Any) -> Pose:
        """The pose of a model's frame in ground; the state must be realized to position."""
        return cls.of(frame.getTransformInGround(state))

    def then(self, inner: Pose) -> Pose:
        """The pose `inner`, given in this frame, converted to the frame in which this pose is given."""
        return Pose(self.origin_m + self.rotation @ inner.origin_m, self.rotation @ inner.rotation)

    def seen_from(self, other: Pose) -> Pose:
        """This pose, given in the frame `other`."""
        back = other.rotation.T
        return Pose(back @ (self.origin_m - other.origin_m), back @ self.rotation)


class Ball:
    """A contact sphere above the plane of a half-space that does not move."""

    def __init__(self, opensim: Any, sphere: Any, floor: Any, state: Any) -> None:
        self.name = str(sphere.getName())
        self.radius_m = float(sphere.getRadius())
        self._frame = sphere.getFrame()
        self._centre = opensim.Vec3(sphere.get_location())
        plane = Pose.in_ground(floor.getFrame(), state).then(Pose.of(floor.getTransform()))
        # A half-space is solid where its x is above 0.
        self.normal: Array = -plane.rotation[:, 0]
        self.level_m = float(self.normal @ plane.origin_m)

    def centre_m(self, state: Any) -> Array:
        """The centre in ground, m. The state must be realized to position."""
        return vector_of_vec3(self._frame.getTransformInGround(state).shiftFrameStationToBase(self._centre))

    def height_m(self, state: Any) -> float:
        """Height of the lowest point above the plane, m; negative if the sphere is pressed in."""
        return float(self.normal @ self.centre_m(state)) - self.level_m - self.radius_m
