//! Rules about contact forces: their spheres, their elements in the file, and terrain. Terrain counts in no figure.

use osim_model::messages::readable;
use osim_model::{
    Body, Example, Finding, FindingCode, Force, ForceKind, Model, Repair, Rule, Selection, Severity, Sphere,
    VerdictOn,
};
use osim_requests::options::{ClassChoice, ForceOptions};
use osim_requests::{ConvertRequest, Request};

use crate::findings::{Remedies, exact_pattern};
use crate::rules::spheres::about_spheres;

pub(super) static SEVERAL_SPHERES_ONE_FORCE: Rule = Rule {
    code: FindingCode::SeveralSpheres,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Solver),
    what: "One HuntCrossleyForce has several spheres.",
    why: "In Simbody, when one sphere of a HuntCrossleyForce leaves the ground faster than 2/(3 dissipation), the spheres evaluated after it lose their force in that step.",
    advice: "Nothing, if feet leave the ground slowly: half of the published models have one force for each foot. Otherwise give each sphere a HuntCrossleyForce of its own",
    repair: Repair::NotPossible("published models are made so on purpose"),
    example: Example::Models { good: "table1/human_62kg_hunt_crossley.osim", bad: "format/v40000.osim" },
};

pub(super) fn find_several_spheres_one_force(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let moving =
            force.spheres().into_iter().filter(|&s| model.sphere(s).is_some_and(|s| !s.fixed)).count();
        if matches!(force.kind, ForceKind::HuntCrossley) && moving > 1 {
            let text = format!("{} holds {moving} spheres: Simbody can drop the force of some", force.path);
            found.push(Finding::at(&SEVERAL_SPHERES_ONE_FORCE, force.line, text).with_place(&force.path));
        }
    }
    found
}

pub(super) static SPHERE_IN_TWO_FORCES: Rule = Rule {
    code: FindingCode::SphereInTwoForces,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Mass),
    what: "One sphere is used by two contact forces.",
    why: "Both forces act, so the sphere is stiffer than either stiffness says, and the sphere count by which parameters scale is not what it seems.",
    advice: "Leave the sphere in one force",
    repair: Repair::NotPossible("only you know which force is right"),
    example: Example::Piece {
        model: "format/unequal_radii.osim",
        good: "<socket_sphere>/contactgeometryset/toe_r</socket_sphere>",
        bad: "<socket_sphere>/contactgeometryset/heel_r</socket_sphere>",
    },
};

pub(super) fn find_sphere_in_two_forces(model: &Model) -> Vec<Finding> {
    let shared = model.spheres_in_several_forces().into_iter();
    let finding = |(sphere, forces): (&Sphere, Vec<&Force>)| {
        let paths: Vec<&str> = forces.iter().map(|force| force.path.as_str()).collect();
        let text = format!("sphere {} meets the ground through {}", sphere.path, paths.join(" and "));
        Finding::at(&SPHERE_IN_TWO_FORCES, sphere.line, text).with_place(&sphere.path)
    };
    shared.map(finding).collect()
}

pub(super) static MOCO_DIALECT: Rule = Rule {
    code: FindingCode::MocoDialect,
    severity: Severity::Warning,
    verdict: None,
    what: "The sphere's radius is inside the force, as in Moco 0.1 to 0.3.",
    why: "OpenSim 4.2 and later cannot read such forces; the model works in OpenSim Moco 0.1 to 0.3 only.",
    advice: "Take spheres and planes out of the forces; OpenSim 4.2 and later would lose them without a message when they save the model",
    repair: Repair::Command(
        "makes spheres and planes members of the ContactGeometrySet, with all numbers as they are",
    ),
    example: Example::Models { good: "format/v40000.osim", bad: "format/moco_sphere_in_force.osim" },
};

pub(super) fn find_moco_dialect(model: &Model) -> Vec<Finding> {
    let inside_forces = model.spheres().iter().filter(|sphere| sphere.is_inside_force());
    let finding = |sphere: &Sphere| {
        let text = format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
        Finding::at(&MOCO_DIALECT, sphere.line, text).with_place(&sphere.path)
    };
    inside_forces.map(finding).collect()
}

/// Whether a force has its sphere inside its own element, as in Moco 0.1 to 0.3.
fn keeps_sphere_inside(model: &Model, force: &Force) -> bool {
    force.spheres().into_iter().any(|id| model.sphere(id).is_some_and(Sphere::is_inside_force))
}

