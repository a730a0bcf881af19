//! The figures as documents: they parse, they say what they show, and points stand where they belong.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::document::Svg;
use contact_plots::{
    Axis, Curve, DropCurve, DropFigure, Figure, ForceAxis, ForceCurves, ForceFigure, HeatLimit, HeatMap,
    IndentationAxis, Limit, Look, LoopCurve, LoopFigure, Panel, PlotError, Point, StateCurve, StateFigure,
    Width,
};
use contact_plots::{Drawing, Paper};

fn line(slope: f64) -> Vec<Point> {
    (-10..=10).map(|i| f64::from(i) / 20.0).map(|x| (x, slope * (x + 0.5))).collect()
}

fn x_limit() -> Limit {
    Limit { label: "x̂ = 0.16".to_owned(), at: 0.16, direction: contact_plots::Direction::Vertical }
}

fn body(name: &str, slope: f64) -> ForceCurves {
    ForceCurves {
        name: name.to_owned(),
        hertz: line(slope),
        with_constant: line(2.0 * slope),
        own: line(1.5 * slope),
        rest: Some((0.35, slope)),
        remark: String::new(),
    }
}

fn force(bodies: Vec<ForceCurves>) -> ForceFigure {
    ForceFigure {
        title: "Contact force".to_owned(),
        indentation: IndentationAxis::Relative,
        force: ForceAxis::Newton,
        top: None,
        bodies,
        limits: vec![x_limit()],
    }
}

