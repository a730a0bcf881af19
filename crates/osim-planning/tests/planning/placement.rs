//! Whether spheres fit their bones: by one file, and compared with the model before scaling.

use std::path::Path;

use crate::checks::remedy_without_models;
use osim_inspect::{CheckResult, InspectOptions};
use osim_model::compare::SpherePlacements;
use osim_model::{Anatomy, FileId, FindingCode, Mass, MassRequest, MassSource, Model, Selection, Severity};
use osim_patch::{Rescale, note, rescale};
use osim_planning::check_with_trials;
use serde_json::{Value, json};

/// A model with the places of Falisse et al. (2022) on bones of the same size, and a model with these places on bones of a child.
const RIGHT_PLACES: &str = include_str!("../../../../fixtures/check/known_contacts.osim");
const CHILD_BONES: &str = include_str!("../../../../fixtures/check/spheres_misplaced.osim");
/// A model with scaled bones, whose spheres are those of no published model. The toe joint is 163.41 · 0.8 / 0.913924 = 143.04 mm from the
/// origin of the calcaneus.
const UNPUBLISHED_MODEL: &str = include_str!("../../../../fixtures/check/spheres_not_compared.osim");
/// The generic model, and the model that the real Scale Tool made from it.
const GENERIC_MODEL: &str = include_str!("../../../../fixtures/scale_tool/generic_smooth.osim");
const SCALED_MODEL: &str = include_str!("../../../../fixtures/scale_tool/scaled_smooth.osim");

const CODES_ABOUT_PLACES: [FindingCode; 3] =
    [FindingCode::SpheresLeftBehind, FindingCode::SpheresMisplaced, FindingCode::SpheresNotCompared];

/// The codes of the findings about places, by one file alone.
fn codes_without_reference(text: &str) -> Vec<FindingCode> {
    codes_found(&check_text(text, None))
}

fn codes_found(found: &CheckResult) -> Vec<FindingCode> {
    found
        .findings
        .iter()
        .map(|finding| finding.code())
        .filter(|code| CODES_ABOUT_PLACES.contains(code))
        .collect()
}

fn check_text(text: &str, generic: Option<&str>) -> CheckResult {
    let (options, model) = (InspectOptions::default(), Model::parse(text).unwrap());
    let mut inspected = options.inspect("scaled.osim", &model, None);
    inspected.placement = generic.map(|generic| {
        let generic = Model::parse(generic).unwrap();
        let kg = |model| MassRequest::default().model_mass(model).unwrap().kg;
        let radius_ratio = (kg(&model) / kg(&generic)).cbrt();
        let original = Anatomy::of(&generic).unwrap();
        SpherePlacements::compare(
            &model,
            Path::new("generic.osim"),
            None,
            &original,
            None,
            Some(radius_ratio),
        )
    });
    check_with_trials(&options, &model, &inspected, &[])
}

/// The model `text` with the sphere `sphere` at this x, mm.
fn with_x(text: &str, sphere: &str, millimetres: f64) -> String {
    let at = text.find(&format!("<ContactSphere name=\"{sphere}\">")).unwrap();
    let start = at + text[at..].find("<location>").unwrap() + "<location>".len();
    let end = start + text[start..].find(' ').unwrap();
    format!("{}{}{}", &text[..start], millimetres / 1e3, &text[end..])
}

#[test]
fn a_published_layout_is_right_on_bones_of_its_size_and_of_no_other() {
    assert_eq!(codes_without_reference(RIGHT_PLACES), []);
    assert_eq!(codes_without_reference(CHILD_BONES), [FindingCode::SpheresMisplaced]);
    // Published at 1.0, too; half a millimetre on a foot is no other size.
    // Meshes in millimetres are of no other size either.
    for (size, expected) in [
        ("1", vec![]),
        ("0.914", vec![]),
        ("0.001", vec![]),
        ("0.000913924", vec![]),
        ("0.95", vec![FindingCode::SpheresMisplaced]),
    ] {
        let text = RIGHT_PLACES.replace("0.913924 0.913924 0.913924", &[size; 3].join(" "));
        // The joint to the toes shows the size, too.
        let text = if size == "1" { text.replace(">0.16341 ", ">0.1788 ") } else { text };
        assert_eq!(codes_without_reference(&text), expected, "{size}");
    }
}