/// A remedy that converts the force which `finding` is about into a form that today's OpenSim reads. It converts all forces if all have
/// their spheres inside and the caller chose none of them.
pub(super) fn convert_moco_forces(
    remedies: &Remedies<'_>,
    model: &Model,
    finding: &Finding,
) -> Option<Request> {
    let models = remedies.models(false)?;
    let all = remedies.options.selection == Selection::default()
        && model.forces().iter().all(|force| keeps_sphere_inside(model, force));
    let force = model.forces().iter().find(|force| Some(force.path.as_str()) == finding.place.as_deref())?;
    let select = if all { Vec::new() } else { vec![exact_pattern(&force.name)?] };
    let choice = ForceOptions { select, ..ForceOptions::default() };
    let to = Some(ClassChoice::of(ForceKind::SmoothSphereHalfSpace));
    Some(ConvertRequest { models, to, choice, ..ConvertRequest::default() }.into())
}

pub(super) static DEAD_DERIVATIVE_SMOOTHING: Rule = Rule {
    code: FindingCode::DeadDerivativeSmoothing,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Solver),
    what: "The file has a derivative_smoothing element, which OpenSim ignores.",
    why: "derivative_smoothing was the name of constant_contact_force in early Moco. OpenSim ignores it and uses its default of 1e-5 m2 for constant_contact_force.",
    advice: "Remove the element, and write constant_contact_force if it should have another value",
    repair: Repair::NotPossible("only you know which value is right"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<derivative_smoothing>9e-07</derivative_smoothing>",
    },
};

pub(super) fn find_dead_derivative_smoothing(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    // Early Moco, whose forces keep their spheres inside, reads the element.
    for force in model.forces().iter().filter(|force| !keeps_sphere_inside(model, force)) {
        let document = model.file(force.file);
        if let Some(dead) = document.tree().child(force.element(), "derivative_smoothing") {
            let line = document.line(document.tree().span(dead).start);
            let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
            found.push(Finding::at(&DEAD_DERIVATIVE_SMOOTHING, line, text).with_place(&force.path));
        }
    }
    found
}

pub(super) static TERRAIN: Rule = Rule {
    code: FindingCode::Terrain,
    severity: Severity::Remark,
    verdict: None,
    what: "A sphere stands on ground or a body welded to it, or such a body has mass, or a plate that carries the floor.",
    why: "Such a sphere or body is scenery: it does not grow with the animal and does not carry it. It counts in no limb, no mass and no other value, and no verb changes it. A body to which others are joined does not count as scenery, so a model whose pelvis is fixed keeps its whole mass.",
    advice: "Nothing, if this is intended",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
};

/// Finds spheres and bodies of terrain: one finding for all its spheres, and one for all its bodies.
pub(super) fn find_terrain(model: &Model) -> Vec<Finding> {
    terrain_spheres(model).into_iter().chain(terrain_bodies(model)).collect()
}

fn terrain_bodies(model: &Model) -> Option<Finding> {
    let heavy: Vec<(&Body, f64)> = model
        .bodies()
        .iter()
        .filter(|body| body.excluded_from_mass)
        .filter_map(|body| Some((body, body.mass_kg().ok().filter(|kg| *kg > 0.0)?)))
        .collect();
    let (first, kg) = heavy.first()?;
    let kg = readable(*kg);
    let text = match heavy.len() {
        1 => format!(
            "{} ({kg} kg) {}: it is scenery and does not count in the mass of the model",
            first.path,
            if first.fixed { "is welded to ground" } else { "carries the floor" }
        ),
        count => format!(
            "{} ({kg} kg) and {} more {} are welded to ground or carry the floor: they are scenery and do not count in the mass of the model",
            first.path,
            count - 1,
            if count == 2 { "body" } else { "bodies" }
        ),
    };
    Some(Finding::new(&TERRAIN, text).with_place(&first.path))
}

fn terrain_spheres(model: &Model) -> Option<Finding> {
    let mut used: Vec<_> = model.forces().iter().flat_map(Force::spheres).collect();
    used.sort_unstable();
    used.dedup();
    let fixed: Vec<&Sphere> =
        used.into_iter().filter_map(|id| model.sphere(id)).filter(|sphere| sphere.fixed).collect();
    let first = fixed.first()?;
    let text = match fixed.len() {
        1 => {
            format!("{} is on ground: it is scenery, so it is not counted and not changed", first.path)
        }
        2 => format!("{} and one more sphere are on ground: {SCENERY}", first.path),
        count => format!("{} and {} more spheres are on ground: {SCENERY}", first.path, count - 1),
    };
    about_spheres(&TERRAIN, text, fixed.iter().copied())
}

const SCENERY: &str = "they are scenery, so they are not counted and not changed";
