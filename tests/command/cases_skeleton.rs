//! Cases with damaged skeletons: a published model with an edit of its text.

use crate::cases::{check_json, codes_of_severity, finding_with_code};
use crate::support::{TestDir, corpus_folder};

/// The report of `check` about the human of Falisse et al. (2022) with an edit; `None` after reporting that the test is skipped.
fn report_after(test: &str, edit: impl Fn(&str) -> String) -> Option<serde_json::Value> {
    let text = std::fs::read_to_string(corpus_folder(test)?.join("v40000_falisse_2022_human.osim")).unwrap();
    let dir = TestDir::new();
    let edited = edit(&text);
    assert_ne!(edited, text);
    dir.write("model.osim", edited);
    Some(check_json(&dir, "model.osim"))
}

/// The text with the first `old` after `start` replaced.
fn replaced_after(text: &str, start: &str, old: &str, new: &str) -> String {
    let at = text.find(start).unwrap();
    format!("{}{}", &text[..at], text[at..].replacen(old, new, 1))
}

#[test]
fn a_shank_on_the_other_thigh_causes_a_warning() {
    let edit = |text: &str| replaced_after(text, "name=\"knee_l\"", "/bodyset/femur_l<", "/bodyset/femur_r<");
    let Some(report) = report_after("a_shank_on_the_other_thigh_causes_a_warning", edit) else { return };
    let found = finding_with_code(&report, "odd-parent");
    assert_eq!((&found["severity"], &found["place"]), (&"warning".into(), &"/jointset/knee_l".into()));
    let message = found["message"].as_str().unwrap();
    assert!(
        message.starts_with("tibia_l hangs on femur_r, unlike its counterpart; toes_l is 16"),
        "{message}"
    );
}

#[test]
fn both_feet_on_ground_cause_a_warning() {
    let edit = |text: &str| {
        let right = replaced_after(text, "<CustomJoint name=\"ankle_r\"", "/bodyset/tibia_r<", "/ground<");
        replaced_after(&right, "<CustomJoint name=\"ankle_l\"", "/bodyset/tibia_l<", "/ground<")
    };
    let Some(report) = report_after("both_feet_on_ground_cause_a_warning", edit) else { return };
    let found = finding_with_code(&report, "odd-parent");
    assert_eq!(found["severity"], "warning");
    assert_eq!(found["message"], "talus_r and talus_l hang on ground, apart from the rest of their limbs");
}

#[test]
fn a_torso_that_is_welded_to_ground_causes_a_remark() {
    let weld = "<objects><WeldConstraint name=\"stand\"><socket_frame1>/ground</socket_frame1>\
        <socket_frame2>/bodyset/torso</socket_frame2></WeldConstraint></objects>";
    let edit = |text: &str| replaced_after(text, "<ConstraintSet ", "<objects />", weld);
    let Some(report) = report_after("a_torso_that_is_welded_to_ground_causes_a_remark", edit) else { return };
    let found = finding_with_code(&report, "root-held");
    assert_eq!(found["severity"], "remark");
    assert!(found["message"].as_str().unwrap().contains("stand fixes torso to ground"), "{found}");
}

#[test]
fn a_held_pelvis_causes_a_remark() {
    let edit = |text: &str| {
        replaced_after(text, "name=\"pelvis_ty\"", "<locked>false</locked>", "<locked>true</locked>")
    };
    let Some(report) = report_after("a_held_pelvis_causes_a_remark", edit) else { return };
    let found = finding_with_code(&report, "root-held");
    assert_eq!(found["severity"], "remark");
    let message = found["message"].as_str().unwrap();
    assert!(message.starts_with("pelvis is held: pelvis_ty is locked"), "{message}");
}

#[test]
fn a_mirrored_mesh_accuses_no_sphere() {
    let test = "a_mirrored_mesh_accuses_no_sphere";
    let size = "0.9139243779317624 0.9139243779317624 ";
    let edits = [
        ["<mesh_file>l_foot.vtp<", "<mesh_file>r_foot.vtp<"],
        [&format!("<scale_factors>{size}"), &format!("<scale_factors>{size}-")],
    ];
    for [old, new] in edits {
        let edit = |text: &str| replaced_after(text, "<Body name=\"calcn_l\">", old, new);
        let Some(report) = report_after(test, edit) else { return };
        assert_eq!(
            codes_of_severity(&report, "warning").len() + codes_of_severity(&report, "error").len(),
            0
        );
    }
}
