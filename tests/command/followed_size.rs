//! What else of a model follows its size: listed, never changed.

use serde_json::Value;

use crate::html::Html;
use crate::support::Bench;

const FILES: &[(&str, &str)] = &[
    ("follows_size/generic.osim", "generic.osim"),
    ("follows_size/scaled.osim", "scaled.osim"),
    ("follows_size/generic.omoco", "generic.omoco"),
    ("follows_size/scaled.omoco", "scaled.omoco"),
];

const ALL: &str =
    "check scaled.osim --from generic.osim --moco-setup scaled.omoco --from-moco-setup generic.omoco";

fn listed(bench: &Bench, call: &str) -> Value {
    let found: Value = serde_json::from_str(&bench.run(&format!("{call} --format json")).out()).unwrap();
    found["similarity"].clone()
}

fn kind<'v>(list: &'v Value, name: &str) -> &'v Value {
    list["kinds"].as_array().unwrap().iter().find(|row| row["kind"] == name).unwrap()
}

/// The child has 20 of 62 kg. Bounds are those that `make_follows_size.py` writes: 0.5 / 0.75 and 0.8 / 1.25, 1.6 / 2, the same.
#[test]
fn each_kind_has_its_factor_and_a_verdict() {
    let bench = Bench::with(FILES);
    let before = bench.text("scaled.osim");
    let list = listed(&bench, ALL);
    assert!((list["mass_ratio"].as_f64().unwrap() - 20.0 / 62.0).abs() < 1e-12);
    let verdicts = [
        ("max_isometric_force", "left"),
        ("optimal_fiber_length", "follows"),
        ("activation_time_constant", "left"),
        ("actuator_torque", "follows"),
        ("bushing_rotational_damping", "left"),
        ("moco_time", "left"),
        ("moco_translation", "follows"),
        ("moco_speed", "follows"),
        ("moco_angular_speed", "left"),
    ];
    for (name, verdict) in verdicts {
        assert_eq!(kind(&list, name)["verdict"], verdict, "{name}");
    }
    let speed = &kind(&list, "moco_speed")["factor"];
    assert!((speed["median"].as_f64().unwrap() - 1.6 / 2.0).abs() < 1e-12, "{speed}");
    let unread: Vec<&str> =
        list["not_read"].as_array().unwrap().iter().map(|one| one["class"].as_str().unwrap()).collect();
    assert_eq!(unread, ["ExpressionBasedBushingForce", "state_infos_pattern"]);
    assert_eq!(bench.text("scaled.osim"), before);
}

#[test]
fn the_list_is_a_line_a_kind() {
    let bench = Bench::with(FILES);
    for call in [ALL, "inspect generic.osim --target-mass 20"] {
        let text = bench.run(call).out();
        let (_, list) = text.split_once("What else follows size:\n").unwrap();
        assert!(list.lines().all(|line| line.chars().count() <= 80), "{list}");
    }
    let text = bench.run(ALL).out();
    let (_, list) = text.split_once("What else follows size:\n").unwrap();
    assert!(
        list.contains("one choice among several") || list.contains("one\n    choice among several"),
        "{list}"
    );
    let row = list.lines().find(|line| line.starts_with(" max isometric force")).unwrap();
    let words: Vec<&str> = row.split_ascii_whitespace().collect();
    assert_eq!(words, ["max", "isometric", "force", "4", "same", "0.323", "left"]);
}

#[test]
fn a_mass_alone_and_a_setup_alone() {
    let bench = Bench::with(FILES);
    // M = 1/2 of 62 kg: forces 0.5, lengths 0.5^(1/3) = 0.7937, times 0.5^(1/6) = 0.8909.
    let list = listed(&bench, "inspect generic.osim --target-mass 31");
    for (name, factor) in
        [("max_isometric_force", 0.5), ("optimal_fiber_length", 0.7937), ("activation_time_constant", 0.8909)]
    {
        let row = kind(&list, name);
        assert!((row["similarity_factor"].as_f64().unwrap() - factor).abs() < 1e-4, "{row}");
        assert!(row["verdict"].is_null() && row["factor"].is_null(), "{row}");
    }
    let list = listed(&bench, "check scaled.osim --from generic.osim --moco-setup scaled.omoco");
    assert_eq!(kind(&list, "moco_time")["verdict"], "not-compared");
    assert!(list["only_in_model"].as_array().unwrap().is_empty(), "{list}");
    assert!(listed(&bench, "check scaled.osim").is_null());
}

#[test]
fn a_setup_needs_the_original_and_a_problem() {
    let bench = Bench::with(FILES);
    bench.run("check scaled.osim --moco-setup scaled.omoco").usage();
    bench.run("check scaled.osim --from generic.osim --from-moco-setup scaled.omoco").usage();
    let none = "check scaled.osim --from generic.osim --moco-setup generic.osim";
    bench.run(none).failed().says(&["generic.osim", "holds a Model, expected a MocoStudy"]);
}

#[test]
fn the_report_has_the_list() {
    let bench = Bench::with(FILES);
    bench.run(&format!("{ALL} --report page.html"));
    let page = Html::sound(&bench.text("page.html"));
    assert!(page.text.contains("What else follows size"), "{}", page.text);
    assert!(page.text.contains("optimal fiber length"), "{}", page.text);
}
