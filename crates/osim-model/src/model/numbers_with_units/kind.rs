//! The kinds of numbers that change with body size, and the properties of OpenSim classes that have these kinds.

use self::SizedKind::*;

/// A dimension: the powers of mass, length and time in a unit. N, which is kg m s^-2, is `1, 1, -2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension {
    /// Exponent of kg in the unit.
    pub mass: i8,
    /// Exponent of m in the unit.
    pub length: i8,
    /// Exponent of s in the unit.
    pub time: i8,
}

const fn powers(mass: i8, length: i8, time: i8) -> Dimension {
    Dimension { mass, length, time }
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident, $code:literal, $words:literal, $unit:literal, $mass:literal $length:literal $time:literal;)*) => {
        /// A kind of number that changes with body size. Lists use this order.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum SizedKind {
            $($(#[$doc])* $name,)*
        }

        impl SizedKind {
            /// All kinds, in the order of lists.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// Name of the kind, a word for scripts.
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$name => $code,)* }
            }

            /// Name of the kind for people.
            pub const fn words(self) -> &'static str {
                match self { $(Self::$name => $words,)* }
            }

            /// Unit of the kind in OpenSim; an angle counts as 1.
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$name => $unit,)* }
            }

            pub const fn dimension(self) -> Dimension {
                match self { $(Self::$name => powers($mass, $length, $time),)* }
            }
        }
    };
}

kinds! {
    /// The trace of the inertia of a body.
    Inertia, "inertia", "inertia of body", "kg m²", 1 2 0;
    /// `max_isometric_force` of a muscle.
    MaxIsometricForce, "max_isometric_force", "max isometric force", "N", 1 1 -2;
    /// `optimal_fiber_length` of a muscle.
    OptimalFiberLength, "optimal_fiber_length", "optimal fiber length", "m", 0 1 0;
    /// `tendon_slack_length` of a muscle.
    TendonSlackLength, "tendon_slack_length", "tendon slack length", "m", 0 1 0;
    /// `max_contraction_velocity` of a muscle, in optimal fiber lengths per second.
    MaxContractionVelocity, "max_contraction_velocity", "max contraction velocity", "1/s", 0 0 -1;
    /// `activation_time_constant` of a muscle.
    ActivationTime, "activation_time_constant", "activation time", "s", 0 0 1;
    /// `deactivation_time_constant` of a muscle.
    DeactivationTime, "deactivation_time_constant", "deactivation time", "s", 0 0 1;
    /// `time_scale` of a muscle of a deprecated class.
    TimeScale, "time_scale", "time scale of muscle", "s", 0 0 1;
    /// Slack or resting length of a ligament.
    LigamentLength, "ligament_length", "ligament slack length", "m", 0 1 0;
    /// `pcsa_force` of a ligament, or `linear_stiffness`, the force per strain.
    LigamentForce, "ligament_force", "ligament force", "N", 1 1 -2;
    /// `damping_coefficient` of a ligament, which multiplies its strain per second.
    LigamentDamping, "ligament_damping", "ligament damping time", "s", 0 0 1;
    /// `stiffness` of a spring between points or along a path.
    SpringStiffness, "spring_stiffness", "spring stiffness", "N/m", 1 0 -2;
    /// Rest length of such a spring.
    SpringLength, "spring_length", "spring rest length", "m", 0 1 0;
    /// `dissipation` of a spring along a path.
    SpringDissipation, "spring_dissipation", "spring dissipation", "s/m", 0 -1 1;
    /// `relaxation_time_constant` of a spring with a clutch.
    SpringTime, "spring_time", "spring time constant", "s", 0 0 1;
    /// `translational_stiffness` of a bushing.
    BushingStiffness, "bushing_stiffness", "bushing stiffness", "N/m", 1 0 -2;
    /// `rotational_stiffness` of a bushing.
    BushingRotationalStiffness, "bushing_rotational_stiffness", "bushing rotational stiffness", "N m/rad", 1 2 -2;
    /// `translational_damping` of a bushing.
    BushingDamping, "bushing_damping", "bushing damping", "N s/m", 1 0 -1;
    /// `rotational_damping` of a bushing.
    BushingRotationalDamping, "bushing_rotational_damping", "bushing rotational damping", "N m s/rad", 1 2 -1;
    /// `stiffness` of a spring on an angle.
    CoordinateRotationalStiffness, "coordinate_rotational_stiffness", "stiffness on angle", "N m/rad", 1 2 -2;
    /// `viscosity` of a spring on an angle.
    CoordinateRotationalDamping, "coordinate_rotational_damping", "viscosity on angle", "N m s/rad", 1 2 -1;
    /// `stiffness` of a spring on a translation.
    CoordinateStiffness, "coordinate_stiffness", "stiffness on translation", "N/m", 1 0 -2;
    /// `viscosity` of a spring on a translation.
    CoordinateDamping, "coordinate_damping", "viscosity on translation", "N s/m", 1 0 -1;
    /// `rest_length` of a spring on a translation.
    CoordinateLength, "coordinate_length", "rest length on translation", "m", 0 1 0;
    /// `upper_stiffness` and `lower_stiffness` of a limit of an angle.
    LimitRotationalStiffness, "limit_rotational_stiffness", "limit stiffness, angle", "N m/degree", 1 2 -2;
    /// `damping` of a limit of an angle.
    LimitRotationalDamping, "limit_rotational_damping", "limit damping, angle", "N m s/degree", 1 2 -1;
    /// `upper_stiffness` and `lower_stiffness` of a limit of a translation.
    LimitStiffness, "limit_stiffness", "limit stiffness, translation", "N/m", 1 0 -2;
    /// `damping` of a limit of a translation.
    LimitDamping, "limit_damping", "limit damping, translation", "N s/m", 1 0 -1;
    /// `upper_limit`, `lower_limit` and `transition` of a limit of a translation.
    LimitLength, "limit_length", "limit length, translation", "m", 0 1 0;
    /// `optimal_force` of an actuator that pulls or pushes.
    ActuatorForce, "actuator_force", "actuator force", "N", 1 1 -2;
    /// `optimal_force` of an actuator that turns.
    ActuatorTorque, "actuator_torque", "actuator torque", "N m", 1 2 -2;
    /// `activation_time_constant` of an actuator.
    ActuatorTime, "actuator_time", "actuator activation time", "s", 0 0 1;
    /// Bounds of the times at which a Moco problem begins and ends.
    MocoTime, "moco_time", "Moco bound of time", "s", 0 0 1;
    /// Moco's bounds of translations.
    MocoTranslation, "moco_translation", "Moco bound of translation", "m", 0 1 0;
    /// Moco's bounds of the speeds of translations.
    MocoSpeed, "moco_speed", "Moco bound of speed", "m/s", 0 1 -1;
    /// Moco's bounds of the speeds of angles.
    MocoAngularSpeed, "moco_angular_speed", "Moco bound of angular speed", "rad/s", 0 0 -1;
}

