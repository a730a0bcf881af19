"""Types of the numbers and texts of answers. Written by dev/generate_python.py from the schemas of results: do not edit."""

from __future__ import annotations


class DropTestFields:
    __slots__ = ()

    model: str
    mass_kg: float
    sphere_count: float
    gravity_m_s2: float
    height_m: float
    duration_s: float
    reference_radius_m: float
    reference_time_s: float
    final_relative_indentation: float
    relative_indentation_hertz: float
    relative_indentation_model_law: float
    peak_force_n: float
    peak_force_bw: float
    equilibrium_stiffness_n_m: float
    hertz_stiffness_n_m: float
    impact_speed_m_s: float | None
    restitution_exact: float | None
    restitution_approximate: float | None
    contact_time_s: float | None
    rebound_speed_m_s: float | None


class MotionFields:
    __slots__ = ()

    model: str
    motion: str
    frames: int
    from_s: float
    to_s: float
    mass_kg: float
    gravity_m_s2: float
    weight_n: float
    stride_mean_n: float | None
    measured_stride_mean_n: float | None
    double_support: float | None
    peak_n: float


class FitFields:
    __slots__ = ()

    file: str
    sphere_count: float
    radius_m: float
    r_squared: float
    degrees_of_freedom: int
    residual_deviation_n: float | None
    largest_relative_indentation: float
    within_hertz_limit: bool
    largest_speed_m_s: float | None
    restitution: float | None
    within_hunt_crossley_limit: bool | None


class DesignSheetFields:
    __slots__ = ()

    load_per_sphere_n: float
    radius_m: float
    relative_indentation: float
    indentation_m: float
    composite_modulus_n_m2: float
    stiffness: float
    first_modulus_n_m2: float
    other_modulus_n_m2: float
    composite_modulus_opensim_n_m2: float
    opensim_over_johnson: float
    contact_stiffness_n_m: float
    dimensionless_stiffness: float
    mean_contact_stress_n_m2: float
    contact_patch_diameter_m: float
    natural_frequency_hz: float
    equilibrium_frequency_hz: float
    impact_speed_m_s: float
    restitution: float
    dissipation: float
    restitution_exact_at_this_dissipation: float
    dissipation_for_exact_restitution_s_m: float
    constant_contact_force: float
    hertz_smoothing: float
    hunt_crossley_smoothing: float
    force_just_touching_n: float


class PresetFields:
    __slots__ = ()

    name: str
    source: str
    mass_kg: float
    spheres: float
    radius_m: float
    gravity_m_s2: float
    stiffness: float
    dissipation: float
    constant_contact_force: float | None
    hertz_smoothing: float | None
    hunt_crossley_smoothing: float | None


class ReproductionFields:
    __slots__ = ()

    numbers: int
    within_last_digit: int


class ExplanationFields:
    __slots__ = ()

    kind: str
    label: str
    title: str
    source: str
    used: str
    name: str
    unit: str
    equation: str
    limit: str | None
    what: str
    trap: str
    code: str
    severity: str
    checked: bool
    why: str
    advice: str
    fix: str | None
    why_no_fix: str | None
    means: str
    way_out: str
