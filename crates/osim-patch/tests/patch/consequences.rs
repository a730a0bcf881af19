//! Tests of what a plan reports about a change: equations, factors, remarks, findings, refusals.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{
    Axis, Companion, Document, Fault, FindingCode, LevelAxis, Mass, MassSource, Model, Property, PropertySet,
    RadiusRule, Selection,
};
use osim_patch::{ChangedBy, Plan, Rescale, Transfer, reference_of_model, rescale, transfer};

const ONE_FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");

fn mass_of_bodies(kg: f64) -> Mass {
    Mass { kg, source: MassSource::ContactsMass }
}

/// A rescaling from 10 kg to 80 kg: lengths become exactly twice as large.
fn rescale_to_80_kg() -> Rescale {
    Rescale::new(80.0, mass_of_bodies(10.0))
}

fn try_rescaled(text: &str, change: impl FnOnce(&mut Rescale)) -> Result<Plan, Fault> {
    let model = Model::parse(text.as_bytes()).unwrap();
    let mut wanted = rescale_to_80_kg();
    change(&mut wanted);
    rescale(&model, &Selection::default().apply(&model).unwrap(), &wanted)
}

fn plan_of_rescaling(text: &str, change: impl FnOnce(&mut Rescale)) -> Plan {
    try_rescaled(text, change).unwrap()
}

fn finding_codes(plan: &Plan) -> Vec<FindingCode> {
    plan.findings.iter().map(osim_model::Finding::code).collect()
}

fn change_of_property(plan: &Plan, property: Property) -> &osim_patch::NumberChange {
    plan.changes.iter().find(|change| change.property == property).unwrap()
}

#[test]
fn the_plan_names_the_equation_of_a_new_radius() {
    let radius = |rule| {
        let plan = plan_of_rescaling(ONE_FOOT, |wanted| wanted.radius = rule);
        let change = change_of_property(&plan, Property::Radius);
        (change.by.as_str(), change.factor, change.to)
    };
    assert_eq!(radius(RadiusRule::Isometric), ("8", Some(2.0), 0.06));
    assert_eq!(radius(RadiusRule::Factor(3.0)), ("given", Some(3.0), 0.09));
    assert_eq!(radius(RadiusRule::Metres(0.1)), ("given", None, 0.1));
}

#[test]
fn the_remark_gives_distance_and_direction_of_moved_sphere_bottoms() {
    let remarks = |rule| {
        plan_of_rescaling(ONE_FOOT, |wanted| wanted.radius = rule)
            .remarks
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("; ")
    };
    assert!(remarks(RadiusRule::Isometric).contains("points of spheres move 30.00 mm down"));
    assert!(remarks(RadiusRule::Metres(0.02)).contains("points of spheres move 10.00 mm up"));
    assert!(!remarks(RadiusRule::Keep).contains("bottoms"));
    let two = ONE_FOOT
        .replace(
            "</ContactSphere>",
            "</ContactSphere><ContactSphere name=\"toe_r\"><socket_frame>/bodyset/foot_r</socket_frame>\
             <radius>0.01</radius></ContactSphere>",
        )
        .replace(
            "</SmoothSphereHalfSpaceForce>",
            "</SmoothSphereHalfSpaceForce><SmoothSphereHalfSpaceForce name=\"contact_toe_r\">\
             <socket_sphere>/contactgeometryset/toe_r</socket_sphere>\
             <socket_half_space>/contactgeometryset/floor</socket_half_space><stiffness>1e6</stiffness>\
             </SmoothSphereHalfSpaceForce>",
        );
    let remarks = plan_of_rescaling(&two, |_| ())
        .remarks
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("; ");
    assert!(remarks.contains("points of spheres move 10.00 to 30.00 mm down"), "{remarks}");
}

#[test]
fn the_first_line_gives_the_mass_ratio() {
    assert_eq!(
        plan_of_rescaling(ONE_FOOT, |_| ()).taken.to_string(),
        "contacts made for 10 kg (`contacts_mass`); scaled to 80 kg (mass x8)"
    );
}

