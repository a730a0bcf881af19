//! Rules about contact forces: their surfaces, their elements in the file, and terrain. Terrain counts in no figure.

use foldhash::{HashSet, HashSetExt};
use osim_model::messages::{readable, shown};
use osim_model::opensim_text::plain_numbers;
use osim_model::{
    Body, Example, Finding, Force, ForceKind, Model, ParameterSet, Property, Repair, Rule, Selection, SetId,
    Severity, Side, Sphere,
};
use osim_requests::options::{ClassChoice, ForceOptions};
use osim_requests::{ConvertRequest, Request};

use crate::findings::{Remedies, exact_pattern};
use crate::rules::skeleton::foot_spheres_on_ground;
use crate::rules::spheres::{finding_about_spheres, other_cases_in_words};
use osim_model::rule;

/// One finding for all forces with a parameter set that `describe` has a text about: the text of the first one, and how many others. Its
/// measure is the largest of their numbers.
pub(super) fn finding_about_forces(
    model: &Model,
    rule: &'static Rule,
    describe: impl Fn(&Force, &ParameterSet) -> Option<(f64, String)>,
) -> Option<Finding> {
    let forces = model.forces().iter();
    let found = forces
        .filter_map(|force| force.sets.iter().find_map(|set| Some((force, set, describe(force, set)?))));
    let found: Vec<(&Force, &ParameterSet, (f64, String))> = found.collect();
    let (force, set, (_, text)) = found.first()?;
    let size = found.iter().map(|(.., (size, _))| *size).fold(0.0, f64::max);
    let more = other_cases_in_words(found.len(), "another force, too", "other forces, too");
    let places = found.iter().map(|(force, ..)| force.path.clone()).collect();
    let finding = Finding::at(rule, set.position, format!("{text}{more}")).with_place(&force.path);
    Some(Finding { places, ..finding.with_measure(size, "") })
}

rule! { pub(super) SEVERAL_SPHERES_ONE_FORCE: SeveralSpheres, Remark, Solver;
    what: "One HuntCrossleyForce has several spheres.",
    why: "In Simbody, when one sphere of a HuntCrossleyForce leaves the ground faster than 2/(3 dissipation), the spheres evaluated after it lose their force in that step.",
    advice: "Nothing, if feet leave the ground slowly: half of the published models have one force for each foot. Otherwise give each sphere a HuntCrossleyForce of its own",
    repair: Repair::NotPossible("published models are made so on purpose"),
    example: Example::Models { good: "table1/human_62kg_hunt_crossley.osim", bad: "format/v40000.osim" },
}

/// Finds each HuntCrossleyForce with several spheres. Spheres after the first can lose their force in a step.
pub(super) fn find_several_spheres_one_force(model: &Model) -> Vec<Finding> {
    let mut found = Vec::new();
    for force in model.forces() {
        let moving = force.spheres().iter().filter(|&&s| model.sphere(s).is_some_and(|s| !s.fixed)).count();
        if matches!(force.kind, ForceKind::HuntCrossley) && moving > 1 {
            let text = format!("{} holds {moving} spheres: Simbody can drop the force of some", force.path);
            found.push(Finding::at(&SEVERAL_SPHERES_ONE_FORCE, force.position, text).with_place(&force.path));
        }
    }
    found
}

rule! { pub(super) SPHERE_IN_TWO_FORCES: SphereInTwoForces, Warning, Mass;
    what: "One sphere is used by two contact forces.",
    why: "Both forces act, so the sphere is stiffer than either stiffness says, and the sphere count by which parameters scale is not what it seems.",
    advice: "Leave the sphere in one force",
    repair: Repair::NotPossible("only you know which force is right"),
    example: Example::Piece { model: "format/unequal_radii.osim",
        good: "<socket_sphere>/contactgeometryset/toe_r</socket_sphere>",
        bad: "<socket_sphere>/contactgeometryset/heel_r</socket_sphere>" },
}

