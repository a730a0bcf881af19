//! Rules that also apply to changes, or that compare two sources. Rules about one model are in `osim-inspect`, rules about changes alone in
//! `osim-patch` and `osim-planning`.

use contact_scaling::modulus;

use crate::messages::{Phrase, phrase, readable};
use crate::model::{Example, Finding, Force, ForceId, Model, Repair, Rule, Severity, Sphere};
use crate::rule;

/// The rules of this crate.
pub const RULES: &[&Rule] = &[
    &MASS_SOURCES_DISAGREE,
    &MIXED_RADII,
    &SEVERAL_PARAMETER_SETS,
    &DISABLED_FORCE,
    &FACTORS_DISAGREE,
    &NOT_A_SCALED_COPY,
];

rule! { MASS_SOURCES_DISAGREE: MassSourcesDisagree, Warning, Mass;
    what: "The note, `mass` and the bodies give different masses.",
    why: "The factor of every change follows from the mass the contacts are made for; a wrong one scales all of them wrongly.",
    advice: "Scale the bodies to the mass of the contacts, or the contacts to that of the bodies. If one of the masses is wrong, give the right one with `contacts_mass=KG` or `mass=KG`",
    repair: Repair::NotPossible("only you know which of the masses is right"),
    example: Example::Models { good: "walks/child.osim", bad: "walks/scaled_noted.osim" },
}

/// The finding that another source gives another mass than the one that was used. Each mass is in kg, with its source.
pub(crate) fn mass_sources_disagree(
    (taken_kg, taken): (f64, &Phrase),
    (kg, source): (f64, &Phrase),
) -> Finding {
    let message = phrase![
        "contacts are taken as made for {} kg ({}), but {} says {} kg";
        readable(taken_kg), taken, source, readable(kg)
    ];
    Finding::new(&MASS_SOURCES_DISAGREE, message).with_measure((taken_kg / kg).ln().abs(), "")
}

/// The remark that the bodies do not yet have the mass that the caller gave and for which the contacts are made.
pub(crate) fn bodies_not_scaled(bodies_kg: f64, contacts_kg: f64) -> Finding {
    let message = format!(
        "the bodies weigh {} kg, and the contacts are for {} kg: scale the bodies, too, before you simulate",
        readable(bodies_kg),
        readable(contacts_kg)
    );
    let finding = Finding::new(&MASS_SOURCES_DISAGREE, message).with_severity(Severity::Remark);
    finding.with_measure((bodies_kg / contacts_kg).ln().abs(), "")
}

impl Model {
    /// Remarks on `forces` with special but permitted properties, in the order of the codes.
    pub fn remarks_on(&self, forces: &[ForceId]) -> Vec<Finding> {
        let forces = || forces.iter().filter_map(|&id| self.force(id));
        let mut remarks: Vec<Finding> = forces().filter_map(|force| find_mixed_radii(self, force)).collect();
        remarks.extend(forces().filter_map(find_several_parameter_sets));
        match forces().next() {
            Some(first) if forces().all(|force| !force.applies) => {
                remarks.push(all_disabled(first, forces().count()));
            }
            _ => remarks.extend(forces().filter_map(find_disabled_force)),
        }
        Finding::group_by_cause(remarks)
    }
}

