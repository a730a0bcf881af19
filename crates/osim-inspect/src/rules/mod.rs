//! The rules about one model. Each topic has a file with the texts of its rules, the functions that apply them, and their remedies. A new
//! rule is a static in such a file and a line in one of the tables here.

mod components;
pub(crate) mod contacts;
pub(crate) mod depth;
mod figure_check;
pub(crate) mod floors;
mod forces;
mod friction;
mod misread;
pub(crate) mod places;
mod refused_or_ignored;
pub(crate) mod sides;
mod skeleton;
mod smoothing;
mod spheres;
mod standing;
mod unlikely_numbers;
mod written_properties;

use contact_scaling::limits::SUGGESTED_CONSTANT_INDENTATION;
use osim_model::{Finding, FindingCode, Model, Rule};
use osim_requests::Request;

use crate::findings::{FindingWithRemedy, Remedies};
use crate::inspection::Inspection;
use crate::plane_judgement::{Floors, JudgedPlane};
use crate::sides::BothSides;
pub use contacts::describe_unmatched_patterns;
pub use depth::ways_within_hertz;
pub(crate) use figure_check::FigureCheck;
pub use places::find_misplaced_spheres;

/// A table of rules: each line has one or several rules, and the function that applies them together.
type RuleTable<F> = &'static [(&'static [&'static Rule], F)];

/// What a rule about one model depends on, and the function that finds its cases.
type ModelRule = (DependsOn, fn(&Model) -> Vec<Finding>);

/// What the findings of a rule depend on.
#[derive(Clone, Copy, PartialEq)]
enum DependsOn {
    /// Numbers of contacts or the note, which a change can make different.
    Numbers,
    /// Numbers of contacts, too. The function applies [`SIDE_RULES`] besides the rules of its line, and finds spheres in wrong places.
    Sides,
    /// Only what models share that differ in such numbers: bodies, joints, constraints, names, other texts.
    Rest,
}
use DependsOn::{Numbers, Rest, Sides};

/// Makes a table of rules: each line has a module, rules of it, and the function that applies them together.
macro_rules! rule_table {
    ($($module:ident [$($rule:ident),*] => $find:expr;)*) => { &[$((&[$(&$module::$rule),*], $find)),*] };
}

/// Rules about the model itself, in the order in which reports list their findings.
static MODEL_RULES: RuleTable<ModelRule> = rule_table! {
    components [CONNECTEE_BY_NAME, SOCKET_NOWHERE, MISNAMED_PARAMETER_SET]
        => (Rest, components::find_irregularities);
    components [] => (Rest, components::find_lost_coordinates);
    refused_or_ignored [BODY_WITHOUT_JOINT, VERSION_AGAINST_FORM, MISPLACED_OBJECT, IGNORED_CONTACTS, UNKNOWN_NAME]
        => (Rest, refused_or_ignored::find_unread);
    misread [ODD_NUMBER, NOT_FINITE, OUT_OF_DOMAIN] => (Numbers, misread::apply_value_rules);
    misread [] => (Rest, misread::find_impossible_bodies);
    // The texts of other numbers, by the same rules.
    misread [] => (Rest, misread::find_misread_texts);
    unlikely_numbers [ANGLE_IN_DEGREES] => (Rest, unlikely_numbers::find_angle_in_degrees);
    unlikely_numbers [MASSLESS_BODY] => (Rest, unlikely_numbers::find_massless_body);
    unlikely_numbers [DEFAULT_OUTSIDE_RANGE] => (Rest, unlikely_numbers::find_default_outside_range);
    skeleton [ODD_PARENT, LEFT_RIGHT_BONES] => (Rest, skeleton::find_wrong_side_or_unlike_limbs);
    skeleton [FOOT_SPHERE_ON_GROUND] => (Rest, skeleton::find_foot_sphere_on_ground);
    skeleton [ROOT_HELD] => (Rest, skeleton::find_root_held);
    components [INCLUDED_FILE] => (Rest, components::find_included_file);
    forces [DEAD_DERIVATIVE_SMOOTHING] => (Numbers, forces::find_dead_derivative_smoothing);
    forces [SEVERAL_SPHERES_ONE_FORCE] => (Rest, forces::find_several_spheres_one_force);
    forces [SPHERE_IN_TWO_FORCES] => (Rest, forces::find_sphere_in_two_forces);
    forces [SURFACE_NAMED_TWICE, NO_SURFACES_MEET, SPHERE_OF_OTHER_SIDE, SHAPE_PRESSES_NOTHING]
        => (Rest, forces::apply_surface_rules);
    forces [ELLIPSOID] => (Numbers, forces::find_ellipsoid);
    unlikely_numbers [DEFAULT_STIFFNESS] => (Numbers, unlikely_numbers::find_default_stiffness);
    unlikely_numbers [ZERO_CONSTANT_CONTACT_FORCE] => (Numbers, unlikely_numbers::find_zero_constant_contact_force);
    sides [LEFT_RIGHT_DIFFER, LEFT_RIGHT_CLOSE] => (Sides, apply_side_rules);
    friction [LARGE_FRICTION, DYNAMIC_ABOVE_STATIC, ODD_TRANSITION_VELOCITY]
        => (Numbers, friction::find_odd_friction);
    friction [NO_FRICTION, NO_DISSIPATION] => (Numbers, friction::find_no_friction_or_dissipation);
    components [CONTACT_DEFAULTS] => (Rest, components::find_contact_defaults);
    forces [MOCO_DIALECT] => (Numbers, forces::find_moco_dialect);
    forces [TERRAIN] => (Numbers, forces::find_terrain);
    components [UNKNOWN_CLASS] => (Rest, components::find_unknown_class);
    components [NOT_HERTZ, DUPLICATE_NAMES, REFUSED_NAME] => (Rest, components::apply_component_rules);
    components [LOOP_OF_JOINTS] => (Rest, components::find_loop_of_joints);
    components [MIXED_PAIR] => (Numbers, components::find_mixed_pair);
};

/// Rules about the two sides of the body, and about places and sizes of spheres.
static SIDE_RULES: RuleTable<fn(&BothSides<'_>) -> Option<Finding>> = &[
    (&[&sides::LEFT_RIGHT_PLACES], sides::find_left_right_places),
    (&[&sides::LEFT_RIGHT_MISSING], sides::find_left_right_missing),
    (&[&sides::LEFT_RIGHT_OFF], sides::find_left_right_off),
    (&[&sides::ONE_SIDE_ONLY], sides::find_one_side_only),
    (&[&sides::LEFT_RIGHT_SWAPPED], sides::find_left_right_swapped),
    (&[&spheres::DOUBLED_SPHERES], spheres::find_doubled_spheres),
    (&[&spheres::CROWDED_SPHERES], spheres::find_crowded_spheres),
    (&[&spheres::ODD_RADIUS], spheres::find_odd_radius),
    (&[&spheres::ODD_PLACE], spheres::find_odd_place),
    (&[&spheres::HEAVY_FOOT], spheres::find_heavy_foot),
];

/// Rules about the floors that spheres press on.
static FLOOR_RULES: RuleTable<fn(&JudgedPlane) -> Option<Finding>> = &[
    (&[&floors::FLOOR_UPSIDE_DOWN], floors::find_upside_down_floor),
    (&[&floors::FLOOR_UPRIGHT], floors::find_upright_floor),
    (&[&floors::FLOOR_ON_LIMB], floors::find_floor_on_limb),
    (&[&floors::FLOOR_SLOPES], floors::find_sloping_floor),
];

/// Rules about the figures of spheres.
static FIGURE_RULES: RuleTable<fn(&FigureCheck<'_>) -> Option<FindingWithRemedy>> = &[
    (&[&depth::SUNK_IN], depth::find_sunk_in_spheres),
    (&[&depth::TOO_STIFF], depth::find_too_stiff_contacts),
    (&[&depth::BEYOND_HERTZ], depth::find_beyond_hertz),
    (&[&depth::BEYOND_HERTZ_AT_TWO], depth::find_beyond_hertz_at_two),
    (&[&smoothing::BEYOND_HUNT_CROSSLEY], smoothing::find_beyond_hunt_crossley),
    (&[&smoothing::LARGE_CONSTANT_INDENTATION], smoothing::find_large_constant_indentation),
    (&[&smoothing::WIDE_TRANSITION], smoothing::find_wide_transition),
    (&[&smoothing::WEAK_AT_REST], smoothing::find_weak_at_rest),
    (&[&smoothing::FORCE_BEFORE_CONTACT], smoothing::find_force_before_contact),
    (&[&smoothing::FLOATS], smoothing::find_floating_body),
    (&[&standing::UNEVEN_BOTTOMS], standing::find_uneven_bottoms),
    (&[&standing::UNLEVEL_FOOT], standing::find_unlevel_foot),
];

/// Rules that no table applies, because they depend on more than the model, such as the options of the caller.
static OTHER_RULES: RuleTable<()> = rule_table! {
    contacts [BARE_MODEL, CONTACTS_OF_ANOTHER_MASS, COUNT_UNKNOWN, KNOWN_CONTACTS, MASS_UNKNOWN] => ();
    contacts [STALE_NOTE, UNMATCHED_PATTERN] => ();
    floors [FLOOR_STEP] => ();
    floors [GRAVITY_NOT_DOWN, GRAVITY_SOURCES_DISAGREE, GRAVITY_TOO_LARGE, NO_GRAVITY, ODD_GRAVITY] => ();
    places [SPHERES_LEFT_BEHIND, SPHERES_MISPLACED, SPHERES_NOT_COMPARED] => ();
    standing [NOT_ON_FLOOR] => ();
};

/// The rules of this crate.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    let of_tables = rules_in(MODEL_RULES).chain(rules_in(SIDE_RULES)).chain(rules_in(FLOOR_RULES));
    of_tables.chain(rules_in(FIGURE_RULES)).chain(rules_in(OTHER_RULES))
}