/// Finds spheres that several forces press on a floor.
pub(super) fn find_sphere_in_two_forces(model: &Model) -> Vec<Finding> {
    let shared = model.spheres_in_several_forces().into_iter();
    let finding = |(sphere, forces): (&Sphere, Vec<&Force>)| {
        let paths: Vec<&str> = forces.iter().map(|force| force.path.as_str()).collect();
        let text = format!("sphere {} meets the ground through {}", sphere.path, paths.join(" and "));
        Finding::at(&SPHERE_IN_TWO_FORCES, sphere.position, text).with_place(&sphere.path)
    };
    shared.map(finding).collect()
}

/// Finds surfaces of a force that press nothing, press twice, or belong to the other foot: at most one finding for each rule.
pub(super) fn apply_surface_rules(model: &Model) -> Vec<Finding> {
    type DescribeForce = fn(&Model, &Force) -> Option<String>;
    let rules: [(&Rule, DescribeForce); 4] = [
        (&SURFACE_NAMED_TWICE, describe_named_twice),
        (&NO_SURFACES_MEET, describe_apart),
        (&SPHERE_OF_OTHER_SIDE, describe_other_side),
        (&SHAPE_PRESSES_NOTHING, describe_shape),
    ];
    let find = |(rule, describe): (&'static Rule, DescribeForce)| {
        // Once for each force, not for each of its parameter sets.
        finding_about_forces(model, rule, |force, set| {
            (set.id == SetId::FIRST).then(|| Some((0.0, describe(model, force)?)))?
        })
    };
    rules.into_iter().filter_map(find).collect()
}

