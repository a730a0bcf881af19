//! Tests the curves, labels and values in figures.

use crate::document::{Scale, Svg};
use crate::support::{HUMAN, TestDir};

const COLOUR_OF_HERTZ: &str = "#0072B2";
const COLOUR_OF_MODEL_LAW: &str = "#222222";
const COLOUR_OF_MOUSE: &str = "#0072B2";
const COLOUR_OF_GIRAFFE: &str = "#D55E00";

/// The SVG that `plot` draws with these arguments.
#[track_caller]
fn plot_svg(dir: &TestDir, arguments: &str) -> Svg {
    dir.run(&format!("plot {arguments} -o figure.svg --force")).succeeded().wrote(&["figure.svg"]);
    Svg::read(&dir.text("figure.svg"))
}

/// The value of a curve at `at`, interpolated between the two nearest points.
#[track_caller]
fn value_at(curve: &[(f64, f64)], (x, y): (&Scale, &Scale), at: f64) -> f64 {
    let points: Vec<(f64, f64)> = curve.iter().map(|(px, py)| (x.value(*px), y.value(*py))).collect();
    let within = points.windows(2).find(|pair| pair[0].0 <= at && at <= pair[1].0);
    // A dotted line may end with a gap, of less than a fiftieth of the figure.
    let last = points.windows(2).next_back().filter(|pair| at > pair[1].0 && at - pair[1].0 < 0.02);
    let pair = within.or(last);
    let [from, to] = *pair.unwrap_or_else(|| panic!("no point at {at}")) else { unreachable!() };
    if to.0 == from.0 { to.1 } else { from.1 + (to.1 - from.1) * (at - from.0) / (to.0 - from.0) }
}