#[test]
fn level_spheres_keep_their_bottoms() {
    let text = ONE_FOOT.replace("<radius>", "<location>0.1 -0.02 0.3</location><radius>");
    let plan = plan_of_rescaling(&text, |wanted| {
        wanted.level = Some(LevelAxis::of_gravity(Some([0.0, -9.81, 0.0])));
    });
    let place = &plan.moves[0];
    // R grows from 0.03 to 0.06: the centre rises by 0.03.
    assert_eq!((place.from, place.by), ([0.1, -0.02, 0.3], ChangedBy::Level));
    assert!((place.to[1] - 0.01).abs() < 1e-15 && place.to[0] == 0.1 && place.to[2] == 0.3);
    assert!(!place.inserted);
    // A sphere without a location stands at the origin, and gets one.
    let plan = plan_of_rescaling(ONE_FOOT, |wanted| {
        wanted.level = Some(LevelAxis { axis: Axis::Z, down: true, of_body: false });
    });
    assert!(plan.moves[0].inserted);
    assert_eq!(plan.moves[0].to, [0.0, 0.0, -0.03]);
}

#[test]
fn friction_is_scaled_only_on_request_with_a_finding() {
    let text = ONE_FOOT.replace(
        "</dissipation>",
        "</dissipation><viscous_friction>0.5</viscous_friction><transition_velocity>0.2</transition_velocity>",
    );
    assert!(!finding_codes(&plan_of_rescaling(&text, |_| ())).contains(&FindingCode::FrictionNotSimilar));
    let plan = plan_of_rescaling(&text, |wanted| wanted.properties = PropertySet::default().with_friction());
    assert!(finding_codes(&plan).contains(&FindingCode::FrictionNotSimilar));
    // Speeds follow the root of the length (2): numbers from theory.md's rule with rho = 2, computed by hand.
    assert!(
        (change_of_property(&plan, Property::TransitionVelocity).to - 0.2 * std::f64::consts::SQRT_2).abs()
            < 1e-15
    );
    assert!(
        (change_of_property(&plan, Property::ViscousFriction).to - 0.5 / std::f64::consts::SQRT_2).abs()
            < 1e-15
    );
}

#[test]
fn the_transition_velocity_of_a_hunt_crossley_force_is_the_forces_own() {
    let text = include_str!("../../../../fixtures/table1/mouse_hunt_crossley.osim");
    let plan = plan_of_rescaling(text, |wanted| wanted.properties = PropertySet::default().with_friction());
    let change = change_of_property(&plan, Property::TransitionVelocity);
    assert_eq!(change.set, None);
    assert!((change.factor.unwrap() - std::f64::consts::SQRT_2).abs() < 1e-15);
    assert!(!finding_codes(&plan).contains(&FindingCode::FrictionNotSimilar));
}

#[test]
fn where_the_forms_of_14_part_a_remark_has_both() {
    // From 10 to 190 kg, by hand: 2 s/m * 19^(-1/6) = 1.224 s/m by mass, and 2 s/m by the radius that stays.
    let remarks = |kg: f64, rule: RadiusRule| {
        let plan = plan_of_rescaling(ONE_FOOT, |wanted| {
            wanted.target_mass_kg = kg;
            wanted.radius = rule;
        });
        plan.remarks.iter().map(|remark| format!("{remark}\n")).collect::<String>()
    };
    let both = remarks(190.0, RadiusRule::Keep);
    assert!(both.contains("2 s/m by radius") && both.contains("1.224 s/m by mass"), "{both}");
    // The horse of Table 1: 545 kg on 15 mm from 62 kg on 32 mm, 2.921 and 1.392 s/m (mpmath).
    let horse = remarks(10.0 * 545.0 / 62.0, RadiusRule::Factor(15.0 / 32.0));
    assert!(horse.contains("2.921 s/m by radius") && horse.contains("1.392 s/m by mass"), "{horse}");
    assert!(!remarks(190.0, RadiusRule::Isometric).contains("by radius"));
    // 1.1^6 = 1.7716 is the largest ratio of masses without a remark where the radius stays.
    assert!(!remarks(17.7, RadiusRule::Keep).contains("by radius"));
    assert!(remarks(17.8, RadiusRule::Keep).contains("by radius"));
}

