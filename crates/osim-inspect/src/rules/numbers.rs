//! Rules about unlikely numbers of a model.

use contact_scaling::limits::SUGGESTED_CONSTANT_INDENTATION;
use osim_model::messages::{readable, shown};
use osim_model::{
    Body, Example, Finding, FindingCode, Force, Model, Orientation, Origin, Property, Repair, Rule, SetId,
    Severity, Value, VerdictOn,
};
use osim_requests::Request;

use crate::findings::Remedies;
use crate::rules::spheres::and_others;

/// The largest inertia, kg m², that a body without mass may have. Programs write tiny inertias for frames that weigh nothing.
const INERTIA_OF_FRAME: f64 = 1e-6;

pub(super) static MASSLESS_BODY: Rule = Rule {
    code: FindingCode::MasslessBody,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Mass),
    what: "A body has an inertia and a mass of 0.",
    why: "A real body with inertia has mass, and OpenSim sets the inertia to 0, too. Then the model weighs less than it should, and contacts that are made for the whole body look too stiff. A frame without mass has no inertia.",
    advice: "Write the mass of the body",
    repair: Repair::NotPossible("only you know what the body weighs"),
    example: Example::Piece {
        model: "check/known_contacts.osim",
        good: "<mass>60</mass>",
        bad: "<mass>0</mass>",
    },
};

/// One finding for all bodies with an inertia and no mass.
pub(super) fn find_massless_body(model: &Model) -> Vec<Finding> {
    let shapes = model.body_shapes();
    let has_inertia = |name: &str| {
        let trace = shapes.get(name).and_then(|shape| shape.inertia_trace);
        trace.is_some_and(|trace| trace > INERTIA_OF_FRAME)
    };
    let massless: Vec<&Body> = model
        .bodies()
        .iter()
        .filter(|body| body.mass_kg().is_ok_and(|kg| kg == 0.0) && has_inertia(&body.name))
        .collect();
    let Some(first) = massless.first() else { return Vec::new() };
    let more = and_others(massless.len(), "another body, too", "other bodies, too");
    let text = format!("{} has a mass of 0 and an inertia{more}", shown(&first.name));
    let line = model.file(first.file).line(first.mass.offset);
    vec![Finding::at(&MASSLESS_BODY, line, text).with_place(&first.path)]
}

pub(super) static DEFAULT_STIFFNESS: Rule = Rule {
    code: FindingCode::DefaultStiffness,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Mass),
    what: "A stiffness is left at its class default.",
    why: "OpenSim's default stiffness (1 N/m2 in SmoothSphereHalfSpaceForce) carries nothing; it is nearly always a forgotten value.",
    advice: "Set a stiffness, for example that of a published model",
    repair: Repair::Command("takes the contacts of a published model"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<stiffness>4.4876e7</stiffness>",
        bad: "<!-- no stiffness -->",
    },
};

pub(super) fn find_default_stiffness(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        for set in &force.sets {
            if let Some(value) = set.value(Property::Stiffness).filter(|value| is_default_stiffness(value)) {
                let text = format!("{}: stiffness is OpenSim's default, {} N/m2", force.path, value.number);
                found.push(Finding::at(&DEFAULT_STIFFNESS, set.line, text).with_place(&force.path));
            }
        }
    }
    found
}

/// A remedy for a default stiffness: the contacts of a published model.
pub(super) fn take_published_contacts(remedies: &Remedies<'_>) -> Option<Request> {
    remedies.transfer_published(None).map(Request::from)
}

/// Whether a value is a stiffness that is absent from the file, so that OpenSim takes its default.
pub(super) fn is_default_stiffness(value: &Value) -> bool {
    value.property == Property::Stiffness && value.origin == Origin::ClassDefault
}

pub(super) static ZERO_CONSTANT_CONTACT_FORCE: Rule = Rule {
    code: FindingCode::ZeroConstantContactForce,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Solver),
    what: "A SmoothSphereHalfSpaceForce has a constant_contact_force of 0.",
    why: "Simbody divides by the root of the squared slip speed plus constant_contact_force: with 0, the force is NaN whenever the sphere does not slip, even without friction. Scaling leaves a value of 0 as it is.",
    advice: "Give it a small value, for example for a constant indentation of {suggested_indentation} of the radius",
    repair: Repair::Command("designs constant_contact_force for a small constant indentation"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<constant_contact_force>0</constant_contact_force>",
    },
};

pub(super) fn find_zero_constant_contact_force(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let zero =
            force.value(SetId::FIRST, Property::ConstantContactForce).filter(|value| value.number == 0.0);
        if let Some(value) = zero {
            let line = model.file(force.file).line(value.offset);
            let text =
                format!("{}: constant_contact_force is 0: OpenSim computes NaN without slip", force.path);
            found.push(Finding::at(&ZERO_CONSTANT_CONTACT_FORCE, line, text).with_place(&force.path));
        }
    }
    found
}

pub(super) fn set_suggested_constant_indentation(remedies: &Remedies<'_>) -> Option<Request> {
    remedies.design_constant_indentation(SUGGESTED_CONSTANT_INDENTATION)
}

/// A friction coefficient above this is not plausible. Between foot and floor it is 0.3 to 1, for the stickiest rubber about 2.
const LARGEST_FRICTION: f64 = 10.0;

pub(super) static LARGE_FRICTION: Rule = Rule {
    code: FindingCode::LargeFriction,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Sizes),
    what: "A coefficient of friction is larger than that of any surface.",
    why: "Between a foot and a floor it is about 0.3 to 1. More than 10 is usually a percentage, or lacks its decimal point; a foot that slides is then stopped by a force of many times its weight.",
    advice: "Write the right coefficient, such as 0.8",
    repair: Repair::NotPossible("only you know the right number"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<static_friction>0.81</static_friction>",
        bad: "<static_friction>81</static_friction>",
    },
};

