//! Findings of `check`: values on both sides of each limit, the sphere and the force that a finding names, and models without the finding.

use crate::checks::{check_foot, check_text, check_with, codes, find, has, message, rule};
use crate::feet::{SOLE, SmoothContact, foot};
use osim_inspect::{ChangeableValues, CheckResult, InspectOptions, Stance, check_model};
use osim_model::files::FileName;
use osim_model::{Finding, FindingCode, Model, Severity, TextPosition};
use osim_planning::check_with_trials;
use osim_planning::find_changeable_values;
use osim_requests::Request;

/// A human of 62 kg on 6 spheres on each foot.
const HUMAN: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
const MODEL_WITHOUT_SIDES: &str = include_str!("../../../../fixtures/format/no_sides.osim");
const MODEL_WITHOUT_GRAVITY: &str = include_str!("../../../../fixtures/format/no_gravity.osim");
const PLAYER_AND_BALL: &str = include_str!("../../../../fixtures/format/player_and_ball.osim");
/// A model whose feet have one `HuntCrossleyForce` each, with sets of parameters for the floor, the heel and the toe.
const MODEL_OF_THREE_MATERIALS: &str = include_str!("../../../../fixtures/format/three_materials.osim");
const MODEL_OF_MIXED_RADII: &str = include_str!("../../../../fixtures/format/mixed_radii.osim");
const MODEL_WITH_DECIMAL_COMMA: &str = include_str!("../../../../fixtures/bad/number_decimal_comma.osim");

/// The weight M g of the foot, N.
const WEIGHT_N: f64 = 600.0;

/// The modulus E₁* with which one sphere of the foot `SOLE` is in equilibrium at `x_hat` under `load`: (11) and (A.4).
fn stiffness_for(x_hat: f64, load: f64) -> f64 {
    8_f64.sqrt() * 3.0 * load / (4.0 * 0.05 * 0.05 * x_hat.powf(1.5))
}

/// The cf with which a sphere carries `force` while it just touches the floor, with the modulus of `SOLE`: (C.3) at x = 0, where (C.1) is
/// 4/3 √R E* cf^(3/4) and the contact state is ½.
fn touching(force: f64) -> f64 {
    let full = 4.0 / 3.0 * 0.05_f64.sqrt() * 2e7 / 8_f64.sqrt();
    (2.0 * force / full).powf(4.0 / 3.0)
}

/// Asserts that the finding `code` occurs a millionth beyond a limit, but not at the limit, and not a millionth before it.
#[track_caller]
fn assert_limit(code: FindingCode, sphere: impl Fn(f64) -> SmoothContact) {
    for (of_limit, expected) in [(1.0 - 1e-6, false), (1.0, false), (1.0 + 1e-6, true)] {
        assert_eq!(
            has(&check_foot(&[sphere(of_limit)]), code),
            expected,
            "{code:?} at {of_limit} of its limit"
        );
    }
}

#[test]
fn nothing_is_found_in_a_foot_within_every_limit() {
    let result = check_foot(&[SOLE]);
    assert!(result.findings.is_empty(), "{:?}", result.findings);
    assert_eq!(result.counts.describe("nothing"), "nothing");
}

#[test]
fn hertz_holds_up_to_0_16_at_body_weight() {
    assert_limit(FindingCode::BeyondHertz, |of_limit| SmoothContact {
        stiffness: stiffness_for(0.16 * of_limit, WEIGHT_N),
        ..SOLE
    });
}

#[test]
fn hertz_holds_up_to_0_16_at_two_body_weights() {
    assert_limit(FindingCode::BeyondHertzAtTwo, |of_limit| SmoothContact {
        stiffness: stiffness_for(0.16 * of_limit, 2.0 * WEIGHT_N),
        ..SOLE
    });
}

#[test]
fn a_sphere_beyond_hertz_at_one_body_weight_is_not_reported_again_at_two() {
    let result = check_foot(&[SmoothContact { stiffness: stiffness_for(0.2, WEIGHT_N), ..SOLE }]);
    assert!(has(&result, FindingCode::BeyondHertz) && !has(&result, FindingCode::BeyondHertzAtTwo));
}

