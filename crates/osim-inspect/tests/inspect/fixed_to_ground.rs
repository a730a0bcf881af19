//! Bodies welded to ground: which of them are fixed objects, and which belong to the animal. `tests/oracle` adds up the same bodies in
//! fixtures and published models.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use osim_inspect::model_findings;
use osim_model::{FindingCode, MassRequest, Model};

/// A model with bodies of 1, 2, 4, ... kg with these names, and joints, each given by class, parent and child.
fn model_of_bodies(bodies: &[&str], joints: &[(&str, &str, &str)]) -> Model {
    let bodies = bodies.iter().enumerate();
    let bodies: String = bodies
        .map(|(place, name)| format!("<Body name='{name}'><mass>{}</mass></Body>", 1 << place))
        .collect();
    let path = |name: &str| if name == "ground" { "/ground".into() } else { format!("/bodyset/{name}") };
    let joints: String = joints
        .iter()
        .enumerate()
        .map(|(place, (class, parent, child))| {
            format!(
                "<{class} name='joint_{place}'><socket_parent_frame>{}</socket_parent_frame>\
                 <socket_child_frame>{}</socket_child_frame></{class}>",
                path(parent),
                path(child)
            )
        })
        .collect();
    let text = format!(
        "<OpenSimDocument Version='40000'><Model name='m'><BodySet><objects>{bodies}</objects></BodySet><JointSet><objects>{joints}\
         </objects></JointSet></Model></OpenSimDocument>"
    );
    Model::parse(text).unwrap()
}

#[test]
fn a_body_welded_to_ground_has_no_weight_unless_the_animal_hangs_on_it() {
    let (weld, free) = ("WeldJoint", ("FreeJoint", "ground", "animal"));
    for (bodies, joints, kg, fixed) in [
        // A goalkeeper, of two bodies, and one that is joined the other way round.
        (
            ["animal", "goal", "keeper"].as_slice(),
            [free, (weld, "ground", "goal"), (weld, "goal", "keeper")].as_slice(),
            1.0,
            ["goal", "keeper"].as_slice(),
        ),
        (&["animal", "goal"], &[free, (weld, "goal", "ground")], 1.0, &["goal"]),
        // A platform from which the animal walks away.
        (
            &["platform", "animal"],
            &[(weld, "ground", "platform"), ("PlanarJoint", "platform", "animal")],
            2.0,
            &["platform"],
        ),
        // A pelvis that is held, with a leg; the trunk on the pelvis belongs to it, the goal does not.
        (
            &["pelvis", "leg", "trunk", "goal"],
            &[
                (weld, "ground", "pelvis"),
                ("PinJoint", "pelvis", "leg"),
                (weld, "pelvis", "trunk"),
                (weld, "ground", "goal"),
            ],
            7.0,
            &["goal"],
        ),
        // A body of the animal that is welded to another one of it.
        (&["animal", "trunk"], &[free, (weld, "animal", "trunk")], 3.0, &[]),
    ] {
        let model = model_of_bodies(bodies, joints);
        assert_eq!(MassRequest::default().model_mass(&model).unwrap().kg, kg, "{joints:?}");
        let found: Vec<&str> =
            model.bodies().iter().filter(|body| body.excluded_from_mass).map(|body| &*body.name).collect();
        assert_eq!(found, fixed, "{joints:?}");
        let said = model_findings(&model).iter().any(|finding| finding.code() == FindingCode::Terrain);
        assert_eq!(said, !fixed.is_empty(), "{joints:?}");
    }
}

#[test]
fn a_model_of_fixed_bodies_alone_has_no_mass() {
    let model = model_of_bodies(&["goal"], &[("WeldJoint", "ground", "goal")]);
    assert_eq!(MassRequest::default().model_mass(&model).unwrap_err().code(), "no-mass");
}
