//! Findings about spheres that sink in too deep under a body on four limbs.

use osim_inspect::{InspectOptions, Stance};
use osim_model::files::InMemory;
use osim_model::{FileId, FindingCode, Model, Severity, VerdictTopic};
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::json;

use crate::checks::{check_with, find, has, message, remedy};

/// A horse of 545 kg on four limbs with five spheres each, R = 0.015 m; x̂ is 0.5608 if one limb carries it.
const HORSE: &str = include_str!("../../../../fixtures/table1/horse_smooth_sphere.osim");
const NAME: &str = "horse.osim";

/// The horse with its stiffness multiplied by `factor`.
fn horse_with_stiffness(factor: f64) -> String {
    HORSE.replace("24003440.860215053", &(24_003_440.860_215_053 * factor).to_string())
}

fn options_of_trot() -> InspectOptions {
    InspectOptions { stance: Stance { limbs: Some(2.0), ..Stance::default() }, ..InspectOptions::default() }
}

#[test]
fn a_horse_gets_published_contacts_for_two_stance_limbs() {
    // By (3) x̂ follows E*^(-2/3): a twentieth makes 0.5608 to 4.132, and 2^(-2/3) of that is 2.603.
    let found = check_with(NAME, &horse_with_stiffness(0.05), &InspectOptions::default());
    let said = message(&found, FindingCode::SunkIn);
    assert!(
        said.starts_with("too soft: at body weight on one limb spheres sink 4.132 R into the floor"),
        "{said}"
    );
    assert!(said.ends_with("; on 2 of its 4 limbs it is 2.603 R"), "{said}");
    assert_eq!(
        remedy(&found, FindingCode::SunkIn),
        json!({"verb": "transfer", "from": "falisse2022", "stance_limbs": 2.0})
    );
}

#[test]
fn what_is_proposed_for_a_horse_puts_it_right_on_one_limb_and_on_two() {
    let text = horse_with_stiffness(0.05);
    let found = check_with(NAME, &text, &InspectOptions::default());
    let files = InMemory::from_iter([(NAME, text.as_str())]);
    let Some(remedy @ Request::Transfer(_)) = find(&found, FindingCode::SunkIn).remedy.clone() else {
        panic!()
    };
    let change = prepare(remedy, &files).unwrap();
    let opened = change.open(NAME.as_ref(), &files).unwrap();
    let plan = change.plan(&opened, &files).unwrap();
    let text = String::from_utf8(plan.patched(&opened.model, FileId::MAIN).unwrap()).unwrap();
    for options in [InspectOptions::default(), options_of_trot()] {
        let found = check_with(NAME, &text, &options);
        assert!(!has(&found, FindingCode::SunkIn));
        assert_eq!((found.counts.error, found.counts.warning), (0, 0));
    }
    // The verdict says what the note records.
    let found = check_with(NAME, &text, &options_of_trot());
    let on_mass = found.verdicts.iter().find(|verdict| verdict.on == VerdictTopic::Mass).unwrap();
    let said = on_mass.text.to_string();
    assert!(
        said.ends_with("; made for 545 kg (note in the file, by transfer from falisse2022, made for 62 kg)"),
        "{said}"
    );
    // What was said once need not be said again.
    let model = Model::parse(text.clone()).unwrap();
    assert_eq!(InspectOptions::default().inspect(NAME, &model, None).stance_limbs, 2.0);
    // Falisse et al. (2022) have x̂ = 0.353 on one human limb, and so has the horse on two.
    let said = message(&check_with(NAME, &text, &options_of_trot()), FindingCode::BeyondHertz);
    assert!(said.contains("on 2 limbs spheres sink in 0.353"), "{said}");
}

#[test]
fn the_depth_of_a_horse_on_two_limbs_is_said() {
    // x̂ is 0.560829 on one limb, and 2^(-2/3) of that, 0.3533, on two, as that of Falisse et al. (2022).
    let said = |stance: Stance| {
        let options = InspectOptions { stance, ..InspectOptions::default() };
        message(&check_with(NAME, HORSE, &options), FindingCode::BeyondHertz)
    };
    let alone = said(Stance::default());
    assert!(alone.starts_with("under body weight on one limb spheres sink in 0.5608 R"), "{alone}");
    assert!(
        alone.contains("; on 2 of its 4 limbs it is 0.3533 R; one of these alone gives 0.16 R"),
        "{alone}"
    );
    // What was said is repeated, and no more.
    for (stance, on) in [
        (Stance { limbs: Some(2.0), ..Stance::default() }, "2 limbs"),
        (Stance { spheres: Some(10.0), ..Stance::default() }, "10 of them,"),
    ] {
        let said = said(stance);
        assert!(said.starts_with(&format!("under body weight on {on} spheres sink in 0.3533 R")), "{said}");
        assert!(!said.contains("of its 4 limbs"), "{said}");
    }
}

