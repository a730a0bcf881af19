//! The list of quantities of a model that change with its size but that no verb changes.

use serde_json::Value;

use crate::html::Html;
use crate::support::TestDir;

const MODELS_TO_COMPARE: &[(&str, &str)] = &[
    ("follows_size/generic.osim", "generic.osim"),
    ("follows_size/scaled.osim", "scaled.osim"),
    ("follows_size/generic.omoco", "generic.omoco"),
    ("follows_size/scaled.omoco", "scaled.omoco"),
];

const CALL_FOR_ALL_ROWS: &str =
    "check scaled.osim --from generic.osim --moco-setup scaled.omoco --from-moco-setup generic.omoco";

fn similarity_of(dir: &TestDir, call: &str) -> Value {
    let check: Value = serde_json::from_str(&dir.run(&format!("{call} --format json")).out()).unwrap();
    check["similarity"].clone()
}

fn kind_row<'v>(list: &'v Value, name: &str) -> &'v Value {
    list["kinds"].as_array().unwrap().iter().find(|row| row["kind"] == name).unwrap()
}

/// The child has 20 kg and the original adult 62 kg. The bounds are from `make_follows_size.py`.
#[test]
fn each_kind_of_quantity_has_a_factor_and_a_verdict() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    let before = dir.text("scaled.osim");
    let list = similarity_of(&dir, CALL_FOR_ALL_ROWS);
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
        assert_eq!(kind_row(&list, name)["verdict"], verdict, "{name}");
    }
    let speed = &kind_row(&list, "moco_speed")["factor"];
    assert!((speed["median"].as_f64().unwrap() - 1.6 / 2.0).abs() < 1e-12, "{speed}");
    let unread: Vec<&str> =
        list["not_read"].as_array().unwrap().iter().map(|one| one["class"].as_str().unwrap()).collect();
    assert_eq!(unread, ["ExpressionBasedBushingForce", "state_infos_pattern"]);
    assert_eq!(dir.text("scaled.osim"), before);
}

/// Where the forms of (14) part, a transfer says the third, too: 2 s/m over the root of the ratio of lengths, 0.643 (see docs/scaling.md).
#[test]
fn a_transfer_has_the_dissipation_by_leg_length() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    let said = dir
        .run("transfer scaled.osim --from generic.osim --follow-bodies --radius keep --dry-run --format json")
        .out();
    let by_legs = said.split(" s/m by length of bones keeps it at speeds").next().unwrap();
    let by_legs = by_legs.rsplit(' ').next().unwrap();
    assert!((by_legs.parse::<f64>().unwrap() - 2.0 / 0.643_f64.sqrt()).abs() < 2e-3, "{said}");
}

#[test]
fn the_list_has_one_line_for_each_kind() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    for call in [CALL_FOR_ALL_ROWS, "inspect generic.osim --target-mass 20"] {
        let text = dir.run(call).out();
        let (_, list) = text.split_once("What else follows size:\n").unwrap();
        assert!(list.lines().all(|line| line.chars().count() <= 80), "{list}");
    }
    let text = dir.run(CALL_FOR_ALL_ROWS).out();
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
fn a_mass_or_a_setup_alone_gives_factors_without_verdicts() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    // M = 1/2 of 62 kg: forces 0.5, lengths 0.5^(1/3) = 0.7937, times 0.5^(1/6) = 0.8909.
    let list = similarity_of(&dir, "inspect generic.osim --target-mass 31");
    for (name, factor) in
        [("max_isometric_force", 0.5), ("optimal_fiber_length", 0.7937), ("activation_time_constant", 0.8909)]
    {
        let row = kind_row(&list, name);
        assert!((row["similarity_factor"].as_f64().unwrap() - factor).abs() < 1e-4, "{row}");
        assert!(row["verdict"].is_null() && row["factor"].is_null(), "{row}");
    }
    let list = similarity_of(&dir, "check scaled.osim --from generic.osim --moco-setup scaled.omoco");
    assert_eq!(kind_row(&list, "moco_time")["verdict"], "not-compared");
    assert!(list["only_in_model"].as_array().unwrap().is_empty(), "{list}");
    assert!(similarity_of(&dir, "check scaled.osim").is_null());
}

#[test]
fn a_setup_needs_the_original_and_a_problem() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    dir.run("check scaled.osim --moco-setup scaled.omoco").usage_error();
    dir.run("check scaled.osim --from generic.osim --from-moco-setup scaled.omoco").usage_error();
    let wrong_setup_call = "check scaled.osim --from generic.osim --moco-setup generic.osim";
    dir.run(wrong_setup_call).failed().says(&["generic.osim", "holds a Model, expected a MocoStudy"]);
}

#[test]
fn the_report_page_shows_the_list() {
    let dir = TestDir::with(MODELS_TO_COMPARE);
    dir.run(&format!("{CALL_FOR_ALL_ROWS} --report page.html"));
    let page = Html::parse_and_check(&dir.text("page.html"));
    assert!(page.text.contains("What else follows size"), "{}", page.text);
    assert!(page.text.contains("optimal fiber length"), "{}", page.text);
}
