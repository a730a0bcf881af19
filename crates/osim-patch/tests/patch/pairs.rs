//! Tests of forces that press spheres on each other, such as a ball and a shoe.
//!
//! In OpenSim 4.6 a ball of 130 mm and a shoe of 40 mm, both of the stiffness below, press each other with 500.0 N where they are
//! 0.1 R = 3.0588 mm deep, with R = 130 * 40 / 170 mm. The other numbers are from mpmath, with 30 digits.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use contact_scaling::SharedLoad;
use osim_model::{Fault, FindingCode, Mass, MassSource, Model, Property, Selection};
use osim_patch::{Design, DesignModulus, Plan, design};

use crate::given::{fixture, given};

const FOR_500_N: f64 = 35_848_205.186_618_3;

/// A model whose force `contact_r` presses only heel_r (130 mm) and toe_l (40 mm), on two bodies.
fn ball_and_shoe() -> String {
    let text = String::from_utf8(fixture("format/mixed_radii.osim")).unwrap();
    let radii = text.replace("<radius>0.05<", "<radius>0.13<").replace("<radius>0.025<", "<radius>0.04<");
    radii.replace("<geometry>floor heel_r toe_r<", "<geometry>heel_r toe_l<")
}

fn designed(text: &str, change: impl FnOnce(&mut Design)) -> Result<Plan, Fault> {
    let model = Model::parse(text.as_bytes()).unwrap();
    let selection = Selection { select: vec!["contact_r".parse().unwrap()], ..Selection::default() };
    let load = Some(SharedLoad::new(500.0, 1.0).unwrap());
    let mut wanted = Design { modulus: Some(DesignModulus::Indentation(0.1)), load, ..Design::default() };
    change(&mut wanted);
    design(&model, &selection.apply(&model).unwrap(), &wanted)
}

#[track_caller]
fn assert_new_values(plan: &Plan, property: Property, expected: &[f64]) {
    let new: Vec<f64> =
        plan.changes.iter().filter(|change| change.property == property).map(|change| change.to).collect();
    let near = |(new, expected): (&f64, &f64)| (new / expected - 1.0).abs() < 1e-13;
    assert!(new.len() == expected.len() && new.iter().zip(expected).all(near), "{new:?}");
}

#[test]
fn a_design_takes_the_radius_of_the_pair() {
    let plan = designed(&ball_and_shoe(), |_| ()).unwrap();
    assert_new_values(&plan, Property::Stiffness, &[FOR_500_N]);
    assert!(plan.findings.iter().all(|finding| finding.code() != FindingCode::MixedRadii));
    // A second shoe on another body makes pairs of other radii; on the body of the first it makes none of its own.
    let three = ball_and_shoe().replace("heel_r toe_l<", "heel_r toe_l heel_l<");
    let plan = designed(&three, |_| ()).unwrap();
    assert!(plan.findings.iter().any(|finding| finding.code() == FindingCode::MixedRadii));
}

#[test]
fn two_materials_keep_their_ratio_and_press_as_one() {
    let text = ball_and_shoe();
    let start = text.find("<HuntCrossleyForce::ContactParameters>").unwrap();
    let end = text.find("</HuntCrossleyForce::ContactParameters>").unwrap() + 39;
    let set = text[start..end].replace("1234567.8", "1000000");
    let shoe = set.replace("heel_r toe_l", "toe_l").replace("1000000", "4000000");
    let both = format!("{}{shoe}", set.replace("heel_r toe_l", "heel_r"));
    let plan = designed(&text.replacen(&text[start..end], &both, 1), |_| ()).unwrap();
    assert_new_values(&plan, Property::Stiffness, &[20_924_120.097_389_68, 83_696_480.389_558_72]);
}

#[test]
fn what_a_pair_has_no_number_for_is_refused() {
    let refused = |change: fn(&mut Design)| designed(&ball_and_shoe(), change).unwrap_err().to_string();
    let weight =
        refused(|wanted| wanted.target_mass = Some(Mass { kg: 70.0, source: MassSource::ReferenceMass }));
    assert!(weight.contains("contact_r presses spheres on each other: give a load in newtons"), "{weight}");
    assert!(refused(|wanted| wanted.restitution = Some((0.9, None))).contains("give an impact speed"));
    assert!(refused(|wanted| wanted.contact_stiffness_n_m = Some(1e4)).contains("give radii in metres"));
    assert!(designed(&ball_and_shoe(), |wanted| wanted.restitution = Some((0.9, Some(2.0)))).is_ok());
}

#[test]
fn a_rescaling_takes_the_radius_of_the_pair_and_says_what_it_assumes() {
    // The shoe is on ground and keeps its 40 mm: R grows by 1.1333, not by 2.
    let toe = "<ContactSphere name=\"toe_l\">\n\t\t\t\t\t<socket_frame>";
    let fixed = ball_and_shoe().replace(&format!("{toe}/bodyset/calcn_l"), &format!("{toe}/ground"));
    let plan = given(fixed).selecting("contact_r").rescaled_to(8.0 * 53.0).result.unwrap().0;
    assert_new_values(&plan, Property::Radius, &[0.26]);
    assert_new_values(&plan, Property::Stiffness, &[1_234_567.8 * 6.228_373_702_422_145]);
    assert_new_values(&plan, Property::Dissipation, &[2.25 * 0.939_336_436_627_724_2]);
    let text: Vec<String> = plan.remarks.iter().map(ToString::to_string).collect();
    let assumed = ["its force goes with body weight (10)", "for a ratio V of speeds"];
    assert!(text.iter().any(|text| assumed.iter().all(|part| text.contains(part))), "{text:?}");
}