pub(super) fn find_large_friction(model: &Model) -> Vec<Finding> {
    model.forces().iter().filter_map(find_large_friction_in).collect()
}

/// Finds the first friction coefficient of a force that is too large.
fn find_large_friction_in(force: &Force) -> Option<Finding> {
    let is_friction = |property| {
        matches!(property, Property::StaticFriction | Property::DynamicFriction | Property::ViscousFriction)
    };
    let values = force.sets.iter().flat_map(|set| set.values.iter().map(move |value| (set, value)));
    let (set, large) =
        { values }.find(|(_, value)| is_friction(value.property) && value.number > LARGEST_FRICTION)?;
    let text = format!(
        "{} of {} is {}, expected at most {LARGEST_FRICTION}",
        large.property,
        force.path,
        readable(large.number)
    );
    Some(Finding::at(&LARGE_FRICTION, set.line, text).with_place(&force.path))
}

pub(super) static NO_FRICTION: Rule = Rule {
    code: FindingCode::NoFriction,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Solver),
    what: "No contact has friction.",
    why: "With all coefficients of friction 0, nothing stops a foot from sliding: a body that stands slides away at the first push.",
    advice: "Nothing, if this is intended; else write the coefficients, such as 0.8",
    repair: Repair::NotPossible("only you know the right numbers"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/no_friction.osim" },
};

/// A dissipation below this, s/m, takes away almost no energy: 0.008 would take half a percent of the speed of an impact at 1 m/s.
const LEAST_DISSIPATION_S_M: f64 = 1e-3;

pub(super) static NO_DISSIPATION: Rule = Rule {
    code: FindingCode::NoDissipation,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Solver),
    what: "No contact has dissipation.",
    why: "Contacts that take away no energy bounce for ever: a body that lands on them does not come to rest.",
    advice: "Nothing, if this is intended; else write the dissipation, for example for a restitution of {restitution}",
    repair: Repair::NotPossible("only you know the right number"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<dissipation>0.4</dissipation>",
        bad: "<dissipation>0</dissipation>",
    },
};

/// Finds models in which no force on a floor has friction, or none has dissipation.
pub(super) fn find_no_friction_or_dissipation(model: &Model) -> Vec<Finding> {
    let on_floors = || model.forces().iter().filter(|force| model.meets_half_space(force));
    let Some(first) = on_floors().next() else { return Vec::new() };
    let are_all_below = |properties: &[Property], limit: f64| {
        let sets = on_floors().flat_map(|force| &force.sets);
        let mut values = sets.flat_map(|set| properties.iter().filter_map(|&property| set.value(property)));
        values.all(|value| (0.0..limit).contains(&value.number))
    };
    let frictions = [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction];
    // Defaults of the class are no choice of anybody.
    let is_written = |property| {
        let mut values = on_floors().filter_map(|force| force.value(SetId::FIRST, property));
        values.any(|value| value.origin != Origin::ClassDefault)
    };
    let no_friction = (is_written(Property::StaticFriction) && are_all_below(&frictions, f64::MIN_POSITIVE))
        .then(|| Finding::at(&NO_FRICTION, first.line, "all coefficients of friction are 0"));
    let no_dissipation = are_all_below(&[Property::Dissipation], LEAST_DISSIPATION_S_M).then(|| {
        Finding::at(&NO_DISSIPATION, first.line, "the dissipation of all contacts is 0 s/m or nearly 0")
    });
    no_friction.into_iter().chain(no_dissipation).map(|finding| finding.with_place(&first.path)).collect()
}

pub(super) static ANGLE_IN_DEGREES: Rule = Rule {
    code: FindingCode::AngleInDegrees,
    severity: Severity::Error,
    verdict: Some(VerdictOn::Floor),
    what: "An angle of a half-space, or of a frame that carries it, is in degrees.",
    why: "OpenSim reads orientations in radians: -90 is 14 whole turns and a little more, which looks like a slope of 26.6 degrees.",
    advice: "Write the angles in radians: degrees × π/180",
    repair: Repair::NotPossible(
        "the floor has to be corrected in the file; the finding names the line and what to write",
    ),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<orientation>0 0 -1.5707963267948966</orientation>",
        bad: "<orientation>0 0 -90</orientation>",
    },
};

/// Finds half-spaces that are turned by more than a whole turn, so their angles are probably in degrees. Each orientation is reported once.
pub(super) fn find_angle_in_degrees(model: &Model) -> Vec<Finding> {
    let mut found: Vec<Finding> = Vec::new();
    let planes = model.half_spaces().into_iter().chain(model.half_spaces_inside());
    for orientation in planes.flat_map(|plane| plane.orientations) {
        let is_reported = found.iter().any(|known| known.place.as_deref() == Some(orientation.path.as_str()));
        found.extend(find_degrees_in(&orientation).filter(|_| !is_reported));
    }
    found
}

fn find_degrees_in(orientation: &Orientation) -> Option<Finding> {
    let angles = orientation.angles_rad.filter(|_| orientation.is_in_degrees())?;
    let listed = |angles: [f64; 3]| angles.map(readable).join(" ");
    let Orientation { path, tag, line, .. } = orientation;
    let text = format!(
        "{tag} of {} is {} rad, more than a whole turn: expected radians; for these degrees write <{tag}>{}</{tag}>",
        shown(path),
        listed(angles),
        listed(angles.map(f64::to_radians)),
    );
    Some(Finding::at(&ANGLE_IN_DEGREES, *line, text).with_place(path))
}