/// The distance from a point to a curve, in drawing units.
fn distance_to_curve((px, py): (f64, f64), curve: &[(f64, f64)]) -> f64 {
    let to_segment = |pair: &[(f64, f64)]| {
        let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
        let length = (bx - ax).powi(2) + (by - ay).powi(2);
        let along =
            if length == 0.0 { 0.0 } else { ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length };
        let along = along.clamp(0.0, 1.0);
        (px - ax - along * (bx - ax)).hypot(py - ay - along * (by - ay))
    };
    curve.windows(2).map(to_segment).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_preset_shows_its_three_laws() {
    let svg = plot_svg(&TestDir::new(), "force falisse2022");
    svg.says(&[
        "Contact force: falisse2022",
        "Hertz (1)",
        "Hertz with cf (C.1)",
        "smoothed, at rest (C.9)",
        "x̂ = 0.16",
    ]);
    let axes = (&svg.scale_of_x(), &svg.scale_of_y());
    let assert_near =
        |value: f64, expected: f64| assert!((value - expected).abs() < 0.4, "{value}, expected {expected}");
    assert_near(value_at(svg.curves(COLOUR_OF_HERTZ)[0], axes, 0.4999), 170.667);
    let model_law = svg.curves(COLOUR_OF_MODEL_LAW)[0];
    assert_near(value_at(model_law, axes, 0.4999), 175.631);
    assert_near(value_at(model_law, axes, 0.0), 7.498);
    assert_near(value_at(svg.curves("#D55E00")[0], axes, 0.0), 14.996);
    // Far above the ground nothing pushes.
    assert_near(value_at(model_law, axes, -0.49), 0.0);
}

#[test]
fn several_bodies_are_drawn_relative_to_their_weight() {
    let dir = TestDir::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")]);
    let svg = plot_svg(&dir, "force human.osim mouse.osim --stance-limbs 1");
    svg.says(&["human", "mouse", "force of one sphere / its share Mg/n (–)"]);
}

#[test]
fn scaled_contacts_have_the_same_dimensionless_curve() {
    let svg = plot_svg(&TestDir::new(), "force falisse2022 --target-mass 1190");
    svg.says(&["falisse2022", "falisse2022, scaled to 1190 kg"]);
    let axes = (&svg.scale_of_x(), &svg.scale_of_y());
    let (before, after) = (svg.curves(COLOUR_OF_MOUSE)[0], svg.curves(COLOUR_OF_GIRAFFE)[0]);
    for at in [-0.2, 0.0, 0.1, 0.3, 0.45] {
        // The picture has points of the dashed curve only at the ends of its dashes, some 0.02 apart.
        let (first, second) = (value_at(before, axes, at), value_at(after, axes, at));
        assert!((first - second).abs() < 6e-3, "{at}: {first}, {second}");
    }
    // At rest each carries its share: falisse2022 rests at 0.33948.
    assert!((value_at(before, axes, 0.339_48) - 1.0).abs() < 4e-3);
    // With their dimensions they are far apart: 32 mm and 85.7 mm.
    let dimensional = plot_svg(&TestDir::new(), "force falisse2022 --target-mass 1190 --axes real");
    dimensional.says(&["indentation x (mm)", "force of one sphere (N)", "−40", "40"]);
}

#[test]
fn different_spheres_have_a_curve_each() {
    let dir = TestDir::with(&[("format/unequal_radii.osim", "unequal.osim")]);
    let svg = plot_svg(&dir, "force unequal.osim --spheres 2");
    // The title says whose they are.
    svg.says(&["heel_r, toe_r", "heel_l, toe_l"]);
}

#[test]
fn fig_c5_shows_what_default_smoothing_does_to_small_spheres() {
    let svg = plot_svg(&TestDir::new(), "fig-c5");
    svg.says(&[
        "A",
        "B",
        "C",
        "D",
        "default cf, bd",
        "scaled cf, bd",
        "state 0.05",
        "state 0.95",
        "x̂ = 0.16",
    ]);
    assert_eq!(svg.attribute("width"), "190mm");
    // All four panels have the same width; the force panels the same scale, from the Hertz curve: 0 to 62.431 N.
    let hertz = svg.curves(COLOUR_OF_HERTZ);
    let model_law = svg.curves(COLOUR_OF_MODEL_LAW);
    assert_eq!((hertz.len(), model_law.len()), (2, 4));
    let force = |panel: usize, at: f64| {
        let curve = hertz[panel];
        let (first, last) = (curve[0], curve[curve.len() - 1]);
        let x = Scale { from: (first.0, -0.5), to: (last.0, 0.5) };
        let y = Scale { from: (first.1, 0.0), to: (last.1, 62.430_97) };
        value_at(model_law[panel], (&x, &y), at)
    };
    let assert_near =
        |value: f64, expected: f64| assert!((value - expected).abs() < 0.15, "{value}, expected {expected}");
    assert_near(force(0, 0.0), 8.546_3);
    assert_near(force(0, 0.499_9), 69.807_1);
    assert_near(force(1, 0.0), 2.742_8);
    // Thresholds of the state, at 0.32716 and 0.15336 (C.6): on the axis of their panel.
    for (column, at) in [(0, 0.327_16), (1, 0.153_36)] {
        // The panel above has the same axis, and a curve without gaps at its ends.
        let curve = hertz[column];
        let x = Scale { from: (curve[0].0, -0.5), to: (curve[curve.len() - 1].0, 0.5) };
        let value = x.value(svg.places_of("state 0.95")[column].0);
        assert!((value - at).abs() < 3e-4, "{value}, expected {at}");
    }
}

#[test]
fn fig_4_shows_the_mouse_bouncing_until_its_dissipation_is_scaled() {
    let svg = plot_svg(&TestDir::new(), "fig4");
    svg.says(&[
        "mouse",
        "giraffe",
        "body weight",
        "time t (s)",
        "non-dimensional time t/√(R/g) (–)",
        "α = 2 s/m for both",
    ]);
    let (mouse, giraffe) = (svg.curves(COLOUR_OF_MOUSE), svg.curves(COLOUR_OF_GIRAFFE));
    assert_eq!((mouse.len(), giraffe.len()), (4, 4));
    // A falling body weighs 0, and at the end it rests at 1: the scale of each panel.
    let y = |panel: usize| {
        let curve = mouse[panel];
        Scale { from: (curve[0].1, 0.0), to: (curve[curve.len() - 1].1, 1.0) }
    };
    let top = |panel: usize, curve: &[(f64, f64)]| {
        curve.iter().map(|point| y(panel).value(point.1)).fold(0.0_f64, f64::max)
    };
    let assert_near =
        |value: f64, expected: f64| assert!((value - expected).abs() < 0.01, "{value}, expected {expected}");
    assert_near(top(0, mouse[0]), 2.8396);
    assert_near(top(1, mouse[1]), 2.6487);
    // The giraffe's (2.6490 and 2.6487) may lie in the gap between two dashes.
    for panel in [0, 1] {
        let value = top(panel, giraffe[panel]);
        assert!((2.61..2.66).contains(&value), "{value}");
    }
    // A: the mouse's second peak, 1.8558 at 0.067973 s, which scaling takes away (1.0536).
    let x = |panel: usize| {
        let curve = mouse[panel];
        Scale { from: (curve[0].0, 0.0), to: (curve[curve.len() - 1].0, 0.5) }
    };
    assert_near(value_at(mouse[0], (&x(0), &y(0)), 0.067_973), 1.8558);
    assert_near(value_at(mouse[1], (&x(1), &y(1)), 0.067_499), 1.0536);
    assert_near(value_at(mouse[0], (&x(0), &y(0)), 0.047_750), 0.1397);
    // D: in non-dimensional time both are one curve, within two drawing units (a tenth of a point); C: they are not.
    let apart = |panel: usize| {
        let distances = giraffe[panel].iter().map(|point| distance_to_curve(*point, mouse[panel]));
        distances.fold(0.0_f64, f64::max)
    };
    assert!(apart(3) <= 2.0, "{}", apart(3));
    assert!(apart(2) > 100.0, "{}", apart(2));
}

#[test]
fn drops_states_and_loops_name_their_axes() {
    let dir = TestDir::with(&[HUMAN]);
    plot_svg(&dir, "drop human.osim").says(&["Drop test: human", "time t (s)", "body weight"]);
    plot_svg(&dir, "state human.osim").says(&["contact state (–)", "smoothed (C.4)", "state 0.05"]);
    let svg = plot_svg(&dir, "loop falisse2022");
    // √(gR/2) = 0.39611 m/s; theory.md: the exact restitution at α ẋ⁻ = 0.792 is 0.550.
    svg.says(&["0.396 m/s, restitution 0.55", "force at rest"]);
}

#[test]
fn a_heat_map_shows_its_quantity_over_stiffness_and_dissipation() {
    let dir = TestDir::new();
    let grid = "--stiffness x0.1..x10/7 --dissipation x0.1..x4/6";
    let svg = plot_svg(&dir, &format!("sweep falisse2022 --quantity peak-force {grid}"));
    svg.says(&[
        "peak force / body weight (–)",
        "stiffness E₁* (N/m²)",
        "dissipation α (s/m)",
        "10⁵",
        "10⁶",
        "10⁷",
        "falisse2022 now",
    ]);
    assert!(svg.fills.len() > 6, "{:?}", svg.fills);
}

#[test]
fn a_sweep_of_one_parameter_is_a_curve() {
    let dir = TestDir::new();
    let svg = plot_svg(&dir, "sweep falisse2022 --quantity restitution");
    svg.says(&["coefficient of restitution (–)", "dissipation α (s/m)", "falisse2022 now"]);
    assert!(svg.fills.iter().all(|fill| fill == "#FFFFFF"), "no cells: {:?}", svg.fills);
    let svg = plot_svg(&dir, "sweep falisse2022 --quantity indentation");
    svg.says(&["x̂ under body weight, Hertz (–)", "stiffness E₁* (N/m²)", "x̂ = 0.16, limit of the Hertz law"]);
    assert!(!svg.texts.iter().any(|text| text.contains("dissipation")), "{:?}", svg.texts);
}

#[test]
fn a_model_whose_weight_is_unknown_is_drawn_in_newtons() {
    let dir = TestDir::with(&[("format/no_gravity.osim", "weightless.osim")]);
    let run = dir.run("plot force weightless.osim -o figure.svg").succeeded();
    run.says(&["its share of the weight is not drawn", "--gravity G"]);
    dir.run("plot drop weightless.osim -o drop.svg").failed().wrote_nothing().says(&["--gravity G"]);
}
