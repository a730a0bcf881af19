//! Remedies of findings, as data. Each front end prints or applies them.
//!
//! Expected numbers are the limits of the paper and its equations, computed by hand.

use crate::checks::{check_foot, check_text, check_with, find, has, remedy, rule};
use crate::feet::{SOLE, SmoothContact, foot};
use contact_scaling::SharedLoad;
use osim_inspect::{CheckResult, InspectOptions, Stance};
use osim_model::messages::{Call, Dialect, Example, Input};
use osim_model::{
    Assignment, FileId, Finding, FindingCode, MassRequest, Model, Property, Selection, Severity,
};
use osim_patch::{Design, DesignModulus, design};
use osim_planning::check_with_remedies;
use osim_requests::options::WantedOptions;
use osim_requests::spell::FrontEnd;
use osim_requests::{ConstantIndentation, Request};
use serde_json::{Value, json};
use std::path::Path;

/// A human of 62 kg on 6 spheres on each foot, R = 0.032 m, E₁* = 1e6 N/m², α = 2 s/m: Table 1 of the paper.
const HUMAN: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
/// A model of 10 kg on one sphere.
const ONE_FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");
/// A model with the contacts of `HUMAN` under a body of 90 kg.
const MODEL_FOR_OTHER_MASS: &str = include_str!("../../../../fixtures/check/contacts_of_another_mass.osim");

/// The human with a tenth of its stiffness, so that its spheres sink in up to the centre.
fn human() -> String {
    HUMAN.replace(">1000000<", ">100000<")
}

/// A human of 62 kg on 6 spheres on each foot, by the Hertz law.
const HUNT_CROSSLEY: &str = include_str!("../../../../fixtures/table1/human_62kg_hunt_crossley.osim");
/// A model of 53 kg on a sphere of 0.05 m and one of 0.025 m on each foot. Both spheres have the same set of parameters: E₁* = 1.2345678
/// MPa, α = 2.25 s/m.
const MODEL_OF_MIXED_RADII: &str = include_str!("../../../../fixtures/format/mixed_radii.osim");
/// A model in which each force has a set of parameters for the heel and a set for the toe.
const MODEL_OF_THREE_MATERIALS: &str = include_str!("../../../../fixtures/format/three_materials.osim");
/// A model with three spheres on the right and two on the left, of 0.0325 m.
const MODEL_OF_UNEQUAL_COUNTS: &str = include_str!("../../../../fixtures/format/unequal_counts.osim");
/// A model whose force has its numbers in `<defaults>`, which no change touches.
const MODEL_WITH_DEFAULTS: &str = include_str!("../../../../fixtures/format/defaults_hunt_crossley.osim");

/// The result of `check` for the model `text`, which is called `name`.
fn check(name: &str, text: &str) -> CheckResult {
    check_with(name, text, &InspectOptions::default())
}

/// The wanted properties in the design that corrects the finding `code`.
#[track_caller]
fn wanted_by_remedy(result: &CheckResult, code: FindingCode) -> WantedOptions {
    match find(result, code).remedy.clone().expect("it has a remedy") {
        Request::Design(design) => design.wanted,
        other => panic!("{code:?}: {other:?}"),
    }
}

/// All fields, except the verb, of the request for a design that corrects the finding `code`.
#[track_caller]
fn design_of(result: &CheckResult, code: FindingCode) -> Value {
    let mut fields = remedy(result, code);
    assert_eq!(fields.as_object_mut().unwrap().shift_remove("verb"), Some(json!("design")));
    fields
}

fn set_request_with_factor(property: &str, factor: f64) -> Value {
    json!({"verb": "set", "set": {property: format!("x{factor}")}})
}

#[test]
fn spheres_that_sink_in_too_deep_get_the_indentation_of_the_limit() {
    let result = check("human.osim", &human());
    let Some(Request::Design(design)) = &find(&result, FindingCode::SunkIn).remedy else { panic!() };
    assert_eq!(design.models, [Path::new("human.osim")]);
    // At rest a sphere that just touches carries ½ (x̂_c / 0.16)^{3/2} of its share, a tenth at most: x̂_c ≤ 0.0547. The load is the
    // model's own weight on the spheres that were found, so it is not given.
    let expected = json!({"indentation": 0.16, "constant_indentation": 0.054});
    assert_eq!(design_of(&result, FindingCode::SunkIn), expected);
}

#[test]
fn contacts_that_were_made_for_this_body_are_not_to_be_scaled() {
    let masses = MassRequest { contacts_mass_kg: Some(62.0), ..MassRequest::default() };
    let said = check_with("human.osim", &human(), &InspectOptions { masses, ..InspectOptions::default() });
    let advice = find(&said, FindingCode::SunkIn).advice.to_string();
    assert!(
        advice.starts_with(
            "They were made for 62 kg (`contacts_mass`), which the body weighs: make them stiffer"
        ),
        "{advice}"
    );
    let unsaid = check("human.osim", &human());
    assert!(
        find(&unsaid, FindingCode::SunkIn)
            .advice
            .to_string()
            .starts_with("If the contacts were made for another body")
    );
}