impl SizedKind {
    /// Whether the kind is a bound in a Moco problem, which is in a separate file.
    pub(crate) const fn is_of_moco(self) -> bool {
        matches!(self, Self::MocoTime | Self::MocoTranslation | Self::MocoSpeed | Self::MocoAngularSpeed)
    }

    /// Index of the kind in lists, for sorting.
    pub const fn order(self) -> usize {
        self as usize
    }
}

// Which properties of which classes have mass, length or time in their unit, and what OpenSim 4.6 takes where a file says nothing.
//
// The defaults are those that `OpenSimObject.newInstanceOfType` of OpenSim 4.6 has.

/// What kind of number a property has: always one kind, or one that depends on its coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) enum SizedKindRule {
    Always(SizedKind),
    /// A property of a force on a coordinate. The first kind is for a coordinate that is an angle (`None`: the number has no dimension),
    /// the second for a translation.
    ByCoordinate(Option<SizedKind>, SizedKind),
}

/// A property of an OpenSim class whose value changes with body size.
#[derive(Debug, Clone, Copy)]
pub(super) struct SizedProperty {
    pub(super) tag: &'static str,
    pub(super) kind: SizedKindRule,
    /// The value that OpenSim uses if the file has none.
    pub(super) default: f64,
    pub(super) count: usize,
}

const fn one_number(tag: &'static str, kind: SizedKind, default: f64) -> SizedProperty {
    SizedProperty { tag, kind: SizedKindRule::Always(kind), default, count: 1 }
}