#[test]
fn a_sphere_sinks_in_from_its_centre_on() {
    for (x_hat, sunk) in [(1.0 - 1e-6, false), (1.0 + 1e-6, true)] {
        let result = check_foot(&[SmoothContact { stiffness: stiffness_for(x_hat, WEIGHT_N), ..SOLE }]);
        let found = (has(&result, FindingCode::SunkIn), has(&result, FindingCode::BeyondHertz));
        assert_eq!(found, (sunk, !sunk), "{x_hat}");
    }
}

#[test]
fn a_sphere_in_the_floor_up_to_its_very_centre_has_sunk_in() {
    // R = 1 m, E* = 1 N/m² and a load of 4/3 N: x̂ is 1 by (3), to the last bit.
    let unit = SmoothContact { radius: 1.0, stiffness: 8_f64.sqrt(), constant_contact_force: 0.0, ..SOLE };
    let text =
        foot(&[unit]).replace("<mass>60<", &format!("<mass>{}<", 4.0 / 3.0)).replace("0 -10 0", "0 -1 0");
    let result = check_text(&text);
    assert!(has(&result, FindingCode::SunkIn) && !has(&result, FindingCode::BeyondHertz));
}

/// As the small toes of a public model (nimblephysics), a tenth as stiff as its other spheres: the heel carries most of the load, and both
/// are in by 0.45 R. With digits lost, the toe carries nothing.
#[test]
fn a_soft_sphere_beside_a_stiff_one_has_not_sunk_in() {
    let heel = SmoothContact { stiffness: stiffness_for(0.3, WEIGHT_N / 2.0), ..SOLE };
    for (x_hat, severity) in [(1.4, Severity::Remark), (3.5, Severity::Error)] {
        let toe = SmoothContact { name: "toe_r", stiffness: stiffness_for(x_hat, WEIGHT_N / 2.0), ..SOLE };
        assert_eq!(find(&check_foot(&[heel, toe]), FindingCode::SunkIn).severity, severity, "{x_hat}");
    }
}

#[test]
fn hunt_and_crossley_hold_down_to_a_restitution_of_0_8() {
    // √(g R / 2) is 0.5 m/s, so that α = 0.4 s/m loses a fifth.
    assert_limit(FindingCode::BeyondHuntCrossley, |of_limit| SmoothContact {
        dissipation: 0.4 * of_limit,
        ..SOLE
    });
}

#[test]
fn the_constant_indentation_is_a_tenth_of_the_radius_at_most() {
    assert_limit(FindingCode::LargeConstantIndentation, |of_limit| SmoothContact {
        constant_contact_force: (0.1 * 0.05 * of_limit).powi(2),
        ..SOLE
    });
}

#[test]
fn contact_sets_in_over_0_31_of_the_radius_at_most() {
    // (C.7) at t = 0.05: 2 atanh(0.9) is ln 19.
    assert_limit(FindingCode::WideTransition, |of_limit| SmoothContact {
        hertz_smoothing: 19_f64.ln() / (0.31 * 0.05 * of_limit),
        ..SOLE
    });
}

#[test]
fn just_touching_a_sphere_carries_a_tenth_of_its_load_at_most() {
    assert_limit(FindingCode::ForceBeforeContact, |of_limit| SmoothContact {
        constant_contact_force: touching(0.1 * WEIGHT_N * of_limit),
        ..SOLE
    });
}

#[test]
fn a_sphere_floats_that_carries_its_load_before_it_touches() {
    for (of_weight, floats) in [(1.0 - 1e-6, false), (1.0 + 1e-6, true)] {
        let sphere = SmoothContact { constant_contact_force: touching(of_weight * WEIGHT_N), ..SOLE };
        assert_eq!(has(&check_foot(&[sphere]), FindingCode::Floats), floats, "{of_weight}");
    }
}

