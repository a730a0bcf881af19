//! Rules about unlikely numbers of a model.

use crate::rules::spheres::other_cases_in_words;
use osim_model::messages::{readable, shown, three_significant};
use osim_model::rule;
use osim_model::{
    Body, Example, Finding, Force, JointCoordinate, Model, Orientation, ParameterSet, Property, Repair,
    SetId, Severity, Value, ValueOrigin,
};

/// The largest inertia, kg m², that a body without mass may have. Programs write tiny inertias for frames that weigh nothing.
const INERTIA_OF_MASSLESS_FRAME: f64 = 1e-6;

rule! { pub(super) MASSLESS_BODY: MasslessBody, Warning, Mass;
    what: "A body has an inertia and a mass of 0.",
    why: "A real body with inertia has mass, and OpenSim sets the inertia to 0, too. Then the model weighs less than it should, and contacts that are made for the whole body look too stiff. A frame without mass has no inertia.",
    advice: "Write the mass of the body",
    repair: Repair::NotPossible("only you know what the body weighs"),
    example: Example::Piece { model: "check/known_contacts.osim", good: "<mass>60</mass>",
        bad: "<mass>0</mass>" },
}

/// One finding for all bodies with an inertia and no mass.
pub(super) fn find_massless_body(model: &Model) -> Vec<Finding> {
    let shapes = model.body_shapes();
    let has_inertia = |name: &str| {
        let inertia = shapes.get(name).and_then(|shape| shape.inertia_kg_m2);
        inertia.is_some_and(|[xx, yy, zz, ..]| xx + yy + zz > INERTIA_OF_MASSLESS_FRAME)
    };
    let massless: Vec<&Body> = model
        .bodies()
        .iter()
        .filter(|body| body.mass_kg().is_ok_and(|kg| kg == 0.0) && has_inertia(&body.name))
        .collect();
    let Some(first) = massless.first() else { return Vec::new() };
    let more = other_cases_in_words(massless.len(), "another body, too", "other bodies, too");
    let text = format!("{} has a mass of 0 and an inertia{more}", shown(&first.name));
    let position = model.file(first.file).position(first.mass.offset);
    vec![Finding::at(&MASSLESS_BODY, position, text).with_place(&first.path)]
}

/// A default value may be outside its range by this much, rad or m, as in OpenSim.
const RANGE_TOLERANCE: f64 = 1e-7;
/// A default value that is outside by at most this part of the range is in the right unit.
const SMALL_PART_OF_RANGE: f64 = 0.1;
/// One that is outside by more than this, rad or m, is not.
const MOST_IN_RIGHT_UNIT: f64 = 0.5;
/// The range of a coordinate without one in the file, rad or m.
const RANGE_OF_CLASS: [f64; 2] = [-10.0, 10.0];

