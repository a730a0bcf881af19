"""Types of the fields of answers. Written by dev/generate_python.py from the schemas of results: do not edit."""

from __future__ import annotations

from typing import TypedDict


class DropDifferenceRecord(TypedDict):
    other: str
    until_dimensionless_time: float
    height_over_radius: float
    force_bw: float


class DropSeriesRecord(TypedDict):
    time_s: list[float]
    height_m: list[float]
    speed_m_s: list[float]
    force_n: list[float]
    force_bw: list[float]
    dimensionless_time: list[float]


class MotionComparisonRecord(TypedDict):
    frames: int
    normal_rms_n: float
    vertical_rms_bw: float
    horizontal_rms_n: float
    horizontal_rms_bw: float
    peak_n: float
    measured_peak_n: float
    cop_rms_m: float | None
    cop_frames: int


class MotionFootRecord(TypedDict):
    name: str
    side: str | None
    bodies: list[str]
    peak_n: float
    peak_at_s: float
    stands_by_plates: bool
    stance_depth_m: float | None
    stance_scatter_m: float | None
    lost_in_stride_j: float | None
    deepest_m: float
    stance_slip_m_s: list[float] | None
    stances: list[MotionStanceRecord]
    spheres: list[MotionSphereRecord]
    cop_ahead_m: float | None
    cop_right_m: float | None
    comparison: MotionComparisonRecord | None


class MotionStanceRecord(TypedDict):
    on_s: float | None
    off_s: float | None
    peak_n: float
    impulse_n_s: float
    loading_rate_n_s: float


class MotionSphereRecord(TypedDict):
    sphere: str
    force: str
    peak_n: float
    largest_relative_indentation: float
    largest_at_s: float
    mean_stress_n_m2: float | None
    peak_stress_n_m2: float | None
    beyond_hertz_s: float
    beyond_radius_s: float
    slip_m_s: float | None
    touch_downs: list[MotionTouchDownRecord]


class MotionTouchDownRecord(TypedDict):
    time_s: float
    impact_speed_m_s: float
    restitution: float | None


class ConsistencyRecord(TypedDict):
    verdict: str
    why: str
    vertical_rms_bw: list[CorrectedErrorRecord]
    horizontal_rms_bw: list[CorrectedErrorRecord]
    cop_rms_m: float | None
    floor_up_m: float | None
    belt_m_per_s: list[float] | None
    lift_rms_m: float | None
    lift_p95_m: float | None
    joint_rms_rad: float | None
    left_minus_right_m: float | None
    largest_relative_indentation: float | None
    root_residual: RootResidualRecord | None
    joint_moment_change_nm: JointMomentsRecord | None


class CorrectedErrorRecord(TypedDict):
    foot: str
    before: float
    after: float
    null: float


class RootResidualRecord(TypedDict):
    vertical: ResidualRecord
    horizontal: ResidualRecord
    moment: ResidualRecord


class ResidualRecord(TypedDict):
    before: float | None
    after: float | None
    with_plates: float | None


class JointMomentsRecord(TypedDict):
    hip: float | None
    knee: float | None
    ankle: float | None


class MotionRemarkRecord(TypedDict):
    code: str
    message: str


class EstimateRecord(TypedDict):
    value: float | None
    standard_error: float | None
    low_95: float | None
    high_95: float | None


class FitWarningRecord(TypedDict):
    code: str
    message: str


class ResidualsRecord(TypedDict):
    line: list[int]
    force_n: list[float]


class DesignFigure(TypedDict):
    name: str
    value: float | None
    unit: str
    equation: str
    given: bool
    limit: DesignLimit | None


class DesignLimit(TypedDict):
    text: str
    within_limit: bool


class Dimensionless(TypedDict):
    modulus: float
    relative_indentation: float
    dissipation: float
    constant_indentation: float | None
    hertz_smoothing: float | None
    hunt_crossley_smoothing: float | None


class AnimalRecord(TypedDict):
    taxon: str
    mass_kg: float
    sphere_count: float
    radius_m: float
    values: list[NumberRecord]


class NumberRecord(TypedDict):
    name: str
    unit: str
    equation: str
    printed: str
    computed: float
    difference: float
    relative_difference: float
    within_last_digit: bool
    computed_from_rounded: float | None


class FormulaRecord(TypedDict):
    variant: str
    formula: str
    ascii: str
    unit: str


class SymbolRecord(TypedDict):
    symbol: str
    ascii: str
    meaning: str
    unit: str


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
    compare: DropDifferenceRecord | None


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
    comparison: MotionComparisonRecord | None
    feet: list[MotionFootRecord]
    consistency: ConsistencyRecord
    remarks: list[MotionRemarkRecord]


class FitFields:
    __slots__ = ()

    file: str
    sphere_count: float
    radius_m: float
    composite_modulus_n_m2: EstimateRecord
    stiffness: EstimateRecord
    dissipation: EstimateRecord | None
    onset_m: EstimateRecord | None
    parameters: list[str]
    covariance: list[list[float | None]]
    warnings: list[FitWarningRecord]
    r_squared: float
    degrees_of_freedom: int
    residual_deviation_n: float | None
    largest_relative_indentation: float
    within_hertz_limit: bool
    largest_speed_m_s: float | None
    restitution: float | None
    within_hunt_crossley_limit: bool | None
    residuals: ResidualsRecord


class DesignSheetFields:
    __slots__ = ()

    figures: list[DesignFigure]
    remarks: list[str]
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
    dimensionless: Dimensionless


class ReproductionFields:
    __slots__ = ()

    table1: list[AnimalRecord]
    numbers: int
    within_last_digit: int
    fig1: list[str]


class ExplanationFields:
    __slots__ = ()

    kind: str
    label: str
    title: str
    formulas: list[FormulaRecord]
    symbols: list[SymbolRecord] | list[str]
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