fn heat() -> HeatMap {
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

/// As wide as the figure is by itself.
fn svg_of(figure: Figure) -> Result<String, PlotError> {
    Drawing::Panels(figure).svg(Paper::default())
}

fn force_svg(data: &ForceFigure) -> Result<String, PlotError> {
    contact_plots::force_figure(data).and_then(svg_of)
}

fn state_svg(data: &StateFigure) -> Result<String, PlotError> {
    contact_plots::state_figure(data).and_then(svg_of)
}

fn loop_svg(data: &LoopFigure) -> Result<String, PlotError> {
    contact_plots::loop_figure(data).and_then(svg_of)
}

fn drop_svg(data: &DropFigure) -> Result<String, PlotError> {
    contact_plots::drop_figure(data).and_then(svg_of)
}

#[test]
fn one_body_has_its_three_laws_a_shade_and_its_limit() {
    let svg = Svg::read(&force_svg(&force(vec![body("human", 100.0)])).unwrap());
    svg.says(&[
        "Contact force",
        "relative indentation x̂ = x/R (–)",
        "force of one sphere (N)",
        "Hertz (1)",
        "Hertz with cf (C.1)",
        "smoothed, at rest (C.9)",
        "before contact",
        "x̂ = 0.16",
        "at rest under body weight",
    ]);
    assert!(svg.description.contains("human"), "{}", svg.description);
}

#[test]
fn several_bodies_are_one_curve_each_under_their_names() {
    let svg = Svg::read(&force_svg(&force(vec![body("mouse", 1.0), body("horse", 2.0)])).unwrap());
    svg.says(&["mouse", "horse"]);
    assert!(!svg.texts.iter().any(|text| text.contains("Hertz")), "{:?}", svg.texts);
}

#[test]
fn points_stand_where_the_ticks_say() {
    let svg = Svg::read(&force_svg(&force(vec![body("human", 100.0)])).unwrap());
    let (x, y) = (svg.scale_of_x(), svg.scale_of_y());
    // The Hertz curve is the solid one: from (−0.5, 0) to (0.5, 100).
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
fn every_kind_of_figure_is_a_document_with_its_axes() {
    let state = StateFigure {
        title: "Contact state".to_owned(),
        indentation: IndentationAxis::Millimetre,
        bodies: vec![StateCurve { name: "emu".to_owned(), points: line(1.0) }],
        limits: vec![],
    };
    Svg::read(&state_svg(&state).unwrap()).says(&[
        "indentation x (mm)",
        "contact state (–)",
        "smoothed (C.4)",
        "binary contact, without smoothing",
    ]);
    let loops = LoopFigure {
        title: "Dissipation".to_owned(),
        motion: "Half a sine wave.".to_owned(),
        indentation: IndentationAxis::Relative,
        force: ForceAxis::WeightShare,
        elastic: line(1.0),
        loops: vec![LoopCurve { name: "0.4 m/s".to_owned(), points: line(2.0) }],
        limits: vec![],
    };
    let svg = Svg::read(&loop_svg(&loops).unwrap());
    svg.says(&["0.4 m/s", "force at rest", "force of one sphere / its share Mg/n (–)"]);
    assert!(svg.description.contains("Half a sine wave."));
    let points: Vec<Point> = (0..=20).map(|i| (f64::from(i) / 10.0, 1.0)).collect();
    let bodies = vec![
        DropCurve { name: "mouse".to_owned(), points: points.clone(), time_unit_s: 0.0143 },
        DropCurve { name: "giraffe".to_owned(), points, time_unit_s: 0.0553 },
    ];
    let drop =
        DropFigure { title: "Drop".to_owned(), conditions: "From R/4.".to_owned(), shown: None, bodies };
    Svg::read(&drop_svg(&drop).unwrap()).says(&[
        "time t (s)",
        "non-dimensional time t/√(R/g) (–)",
        "normal force / body weight (–)",
        "mouse",
        "giraffe",
        "body weight",
        "A",
        "B",
    ]);
}

#[test]
fn dimensionless_drops_end_with_the_shorter_one() {
    let points: Vec<Point> = (0..=20).map(|i| (f64::from(i) / 10.0, 1.0)).collect();
    let slow = DropCurve { name: "slow".to_owned(), points: points.clone(), time_unit_s: 0.5 };
    let quick = DropCurve { name: "quick".to_owned(), points, time_unit_s: 0.1 };
    let panel =
        contact_plots::drop_panel(&[slow, quick], contact_plots::TimeAxis::Dimensionless, None).unwrap();
    assert_eq!(panel.x.limits, Some((0.0, 4.0)));
}

#[test]
fn a_heat_map_has_decades_and_a_named_bar() {
    let svg = Svg::read(&contact_plots::heat_map(&heat(), Paper::default()).unwrap());
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
    let mut gap = heat();
    gap.values[1][2] = None;
    Svg::read(&contact_plots::heat_map(&gap, Paper::default()).unwrap()).says(&["no value"]);
}

#[test]
fn several_figures_stand_in_one_page_without_a_clash() {
    for svg in [
        force_svg(&force(vec![body("human", 1.0)])).unwrap(),
        contact_plots::heat_map(&heat(), Paper::default()).unwrap(),
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
fn names_are_text_whatever_they_hold() {
    let odd = "a<b> & \"c\" \u{1}";
    let svg = Svg::read(&force_svg(&force(vec![body(odd, 1.0), body("plain", 1.0)])).unwrap());
    svg.says(&["a<b> & \"c\""]);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let refused = |bodies| contact_plots::force_figure(&force(bodies)).and_then(svg_of).unwrap_err();
    let mut broken = body("human", 1.0);
    broken.hertz[3].1 = f64::NAN;
    assert_eq!(refused(vec![broken]), PlotError::NotFinite { curve: "Hertz (1)".to_owned() });
    assert!(matches!(refused(vec![]), PlotError::Empty { .. }));
    let many = (0..=Look::MOST_SERIES).map(|i| body(&i.to_string(), 1.0)).collect();
    assert_eq!(refused(many), PlotError::TooMany { count: 9, most: 8 });
    let empty = Figure {
        title: String::new(),
        description: String::new(),
        width: Width::Column,
        columns: 1,
        panels: vec![],
    };
    assert!(matches!(contact_plots::figure(&empty, Paper::default()), Err(PlotError::Empty { .. })));
    let mut map = heat();
    map.x[0] = 0.0;
    assert_eq!(
        contact_plots::heat_map(&map, Paper::default()),
        Err(PlotError::NotPositive { axis: "E₁* (N/m²)".to_owned() })
    );
}

#[test]
fn names_of_limits_that_would_touch_are_written_in_rows() {
    let mut panel = Panel::new("", Axis::over("x", 0.0, 1.0), Axis::new("y"));
    panel.curves.push(Curve {
        label: "curve".to_owned(),
        points: vec![(0.0, 0.0), (1.0, 1.0)],
        look: Look::HERTZ,
    });
    for at in [0.5, 0.52] {
        let direction = contact_plots::Direction::Vertical;
        panel.limits.push(Limit { label: format!("limit {at}"), at, direction });
    }
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
