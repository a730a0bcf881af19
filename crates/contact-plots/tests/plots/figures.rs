//! Tests of figures as SVG documents: they are valid XML, have texts for their content, and have points at the right places.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::document::Svg;
use contact_plots::{
    Area, Axis, Curve, Drawing, Figure, HeatLimit, HeatMap, Limit, Look, Mark, Panel, Paper, PlotError,
    Point, Width,
};

fn points_on_line(slope: f64) -> Vec<Point> {
    (-10..=10).map(|i| f64::from(i) / 20.0).map(|x| (x, slope * (x + 0.5))).collect()
}

/// A figure of straight lines with the given names and slopes, with a limit, a shade and a mark.
fn force_figure(lines: &[(&str, f64)]) -> Figure {
    let mut panel = Panel::new("", Axis::new("x̂ = x/R (–)"), Axis::new("force (N)"));
    let curve = |(index, (name, slope)): (usize, &(&str, f64))| {
        Curve::new(*name, points_on_line(*slope), Look::series(index))
    };
    panel.curves = lines.iter().enumerate().map(curve).collect();
    panel.limits.push(Limit::vertical("x̂ = 0.16", 0.16));
    panel.areas.push(Area { label: "shade".to_owned(), points: points_on_line(1.0) });
    panel.marks.push(Mark { label: "at rest".to_owned(), at: (0.35, 1.0), look: Look::OWN });
    Figure::in_column("Contact force", "Force against indentation.".to_owned(), vec![panel])
}

fn heat_map_of_two_parameters() -> HeatMap {
    let values = (0..4).map(|row| (0..5).map(|column| Some(f64::from(row * 5 + column))).collect()).collect();
    HeatMap {
        title: "Peak force".to_owned(),
        description: "Peak force over two parameters.".to_owned(),
        x_axis: Axis::logarithmic("E₁* (N/m²)"),
        x: vec![1e5, 3e5, 1e6, 3e6, 1e7],
        y_axis: Axis::logarithmic("α (s/m)"),
        y: vec![0.1, 0.3, 1.0, 3.0],
        values,
        value_axis: Axis::new("peak force / body weight (–)"),
        limit: Some(HeatLimit { label: "limit".to_owned(), at: 7.5 }),
        mark: Some(("the model".to_owned(), (1e6, 1.0))),
    }
}

/// The SVG of a figure in its default width.
fn svg_of(figure: Figure) -> Result<String, PlotError> {
    Drawing::Panels(figure).svg(Paper::default())
}

fn force_svg(lines: &[(&str, f64)]) -> String {
    svg_of(force_figure(lines)).unwrap()
}

#[test]
fn a_panel_has_texts_for_its_axes_and_elements() {
    let svg = Svg::read(&force_svg(&[("mouse", 1.0), ("horse", 2.0)]));
    svg.says(&[
        "Contact force",
        "x̂ = x/R (–)",
        "force (N)",
        "mouse",
        "horse",
        "shade",
        "x̂ = 0.16",
        "at rest",
    ]);
    assert_eq!(svg.description, "Force against indentation.");
    let panel = force_figure(&[("mouse", 1.0)]).panels.remove(0);
    let two = Figure::in_column("Two", "Twice the force.".into(), vec![panel.clone(), panel]);
    Svg::read(&svg_of(two).unwrap()).says(&["A", "B"]);
}

#[test]
fn points_are_at_the_values_of_the_ticks() {
    let svg = Svg::read(&force_svg(&[("human", 100.0)]));
    let (x, y) = (svg.scale_of_x(), svg.scale_of_y());
    // The first curve is the solid one: from (−0.5, 0) to (0.5, 100).
    let curve = svg.longest_line("#0072B2");
    assert_eq!(curve.len(), 21);
    for (index, (px, py)) in curve.iter().enumerate() {
        let expected = f64::from(u32::try_from(index).unwrap()) / 20.0;
        // Half a drawing unit in the position, as much in each of the two ticks.
        assert!((x.value(*px) - (expected - 0.5)).abs() < 3e-4, "{index}: {}", x.value(*px));
        assert!((y.value(*py) - 100.0 * expected).abs() < 0.12, "{index}: {}", y.value(*py));
    }
}

