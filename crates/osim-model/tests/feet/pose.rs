//! Tests of joints that cannot be placed at the default pose. `tests/oracle/test_feet.py` tests the places of bodies.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::Model;
use osim_model::feet::{DefaultPose, PoseFault};

/// The default pose of a model with the bodies a, b and c, with `joints` and `constraints`.
fn default_pose(joints: &str, constraints: &str) -> DefaultPose {
    let bodies: String =
        ["a", "b", "c"].map(|name| format!("<Body name=\"{name}\"><mass>1</mass></Body>")).concat();
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects>{bodies}</objects></BodySet><JointSet><objects>{joints}\
         </objects></JointSet><ConstraintSet><objects>{constraints}</objects></ConstraintSet></Model></OpenSimDocument>"
    );
    DefaultPose::of(&Model::parse(text).unwrap())
}

/// A joint that slides along x.
fn slider_joint(name: &str, parent: &str, child: &str, value: &str) -> String {
    joint_xml("SliderJoint", name, parent, child, value)
}

fn joint_xml(class: &str, name: &str, parent: &str, child: &str, value: &str) -> String {
    let path = |body: &str| if body == "ground" { "/ground".into() } else { format!("/bodyset/{body}") };
    format!(
        "<{class} name=\"{name}\"><socket_parent_frame>{}</socket_parent_frame><socket_child_frame>{}</socket_child_frame>\
         <coordinates><Coordinate name=\"{name}_x\"><default_value>{value}</default_value></Coordinate></coordinates></{class}>",
        path(parent),
        path(child)
    )
}

fn x_in_ground(pose: &DefaultPose, body: &str) -> Result<f64, String> {
    pose.placement(body).map(|there| there.translation_m[0]).map_err(|fault| fault.to_string())
}

#[test]
fn bodies_are_found_through_joints_in_either_direction() {
    let joints = [
        slider_joint("j", "ground", "b", "0.5"),
        slider_joint("k", "a", "b", "0.2"),
        slider_joint("l", "a", "c", "1"),
    ]
    .concat();
    let pose = default_pose(&joints, "");
    assert_eq!(
        (x_in_ground(&pose, "b"), x_in_ground(&pose, "a"), x_in_ground(&pose, "c")),
        (Ok(0.5), Ok(0.3), Ok(1.3))
    );
}

#[test]
fn an_unknown_joint_makes_the_bodies_that_it_moves_unknown() {
    let joints = [
        slider_joint("j", "ground", "a", "0.5"),
        joint_xml("PluginJoint", "k", "a", "b", "0"),
        slider_joint("l", "b", "c", "1"),
    ];
    let found = default_pose(&joints.concat(), "");
    assert_eq!(x_in_ground(&found, "a"), Ok(0.5));
    let unknown = "the default pose of joint k, a PluginJoint, cannot be computed: one of its functions, or the joint itself, \
                   is not understood";
    assert_eq!(
        (x_in_ground(&found, "b"), x_in_ground(&found, "c")),
        (Err(unknown.into()), Err(unknown.into()))
    );
    let word = default_pose(&slider_joint("j", "ground", "a", "far"), "");
    assert_eq!(
        x_in_ground(&word, "a"),
        Err("coordinate j_x of joint j has no default value that can be read".into())
    );
    assert_eq!(
        x_in_ground(&word, "b"),
        Err("no joints lead from ground to body b, so it is not known where it is at the default pose".into())
    );
}

/// Loops of joints that close at the default pose change nothing. For loops that do not close, OpenSim would choose a place.
#[test]
fn loops_of_joints_must_be_closed_in_the_default_pose() {
    let ring = |last: &str| {
        let joints = [
            slider_joint("j", "ground", "a", "0.5"),
            slider_joint("k", "a", "b", "0.2"),
            slider_joint("l", "ground", "b", last),
        ];
        default_pose(&joints.concat(), "")
    };
    assert_eq!(x_in_ground(&ring("0.7"), "b"), Ok(0.7));
    let Err(PoseFault::Loop { joint }) = ring("0.8").placement("a").cloned() else { panic!("it is open") };
    assert!(["j", "k", "l"].contains(&&*joint));
}

#[test]
fn constraints_other_than_couplers_are_not_computed() {
    let joints = slider_joint("j", "ground", "a", "0.5");
    let weld = |flag: &str| format!("<WeldConstraint name=\"w\">{flag}</WeldConstraint>");
    assert_eq!(
        x_in_ground(&default_pose(&joints, &weld("")), "a"),
        Err("constraint w, a WeldConstraint, may move bodies at the default pose, which is not computed: switch it off in a copy of \
             the model"
            .into())
    );
    assert_eq!(x_in_ground(&default_pose(&joints, &weld("<isEnforced>false</isEnforced>")), "a"), Ok(0.5));
}

/// A chain with far more bodies than any animal has.
#[test]
fn long_chains_of_joints_are_walked_once() {
    const BODIES: usize = 20_000;
    let bodies: String = (0..BODIES).map(|n| format!("<Body name=\"b{n}\"><mass>1</mass></Body>")).collect();
    let joints: String = (0..BODIES)
        .map(|n| {
            let parent = if n == 0 { "ground".into() } else { format!("b{}", n - 1) };
            slider_joint(&format!("j{n}"), &parent, &format!("b{n}"), "0.001")
        })
        .collect();
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects>{bodies}</objects></BodySet><JointSet><objects>{joints}\
         </objects></JointSet></Model></OpenSimDocument>"
    );
    let pose = DefaultPose::of(&Model::parse(text).unwrap());
    assert!((x_in_ground(&pose, "b19999").unwrap() - 20.0).abs() < 1e-9);
}