/// All rules of a table.
fn rules_in<F>(table: RuleTable<F>) -> impl Iterator<Item = &'static Rule> {
    table.iter().flat_map(|(rules, _)| rules.iter().copied())
}

/// The findings of the rules about a model itself, computed once for each model.
///
/// ```
/// use osim_inspect::model_findings;
/// use osim_model::{FindingCode, Model};
///
/// # let text = include_str!("../../../osim-model/tests/data/one_foot.osim");
/// // A force without a stiffness has OpenSim's default, 1 N/m², which carries nothing.
/// let model = Model::parse(text.replace("<stiffness>1000000</stiffness>", ""))?;
/// let finding = &model_findings(&model)[0];
/// assert_eq!(finding.code(), FindingCode::DefaultStiffness);
/// assert!(finding.advice.to_string().starts_with("Set a stiffness"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
pub fn model_findings(model: &Model) -> &[Finding] {
    model.findings(|model| apply_model_rules(model, |_| true))
}

/// The findings of [`model_findings`], without those of rules about numbers of contacts that have none among the findings `other`.
pub(crate) fn findings_as_in(model: &Model, other: &[FindingWithRemedy]) -> Vec<Finding> {
    apply_model_rules(model, |code| other.iter().any(|one| one.code() == code))
}

/// Applies the rules about a model itself; those about numbers of contacts only if a finding with one of their codes `is_wanted`.
fn apply_model_rules(model: &Model, is_wanted: impl Fn(FindingCode) -> bool) -> Vec<Finding> {
    /// Findings of the rules that do not depend on numbers of contacts, computed once for models that differ only in such numbers.
    struct RestFindings(Vec<Vec<Finding>>);
    let of_rest = MODEL_RULES.iter().filter(|(_, (depends_on, _))| *depends_on == Rest);
    let RestFindings(found) =
        model.derived_from_bodies(|model| RestFindings(of_rest.map(|(_, (_, find))| find(model)).collect()));
    let mut found = found.iter().cloned();
    let is_wanted = |rule: &Rule| is_wanted(rule.code);
    let are_sides_wanted = || rules_in(SIDE_RULES).chain([&places::SPHERES_MISPLACED]).any(is_wanted);
    let findings = MODEL_RULES.iter().flat_map(|(rules, (depends_on, find))| match depends_on {
        Rest => found.next().unwrap_or_default(),
        _ if rules.iter().any(|rule| is_wanted(rule)) => find(model),
        Sides if are_sides_wanted() => find(model),
        Numbers | Sides => Vec::new(),
    });
    Finding::group_by_cause(findings.collect())
}