#[test]
fn a_layout_that_grew_with_its_bones_is_right() {
    // Every place of the fixture on a larger foot, and the mesh with it.
    let grown = RIGHT_PLACES.replace("0.913924 0.913924 0.913924", "1.827848 0.913924 0.913924");
    let grown = [
        ("0.00190115", "0.0038023"),
        ("0.14838637", "0.29677274"),
        ("0.13300117", "0.26600234"),
        ("0.06623469", "0.13246938"),
        (">0.06 ", ">0.12 "),
        (">0.045 ", ">0.09 "),
    ]
    .iter()
    .fold(grown, |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 2, "{old}");
        text.replace(old, new)
    });
    assert_eq!(codes_without_reference(&grown), []);
}

#[test]
fn spheres_beyond_any_published_reach_are_reported_and_others_are_not() {
    // The projection of (x, ...) on the joint's direction: |J - x/143.04 mm| < 0.002, as y and z are small.
    for (millimetres, expected) in [
        (1.39 * 143.04, FindingCode::SpheresNotCompared),
        (1.41 * 143.04, FindingCode::SpheresMisplaced),
        (100.0, FindingCode::SpheresNotCompared),
    ] {
        assert_eq!(
            codes_without_reference(&with_x(UNPUBLISHED_MODEL, "s2_r", millimetres)),
            [expected],
            "{millimetres}"
        );
    }
}

#[test]
fn a_joint_nearer_than_a_radius_does_not_show_the_length_of_a_bone() {
    // The toe joint 20 mm from the origin, on spheres of 32 mm; the mesh is no standard one, so that there is no L.
    assert!(UNPUBLISHED_MODEL.contains(">0.14304034 "));
    let near = UNPUBLISHED_MODEL.replace(">0.14304034 ", ">0.02 ").replace("foot.vtp", "hoof.stl");
    assert_eq!(codes_without_reference(&near), [FindingCode::SpheresNotCompared]);
    // At 40 mm it is the next joint, and spheres are beyond it.
    assert_eq!(codes_without_reference(&near.replace(">0.02 ", ">0.04 ")), [FindingCode::SpheresMisplaced]);
}

#[test]
fn a_foot_is_filled_as_in_published_models() {
    // Heel and tip of this foot are at -9.8 · 0.8 and 143.04 + 76.918 · 0.8 mm, 212.41 mm apart. The toes' spheres are foremost
    // at 143.04 + x; where they are far back, s2_r on the calcn is, at 129.89 mm: L is 0.648.
    for (x, expected) in [
        (80.0, FindingCode::SpheresMisplaced),
        (70.0, FindingCode::SpheresNotCompared),
        (0.0, FindingCode::SpheresNotCompared),
        (-50.0, FindingCode::SpheresMisplaced),
    ] {
        let text =
            ["s5_r", "s6_r"].iter().fold(UNPUBLISHED_MODEL.to_owned(), |text, name| with_x(&text, name, x));
        assert_eq!(codes_without_reference(&text), [expected], "{x}");
        let found = check_text(&text, None);
        let odd = found.findings.iter().find(|one| one.code() == FindingCode::SpheresMisplaced);
        let odd = odd.map(|odd| odd.message.to_string());
        assert!(odd.as_ref().is_none_or(|odd| odd.contains("of the foot's length")), "{odd:?}");
    }
}

#[test]
fn bones_that_nobody_scaled_give_no_finding_about_places() {
    // Unscaled bones, and meshes in millimetres.
    for (size, mesh) in [("1", "foot.vtp"), ("0.001", "hoof.stl")] {
        let text = UNPUBLISHED_MODEL.replace("0.8 0.8 0.8", &[size; 3].join(" ")).replace("foot.vtp", mesh);
        assert_eq!(codes_without_reference(&text), [], "{size}");
    }
}

