//! Tests of pictures of feet: which bodies form feet, and the places of everything on them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::feet::{Bone, DefaultPose, FloorPlace, Foot, FootBodies, FootFrame};
use osim_model::{Anatomy, DVec3, Model, Side, SphereId};

/// A model of a pelvis with two legs of one body each (calcn_r, calcn_l), and toes on each leg; `joint` connects the pelvis with ground.
/// Each foot is 0.1 m to its side and 0.9 m below the pelvis, its toes 0.2 m before it.
fn model_of_walker(joint: &str, gravity: &str, spheres: &str) -> Model {
    let body = |name: &str| format!("<Body name=\"{name}\"><mass>1</mass></Body>");
    let frame = |name: &str, at: &str, body: &str| {
        format!(
            "<PhysicalOffsetFrame name=\"{name}\"><socket_parent>/bodyset/{body}</socket_parent><translation>{at}</translation>\
             </PhysicalOffsetFrame>"
        )
    };
    let weld = |name: &str, parent: &str, at: &str, child: &str| {
        format!(
            "<WeldJoint name=\"{name}\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>c</socket_child_frame>\
             <frames>{}{}</frames></WeldJoint>",
            frame("p", at, parent),
            frame("c", "0 0 0", child)
        )
    };
    let names = ["pelvis", "calcn_r", "toes_r", "calcn_l", "toes_l"];
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><gravity>{gravity}</gravity><BodySet><objects>{}</objects></BodySet>\
         <JointSet><objects>{joint}{}{}{}{}</objects></JointSet><ContactGeometrySet><objects><ContactHalfSpace name=\"floor\">\
         <socket_frame>/ground</socket_frame><location>0 0.05 0</location><orientation>0 0 -1.57079632679489661923</orientation>\
         </ContactHalfSpace>{spheres}</objects></ContactGeometrySet></Model></OpenSimDocument>",
        names.map(body).concat(),
        weld("ankle_r", "pelvis", "0 -0.9 0.1", "calcn_r"),
        weld("mtp_r", "calcn_r", "0.2 0 0", "toes_r"),
        weld("ankle_l", "pelvis", "0 -0.9 -0.1", "calcn_l"),
        weld("mtp_l", "calcn_l", "0.2 0 0", "toes_l"),
    );
    Model::parse(text).unwrap()
}

/// A joint that slides along x, 1 m above ground, with its coordinate at `value`.
fn slider_joint(value: &str) -> String {
    format!(
        "<SliderJoint name=\"root\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>/bodyset/pelvis\
         </socket_child_frame><coordinates><Coordinate name=\"x\"><default_value>{value}</default_value></Coordinate>\
         </coordinates><frames><PhysicalOffsetFrame name=\"p\"><socket_parent>/ground</socket_parent><translation>0 1 0\
         </translation></PhysicalOffsetFrame></frames></SliderJoint>"
    )
}

fn sphere_xml(name: &str, body: &str, at: &str) -> String {
    format!(
        "<ContactSphere name=\"{name}\"><socket_frame>/bodyset/{body}</socket_frame><location>{at}</location><radius>0.03</radius>\
         </ContactSphere>"
    )
}

struct Feet {
    anatomy: Anatomy,
    pose: DefaultPose,
    found: Vec<FootBodies>,
    feet: Vec<Foot>,
}

fn feet_of_model(model: &Model) -> Feet {
    let anatomy = Anatomy::of(model).unwrap();
    let pose = DefaultPose::of(model);
    let spheres: Vec<SphereId> = model.spheres().iter().map(|sphere| sphere.id).collect();
    let found = FootBodies::find(model, &anatomy, &spheres, &model.force_ids(), &pose);
    let feet = Foot::all(model, &anatomy, &found, &pose);
    Feet { anatomy, pose, found, feet }
}

#[track_caller]
fn assert_close(seen: DVec3, expected: [f64; 3]) {
    assert!(seen.abs_diff_eq(expected.into(), 1e-12), "{seen:?}, expected {expected:?}");
}

