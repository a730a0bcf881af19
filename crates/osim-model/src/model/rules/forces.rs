//! Rules about contact forces: their spheres, their parameter sets, and what of them counts nowhere.

use foldhash::{HashMap, HashMapExt};

use crate::messages::readable;
use crate::model::contacts::{Force, ForceId, ForceKind, Sphere, SphereId, moving_spheres};
use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::skeleton::Body;
use crate::model::typed_model::Model;

impl Model {
    /// What is special about `forces` without being wrong, in the order of the codes.
    pub fn remarks_on(&self, forces: &[ForceId]) -> Vec<Finding> {
        let forces = || forces.iter().filter_map(|&id| self.force(id));
        let mut found: Vec<Finding> = forces().filter_map(|force| find_mixed_radii(self, force)).collect();
        found.extend(forces().filter_map(find_several_parameter_sets));
        found.extend(forces().filter_map(find_disabled_force));
        found
    }
}

pub(super) static DISABLED_FORCE: Rule = Rule {
    code: FindingCode::DisabledForce,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "A contact force that is switched off is changed with the others.",
    why: "A force that does not apply carries no load, so its spheres are not counted; it is still scaled, so that it is right once it is switched on.",
    advice: "Nothing, if that is meant; else `skip_disabled`",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r">"#,
        bad: r#"<SmoothSphereHalfSpaceForce name="contact_heel_r"><appliesForce>false</appliesForce>"#,
    },
};

fn find_disabled_force(force: &Force) -> Option<Finding> {
    let text = format!(
        "{} is switched off: it is changed with the others, and its spheres are not counted",
        force.path
    );
    (!force.applies).then(|| Finding::at(&DISABLED_FORCE, force.line, text).about(&force.path))
}

pub(super) static MIXED_RADII: Rule = Rule {
    code: FindingCode::MixedRadii,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sizes),
    what: "Radii differ within one ContactParameters.",
    why: "One ContactParameters has one modulus for all its spheres. The mean of R squared is used before and after: equal relative indentation, load in proportion to R squared.",
    advice: "Nothing, if that is meant; else give each sphere its own force",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/mixed_radii.osim" },
};

/// One set of parameters for spheres of different radii.
fn find_mixed_radii(model: &Model, force: &Force) -> Option<Finding> {
    let set = force.sets.iter().find(|set| {
        let spheres = set.spheres.iter().filter_map(|&id| model.sphere(id));
        let mut radii = spheres.filter(|sphere| !sphere.fixed).map(|sphere| sphere.radius.number);
        radii.next().is_some_and(|first| radii.any(|radius| radius != first))
    })?;
    let text = format!("{} has spheres of different radii: the mean of R squared is used", force.path);
    Some(Finding::at(&MIXED_RADII, set.line, text).about(&force.path))
}

pub(super) static SEVERAL_PARAMETER_SETS: Rule = Rule {
    code: FindingCode::SeveralParameterSets,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A force has several ContactParameters.",
    why: "The surfaces have moduli of their own and the contact uses their composite (A.3); all are multiplied by the same factor.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/three_materials.osim" },
};

fn find_several_parameter_sets(force: &Force) -> Option<Finding> {
    let used = force.sets.iter().filter(|set| !set.spheres.is_empty() || set.half_spaces > 0).count();
    let text = format!("{} has {} ContactParameters: all get the same factor", force.path, force.sets.len());
    (used > 1).then(|| Finding::at(&SEVERAL_PARAMETER_SETS, force.line, text).about(&force.path))
}

pub(super) static SEVERAL_SPHERES_ONE_FORCE: Rule = Rule {
    code: FindingCode::SeveralSpheres,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "One HuntCrossleyForce has several spheres.",
    why: "In Simbody, when one sphere of a HuntCrossleyForce leaves the ground faster than 2/(3 dissipation), the spheres evaluated after it lose their force in that step.",
    advice: "Nothing, where feet leave the ground slowly: half of the published models have one force for each foot. Else give each sphere a HuntCrossleyForce of its own",
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
            found.push(Finding::at(&SEVERAL_SPHERES_ONE_FORCE, force.line, text).about(&force.path));
        }
    }
    found
}

pub(super) static SPHERE_IN_TWO_FORCES: Rule = Rule {
    code: FindingCode::SphereInTwoForces,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Mass),
    what: "One sphere is used by two contact forces.",
    why: "Both forces act, so the sphere is stiffer than either stiffness says, and the sphere count by which parameters scale is not what it seems.",
    advice: "Leave the sphere in one force",
    repair: Repair::NotPossible("only you know which force is meant"),
    example: Example::Piece {
        model: "format/unequal_radii.osim",
        good: "<socket_sphere>/contactgeometryset/toe_r</socket_sphere>",
        bad: "<socket_sphere>/contactgeometryset/heel_r</socket_sphere>",
    },
};