#[test]
fn compared_with_the_model_that_was_scaled_each_sphere_has_its_place() {
    let found = check_text(SCALED_MODEL, Some(GENERIC_MODEL));
    let behind: Vec<String> = found
        .findings
        .iter()
        .filter(|finding| finding.code() == FindingCode::SpheresLeftBehind)
        .flat_map(|finding| [vec![finding.message.to_string()], finding.details.clone()].concat())
        .collect();
    // The Scale Tool's factors of calcn and toes are 1.02, 0.9 and 0.95. The heel's bottom was at -72 mm and goes to -64.8; with a radius of
    // 32 ∛(52/62) = 30.18 mm its centre goes to -34.62, and from 5 to 4.75 mm sideways: √(0.2² + 5.38² + 0.25²) is 5.39.
    assert_eq!(behind[0], "6 of 6 spheres did not follow the bones (up to 5.39 mm, heel_r)");
    assert_eq!(behind[1], "heel_r is at -10.00 -40.00 5.00 mm and belongs at -10.20 -34.62 4.75 mm");
    assert_eq!(behind.len(), 7);
    let expected = json!({"verb": "transfer", "from": "generic.osim", "follow_bodies": true, "level": true});
    assert_eq!(remedy_without_models(found.findings[0].remedy.as_ref()), expected);
    // What the spheres do where they should not be is judged, too, but nothing else has a command.
    assert!(
        found.findings.iter().all(|one| one.remedy.is_none() || one.code() == FindingCode::SpheresLeftBehind)
    );
    assert!(found.findings.iter().any(|one| one.code() == FindingCode::BeyondHertz));
    // Nothing advises to name the model that was named.
    let mut advice = found.findings.iter().map(|one| one.advice.to_string());
    assert!(advice.all(|advice| !advice.contains("GENERIC") && !advice.contains("ORIGINAL")));
}

#[test]
fn the_generic_model_itself_has_no_findings() {
    assert_eq!(codes_found(&check_text(GENERIC_MODEL, Some(GENERIC_MODEL))), []);
}

#[test]
fn a_sphere_that_somebody_moved_is_a_warning_without_a_command() {
    let moved = SCALED_MODEL.replacen("<location>-0.01 -0.04", "<location>-0.011 -0.04", 1);
    let moved = if moved == SCALED_MODEL {
        SCALED_MODEL.replacen("-0.040000000000000001", "-0.041", 1)
    } else {
        moved
    };
    assert_ne!(moved, SCALED_MODEL);
    let found = check_text(&moved, Some(GENERIC_MODEL));
    assert!(found.findings.iter().any(|one| one.code() == FindingCode::SpheresMisplaced));
    assert!(found.findings.iter().all(|one| one.remedy.is_none()), "a transfer would ask");
    // A contact that is off on the other foot is another fault.
    let name = "\"contact_heel_l\">";
    let off = moved.replacen(name, &format!("{name}<appliesForce>false</appliesForce>"), 1);
    assert!(codes_found(&check_text(&off, Some(GENERIC_MODEL))).contains(&FindingCode::SpheresMisplaced));
}