#[test]
fn a_force_that_is_switched_off_is_named() {
    let off = ONE_FOOT.replace("<stiffness>", "<appliesForce>false</appliesForce><stiffness>");
    assert!(finding_codes(&plan_of_rescaling(&off, |_| ())).contains(&FindingCode::DisabledForce));
    assert!(!finding_codes(&plan_of_rescaling(ONE_FOOT, |_| ())).contains(&FindingCode::DisabledForce));
}

#[test]
fn factors_follow_the_models_own_gravity_or_a_zero_gravity_is_refused() {
    let to = |gravity: f64| move |wanted: &mut Rescale| wanted.target_gravity_m_s2 = Some(gravity);
    let plan = plan_of_rescaling(ONE_FOOT, to(2.0 * 9.81));
    assert_eq!(change_of_property(&plan, Property::Stiffness).factor, Some(4.0));
    assert!(plan.remarks.iter().map(ToString::to_string).collect::<String>().contains("<gravity> stays"));
    for nonsense in [0.0, -9.81, f64::NAN, f64::INFINITY] {
        assert_eq!(try_rescaled(ONE_FOOT, to(nonsense)).unwrap_err().code(), "refused", "{nonsense}");
    }
    let weightless = ONE_FOOT.replace("0 -9.81 0", "0 0 0");
    assert_eq!(try_rescaled(&weightless, to(9.81)).unwrap_err().code(), "refused");
    assert!(try_rescaled(&weightless, |_| ()).is_ok());
}

#[test]
fn a_given_radius_is_set_at_an_equal_mass_too() {
    let same =
        |rule| plan_of_rescaling(ONE_FOOT, |wanted| (wanted.target_mass_kg, wanted.radius) = (10.0, rule));
    assert!(same(RadiusRule::Isometric).is_empty());
    assert_eq!(finding_codes(&same(RadiusRule::Keep)).last(), Some(&FindingCode::AlreadyAtTarget));
    assert_eq!(change_of_property(&same(RadiusRule::Factor(2.0)), Property::Stiffness).factor, Some(0.25));
}

#[test]
fn a_computed_value_within_rounding_of_the_old_one_is_no_change() {
    let plan_with = |stiffness: f64| {
        let text = ONE_FOOT.replace("1000000", &osim_model::messages::shortest(stiffness));
        let models = [ONE_FOOT, text.as_str()].map(|text| Model::parse(text).unwrap());
        let selected = Selection::default().apply(&models[0]).unwrap();
        let reference = reference_of_model(&models[0], &selected, mass_of_bodies(10.0), 1.0).unwrap();
        let wanted = Transfer::new(reference, mass_of_bodies(10.0), 1.0);
        transfer(&models[1], &selected, &wanted).unwrap().changes.len()
    };
    assert_eq!(plan_with(1e6), 0);
    assert_eq!(plan_with(1e6 * (1.0 + 2.0 * f64::EPSILON)), 0);
    assert_eq!(plan_with(1e6 * (1.0 + 1e-12)), 1);
    assert_eq!(plan_with(1e6 * (1.0 - 1e-12)), 1);
}

#[test]
fn contacts_in_an_included_file_are_read_and_refused() {
    let main = include_str!("../../../../fixtures/format/file_both_sets.osim");
    let document = Document::parse(main.as_bytes()).unwrap();
    let included = document.included_files();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/format/");
    let texts: Vec<Vec<u8>> =
        included.iter().map(|(_, name)| std::fs::read(format!("{folder}{name}")).unwrap()).collect();
    let companions = texts.into_iter().zip(&included).map(|(bytes, (element, _))| Companion {
        document: Document::parse(bytes).unwrap(),
        included_by: Some(*element),
    });
    let model = Model::read_with(document, companions.collect()).unwrap();
    assert!(!model.forces().is_empty() && !model.spheres().is_empty());
    let selected = Selection::default().apply(&model).unwrap();
    assert_eq!(rescale(&model, &selected, &rescale_to_80_kg()).unwrap_err().code(), "included-file");
}