#[test]
fn each_finding_has_the_value_of_its_figure_and_the_limit() {
    // mpmath 1.3.0, 40 digits, where the numbers are not those that the sphere was made from.
    for (code, sphere, expected) in [
        (
            FindingCode::BeyondHertz,
            SmoothContact { stiffness: stiffness_for(0.25, WEIGHT_N), ..SOLE },
            "under body weight on one limb spheres sink in 0.25 R, and Hertz theory holds up to 0.16 R (heel_r); one of these alone gives 0.16 R: radius x1.398, stiffness x1.954, or 1.954 times as many spheres",
        ),
        (
            FindingCode::BeyondHertzAtTwo,
            SmoothContact { stiffness: stiffness_for(0.2, 2.0 * WEIGHT_N), ..SOLE },
            "under two body weights on one limb spheres sink in 0.2 R, and Hertz theory holds up to 0.16 R (heel_r); one of these alone gives 0.16 R: radius x1.183, stiffness x1.398, or 1.398 times as many spheres",
        ),
        (
            FindingCode::SunkIn,
            SmoothContact { stiffness: stiffness_for(1.25, WEIGHT_N), ..SOLE },
            "too soft: at body weight on one limb spheres sink 1.25 R into the floor (x/R by Hertz) (heel_r)",
        ),
        (
            FindingCode::BeyondHuntCrossley,
            SmoothContact { dissipation: 1.5, ..SOLE },
            "the restitution at 0.5 m/s is 0.5636, by (13) 0.25, limit 0.8 or more (heel_r)",
        ),
        (
            FindingCode::BeyondHuntCrossley,
            SmoothContact { dissipation: 2.5, ..SOLE },
            "the restitution at 0.5 m/s is 0.4279, by (13) below 0, limit 0.8 or more (heel_r)",
        ),
        (
            FindingCode::LargeConstantIndentation,
            SmoothContact { constant_contact_force: 1e-4, ..SOLE },
            "sqrt(constant_contact_force)/R is 0.2, limit 0.1 (heel_r)",
        ),
        (
            FindingCode::WideTransition,
            SmoothContact { hertz_smoothing: 100.0, ..SOLE },
            "smoothing switches contact on over 0.5889 R, limit 0.31 R (heel_r)",
        ),
        (
            // tanh(1/3) is 0.3215.
            FindingCode::WeakAtRest,
            SmoothContact { hunt_crossley_smoothing: 0.15, ..SOLE },
            "a sphere at rest presses with 0.6608 of its force, expected 0.9 or more: hunt_crossley_smoothing is too small for the dissipation (heel_r)",
        ),
        (
            FindingCode::ForceBeforeContact,
            SmoothContact { constant_contact_force: touching(120.0), ..SOLE },
            "just touching, a sphere carries 120 N, 0.2 of its share of body weight (heel_r)",
        ),
        (
            FindingCode::Floats,
            SmoothContact { constant_contact_force: 1e-4, ..SOLE },
            "body weight is carried 0.03838 R above the floor (heel_r)",
        ),
    ] {
        assert_eq!(message(&check_foot(&[sphere]), code), expected);
    }
}

fn line(finding: &Finding) -> Option<usize> {
    finding.position.map(|at| at.line)
}

/// The number of the line with `text` in `model`, from 1.
fn line_of(model: &str, text: &str) -> Option<usize> {
    model.lines().position(|line| line.contains(text)).map(|index| index + 1)
}

#[test]
fn a_finding_about_several_spheres_is_placed_at_the_worst_and_names_all() {
    // Each of three spheres carries 200 N.
    let of = |name, x_hat| SmoothContact { name, stiffness: stiffness_for(x_hat, 200.0), ..SOLE };
    let spheres = [of("heel_r", 0.2), of("mid_r", 0.09), of("toe_r", 0.25)];
    let result = check_foot(&spheres);
    let deep = find(&result, FindingCode::BeyondHertz);
    assert!(deep.message.to_string().contains(
        "sink in 0.25 R, and Hertz theory holds up to 0.16 R (2 of 3 spheres, most in toe_r); one"
    ));
    assert_eq!(deep.place.as_deref(), Some("/contactgeometryset/toe_r"));
    assert_eq!(line(deep), line_of(&foot(&spheres), "<ContactSphere name=\"toe_r\""));
    assert_eq!(deep.spheres, ["heel_r", "toe_r"]);
}

#[test]
fn of_spheres_that_are_equally_bad_the_first_is_the_place() {
    let of = |name| SmoothContact { name, stiffness: stiffness_for(0.25, 300.0), ..SOLE };
    let result = check_foot(&[of("heel_r"), of("toe_r")]);
    let deep = find(&result, FindingCode::BeyondHertz);
    assert!(deep.message.to_string().contains(" (all 2 spheres); one"));
    assert_eq!(deep.place.as_deref(), Some("/contactgeometryset/heel_r"));
    assert_eq!(deep.spheres, ["heel_r", "toe_r"]);
}