#[test]
fn a_model_after_its_remedy_has_no_such_finding() {
    let result = check("human.osim", &human());
    let deep = wanted_by_remedy(&result, FindingCode::SunkIn);
    let model = Model::parse(human()).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let request = Design {
        modulus: deep.indentation.map(|x| DesignModulus::Indentation(x.get())),
        load: SharedLoad::new(62.0 * 9.81, 6.0).ok(),
        constant_indentation: deep.constant_indentation.map(ConstantIndentation::get),
        ..Design::default()
    };
    let plan = design(&model, &selected, &request).unwrap();
    let stiffness = plan.changes.iter().find(|change| change.property == Property::Stiffness).unwrap();
    // (11) and (A.4): E₁* = 2^{3/2} 3 F / (4 R² x̂^{3/2} n), and 0.16^{3/2} is 0.064.
    let expected = 2_f64.powf(1.5) * 3.0 * 62.0 * 9.81 / (4.0 * 0.032 * 0.032 * 0.064 * 6.0);
    assert!((stiffness.to / expected - 1.0).abs() < 1e-12, "{}", stiffness.to);

    let patched = plan.patched(&model, FileId::MAIN).unwrap();
    let after = check("human.osim", std::str::from_utf8(&patched).unwrap());
    let left: Vec<&str> = after.findings.iter().map(|finding| finding.code().as_str()).collect();
    assert!(!left.contains(&"beyond-hertz") && !left.contains(&"sunk-in"), "{left:?}");
}

#[test]
fn contacts_of_another_body_are_rescaled_from_its_mass_to_this_one() {
    let result = check_text(MODEL_FOR_OTHER_MASS);
    // Both masses are in it, so that no load has to be given.
    let expected = json!({"verb": "rescale", "target_mass": 90.0, "contacts_mass": 62.0});
    assert_eq!(remedy(&result, FindingCode::ContactsOfAnotherMass), expected);
    // Everything else has to wait until the contacts are those of this body.
    let others =
        result.findings.iter().filter(|finding| finding.code() != FindingCode::ContactsOfAnotherMass);
    assert!(others.into_iter().all(|finding| finding.remedy.is_none()));
}

#[test]
fn a_forgotten_stiffness_is_taken_from_a_preset() {
    let text = ONE_FOOT.replace("<stiffness>1000000</stiffness>", "");
    let result = check("one_foot.osim", &text);
    assert_eq!(
        remedy(&result, FindingCode::DefaultStiffness),
        json!({"verb": "transfer", "from": "falisse2022"})
    );
}

#[test]
fn a_model_that_cannot_be_read_again_has_findings_and_no_remedy() {
    let result = check("-", HUMAN);
    assert_eq!((result.counts.warning, result.counts.remark), (0, 3));
    assert!(result.findings.iter().all(|finding| finding.remedy.is_none()));
}

// What x̂ has to come down to.

#[test]
fn a_sphere_that_has_sunk_in_gets_the_indentation_of_the_limit() {
    let design = design_of(&check_foot(&[SmoothContact { stiffness: 3e5, ..SOLE }]), FindingCode::SunkIn);
    assert_eq!((&design["indentation"], &design["body_weights"]), (&json!(0.16), &Value::Null));
}

#[test]
fn a_remark_has_no_remedy() {
    // x̂ is 0.105 at body weight and 0.166 at twice: a remark.
    let result = check_foot(&[SmoothContact { stiffness: 1.5e7, ..SOLE }]);
    assert_eq!(find(&result, FindingCode::BeyondHertzAtTwo).remedy, None);
    // What was published so is one, too.
    let published = check("human.osim", HUMAN);
    assert_eq!(find(&published, FindingCode::BeyondHertz).remedy, None);
    assert_eq!(published.steps, []);
}

#[test]
fn the_hertz_law_has_no_constant_indentation_to_bring_down() {
    let result = check("human.osim", &HUNT_CROSSLEY.replace(">1000000<", ">100000<"));
    assert_eq!(design_of(&result, FindingCode::SunkIn), json!({"indentation": 0.16}));
}

#[test]
fn a_fault_of_a_mesh_stays_after_the_commands() {
    let model = Model::parse(human()).unwrap();
    let options = InspectOptions::default();
    let mesh = Finding::new(rule(FindingCode::OddMesh), "a mesh in millimetres");
    let inspected = options.inspect("human.osim", &model, None);
    let found = check_with_remedies(&options, &model, &inspected, &[mesh]);
    assert_eq!(found.corrected, found.counts.error + found.counts.warning - 1);
    assert!(!found.steps.is_empty() && find(&found, FindingCode::OddMesh).remedy.is_none());
}

