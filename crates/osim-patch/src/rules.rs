//! Rules of the findings about changes.

use contact_scaling::{RatioValues, Ratios};
use osim_model::compare::Follow;
use osim_model::messages::{Input, Phrase, Verb, four_significant, phrase, readable, three_significant};
use osim_model::{
    Example, Finding, Force, ForceId, ForceKind, Mass, Model, Property, PropertySet, RadiusRule, Repair,
    Rule, are_equal_gravities,
};

use crate::builder::PlanBuilder;
use crate::new_radii::Radii;
use osim_model::rule;

/// The rules of this crate, which are about changes.
pub const RULES: &[&Rule] = &[
    &ALREADY_AT_TARGET,
    &COMPOSITE_SURFACES,
    &FACTOR_SPREAD,
    &FRICTION_NOT_SIMILAR,
    &NOTHING_TO_CHANGE,
    &REFERENCE_WITHOUT_SMOOTHING,
];

rule! { ALREADY_AT_TARGET: AlreadyAtTarget, Warning;
    what: "The contacts are already made for the target mass, so nothing was written.",
    why: "The mass the contacts are made for is taken from the note in the file, else `mass`, else the sum of the bodies. A model that was scaled in OpenSim weighs its new mass already while its contacts are still those of the old one; the file does not show which.",
    advice: "Give the mass that the contacts were made for with `contacts_mass=KG`, or take those of a known model with `transfer from=MODEL`",
    repair: Repair::OnlyInChange("only you know for which mass the contacts were made"),
    example: Example::Request {
        good: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90}"#,
        bad: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 62}"# },
}

/// The remark that the contacts are made for the target mass already.
pub(crate) fn already_at_target(contacts_mass: &Mass) -> Finding {
    let message = phrase![
        "contacts are taken as made for {} kg already ({}); if they were made for another mass, give {} or {}";
        readable(contacts_mass.kg), &contacts_mass.source.describe(),
        Input::ContactsMass.with_placeholder("KG"),
        Verb::Transfer.call().with_placeholder(Input::From, "MODEL")
    ];
    Finding::new(&ALREADY_AT_TARGET, message)
}

