//! Verbs that change models: the plan as table, JSON and diff, and the bytes of each file.

use osim_planning::prepare;
use serde_json::json;

use crate::front_end::{same_change, same_failure};
use crate::support::{Bench, HUMAN, fixture};

#[test]
fn rescale() {
    let bench = Bench::human();
    let json = json!({"verb": "rescale", "models": "human.osim", "target_mass": 500});
    same_change(&bench, "rescale human.osim --target-mass 500", &json);
    // Its note goes, and that is said.
    same_change(
        &bench,
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
fn rescale_of_a_model_in_several_files() {
    let bench = Bench::new();
    let human = String::from_utf8(fixture(HUMAN.0)).unwrap();
    let (before, rest) = human.split_once("<BodySet").unwrap();
    let (bodies, after) = rest.split_once("</BodySet>").unwrap();
    bench.write("models/human.osim", format!("{before}<BodySet file=\"../parts/bodies.xml\" />{after}"));
    bench.write(
        "parts/bodies.xml",
        format!("<OpenSimDocument Version=\"40000\"><BodySet{bodies}</BodySet></OpenSimDocument>"),
    );
    let changed = same_change(
        &bench,
        "rescale models/human.osim --target-mass 500",
        &json!({"verb": "rescale", "models": ["models/human.osim"], "target_mass": 500}),
    );
    assert_eq!(changed.opened.files().count(), 2);
}

#[test]
fn contacts_in_an_included_file() {
    let bench = Bench::with(&[
        ("format/file_forceset.osim", "model.osim"),
        ("format/standalone_ForceSet.xml", "standalone_ForceSet.xml"),
    ]);
    let json = json!({"verb": "rescale", "models": ["model.osim", "absent.osim"], "target_mass": 500});
    same_failure(&bench, "rescale model.osim absent.osim --target-mass 500", &json);
    same_failure(
        &Bench::with(&[("format/file_forceset.osim", "model.osim")]),
        "rescale model.osim --target-mass 500",
        &json!({"verb": "rescale", "models": "model.osim", "target_mass": 500}),
    );
}

#[test]
fn a_standalone_force_set_with_its_geometry() {
    let bench = Bench::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    let changed = same_change(
        &bench,
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
fn transfer() {
    let bench = Bench::with(&[
        HUMAN,
        ("table1/mouse_smooth_sphere.osim", "mouse.osim"),
        ("presets/lab.toml", "lab.toml"),
    ]);
    for (words, more) in [
        ("--from human.osim -o model.osim", json!({"from": "human.osim", "output": "model.osim"})),
        ("--from falisse2022 -o preset.osim", json!({"from": "falisse2022", "output": "preset.osim"})),
        (
            "--from heel_pad --presets lab.toml -o own.osim",
            json!({"from": "heel_pad", "presets": "lab.toml", "output": "own.osim"}),
        ),
    ] {
        let mut json = json!({"verb": "transfer", "models": ["mouse.osim"]});
        json.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        same_change(&bench, &format!("transfer mouse.osim {words}"), &json);
    }
}

#[test]
fn transfer_with_spheres_that_follow_their_bodies() {
    let bench = Bench::with(&[
        ("scale_tool/generic_smooth.osim", "generic.osim"),
        ("scale_tool/scaled_smooth.osim", "scaled.osim"),
        ("scale_tool/applied_scale_set.xml", "applied.xml"),
    ]);
    same_change(
        &bench,
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
fn design() {
    let bench = Bench::human();
    same_change(
        &bench,
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
fn set() {
    let bench = Bench::human();
    same_change(
        &bench,
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
fn contacts_at_places_of_the_models_own() {
    let bench = Bench::with(&[
        ("feet/human_40000.osim", "human.osim"),
        ("feet/Geometry/r_human_foot.vtp", "bones/r_human_foot.vtp"),
        ("contact_tables/own.csv", "own.csv"),
        ("contact_tables/bad/no_number.csv", "bad.csv"),
    ]);
    same_change(
        &bench,
        "add human.osim --contacts own.csv --from falisse2022 --class hunt-crossley",
        &json!({"verb": "add", "models": "human.osim", "contacts": "own.csv", "from": "falisse2022", "class": "hunt-crossley"}),
    );
    // Files beside the model are read through what the front end brings.
    let words = "add human.osim --feet calcn_r,calcn_l --count 3 --pad 0.01 --geometry-dir bones --radius 0.03 --class smooth \
                 --indentation 0.2 --dynamic-friction 0.5 --output feet.osim";
    same_change(
        &bench,
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
    let fault = prepare(crate::front_end::read(&json), &crate::front_end::files_of(&bench)).err().unwrap();
    let osim_requests::RequestError::Failure(failure) = fault else { panic!("{fault:?}") };
    assert_eq!((failure.code, failure.line, failure.column), ("table", Some(3), Some(4)));
}