pub(super) fn find_sphere_in_two_forces(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut users: HashMap<SphereId, Vec<&str>> = HashMap::new();
    for force in model.forces().iter().filter(|force| force.applies && model.meets_half_space(force)) {
        for sphere in moving_spheres(model, &[force.id]) {
            users.entry(sphere).or_default().push(&force.path);
        }
    }
    let mut shared: Vec<_> = users.into_iter().filter(|(_, forces)| forces.len() > 1).collect();
    shared.sort_unstable();
    for (index, forces) in shared {
        let Some(sphere) = model.sphere(index) else { continue };
        let text = format!("sphere {} meets the ground through {}", sphere.path, forces.join(" and "));
        found.push(Finding::at(&SPHERE_IN_TWO_FORCES, sphere.line, text).about(&sphere.path));
    }
    found
}

pub(super) static MOCO_DIALECT: Rule = Rule {
    code: FindingCode::MocoDialect,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: None,
    what: "The sphere's radius is inside the force, as in Moco 0.1 to 0.3.",
    why: "OpenSim 4.2 and later cannot read such forces; the model works in OpenSim Moco 0.1 to 0.3 only.",
    advice: "Take spheres and planes out of the forces; OpenSim 4.2 and later would drop them without a word when they save the model",
    repair: Repair::Command(
        "makes spheres and planes members of the ContactGeometrySet, with all numbers as they are",
    ),
    example: Example::Models { good: "format/v40000.osim", bad: "format/moco_sphere_in_force.osim" },
};

pub(super) fn find_moco_dialect(model: &Model) -> Vec<Finding> {
    let inside = model.spheres().iter().filter(|sphere| sphere.is_inside_force());
    let finding = |sphere: &Sphere| {
        let text = format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
        Finding::at(&MOCO_DIALECT, sphere.line, text).about(&sphere.path)
    };
    inside.map(finding).collect()
}

pub(super) static DEAD_DERIVATIVE_SMOOTHING: Rule = Rule {
    code: FindingCode::DeadDerivativeSmoothing,
    severity: Severity::Warn,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Solver),
    what: "The file has a derivative_smoothing element, which OpenSim ignores.",
    why: "derivative_smoothing was the name of constant_contact_force in early Moco. OpenSim ignores it and uses its default of 1e-5 m2 for constant_contact_force.",
    advice: "Remove the element; set constant_contact_force if another value is meant",
    repair: Repair::NotPossible("only you know which value was meant"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<derivative_smoothing>9e-07</derivative_smoothing>",
    },
};

pub(super) fn find_dead_derivative_smoothing(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    // Where the force keeps its sphere inside itself, its class is that of early Moco, and the element is alive.
    let inside = |force: &&Force| force.sets.iter().any(|set| set.half_space_inside.is_some());
    for force in model.forces().iter().filter(|force| !inside(force)) {
        let document = model.file(force.file);
        if let Some(dead) = document.tree().child(force.element, "derivative_smoothing") {
            let line = document.line(document.tree().span(dead).start);
            let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
            found.push(Finding::at(&DEAD_DERIVATIVE_SMOOTHING, line, text).about(&force.path));
        }
    }
    found
}

pub(super) static TERRAIN: Rule = Rule {
    code: FindingCode::Terrain,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: None,
    what: "A sphere stands on ground or a body welded to it, or such a body has mass.",
    why: "Such a sphere or body is scenery: it does not grow with the animal and carries nobody. It counts in no limb, no mass and no figure, and no verb changes it. A body on which others hang is none: a model whose pelvis is held weighs all that it weighs.",
    advice: "Nothing, if that is meant",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
};

/// One finding for all spheres that are scenery, and one for all bodies.
pub(super) fn find_terrain(model: &Model) -> Vec<Finding> {
    terrain_spheres(model).into_iter().chain(terrain_bodies(model)).collect()
}

fn terrain_bodies(model: &Model) -> Option<Finding> {
    let heavy: Vec<(&Body, f64)> = model
        .bodies()
        .iter()
        .filter(|body| body.scenery)
        .filter_map(|body| Some((body, body.mass_kg().ok().filter(|kg| *kg > 0.0)?)))
        .collect();
    let (first, kg) = heavy.first()?;
    let kg = readable(*kg);
    let text = match heavy.len() {
        1 => format!(
            "{} ({kg} kg) is welded to ground: it is scenery, which does not count in what the model weighs",
            first.path
        ),
        count => format!(
            "{} ({kg} kg) and {} more {} are welded to ground: they are scenery, which does not count in what the model weighs",
            first.path,
            count - 1,
            if count == 2 { "body" } else { "bodies" }
        ),
    };
    Some(Finding::new(&TERRAIN, text).about(&first.path))
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
            format!("{} stands on ground: it is scenery, which counts nowhere and stays as it is", first.path)
        }
        2 => format!("{} and one more sphere stand on ground: {SCENERY}", first.path),
        count => format!("{} and {} more spheres stand on ground: {SCENERY}", first.path, count - 1),
    };
    let finding = Finding::at(&TERRAIN, first.line, text).about(&first.path);
    Some(finding.of_spheres(fixed.iter().map(|sphere| sphere.name.clone()).collect()))
}

const SCENERY: &str = "they are scenery, which counts nowhere and stays as it is";