rule! { pub(crate) COMPOSITE_SURFACES: CompositeSurfaces, Warning;
    what: "Sphere and half-space of a converted force have parameters of their own.",
    why: "A force of one sphere has one set of parameters. It gets those that both surfaces have together (A.3), which gives the same force; but Simbody moves the point of contact towards the softer surface, so that accelerations can differ by up to 3 %.",
    advice: "Nothing, if 3 % do not matter; otherwise give both surfaces the same parameters first",
    repair: Repair::OnlyInChange("only you know which parameters are right"),
    example: Example::Request {
        good: r#"{"verb": "convert", "models": ["format/v40000.osim"], "to": "hunt-crossley"}"#,
        bad: r#"{"verb": "convert", "models": ["format/three_materials.osim"], "to": "hunt-crossley"}"# },
}

/// The message about the composite parameters of the new force between `sphere` and `plane`; also the error message of a strict
/// change.
pub(crate) fn composite_surfaces_message(force: &Force, sphere: &str, plane: &str) -> String {
    format!(
        "{}: {sphere} and {plane} have parameters of their own; the new force has those of both together (A.3), and as Simbody \
         moves the contact point by the moduli, accelerations differ by up to 2.9 %",
        force.path
    )
}

rule! { pub(crate) FACTOR_SPREAD: FactorSpread, Warning;
    what: "Spheres of one ContactParameters follow bodies with different factors.",
    why: "One ContactParameters has one modulus for all its spheres; the mean of R squared is used before and after, so single spheres sink in more or less than they did.",
    advice: "Give each sphere its own force, or accept it; `strict` refuses instead",
    repair: Repair::OnlyInChange("forces cannot be divided yet: only numbers are changed"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["scale_tool/scaled_hunt_crossley.osim"], "from": "scale_tool/generic_hunt_crossley.osim", "follow_bodies": true, "radius": "follow"}"#,
        bad: r#"{"verb": "transfer", "models": ["scale_tool/scaled_hunt_crossley.osim"], "from": "scale_tool/generic_hunt_crossley.osim", "follow_bodies": true, "radius": "follow", "body_scale": {"toes_r": 1.1}}"# },
}

/// Largest relative difference of factors that count as equal.
const EQUAL_FACTORS_TOLERANCE: f64 = 0.01;

/// The message for a force whose spheres' largest factor is `spread` times the smallest; also the error message of a strict
/// change. `None` if the factors are equal.
pub(crate) fn factor_spread_message(force: &Force, spread: f64) -> Option<String> {
    (spread > 1.0 + EQUAL_FACTORS_TOLERANCE).then(|| {
        format!(
            "{}: its spheres grow by factors that differ by {:.1} %; the mean of R squared is used",
            force.path,
            (spread - 1.0) * 100.0
        )
    })
}

rule! { FRICTION_NOT_SIMILAR: FrictionNotSimilar, Remark;
    what: "The friction of SmoothSphereHalfSpaceForce is not exactly similar.",
    why: "Simbody adds constant_contact_force to the squared slip speed, where similarity wants a term in proportion to g R: friction of the smooth force is similar only as far as that term is small.",
    advice: "Rely on friction only where the slip speed in m/s is a much larger number than the square root of constant_contact_force",
    repair: Repair::OnlyInChange("it lies in how OpenSim computes friction"),
    example: Example::Request {
        good: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90}"#,
        bad: r#"{"verb": "rescale", "models": ["table1/human_62kg_smooth_sphere.osim"], "target_mass": 90, "friction": true}"# },
}

/// A finding if the friction of one of `forces` is scaled but not exactly similar.
pub(crate) fn friction_not_similar<'f>(
    mut forces: impl Iterator<Item = &'f Force>,
    properties: &PropertySet,
) -> Option<Finding> {
    let scaled = properties.contains(Property::TransitionVelocity)
        && forces.any(|force| force.kind == ForceKind::SmoothSphereHalfSpace);
    let text = "friction of SmoothSphereHalfSpaceForce scales only as far as constant_contact_force is small \
                against the squared slip speed";
    scaled.then(|| Finding::new(&FRICTION_NOT_SIMILAR, text))
}

