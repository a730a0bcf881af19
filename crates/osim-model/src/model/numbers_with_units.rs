//! Numbers of a model with mass, length or time in their unit, without those of contacts: muscles, ligaments, springs, bushings, actuators
//! and bodies. Also the kinds of such numbers, and the properties of OpenSim classes that have these kinds.

use std::collections::{BTreeMap, HashMap};

use SizedKind::*;

use crate::model::{ComponentId, Document, Model};
use crate::xml::{ElementId, opensim_text};

/// A number of a model that changes with body size, and the object that has it.
#[derive(Debug, Clone, PartialEq)]
pub struct SizedValue {
    pub kind: SizedKind,
    /// The name of the object that has the number.
    pub owner: String,
    /// The property of the object and the index in the property, for an object with several numbers of one kind.
    pub part: (&'static str, usize),
    /// The number in the unit of its kind; finite.
    pub value: f64,
}

/// Objects of one class whose numbers are not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotRead {
    /// The OpenSim class, or a part of a file.
    pub class: String,
    pub count: usize,
    /// Why their numbers are not read.
    pub why: &'static str,
}

impl NotRead {
    /// The record that the numbers of `count` objects of `class` are not read, and `why`.
    pub fn new(class: &str, count: usize, why: &'static str) -> Self {
        Self { class: class.to_owned(), count, why }
    }
}

/// All numbers of a model with mass, length or time in their unit, except those of contacts.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SizedValues {
    pub values: Vec<SizedValue>,
    pub not_read: Vec<NotRead>,
}

impl SizedValues {
    /// The numbers of `model` that change with body size, as OpenSim reads them: from the object, else `<defaults>`, else the default of
    /// the class. Numbers that are not finite are left out.
    ///
    /// ```
    /// use osim_model::{Model, SizedKind, SizedValues};
    ///
    /// let text = r#"<OpenSimDocument Version="40000"><Model><ForceSet><objects>
    ///     <Thelen2003Muscle name="soleus_r"><max_isometric_force>3549</max_isometric_force></Thelen2003Muscle>
    /// </objects></ForceSet></Model></OpenSimDocument>"#;
    /// let found = SizedValues::of(&Model::parse(text)?);
    /// let first = &found.values[0];
    /// assert_eq!((first.kind, first.owner.as_str(), first.value), (SizedKind::MaxIsometricForce, "soleus_r", 3549.0));
    /// # Ok::<(), osim_model::Fault>(())
    /// ```
    pub fn of(model: &Model) -> Self {
        let mut reader = SizedValueReader { model, angles: None, not_read: BTreeMap::new() };
        let components = model.components();
        let mut values = Vec::new();
        for (id, _) in components.tree.iter() {
            reader.add(id, &mut values);
        }
        let not_read =
            reader.not_read.into_iter().map(|((class, why), count)| NotRead { class, count, why }).collect();
        Self { values, not_read }
    }
}

/// Why the numbers of a force on a coordinate are not read.
const FORCE_ON_UNKNOWN_COORDINATE: &str = "coordinates that are missing, or neither an angle nor a length";

/// Reads the numbers of a model that change with body size, one object after the other.
struct SizedValueReader<'m> {
    model: &'m Model,
    /// Whether each coordinate is an angle. Read when the first force on a coordinate is found.
    angles: Option<HashMap<&'m str, Option<bool>>>,
    not_read: BTreeMap<(String, &'static str), usize>,
}

impl SizedValueReader<'_> {
    /// Adds the numbers of one component.
    fn add(&mut self, id: ComponentId, values: &mut Vec<SizedValue>) {
        let components = self.model.components();
        let class = components.tag(id);
        if class == "Body" {
            values.extend(inertia_value(self.model, id));
            return;
        }
        if let Some(why) = why_not_read(class) {
            *self.not_read.entry((class.to_owned(), why)).or_default() += 1;
        }
        let properties = sized_properties(class);
        if properties.is_empty() {
            return;
        }
        let (document, element) = (components.document_of(id), components.element(id));
        let acts_on_coordinate =
            properties.iter().any(|one| matches!(one.kind, SizedKindRule::ByCoordinate(..)));
        let is_angle = acts_on_coordinate.then(|| self.is_angle(document, element)).flatten();
        if acts_on_coordinate && is_angle.is_none() {
            *self.not_read.entry((class.to_owned(), FORCE_ON_UNKNOWN_COORDINATE)).or_default() += 1;
        }
        let owner = components.name(id).into_owned();
        for property in properties {
            let Some(kind) = kind_of_property(property.kind, is_angle) else { continue };
            let found = numbers(document, element, property).into_iter().enumerate();
            for (place, value) in found.filter(|(_, value)| value.is_finite()) {
                values.push(SizedValue { kind, owner: owner.clone(), part: (property.tag, place), value });
            }
        }
    }

    /// Whether the coordinate of a force is an angle; `None` if it is not known, or is neither an angle nor a length.
    fn is_angle(&mut self, document: &Document, force: ElementId) -> Option<bool> {
        let named = document.tree().text_of(document.property_element(force, "coordinate")?);
        let name = opensim_text::trimmed(&named).rsplit('/').next()?;
        let model = self.model;
        let angles = self.angles.get_or_insert_with(|| model.coordinates_are_angles());
        angles.get(name).copied().flatten()
    }
}

fn kind_of_property(rule: SizedKindRule, is_angle: Option<bool>) -> Option<SizedKind> {
    match rule {
        SizedKindRule::Always(kind) => Some(kind),
        SizedKindRule::ByCoordinate(turning, _) if is_angle? => turning,
        SizedKindRule::ByCoordinate(_, shifting) => Some(shifting),
    }
}

fn inertia_value(model: &Model, body: ComponentId) -> Option<SizedValue> {
    let components = model.components();
    let [xx, yy, zz, ..] = crate::model::body_sizes::inertia_kg_m2(components, body)?;
    let value = xx + yy + zz;
    (!components.is_ground(body) && value.is_finite()).then(|| SizedValue {
        kind: Inertia,
        owner: components.name(body).into_owned(),
        part: ("inertia", 0),
        value,
    })
}

/// The numbers of a property, up to the number that it should have.
fn numbers(document: &Document, object: ElementId, property: &SizedProperty) -> Vec<f64> {
    let tree = document.tree();
    let read = |element| {
        if property.count == 1 {
            return match opensim_text::number(&tree.raw_text(element)) {
                Ok(number) | Err(opensim_text::NumberFault::Prefix { opensim_reads: number }) => {
                    Some(vec![number])
                }
                Err(_) => None,
            };
        }
        opensim_text::triple(&tree.text_of(element)).map(|found| found.to_vec())
    };
    let own = tree.child(object, property.tag).and_then(read);
    let inherited = || document.inherited_element(object, property.tag).and_then(read);
    own.or_else(inherited).unwrap_or_else(|| vec![property.default; property.count])
}

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
enum SizedKindRule {
    Always(SizedKind),
    /// A property of a force on a coordinate. The first kind is for a coordinate that is an angle (`None`: the number has no dimension),
    /// the second for a translation.
    ByCoordinate(Option<SizedKind>, SizedKind),
}

/// A property of an OpenSim class whose value changes with body size.
#[derive(Debug, Clone, Copy)]
struct SizedProperty {
    tag: &'static str,
    kind: SizedKindRule,
    /// The value that OpenSim uses if the file has none.
    default: f64,
    count: usize,
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
fn sized_properties(class: &str) -> &'static [SizedProperty] {
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

fn why_not_read(class: &str) -> Option<&'static str> {
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