#[test]
fn a_model_that_cannot_be_compared_says_why() {
    let found = check_text(SCALED_MODEL, Some(RIGHT_PLACES));
    let why = found.findings.iter().find(|one| one.code() == FindingCode::SpheresNotCompared).unwrap();
    assert!(why.message.to_string().contains("no sphere of the same name"), "{}", why.message);
    // Spheres of the same names may all be on other bodies.
    let on_shanks = ["r", "l"].iter().fold(SCALED_MODEL.to_owned(), |text, side| {
        let (calcaneus, toes) = (format!("calcn_{side}"), format!("toes_{side}"));
        let frames = [format!("{calcaneus}/{calcaneus}_ball"), calcaneus, toes];
        let frame = |part: &str| format!("<socket_frame>/bodyset/{part}<");
        let shank = frame(&format!("tibia_{side}"));
        frames.iter().fold(text, |text, part| text.replace(&frame(part), &shank))
    });
    let found = check_text(&on_shanks, Some(GENERIC_MODEL));
    let why = found.findings.iter().find(|one| one.code() == FindingCode::SpheresNotCompared).unwrap();
    let expected = "is on tibia_r, and on calcn_r in the model that was scaled";
    assert!(why.message.to_string().contains(expected), "{}", why.message);
    // Of spheres on the other foot the difference of the sides says so.
    let swapped = ["heel", "ball", "toe"].iter().fold(SCALED_MODEL.to_owned(), |text, name| {
        let sphere = |side: &str| format!("ContactSphere name=\"{name}_{side}\"");
        let text = text.replace(&sphere("r"), &sphere("?")).replace(&sphere("l"), &sphere("r"));
        text.replace(&sphere("?"), &sphere("l"))
    });
    assert_eq!(codes_found(&check_text(&swapped, Some(GENERIC_MODEL))), []);
    // Also if the bones are others, and if the other model has no spheres.
    let other_legs = RIGHT_PLACES.replace("0 -0.9 0.1<", "0.3 -0.9 0.1<").replace("\"mtp_l\"", "\"ball_l\"");
    let (bones, _) = other_legs.split_once("<ForceSet").unwrap();
    let bare = format!("{bones}</Model></OpenSimDocument>");
    for other in [other_legs, bare] {
        let found = check_text(SCALED_MODEL, Some(&other));
        let why = found.findings.iter().find(|one| one.code() == FindingCode::SpheresNotCompared).unwrap();
        assert_eq!(why.severity, Severity::Error);
        assert!(why.message.to_string().contains("no sphere of the same name"), "{}", why.message);
    }
}

/// The model `text` with a note that its contacts were made for 62 kg, by the operation `operation`.
fn with_note(text: &str, operation: &str) -> String {
    let model = Model::parse(text).unwrap();
    let mut plan = note(&model, 62.0, model.gravity(), None).unwrap();
    plan.name_operation(operation);
    String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap()
}

/// The model `text` with a note that its spheres were placed together with their bodies.
fn placed_by_tool(text: &str) -> String {
    with_note(text, "rescale follow-bodies").replace("; made c)]", "; made cp)]")
}

/// The model with its meshes scaled as OpenSim does it. Spheres and note stay as they are.
fn bones_of(text: &str, size: &str) -> String {
    text.replace("0.913924 0.913924 0.913924", size)
}

#[test]
fn the_note_counts_more_than_all_other_evidence() {
    let scaled = bones_of(&with_note(RIGHT_PLACES, "note"), "0.6306 0.6397 0.6306");
    let found = check_text(&scaled, None);
    let left =
        found.findings.iter().find(|finding| finding.code() == FindingCode::SpheresLeftBehind).unwrap();
    // 0.6306 / 0.913924 and 0.6397 / 0.913924.
    assert!(left.message.to_string().contains("calcn_r x0.68999"), "{}", left.message);
    let by_note = json!({"verb": "rescale", "target_mass": 62.0, "follow_bodies": true});
    let mut level = by_note.clone();
    level["level"] = json!(true);
    assert_eq!(remedy_without_models(left.remedy.as_ref()), level);
    // Stretched by more than 20 %: bottoms are not kept.
    let stretched = check_text(&bones_of(&with_note(RIGHT_PLACES, "note"), "0.6 0.9 0.6"), None);
    assert!(
        stretched.findings.iter().any(|finding| remedy_without_models(finding.remedy.as_ref()) == by_note)
    );
}

#[test]
fn a_note_of_spheres_that_were_placed_with_their_bodies_is_believed() {
    assert_eq!(codes_without_reference(&placed_by_tool(CHILD_BONES)), []);
    // Another note was written where the spheres were, right or wrong.
    assert_eq!(codes_without_reference(&with_note(CHILD_BONES, "rescale")), [FindingCode::SpheresMisplaced]);
}

