//! Loops of joints, and joints that OpenSim ignores. The expected results were seen in OpenSim 4.6; `tests/oracle/test_words.py` compares
//! with OpenSim again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use osim_inspect::model_findings;
use osim_model::{MassRequest, Model};

/// A model with bodies a, b and c of 10, 20 and 40 kg in a loop. The joint between b and c, of class `class`, closes the loop.
fn loop_closed_by(class: &str) -> Model {
    let bodies = [("a", 10), ("b", 20), ("c", 40)];
    let bodies = bodies.map(|(name, kg)| format!("<Body name='{name}'><mass>{kg}</mass></Body>")).concat();
    let joint = |class: &str, name: &str, parent: &str, child: &str| {
        format!(
            "<{class} name='{name}'><socket_parent_frame>{parent}</socket_parent_frame><socket_child_frame>/bodyset/{child}\
             </socket_child_frame></{class}>"
        )
    };
    let joints = [
        joint("FreeJoint", "root", "/ground", "a"),
        joint("PinJoint", "ab", "/bodyset/a", "b"),
        joint("PinJoint", "ac", "/bodyset/a", "c"),
        if class.is_empty() { String::new() } else { joint(class, "bc", "/bodyset/b", "c") },
    ];
    let text = format!(
        "<OpenSimDocument Version='40000'><Model name='m'><BodySet><objects>{bodies}</objects></BodySet><JointSet><objects>{}\
         </objects></JointSet></Model></OpenSimDocument>",
        joints.concat()
    );
    Model::parse(text).unwrap()
}

fn finding_codes(model: &Model) -> Vec<&str> {
    model_findings(model).iter().map(|finding| finding.code().as_str()).collect()
}

// OpenSim 4.6: 70 kg without the joint and with a PinJoint (c is divided), 110 kg with a WeldJoint or a FreeJoint.
#[test]
fn a_loop_is_reported_and_its_mass_asked_for_if_opensim_counts_a_body_twice() {
    let weighs = |model: &Model, mass: MassRequest| mass.model_mass(model).map(|mass| mass.kg);
    for (class, found) in
        [("", [""; 0].as_slice()), ("PinJoint", &["loop-of-joints"]), ("BallJoint", &["loop-of-joints"])]
    {
        let model = loop_closed_by(class);
        assert_eq!(
            (finding_codes(&model).as_slice(), weighs(&model, MassRequest::default()).unwrap()),
            (found, 70.0)
        );
    }
    for class in ["WeldJoint", "FreeJoint"] {
        let model = loop_closed_by(class);
        assert_eq!(finding_codes(&model), ["loop-of-joints"]);
        assert_eq!(weighs(&model, MassRequest::default()).unwrap_err().code(), "no-mass");
        assert_eq!(
            weighs(&model, MassRequest { model_kg: Some(70.0), ..MassRequest::default() }).unwrap(),
            70.0
        );
    }
}

#[test]
fn joints_in_bodies_count_once() {
    let body = |name: &str, joints: &str| {
        format!("<Body name='{name}'><mass>1</mass><Joint>{joints}</Joint></Body>")
    };
    let pin = |name: &str, parent: &str| {
        format!("<PinJoint name='{name}'><parent_body>{parent}</parent_body></PinJoint>")
    };
    let model = |bodies: &str| {
        let text = format!(
            "<OpenSimDocument Version='30000'><Model name='m'><BodySet><objects><Body name='ground'/>{bodies}</objects></BodySet>\
             </Model></OpenSimDocument>"
        );
        Model::parse(text).unwrap()
    };
    // OpenSim reads ab, and never ba2: no loop.
    let ignored = model(
        &(body("a", &pin("ground_a", "ground")) + &body("b", &(pin("ab", "a") + &pin("ground_b", "ground")))),
    );
    assert_eq!(finding_codes(&ignored), ["loop-of-joints"]);
    assert!(
        model_findings(&ignored)[0].message.to_string().contains("ground_b is not the first joint"),
        "{:?}",
        model_findings(&ignored)
    );
    // Each hangs on the other: OpenSim divides one of them.
    let circle = model(&(body("a", &pin("ba", "b")) + &body("b", &pin("ab", "a"))));
    assert_eq!(finding_codes(&circle), ["loop-of-joints"]);
    assert!(
        model_findings(&circle)[0].message.to_string().contains("(ba, ab)"),
        "{:?}",
        model_findings(&circle)
    );
}