#[test]
fn a_heat_map_has_decades_and_a_named_bar() {
    let svg = Svg::read(&contact_plots::heat_map(&heat_map_of_two_parameters(), Paper::default()).unwrap());
    svg.says(&[
        "E₁* (N/m²)",
        "α (s/m)",
        "10⁵",
        "10⁶",
        "10⁷",
        "0.1",
        "1",
        "peak force / body weight (–)",
        "limit",
        "the model",
    ]);
    // 20 cells and the bar's slices, of many colours.
    assert!(svg.fills.len() > 30, "{}", svg.fills.len());
    let mut gap = heat_map_of_two_parameters();
    gap.values[1][2] = None;
    Svg::read(&contact_plots::heat_map(&gap, Paper::default()).unwrap()).says(&["no value"]);
}

#[test]
fn several_figures_in_one_page_have_no_common_ids() {
    for svg in [
        force_svg(&[("human", 1.0)]),
        contact_plots::heat_map(&heat_map_of_two_parameters(), Paper::default()).unwrap(),
    ] {
        let read = Svg::read(&svg);
        assert_eq!(read.attribute("role"), "img");
        assert_eq!(read.attribute("width"), "90mm");
        for word in [" id=", "url(", "<style", "<script", "NaN", "inf"] {
            assert!(!svg.contains(word), "'{word}' is in the document");
        }
        assert!(svg.contains("sans-serif") && svg.len() < 60_000, "{}", svg.len());
    }
}

#[test]
fn names_with_markup_are_written_as_text() {
    let odd = "a<b> & \"c\" \u{1}";
    let svg = Svg::read(&force_svg(&[(odd, 1.0), ("plain", 1.0)]));
    svg.says(&["a<b> & \"c\""]);
}

#[test]
fn figures_that_cannot_be_drawn_are_refused() {
    let mut broken = force_figure(&[("Hertz (1)", 1.0)]);
    broken.panels[0].curves[0].points[3].1 = f64::NAN;
    assert_eq!(svg_of(broken), Err(PlotError::NotFinite("Hertz (1)".to_owned())));
    assert!(matches!(svg_of(force_figure(&[])), Err(PlotError::Empty(_))));
    let many = [("", 1.0); Look::MOST_SERIES + 1];
    assert_eq!(force_figure(&many).distinct(), Err(PlotError::TooMany { count: 9, most: 8 }));
    assert!(force_figure(&many[1..]).distinct().is_ok());
    let empty = Figure::in_column("", String::new(), vec![]);
    assert!(matches!(contact_plots::figure(&empty, Paper::default()), Err(PlotError::Empty(_))));
    let mut map = heat_map_of_two_parameters();
    map.x[0] = 0.0;
    assert_eq!(
        contact_plots::heat_map(&map, Paper::default()),
        Err(PlotError::NotPositive("E₁* (N/m²)".to_owned()))
    );
}

#[test]
fn names_of_limits_that_would_touch_are_written_in_rows() {
    let mut panel = Panel::new("", Axis::covering("x", 0.0, 1.0), Axis::new("y"));
    panel.curves.push(Curve::new("curve", vec![(0.0, 0.0), (1.0, 1.0)], Look::HERTZ));
    panel.limits.extend([0.5, 0.52].map(|at| Limit::vertical(format!("limit {at}"), at)));
    let figure = Figure {
        title: "t".to_owned(),
        description: "d".to_owned(),
        width: Width::Page,
        columns: 2,
        panels: vec![panel.clone(), panel],
    };
    let svg = Svg::read(&contact_plots::figure(&figure, Paper::default()).unwrap());
    assert_eq!(svg.attribute("width"), "190mm");
    assert_ne!(svg.place_of("limit 0.5").1, svg.place_of("limit 0.52").1);
}
