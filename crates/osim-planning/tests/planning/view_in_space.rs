//! The three-dimensional view of a model: bodies, spheres, forces and bones, at the default pose and along a recording.

use std::path::{Path, PathBuf};

use osim_inspect::InspectOptions;
use osim_model::Model;
use osim_model::files::{Files, InMemory};
use osim_model::messages::FieldNames;
use osim_planning::run_motion;
use osim_planning::scene::{BoneSurfaces, PlayedRecording, Scene};
use osim_requests::MotionRequest;
use serde_json::Value;

fn read_fixture(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn numbers_in_json(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|one| one.as_f64().unwrap()).collect()
}

fn recorded_walk() -> (InMemory, MotionRequest) {
    let mut files = InMemory::default();
    for name in ["walker.osim", "walk.mot", "plates.sto", "plates.xml"] {
        files.add(name, read_fixture(&format!("motion/{name}")));
    }
    let named = |name: &str| Some(PathBuf::from(name));
    let request = MotionRequest {
        subject: named("walker.osim"),
        motion: named("walk.mot"),
        plates: named("plates.sto"),
        loads: named("plates.xml"),
        ..MotionRequest::default()
    };
    (files, request)
}

/// Other tests (`tests/oracle`) compare the sphere centres of `run_motion` with OpenSim. Here, the bodies in the view carry the spheres to
/// the same places.
#[test]
fn bodies_along_a_recording_carry_their_spheres_where_the_motion_has_them() {
    let (files, request) = recorded_walk();
    let result = run_motion(&request, &files).unwrap();
    let played = serde_json::to_value(PlayedRecording::of(&result, &request, &FieldNames)).unwrap();
    let bodies: Vec<&str> =
        played["bodies"].as_array().unwrap().iter().map(|body| body.as_str().unwrap()).collect();
    let poses = numbers_in_json(&played["poses"]);
    let frames = result.states.frames();
    assert_eq!(numbers_in_json(&played["time_s"]).len(), frames);
    assert_eq!(poses.len(), frames * bodies.len() * 12);
    for (index, pair) in result.states.pairs.iter().enumerate() {
        let body = bodies.iter().position(|name| **name == *pair.body).unwrap();
        let centre = result.opened.model.centre_m(pair.sphere).unwrap();
        for frame in 0..frames {
            let part = |at: usize| poses[(frame * bodies.len() + body) * 12 + at] / 1e5;
            let there: [f64; 3] = std::array::from_fn(|i| {
                part(9 + i) + (0..3).map(|axis| centre[axis] * part(3 * axis + i)).sum::<f64>()
            });
            let expected = result.states.frame(frame)[index].centre_m;
            let apart = (0..3).map(|i| (there[i] - expected[i]).abs()).fold(0.0, f64::max);
            assert!(apart < 3e-5, "sphere {index}, frame {frame}: {there:?}, {expected:?}");
        }
    }
}

#[test]
fn forces_of_feet_are_those_of_the_motion_and_plates_have_a_place() {
    let (files, request) = recorded_walk();
    let result = run_motion(&request, &files).unwrap();
    let played = serde_json::to_value(PlayedRecording::of(&result, &request, &FieldNames)).unwrap();
    let feet = played["feet"].as_array().unwrap();
    for frame in 0..result.states.frames() {
        let up = |foot: &Value| foot["model"]["forces_bw"][frame][1].as_f64().unwrap();
        let of_feet: f64 = feet.iter().map(up).sum();
        // The floor is level, and friction is across its normal.
        let of_spheres: f64 = result.states.frame(frame).iter().map(|state| state.normal_force_n).sum();
        let apart = of_feet - of_spheres / result.summary.weight_n;
        assert!(apart.abs() < 1e-9, "frame {frame}: {apart}");
    }
    // The plates of `make_motion.py` are under both feet.
    assert!(
        feet.iter().all(|foot| foot["plates"]["points_m"].as_array().unwrap().iter().any(Value::is_array))
    );
    assert!(
        played["remarks"]
            .as_array()
            .unwrap()
            .iter()
            .any(|remark| remark.as_str().unwrap().contains("right foot"))
    );
}

#[test]
fn spheres_at_rest_carry_the_body_weight_together() {
    let model = Model::parse(read_fixture("table1/human_62kg_smooth_sphere.osim")).unwrap();
    let scene = serde_json::to_value(Scene::of(&model, &InspectOptions::default())).unwrap();
    let spheres = scene["spheres"].as_array().unwrap();
    assert_eq!((spheres.len(), scene["planes"].as_array().unwrap().len()), (12, 1));
    let sum: f64 = spheres.iter().map(|sphere| sphere["force_bw"].as_f64().unwrap()).sum();
    assert!((sum - 1.0).abs() < 1e-9, "{sum}");
    assert_eq!(scene["axes"][1], serde_json::json!([0.0, 1.0, 0.0]));
    assert!(spheres.iter().filter(|sphere| sphere["side"] == "right").count() == 6);
}

/// The places of the left foot are those of the right foot with z negated, because make_feet.py writes both.
#[test]
fn bones_are_on_their_bodies_and_missing_ones_are_named() {
    let model = Model::parse(read_fixture("feet/human_40000.osim")).unwrap();
    let mut files = InMemory::default();
    for name in ["r_human_foot.vtp", "l_human_foot.vtp"] {
        files.add(name, read_fixture(&format!("feet/Geometry/{name}")));
    }
    assert!(files.exists(Path::new("r_human_foot.vtp")));
    let bones = serde_json::to_value(BoneSurfaces::of(&model, Path::new("human.osim"), &files)).unwrap();
    let surfaces = bones["surfaces"].as_array().unwrap();
    assert!(surfaces.iter().all(|surface| surface["triangles"].as_array().unwrap().len() == 3 * 188));
    let z = |mesh: &str| -> Vec<f64> {
        let surface = surfaces.iter().find(|surface| surface["mesh"] == mesh).unwrap();
        numbers_in_json(&surface["points"]).chunks(3).map(|point| point[2]).collect()
    };
    let mirrored: Vec<f64> = z("l_human_foot.vtp").iter().map(|value| -value).collect();
    assert_eq!(z("r_human_foot.vtp"), mirrored);
    let missing = bones["missing"].as_array().unwrap();
    assert!(
        !missing.is_empty() && missing.iter().all(|name| !name.as_str().unwrap().contains("human_foot")),
        "{missing:?}"
    );
}