const fn three_numbers(tag: &'static str, kind: SizedKind) -> SizedProperty {
    SizedProperty { tag, kind: SizedKindRule::Always(kind), default: 0.0, count: 3 }
}

const fn on_coordinate(
    tag: &'static str,
    turns: Option<SizedKind>,
    shifts: SizedKind,
    default: f64,
) -> SizedProperty {
    SizedProperty { tag, kind: SizedKindRule::ByCoordinate(turns, shifts), default, count: 1 }
}

const MAX_FORCE: SizedProperty = one_number("max_isometric_force", MaxIsometricForce, 1000.0);
const FIBER_LENGTH: SizedProperty = one_number("optimal_fiber_length", OptimalFiberLength, 0.1);
const TENDON_LENGTH: SizedProperty = one_number("tendon_slack_length", TendonSlackLength, 0.2);
const MAX_VELOCITY: SizedProperty = one_number("max_contraction_velocity", MaxContractionVelocity, 10.0);
const TIME_SCALE: SizedProperty = one_number("time_scale", TimeScale, 0.1);

const fn activation_time(default: f64) -> SizedProperty {
    one_number("activation_time_constant", ActivationTime, default)
}

const fn deactivation_time(default: f64) -> SizedProperty {
    one_number("deactivation_time_constant", DeactivationTime, default)
}

const RIGID_TENDON_MUSCLE: &[SizedProperty] = &[MAX_FORCE, FIBER_LENGTH, TENDON_LENGTH, MAX_VELOCITY];
const THELEN_MUSCLE: &[SizedProperty] =
    &[MAX_FORCE, FIBER_LENGTH, TENDON_LENGTH, MAX_VELOCITY, activation_time(0.015), deactivation_time(0.05)];
const OLD_THELEN_MUSCLE: &[SizedProperty] = &[
    MAX_FORCE,
    FIBER_LENGTH,
    TENDON_LENGTH,
    one_number("Vmax", MaxContractionVelocity, 10.0),
    activation_time(0.01),
    deactivation_time(0.04),
];
const MILLARD_MUSCLE: &[SizedProperty] =
    &[MAX_FORCE, FIBER_LENGTH, TENDON_LENGTH, MAX_VELOCITY, activation_time(0.01), deactivation_time(0.04)];
const DE_GROOTE_MUSCLE: &[SizedProperty] =
    &[MAX_FORCE, FIBER_LENGTH, TENDON_LENGTH, MAX_VELOCITY, activation_time(0.015), deactivation_time(0.06)];
const TIME_SCALED_MUSCLE: &[SizedProperty] = &[MAX_FORCE, FIBER_LENGTH, TENDON_LENGTH, TIME_SCALE];
const LIGAMENT: &[SizedProperty] =
    &[one_number("resting_length", LigamentLength, 0.0), one_number("pcsa_force", LigamentForce, 0.0)];
const BLANKEVOORT_LIGAMENT: &[SizedProperty] = &[
    one_number("slack_length", LigamentLength, 0.0),
    one_number("linear_stiffness", LigamentForce, 1.0),
    one_number("damping_coefficient", LigamentDamping, 0.003),
];
const PATH_SPRING: &[SizedProperty] = &[
    one_number("resting_length", SpringLength, f64::NAN),
    one_number("stiffness", SpringStiffness, f64::NAN),
    one_number("dissipation", SpringDissipation, f64::NAN),
];
const CLUTCHED_SPRING: &[SizedProperty] = &[
    one_number("stiffness", SpringStiffness, f64::NAN),
    one_number("dissipation", SpringDissipation, f64::NAN),
    one_number("relaxation_time_constant", SpringTime, 0.001),
];
const POINTS_SPRING: &[SizedProperty] =
    &[one_number("stiffness", SpringStiffness, 1.0), one_number("rest_length", SpringLength, 0.0)];