rule! { pub(super) SURFACE_NAMED_TWICE: SurfaceNamedTwice, Warning, Mass;
    what: "A HuntCrossleyForce names a sphere or a floor more than once.",
    why: "OpenSim presses each pair of surfaces as often as the force names it, so that contacts are several times as stiff as they look. A loop in a script that adds the floor with each sphere makes such a force.",
    advice: "Name each surface once, in one of the force's parameter sets",
    repair: Repair::NotPossible("only you know which parameter set is right"),
    example: Example::Piece { model: "format/v40000.osim", good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>floor heel_l floor toe_l</geometry>" },
}

/// The message about a force that names a sphere or plane several times; `None` if it does not.
fn describe_named_twice(model: &Model, force: &Force) -> Option<String> {
    let mut spheres = HashSet::new();
    let mut all = force.sets.iter().flat_map(|set| &set.spheres);
    let sphere =
        all.find(|sphere| !spheres.insert(**sphere)).and_then(|id| Some(model.sphere(*id)?.name.clone()));
    let name = sphere.or_else(|| {
        if force.sets.iter().map(|set| set.half_spaces).sum::<usize>() < 2 {
            return None;
        }
        let mut planes = HashSet::new();
        let mut all = force.sets.iter().flat_map(|set| model.half_spaces_of(set));
        all.find(|plane| !planes.insert(plane.path.clone())).map(|plane| plane.name)
    })?;
    Some(format!("{} names {} more than once, and presses it each time", force.path, shown(&name)))
}

rule! { pub(super) NO_SURFACES_MEET: NoSurfacesMeet, Warning, Mass;
    what: "None of the surfaces of a HuntCrossleyForce can meet another one.",
    why: "A sphere presses on a half-space or on a sphere of another body that the force names, too. Without one the force is always 0.",
    advice: "Name the floor in the force",
    repair: Repair::NotPossible("only you know which floor is right"),
    example: Example::Piece { model: "format/v40000.osim", good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>heel_l toe_l</geometry>" },
}

/// The message about a force whose surfaces cannot meet; `None` if they can.
fn describe_apart(model: &Model, force: &Force) -> Option<String> {
    let has_others = force.sets.iter().any(|set| !set.other_surfaces.is_empty());
    if force.kind != ForceKind::HuntCrossley || has_others || !force.applies {
        return None;
    }
    // Surfaces of one body never meet, and all bodies that are welded to ground are ground.
    let body = |sphere: &Sphere| sphere.body.clone().filter(|_| !sphere.fixed);
    let spheres: Vec<&Sphere> = force.spheres().iter().filter_map(|&id| model.sphere(id)).collect();
    if !spheres.is_empty() && spheres.iter().all(|sphere| sphere.fixed) {
        // Terrain has a finding of its own.
        return None;
    }
    let mut bodies = spheres.into_iter().map(body);
    let first = bodies.next();
    let can_meet = first.is_some_and(|first| {
        bodies.any(|body| body != first) || model.planes_of(force).iter().any(|plane| plane.body != first)
    });
    (!can_meet)
        .then(|| format!("no two of the surfaces that {} names can meet: it presses nothing", force.path))
}

rule! { pub(super) SPHERE_OF_OTHER_SIDE: SphereOfOtherSide, Warning, Sides;
    what: "A force of one side presses a sphere of the other side.",
    why: "Scripts read the force of a foot by the names of its contact forces: the force of one foot then includes a part of the other foot's. No published model has this.",
    advice: "Name the sphere of the force's own side, or move this one to the force of the other side",
    repair: Repair::NotPossible("only you know which sphere is right"),
    example: Example::Piece { model: "format/v40000.osim", good: "<geometry>floor heel_r toe_r</geometry>",
        bad: "<geometry>floor heel_l toe_r</geometry>" },
}

/// The message about a force of one side that presses spheres of both sides; `None` if it does not.
fn describe_other_side(model: &Model, force: &Force) -> Option<String> {
    let side = Side::of_name(force.name.trim_end_matches(|letter: char| letter.is_ascii_digit()))?;
    let spheres = force.spheres().iter().filter_map(|&id| model.sphere(id));
    let sides = spheres.filter_map(|sphere| Some((sphere, Side::of_name(sphere.body.as_deref()?)?)));
    // A sphere with a name of the force's side is itself on the wrong body, which is another finding.
    let is_other =
        |(sphere, of_body): &(&Sphere, Side)| *of_body != side && Side::of_name(&sphere.name) != Some(side);
    let other: Vec<_> = sides.filter(is_other).collect();
    let (first, of_body) = other.first()?;
    let more = other_cases_in_words(other.len(), "another sphere, too", "other spheres, too");
    Some(format!(
        "{} presses {}, which is on the {} side{more}",
        force.path,
        shown(&first.name),
        of_body.as_str()
    ))
}

rule! { pub(super) SHAPE_PRESSES_NOTHING: ShapePressesNothing, Warning, Mass;
    what: "A HuntCrossleyForce names a cylinder, a torus or a mesh.",
    why: "OpenSim computes no force for such a surface in a HuntCrossleyForce: it presses nothing, and the spheres beside it carry its share.",
    advice: "Put a sphere or an ellipsoid in its place; a mesh belongs in an ElasticFoundationForce",
    repair: Repair::NotPossible("only you know which shape was meant"),
    example: Example::Models { good: "shapes/ellipsoid.osim", bad: "shapes/torus_and_cylinder.osim" },
}

/// The message about a surface of another class, which presses nothing; `None` if there is none.
fn describe_shape(model: &Model, force: &Force) -> Option<String> {
    let components = model.components();
    let &shape = force.sets.iter().flat_map(|set| &set.other_surfaces).next()?;
    Some(format!(
        "{} names {}, a {}, which presses nothing in a HuntCrossleyForce: 0 N",
        force.path,
        shown(&components.name(shape)),
        components.tag(shape)
    ))
}

rule! { pub(super) ELLIPSOID: Ellipsoid, Remark;
    what: "A contact force presses an ellipsoid.",
    why: "OpenSim presses it on a half-space in a HuntCrossleyForce. With all radii times 2 the force is 4 times as large, as that of a sphere, so its radii are scaled as those of spheres. Figures that need a sphere, such as x/R and lowest points, do not hold for it.",
    advice: "Nothing, if this is intended",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "shapes/ellipsoid.osim" },
}

/// Finds ellipsoids that are pressed on a floor.
pub(super) fn find_ellipsoid(model: &Model) -> Vec<Finding> {
    let loaded = model.loaded_spheres(&model.force_ids()).into_iter().filter_map(|id| model.sphere(id));
    let ellipsoids: Vec<&Sphere> = loaded.filter(|sphere| sphere.radii_m.is_some()).collect();
    let Some(first) = ellipsoids.first() else { return Vec::new() };
    let text = format!(
        "{} is an ellipsoid: it is scaled as a sphere is, and figures that need a sphere leave it out{}",
        shown(&first.name),
        other_cases_in_words(ellipsoids.len(), "another ellipsoid, too", "other ellipsoids, too")
    );
    finding_about_spheres(&ELLIPSOID, text, ellipsoids.iter().copied()).into_iter().collect()
}

rule! { pub(super) MOCO_DIALECT: MocoDialect, Warning;
    what: "The sphere's radius is inside the force, as in Moco 0.1 to 0.3.",
    why: "OpenSim 4.2 and later cannot read such forces; the model works in OpenSim Moco 0.1 to 0.3 only.",
    advice: "Take spheres and planes out of the forces; OpenSim 4.2 and later would lose them without a message when they save the model",
    repair: Repair::Command("makes spheres and planes members of the ContactGeometrySet, with all numbers as they are"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/moco_sphere_in_force.osim" },
}

/// Finds forces that keep their sphere inside, as in Moco 0.1 to 0.3.
pub(super) fn find_moco_dialect(model: &Model) -> Vec<Finding> {
    let inside_forces = model.spheres().iter().filter(|sphere| sphere.is_inside_force());
    let finding = |sphere: &Sphere| {
        let text = format!("{} keeps its sphere inside: OpenSim 4.2 and later cannot read it", sphere.path);
        Finding::at(&MOCO_DIALECT, sphere.position, text).with_place(&sphere.path)
    };
    inside_forces.map(finding).collect()
}

/// Whether a force has its sphere inside its own element, as in Moco 0.1 to 0.3.
fn keeps_sphere_inside(model: &Model, force: &Force) -> bool {
    force.spheres().iter().any(|&id| model.sphere(id).is_some_and(Sphere::is_inside_force))
}

/// A remedy that converts the forces which `finding` is about into a form that today's OpenSim reads. It converts all forces if all have
/// their spheres inside and the caller chose none of them.
pub(super) fn convert_moco_forces(
    remedies: &Remedies<'_>,
    model: &Model,
    finding: &Finding,
) -> Option<Request> {
    let models = remedies.models(false)?;
    let all = remedies.options.selection == Selection::default()
        && model.forces().iter().all(|force| keeps_sphere_inside(model, force));
    let forces = model.forces().iter().filter(|force| finding.paths().any(|path| *path == force.path));
    let names: Option<Vec<_>> = forces.map(|force| exact_pattern(&force.name)).collect();
    let select = if all { Vec::new() } else { names? };
    let choice = ForceOptions { select, ..ForceOptions::default() };
    let to = Some(ClassChoice::of(ForceKind::SmoothSphereHalfSpace));
    Some(ConvertRequest { models, to, choice, ..ConvertRequest::default() }.into())
}

rule! { pub(super) DEAD_DERIVATIVE_SMOOTHING: DeadDerivativeSmoothing, Warning, Solver;
    what: "The file has a derivative_smoothing element, which OpenSim ignores. It is a remark if OpenSim takes the same number without it.",
    why: "derivative_smoothing was the name of constant_contact_force in early Moco. OpenSim ignores it and uses its default of 1e-5 m2 for constant_contact_force.",
    advice: "Remove the element, and write constant_contact_force if it should have another value",
    repair: Repair::NotPossible("only you know which value is right"),
    example: Example::Piece { model: "check/within_limits.osim",
        good: "<constant_contact_force>9e-07</constant_contact_force>",
        bad: "<derivative_smoothing>9e-07</derivative_smoothing>" },
}

/// Finds an element `derivative_smoothing` that OpenSim no longer reads.
pub(super) fn find_dead_derivative_smoothing(model: &Model) -> Vec<Finding> {
    let finding = |force: &Force| {
        let document = model.file(force.file);
        let dead = document.tree().child(force.element, "derivative_smoothing")?;
        let text = format!("{}: derivative_smoothing is ignored by OpenSim", force.path);
        let finding = Finding::at(&DEAD_DERIVATIVE_SMOOTHING, document.position_of(dead), text);
        let written = plain_numbers(&document.tree().text_of(dead)).unwrap_or_default();
        let taken = force.sets.iter().find_map(|set| set.value(Property::ConstantContactForce));
        let is_same = taken.is_some_and(|taken| written == [taken.number]);
        let finding = if is_same { finding.with_severity(Severity::Remark) } else { finding };
        Some(finding.with_place(&force.path))
    };
    // Early Moco, whose forces keep their spheres inside, reads the element.
    model.forces().iter().filter(|force| !keeps_sphere_inside(model, force)).filter_map(finding).collect()
}

rule! { pub(super) TERRAIN: Terrain, Remark;
    what: "A sphere stands on ground or a body welded to it, or such a body has mass, or a plate that carries the floor.",
    why: "Such a sphere or body is scenery: it does not grow with the animal and does not carry it. It counts in no limb, no mass and no other value, and no verb changes it. A body to which others are joined does not count as scenery, so a model whose pelvis is fixed keeps its whole mass.",
    advice: "Nothing, if this is intended",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "format/v40000.osim", bad: "format/terrain_on_ground.osim" },
}

/// Finds spheres and bodies of terrain: one finding for all its spheres, and one for all its bodies.
pub(super) fn find_terrain(model: &Model) -> Vec<Finding> {
    terrain_spheres(model).into_iter().chain(terrain_bodies(model)).collect()
}

/// The finding about heavy bodies of terrain, which do not count for the model's mass.
fn terrain_bodies(model: &Model) -> Option<Finding> {
    let heavy: Vec<(&Body, f64)> = model
        .bodies()
        .iter()
        .filter(|body| body.excluded_from_mass)
        .filter_map(|body| Some((body, body.mass_kg().ok().filter(|kg| *kg > 0.0)?)))
        .collect();
    let (first, kg) = heavy.first()?;
    let text = format!(
        "{} ({} kg) {}: it is scenery and does not count in the mass of the model{}",
        first.path,
        readable(*kg),
        if first.fixed { "is welded to ground" } else { "carries the floor" },
        other_cases_in_words(heavy.len(), "another body, too", "other bodies, too")
    );
    Some(Finding::new(&TERRAIN, text).with_place(&first.path))
}

/// The finding about spheres of terrain, which do not move.
fn terrain_spheres(model: &Model) -> Option<Finding> {
    let mut used: Vec<_> = model.forces().iter().flat_map(Force::spheres).copied().collect();
    used.sort_unstable();
    used.dedup();
    // Spheres of feet have a finding of their own.
    let feet = foot_spheres_on_ground(model);
    let is_scenery =
        |sphere: &&Sphere| sphere.fixed && feet.binary_search_by_key(&sphere.id, |foot| foot.id).is_err();
    let fixed: Vec<&Sphere> = used.into_iter().filter_map(|id| model.sphere(id)).filter(is_scenery).collect();
    let first = fixed.first()?;
    let text = format!(
        "{} is on ground: it is scenery, so it is not counted and not changed{}",
        first.path,
        other_cases_in_words(fixed.len(), "another sphere, too", "other spheres, too")
    );
    finding_about_spheres(&TERRAIN, text, fixed.iter().copied())
}