rule! { DISABLED_FORCE: DisabledForce, Remark, Sides;
    what: "A contact force that is switched off is changed with the others. It is a warning if all are switched off.",
    why: "A force that does not apply carries no load, so its spheres are not counted; it is still scaled, so that it is right once it is switched on.",
    advice: "Nothing, if this is intended; else `skip_disabled`",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece { model: "check/within_limits.osim",
        good: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r">"#,
        bad: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r"><appliesForce>false</appliesForce>"# },
}

fn find_disabled_force(force: &Force) -> Option<Finding> {
    if force.applies {
        return None;
    }
    let text = format!(
        "{} is switched off: it is changed with the others, and its spheres are not counted",
        force.path
    );
    Some(Finding::at(&DISABLED_FORCE, force.position, text).with_place(&force.path))
}

/// The warning that all `count` contact forces are switched off.
fn all_disabled(first: &Force, count: usize) -> Finding {
    let text = match count {
        1 => format!("{}, the only contact force, is switched off: nothing carries the model", first.path),
        _ => format!("all {count} contact forces are switched off: nothing carries the model"),
    };
    let finding = Finding::at(&DISABLED_FORCE, first.position, text).with_place(&first.path);
    finding.with_severity(Severity::Warning)
}

rule! { MIXED_RADII: MixedRadii, Remark, Sizes;
    what: "Radii differ within one ContactParameters.",
    why: "One ContactParameters has one modulus for all its spheres. The mean of R squared is used before and after: equal relative indentation, load in proportion to R squared.",
    advice: "Nothing, if this is intended; else give each sphere its own force",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/mixed_radii.osim" },
}

/// The remark that one set of parameters is for spheres of different radii.
fn find_mixed_radii(model: &Model, force: &Force) -> Option<Finding> {
    let pairs = model.sphere_pairs(force);
    if !pairs.is_empty() {
        let radius = |pair: [&Sphere; 2]| {
            let [one, other] = pair.map(|sphere| sphere.radius.number);
            modulus::composite_radius(one, other).ok()
        };
        let mut radii = pairs.into_iter().filter_map(radius);
        let differ = radii.next().is_some_and(|first| radii.any(|radius| radius != first));
        let text =
            format!("{} has pairs of different R1 R2/(R1 + R2): the mean of its square is used", force.path);
        return differ.then(|| Finding::at(&MIXED_RADII, force.position, text).with_place(&force.path));
    }
    let set = force.sets.iter().find(|set| {
        let spheres = set.spheres.iter().filter_map(|&id| model.sphere(id));
        let mut radii = spheres.filter(|sphere| !sphere.fixed).map(|sphere| sphere.radius.number);
        radii.next().is_some_and(|first| radii.any(|radius| radius != first))
    })?;
    let text = format!("{} has spheres of different radii: the mean of R squared is used", force.path);
    Some(Finding::at(&MIXED_RADII, set.position, text).with_place(&force.path))
}

rule! { SEVERAL_PARAMETER_SETS: SeveralParameterSets, Remark;
    what: "A force has several ContactParameters.",
    why: "The surfaces have moduli of their own and the contact uses their composite (A.3); all are multiplied by the same factor.",
    advice: "Nothing, if this is intended",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/three_materials.osim" },
}

fn find_several_parameter_sets(force: &Force) -> Option<Finding> {
    let used = force.sets.iter().filter(|set| !set.spheres.is_empty() || set.half_spaces > 0).count();
    if used < 2 {
        return None;
    }
    let text = format!("{} has {} ContactParameters: all get the same factor", force.path, force.sets.len());
    Some(Finding::at(&SEVERAL_PARAMETER_SETS, force.position, text).with_place(&force.path))
}

rule! { pub(crate) FACTORS_DISAGREE: FactorsDisagree, Warning;
    what: "Two sources give different scale factors of a body.",
    why: "A sphere's place and size follow from its body's factors; the first source in the order given, scale file, mesh, joint offset was taken.",
    advice: "Look at `inspect from`, and give `body_scale=BODY=x,y,z` where another source is right",
    repair: Repair::OnlyInChange("only you know which source is right"),
    example: Example::Request {
        good: r#"{"verb": "transfer", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim", "follow_bodies": true}"#,
        bad: r#"{"verb": "transfer", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim", "follow_bodies": true, "body_scale": {"calcn_r": [1.02, 0.91, 0.95]}}"# },
}

rule! { NOT_A_SCALED_COPY: NotAScaledCopy, Warning;
    what: "A model is not a scaled copy of the reference whose contacts follow its bodies.",
    why: "In a scaled copy, joint offsets and meshes give each factor exactly. Between different models offsets are not factors: a body then gets the ratio of the mesh factors of the same bone, else one ratio of distances to a joint below it, and the last body of a limb the factors of its parent body.",
    advice: "Nothing, if it is another model on purpose; else name the generic model that this one was scaled from, or give `body_scale=BODY=x,y,z`",
    repair: Repair::OnlyInChange("only you know which model this one was scaled from"),
    example: Example::Request {
        good: r#"{"verb": "inspect", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim"}"#,
        bad: r#"{"verb": "inspect", "models": ["scale_tool/scaled_smooth.osim"], "from": "feet/human_40000.osim"}"# },
}

/// The consequence if models are different, for the end of the message.
const OTHER_SOURCE_OF_FACTORS: &str =
    "so factors are those of the same bone's mesh, or ratios of distances between joints";

/// The finding that the model is not a scaled copy; `message` says what differs.
pub(crate) fn not_a_scaled_copy(mut message: Phrase) -> Finding {
    message.push(OTHER_SOURCE_OF_FACTORS);
    Finding::new(&NOT_A_SCALED_COPY, message)
}