#[test]
fn a_sphere_moved_after_the_note_makes_the_note_no_evidence_of_places() {
    let moved = with_x(&bones_of(&with_note(RIGHT_PLACES, "note"), "0.6 0.6 0.6"), "s1_r", 12.0);
    assert!(!codes_without_reference(&moved).contains(&FindingCode::SpheresLeftBehind));
}

#[test]
fn after_a_rescaling_the_printed_command_does_not_keep_bottoms() {
    let found = check_text(&bones_of(&with_note(RIGHT_PLACES, "rescale"), "0.6306 0.6397 0.6306"), None);
    let remedies = found.findings.iter().filter_map(|finding| finding.remedy.as_ref());
    let remedies: Vec<Value> = remedies.map(|remedy| remedy_without_models(Some(remedy))).collect();
    assert_eq!(remedies, [json!({"verb": "rescale", "target_mass": 62.0, "follow_bodies": true})]);
}

#[test]
fn a_note_that_is_not_believed_leads_to_no_command() {
    let scaled = bones_of(&with_note(RIGHT_PLACES, "note"), "0.6 0.6 0.6").replacen(
        "<dissipation>2<",
        "<dissipation>2.1<",
        1,
    );
    let found = check_text(&scaled, None);
    assert!(codes_found(&found).contains(&FindingCode::SpheresLeftBehind));
    assert!(found.findings.iter().all(|finding| finding.remedy.is_none()), "{:?}", found.findings);
}

#[test]
fn bones_of_other_software_are_not_measured_as_those_of_open_sim() {
    for text in
        [UNPUBLISHED_MODEL.replace("foot.vtp", "foot.stl"), bones_of(UNPUBLISHED_MODEL, "0.001 0.001 0.001")]
    {
        assert!(!codes_without_reference(&text).contains(&FindingCode::SpheresMisplaced));
    }
}

#[test]
fn a_wrong_original_is_reported_and_the_evidence_of_the_file_stays() {
    let found = check_text(CHILD_BONES, Some(RIGHT_PLACES));
    // The same bodies: compared, and no layout is looked at.
    assert!(!codes_found(&found).contains(&FindingCode::SpheresNotCompared), "{:?}", codes_found(&found));
    // A joint that the factors of the meshes do not explain: not a scaled copy.
    let unlike = RIGHT_PLACES.replacen("0.16341 -0.00183 0.00099", "0.16341 -0.00183 0.2", 1);
    let found = check_text(CHILD_BONES, Some(&unlike));
    let said: Vec<_> = found.findings.iter().filter(|one| CODES_ABOUT_PLACES.contains(&one.code())).collect();
    assert_eq!(codes_found(&found).len(), 2, "{said:?}");
    assert!(codes_found(&found).contains(&FindingCode::SpheresMisplaced), "by the layout in the file");
    let why = said.iter().find(|one| one.code() == FindingCode::SpheresNotCompared).unwrap();
    assert!(why.message.to_string().contains("not a scaled copy of that one"), "{}", why.message);
    assert!(said.iter().all(|one| one.remedy.is_none()));
    // A command for the mass would leave spheres behind that did not follow.
    let light = RIGHT_PLACES.replace("<mass>60</mass>", "<mass>45</mass>");
    let has_command = |other: Option<&str>| {
        let found = check_text(&light, other).findings;
        let mass = found.into_iter().find(|one| one.code() == FindingCode::ContactsOfAnotherMass).unwrap();
        mass.remedy.is_some()
    };
    assert!(has_command(None) && !has_command(Some(&unlike)));
}

