//! The properties of each figure apart from its value: its limit, its name in JSON, its heading in a table.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    unreachable_pub,
    reason = "a test fails by panicking"
)]

use crate::feet::{HEEL, SmoothContact, TOE, foot};
use osim_inspect::{Figure, Figures, InspectOptions, LimitCheck, SphereFigures};
use osim_model::Model;

/// A model with two feet whose names do not say which one is the left foot.
const FEET_WITHOUT_SIDES: &str = include_str!("../../../../fixtures/format/no_sides.osim");

fn figures_of_text(text: &str) -> Figures {
    let model = Model::parse(text).unwrap();
    InspectOptions::default().inspect("model.osim", &model, None).figures
}

/// The figures of the first sphere.
fn first_sphere(figures: &Figures) -> &SphereFigures {
    figures.spheres().next().unwrap()
}

fn check_of_figure(checks: &[LimitCheck], figure: Figure) -> &LimitCheck {
    checks.iter().find(|check| check.figure == figure.info().name).unwrap()
}

#[test]
fn each_limit_is_compared_with_its_figure() {
    let figures = figures_of_text(&foot(&[HEEL, TOE]));
    let checks: Vec<LimitCheck> = first_sphere(&figures).limits().collect();
    let limited: Vec<&str> = checks.iter().map(|check| check.figure).collect();
    let indentations = Figure::ALL.iter().map(|figure| figure.info().name);
    // Depths at the default pose say as much about the pose as about the contacts.
    let contacts = |name: &&str| name.starts_with("relative_indentation") && !name.ends_with("_standing");
    let indentations = indentations.filter(contacts);
    let others = ["restitution_approximate", "constant_indentation", "transition_width", "touching_share"];
    assert_eq!(limited, indentations.chain(others).collect::<Vec<_>>());
    for (figure, limit, within) in [
        (Figure::Indentation, 0.16, false),
        (Figure::RestitutionApproximate, 0.8, true),
        (Figure::ConstantIndentation, 0.1, true),
        (Figure::TransitionWidth, 0.31, true),
        (Figure::TouchingShare, 0.1, false),
    ] {
        let check = check_of_figure(&checks, figure);
        assert_eq!((check.limit, check.within_limit), (limit, within), "{figure:?}");
        assert_eq!(check.value, first_sphere(&figures).value(figure));
    }
    assert_eq!(first_sphere(&figures).is_within(Figure::Load), None, "it has no limit");
}

#[test]
fn a_restitution_below_0_is_beyond_its_limit_and_has_no_value() {
    // 1 − 2.25 · 0.454 is −0.02 by (13).
    let figures = figures_of_text(&foot(&[SmoothContact { dissipation: 2.25, ..HEEL }, TOE]));
    let checks: Vec<LimitCheck> = first_sphere(&figures).limits().collect();
    let check = check_of_figure(&checks, Figure::RestitutionApproximate);
    assert_eq!((check.value, check.within_limit), (None, false));
    assert!(first_sphere(&figures).value(Figure::RestitutionExact).unwrap() > 0.0);
}

#[test]
fn a_figure_without_a_value_is_not_compared_with_its_limit() {
    let figures = figures_of_text(FEET_WITHOUT_SIDES);
    let limited: Vec<&str> = first_sphere(&figures).limits().map(|check| check.figure).collect();
    assert_eq!(limited, ["restitution_approximate", "constant_indentation", "transition_width"]);
}

#[test]
fn the_schema_of_a_sphere_lists_exactly_what_is_serialised() {
    let schema = schemars::schema_for!(SphereFigures);
    assert_eq!(schema.get("title"), Some(&"SphereFigures".into()));
    let properties = schema.get("properties").and_then(|all| all.as_object()).unwrap();
    let figures = Figure::ALL.iter().map(|figure| figure.info().name);
    let expected: Vec<&str> =
        ["sphere", "path", "forces"].into_iter().chain(figures).chain(["limits"]).collect();
    assert_eq!(properties.keys().collect::<Vec<_>>(), expected);
    let required = schema.get("required").and_then(|all| all.as_array()).unwrap();
    assert_eq!(required.iter().map(|name| name.as_str().unwrap()).collect::<Vec<_>>(), expected);
    let inspected = figures_of_text(&foot(&[HEEL, TOE]));
    let serialised = serde_json::to_value(first_sphere(&inspected)).unwrap();
    let serialised = serialised.as_object().unwrap();
    assert_eq!(serialised.keys().collect::<Vec<_>>(), expected);
    assert_eq!(schema.get("additionalProperties"), Some(&false.into()));
}

#[test]
fn a_schema_has_meaning_equation_and_unit_of_each_figure() {
    let schema = schemars::schema_for!(SphereFigures);
    let described =
        |figure: Figure| schema.get("properties").unwrap()[figure.info().name]["description"].clone();
    for (figure, text) in [
        (Figure::Radius, "Radius R of the sphere, m."),
        (Figure::MeanContactStress, "Mean contact stress σ under one body weight (15), N/m2."),
        (Figure::Indentation, "x̂ under its share of one body weight, by the Hertz law (11)."),
        (
            Figure::TouchingShare,
            "Force at rest while the sphere just touches, over its share of one body weight.",
        ),
    ] {
        assert_eq!(described(figure), text);
    }
}

#[test]
fn a_heading_in_a_table_has_unit_and_equation_of_the_figure() {
    let heading = |figure: Figure| figure.info().heading();
    assert_eq!(heading(Figure::Radius), "radius, m");
    assert_eq!(heading(Figure::MeanContactStress), "mean stress, N/m2 (15)");
    assert_eq!(heading(Figure::Indentation), "x/R at 1 BW, Hertz (11)");
    assert_eq!(heading(Figure::RestitutionExact), "restitution, exact");
    assert_eq!(Figure::Radius.info().meaning().to_string(), "Radius R of the sphere.");
}

#[test]
fn a_sphere_is_serialised_with_its_numbers_and_limits() {
    let figures = figures_of_text(FEET_WITHOUT_SIDES);
    let json = serde_json::to_value(first_sphere(&figures)).unwrap();
    assert_eq!(json["sphere"], "heel_a");
    assert_eq!(json["path"], "/contactgeometryset/heel_a");
    assert_eq!(json["forces"], serde_json::json!(["contact_heel_a"]));
    assert_eq!(json["radius_m"], 0.0325);
    assert!(json["load_n"].is_null());
    assert_eq!(json["limits"].as_array().map(Vec::len), Some(3));
    assert!(
        serde_json::to_value(&figures).unwrap()["why_no_body_weight"].as_str().unwrap().contains("spheres")
    );
}