#[test]
fn spheres_of_two_sizes_under_one_set_of_parameters_are_all_made_stiffer() {
    let result = check_text(&MODEL_OF_MIXED_RADII.replace(">1234567.8<", ">123456.78<"));
    // mpmath: the toe is in 3.71040 R deep; (3.71040/0.16)^(3/2) is 111.67249, rounded up.
    assert_eq!(remedy(&result, FindingCode::SunkIn), set_request_with_factor("stiffness", 111.673));
}

#[test]
fn materials_of_several_sets_are_multiplied_too() {
    let result = check_text(&MODEL_OF_THREE_MATERIALS.replace("<stiffness>", "<stiffness>0.0"));
    let Some(Request::Set(set)) = &find(&result, FindingCode::SunkIn).remedy else { panic!() };
    assert!(matches!(set.set.as_slice(), [(Property::Stiffness, Assignment::Factor(_))]));
}

#[test]
fn no_stiffness_hides_that_a_foot_has_lost_a_sphere() {
    let soft = MODEL_OF_UNEQUAL_COUNTS.replace(">1234567.8<", ">123456.78<");
    for spheres in [None, Some(3.0)] {
        let stance = Stance { spheres, ..Stance::default() };
        let result = check_with("model.osim", &soft, &InspectOptions { stance, ..InspectOptions::default() });
        assert!(find(&result, FindingCode::SunkIn).remedy.is_none());
        assert!(find(&result, FindingCode::LeftRightMissing).severity > Severity::Remark);
    }
}

// What the smoothing has to come down to.

#[test]
fn a_large_constant_indentation_comes_down_to_its_limit() {
    let result = check_foot(&[SmoothContact { constant_contact_force: 1e-4, ..SOLE }]);
    let expected = json!({"constant_indentation": 0.1});
    assert_eq!(design_of(&result, FindingCode::LargeConstantIndentation), expected);
}

#[test]
fn a_wide_transition_becomes_three_tenths_of_the_radius() {
    let result = check_foot(&[SmoothContact { hertz_smoothing: 100.0, ..SOLE }]);
    let expected = json!({"state_width": 0.3});
    assert_eq!(design_of(&result, FindingCode::WideTransition), expected);
}

#[test]
fn what_a_sphere_carries_while_it_touches_comes_down_to_a_tenth() {
    let result = check_foot(&[SmoothContact { constant_contact_force: 4e-6, ..SOLE }]);
    // It rests at x̂ = 0.086535; of that 0.2^(2/3), 0.029594.
    let expected = json!({"constant_indentation": 0.029});
    assert_eq!(design_of(&result, FindingCode::ForceBeforeContact), expected);
}

#[test]
fn the_sphere_that_is_in_least_deep_decides_how_much_touching_may_carry() {
    let result = check_foot(&[
        SmoothContact { stiffness: 1.2e7, name: "toe_r", ..SOLE },
        SmoothContact { constant_contact_force: 4e-6, ..SOLE },
    ]);
    // Of 300 N the stiffer one is in 0.054514 R deep; of that 0.2^(2/3), 0.018643.
    assert_eq!(design_of(&result, FindingCode::ForceBeforeContact), json!({"constant_indentation": 0.018}));
}

#[test]
fn a_sphere_that_floats_comes_down_to_the_floor() {
    let floating = SmoothContact { constant_contact_force: 1e-4, ..SOLE };
    let expected = json!({"constant_indentation": 0.029});
    assert_eq!(design_of(&check_foot(&[floating]), FindingCode::Floats), expected);
    // Where contact sets in over a long way, that has to be shorter as well: 2 artanh(0.9) (0.1/0.12118)^(2/3) is 2.5905, times
    // x̂ = 0.086535 is 0.22417.
    let wide = check_foot(&[SmoothContact { hertz_smoothing: 100.0, ..floating }]);
    assert_eq!(
        design_of(&wide, FindingCode::Floats),
        json!({"constant_indentation": 0.029, "state_width": 0.22})
    );
}

#[test]
fn a_constant_contact_force_of_0_becomes_a_twentieth_of_the_radius() {
    let result = check_foot(&[SmoothContact { constant_contact_force: 0.0, ..SOLE }]);
    let expected = json!({"constant_indentation": 0.05});
    assert_eq!(design_of(&result, FindingCode::ZeroConstantContactForce), expected);
}

// Whose weight it is: what was said is said again.