#[test]
fn a_sphere_without_a_counterpart_is_reported_and_nothing_is_said_to_be_right() {
    for (scaled, generic) in [
        // In one of the two models alone: renamed there.
        (SCALED_MODEL.replace("heel_r", "hind_r"), GENERIC_MODEL.to_owned()),
        (SCALED_MODEL.to_owned(), GENERIC_MODEL.replace("heel_r", "hind_r")),
    ] {
        let found = check_text(&scaled, Some(&generic));
        let missing: Vec<String> = found
            .findings
            .iter()
            .filter(|one| one.code() == FindingCode::SpheresNotCompared)
            .map(|one| one.message.to_string())
            .collect();
        assert_eq!(missing.len(), 2, "{missing:?}");
        assert!(missing[0].contains("is not in the model that was scaled"), "{missing:?}");
        assert!(missing[1].contains("of the model that was scaled is missing here"), "{missing:?}");
        assert!(found.findings.iter().all(|one| one.remedy.is_none()), "a transfer would refuse");
    }
    // All spheres of one side: one cause for three, each with its sentence.
    let renamed =
        SCALED_MODEL.replace("toe_r", "tip_r").replace("ball_r", "mid_r").replace("heel_r", "hind_r");
    let found = check_text(&renamed, Some(GENERIC_MODEL));
    let not_compared = found.findings.iter().filter(|one| one.code() == FindingCode::SpheresNotCompared);
    let counts: Vec<usize> = not_compared.map(|one| one.details.len()).collect();
    assert_eq!(counts, [3, 3]);
}

#[test]
fn spheres_that_this_program_resized_are_placed_again() {
    let model = Model::parse(SCALED_MODEL).unwrap();
    let selected = Selection::default().apply(&model).unwrap();
    let mass = Mass { kg: 62.0, source: MassSource::ContactsMass };
    let mut plan = rescale(&model, &selected, &Rescale::new(40.0, mass)).unwrap();
    plan.name_operation("rescale");
    let resized = String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    let change = |text: &str| {
        let found = check_text(text, Some(GENERIC_MODEL));
        let behind = found.findings.iter().find(|one| one.code() == FindingCode::SpheresLeftBehind).unwrap();
        remedy_without_models(behind.remedy.as_ref())
    };
    let expected = json!({
        "verb": "transfer", "from": "generic.osim", "follow_bodies": true, "moved_spheres": "replace", "level": true,
    });
    assert_eq!(change(&resized), expected);
    // Whoever else changed a radius knows why.
    let start = resized.find("<radius>").unwrap() + "<radius>".len();
    let by_hand = format!("{}1{}", &resized[..start], &resized[start..]);
    assert_eq!(change(&by_hand), Value::Null);
}

#[test]
fn what_is_wrong_beside_misplaced_spheres_has_no_command() {
    // Beyond the toe joint, and a hundredth as stiff.
    let text =
        with_x(UNPUBLISHED_MODEL, "s2_r", 1.45 * 143.04).replace("<stiffness>1000000<", "<stiffness>10000<");
    let found = check_text(&text, None);
    assert!(found.findings.iter().all(|one| one.remedy.is_none()));
    let codes: Vec<_> = found.findings.iter().map(|one| (one.severity, one.code())).collect();
    let expected = [
        (Severity::Error, FindingCode::SunkIn),
        (Severity::Warning, FindingCode::SpheresMisplaced),
        (Severity::Remark, FindingCode::BeyondHuntCrossley),
    ];
    assert_eq!(codes, expected);
}

#[test]
fn a_command_that_would_be_refused_for_a_shared_sphere_is_not_proposed() {
    // The sphere is in a force of another class, which a transfer does not change with it.
    let obstacle = "<ElasticFoundationForce name=\"obstacle\"><HuntCrossleyForce::ContactParametersSet><objects>\
                    <ElasticFoundationForce::ContactParameters><geometry>heel_r</geometry>\
                    </ElasticFoundationForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet>\
                    </ElasticFoundationForce>";
    let at = SCALED_MODEL
        .find("<ForceSet")
        .map(|at| at + SCALED_MODEL[at..].find("<objects>").unwrap() + "<objects>".len())
        .unwrap();
    let shared = format!("{}{obstacle}{}", &SCALED_MODEL[..at], &SCALED_MODEL[at..]);
    assert!(Model::parse(shared.as_str()).unwrap().forces_of_other_classes().contains_key("heel_r"));
    let found = check_text(&shared, Some(GENERIC_MODEL));
    assert_eq!(codes_found(&found).len(), 1);
    assert!(found.findings.iter().all(|one| one.remedy.is_none()));
}