rule! { NOTHING_TO_CHANGE: NothingToChange, Remark;
    what: "A part of the request changes nothing.",
    why: "A factor of exactly 1 leaves every byte as it is. With a radius that stays, dissipation and smoothing stay too (14, C.2, C.5, C.10).",
    advice: "Nothing, if this is intended; else ask for another change",
    repair: Repair::OnlyInChange("nothing is wrong"),
    example: Example::Request {
        good: r#"{"verb": "set", "models": ["table1/human_62kg_smooth_sphere.osim"], "set": {"stiffness": 2000000}}"#,
        bad: r#"{"verb": "set", "models": ["table1/human_62kg_smooth_sphere.osim"], "set": {"stiffness": 1000000}}"# },
}

/// The remark that a part of the request changes nothing; `text` says which.
pub(crate) fn nothing_to_change(text: impl Into<Phrase>) -> Finding {
    Finding::new(&NOTHING_TO_CHANGE, text)
}

rule! { pub(crate) REFERENCE_WITHOUT_SMOOTHING: ReferenceWithoutSmoothing, Warning;
    what: "The reference has no smoothing parameters to give.",
    why: "A HuntCrossleyForce has no constant_contact_force, hertz_smoothing or hunt_crossley_smoothing, so those of the model stay (or follow its own radii where these change).",
    advice: "Take the contacts from a model with SmoothSphereHalfSpaceForce, or check the smoothing with `inspect`",
    repair: Repair::OnlyInChange("only you know which smoothing is right"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["table1/human_62kg_smooth_sphere.osim"], "from": "table1/human_500kg_smooth_sphere.osim"}"#,
        bad: r#"{"verb": "transfer", "models": ["table1/human_62kg_smooth_sphere.osim"], "from": "table1/human_500kg_hunt_crossley.osim"}"# },
}

// Remarks about a change beside its numbers.

/// A remark on the quantities that a change of numbers leaves as they are.
pub const REMARK_PLACES_STAY: &str = "body masses and sphere locations stay as they are";

/// The remark if sphere centres move because radii change.
pub(crate) const REMARK_LEVEL: &str = "body masses stay as they are; sphere centres move, so that the lowest point of each sphere stays where it is";

/// The remark if contacts are scaled to a gravity that is not the model's.
pub(crate) fn remark_on_gravity(model: &Model, target_m_s2: Option<f64>) -> Option<Phrase> {
    let own_m_s2 = model.gravity();
    let is_other = |target| own_m_s2.is_none_or(|own| !are_equal_gravities(target, own));
    let text = "the model's own <gravity> stays as it is: set it in OpenSim";
    target_m_s2.is_some_and(is_other).then(|| text.into())
}

/// The remark if spheres move because their feet are made level.
pub(crate) const REMARK_LEVEL_FEET: &str = "spheres move down, along the normal of their floor, until all spheres of a foot are as low as its lowest one at the default pose";

/// Adds the findings about the chosen forces to the plan.
pub(crate) fn warn_forces(plan: &mut PlanBuilder<'_>, forces: &[ForceId], properties: &PropertySet) {
    let model = plan.model;
    plan.findings.extend(model.remarks_on(forces));
    let call = Verb::Design
        .call_with_model()
        .with_placeholder(Input::Load, "N")
        .with_placeholder(Input::Spheres, "N");
    let call = call.with_placeholder(Input::Indentation, "X").with_placeholder(Input::Restitution, "CR");
    let call = call.with_placeholder(Input::ImpactSpeed, "M/S");
    let of_speeds = Verb::Set.call_with_model().with_placeholder(Input::Dissipation, "x1/V");
    for force in forces.iter().filter_map(|&id| model.force(id)) {
        if model.sphere_pairs(force).is_empty() {
            continue;
        }
        plan.remarks.push(phrase![
            "{} presses spheres on each other: here its force goes with body weight (10), its speed with gravity (14); for others: {}; \
            for a ratio V of speeds: {}, then {}";
            force.path.clone(), call.clone(), Input::Keep.with_value("dissipation"), of_speeds.clone()
        ]);
    }
    let chosen = forces.iter().filter_map(|&id| model.force(id));
    plan.findings.extend(friction_not_similar(chosen, properties));
}

/// Two rules of size differ clearly if one gives more than this many times the other.
const CLEAR_RATIO: f64 = 1.1;

/// Whether the ratio of two sizes is clearly not 1.
fn are_apart(ratio: f64) -> bool {
    ratio > CLEAR_RATIO || ratio * CLEAR_RATIO < 1.0
}

/// The beginning of the remark on dissipation by radius and by mass, by which it is recognised.
const START_OF_FORMS: &str = "(14) has two forms: ";

/// A sentence with the dissipation, scaled by (14) from `from` (s/m), by radius and by mass; `None` if the two hardly differ. With the
/// ratio of `lengths` of bones, also that for the speeds of legs, which go with the root of their length.
pub fn forms_of_dissipation(ratios: &Ratios, from: f64, lengths: Option<f64>) -> Option<String> {
    let [by_radius, by_mass] =
        [ratios.dissipation(), ratios.dissipation_by_mass()].map(|factor| from * factor);
    let of_legs = lengths.and_then(|radius| Ratios::new(RatioValues { radius, ..ratios.values() }).ok());
    let by_legs = of_legs.map(|legs| {
        let value = four_significant(from * legs.dissipation());
        format!("; {value} s/m by length of bones keeps it at speeds in proportion to the root of leg length")
    });
    are_apart(by_radius / by_mass).then(|| {
        format!(
            "{START_OF_FORMS}{} s/m by radius keeps the restitution after falls of equal height over radius, {} s/m by mass that at speeds \
             in proportion to M^(1/6){}",
            four_significant(by_radius),
            four_significant(by_mass),
            by_legs.unwrap_or_default()
        )
    })
}

/// Adds a remark, once, if (14) by radius and (14) by mass give clearly different dissipations of a contact with the dissipation `from`.
pub(crate) fn remark_on_dissipation(
    remarks: &mut Vec<Phrase>,
    ratios: &Ratios,
    from: f64,
    lengths: Option<f64>,
) {
    let is_new = !remarks.iter().any(|remark| remark.to_string().starts_with(START_OF_FORMS));
    remarks.extend(forms_of_dissipation(ratios, from, lengths).filter(|_| is_new).map(Phrase::from));
}

/// A remark that radii follow the mass, or the bones in `follow`, if the two rules are clearly different, and what each keeps. `by_mass` is
/// the ratio of isometric radii.
pub(crate) fn remark_on_radii(follow: &Follow, radius: RadiusRule, by_mass: f64) -> Option<Phrase> {
    if !follow.is_placed || !are_apart(follow.size_ratio / by_mass) {
        return None;
    }
    let [by_mass, bones] = [by_mass, follow.size_ratio].map(three_significant);
    let (force, depth) = (
        "the peak force of falls from heights in proportion to mass^(1/3)",
        "depth and pressure under the foot",
    );
    match radius {
        RadiusRule::Isometric => Some(phrase![
            "radii follow mass^(1/3) (x{by_mass}), and the bones are x{bones}: this keeps {force}; {} keeps {depth}";
            Input::Radius.with_value("follow")
        ]),
        _ if follow.has_radii_of_bodies => Some(phrase![
            "radii follow the bones (x{bones}), and mass^(1/3) is x{by_mass}: this keeps {depth}; {} keeps {force}";
            Input::Radius.with_value("isometric")
        ]),
        _ => None,
    }
}

/// A remark on how far the lowest points of spheres move, if radii change and centres do not.
pub(crate) fn remark_on_moved_bottoms(radii: &Radii) -> Option<Phrase> {
    let (least, most) = radii.bottom_shifts()?;
    let mm = |metres: f64| {
        let millimetres = metres.abs() * 1e3;
        if millimetres < 1e6 { format!("{millimetres:.2}") } else { readable(millimetres) }
    };
    let way = |metres: f64| if metres > 0.0 { "down" } else { "up" };
    let moves = if mm(least) == mm(most) && way(least) == way(most) {
        format!("{} mm {}", mm(most), way(most))
    } else if least >= 0.0 || most <= 0.0 {
        let (small, large) = if most > 0.0 { (least, most) } else { (most, least) };
        format!("{} to {} mm {}", mm(small), mm(large), way(large))
    } else {
        format!("from {} mm up to {} mm down", mm(least), mm(most))
    };
    Some(format!("the lowest points of spheres move {moves}, because radii change and centres stay").into())
}

/// Distance in m above which the remark on moved sphere bottoms comes first, because the body is then clearly higher or lower.
const CLEAR_BOTTOM_SHIFT_M: f64 = 0.005;

/// Adds the remark on how far sphere bottoms move, for a change in which centres could move instead.
pub(crate) fn remark_on_bottoms(remarks: &mut Vec<Phrase>, radii: Option<&Radii>) {
    let Some((radii, remark)) = radii.and_then(|radii| Some((radii, remark_on_moved_bottoms(radii)?))) else {
        return;
    };
    let is_far = |(least, most): (f64, f64)| most.max(-least) > CLEAR_BOTTOM_SHIFT_M;
    let at = if radii.bottom_shifts().is_some_and(is_far) { 0 } else { remarks.len() };
    remarks.insert(at, phrase![&remark, "; ", Input::Level, " keeps them where they are"]);
}

/// A remark on x/R of each sphere at equilibrium after a design, by the model's smoothed law; (11) gives x/R for the Hertz law.
pub(crate) fn remark_on_equilibrium(rests: &[f64]) -> Option<Phrase> {
    let four = |x: f64| format!("{x:.4}");
    let least = rests.iter().copied().reduce(f64::min).map(four)?;
    let most = rests.iter().copied().reduce(f64::max).map(four)?;
    let range = if least == most { most } else { format!("{least} to {most}") };
    Some(
        format!("by the model's law, (C.9) at speed 0, spheres rest at x/R = {range} under this load").into(),
    )
}
