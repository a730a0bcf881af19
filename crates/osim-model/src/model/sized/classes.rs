//! Which properties of which classes have mass, length or time in their unit, and what OpenSim 4.6 takes where a file says nothing.
//!
//! The defaults are those that `OpenSimObject.newInstanceOfType` of OpenSim 4.6 has.

use super::kind::SizedKind;
use super::kind::SizedKind::{
    ActivationTime, ActuatorForce, ActuatorTime, ActuatorTorque, BushingDamping, BushingRotationalDamping,
    BushingRotationalStiffness, BushingStiffness, CoordinateDamping, CoordinateLength,
    CoordinateRotationalDamping, CoordinateRotationalStiffness, CoordinateStiffness, DeactivationTime,
    LigamentDamping, LigamentForce, LigamentLength, LimitDamping, LimitLength, LimitRotationalDamping,
    LimitRotationalStiffness, LimitStiffness, MaxContractionVelocity, MaxIsometricForce, OptimalFiberLength,
    SpringDissipation, SpringLength, SpringStiffness, SpringTime, TendonSlackLength, TimeScale,
};

/// What a property is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Is {
    /// This kind.
    Always(SizedKind),
    /// It acts on a coordinate: the kind where that is an angle (`None` is without dimension), and where it is a translation.
    ByCoordinate(Option<SizedKind>, SizedKind),
}

/// A property of a class.
#[derive(Debug, Clone, Copy)]
pub(super) struct Listed {
    pub(super) tag: &'static str,
    pub(super) is: Is,
    /// What OpenSim takes where the file says nothing.
    pub(super) default: f64,
    /// How many numbers it has.
    pub(super) count: usize,
}

const fn one(tag: &'static str, kind: SizedKind, default: f64) -> Listed {
    Listed { tag, is: Is::Always(kind), default, count: 1 }
}

const fn three(tag: &'static str, kind: SizedKind) -> Listed {
    Listed { tag, is: Is::Always(kind), default: 0.0, count: 3 }
}

const fn acts(tag: &'static str, turns: Option<SizedKind>, shifts: SizedKind, default: f64) -> Listed {
    Listed { tag, is: Is::ByCoordinate(turns, shifts), default, count: 1 }
}

const FORCE: Listed = one("max_isometric_force", MaxIsometricForce, 1000.0);
const FIBER: Listed = one("optimal_fiber_length", OptimalFiberLength, 0.1);
const TENDON: Listed = one("tendon_slack_length", TendonSlackLength, 0.2);
const VELOCITY: Listed = one("max_contraction_velocity", MaxContractionVelocity, 10.0);
const SCALE: Listed = one("time_scale", TimeScale, 0.1);

const fn activation(default: f64) -> Listed {
    one("activation_time_constant", ActivationTime, default)
}

const fn deactivation(default: f64) -> Listed {
    one("deactivation_time_constant", DeactivationTime, default)
}

const RIGID_TENDON: &[Listed] = &[FORCE, FIBER, TENDON, VELOCITY];
const THELEN: &[Listed] = &[FORCE, FIBER, TENDON, VELOCITY, activation(0.015), deactivation(0.05)];
const OLD_THELEN: &[Listed] =
    &[FORCE, FIBER, TENDON, one("Vmax", MaxContractionVelocity, 10.0), activation(0.01), deactivation(0.04)];
const MILLARD: &[Listed] = &[FORCE, FIBER, TENDON, VELOCITY, activation(0.01), deactivation(0.04)];
const DE_GROOTE: &[Listed] = &[FORCE, FIBER, TENDON, VELOCITY, activation(0.015), deactivation(0.06)];
const TIME_SCALED: &[Listed] = &[FORCE, FIBER, TENDON, SCALE];
const LIGAMENT: &[Listed] =
    &[one("resting_length", LigamentLength, 0.0), one("pcsa_force", LigamentForce, 0.0)];
