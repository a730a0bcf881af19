//! Verbs that change models in memory: the plan as table, JSON and diff, and the bytes of each file.

use osim_planning::prepare;
use serde_json::json;

use crate::front_end::{assert_same_change, assert_same_failure};
use crate::support::{HUMAN, TestDir, fixture};

#[test]
fn rescale_in_memory_equals_the_command() {
    let dir = TestDir::with_human();
    let json = json!({"verb": "rescale", "models": "human.osim", "target_mass": 500});
    assert_same_change(&dir, "rescale human.osim --target-mass 500", &json);
    // The note is removed, with a remark.
    assert_same_change(
        &dir,
        "rescale human.scaled.osim --target-mass 80 --only stiffness --no-note -o plain.osim",
        &json!({
            "verb": "rescale",
            "models": ["human.scaled.osim"],
            "target_mass": "80",
            "only": ["stiffness"],
            "no_note": true,
            "output": "plain.osim",
        }),
    );
}

#[test]
fn rescale_of_a_model_in_two_files_equals_the_command() {
    let dir = TestDir::new();
    let human = String::from_utf8(fixture(HUMAN.0)).unwrap();
    let (before, rest) = human.split_once("<BodySet").unwrap();
    let (bodies, after) = rest.split_once("</BodySet>").unwrap();
    dir.write("models/human.osim", format!("{before}<BodySet file=\"../parts/bodies.xml\" />{after}"));
    dir.write(
        "parts/bodies.xml",
        format!("<OpenSimDocument Version=\"40000\"><BodySet{bodies}</BodySet></OpenSimDocument>"),
    );
    let changed = assert_same_change(
        &dir,
        "rescale models/human.osim --target-mass 500",
        &json!({"verb": "rescale", "models": ["models/human.osim"], "target_mass": 500}),
    );
    assert_eq!(changed.opened.files().count(), 2);
}

#[test]
fn a_failure_of_included_contacts_equals_the_command() {
    let dir = TestDir::with(&[
        ("format/file_forceset.osim", "model.osim"),
        ("format/standalone_ForceSet.xml", "standalone_ForceSet.xml"),
    ]);
    let json = json!({"verb": "rescale", "models": ["model.osim", "absent.osim"], "target_mass": 500});
    assert_same_failure(&dir, "rescale model.osim absent.osim --target-mass 500", &json);
    assert_same_failure(
        &TestDir::with(&[("format/file_forceset.osim", "model.osim")]),
        "rescale model.osim --target-mass 500",
        &json!({"verb": "rescale", "models": "model.osim", "target_mass": 500}),
    );
}

#[test]
fn rescale_of_a_standalone_force_set_equals_the_command() {
    let dir = TestDir::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    let changed = assert_same_change(
        &dir,
        "rescale forces.xml --geometry geometry.xml --mass 61.5 --target-mass 80",
        &json!({
            "verb": "rescale",
            "models": "forces.xml",
            "geometry": "geometry.xml",
            "mass": 61.5,
            "target_mass": 80,
        }),
    );
    assert_eq!(changed.results.len(), 2);
}

#[test]
fn transfer_in_memory_equals_the_command() {
    let dir = TestDir::with(&[
        HUMAN,
        ("table1/mouse_smooth_sphere.osim", "mouse.osim"),
        ("presets/lab.toml", "lab.toml"),
    ]);
    for (words, fields) in [
        ("--from human.osim -o model.osim", json!({"from": "human.osim", "output": "model.osim"})),
        ("--from falisse2022 -o preset.osim", json!({"from": "falisse2022", "output": "preset.osim"})),
        (
            "--from heel_pad --presets lab.toml -o own.osim",
            json!({"from": "heel_pad", "presets": "lab.toml", "output": "own.osim"}),
        ),
    ] {
        let mut json = json!({"verb": "transfer", "models": ["mouse.osim"]});
        json.as_object_mut().unwrap().extend(fields.as_object().unwrap().clone());
        assert_same_change(&dir, &format!("transfer mouse.osim {words}"), &json);
    }
}

#[test]
fn transfer_with_followed_bodies_equals_the_command() {
    let dir = TestDir::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ]);
    assert_same_change(
        &dir,
        "transfer scaled.osim --from generic.osim --follow-bodies --body-scale-file applied.xml",
        &json!({
            "verb": "transfer",
            "models": "scaled.osim",
            "from": "generic.osim",
            "follow_bodies": true,
            "body_scale_file": "applied.xml",
        }),
    );
}

#[test]
fn design_of_a_model_equals_the_command() {
    let dir = TestDir::with_human();
    assert_same_change(
        &dir,
        "design human.osim --indentation 0.16 --restitution 0.8 --impact-speed 0.4",
        &json!({
            "verb": "design",
            "models": "human.osim",
            "indentation": 0.16,
            "restitution": 0.8,
            "impact_speed": 0.4,
        }),
    );
}

#[test]
fn set_in_memory_equals_the_command() {
    let dir = TestDir::with_human();
    assert_same_change(
        &dir,
        "set human.osim stiffness=x2 dissipation=1 --select *_r",
        &json!({
            "verb": "set",
            "models": "human.osim",
            "set": {"stiffness": "x2", "dissipation": 1},
            "select": ["*_r"],
        }),
    );
}

#[test]
fn add_in_memory_equals_the_command() {
    let dir = TestDir::with(&[
        ("feet/human_40000.osim", "human.osim"),
        ("feet/Geometry/r_human_foot.vtp", "bones/r_human_foot.vtp"),
        ("contact_tables/own.csv", "own.csv"),
        ("contact_tables/bad/no_number.csv", "bad.csv"),
    ]);
    assert_same_change(
        &dir,
        "add human.osim --contacts own.csv --from falisse2022 --class hunt-crossley",
        &json!({"verb": "add", "models": "human.osim", "contacts": "own.csv", "from": "falisse2022", "class": "hunt-crossley"}),
    );
    // The front end's reader opens the files beside the model.
    let words = "add human.osim --feet calcn_r,calcn_l --count 3 --pad 0.01 --geometry-dir bones --radius 0.03 --class smooth \
                 --indentation 0.2 --dynamic-friction 0.5 -o feet.osim";
    assert_same_change(
        &dir,
        words,
        &json!({
            "verb": "add",
            "models": ["human.osim"],
            "feet": ["calcn_r", "calcn_l"],
            "count": 3,
            "pad": 0.01,
            "geometry_dir": "bones",
            "radius": 0.03,
            "class": "smooth",
            "indentation": 0.2,
            "dynamic_friction": 0.5,
            "output": "feet.osim",
        }),
    );
    let json = json!({"verb": "add", "models": "human.osim", "contacts": "bad.csv", "from": "falisse2022"});
    let fault = prepare(crate::front_end::request_from_json(&json), &crate::front_end::files_in_memory(&dir))
        .err()
        .unwrap();
    let osim_requests::RequestError::Failure(failure) = fault else { panic!("{fault:?}") };
    assert_eq!((failure.code, failure.line, failure.column), ("table", Some(3), Some(4)));
}