const EXPRESSION_PATH: &[SizedProperty] = &[one_number("resting_length", SpringLength, 0.0)];
const BUSHING: &[SizedProperty] = &[
    three_numbers("rotational_stiffness", BushingRotationalStiffness),
    three_numbers("translational_stiffness", BushingStiffness),
    three_numbers("rotational_damping", BushingRotationalDamping),
    three_numbers("translational_damping", BushingDamping),
];
const BUSHING_OF_FUNCTIONS: &[SizedProperty] = &[
    three_numbers("rotational_damping", BushingRotationalDamping),
    three_numbers("translational_damping", BushingDamping),
];
const COORDINATE_SPRING: &[SizedProperty] = &[
    on_coordinate("stiffness", Some(CoordinateRotationalStiffness), CoordinateStiffness, 0.0),
    on_coordinate("viscosity", Some(CoordinateRotationalDamping), CoordinateDamping, 0.0),
    on_coordinate("rest_length", None, CoordinateLength, 0.0),
];
const LIMIT_FORCE: &[SizedProperty] = &[
    on_coordinate("upper_stiffness", Some(LimitRotationalStiffness), LimitStiffness, 1.0),
    on_coordinate("lower_stiffness", Some(LimitRotationalStiffness), LimitStiffness, 1.0),
    on_coordinate("damping", Some(LimitRotationalDamping), LimitDamping, 0.001),
    on_coordinate("upper_limit", None, LimitLength, 0.0),
    on_coordinate("lower_limit", None, LimitLength, 0.0),
    on_coordinate("transition", None, LimitLength, 0.1),
];
const COORDINATE_ACTUATOR: &[SizedProperty] =
    &[on_coordinate("optimal_force", Some(ActuatorTorque), ActuatorForce, 1.0)];
const ACTIVATED_ACTUATOR: &[SizedProperty] = &[
    on_coordinate("optimal_force", Some(ActuatorTorque), ActuatorForce, 1.0),
    one_number("activation_time_constant", ActuatorTime, 0.01),
];
const FORCE_ACTUATOR: &[SizedProperty] = &[one_number("optimal_force", ActuatorForce, 1.0)];
const TORQUE_ACTUATOR: &[SizedProperty] = &[one_number("optimal_force", ActuatorTorque, 1.0)];

/// The properties of `class` that change with body size.
pub(super) fn sized_properties(class: &str) -> &'static [SizedProperty] {
    match class {
        "Thelen2003Muscle" => THELEN_MUSCLE,
        "Thelen2003Muscle_Deprecated" => OLD_THELEN_MUSCLE,
        "Millard2012EquilibriumMuscle" => MILLARD_MUSCLE,
        "DeGrooteFregly2016Muscle" | "MeyerFregly2016Muscle" => DE_GROOTE_MUSCLE,
        "RigidTendonMuscle" | "Millard2012AccelerationMuscle" => RIGID_TENDON_MUSCLE,
        "Schutte1993Muscle_Deprecated" | "Delp1990Muscle_Deprecated" => TIME_SCALED_MUSCLE,
        "Ligament" => LIGAMENT,
        "Blankevoort1991Ligament" => BLANKEVOORT_LIGAMENT,
        "PathSpring" => PATH_SPRING,
        "ClutchedPathSpring" => CLUTCHED_SPRING,
        "PointToPointSpring" => POINTS_SPRING,
        "ExpressionBasedPathForce" => EXPRESSION_PATH,
        "BushingForce" => BUSHING,
        "ExpressionBasedBushingForce" | "FunctionBasedBushingForce" => BUSHING_OF_FUNCTIONS,
        "SpringGeneralizedForce" => COORDINATE_SPRING,
        "CoordinateLimitForce" => LIMIT_FORCE,
        "CoordinateActuator" => COORDINATE_ACTUATOR,
        "ActivationCoordinateActuator" => ACTIVATED_ACTUATOR,
        "PathActuator" | "PointActuator" | "PointToPointActuator" => FORCE_ACTUATOR,
        "TorqueActuator" => TORQUE_ACTUATOR,
        _ => &[],
    }
}

pub(super) fn why_not_read(class: &str) -> Option<&'static str> {
    match class {
        "ExpressionBasedBushingForce"
        | "ExpressionBasedCoordinateForce"
        | "ExpressionBasedPathForce"
        | "ExpressionBasedPointToPointForce" => Some("expressions"),
        "FunctionBasedBushingForce" | "PrescribedForce" => Some("functions"),
        "Millard2012AccelerationMuscle" => Some("parts with time constants"),
        _ => None,
    }
}