const BLANKEVOORT: &[Listed] = &[
    one("slack_length", LigamentLength, 0.0),
    one("linear_stiffness", LigamentForce, 1.0),
    one("damping_coefficient", LigamentDamping, 0.003),
];
const PATH_SPRING: &[Listed] = &[
    one("resting_length", SpringLength, f64::NAN),
    one("stiffness", SpringStiffness, f64::NAN),
    one("dissipation", SpringDissipation, f64::NAN),
];
const CLUTCHED: &[Listed] = &[
    one("stiffness", SpringStiffness, f64::NAN),
    one("dissipation", SpringDissipation, f64::NAN),
    one("relaxation_time_constant", SpringTime, 0.001),
];
const POINTS_SPRING: &[Listed] =
    &[one("stiffness", SpringStiffness, 1.0), one("rest_length", SpringLength, 0.0)];
const EXPRESSION_PATH: &[Listed] = &[one("resting_length", SpringLength, 0.0)];
const BUSHING: &[Listed] = &[
    three("rotational_stiffness", BushingRotationalStiffness),
    three("translational_stiffness", BushingStiffness),
    three("rotational_damping", BushingRotationalDamping),
    three("translational_damping", BushingDamping),
];
const BUSHING_OF_FUNCTIONS: &[Listed] =
    &[three("rotational_damping", BushingRotationalDamping), three("translational_damping", BushingDamping)];
const COORDINATE_SPRING: &[Listed] = &[
    acts("stiffness", Some(CoordinateRotationalStiffness), CoordinateStiffness, 0.0),
    acts("viscosity", Some(CoordinateRotationalDamping), CoordinateDamping, 0.0),
    acts("rest_length", None, CoordinateLength, 0.0),
];
const LIMIT: &[Listed] = &[
    acts("upper_stiffness", Some(LimitRotationalStiffness), LimitStiffness, 1.0),
    acts("lower_stiffness", Some(LimitRotationalStiffness), LimitStiffness, 1.0),
    acts("damping", Some(LimitRotationalDamping), LimitDamping, 0.001),
    acts("upper_limit", None, LimitLength, 0.0),
    acts("lower_limit", None, LimitLength, 0.0),
    acts("transition", None, LimitLength, 0.1),
];
const COORDINATE_ACTUATOR: &[Listed] = &[acts("optimal_force", Some(ActuatorTorque), ActuatorForce, 1.0)];
const ACTIVATED_ACTUATOR: &[Listed] = &[
    acts("optimal_force", Some(ActuatorTorque), ActuatorForce, 1.0),
    one("activation_time_constant", ActuatorTime, 0.01),
];
const FORCE_ACTUATOR: &[Listed] = &[one("optimal_force", ActuatorForce, 1.0)];
const TORQUE_ACTUATOR: &[Listed] = &[one("optimal_force", ActuatorTorque, 1.0)];

/// The properties of `class` that are listed.
pub(super) fn listed(class: &str) -> &'static [Listed] {
    match class {
        "Thelen2003Muscle" => THELEN,
        "Thelen2003Muscle_Deprecated" => OLD_THELEN,
        "Millard2012EquilibriumMuscle" => MILLARD,
        "DeGrooteFregly2016Muscle" | "MeyerFregly2016Muscle" => DE_GROOTE,
        "RigidTendonMuscle" | "Millard2012AccelerationMuscle" => RIGID_TENDON,
        "Schutte1993Muscle_Deprecated" | "Delp1990Muscle_Deprecated" => TIME_SCALED,
        "Ligament" => LIGAMENT,
        "Blankevoort1991Ligament" => BLANKEVOORT,
        "PathSpring" => PATH_SPRING,
        "ClutchedPathSpring" => CLUTCHED,
        "PointToPointSpring" => POINTS_SPRING,
        "ExpressionBasedPathForce" => EXPRESSION_PATH,
        "BushingForce" => BUSHING,
        "ExpressionBasedBushingForce" | "FunctionBasedBushingForce" => BUSHING_OF_FUNCTIONS,
        "SpringGeneralizedForce" => COORDINATE_SPRING,
        "CoordinateLimitForce" => LIMIT,
        "CoordinateActuator" => COORDINATE_ACTUATOR,
        "ActivationCoordinateActuator" => ACTIVATED_ACTUATOR,
        "PathActuator" | "PointActuator" | "PointToPointActuator" => FORCE_ACTUATOR,
        "TorqueActuator" => TORQUE_ACTUATOR,
        _ => &[],
    }
}

/// Why some numbers of `class` are not read.
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