#[test]
fn a_finding_about_parameters_is_placed_at_the_force() {
    let spheres = [SOLE, SmoothContact { name: "toe_r", dissipation: 1.0, ..SOLE }];
    let result = check_foot(&spheres);
    let damped = find(&result, FindingCode::BeyondHuntCrossley);
    assert_eq!(damped.place.as_deref(), Some("/forceset/contact_toe_r"));
    assert_eq!(line(damped), line_of(&foot(&spheres), "name=\"contact_toe_r\""));
    assert_eq!(damped.spheres, ["toe_r"]);
}

#[test]
fn the_line_of_a_finding_is_that_of_the_parameter_set_of_the_sphere() {
    // The heel, of 2.25 s/m, is damped most; its set begins on the line before its spheres.
    let result = check_text(MODEL_OF_THREE_MATERIALS);
    let damped = find(&result, FindingCode::BeyondHuntCrossley);
    assert_eq!(damped.place.as_deref(), Some("/forceset/contact_r"));
    assert_eq!(
        line(damped),
        line_of(MODEL_OF_THREE_MATERIALS, "<geometry>heel_r</geometry>").map(|line| line - 1)
    );
}

// What keeps figures away.

fn with_stance(text: &str, stance: Stance) -> CheckResult {
    check_with("model.osim", text, &InspectOptions { stance, ..InspectOptions::default() })
}

#[test]
fn a_model_without_gravity_gets_a_finding() {
    assert!(has(&with_stance(MODEL_WITHOUT_GRAVITY, Stance::default()), FindingCode::NoGravity));
    let given = Stance { gravity_m_s2: Some(9.81), ..Stance::default() };
    assert!(!has(&with_stance(MODEL_WITHOUT_GRAVITY, given), FindingCode::NoGravity));
}

#[test]
fn gravity_at_another_place_on_the_earth_is_that_of_the_note() {
    let is_found = |gravity: &str| {
        let text = include_str!("../../../../fixtures/check/noted.osim");
        let found = with_stance(&text.replace("0 -9.81 0", gravity), Stance::default());
        has(&found, FindingCode::GravitySourcesDisagree)
    };
    assert!(!is_found("0 -9.78 0") && !is_found("0 -9.83 0") && is_found("0 -9.7 0"));
}

#[test]
fn gravity_is_not_reported_missing_if_figures_fail_for_another_reason() {
    let text = foot(&[SmoothContact { dissipation: -1.0, ..SOLE }]);
    assert!(!has(&with_stance(&text, Stance::default()), FindingCode::NoGravity));
}

#[test]
fn an_unknown_sphere_count_is_asked_for_until_it_is_given() {
    let asked = with_stance(MODEL_WITHOUT_SIDES, Stance::default());
    assert!(message(&asked, FindingCode::CountUnknown).contains("left or right cannot be determined"));
    let given = Stance { spheres: Some(2.0), ..Stance::default() };
    assert!(!has(&with_stance(MODEL_WITHOUT_SIDES, given), FindingCode::CountUnknown));
    assert!(!has(&with_stance(HUMAN, Stance::default()), FindingCode::CountUnknown));
}

#[test]
fn a_sphere_count_does_not_help_if_no_body_of_two_was_chosen() {
    let given = Stance { spheres: Some(2.0), ..Stance::default() };
    assert!(has(&with_stance(PLAYER_AND_BALL, given), FindingCode::CountUnknown));
}

#[test]
fn mixed_radii_are_reported() {
    assert!(has(&check_text(MODEL_OF_MIXED_RADII), FindingCode::MixedRadii));
}

// The result.