#[test]
fn places_of_a_foot_are_in_the_frame_of_ground_at_the_default_pose() {
    let spheres =
        [sphere_xml("heel_r", "calcn_r", "0 -0.02 0"), sphere_xml("toe_r", "toes_r", "0.05 -0.01 0.01")]
            .concat();
    let model = model_of_walker(&slider_joint("0.5"), "0 -9.81 0", &spheres);
    let Feet { feet, .. } = feet_of_model(&model);
    let [foot] = feet.as_slice() else { panic!("{feet:?}") };
    assert_eq!(
        (foot.name.as_str(), foot.side, &foot.frame),
        ("calcn_r", Some(Side::Right), &FootFrame::Ground)
    );
    assert_close(foot.spheres[0].centre_m, [0.5, 0.08, 0.1]);
    assert_close(foot.spheres[1].centre_m, [0.75, 0.09, 0.11]);
    let names: Vec<&str> = foot.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["ankle_r", "mtp_r"]);
    assert_close(foot.joints[1].at_m, [0.7, 0.1, 0.1]);
    // From the back of the heel's sphere to the front of the toe's; the floor is level with its bottom.
    assert!((foot.length_m() - 0.31).abs() < 1e-12 && (foot.lowest_m().unwrap() - 0.05).abs() < 1e-12);
    assert_eq!(foot.floor, FloorPlace::At(0.05));
}

#[test]
fn a_model_without_spheres_has_its_feet_near_the_ground() {
    let Feet { feet, .. } = feet_of_model(&model_of_walker(&slider_joint("0"), "0 -9.81 0", ""));
    let names: Vec<(&str, Option<Side>, usize)> =
        feet.iter().map(|foot| (foot.name.as_str(), foot.side, foot.joints.len())).collect();
    assert_eq!(names, [("calcn_r", Some(Side::Right), 2), ("calcn_l", Some(Side::Left), 2)]);
}

#[test]
fn spheres_on_a_body_that_is_no_limb_are_a_foot_of_their_own() {
    let spheres = [sphere_xml("hip", "pelvis", "0 0 0"), sphere_xml("heel_l", "calcn_l", "0 0 0")].concat();
    let Feet { feet, found, .. } = feet_of_model(&model_of_walker(&slider_joint("0"), "0 -9.81 0", &spheres));
    let names: Vec<(&str, usize)> =
        feet.iter().map(|foot| (foot.name.as_str(), foot.spheres.len())).collect();
    assert_eq!(names, [("pelvis", 1), ("calcn_l", 1)]);
    // The legs are not part of the pelvis; toes without spheres are part of the foot.
    assert_eq!(found[0].bodies, ["pelvis"]);
    assert_eq!(found[1].bodies, ["calcn_l", "toes_l"]);
}

/// A chain of `count` bodies, each 1 cm behind the one before. The first is on ground by a joint of the class `root`.
fn chain_of_bodies(count: usize, root: &str, spheres: &str) -> Model {
    let bodies: String =
        (0..count).map(|i| format!("<Body name=\"tail{i}_r\"><mass>1</mass></Body>")).collect();
    let joint = |i: usize| {
        let (class, parent) = match i {
            0 => (root, "/ground".to_owned()),
            _ => ("WeldJoint", format!("/bodyset/tail{}_r", i - 1)),
        };
        format!(
            "<{class} name=\"joint{i}\"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>/bodyset/tail{i}_r\
             </socket_child_frame><frames><PhysicalOffsetFrame name=\"p\"><socket_parent>{parent}</socket_parent>\
             <translation>-0.01 0 0</translation></PhysicalOffsetFrame></frames></{class}>"
        )
    };
    let joints: String = (0..count).map(joint).collect();
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><gravity>0 -9.81 0</gravity><BodySet><objects>{bodies}</objects>\
         </BodySet><JointSet><objects>{joints}</objects></JointSet><ContactGeometrySet><objects>{spheres}</objects>\
         </ContactGeometrySet></Model></OpenSimDocument>"
    );
    Model::parse(text).unwrap()
}