#[test]
fn scaling_by_mass_alone_would_leave_the_horse_wrong() {
    let files = InMemory::from_iter([(NAME, horse_with_stiffness(0.05))]);
    let request = json!({"verb": "rescale", "models": [NAME], "target_mass": 545, "contacts_mass": 62, "yes": ["wrong-afterwards"]});
    let change = prepare(Request::from_json(request.to_string().as_bytes()).unwrap(), &files).unwrap();
    let opened = change.open(NAME.as_ref(), &files).unwrap();
    let plan = change.plan_alone(&opened.model).unwrap();
    let text = String::from_utf8(plan.patched(&opened.model, FileId::MAIN).unwrap()).unwrap();
    // Isometric scaling keeps E* R^2 / M, so x̂ becomes 4.132 (62/545)^(2/3) = 0.97 under this weight: nearly to the centre still.
    let said = message(&check_with(NAME, &text, &InspectOptions::default()), FindingCode::BeyondHertz);
    assert!(said.contains("sink in 0.97"), "{said}");
}

#[test]
fn a_horse_that_two_limbs_carry_is_not_told_to_change() {
    // x̂ = 0.560829 / 0.35^(2/3) = 1.12924 on one limb, 0.711375 on two.
    let found = check_with(NAME, &horse_with_stiffness(0.35), &InspectOptions::default());
    let own = find(&found, FindingCode::SunkIn);
    assert_eq!((own.severity, own.remedy.is_none()), (Severity::Warning, true));
    let said = own.message.to_string();
    assert!(said.ends_with("; on 2 of its 4 limbs it is 0.7114 R"), "{said}");
    assert!(own.advice.to_string().contains("Nothing, if at least two of its 4 limbs always carry it"));
    assert!(!has(&check_with(NAME, &horse_with_stiffness(0.35), &options_of_trot()), FindingCode::SunkIn));
}

#[test]
fn a_transfer_to_a_horse_says_how_many_limbs_carry_it() {
    let files = InMemory::from_iter([(NAME, HORSE.to_owned())]);
    let says = |more: &str| {
        let request = format!(r#"{{"verb": "transfer", "models": ["{NAME}"], "from": "falisse2022"{more}}}"#);
        let change = prepare(Request::from_json(request.as_bytes()).unwrap(), &files).unwrap();
        let opened = change.open(NAME.as_ref(), &files).unwrap();
        let plan = change.plan(&opened, &files).unwrap();
        plan.remarks.iter().any(|one| one.to_string().starts_with("one of 4 limbs carries the body; if two"))
    };
    assert!(says(""));
    assert!(!says(r#", "stance_limbs": 2"#) && !says(r#", "spheres": 10"#));
}

/// A human on the contacts of Falisse et al. (2022), with a sphere of 10 mm on each hand, in which one hand would sink to the centre. On
/// forepaws it would be an error.
#[test]
fn hands_that_press_on_a_wall_carry_no_body() {
    const HUMAN: &str = include_str!("../../../../fixtures/check/known_contacts.osim");
    let [mut bodies, mut joints, mut forces, mut surfaces] = std::array::from_fn(|_| String::new());
    for (side, z) in [("r", "0.4"), ("l", "-0.4")] {
        bodies += &format!("<Body name=\"hand_{side}\"><mass>0.5</mass></Body>");
        joints += &format!(
            "<PinJoint name=\"arm_{side}\"><socket_parent_frame>chest</socket_parent_frame>\
             <socket_child_frame>/bodyset/hand_{side}</socket_child_frame><frames><PhysicalOffsetFrame name=\"chest\">\
             <socket_parent>/bodyset/pelvis</socket_parent><translation>0.4 0.5 {z}</translation></PhysicalOffsetFrame></frames></PinJoint>"
        );
        forces += &format!(
            "<SmoothSphereHalfSpaceForce name=\"push_{side}\"><socket_sphere>/contactgeometryset/palm_{side}</socket_sphere>\
             <socket_half_space>/contactgeometryset/surface</socket_half_space><stiffness>1000000</stiffness>\
             <dissipation>2</dissipation></SmoothSphereHalfSpaceForce>"
        );
        surfaces += &format!(
            "<ContactSphere name=\"palm_{side}\"><socket_frame>/bodyset/hand_{side}</socket_frame><location>0 0 0</location>\
             <radius>0.01</radius></ContactSphere>"
        );
    }
    let insert = |set: &str, objects: &str, text: String| {
        let (before, rest) = text.split_once(&format!("<{set} name")).unwrap();
        format!("{before}<{set} name{}", rest.replacen("<objects>", &format!("<objects>{objects}"), 1))
    };
    let floor = "0 0 -1.5707963267948966";
    for (turned, limb, is_error) in [
        ("0 0 0", "hand_", false),
        (floor, "hand_", false),
        (floor, "crutch_", false),
        (floor, "forepaw_", true),
    ] {
        let surface = format!(
            "<ContactHalfSpace name=\"surface\"><socket_frame>/ground</socket_frame><location>0.5 0 0</location>\
             <orientation>{turned}</orientation></ContactHalfSpace>"
        );
        let text = insert("BodySet", &bodies, HUMAN.to_owned());
        let text = insert("JointSet", &joints, text);
        let text = insert("ForceSet", &forces, text);
        let text = insert("ContactGeometrySet", &format!("{surface}{surfaces}"), text);
        let found = check_with("human.osim", &text.replace("hand_", limb), &InspectOptions::default());
        assert_eq!(has(&found, FindingCode::SunkIn), is_error, "{limb} {:?}", found.findings);
    }
}
