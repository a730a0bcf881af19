//! The files for what follows a correction: tracking with Moco, with its script, and NMSM's ground contact personalisation.

use std::fmt::Display;

use osim_model::{ForceKind, Model, moving_spheres};
use osim_motion::FootSummary;
use osim_planning::{MocoStart, MotionResult, NextModels};

use super::motion::{corrected_motion, moved_plates_xml, plates_sto, storage_file_text};

/// The script with a placeholder for the feet and the times.
const SCRIPT: &str = include_str!("track.py");
/// The line of the script in which the feet are filled in.
const FEET: &str = "FEET = {}\n";
/// The line of the script in which the first and the last time are filled in.
const TIMES: &str = "START, END = 0.0, 1.0\n";

/// Names of the files for Moco, in their folder.
pub const MOCO_FILES: [&str; 5] = ["model.osim", "motion.sto", "plates.sto", "plates.xml", "track.py"];
/// Names of the files for NMSM, in their folder.
pub const NMSM_FILES: [&str; 3] = ["model.osim", "motion.sto", "plates.sto"];

/// The texts of [`MOCO_FILES`], which track a corrected motion with Moco; none if the request wants none.
pub fn moco_files(result: &MotionResult, next: &NextModels) -> Vec<Vec<u8>> {
    let Some(MocoStart { model, smooth }) = &next.moco else { return Vec::new() };
    let result = smooth.as_deref().unwrap_or(result);
    let Some((correction, measured)) = result.correction().zip(result.measured.as_ref()) else {
        return Vec::new();
    };
    let known = measured.longest_known();
    let time_s = |frame: usize| result.states.time_s.get(frame).copied().unwrap_or_default();
    let times =
        format!("START, END = {:?}, {:?}\n", time_s(known.start), time_s(known.end.saturating_sub(1)));
    let script = SCRIPT.replace(FEET, &format!("FEET = {}\n", feet(result, model))).replace(TIMES, &times);
    vec![
        model.document().bytes().to_vec(),
        corrected_motion(result, correction, "motion.sto").into_bytes(),
        plates_sto(result, known, &correction.belt_way_m, "plates.sto").into_bytes(),
        moved_plates_xml(result, "plates.sto").into_bytes(),
        script.into_bytes(),
    ]
}

/// A dictionary in Python: the force of the plates on each foot, with the contacts under the foot and its bodies after the first.
fn feet(result: &MotionResult, model: &Model) -> String {
    let quoted = |text: &dyn Display| serde_json::json!(text.to_string()).to_string();
    let mut text = "{".to_owned();
    let is_measured =
        |foot: &&FootSummary| foot.comparison.is_some_and(|plates| plates.measured_peak_n > 0.0);
    for foot in result.summary.feet.iter().filter(is_measured).map(|foot| &foot.foot) {
        let Some((first, others)) = foot.bodies.split_first() else { continue };
        let is_under = |force: &&osim_model::Force| {
            let spheres = moving_spheres(model, &[force.id]);
            let mut bodies = spheres.iter().filter_map(|&sphere| model.sphere(sphere)?.body.as_ref());
            force.kind == ForceKind::SmoothSphereHalfSpace
                && force.applies
                && bodies.any(|body| foot.bodies.contains(body))
        };
        let contacts: Vec<String> =
            model.forces().iter().filter(is_under).map(|force| quoted(&force.path)).collect();
        let others: Vec<String> = others.iter().map(|body| quoted(&format!("/bodyset/{body}"))).collect();
        let (load, contacts, others) =
            (quoted(&format!("plates_{first}")), contacts.join(", "), others.join(", "));
        text.push_str(&format!("\n    {load}: ([{contacts}], [{others}]),"));
    }
    text + "\n}"
}

/// The texts of [`NMSM_FILES`]: the motion as it was measured, and the plates at the same times; none if the request wants none.
pub fn nmsm_files(result: &MotionResult, next: &NextModels) -> Vec<Vec<u8>> {
    let Some((model, measured)) = next.nmsm.as_ref().zip(result.measured.as_ref()) else {
        return Vec::new();
    };
    let known = measured.longest_known();
    let recording = &result.recording;
    let columns: Vec<String> =
        recording.coordinates.iter().map(|coordinate| coordinate.name.clone()).collect();
    let motion = storage_file_text("motion.sto", "", &columns, &recording.time_s[known.clone()], |row| {
        recording.values(known.start + row).to_vec()
    });
    vec![
        model.document().bytes().to_vec(),
        motion.into_bytes(),
        plates_sto(result, known, &[], "plates.sto").into_bytes(),
    ]
}