#[test]
fn a_remedy_repeats_the_options_about_the_load() {
    let masses = MassRequest {
        model_kg: Some(80.0),
        exclude_bodies: vec!["platform".parse().unwrap()],
        ..MassRequest::default()
    };
    let stance =
        Stance { spheres: Some(5.0), limbs: Some(2.0), gravity_m_s2: Some(12.0), impact_speed_m_s: None };
    let result =
        check_with("human.osim", &human(), &InspectOptions { masses, stance, ..InspectOptions::default() });
    let design = design_of(&result, FindingCode::SunkIn);
    let load =
        ["mass", "gravity", "exclude_body", "spheres", "stance_limbs"].map(|field| design[field].clone());
    assert_eq!(load, [json!(80.0), json!(12.0), json!(["platform"]), json!(5.0), json!(2.0)]);
}

#[test]
fn a_remedy_does_not_repeat_the_gravity_of_the_model() {
    let stance = Stance { gravity_m_s2: Some(9.81), ..Stance::default() };
    let result = check_with("human.osim", &human(), &InspectOptions { stance, ..InspectOptions::default() });
    assert_eq!(design_of(&result, FindingCode::SunkIn)["gravity"], Value::Null);
}

#[test]
fn a_remedy_repeats_a_mass_that_the_bodies_do_not_have() {
    let text = foot(&[SmoothContact { stiffness: 3e5, ..SOLE }]).replace("<mass>60</mass>", "<mass>0</mass>");
    let masses = MassRequest { contacts_mass_kg: Some(60.0), ..MassRequest::default() };
    let result = check_with("foot.osim", &text, &InspectOptions { masses, ..InspectOptions::default() });
    assert_eq!(design_of(&result, FindingCode::SunkIn)["mass"], json!(60.0));
}

#[test]
fn sets_that_stand_alone_are_named_again() {
    let options = InspectOptions {
        geometry: Some("geometry.xml".into()),
        model: Some("body.osim".into()),
        selection: Selection { exclude: vec!["kick".parse().unwrap()], ..Selection::default() },
        ..InspectOptions::default()
    };
    let result = check_with("forces.xml", &human(), &options);
    let Some(Request::Design(design)) = &find(&result, FindingCode::SunkIn).remedy else { panic!() };
    assert_eq!(design.set_files.geometry, options.geometry);
    assert_eq!(design.set_files.model, options.model);
    assert_eq!(design.choice.selection(), options.selection);
}

#[test]
fn masses_of_a_rescaling_have_the_digits_that_people_read() {
    let text = MODEL_FOR_OTHER_MASS.replace("<mass>88<", "<mass>88.123456789<");
    let expected = json!({"verb": "rescale", "target_mass": 90.123457, "contacts_mass": 62.0});
    assert_eq!(remedy(&check_text(&text), FindingCode::ContactsOfAnotherMass), expected);
}

#[test]
fn a_preset_is_not_proposed_under_another_gravity_than_the_models() {
    let text = ONE_FOOT.replace("<stiffness>1000000</stiffness>", "");
    let stance = Stance { gravity_m_s2: Some(1.62), ..Stance::default() };
    let result = check_with("one_foot.osim", &text, &InspectOptions { stance, ..InspectOptions::default() });
    assert_eq!(find(&result, FindingCode::DefaultStiffness).remedy, None);
    // Under the model's own it is, for the weight that the spheres carry.
    let proposed = check("one_foot.osim", &text);
    assert_eq!(
        remedy(&proposed, FindingCode::DefaultStiffness),
        json!({"verb": "transfer", "from": "falisse2022"})
    );
}

// Where there is none.

#[test]
fn a_model_that_cannot_be_changed_has_findings_and_no_remedy() {
    let result = check_text(MODEL_WITH_DEFAULTS);
    assert!(has(&result, FindingCode::BeyondHertz) && has(&result, FindingCode::BeyondHuntCrossley));
    assert!(result.findings.iter().all(|finding| finding.remedy.is_none()), "{result:?}");
}

/// A front end that writes inputs and commands as their names in angle brackets.
struct AngleBracketFrontEnd;

impl Dialect for AngleBracketFrontEnd {
    fn input(&self, input: Input, _: Option<&Example>) -> String {
        format!("<{}>", input.name())
    }

    fn call(&self, call: &Call) -> String {
        format!("<{}>", call.verb.name())
    }
}

impl FrontEnd for AngleBracketFrontEnd {
    fn request(&self, request: &Request) -> String {
        format!("change by {}", request.verb().name())
    }
}

#[test]
fn a_front_end_spells_findings_and_remedies() {
    let mut result = check("human.osim", &human());
    assert_eq!(find(&result, FindingCode::SunkIn).command, None);
    result.spell(&AngleBracketFrontEnd);
    let deep = find(&result, FindingCode::SunkIn);
    assert_eq!(deep.command.as_deref(), Some("change by design"));
    assert!(!deep.advice.to_string().contains('<'), "{}", deep.advice);
}
