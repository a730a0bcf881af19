# Written by dev/generate_scaling.py: do not edit.
# Each overload takes all that those before it take: the first one that fits is meant.
# mypy: disable-error-code="overload-overlap"
# pyright: reportOverlappingOverload=false
"""Every equation of the paper as a function of NumPy arrays, Series and DataFrames.

All arguments have names, so that no order can be mixed up; all numbers are in SI units. Arrays are broadcast against each other; the
result is an array of float64, or a float where every argument is a number. A value outside of the domain of an equation is a
`osim_contact_scale.RequestError` (which is a ValueError) that names the argument and the element. Infinity is such a value, too, and
so is NaN, unless `nan="propagate"` is given: then an element is NaN where any of its arguments is, and the others are calculated.

With a Series or a DataFrame of pandas or polars among the arguments, the result is one, too. Its index and columns are theirs. A
Series keeps its name; of several Series, the name that all of them have. Several must have equal indexes (in polars: lengths), in
the same order: nothing is aligned silently. Numbers, and arrays of the same shape, go together with all of them. NA of pandas and
null of polars are taken for NaN.

A function over a list of spheres takes a Series for a list, and gives one number; it is NaN with `nan="propagate"` where any number
of any list is.

A name without "for" is what the name says. A property of OpenSim alone, such as `dissipation`, is the factor by which it grows from
one animal to another; `dissipation_for_restitution` is its value for what is wanted. Moduli are E* of both surfaces unless the name
says plane strain: OpenSim's `stiffness` is a plane strain modulus.

    >>> from osim_contact_scale import scaling
    >>> scaling.dissipation(radius_ratio=4)
    0.5
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, overload

from ._arrays import Number, NumberList, Steps, call, call_of_list, call_of_steps

if TYPE_CHECKING:
    from ._arrays import Array, Floats, Frame, PandasFloats, PandasSeries, Scalar

__all__ = [
    "approximate_restitution",
    "composite_modulus_by_johnson",
    "composite_modulus_by_sherman",
    "composite_modulus_for_indentation",
    "composite_modulus_for_stiffness",
    "composite_modulus_of_equal_surfaces",
    "composite_radius",
    "constant_contact_force",
    "constant_contact_force_for_indentation",
    "constant_indentation_force",
    "constant_relative_indentation",
    "contact_state",
    "continuation_steps",
    "dimensionless_hertz_stiffness",
    "dimensionless_stiffness",
    "dissipation",
    "dissipation_by_mass",
    "dissipation_for_exact_restitution",
    "dissipation_for_restitution",
    "drop_speed",
    "equilibrium_frequency",
    "exact_restitution",
    "hertz_force",
    "hertz_force_at_relative_indentation",
    "hertz_indentation",
    "hertz_rest_indentation",
    "hertz_smoothing",
    "hertz_smoothing_for_radius",
    "hertz_smoothing_for_width",
    "hertz_stiffness",
    "hertz_stiffness_at_relative_indentation",
    "hunt_crossley_dissipative_force",
    "hunt_crossley_force",
    "hunt_crossley_smoothing",
    "hunt_crossley_smoothing_for_radius",
    "hunt_crossley_smoothing_for_reduced_width",
    "hunt_crossley_smoothing_for_speed_width",
    "indentation",
    "mean_square_radius",
    "mean_stress",
    "mixed_dissipation",
    "modulus_ratio",
    "natural_frequency",
    "patch_diameter",
    "patch_radius",
    "plane_strain_modulus",
    "plane_strain_modulus_of_equal_surfaces",
    "plane_strain_modulus_of_material",
    "radius_for_stiffness",
    "relative_indentation",
    "relative_indentation_under_load",
    "relative_patch_radius",
    "smooth_elastic_force",
    "smooth_elastic_stiffness",
    "smooth_force",
    "smooth_rest_force",
    "smooth_rest_indentation",
    "smooth_rest_stiffness",
    "speed_state",
    "speed_state_at_rest",
    "stiffness_on_rigid_ground",
    "threshold_indentation",
    "transition_velocity",
    "transition_width",
    "viscous_friction",
]


def __dir__() -> list[str]:
    return list(__all__)


@overload
def hertz_force(*, composite_modulus: Scalar, radius: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_force(*, composite_modulus: Number, radius: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hertz force of one sphere.

        F_e = 4/3 η √R E* x^(3/2)    (1)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_e: elastic force of one sphere; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (1): Van Bijlert (2026), section 2; Hertz's law as in Johnson (1985) and Sherman et al. (2011).

    Examples
    --------
    >>> round(scaling.hertz_force(composite_modulus=3e5, radius=0.032, indentation=0.008), 3)
    51.2
    """
    return call("hertz_force", {"composite_modulus": composite_modulus, "radius": radius, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def hertz_indentation(*, composite_modulus: Scalar, radius: Scalar, force: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_indentation(*, composite_modulus: Scalar | Array, radius: Scalar | Array, force: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_indentation(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, force: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_indentation(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, force: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_indentation(*, composite_modulus: Number, radius: Number, force: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hertz force of one sphere, solved for x.

        x = (F_e / (4/3 η √R E*))^(2/3)    (1)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    force : float or array_like
        F_e: elastic force of one sphere; in N.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x: indentation: how far sphere and ground overlap; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (1): Van Bijlert (2026), section 2; Hertz's law as in Johnson (1985) and Sherman et al. (2011).

    Examples
    --------
    >>> round(scaling.hertz_indentation(composite_modulus=3e5, radius=0.032, force=51.2), 6)
    0.008
    """
    return call("hertz_indentation", {"composite_modulus": composite_modulus, "radius": radius, "force": force, "shape_factor": shape_factor}, nan)


@overload
def relative_indentation(*, indentation: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def relative_indentation(*, indentation: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def relative_indentation(*, indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def relative_indentation(*, indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def relative_indentation(*, indentation: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Relative indentation.

        x̂ = x / R    (2)

    Parameters
    ----------
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x̂: relative indentation, x / R; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (2): Van Bijlert (2026), section 2.

    Examples
    --------
    >>> scaling.relative_indentation(indentation=0.008, radius=0.032)
    0.25
    """
    return call("relative_indentation", {"indentation": indentation, "radius": radius}, nan)


@overload
def indentation(*, relative_indentation: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def indentation(*, relative_indentation: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def indentation(*, relative_indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def indentation(*, relative_indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def indentation(*, relative_indentation: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Relative indentation, solved for x.

        x = x̂ R    (2)

    Parameters
    ----------
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x: indentation: how far sphere and ground overlap; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (2): Van Bijlert (2026), section 2.

    Examples
    --------
    >>> scaling.indentation(relative_indentation=0.25, radius=0.032)
    0.008
    """
    return call("indentation", {"relative_indentation": relative_indentation, "radius": radius}, nan)


@overload
def hertz_force_at_relative_indentation(*, composite_modulus: Scalar, radius: Scalar, relative_indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_force_at_relative_indentation(*, composite_modulus: Scalar | Array, radius: Scalar | Array, relative_indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_force_at_relative_indentation(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, relative_indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_force_at_relative_indentation(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, relative_indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_force_at_relative_indentation(*, composite_modulus: Number, radius: Number, relative_indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hertz force by relative indentation.

        F_e = 4/3 η R² E* x̂^(3/2)    (3)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_e: elastic force of one sphere; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (3): Van Bijlert (2026), section 2; it is (1) with (2).

    Examples
    --------
    >>> round(scaling.hertz_force_at_relative_indentation(composite_modulus=3e5, radius=0.032,
    ...     relative_indentation=0.25), 3)
    51.2
    """
    return call("hertz_force_at_relative_indentation", {"composite_modulus": composite_modulus, "radius": radius, "relative_indentation": relative_indentation, "shape_factor": shape_factor}, nan)


@overload
def hunt_crossley_dissipative_force(*, composite_modulus: Scalar, radius: Scalar, dissipation: Scalar, indentation: Scalar, speed: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_dissipative_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, dissipation: Scalar | Array, indentation: Scalar | Array, speed: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_dissipative_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, dissipation: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, speed: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_dissipative_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, dissipation: Scalar | Array | Frame, indentation: Scalar | Array | Frame, speed: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_dissipative_force(*, composite_modulus: Number, radius: Number, dissipation: Number, indentation: Number, speed: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hunt–Crossley dissipation.

        F_d = 3/2 F_e α ẋ    (12)

    where

        F_e: elastic force of one sphere; in N

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    speed : float or array_like
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_d: dissipative force of one sphere; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (12): Van Bijlert (2026), section 2.3; Hunt and Crossley (1975).

    Examples
    --------
    >>> round(scaling.hunt_crossley_dissipative_force(composite_modulus=3e5, radius=0.032, dissipation=2,
    ...     indentation=0.008, speed=0.1), 3)
    15.36
    """
    return call("hunt_crossley_dissipative_force", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "indentation": indentation, "speed": speed, "shape_factor": shape_factor}, nan)


@overload
def hunt_crossley_force(*, composite_modulus: Scalar, radius: Scalar, dissipation: Scalar, indentation: Scalar, speed: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, dissipation: Scalar | Array, indentation: Scalar | Array, speed: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, dissipation: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, speed: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, dissipation: Scalar | Array | Frame, indentation: Scalar | Array | Frame, speed: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_force(*, composite_modulus: Number, radius: Number, dissipation: Number, indentation: Number, speed: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hunt–Crossley dissipation, the sum.

        F_c = F_e (1 + 3/2 α ẋ)    (12)

    where

        F_e: elastic force of one sphere; in N

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    speed : float or array_like
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_c: contact force of one sphere, elastic and dissipative; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (12): Van Bijlert (2026), section 2.3; Hunt and Crossley (1975).

    Examples
    --------
    >>> round(scaling.hunt_crossley_force(composite_modulus=3e5, radius=0.032, dissipation=2, indentation=0.008,
    ...     speed=0.1), 3)
    66.56
    """
    return call("hunt_crossley_force", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "indentation": indentation, "speed": speed, "shape_factor": shape_factor}, nan)


@overload
def mean_stress(*, force: Scalar, radius: Scalar, relative_indentation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def mean_stress(*, force: Scalar | Array, radius: Scalar | Array, relative_indentation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def mean_stress(*, force: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, relative_indentation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def mean_stress(*, force: Scalar | Array | Frame, radius: Scalar | Array | Frame, relative_indentation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def mean_stress(*, force: Number, radius: Number, relative_indentation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Mean stress on the contact patch.

        σ = F_c / (π R² x̂)    (15)

    Parameters
    ----------
    force : float or array_like
        F_c: contact force of one sphere, elastic and dissipative; in N.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        σ: mean stress on the contact patch; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (15): Van Bijlert (2026), section 4.3; the patch is the circle of Fig. 3.

    Examples
    --------
    >>> round(scaling.mean_stress(force=51.2, radius=0.032, relative_indentation=0.25), 1)
    63662.0
    """
    return call("mean_stress", {"force": force, "radius": radius, "relative_indentation": relative_indentation}, nan)


@overload
def patch_radius(*, indentation: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def patch_radius(*, indentation: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def patch_radius(*, indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def patch_radius(*, indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def patch_radius(*, indentation: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Size of the contact patch.

        patch radius √(x R)    Fig. 3

    Parameters
    ----------
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        patch radius: radius of the circle on which sphere and ground touch; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    Fig. 3: Van Bijlert (2026), Fig. 3; for small x.

    Examples
    --------
    >>> round(scaling.patch_radius(indentation=0.008, radius=0.032), 6)
    0.016
    """
    return call("patch_radius", {"indentation": indentation, "radius": radius}, nan)


@overload
def patch_diameter(*, indentation: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def patch_diameter(*, indentation: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def patch_diameter(*, indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def patch_diameter(*, indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def patch_diameter(*, indentation: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Size of the contact patch.

        patch diameter 2 √(x R)    Fig. 3

    Parameters
    ----------
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        patch diameter: diameter of the circle on which sphere and ground touch; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    Fig. 3: Van Bijlert (2026), Fig. 3; for small x.

    Examples
    --------
    >>> round(scaling.patch_diameter(indentation=0.008, radius=0.032), 6)
    0.032
    """
    return call("patch_diameter", {"indentation": indentation, "radius": radius}, nan)


@overload
def relative_patch_radius(*, relative_indentation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def relative_patch_radius(*, relative_indentation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def relative_patch_radius(*, relative_indentation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def relative_patch_radius(*, relative_indentation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def relative_patch_radius(*, relative_indentation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Size of the contact patch.

        patch radius / R = √x̂    Fig. 3

    where

        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        patch radius / R: patch radius by the radius of the sphere; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    Fig. 3: Van Bijlert (2026), Fig. 3; for small x.

    Examples
    --------
    >>> round(scaling.relative_patch_radius(relative_indentation=0.16), 6)
    0.4
    """
    return call("relative_patch_radius", {"relative_indentation": relative_indentation}, nan)


@overload
def hertz_stiffness(*, composite_modulus: Scalar, radius: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_stiffness(*, composite_modulus: Scalar | Array, radius: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_stiffness(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_stiffness(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_stiffness(*, composite_modulus: Number, radius: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Contact stiffness of one sphere.

        k = 2 η √R E* √x    (B.1)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k: contact stiffness of one sphere, the slope of its force; in N/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.1): Van Bijlert (2026), appendix B; the slope of (1).

    Examples
    --------
    >>> round(scaling.hertz_stiffness(composite_modulus=3e5, radius=0.032, indentation=0.008), 3)
    9600.0
    """
    return call("hertz_stiffness", {"composite_modulus": composite_modulus, "radius": radius, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def hertz_stiffness_at_relative_indentation(*, composite_modulus: Scalar, radius: Scalar, relative_indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_stiffness_at_relative_indentation(*, composite_modulus: Scalar | Array, radius: Scalar | Array, relative_indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_stiffness_at_relative_indentation(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, relative_indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_stiffness_at_relative_indentation(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, relative_indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_stiffness_at_relative_indentation(*, composite_modulus: Number, radius: Number, relative_indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Contact stiffness by relative indentation.

        k = 2 η R E* √x̂    (B.2)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k: contact stiffness of one sphere, the slope of its force; in N/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.2): Van Bijlert (2026), appendix B; (B.1) with (2).

    Examples
    --------
    >>> round(scaling.hertz_stiffness_at_relative_indentation(composite_modulus=3e5, radius=0.032,
    ...     relative_indentation=0.25), 3)
    9600.0
    """
    return call("hertz_stiffness_at_relative_indentation", {"composite_modulus": composite_modulus, "radius": radius, "relative_indentation": relative_indentation, "shape_factor": shape_factor}, nan)


@overload
def approximate_restitution(*, dissipation: Scalar, impact_speed: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def approximate_restitution(*, dissipation: Scalar | Array, impact_speed: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def approximate_restitution(*, dissipation: Scalar | Array | PandasSeries, impact_speed: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def approximate_restitution(*, dissipation: Scalar | Array | Frame, impact_speed: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def approximate_restitution(*, dissipation: Number, impact_speed: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Coefficient of restitution, approximate.

        c_r = 1 − α ẋ⁻    (13)

    Parameters
    ----------
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    impact_speed : float or array_like
        ẋ⁻: speed just before impact; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        c_r: coefficient of restitution, by the approximation; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (13): Van Bijlert (2026), section 2.3; Hunt and Crossley (1975). Accurate for c_r of about 0.8 and above; refused where it is negative.

    Examples
    --------
    >>> scaling.approximate_restitution(dissipation=2, impact_speed=0.1)
    0.8
    """
    return call("approximate_restitution", {"dissipation": dissipation, "impact_speed": impact_speed}, nan)


@overload
def dissipation_for_restitution(*, restitution: Scalar, impact_speed: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dissipation_for_restitution(*, restitution: Scalar | Array, impact_speed: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dissipation_for_restitution(*, restitution: Scalar | Array | PandasSeries, impact_speed: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dissipation_for_restitution(*, restitution: Scalar | Array | Frame, impact_speed: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dissipation_for_restitution(*, restitution: Number, impact_speed: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Coefficient of restitution, approximate, solved for α.

        α = (1 − c_r) / ẋ⁻    (13)

    Parameters
    ----------
    restitution : float or array_like
        c_r: coefficient of restitution, by the approximation; without unit.
    impact_speed : float or array_like
        ẋ⁻: speed just before impact; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (13): Van Bijlert (2026), section 2.3; Hunt and Crossley (1975). Accurate for c_r of about 0.8 and above; refused where it is negative.

    Examples
    --------
    >>> round(scaling.dissipation_for_restitution(restitution=0.8, impact_speed=0.1), 6)
    2.0
    """
    return call("dissipation_for_restitution", {"restitution": restitution, "impact_speed": impact_speed}, nan)


@overload
def exact_restitution(*, dissipation: Scalar, impact_speed: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def exact_restitution(*, dissipation: Scalar | Array, impact_speed: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def exact_restitution(*, dissipation: Scalar | Array | PandasSeries, impact_speed: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def exact_restitution(*, dissipation: Scalar | Array | Frame, impact_speed: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def exact_restitution(*, dissipation: Number, impact_speed: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Coefficient of restitution, exact.

        d − ln(1 + d) = −c d − ln(1 − c d), d = 3/2 α ẋ⁻    exact restitution

    where

        d: 3/2 α ẋ⁻; without unit

    Parameters
    ----------
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    impact_speed : float or array_like
        ẋ⁻: speed just before impact; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        c: coefficient of restitution, exact; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    exact restitution: beyond the paper: the integral of (12) over an impact without gravity.

    Examples
    --------
    >>> round(scaling.exact_restitution(dissipation=2, impact_speed=0.396), 3)
    0.549
    """
    return call("exact_restitution", {"dissipation": dissipation, "impact_speed": impact_speed}, nan)


@overload
def dissipation_for_exact_restitution(*, restitution: Scalar, impact_speed: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dissipation_for_exact_restitution(*, restitution: Scalar | Array, impact_speed: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dissipation_for_exact_restitution(*, restitution: Scalar | Array | PandasSeries, impact_speed: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dissipation_for_exact_restitution(*, restitution: Scalar | Array | Frame, impact_speed: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dissipation_for_exact_restitution(*, restitution: Number, impact_speed: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Coefficient of restitution, exact, solved for α.

        the same, solved for d    exact restitution

    where

        d: 3/2 α ẋ⁻; without unit

    Parameters
    ----------
    restitution : float or array_like
        c: coefficient of restitution, exact; without unit.
    impact_speed : float or array_like
        ẋ⁻: speed just before impact; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    exact restitution: beyond the paper: the integral of (12) over an impact without gravity.

    Examples
    --------
    >>> round(scaling.dissipation_for_exact_restitution(restitution=0.55, impact_speed=0.396), 3)
    1.996
    """
    return call("dissipation_for_exact_restitution", {"restitution": restitution, "impact_speed": impact_speed}, nan)


@overload
def drop_speed(*, gravity: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def drop_speed(*, gravity: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def drop_speed(*, gravity: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def drop_speed(*, gravity: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def drop_speed(*, gravity: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Impact speed of the paper's drop.

        ẋ⁻ = √(2 g · R/4) = √(g R / 2)    drop speed

    Parameters
    ----------
    gravity : float or array_like
        g: gravity; in m/s².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        ẋ⁻: speed just before impact; in m/s.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    drop speed: the drops of Table 1: a fall from a quarter of the radius.

    Examples
    --------
    >>> round(scaling.drop_speed(gravity=9.81, radius=0.032), 3)
    0.396
    """
    return call("drop_speed", {"gravity": gravity, "radius": radius}, nan)


@overload
def plane_strain_modulus_of_material(*, youngs_modulus: Scalar, poissons_ratio: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def plane_strain_modulus_of_material(*, youngs_modulus: Scalar | Array, poissons_ratio: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def plane_strain_modulus_of_material(*, youngs_modulus: Scalar | Array | PandasSeries, poissons_ratio: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def plane_strain_modulus_of_material(*, youngs_modulus: Scalar | Array | Frame, poissons_ratio: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def plane_strain_modulus_of_material(*, youngs_modulus: Number, poissons_ratio: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Plane strain modulus from Young's modulus.

        E₁* = E₁ / (1 − ν₁²)    (A.1)

    Parameters
    ----------
    youngs_modulus : float or array_like
        E₁: Young's modulus of the material; in N/m².
    poissons_ratio : float or array_like
        ν₁: Poisson's ratio of the material; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.1): Van Bijlert (2026), appendix A; Johnson (1985).

    Examples
    --------
    >>> scaling.plane_strain_modulus_of_material(youngs_modulus=7.5e5, poissons_ratio=0.5)
    1000000.0
    """
    return call("plane_strain_modulus_of_material", {"youngs_modulus": youngs_modulus, "poissons_ratio": poissons_ratio}, nan)


@overload
def composite_modulus_by_johnson(*, first_modulus: Scalar, second_modulus: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_modulus_by_johnson(*, first_modulus: Scalar | Array, second_modulus: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_modulus_by_johnson(*, first_modulus: Scalar | Array | PandasSeries, second_modulus: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_modulus_by_johnson(*, first_modulus: Scalar | Array | Frame, second_modulus: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_modulus_by_johnson(*, first_modulus: Number, second_modulus: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Composite modulus, Johnson's rule.

        E* = E₁* E₂* / (E₁* + E₂*)    (A.2)

    Parameters
    ----------
    first_modulus : float or array_like
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².
    second_modulus : float or array_like
        E₂*: plane strain modulus of the other surface; in N/m².
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E*: composite plane strain modulus of the contact; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.2): Van Bijlert (2026), appendix A; Johnson (1985). OpenSim uses (A.3).

    Examples
    --------
    >>> scaling.composite_modulus_by_johnson(first_modulus=1e6, second_modulus=3e6)
    750000.0
    """
    return call("composite_modulus_by_johnson", {"first_modulus": first_modulus, "second_modulus": second_modulus}, nan)


@overload
def composite_modulus_by_sherman(*, first_modulus: Scalar, second_modulus: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_modulus_by_sherman(*, first_modulus: Scalar | Array, second_modulus: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_modulus_by_sherman(*, first_modulus: Scalar | Array | PandasSeries, second_modulus: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_modulus_by_sherman(*, first_modulus: Scalar | Array | Frame, second_modulus: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_modulus_by_sherman(*, first_modulus: Number, second_modulus: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Composite modulus, the rule of Simbody and OpenSim.

        E* = (E₁*^(2/3) E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3)))^(3/2)    (A.3)

    Parameters
    ----------
    first_modulus : float or array_like
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².
    second_modulus : float or array_like
        E₂*: plane strain modulus of the other surface; in N/m².
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E*: composite plane strain modulus of the contact; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.3): Van Bijlert (2026), appendix A; Sherman et al. (2011).

    Examples
    --------
    >>> round(scaling.composite_modulus_by_sherman(first_modulus=1e6, second_modulus=8e6), 1)
    715541.8
    """
    return call("composite_modulus_by_sherman", {"first_modulus": first_modulus, "second_modulus": second_modulus}, nan)


@overload
def plane_strain_modulus_of_equal_surfaces(*, composite_modulus: Scalar, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def plane_strain_modulus_of_equal_surfaces(*, composite_modulus: Scalar | Array, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def plane_strain_modulus_of_equal_surfaces(*, composite_modulus: Scalar | Array | PandasSeries, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def plane_strain_modulus_of_equal_surfaces(*, composite_modulus: Scalar | Array | Frame, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def plane_strain_modulus_of_equal_surfaces(*, composite_modulus: Number, rule: Literal["sherman", "johnson"] = "sherman", nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Modulus of one of two equal surfaces.

        E₁* = 2^p E*    (A.4)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    rule : {"sherman", "johnson"}, default "sherman"
        p: 1 with (A.2), 3/2 with (A.3) as in OpenSim (the paper's n here); without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.4): Van Bijlert (2026), appendix A. OpenSim's stiffness is E₁*: 2^(3/2) times what the contact feels.

    Examples
    --------
    >>> round(scaling.plane_strain_modulus_of_equal_surfaces(composite_modulus=353553.4), 1)
    1000000.0
    >>> scaling.plane_strain_modulus_of_equal_surfaces(composite_modulus=5e5, rule="johnson")
    1000000.0
    """
    return call("plane_strain_modulus_of_equal_surfaces", {"composite_modulus": composite_modulus}, nan, rule)


@overload
def composite_modulus_of_equal_surfaces(*, plane_strain_modulus: Scalar, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_modulus_of_equal_surfaces(*, plane_strain_modulus: Scalar | Array, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_modulus_of_equal_surfaces(*, plane_strain_modulus: Scalar | Array | PandasSeries, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_modulus_of_equal_surfaces(*, plane_strain_modulus: Scalar | Array | Frame, rule: Literal["sherman", "johnson"] = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_modulus_of_equal_surfaces(*, plane_strain_modulus: Number, rule: Literal["sherman", "johnson"] = "sherman", nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Modulus of one of two equal surfaces, solved for E*.

        E* = E₁* / 2^p    (A.4)

    Parameters
    ----------
    plane_strain_modulus : float or array_like
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².
    rule : {"sherman", "johnson"}, default "sherman"
        p: 1 with (A.2), 3/2 with (A.3) as in OpenSim (the paper's n here); without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E*: composite plane strain modulus of the contact; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.4): Van Bijlert (2026), appendix A. OpenSim's stiffness is E₁*: 2^(3/2) times what the contact feels.

    Examples
    --------
    >>> round(scaling.composite_modulus_of_equal_surfaces(plane_strain_modulus=1e6), 1)
    353553.4
    >>> scaling.composite_modulus_of_equal_surfaces(plane_strain_modulus=1e6, rule="johnson")
    500000.0
    """
    return call("composite_modulus_of_equal_surfaces", {"plane_strain_modulus": plane_strain_modulus}, nan, rule)


@overload
def stiffness_on_rigid_ground(*, youngs_modulus: Scalar, poissons_ratio: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def stiffness_on_rigid_ground(*, youngs_modulus: Scalar | Array, poissons_ratio: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def stiffness_on_rigid_ground(*, youngs_modulus: Scalar | Array | PandasSeries, poissons_ratio: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def stiffness_on_rigid_ground(*, youngs_modulus: Scalar | Array | Frame, poissons_ratio: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def stiffness_on_rigid_ground(*, youngs_modulus: Number, poissons_ratio: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """A soft body on rigid ground.

        E* → E₁* for E₂* → ∞    (A.5)
        stiffness = 2^(3/2) E₁ / (1 − ν₁²)    (A.5)

    where

        E*: composite plane strain modulus of the contact; in N/m²
        E₂*: plane strain modulus of the other surface; in N/m²

    Parameters
    ----------
    youngs_modulus : float or array_like
        E₁: Young's modulus of the material; in N/m².
    poissons_ratio : float or array_like
        ν₁: Poisson's ratio of the material; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (A.5): Van Bijlert (2026), appendix A; with (A.1) and (A.4) it gives the stiffness to write in OpenSim.

    Examples
    --------
    >>> round(scaling.stiffness_on_rigid_ground(youngs_modulus=7.5e5, poissons_ratio=0.5), 1)
    2828427.1
    """
    return call("stiffness_on_rigid_ground", {"youngs_modulus": youngs_modulus, "poissons_ratio": poissons_ratio}, nan)


@overload
def mixed_dissipation(*, first_modulus: Scalar, first_dissipation: Scalar, second_modulus: Scalar, second_dissipation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def mixed_dissipation(*, first_modulus: Scalar | Array, first_dissipation: Scalar | Array, second_modulus: Scalar | Array, second_dissipation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def mixed_dissipation(*, first_modulus: Scalar | Array | PandasSeries, first_dissipation: Scalar | Array | PandasSeries, second_modulus: Scalar | Array | PandasSeries, second_dissipation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def mixed_dissipation(*, first_modulus: Scalar | Array | Frame, first_dissipation: Scalar | Array | Frame, second_modulus: Scalar | Array | Frame, second_dissipation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def mixed_dissipation(*, first_modulus: Number, first_dissipation: Number, second_modulus: Number, second_dissipation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Dissipation of two unlike surfaces.

        α = α₁ s₁ + α₂ (1 − s₁), s₁ = E₂*^(2/3) / (E₁*^(2/3) + E₂*^(2/3))    Simbody

    where

        s₁: share of the indentation that the first surface takes; without unit

    Parameters
    ----------
    first_modulus : float or array_like
        E₁*: plane strain modulus of one of the two surfaces (OpenSim: stiffness); in N/m².
    first_dissipation : float or array_like
        α₁: dissipation of one surface; in s/m.
    second_modulus : float or array_like
        E₂*: plane strain modulus of the other surface; in N/m².
    second_dissipation : float or array_like
        α₂: dissipation of the other surface; in s/m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    Simbody: not numbered in the paper: Simbody's HuntCrossleyForce (Sherman et al. 2011).

    Examples
    --------
    >>> round(scaling.mixed_dissipation(first_modulus=1e6, first_dissipation=2, second_modulus=8e6,
    ...     second_dissipation=1), 6)
    1.8
    """
    return call("mixed_dissipation", {"first_modulus": first_modulus, "first_dissipation": first_dissipation, "second_modulus": second_modulus, "second_dissipation": second_dissipation}, nan)


@overload
def composite_radius(*, first_radius: Scalar, second_radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_radius(*, first_radius: Scalar | Array, second_radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_radius(*, first_radius: Scalar | Array | PandasSeries, second_radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_radius(*, first_radius: Scalar | Array | Frame, second_radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_radius(*, first_radius: Number, second_radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Composite radius of two spheres.

        R = R₁ R₂ / (R₁ + R₂)    Johnson

    Parameters
    ----------
    first_radius : float or array_like
        R₁: radius of the first sphere; in m.
    second_radius : float or array_like
        R₂: radius of the second sphere; in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        R: composite radius of two spheres; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    Johnson: not numbered in the paper: Johnson (1985), as in section 2.

    Examples
    --------
    >>> round(scaling.composite_radius(first_radius=0.03, second_radius=0.06), 6)
    0.02
    """
    return call("composite_radius", {"first_radius": first_radius, "second_radius": second_radius}, nan)


@overload
def composite_modulus_for_indentation(*, relative_indentation: Scalar, radius: Scalar, load: Scalar, sphere_count: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_modulus_for_indentation(*, relative_indentation: Scalar | Array, radius: Scalar | Array, load: Scalar | Array, sphere_count: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_modulus_for_indentation(*, relative_indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, load: Scalar | Array | PandasSeries, sphere_count: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_modulus_for_indentation(*, relative_indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, load: Scalar | Array | Frame, sphere_count: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_modulus_for_indentation(*, relative_indentation: Number, radius: Number, load: Number, sphere_count: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """The modulus for a wanted relative indentation under a known load.

        E* = 3 F / (4 η R² x̂^(3/2) n)    (11)

    where

        η: shape factor, 1 for spheres; without unit

    Parameters
    ----------
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    load : float or array_like
        F: expected load on all n spheres together; in N.
    sphere_count : float or array_like
        n: spheres that share the load; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E*: composite plane strain modulus of the contact; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (11): Van Bijlert (2026), section 2.2. Multiply by 2^(3/2) (A.4) to get OpenSim's stiffness.

    Examples
    --------
    >>> round(scaling.composite_modulus_for_indentation(relative_indentation=0.25, radius=0.032, load=600,
    ...     sphere_count=6), 3)
    585937.5
    """
    return call("composite_modulus_for_indentation", {"relative_indentation": relative_indentation, "radius": radius, "load": load, "sphere_count": sphere_count}, nan)


@overload
def relative_indentation_under_load(*, composite_modulus: Scalar, radius: Scalar, load: Scalar, sphere_count: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def relative_indentation_under_load(*, composite_modulus: Scalar | Array, radius: Scalar | Array, load: Scalar | Array, sphere_count: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def relative_indentation_under_load(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, load: Scalar | Array | PandasSeries, sphere_count: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def relative_indentation_under_load(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, load: Scalar | Array | Frame, sphere_count: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def relative_indentation_under_load(*, composite_modulus: Number, radius: Number, load: Number, sphere_count: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """The modulus for a wanted relative indentation under a known load, solved for x̂.

        x̂ = (3 F / (4 η E* R² n))^(2/3)    (11)

    where

        η: shape factor, 1 for spheres; without unit

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    load : float or array_like
        F: expected load on all n spheres together; in N.
    sphere_count : float or array_like
        n: spheres that share the load; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x̂: relative indentation, x / R; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (11): Van Bijlert (2026), section 2.2. Multiply by 2^(3/2) (A.4) to get OpenSim's stiffness.

    Examples
    --------
    >>> round(scaling.relative_indentation_under_load(composite_modulus=353553.4, radius=0.032, load=62 * 9.81,
    ...     sphere_count=6), 4)
    0.3533
    """
    return call("relative_indentation_under_load", {"composite_modulus": composite_modulus, "radius": radius, "load": load, "sphere_count": sphere_count}, nan)


@overload
def composite_modulus_for_stiffness(*, stiffness: Scalar, radius: Scalar, relative_indentation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def composite_modulus_for_stiffness(*, stiffness: Scalar | Array, radius: Scalar | Array, relative_indentation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def composite_modulus_for_stiffness(*, stiffness: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, relative_indentation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def composite_modulus_for_stiffness(*, stiffness: Scalar | Array | Frame, radius: Scalar | Array | Frame, relative_indentation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def composite_modulus_for_stiffness(*, stiffness: Number, radius: Number, relative_indentation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Contact stiffness by relative indentation, solved for E*.

        E* = k / (2 η R √x̂)    (B.2)

    where

        η: shape factor, 1 for spheres; without unit

    Parameters
    ----------
    stiffness : float or array_like
        k: contact stiffness of one sphere, the slope of its force; in N/m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        E*: composite plane strain modulus of the contact; in N/m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.2): Van Bijlert (2026), appendix B; (B.1) with (2).

    Examples
    --------
    >>> round(scaling.composite_modulus_for_stiffness(stiffness=9600, radius=0.032, relative_indentation=0.25), 3)
    300000.0
    """
    return call("composite_modulus_for_stiffness", {"stiffness": stiffness, "radius": radius, "relative_indentation": relative_indentation}, nan)


@overload
def radius_for_stiffness(*, stiffness: Scalar, relative_indentation: Scalar, load: Scalar, sphere_count: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def radius_for_stiffness(*, stiffness: Scalar | Array, relative_indentation: Scalar | Array, load: Scalar | Array, sphere_count: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def radius_for_stiffness(*, stiffness: Scalar | Array | PandasSeries, relative_indentation: Scalar | Array | PandasSeries, load: Scalar | Array | PandasSeries, sphere_count: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def radius_for_stiffness(*, stiffness: Scalar | Array | Frame, relative_indentation: Scalar | Array | Frame, load: Scalar | Array | Frame, sphere_count: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def radius_for_stiffness(*, stiffness: Number, relative_indentation: Number, load: Number, sphere_count: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Contact stiffness by relative indentation, with (11).

        R = 3 F / (2 k x̂ n)    (B.2)

    Parameters
    ----------
    stiffness : float or array_like
        k: contact stiffness of one sphere, the slope of its force; in N/m.
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    load : float or array_like
        F: expected load on all n spheres together; in N.
    sphere_count : float or array_like
        n: spheres that share the load; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        R: radius of the sphere (OpenSim: radius); in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.2): Van Bijlert (2026), appendix B; (B.1) with (2).

    Examples
    --------
    >>> round(scaling.radius_for_stiffness(stiffness=9600, relative_indentation=0.25, load=600, sphere_count=6), 6)
    0.0625
    """
    return call("radius_for_stiffness", {"stiffness": stiffness, "relative_indentation": relative_indentation, "load": load, "sphere_count": sphere_count}, nan)


@overload
def dimensionless_stiffness(*, stiffness: Scalar, radius: Scalar, load: Scalar, sphere_count: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dimensionless_stiffness(*, stiffness: Scalar | Array, radius: Scalar | Array, load: Scalar | Array, sphere_count: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dimensionless_stiffness(*, stiffness: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, load: Scalar | Array | PandasSeries, sphere_count: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dimensionless_stiffness(*, stiffness: Scalar | Array | Frame, radius: Scalar | Array | Frame, load: Scalar | Array | Frame, sphere_count: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dimensionless_stiffness(*, stiffness: Number, radius: Number, load: Number, sphere_count: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Dimensionless stiffness.

        k̂ = k R n / F_c    (B.3)

    Parameters
    ----------
    stiffness : float or array_like
        k: contact stiffness of one sphere, the slope of its force; in N/m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    load : float or array_like
        F_c: contact force of all n spheres together; in N.
    sphere_count : float or array_like
        n: spheres that share the load; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k̂: dimensionless stiffness; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.3): Van Bijlert (2026), appendix B, which cites Alexander et al. (1986). The second form: (B.2), (3).

    Examples
    --------
    >>> round(scaling.dimensionless_stiffness(stiffness=9600, radius=0.032, load=307.2, sphere_count=6), 6)
    6.0
    """
    return call("dimensionless_stiffness", {"stiffness": stiffness, "radius": radius, "load": load, "sphere_count": sphere_count}, nan)


@overload
def dimensionless_hertz_stiffness(*, relative_indentation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dimensionless_hertz_stiffness(*, relative_indentation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dimensionless_hertz_stiffness(*, relative_indentation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dimensionless_hertz_stiffness(*, relative_indentation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dimensionless_hertz_stiffness(*, relative_indentation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Dimensionless stiffness, Hertz.

        k̂ = 3 / (2 x̂)    (B.3)

    Parameters
    ----------
    relative_indentation : float or array_like
        x̂: relative indentation, x / R; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k̂: dimensionless stiffness; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.3): Van Bijlert (2026), appendix B, which cites Alexander et al. (1986). The second form: (B.2), (3).

    Examples
    --------
    >>> scaling.dimensionless_hertz_stiffness(relative_indentation=0.25)
    6.0
    """
    return call("dimensionless_hertz_stiffness", {"relative_indentation": relative_indentation}, nan)


@overload
def natural_frequency(*, stiffness: Scalar, mass_on_sphere: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def natural_frequency(*, stiffness: Scalar | Array, mass_on_sphere: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def natural_frequency(*, stiffness: Scalar | Array | PandasSeries, mass_on_sphere: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def natural_frequency(*, stiffness: Scalar | Array | Frame, mass_on_sphere: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def natural_frequency(*, stiffness: Number, mass_on_sphere: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Natural frequency of one loaded sphere.

        f_n = √(k / M) / (2π)    (B.4)

    Parameters
    ----------
    stiffness : float or array_like
        k: contact stiffness of one sphere, the slope of its force; in N/m.
    mass_on_sphere : float or array_like
        M: mass on that sphere, body mass / n; in kg.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        f_n: natural frequency of small oscillations; in Hz.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.4): Van Bijlert (2026), appendix B; for small oscillations without damping.

    Examples
    --------
    >>> round(scaling.natural_frequency(stiffness=13450, mass_on_sphere=62 / 6), 3)
    5.742
    """
    return call("natural_frequency", {"stiffness": stiffness, "mass_on_sphere": mass_on_sphere}, nan)


@overload
def equilibrium_frequency(*, relative_indentation: Scalar, radius: Scalar, gravity: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def equilibrium_frequency(*, relative_indentation: Scalar | Array, radius: Scalar | Array, gravity: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def equilibrium_frequency(*, relative_indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, gravity: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def equilibrium_frequency(*, relative_indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, gravity: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def equilibrium_frequency(*, relative_indentation: Number, radius: Number, gravity: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Natural frequency at rest under body weight.

        f_n,eq = √(3/2 · g / (x̂_eq R)) / (2π)    (B.5)

    Parameters
    ----------
    relative_indentation : float or array_like
        x̂_eq: relative indentation at rest under body weight; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    gravity : float or array_like
        g: gravity; in m/s².
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        f_n,eq: natural frequency at rest under body weight; in Hz.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (B.5): Van Bijlert (2026), appendix B; (B.4) with (B.2) and (3).

    Examples
    --------
    >>> round(scaling.equilibrium_frequency(relative_indentation=0.3533, radius=0.032, gravity=9.81), 3)
    5.742
    """
    return call("equilibrium_frequency", {"relative_indentation": relative_indentation, "radius": radius, "gravity": gravity}, nan)


@overload
def modulus_ratio(*, first_dimensionless_stiffness: Scalar, second_dimensionless_stiffness: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def modulus_ratio(*, first_dimensionless_stiffness: Scalar | Array, second_dimensionless_stiffness: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def modulus_ratio(*, first_dimensionless_stiffness: Scalar | Array | PandasSeries, second_dimensionless_stiffness: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def modulus_ratio(*, first_dimensionless_stiffness: Scalar | Array | Frame, second_dimensionless_stiffness: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def modulus_ratio(*, first_dimensionless_stiffness: Number, second_dimensionless_stiffness: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Modulus for a dimensionless stiffness.

        E*_a / E*_b = (k̂_a / k̂_b)^(3/2)    continuation

    where

        E*_a: composite plane strain modulus of a, the reference; in N/m²
        E*_b: composite plane strain modulus of b, the model; in N/m²

    Parameters
    ----------
    first_dimensionless_stiffness : float or array_like
        k̂_a: dimensionless stiffness with E*_a; without unit.
    second_dimensionless_stiffness : float or array_like
        k̂_b: dimensionless stiffness with E*_b; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of E*: composite plane strain modulus of the contact.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    continuation: (11) and (B.3) at one load; the steps of section 4.3.

    Examples
    --------
    >>> scaling.modulus_ratio(first_dimensionless_stiffness=4, second_dimensionless_stiffness=1)
    8.0
    """
    return call("modulus_ratio", {"first_dimensionless_stiffness": first_dimensionless_stiffness, "second_dimensionless_stiffness": second_dimensionless_stiffness}, nan)


@overload
def constant_indentation_force(*, composite_modulus: Scalar, radius: Scalar, constant_contact_force: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def constant_indentation_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, constant_contact_force: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def constant_indentation_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def constant_indentation_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def constant_indentation_force(*, composite_modulus: Number, radius: Number, constant_contact_force: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Hertz force with a constant indentation.

        F_cf = 4/3 η √R E* (x² + cf)^(3/4)    (C.1)

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_cf: elastic force with the constant indentation; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.1): Van Bijlert (2026), appendix C.1, printed there as √(x² + cf)^(3/2).

    Examples
    --------
    >>> round(scaling.constant_indentation_force(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
    ...     indentation=0.008), 3)
    80.0
    """
    return call("constant_indentation_force", {"composite_modulus": composite_modulus, "radius": radius, "constant_contact_force": constant_contact_force, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def smooth_elastic_force(*, composite_modulus: Scalar, radius: Scalar, constant_contact_force: Scalar, hertz_smoothing: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def smooth_elastic_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, constant_contact_force: Scalar | Array, hertz_smoothing: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def smooth_elastic_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def smooth_elastic_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def smooth_elastic_force(*, composite_modulus: Number, radius: Number, constant_contact_force: Number, hertz_smoothing: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Smoothed elastic force.

        F_s = F_cf s_c(x)    (C.3)

    where

        F_cf: elastic force with the constant indentation; in N
        s_c: contact state: 0 is none, 1 is full contact; without unit

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F_s: smoothed elastic force; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.3): Van Bijlert (2026), appendix C.2.

    Examples
    --------
    >>> round(scaling.smooth_elastic_force(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
    ...     hertz_smoothing=300, indentation=0.008), 3)
    79.347
    """
    return call("smooth_elastic_force", {"composite_modulus": composite_modulus, "radius": radius, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def smooth_elastic_stiffness(*, composite_modulus: Scalar, radius: Scalar, constant_contact_force: Scalar, hertz_smoothing: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def smooth_elastic_stiffness(*, composite_modulus: Scalar | Array, radius: Scalar | Array, constant_contact_force: Scalar | Array, hertz_smoothing: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def smooth_elastic_stiffness(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def smooth_elastic_stiffness(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def smooth_elastic_stiffness(*, composite_modulus: Number, radius: Number, constant_contact_force: Number, hertz_smoothing: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Smoothed elastic force, its slope.

        ∂F_s / ∂x    (C.3)

    where

        F_s: smoothed elastic force; in N

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k: contact stiffness of one sphere, the slope of its force; in N/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.3): Van Bijlert (2026), appendix C.2.

    Examples
    --------
    >>> round(scaling.smooth_elastic_stiffness(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
    ...     hertz_smoothing=300, indentation=0.008), 2)
    9910.24
    """
    return call("smooth_elastic_stiffness", {"composite_modulus": composite_modulus, "radius": radius, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def contact_state(*, hertz_smoothing: Scalar, indentation: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def contact_state(*, hertz_smoothing: Scalar | Array, indentation: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def contact_state(*, hertz_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def contact_state(*, hertz_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def contact_state(*, hertz_smoothing: Number, indentation: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Contact state, a smoothed step.

        s_c = ½ + ½ tanh(bd x)    (C.4)

    Parameters
    ----------
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        s_c: contact state: 0 is none, 1 is full contact; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.4): Van Bijlert (2026), appendix C.2.

    Examples
    --------
    >>> scaling.contact_state(hertz_smoothing=300, indentation=0)
    0.5
    >>> round(scaling.contact_state(hertz_smoothing=300, indentation=0.008), 3)
    0.992
    """
    return call("contact_state", {"hertz_smoothing": hertz_smoothing, "indentation": indentation}, nan)


@overload
def smooth_force(*, composite_modulus: Scalar, radius: Scalar, dissipation: Scalar, constant_contact_force: Scalar, hertz_smoothing: Scalar, hunt_crossley_smoothing: Scalar, indentation: Scalar, speed: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def smooth_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, dissipation: Scalar | Array, constant_contact_force: Scalar | Array, hertz_smoothing: Scalar | Array, hunt_crossley_smoothing: Scalar | Array, indentation: Scalar | Array, speed: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def smooth_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, dissipation: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, hunt_crossley_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, speed: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def smooth_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, dissipation: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, hunt_crossley_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, speed: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def smooth_force(*, composite_modulus: Number, radius: Number, dissipation: Number, constant_contact_force: Number, hertz_smoothing: Number, hunt_crossley_smoothing: Number, indentation: Number, speed: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Force of SmoothSphereHalfSpaceForce.

        F = (F_s + 3/2 F_s α ẋ)(½ + ½ tanh(bv (ẋ + 2/(3α))))    (C.9)

    where

        F_s: smoothed elastic force; in N

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    hunt_crossley_smoothing : float or array_like
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    speed : float or array_like
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F: smoothed contact force of one sphere; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.9): Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20.

    Examples
    --------
    >>> round(scaling.smooth_force(composite_modulus=3e5, radius=0.04, dissipation=2, constant_contact_force=3.6e-5,
    ...     hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008, speed=0.1), 3)
    103.151
    """
    return call("smooth_force", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "indentation": indentation, "speed": speed, "shape_factor": shape_factor}, nan)


@overload
def speed_state(*, dissipation: Scalar, hunt_crossley_smoothing: Scalar, speed: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def speed_state(*, dissipation: Scalar | Array, hunt_crossley_smoothing: Scalar | Array, speed: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def speed_state(*, dissipation: Scalar | Array | PandasSeries, hunt_crossley_smoothing: Scalar | Array | PandasSeries, speed: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def speed_state(*, dissipation: Scalar | Array | Frame, hunt_crossley_smoothing: Scalar | Array | Frame, speed: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def speed_state(*, dissipation: Number, hunt_crossley_smoothing: Number, speed: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Force of SmoothSphereHalfSpaceForce, second factor.

        ½ + ½ tanh(bv (ẋ + 2/(3α)))    (C.9)

    Parameters
    ----------
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    hunt_crossley_smoothing : float or array_like
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    speed : float or array_like
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        second factor: speed state: 0 is where the force would pull, 1 is where it pushes; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.9): Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20.

    Examples
    --------
    >>> round(scaling.speed_state(dissipation=2, hunt_crossley_smoothing=50, speed=-0.3), 3)
    0.966
    """
    return call("speed_state", {"dissipation": dissipation, "hunt_crossley_smoothing": hunt_crossley_smoothing, "speed": speed}, nan)


@overload
def speed_state_at_rest(*, dissipation: Scalar, hunt_crossley_smoothing: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def speed_state_at_rest(*, dissipation: Scalar | Array, hunt_crossley_smoothing: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def speed_state_at_rest(*, dissipation: Scalar | Array | PandasSeries, hunt_crossley_smoothing: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def speed_state_at_rest(*, dissipation: Scalar | Array | Frame, hunt_crossley_smoothing: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def speed_state_at_rest(*, dissipation: Number, hunt_crossley_smoothing: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Force of SmoothSphereHalfSpaceForce, second factor at rest.

        ½ + ½ tanh(2 bv/(3α))    (C.9)

    Parameters
    ----------
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    hunt_crossley_smoothing : float or array_like
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        second factor: speed state: 0 is where the force would pull, 1 is where it pushes; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.9): Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20.

    Examples
    --------
    >>> round(scaling.speed_state_at_rest(dissipation=20, hunt_crossley_smoothing=50), 3)
    0.966
    """
    return call("speed_state_at_rest", {"dissipation": dissipation, "hunt_crossley_smoothing": hunt_crossley_smoothing}, nan)


@overload
def smooth_rest_force(*, composite_modulus: Scalar, radius: Scalar, dissipation: Scalar, constant_contact_force: Scalar, hertz_smoothing: Scalar, hunt_crossley_smoothing: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def smooth_rest_force(*, composite_modulus: Scalar | Array, radius: Scalar | Array, dissipation: Scalar | Array, constant_contact_force: Scalar | Array, hertz_smoothing: Scalar | Array, hunt_crossley_smoothing: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def smooth_rest_force(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, dissipation: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, hunt_crossley_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def smooth_rest_force(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, dissipation: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, hunt_crossley_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def smooth_rest_force(*, composite_modulus: Number, radius: Number, dissipation: Number, constant_contact_force: Number, hertz_smoothing: Number, hunt_crossley_smoothing: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Force of SmoothSphereHalfSpaceForce, at rest.

        F = F_s (½ + ½ tanh(2 bv/(3α)))    (C.9)

    where

        F_s: smoothed elastic force; in N

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    hunt_crossley_smoothing : float or array_like
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        F: smoothed contact force of one sphere; in N.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.9): Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20.

    Examples
    --------
    >>> round(scaling.smooth_rest_force(composite_modulus=3e5, radius=0.04, dissipation=20,
    ...     constant_contact_force=3.6e-5, hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008), 3)
    76.614
    """
    return call("smooth_rest_force", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def smooth_rest_stiffness(*, composite_modulus: Scalar, radius: Scalar, dissipation: Scalar, constant_contact_force: Scalar, hertz_smoothing: Scalar, hunt_crossley_smoothing: Scalar, indentation: Scalar, shape_factor: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def smooth_rest_stiffness(*, composite_modulus: Scalar | Array, radius: Scalar | Array, dissipation: Scalar | Array, constant_contact_force: Scalar | Array, hertz_smoothing: Scalar | Array, hunt_crossley_smoothing: Scalar | Array, indentation: Scalar | Array, shape_factor: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def smooth_rest_stiffness(*, composite_modulus: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, dissipation: Scalar | Array | PandasSeries, constant_contact_force: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, hunt_crossley_smoothing: Scalar | Array | PandasSeries, indentation: Scalar | Array | PandasSeries, shape_factor: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def smooth_rest_stiffness(*, composite_modulus: Scalar | Array | Frame, radius: Scalar | Array | Frame, dissipation: Scalar | Array | Frame, constant_contact_force: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, hunt_crossley_smoothing: Scalar | Array | Frame, indentation: Scalar | Array | Frame, shape_factor: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def smooth_rest_stiffness(*, composite_modulus: Number, radius: Number, dissipation: Number, constant_contact_force: Number, hertz_smoothing: Number, hunt_crossley_smoothing: Number, indentation: Number, shape_factor: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Force of SmoothSphereHalfSpaceForce, its slope at rest.

        ∂F / ∂x at ẋ = 0    (C.9)

    where

        F: smoothed contact force of one sphere; in N
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s

    Parameters
    ----------
    composite_modulus : float or array_like
        E*: composite plane strain modulus of the contact; in N/m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    dissipation : float or array_like
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    hunt_crossley_smoothing : float or array_like
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    indentation : float or array_like
        x: indentation: how far sphere and ground overlap; in m.
    shape_factor : float or array_like, default 1
        η: shape factor, 1 for spheres; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        k: contact stiffness of one sphere, the slope of its force; in N/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.9): Van Bijlert (2026), appendix C.2. With α = 0 the second factor is 1. At rest (ẋ = 0) it is below 1: by 3e-15 at α = 2 s/m and bv = 50 s/m, by 3.4 % at α = 20.

    Examples
    --------
    >>> round(scaling.smooth_rest_stiffness(composite_modulus=3e5, radius=0.04, dissipation=20,
    ...     constant_contact_force=3.6e-5, hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008), 2)
    9568.88
    """
    return call("smooth_rest_stiffness", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "indentation": indentation, "shape_factor": shape_factor}, nan)


@overload
def constant_contact_force_for_indentation(*, constant_relative_indentation: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def constant_contact_force_for_indentation(*, constant_relative_indentation: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def constant_contact_force_for_indentation(*, constant_relative_indentation: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def constant_contact_force_for_indentation(*, constant_relative_indentation: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def constant_contact_force_for_indentation(*, constant_relative_indentation: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """cf for a wanted constant relative indentation.

        cf = (R x̂_c)²    (C.2)

    Parameters
    ----------
    constant_relative_indentation : float or array_like
        x̂_c: constant relative indentation; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.2): Van Bijlert (2026), appendix C.1. A start: x̂_c = 0.1, or 0.05 where x̂ below 0.16 is wanted.

    Examples
    --------
    >>> round(scaling.constant_contact_force_for_indentation(constant_relative_indentation=0.1, radius=0.032), 9)
    1.024e-05
    """
    return call("constant_contact_force_for_indentation", {"constant_relative_indentation": constant_relative_indentation, "radius": radius}, nan)


@overload
def constant_relative_indentation(*, constant_contact_force: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def constant_relative_indentation(*, constant_contact_force: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def constant_relative_indentation(*, constant_contact_force: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def constant_relative_indentation(*, constant_contact_force: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def constant_relative_indentation(*, constant_contact_force: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """cf for a wanted constant relative indentation, solved for x̂_c.

        x̂_c = √cf / R    (C.2)

    Parameters
    ----------
    constant_contact_force : float or array_like
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x̂_c: constant relative indentation; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.2): Van Bijlert (2026), appendix C.1. A start: x̂_c = 0.1, or 0.05 where x̂ below 0.16 is wanted.

    Examples
    --------
    >>> round(scaling.constant_relative_indentation(constant_contact_force=1e-5, radius=0.032), 4)
    0.0988
    """
    return call("constant_relative_indentation", {"constant_contact_force": constant_contact_force, "radius": radius}, nan)


@overload
def hertz_smoothing_for_radius(*, dimensionless_hertz_smoothing: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_smoothing_for_radius(*, dimensionless_hertz_smoothing: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_smoothing_for_radius(*, dimensionless_hertz_smoothing: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_smoothing_for_radius(*, dimensionless_hertz_smoothing: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_smoothing_for_radius(*, dimensionless_hertz_smoothing: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bd from a pure number.

        bd = b_x̂ / R    (C.5)

    Parameters
    ----------
    dimensionless_hertz_smoothing : float or array_like
        b_x̂: bd without dimension, bd R; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.5): Van Bijlert (2026), appendix C.2. A start: b_x̂ = 10.

    Examples
    --------
    >>> round(scaling.hertz_smoothing_for_radius(dimensionless_hertz_smoothing=9.6, radius=0.032), 6)
    300.0
    """
    return call("hertz_smoothing_for_radius", {"dimensionless_hertz_smoothing": dimensionless_hertz_smoothing, "radius": radius}, nan)


@overload
def threshold_indentation(*, threshold: Scalar, hertz_smoothing: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def threshold_indentation(*, threshold: Scalar | Array, hertz_smoothing: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def threshold_indentation(*, threshold: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def threshold_indentation(*, threshold: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def threshold_indentation(*, threshold: Number, hertz_smoothing: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Indentation at which the contact state reaches a threshold.

        x̂_t = atanh(1 − 2 t) / (bd R)    (C.6)

    Parameters
    ----------
    threshold : float or array_like
        t: threshold on a smoothed step, such as 0.05; without unit.
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        x̂_t: relative indentation at which s_c is 1 − t; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.6): Van Bijlert (2026), appendix C.2; (C.4) solved for x̂.

    Examples
    --------
    >>> round(scaling.threshold_indentation(threshold=0.05, hertz_smoothing=300, radius=0.032), 4)
    0.1534
    """
    return call("threshold_indentation", {"threshold": threshold, "hertz_smoothing": hertz_smoothing, "radius": radius}, nan)


@overload
def transition_width(*, threshold: Scalar, hertz_smoothing: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def transition_width(*, threshold: Scalar | Array, hertz_smoothing: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def transition_width(*, threshold: Scalar | Array | PandasSeries, hertz_smoothing: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def transition_width(*, threshold: Scalar | Array | Frame, hertz_smoothing: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def transition_width(*, threshold: Number, hertz_smoothing: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """Width of the contact transition.

        Δx̂ = 2 atanh(1 − 2 t) / (bd R)    (C.7)

    Parameters
    ----------
    threshold : float or array_like
        t: threshold on a smoothed step, such as 0.05; without unit.
    hertz_smoothing : float or array_like
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        Δx̂: relative indentation from s_c = t to s_c = 1 − t; without unit.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.7): Van Bijlert (2026), appendix C.2; twice (C.6).

    Examples
    --------
    >>> round(scaling.transition_width(threshold=0.05, hertz_smoothing=300, radius=0.032), 4)
    0.3067
    """
    return call("transition_width", {"threshold": threshold, "hertz_smoothing": hertz_smoothing, "radius": radius}, nan)


@overload
def hertz_smoothing_for_width(*, threshold: Scalar, transition_width: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_smoothing_for_width(*, threshold: Scalar | Array, transition_width: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_smoothing_for_width(*, threshold: Scalar | Array | PandasSeries, transition_width: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_smoothing_for_width(*, threshold: Scalar | Array | Frame, transition_width: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_smoothing_for_width(*, threshold: Number, transition_width: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bd for a wanted width of the contact transition.

        bd = 2 atanh(1 − 2 t) / (Δx̂ R)    (C.8)

    Parameters
    ----------
    threshold : float or array_like
        t: threshold on a smoothed step, such as 0.05; without unit.
    transition_width : float or array_like
        Δx̂: relative indentation from s_c = t to s_c = 1 − t; without unit.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.8): Van Bijlert (2026), appendix C.2; (C.7) solved for bd.

    Examples
    --------
    >>> round(scaling.hertz_smoothing_for_width(threshold=0.05, transition_width=0.3, radius=0.032), 2)
    306.71
    """
    return call("hertz_smoothing_for_width", {"threshold": threshold, "transition_width": transition_width, "radius": radius}, nan)


@overload
def hunt_crossley_smoothing_for_radius(*, reduced_hunt_crossley_smoothing: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_smoothing_for_radius(*, reduced_hunt_crossley_smoothing: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_smoothing_for_radius(*, reduced_hunt_crossley_smoothing: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_smoothing_for_radius(*, reduced_hunt_crossley_smoothing: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_smoothing_for_radius(*, reduced_hunt_crossley_smoothing: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bv from the sphere's radius, or for a wanted width.

        bv = b_ẋ / √R    (C.10)

    Parameters
    ----------
    reduced_hunt_crossley_smoothing : float or array_like
        b_ẋ: bv with only the radius taken out, bv √R; in s/√m.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.10): Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> round(scaling.hunt_crossley_smoothing_for_radius(reduced_hunt_crossley_smoothing=9, radius=0.04), 6)
    45.0
    """
    return call("hunt_crossley_smoothing_for_radius", {"reduced_hunt_crossley_smoothing": reduced_hunt_crossley_smoothing, "radius": radius}, nan)


@overload
def hunt_crossley_smoothing_for_speed_width(*, threshold: Scalar, speed_width: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_smoothing_for_speed_width(*, threshold: Scalar | Array, speed_width: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_smoothing_for_speed_width(*, threshold: Scalar | Array | PandasSeries, speed_width: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_smoothing_for_speed_width(*, threshold: Scalar | Array | Frame, speed_width: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_smoothing_for_speed_width(*, threshold: Number, speed_width: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bv from the sphere's radius, or for a wanted width, from a speed.

        bv = 2 atanh(1 − 2 t) / Δv    (C.10)

    Parameters
    ----------
    threshold : float or array_like
        t: threshold on a smoothed step, such as 0.05; without unit.
    speed_width : float or array_like
        Δv: speed over which the step goes from t to 1 − t; in m/s.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.10): Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> round(scaling.hunt_crossley_smoothing_for_speed_width(threshold=0.05, speed_width=0.1), 3)
    29.444
    """
    return call("hunt_crossley_smoothing_for_speed_width", {"threshold": threshold, "speed_width": speed_width}, nan)


@overload
def hunt_crossley_smoothing_for_reduced_width(*, threshold: Scalar, reduced_speed_width: Scalar, radius: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_smoothing_for_reduced_width(*, threshold: Scalar | Array, reduced_speed_width: Scalar | Array, radius: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_smoothing_for_reduced_width(*, threshold: Scalar | Array | PandasSeries, reduced_speed_width: Scalar | Array | PandasSeries, radius: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_smoothing_for_reduced_width(*, threshold: Scalar | Array | Frame, reduced_speed_width: Scalar | Array | Frame, radius: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_smoothing_for_reduced_width(*, threshold: Number, reduced_speed_width: Number, radius: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bv from the sphere's radius, or for a wanted width, as printed.

        bv = 2 atanh(1 − 2 t) / (Δẋ √R)    (C.10)

    Parameters
    ----------
    threshold : float or array_like
        t: threshold on a smoothed step, such as 0.05; without unit.
    reduced_speed_width : float or array_like
        Δẋ: Δv / √R; in √m/s.
    radius : float or array_like
        R: radius of the sphere (OpenSim: radius); in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.10): Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> round(scaling.hunt_crossley_smoothing_for_reduced_width(threshold=0.05, reduced_speed_width=0.5,
    ...     radius=0.04), 3)
    29.444
    """
    return call("hunt_crossley_smoothing_for_reduced_width", {"threshold": threshold, "reduced_speed_width": reduced_speed_width, "radius": radius}, nan)


@overload
def plane_strain_modulus(*, mass_ratio: Scalar, sphere_count_ratio: Scalar, radius_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def plane_strain_modulus(*, mass_ratio: Scalar | Array, sphere_count_ratio: Scalar | Array, radius_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def plane_strain_modulus(*, mass_ratio: Scalar | Array | PandasSeries, sphere_count_ratio: Scalar | Array | PandasSeries, radius_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def plane_strain_modulus(*, mass_ratio: Scalar | Array | Frame, sphere_count_ratio: Scalar | Array | Frame, radius_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def plane_strain_modulus(*, mass_ratio: Number, sphere_count_ratio: Number, radius_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """How the modulus grows with body size at the same relative indentation.

        E* ∝ M / (n R²)    (8)
        E*_b / E*_a = (M_b / M_a) (n_a / n_b) (R_a² / R_b²)    (9)
        E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a    (10)

    where

        M: body mass; in kg
        n: spheres that share the load; without unit
        E*_b: composite plane strain modulus of b, the model; in N/m²
        E*_a: composite plane strain modulus of a, the reference; in N/m²
        M_b: body mass of b, the model; in kg
        M_a: body mass of a, the reference; in kg
        n_a: spheres that share the load of a, the reference; without unit
        n_b: spheres that share the load of b, the model; without unit

    Parameters
    ----------
    mass_ratio : float or array_like
        M_b / M_a: body mass of b, the model, divided by that of a, the reference; without unit.
    sphere_count_ratio : float or array_like
        n_b / n_a: spheres that share the load of b, the model, divided by those of a, the reference; without unit.
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of E*: composite plane strain modulus of the contact.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (8): Van Bijlert (2026), section 2. With geometric similarity R ∝ M^(1/3), so E* ∝ M^(1/3) too: this is what sets isometric radii.
    (9): Van Bijlert (2026), section 2.1; it is (8) for a and b.
    (10): Van Bijlert (2026), section 2.1. It holds for E₁* (OpenSim's stiffness) as well, since both surfaces are equal (A.4). With another gravity also × g_b / g_a (an extension).

    Examples
    --------
    >>> round(scaling.plane_strain_modulus(mass_ratio=545 / 62, sphere_count_ratio=10 / 6,
    ...     radius_ratio=0.015 / 0.032), 2)
    24.0
    """
    return call("plane_strain_modulus", {"mass_ratio": mass_ratio, "sphere_count_ratio": sphere_count_ratio, "radius_ratio": radius_ratio, "gravity_ratio": gravity_ratio}, nan)


@overload
def dissipation(*, radius_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dissipation(*, radius_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dissipation(*, radius_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dissipation(*, radius_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dissipation(*, radius_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """How dissipation follows body size at the same restitution.

        α ∝ R^(−1/2)    (14)

    where

        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of α: Hunt–Crossley dissipation (OpenSim: dissipation).

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (14): Van Bijlert (2026), section 2.3. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> scaling.dissipation(radius_ratio=4)
    0.5
    >>> scaling.dissipation(radius_ratio=[0.0625, 1])
    array([4., 1.])
    """
    return call("dissipation", {"radius_ratio": radius_ratio, "gravity_ratio": gravity_ratio}, nan)


@overload
def dissipation_by_mass(*, mass_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def dissipation_by_mass(*, mass_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def dissipation_by_mass(*, mass_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def dissipation_by_mass(*, mass_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def dissipation_by_mass(*, mass_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """How dissipation follows body size at the same restitution, by mass.

        α ∝ M^(−1/6)    (14)

    where

        M: body mass; in kg

    Parameters
    ----------
    mass_ratio : float or array_like
        M_b / M_a: body mass of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of α: Hunt–Crossley dissipation (OpenSim: dissipation).

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (14): Van Bijlert (2026), section 2.3. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> round(scaling.dissipation_by_mass(mass_ratio=64), 6)
    0.5
    """
    return call("dissipation_by_mass", {"mass_ratio": mass_ratio, "gravity_ratio": gravity_ratio}, nan)


@overload
def constant_contact_force(*, radius_ratio: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def constant_contact_force(*, radius_ratio: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def constant_contact_force(*, radius_ratio: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def constant_contact_force(*, radius_ratio: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def constant_contact_force(*, radius_ratio: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """cf for a wanted constant relative indentation, from a to b.

        cf ∝ R²    (C.2)

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.2): Van Bijlert (2026), appendix C.1. A start: x̂_c = 0.1, or 0.05 where x̂ below 0.16 is wanted.

    Examples
    --------
    >>> scaling.constant_contact_force(radius_ratio=0.5)
    0.25
    """
    return call("constant_contact_force", {"radius_ratio": radius_ratio}, nan)


@overload
def hertz_smoothing(*, radius_ratio: Scalar, nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hertz_smoothing(*, radius_ratio: Scalar | Array, nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hertz_smoothing(*, radius_ratio: Scalar | Array | PandasSeries, nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hertz_smoothing(*, radius_ratio: Scalar | Array | Frame, nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hertz_smoothing(*, radius_ratio: Number, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bd from a pure number, from a to b.

        bd ∝ 1/R    (C.5)

    where

        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of bd: how sharply contact begins (OpenSim: hertz_smoothing).

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.5): Van Bijlert (2026), appendix C.2. A start: b_x̂ = 10.

    Examples
    --------
    >>> scaling.hertz_smoothing(radius_ratio=0.0625)
    16.0
    """
    return call("hertz_smoothing", {"radius_ratio": radius_ratio}, nan)


@overload
def hunt_crossley_smoothing(*, radius_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def hunt_crossley_smoothing(*, radius_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def hunt_crossley_smoothing(*, radius_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def hunt_crossley_smoothing(*, radius_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def hunt_crossley_smoothing(*, radius_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """bv from the sphere's radius, or for a wanted width, from a to b.

        bv ∝ R^(−1/2)    (C.10)

    where

        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing).

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    (C.10): Van Bijlert (2026), appendix C.2. A start: b_ẋ = 9. The printed form takes Δv / √R, not a speed. With another gravity also × (g_b / g_a)^(−1/2) (an extension).

    Examples
    --------
    >>> scaling.hunt_crossley_smoothing(radius_ratio=0.25)
    2.0
    """
    return call("hunt_crossley_smoothing", {"radius_ratio": radius_ratio, "gravity_ratio": gravity_ratio}, nan)


@overload
def transition_velocity(*, radius_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def transition_velocity(*, radius_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def transition_velocity(*, radius_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def transition_velocity(*, radius_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def transition_velocity(*, radius_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """How friction speeds follow body size.

        transition_velocity ∝ √(g R)    friction

    where

        g: gravity; in m/s²
        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of transition_velocity: slip speed at which friction is fully there.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    friction: beyond the paper: speeds grow as √(g R). Friction coefficients do not depend on size, and stay. The friction of SmoothSphereHalfSpaceForce is similar only in part.

    Examples
    --------
    >>> scaling.transition_velocity(radius_ratio=4)
    2.0
    """
    return call("transition_velocity", {"radius_ratio": radius_ratio, "gravity_ratio": gravity_ratio}, nan)


@overload
def viscous_friction(*, radius_ratio: Scalar, gravity_ratio: Scalar = ..., nan: Literal["raise", "propagate"] = ...) -> float: ...
@overload
def viscous_friction(*, radius_ratio: Scalar | Array, gravity_ratio: Scalar | Array = ..., nan: Literal["raise", "propagate"] = ...) -> Floats: ...
@overload
def viscous_friction(*, radius_ratio: Scalar | Array | PandasSeries, gravity_ratio: Scalar | Array | PandasSeries = ..., nan: Literal["raise", "propagate"] = ...) -> PandasFloats: ...
@overload
def viscous_friction(*, radius_ratio: Scalar | Array | Frame, gravity_ratio: Scalar | Array | Frame = ..., nan: Literal["raise", "propagate"] = ...) -> Frame: ...
def viscous_friction(*, radius_ratio: Number, gravity_ratio: Number = 1.0, nan: Literal["raise", "propagate"] = "raise") -> Any:
    """How friction speeds follow body size.

        viscous_friction ∝ 1/√(g R)    friction

    where

        g: gravity; in m/s²
        R: radius of the sphere (OpenSim: radius); in m

    Parameters
    ----------
    radius_ratio : float or array_like
        R_b / R_a: radius of the spheres of b, the model, divided by that of a, the reference; without unit.
    gravity_ratio : float or array_like, default 1
        g_b / g_a: gravity where b, the model, lives, divided by that of a, the reference; without unit.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", an element that has it in any argument is NaN, and not looked at further.

    Returns
    -------
    float, numpy.ndarray, Series or DataFrame
        The factor, without unit, of viscous_friction: friction that grows with slip speed.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.
        Arguments whose shapes or indexes do not go together.

    References
    ----------
    friction: beyond the paper: speeds grow as √(g R). Friction coefficients do not depend on size, and stay. The friction of SmoothSphereHalfSpaceForce is similar only in part.

    Examples
    --------
    >>> scaling.viscous_friction(radius_ratio=4)
    0.5
    """
    return call("viscous_friction", {"radius_ratio": radius_ratio, "gravity_ratio": gravity_ratio}, nan)


def mean_square_radius(*, radius: NumberList, nan: Literal["raise", "propagate"] = "raise") -> float:
    """One radius for spheres of different size.

        R² = Σ R_i² / n    mixed radii

    where

        n: spheres that share the load; without unit

    Parameters
    ----------
    radius : sequence of float
        R_i: radius of sphere i; in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", the result is NaN where any number of any list is.

    Returns
    -------
    float
        R²: square of the radius that n equal spheres would have; in m².

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.

    References
    ----------
    mixed radii: beyond the paper: (3) summed over spheres of equal x̂ and E*.

    Examples
    --------
    >>> round(scaling.mean_square_radius(radius=[0.03, 0.04]), 6)
    0.00125
    """
    return call_of_list("mean_square_radius", {"radius": radius}, nan=nan)


def hertz_rest_indentation(*, load: float, composite_modulus: float | NumberList, radius: float | NumberList, number_of_spheres: float | NumberList = 1.0, height: NumberList | None = None, nan: Literal["raise", "propagate"] = "raise") -> float:
    """Indentation at rest by the Hertz law.

        Σ 4/3 E*_i √R_i x^(3/2) = F    rest by (1)
        Σ 4/3 E*_i √R_i max(0, x − h_i)^(3/2) = F    rest at own heights

    Parameters
    ----------
    load : float
        F: load on all spheres together; in N.
    composite_modulus : sequence of float
        E*_i: composite plane strain modulus of sphere i; in N/m².
    radius : sequence of float
        R_i: radius of sphere i; in m.
    number_of_spheres : sequence of float, default 1
        n_i: how many spheres are like sphere i, itself included; without unit.
    height : sequence of float, optional
        h_i: height of the bottom of sphere i above the lowest; in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", the result is NaN where any number of any list is.

    Returns
    -------
    float
        x: indentation: how far sphere and ground overlap; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.

    References
    ----------
    rest by (1): beyond the paper: (1) summed over spheres whose bottoms are level.
    rest at own heights: beyond the paper: (1) and (C.9) summed over spheres whose bottoms are h_i above the lowest, as at the default pose.

    Examples
    --------
    >>> round(scaling.hertz_rest_indentation(load=120, composite_modulus=3e5, radius=[0.04, 0.01]), 6)
    0.01
    """
    return call_of_list("hertz_rest_indentation", {"composite_modulus": composite_modulus, "radius": radius, "number_of_spheres": number_of_spheres}, height, load, nan=nan)


def smooth_rest_indentation(*, load: float, composite_modulus: float | NumberList, radius: float | NumberList, dissipation: float | NumberList, constant_contact_force: float | NumberList, hertz_smoothing: float | NumberList, hunt_crossley_smoothing: float | NumberList, number_of_spheres: float | NumberList = 1.0, height: NumberList | None = None, nan: Literal["raise", "propagate"] = "raise") -> float:
    """Indentation at rest by the file's law.

        Σ F_i(x, ẋ = 0) = F    rest by (C.9)
        Σ F_i(x − h_i, ẋ = 0) = F    rest at own heights

    where

        F_i: smoothed contact force of sphere i; in N
        ẋ: rate of indentation, above 0 while the sphere sinks in; in m/s

    Parameters
    ----------
    load : float
        F: load on all spheres together; in N.
    composite_modulus : sequence of float
        E*_i: composite plane strain modulus of sphere i; in N/m².
    radius : sequence of float
        R_i: radius of sphere i; in m.
    dissipation : sequence of float
        α: Hunt–Crossley dissipation (OpenSim: dissipation); in s/m.
    constant_contact_force : sequence of float
        cf: a squared indentation, in spite of its name in OpenSim: constant_contact_force; in m².
    hertz_smoothing : sequence of float
        bd: how sharply contact begins (OpenSim: hertz_smoothing); in 1/m.
    hunt_crossley_smoothing : sequence of float
        bv: how sharply the force is cut off (OpenSim: hunt_crossley_smoothing); in s/m.
    number_of_spheres : sequence of float, default 1
        n_i: how many spheres are like sphere i, itself included; without unit.
    height : sequence of float, optional
        h_i: height of the bottom of sphere i above the lowest; in m.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", the result is NaN where any number of any list is.

    Returns
    -------
    float
        x: indentation: how far sphere and ground overlap; in m.

    Raises
    ------
    RequestError
        A value outside of the domain, by its argument and element.

    References
    ----------
    rest by (C.9): beyond the paper: (C.9) at ẋ = 0 summed over spheres whose bottoms are level.
    rest at own heights: beyond the paper: (1) and (C.9) summed over spheres whose bottoms are h_i above the lowest, as at the default pose.

    Examples
    --------
    >>> round(scaling.smooth_rest_indentation(load=120, composite_modulus=3e5, radius=[0.04, 0.01], dissipation=2,
    ...     constant_contact_force=1e-5, hertz_smoothing=300, hunt_crossley_smoothing=50), 6)
    0.00951
    """
    return call_of_list("smooth_rest_indentation", {"composite_modulus": composite_modulus, "radius": radius, "dissipation": dissipation, "constant_contact_force": constant_contact_force, "hertz_smoothing": hertz_smoothing, "hunt_crossley_smoothing": hunt_crossley_smoothing, "number_of_spheres": number_of_spheres}, height, load, nan=nan)


def continuation_steps(*, first: float, last: float, dissipation_ratio: float = 1.0, count: int = 5, nan: Literal["raise", "propagate"] = "raise") -> Steps:
    """Steps from soft contacts to those that are wanted, for a ladder of optimisations (section 4.3 of the paper).

    Parameters
    ----------
    first, last : float
        Dimensionless stiffness k̂ (B.3) at the load of the first and the last step; without unit.
    dissipation_ratio : float, default 1
        What α begins with, over its last value; without unit.
    count : int, default 5
        How many steps, the last one included.
    nan : {"raise", "propagate"}, default "raise"
        Whether NaN is an error. With "propagate", all steps are NaN where any number is.

    Returns
    -------
    Steps
        Arrays of float64: `dimensionless_stiffness`, and what E* and α of the last step are multiplied by, `modulus_factor` and
        `dissipation_factor`; without unit.

    Examples
    --------
    >>> steps = scaling.continuation_steps(first=1, last=16, dissipation_ratio=4, count=3)
    >>> steps.modulus_factor.round(6).tolist(), steps.dissipation_factor.round(6).tolist()
    ([0.015625, 0.125, 1.0], [4.0, 2.0, 1.0])
    """
    return call_of_steps(first, last, dissipation_ratio, count, nan)