/// Applies the rules that compare left and right.
fn apply_side_rules(model: &Model) -> Vec<Finding> {
    let sides = BothSides::of(model);
    let mut findings = sides::find_side_differences(&sides);
    findings.extend(SIDE_RULES.iter().filter_map(|(_, find)| find(&sides)));
    findings.extend(places::find_no_heel(&sides));
    findings.extend(places::find_toes_at_ankle(&sides));
    // Of a sphere on the trunk whose counterpart is on a foot, that one says so.
    let is_missing = |one: &Finding| one.code() == FindingCode::LeftRightMissing;
    if !findings.iter().any(is_missing) {
        findings.extend(places::find_foot_spheres_on_trunk(&sides));
    }
    if !skeleton::foot_spheres_on_ground(model).is_empty() {
        // These have a finding of their own.
        findings
            .retain(|one| !matches!(one.code(), FindingCode::LeftRightMissing | FindingCode::OneSideOnly));
    }
    findings
}

/// The finding that gravity does not point into a floor of `model`: then nothing says which way is up.
pub fn find_gravity_not_down(model: &Model) -> Option<Finding> {
    Floors::of(model).iter().find_map(|judged| floors::find_gravity_not_into_floor(model, judged))
}

/// Applies the rules about floors and about gravity towards them.
pub(crate) fn apply_floor_rules(model: &Model, inspected: &Inspection, floors: &Floors) -> Vec<Finding> {
    let about_gravity = [
        floors::find_too_large_gravity(model),
        floors.iter().find_map(|judged| floors::find_gravity_not_into_floor(model, judged)),
        floors::find_odd_gravity(model, floors),
    ];
    let about_planes = FLOOR_RULES.iter().flat_map(|(_, find)| floors.iter().filter_map(find));
    let about_all = [floors::find_floor_step(floors), floors::find_no_gravity(model, inspected, floors)];
    about_gravity.into_iter().flatten().chain(about_planes).chain(about_all.into_iter().flatten()).collect()
}

/// Applies the rules about figures.
pub(crate) fn apply_figure_rules(check: &FigureCheck<'_>) -> Vec<FindingWithRemedy> {
    let findings = FIGURE_RULES.iter().filter_map(|(_, find)| find(check));
    findings.chain(standing::find_not_on_floor(check)).collect()
}

/// The request that corrects a finding of [`model_findings`], if there is one.
pub(crate) fn find_remedy(model: &Model, finding: &Finding, remedies: &Remedies<'_>) -> Option<Request> {
    match finding.code() {
        FindingCode::DefaultStiffness => remedies.transfer_published(None).map(Request::from),
        FindingCode::ZeroConstantContactForce => {
            remedies.design_constant_indentation(SUGGESTED_CONSTANT_INDENTATION)
        }
        FindingCode::ConnecteeByName => components::connect_sockets(remedies, model),
        FindingCode::MocoDialect => forces::convert_moco_forces(remedies, model, finding),
        _ => None,
    }
}
