//! Models of which OpenSim refuses or ignores a part, or reads other numbers than are written, as users found them. Each is a folder in the
//! folder that OSIM_CASES names.

use serde_json::Value;

use crate::cases::{check_json, codes_of_severity, dir_of_case, finding_with_code};
use crate::support::{TestDir, corpus_folder, fixture};

/// The severity, the place and the message of the finding `code` about the model of a case.
fn found_in_case(case: &str, code: &str) -> Option<(String, String, String)> {
    let report = check_json(&dir_of_case(case)?, "model.osim");
    Some(of_finding(finding_with_code(&report, code)))
}

fn of_finding(finding: &Value) -> (String, String, String) {
    let text = |key: &str| finding[key].as_str().unwrap_or_default().to_owned();
    (text("severity"), text("place"), text("message"))
}

/// A published model of the corpus; `None` after reporting that the test is skipped.
fn text_of_published_model(test: &str, name: &str) -> Option<String> {
    Some(std::fs::read_to_string(corpus_folder(test)?.join(format!("{name}.osim"))).unwrap())
}

#[test]
fn a_floor_whose_orientation_opensim_cannot_read_is_an_error() {
    let Some((severity, place, message)) = found_in_case("floor_orientation_unreadable", "odd-number") else {
        return;
    };
    assert_eq!(severity, "error");
    assert!(place.starts_with("/contactgeometryset/"), "{place}");
    assert!(message.contains("'0,0,-1.5707963'") && message.ends_with("OpenSim reads as 0 0 0"), "{message}");
}

#[test]
fn a_frame_whose_translation_opensim_cannot_read_is_an_error() {
    let Some((severity, place, message)) = found_in_case("leg_bone_unreadable", "odd-number") else { return };
    assert_eq!(severity, "error");
    assert!(message.contains("translation") && message.ends_with("OpenSim reads as 0 0 0"), "{message}");
    assert!(place.contains("tibia_r") || place.contains("femur_r"), "{place}");
    // The legs are no mirror images because of it: one cause has one finding.
    let report = check_json(&dir_of_case("leg_bone_unreadable").unwrap(), "model.osim");
    assert!(!report.to_string().contains("left-right-bones"), "{report}");
}

#[test]
fn a_flag_that_opensim_cannot_read_is_an_error() {
    let Some(text) = text_of_published_model(
        "a_flag_that_opensim_cannot_read_is_an_error",
        "v40000_human_12_hunt_crossley",
    ) else {
        return;
    };
    let dir = TestDir::new();
    let start = text.find("<HuntCrossleyForce name=").unwrap();
    let (before, forces) = text.split_at(start);
    let text = format!("{before}{}", forces.replacen("<appliesForce>true<", "<appliesForce>no<", 1));
    dir.write("model.osim", text);
    let report = check_json(&dir, "model.osim");
    let (severity, place, message) = of_finding(finding_with_code(&report, "odd-number"));
    assert_eq!(severity, "error");
    assert!(
        place.starts_with("/forceset/") && message.ends_with("'no', which OpenSim reads as true"),
        "{message}"
    );
}

#[test]
fn sockets_that_lead_nowhere_are_errors_and_the_command_connects_them() {
    for (case, owner, path) in [
        ("joint-socket-nowhere", "/jointset/ground_pelvis/", "/bodyset/pelvis"),
        ("contact-frame-bare-name", "/contactgeometryset/", "/bodyset/calcn_r"),
    ] {
        let Some(dir) = dir_of_case(case) else { return };
        let report = check_json(&dir, "model.osim");
        let findings = report["findings"].as_array().unwrap().iter();
        let about: Vec<_> =
            findings.filter(|one| one["code"] == "connectee-by-name").map(of_finding).collect();
        assert!(about.iter().all(|(severity, ..)| severity == "error"), "{about:?}");
        assert!(
            about.iter().any(|(_, place, message)| place.starts_with(owner) && message.contains(path)),
            "{case}: {about:?}"
        );
        // Joints and spheres are named.
        assert!(about.iter().any(|(_, place, _)| place.starts_with("/jointset/")), "{about:?}");
        let commands = report["commands"].as_array().unwrap().iter().filter_map(Value::as_str);
        let command = commands.filter(|one| one.contains("--sockets")).collect::<Vec<_>>();
        let [command] = command[..] else { panic!("{report}") };
        let command = command.strip_prefix("osim-contact-scale ").unwrap();
        dir.run(&format!("{command} -o right.osim")).succeeded();
        let right = check_json(&dir, "right.osim");
        assert!(!codes_of_severity(&right, "error").contains("connectee-by-name"), "{right}");
        // All lines but those of sockets are the same.
        let (old, new) = (dir.read("model.osim"), dir.read("right.osim"));
        let (old, new) = (String::from_utf8(old).unwrap(), String::from_utf8(new).unwrap());
        assert_eq!(old.lines().count(), new.lines().count());
        let mut changed = old.lines().zip(new.lines()).filter(|(old, new)| old != new);
        assert!(changed.all(|(old, _)| old.trim_start().starts_with("<socket_")), "{case}");
    }
}