#[test]
fn the_worst_comes_first_and_each_severity_is_counted() {
    // The heel, which should carry half, is damped too much, sets in slowly and is sunk in; the toe is too soft at twice the load.
    let heel = SmoothContact {
        stiffness: stiffness_for(12.5, 300.0),
        dissipation: 2.0,
        hertz_smoothing: 100.0,
        ..SOLE
    };
    let toe = SmoothContact { name: "toe_r", stiffness: stiffness_for(0.2, 2.0 * 300.0), ..SOLE };
    let result = check_foot(&[heel, toe]);
    let expected = [
        FindingCode::SunkIn,
        FindingCode::WideTransition,
        FindingCode::BeyondHertzAtTwo,
        FindingCode::BeyondHuntCrossley,
    ];
    assert_eq!(codes(&result), expected);
    assert_eq!((result.counts.error, result.counts.warning, result.counts.remark), (1, 1, 2));
    assert_eq!((result.model.as_str(), result.schema_version), ("model.osim", 1));
}

#[test]
fn spheres_that_no_force_presses_with_are_a_warning() {
    let without = |text: &str, set: &str| {
        let (before, rest) = text.split_once(&format!("<{set}")).unwrap();
        format!("{before}{}", rest.split_once(&format!("</{set}>")).unwrap().1)
    };
    let no_force = without(HUMAN, "ForceSet");
    let without_parameters = HUMAN.replace("SmoothSphereHalfSpaceForce", "HuntCrossleyForce");
    let found = [no_force.as_str(), &without_parameters].map(check_text);
    let [bare, other] = found.each_ref().map(|found| find(found, FindingCode::BareModel));
    assert_eq!((bare.severity, &bare.spheres), (Severity::Warning, &other.spheres));
    assert!(other.severity == Severity::Warning && !bare.spheres.is_empty());
    // As in OpenSim's Scholz2015GeometryPathExample, whose muscle wraps around its spheres.
    let socket =
        |name| format!("<socket_contact_geometry>/contactgeometryset/{name}</socket_contact_geometry>");
    let obstacles: String = bare.spheres.iter().map(socket).collect();
    let path = format!("<Scholz2015GeometryPath>{obstacles}</Scholz2015GeometryPath>");
    let path = format!("<ForceSet><objects><PathSpring>{path}</PathSpring></objects></ForceSet>");
    let wrapped = no_force.replace("<ContactGeometrySet", &format!("{path}<ContactGeometrySet"));
    for text in [wrapped, without(&no_force, "ContactGeometrySet")] {
        assert_eq!(find(&check_text(&text), FindingCode::BareModel).severity, Severity::Remark);
    }
}

#[test]
fn a_gravity_that_is_not_the_earths_is_a_remark() {
    for (size, is_odd) in [(8.9, true), (9.0, false), (10.5, false), (10.6, true), (19.62, true)] {
        let text = HUMAN.replace("<gravity>0 -9.8100000000000005 0<", &format!("<gravity>0 -{size} 0<"));
        let found = check_text(&text);
        let odd = found.findings.iter().find(|one| one.code() == FindingCode::OddGravity);
        assert_eq!(odd.map(|one| one.severity), is_odd.then_some(Severity::Remark), "{size}");
    }
}

#[test]
fn contacts_a_thousand_times_as_stiff_as_published_ones_are_a_remark() {
    for (x_hat, severity) in
        [(0.0005, Some(Severity::Warning)), (0.005, Some(Severity::Remark)), (0.02, None)]
    {
        let sole = SmoothContact { stiffness: stiffness_for(x_hat, WEIGHT_N), ..SOLE };
        let found = check_foot(&[sole]);
        let too_stiff = found.findings.iter().find(|one| one.code() == FindingCode::TooStiff);
        assert_eq!(too_stiff.map(|one| one.severity), severity, "{x_hat}");
    }
}

#[test]
fn no_design_is_proposed_for_contacts_in_another_unit_or_doubled() {
    let stiff = HUMAN.replace(">1000000<", ">1000000000000<");
    let (before, rest) = HUMAN.split_once("<ForceSet").unwrap();
    let (start, forces) = rest.split_once("<objects>").unwrap();
    let (forces, after) = forces.split_once("</objects>").unwrap();
    let copies = forces.replace("name=\"", "name=\"copy_of_");
    let doubled = format!("{before}<ForceSet{start}<objects>{forces}{copies}</objects>{after}");
    for (text, code) in [(stiff, FindingCode::TooStiff), (doubled, FindingCode::SphereInTwoForces)] {
        let found = check_text(&text);
        assert!(has(&found, code) && found.steps.is_empty(), "{:?} {:?}", codes(&found), found.steps);
    }
}