#[test]
fn bodies_of_a_long_chain_are_one_foot() {
    let spheres: String =
        (9..=190).map(|i| sphere_xml(&format!("s{i}"), &format!("tail{i}_r"), "0 0 0")).collect();
    let Feet { feet, found, .. } = feet_of_model(&chain_of_bodies(200, "WeldJoint", &spheres));
    let [foot] = feet.as_slice() else { panic!("{feet:?}") };
    assert_eq!((foot.name.as_str(), foot.spheres.len()), ("tail9_r", 182));
    // From the first with a sphere to the end of the tail, each once.
    let mut bodies: Vec<String> = (9..200).map(|i| format!("tail{i}_r")).collect();
    bodies.sort();
    let mut found: Vec<String> = found[0].bodies.clone();
    assert_eq!(found[0], "tail9_r");
    found.sort();
    assert_eq!(found, bodies);
    // 10 and 191 joints from ground.
    assert_close(foot.spheres[0].centre_m, [-0.1, 0.0, 0.0]);
    assert_close(foot.spheres[181].centre_m, [-1.91, 0.0, 0.0]);
    // If the place of the first body is not known, coordinates are in its frame.
    let Feet { feet, .. } = feet_of_model(&chain_of_bodies(200, "ScapulothoracicJoint", &spheres));
    assert_eq!(feet[0].unplaced, Vec::<String>::new());
    assert_close(feet[0].spheres[181].centre_m, [-1.81, 0.0, 0.0]);
}

#[test]
fn an_unknown_pose_is_drawn_in_the_frame_of_the_body() {
    let joint = slider_joint("0").replace("SliderJoint", "ScapulothoracicJoint");
    let spheres =
        [sphere_xml("heel_r", "calcn_r", "0 -0.02 0"), sphere_xml("toe_r", "toes_r", "0.05 0 0")].concat();
    let Feet { feet, .. } = feet_of_model(&model_of_walker(&joint, "0 -9.81 0", &spheres));
    let [foot] = feet.as_slice() else { panic!("{feet:?}") };
    let FootFrame::Body { name, fault } = &foot.frame else { panic!("{foot:?}") };
    assert_eq!(name, "calcn_r");
    assert!(fault.to_string().contains("ScapulothoracicJoint"), "{fault}");
    assert_close(foot.spheres[0].centre_m, [0.0, -0.02, 0.0]);
    assert_close(foot.spheres[1].centre_m, [0.25, 0.0, 0.0]);
    assert_eq!(foot.floor, FloorPlace::NotInGround);
    // Feet without spheres are known by their names then.
    let without = model_of_walker(&joint, "0 -9.81 0", "");
    assert_eq!(feet_of_model(&without).feet.len(), 2);
}

#[test]
fn up_is_z_if_gravity_points_along_minus_z() {
    let Feet { feet, .. } = feet_of_model(&model_of_walker(
        &slider_joint("0"),
        "0 0 -9.81",
        &sphere_xml("heel_r", "calcn_r", "0 0 0.02"),
    ));
    assert_eq!(feet[0].axes.names(), ["x", "z", "−y"]);
    // The foot is at 0.1 m along z, its sphere's bottom at 0.1 + 0.02 - 0.03; the half-space is a wall.
    assert!((feet[0].lowest_m().unwrap() - 0.09).abs() < 1e-12);
    assert_eq!(feet[0].floor, FloorPlace::None);
}

#[test]
fn bones_are_drawn_at_the_places_of_their_bodies() {
    let spheres = sphere_xml("heel_r", "calcn_r", "0.05 0 0");
    let model = model_of_walker(&slider_joint("0.5"), "0 -9.81 0", &spheres);
    let Feet { anatomy, pose, found, mut feet } = feet_of_model(&model);
    let bone = Bone::new("calcn_r", "foot.vtp", vec![[-0.05, 0.0, 0.0], [0.15, 0.0, 0.0], [0.0, 5.0, 0.0]]);
    let toes = Bone::new("toes_r", "toes.vtp", vec![[0.0, 0.0, 0.0], [0.0, 5.0, 0.0]]);
    feet[0].add_bones(&anatomy, &found[0], &[bone, toes], &pose);
    let foot = &feet[0];
    assert_close(foot.bones[0].points_m[0], [0.45, 0.1, 0.1]);
    assert_eq!(foot.bones[0].points_m.len(), 3);
    // What is high above a foot is left out on bodies without spheres.
    assert_eq!(foot.bones[1].points_m.len(), 1);
    // The centre is half of the bone's length from the heel.
    let (first, last) = foot.sphere_extent().unwrap();
    assert!((first - 0.5).abs() < 1e-12 && first == last);
}