rule! { pub(super) DEFAULT_OUTSIDE_RANGE: DefaultOutsideRange, Warning, Standing;
    what: "The default value of a coordinate is outside the coordinate's own range. It is an error if the coordinate is clamped, else a remark if the value is outside by at most a tenth of the range.",
    why: "OpenSim reads radians and metres; mostly the value is in degrees or millimetres. It refuses a model with such a value in a clamped coordinate, and starts others from a pose that no joint has.",
    advice: "Write the value in radians or metres, or correct the range",
    repair: Repair::NotPossible("only you know the right pose"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/default_outside_range.osim" },
}

/// One finding for all coordinates whose default value is outside their range.
pub(super) fn find_default_outside_range(model: &Model) -> Vec<Finding> {
    let range_of = |coordinate: &JointCoordinate| coordinate.range.unwrap_or(RANGE_OF_CLASS);
    let is_outside_by = |coordinate: &JointCoordinate, distance: f64| {
        let [least, most] = range_of(coordinate);
        coordinate.default.is_some_and(|value| value < least - distance || value > most + distance)
    };
    let severity_of = |one: &JointCoordinate| {
        let [least, most] = range_of(one);
        match one.clamped {
            true => Severity::Error,
            false if is_outside_by(one, (SMALL_PART_OF_RANGE * (most - least)).min(MOST_IN_RIGHT_UNIT)) => {
                Severity::Warning
            }
            false => Severity::Remark,
        }
    };
    let all = model.joints().iter().flat_map(|joint| joint.coordinates.iter().map(move |one| (joint, one)));
    let found: Vec<_> = all.filter(|(_, one)| is_outside_by(one, RANGE_TOLERANCE)).collect();
    // The first of the worst.
    let Some((joint, worst)) = found.iter().rev().max_by_key(|(_, one)| severity_of(one)) else {
        return Vec::new();
    };
    let [least, most] = range_of(worst).map(three_significant);
    let text = format!(
        "the default value of {} is {}, outside its range of {least} to {most} (radians or metres){}{}",
        shown(&worst.name),
        readable(worst.default.unwrap_or_default()),
        if worst.clamped { ": OpenSim refuses the model" } else { "" },
        other_cases_in_words(found.len(), "another coordinate, too", "other coordinates, too")
    );
    let document = model.file(joint.file);
    let position = document.position_of(worst.element);
    vec![Finding::at(&DEFAULT_OUTSIDE_RANGE, position, text).with_severity(severity_of(worst))]
}

rule! { pub(super) DEFAULT_STIFFNESS: DefaultStiffness, Error, Mass;
    what: "A stiffness is left at its class default.",
    why: "OpenSim's default stiffness (1 N/m2 in SmoothSphereHalfSpaceForce) carries nothing; it is nearly always a forgotten value.",
    advice: "Set a stiffness, for example that of a published model",
    repair: Repair::Command("takes the contacts of a published model"),
    example: Example::Piece { model: "check/within_limits.osim", good: "<stiffness>4.4876e7</stiffness>",
        bad: "<!-- no stiffness -->" },
}

/// Finds contacts without a stiffness in the file, for which OpenSim takes its default.
pub(super) fn find_default_stiffness(model: &Model) -> Vec<Finding> {
    let all = model.forces().iter().flat_map(|force| force.sets.iter().map(move |set| (force, set)));
    let finding = |(force, set): (&Force, &ParameterSet)| {
        let value = set.value(Property::Stiffness).filter(|value| is_default_stiffness(value))?;
        let text = format!("{}: stiffness is OpenSim's default, {} N/m2", force.path, value.number);
        Some(Finding::at(&DEFAULT_STIFFNESS, set.position, text).with_place(&force.path))
    };
    all.filter_map(finding).collect()
}

/// Whether a value is a stiffness that is absent from the file, so that OpenSim takes its default.
pub(super) fn is_default_stiffness(value: &Value) -> bool {
    value.property == Property::Stiffness && value.origin == ValueOrigin::ClassDefault
}

rule! { pub(super) ZERO_CONSTANT_CONTACT_FORCE: ZeroConstantContactForce, Error, Solver;
    what: "A SmoothSphereHalfSpaceForce has a constant_contact_force of 0.",
    why: "Simbody divides by the root of the squared slip speed plus constant_contact_force: with 0, the force is NaN whenever the sphere does not slip, even without friction. Scaling leaves a value of 0 as it is.",
    advice: "Give it a small value, for example for a constant indentation of {suggested_indentation} of the radius",
    repair: Repair::Command("designs constant_contact_force for a small constant indentation"),
    example: Example::ElementText { tag: "constant_contact_force", good: "9e-07", bad: "0" },
}

/// Finds smoothed forces whose `constant_contact_force` is 0.
pub(super) fn find_zero_constant_contact_force(model: &Model) -> Vec<Finding> {
    let finding = |force: &Force| {
        let value = force.value(SetId::FIRST, Property::ConstantContactForce);
        let position = model.file(force.file).position(value.filter(|value| value.number == 0.0)?.offset);
        let text = format!("{}: constant_contact_force is 0: OpenSim computes NaN without slip", force.path);
        Some(Finding::at(&ZERO_CONSTANT_CONTACT_FORCE, position, text).with_place(&force.path))
    };
    model.forces().iter().filter_map(finding).collect()
}

rule! { pub(super) ANGLE_IN_DEGREES: AngleInDegrees, Error, Floor;
    what: "An angle of a half-space or of a frame is in degrees.",
    why: "OpenSim reads orientations in radians: -90 is 14 whole turns and a little more, which looks like a slope of 26.6 degrees.",
    advice: "Write the angles in radians: degrees × π/180",
    repair: Repair::NotPossible("the angle has to be corrected in the file; the finding names the line and what to write"),
    example: Example::ElementText { tag: "orientation", good: "0 0 -1.5707963267948966", bad: "0 0 -90" },
}

/// One finding for all half-spaces and frames that are turned by more than a whole turn, so their angles are probably in degrees.
pub(super) fn find_angle_in_degrees(model: &Model) -> Vec<Finding> {
    let listed = |angles: [f64; 3]| angles.map(readable).join(" ");
    let finding = |one: Orientation| {
        let angles = one.angles_rad.filter(|_| one.is_in_degrees())?;
        let text = format!(
            "{tag} of {} is {} rad, more than a whole turn: expected radians; for these degrees write <{tag}>{}</{tag}>",
            shown(&one.path),
            listed(angles),
            listed(angles.map(f64::to_radians)),
            tag = one.tag,
        );
        Some(Finding::at(&ANGLE_IN_DEGREES, one.position, text).with_place(&one.path))
    };
    let all: Vec<Finding> = Orientation::all_in_degrees(model.components()).filter_map(finding).collect();
    Finding::join_cases(&all).into_iter().collect()
}