#[test]
fn findings_of_one_kind_are_in_the_order_of_their_lines() {
    let model = Model::parse(foot(&[SOLE])).unwrap();
    let inspected = InspectOptions::default().inspect("model.osim", &model, None);
    let position = |line| TextPosition { offset: line, line, column: 1 };
    let on = |line| Finding::at(rule(FindingCode::DisabledForce), position(line), "it is off");
    assert_eq!(
        CheckResult::new(&model, &inspected, vec![on(31).into(), on(7).into()]).findings,
        [on(7).into(), on(31).into()]
    );
}

#[test]
fn a_file_name_that_is_not_text_keeps_its_bytes() {
    let model = Model::parse(HUMAN.replace(">1000000<", ">100000<")).unwrap();
    let name = FileName::from_parts("f\u{fffd}.osim".to_owned(), Some(b"f\xff.osim".to_vec()));
    let options = InspectOptions::default();
    let result = check_with_trials(&options, &model, &options.inspect(name.clone(), &model, None), &[]);
    assert_eq!(result.model_bytes.as_deref(), name.bytes());
    let Some(Request::Design(design)) = &find(&result, FindingCode::SunkIn).remedy else { panic!() };
    assert_eq!(design.models, [name.to_path()]);
}

#[test]
fn a_result_reaches_the_severity_of_its_worst_finding() {
    let remark = check_foot(&[SmoothContact { stiffness: stiffness_for(0.2, 2.0 * WEIGHT_N), ..SOLE }]);
    let warning = check_foot(&[SmoothContact { hertz_smoothing: 100.0, ..SOLE }]);
    let error = check_foot(&[SmoothContact { constant_contact_force: touching(1.5 * WEIGHT_N), ..SOLE }]);
    for (result, expected) in [
        (&check_foot(&[SOLE]), [false; 3]),
        (&remark, [true, false, false]),
        (&warning, [true, true, false]),
        (&error, [true; 3]),
    ] {
        let reached = [Severity::Remark, Severity::Warning, Severity::Error]
            .map(|severity| result.findings.iter().any(|finding| finding.severity >= severity));
        assert_eq!(reached, expected, "{:?}", codes(result));
    }
}

#[test]
fn messages_of_findings_count_in_words() {
    let mut counts = check_foot(&[SOLE]).counts;
    counts.error = 1;
    assert_eq!(counts.describe("-"), "1 error");
    (counts.error, counts.warning, counts.remark) = (2, 1, 3);
    assert_eq!(counts.describe("-"), "2 errors, 1 warning, 3 remarks");
    (counts.error, counts.warning, counts.remark) = (0, 2, 1);
    assert_eq!(counts.describe("-"), "2 warnings, 1 remark");
}

#[test]
fn findings_about_files_beside_the_model_are_in_the_result() {
    let model = Model::parse(foot(&[SOLE])).unwrap();
    let options = InspectOptions::default();
    let beside = Finding::new(rule(FindingCode::CompiledModelBeside), "F_model.so is here");
    let result = check_with_trials(
        &options,
        &model,
        &options.inspect("model.osim", &model, None),
        std::slice::from_ref(&beside),
    );
    assert_eq!(result.findings, [beside.into()]);
}

#[test]
fn only_a_model_that_can_be_changed_gets_commands() {
    // Spheres that are too soft by a factor of ten sink in.
    let model = Model::parse(HUMAN.replace(">1000000<", ">100000<")).unwrap();
    let options = InspectOptions::default();
    assert!(find_changeable_values(&options, &model).numbers);
    let inspected = options.inspect("human.osim", &model, None);
    let remedies = |changes| {
        let result = check_model(
            &options,
            &model,
            &inspected,
            &[],
            ChangeableValues { numbers: changes, radii: true },
        );
        result.findings.iter().filter(|finding| finding.remedy.is_some()).count()
    };
    assert_eq!((remedies(true), remedies(false)), (1, 0));
    // "1,5e6" is no number, so that a change of it is refused.
    assert!(!find_changeable_values(&options, &Model::parse(MODEL_WITH_DECIMAL_COMMA).unwrap()).numbers);
}