#[test]
fn a_body_without_a_joint_is_an_error_and_no_mass_is_compared() {
    let Some(text) =
        text_of_published_model("a_body_without_a_joint_is_an_error", "v40000_falisse_2022_human")
    else {
        return;
    };
    let start = text.find("<Body name=\"calcn_r\">").unwrap();
    let end = start + text[start..].find("</Body>").unwrap() + "</Body>".len();
    let copy = text[start..end].replace("calcn_r", "calcn_copy");
    let dir = TestDir::new();
    dir.write("model.osim", format!("{}{copy}{}", &text[..start], &text[start..]));
    let report = check_json(&dir, "model.osim");
    let (severity, place, _) = of_finding(finding_with_code(&report, "body-without-joint"));
    assert_eq!((severity.as_str(), place.as_str()), ("error", "/bodyset/calcn_copy"));
    assert!(!report.to_string().contains("contacts-of-another-mass"), "{report}");
    assert_eq!(report["commands"], Value::Array(Vec::new()));
}

#[test]
fn classes_and_versions_that_opensim_does_not_read_are_errors() {
    for (case, code, word) in
        [("class_misspelt", "unknown-name", "HuntCrosleyForce"), ("version_30000", "other-version", "30000")]
    {
        let Some((severity, _, message)) = found_in_case(case, code) else { return };
        assert_eq!(severity, "error", "{case}");
        assert!(message.contains(word), "{message}");
    }
}

/// What follows from the mass that OpenSim then takes, not a number, is not said besides.
#[test]
fn a_misspelt_mass_is_one_error() {
    let dir = TestDir::with_human();
    let text = dir.text("human.osim").replacen("<mass>", "<mas>", 1).replacen("</mass>", "</mas>", 1);
    dir.write("human.osim", text);
    let report = check_json(&dir, "human.osim");
    assert_eq!(report["counts"]["error"], 1, "{report}");
    let found = finding_with_code(&report, "unknown-name");
    assert!(found["message"].as_str().unwrap().contains("mass is meant"), "{found}");
}

#[test]
fn contacts_that_opensim_does_not_read_cause_a_warning() {
    for case in ["empty_forceset_first", "forces_outside_objects"] {
        let Some((severity, _, message)) = found_in_case(case, "ignored-contacts") else { return };
        assert_eq!(severity, "warning", "{case}");
        assert!(message.contains("11 other objects"), "{case}: {message}");
        let report = check_json(&dir_of_case(case).unwrap(), "model.osim");
        assert!(!codes_of_severity(&report, "remark").contains("bare-model"), "{report}");
    }
}

#[test]
fn one_misspelt_name_is_one_finding() {
    for (model, name) in [
        ("format/v40000.osim", "geometry"),
        ("format/v40000.osim", "static_friction"),
        ("format/v40000.osim", "dissipation"),
        ("format/v40000.osim", "stiffness"),
        ("format/v40000.osim", "radius"),
        ("format/v40000.osim", "frames"),
        ("scale_tool/generic_smooth.osim", "static_friction"),
        ("scale_tool/generic_smooth.osim", "stiffness"),
        ("scale_tool/generic_smooth.osim", "frames"),
        ("scale_tool/generic_smooth.osim", "translation"),
        ("feet/human_40000.osim", "coordinates"),
    ] {
        let text = String::from_utf8(fixture(model)).unwrap();
        let misspelt = format!("{}x{}", &name[..3], &name[3..]);
        let text = text.replacen(&format!("<{name}>"), &format!("<{misspelt}>"), 1);
        let dir = TestDir::new();
        dir.write("model.osim", text.replacen(&format!("</{name}>"), &format!("</{misspelt}>"), 1));
        let report = check_json(&dir, "model.osim");
        let findings = report["findings"].as_array().unwrap().iter().map(of_finding);
        let found: Vec<_> = findings.filter(|(severity, ..)| severity != "remark").collect();
        let [(severity, _, message)] = &found[..] else { panic!("{model}, {misspelt}: {found:?}") };
        assert!(severity == "error" && message.contains(&misspelt), "{message}");
        assert!(message.ends_with(&format!("{name} is meant")), "{message}");
    }
}
