//! Tests of a figure's layout: its size, its names, the limits of its axes; and of its data.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::document::Svg;
use contact_plots::{
    Area, Axis, Curve, Datum, Direction, Drawing, Figure, HeatMap, Limit, Look, Mark, Panel, Paper,
    PlotError, Width,
};

/// A panel with a straight line from (0, 0) to (10, 100), a shade below it and a mark at its end.
fn panel_with_line(label: &str) -> Panel {
    let points: Vec<(f64, f64)> = (0..=10).map(|i| (f64::from(i), f64::from(10 * i))).collect();
    let mut panel = Panel::new("", Axis::new("x (mm)"), Axis::new("y (N)"));
    panel.curves.push(Curve { label: label.to_owned(), points: points.clone(), look: Look::HERTZ });
    panel.areas.push(Area { label: "shade".to_owned(), points });
    panel.marks.push(Mark { label: "end".to_owned(), at: (10.0, 100.0), look: Look::OWN });
    panel
}

fn figure_of_panels(title: &str, panels: Vec<Panel>) -> Figure {
    let description = "A line. It is straight.".to_owned();
    Figure { title: title.to_owned(), description, width: Width::Column, columns: panels.len(), panels }
}

fn drawn_svg(figure: Figure, paper: Paper) -> String {
    Drawing::Panels(figure).svg(paper).unwrap()
}

fn paper_of_width(width_mm: f64, text_pt: f64) -> Paper {
    Paper { width_mm: Some(width_mm), text_pt }
}

/// The size of the letters of the text `content` on paper, in points.
fn letters_pt(text: &str, content: &str) -> f64 {
    let svg = Svg::read(text);
    let units: f64 = svg.attribute("viewBox").split(' ').nth(2).unwrap().parse().unwrap();
    let mm: f64 = svg.attribute("width").trim_end_matches("mm").parse().unwrap();
    let before = text.split(content).next().unwrap();
    let size = before.rsplit("font-size=\"").next().unwrap().split('"').next().unwrap();
    size.parse::<f64>().unwrap() * mm / units / 25.4 * 72.0
}

#[test]
fn a_figure_has_the_wanted_width_and_letter_size() {
    for (mm, pt) in [(85.0, 7.0), (85.0, 9.5), (120.5, 6.0), (190.0, 12.0)] {
        let text =
            drawn_svg(figure_of_panels("Title", vec![panel_with_line("line")]), paper_of_width(mm, pt));
        let svg = Svg::read(&text);
        assert_eq!(svg.attribute("width"), format!("{mm}mm"));
        assert!((letters_pt(&text, "x (mm)") - pt).abs() < 0.05, "{pt}: {}", letters_pt(&text, "x (mm)"));
    }
}

#[test]
fn paper_that_is_too_narrow_is_refused_with_the_least_width() {
    let figure = Drawing::Panels(figure_of_panels("Title", vec![panel_with_line("line")]));
    let Err(PlotError::TooNarrow { least_mm, .. }) = figure.svg(paper_of_width(20.0, 7.0)) else { panic!() };
    assert!(figure.svg(paper_of_width(least_mm, 7.0)).is_ok());
    assert!(
        figure.svg(paper_of_width(f64::NAN, 7.0)).is_err() && figure.svg(paper_of_width(90.0, 0.0)).is_err()
    );
    let wide = Svg::read(&drawn_svg(
        figure_of_panels("", vec![panel_with_line("line"), panel_with_line("line")]),
        paper_of_width(190.0, 7.0),
    ));
    let narrow = Svg::read(&drawn_svg(
        figure_of_panels("", vec![panel_with_line("line"), panel_with_line("line")]),
        paper_of_width(60.0, 7.0),
    ));
    let beside = |svg: &Svg| svg.place_of("A").1 == svg.place_of("B").1;
    assert!(beside(&wide) && !beside(&narrow), "on narrow paper panels stand below each other");
}

#[test]
fn a_figure_without_a_title_has_no_empty_band_and_still_a_name() {
    let height = |svg: &Svg| svg.attribute("viewBox").split(' ').nth(3).unwrap().parse::<f64>().unwrap();
    let with =
        Svg::read(&drawn_svg(figure_of_panels("Title", vec![panel_with_line("line")]), Paper::default()));
    let without =
        Svg::read(&drawn_svg(figure_of_panels("", vec![panel_with_line("line")]), Paper::default()));
    // One row of 8 pt and what is around it, in units of 1/20 pt.
    assert!((height(&with) - height(&without) - 20.0 * 13.0).abs() <= 1.0);
    assert_eq!(without.title, "A line.");
}

#[test]
fn no_name_of_a_legend_is_cut_and_no_title() {
    let name =
        "a_model_with_a_long_name_that_was_scaled_by_the_tool_and_then_rescaled, 0.396 m/s, restitution 0.55";
    let title =
        "What the contacts of a model with a very long name do while they are pressed and let go again";
    let text = drawn_svg(figure_of_panels(title, vec![panel_with_line(name)]), Paper::default());
    let svg = Svg::read(&text);
    assert!(!text.contains('…'));
    let written: String = svg.texts.concat();
    assert!(written.replace(' ', "").contains(&name.replace(' ', "")), "{written}");
    assert!(written.replace(' ', "").contains(&title.replace(' ', "")), "{written}");
}

#[test]
fn limits_of_axes_cut_curves_shades_and_marks() {
    let mut drawing = Drawing::Panels(figure_of_panels("t", vec![panel_with_line("")]));
    drawing.limit_x((2.0, 8.0)).unwrap();
    drawing.limit_y((0.0, 50.0)).unwrap();
    let svg = Svg::read(&drawing.svg(Paper::default()).unwrap());
    let (x, y) = (svg.scale_of_x(), svg.scale_of_y());
    let line = svg.longest_line("#0072B2");
    let (first, last) = (line.first().unwrap(), line.last().unwrap());
    // It enters at the left edge and leaves through the upper one.
    let near =
        |seen: f64, expected: f64| assert!((seen - expected).abs() < 0.1, "{seen}, expected {expected}");
    near(x.value(first.0), 2.0);
    near(y.value(first.1), 20.0);
    near(x.value(last.0), 5.0);
    near(y.value(last.1), 50.0);
    assert!(!svg.texts.iter().any(|text| text == "end"), "a mark outside is not in the legend");
    assert!(drawing.limit_x((3.0, 3.0)).and_then(|()| drawing.svg(Paper::default()).map(|_| ())).is_err());
}

#[test]
fn a_vertical_axis_covers_what_the_horizontal_limits_leave() {
    let mut drawing = Drawing::Panels(figure_of_panels("t", vec![panel_with_line("line")]));
    drawing.limit_x((0.0, 2.0)).unwrap();
    let svg = Svg::read(&drawing.svg(Paper::default()).unwrap());
    assert!(svg.texts.iter().all(|text| text != "100"), "{:?}", svg.texts);
}

#[test]
fn panels_with_several_horizontal_axes_are_not_limited() {
    let mut other = panel_with_line("line");
    other.x.label = "t (s)".to_owned();
    let mut drawing = Drawing::Panels(figure_of_panels("t", vec![panel_with_line("line"), other]));
    assert!(matches!(drawing.limit_x((0.0, 1.0)), Err(PlotError::NoAxis { which: "horizontal", .. })));
    drawing.limit_y((0.0, 1.0)).unwrap();
}

#[test]
fn curves_get_other_names_in_the_order_of_the_legend() {
    let mut two = panel_with_line("line");
    two.curves.push(Curve {
        label: "second".to_owned(),
        points: vec![(0.0, 0.0), (1.0, 1.0)],
        look: Look::OWN,
    });
    let mut drawing = Drawing::Panels(figure_of_panels("t", vec![two.clone(), two]));
    assert_eq!(drawing.curves(), ["line", "second"]);
    drawing.rename(&["mouse".to_owned()]).unwrap();
    assert_eq!(drawing.curves(), ["mouse", "second"]);
    let error = drawing.rename(&["a", "b", "c"].map(str::to_owned)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "3 names were given, and the figure has 2 curves to name: 'mouse', 'second'"
    );
}

#[test]
fn a_logarithmic_axis_puts_equal_ratios_equally_far_apart() {
    let mut panel = Panel::new("", Axis::logarithmic("E (N/m²)"), Axis::new("y"));
    let points = vec![(1e5, 0.0), (1e6, 1.0), (1e7, 2.0)];
    panel.curves.push(Curve { label: String::new(), points, look: Look::HERTZ });
    let svg = Svg::read(&drawn_svg(figure_of_panels("t", vec![panel.clone()]), Paper::default()));
    svg.says(&["10⁵", "10⁶", "10⁷"]);
    let line = svg.longest_line("#0072B2");
    assert!(((line[1].0 - line[0].0) - (line[2].0 - line[1].0)).abs() <= 1.0, "{line:?}");
    panel.curves[0].points[0].0 = 0.0;
    let wrong = Drawing::Panels(figure_of_panels("t", vec![panel])).svg(Paper::default());
    assert_eq!(wrong, Err(PlotError::NotPositive("E (N/m²)".to_owned())));
}

#[test]
fn colours_beyond_their_limits_are_explained() {
    let mut map = HeatMap {
        title: "t".to_owned(),
        description: "d".to_owned(),
        x_axis: Axis::new("x"),
        x: vec![0.0, 1.0],
        y_axis: Axis::new("y"),
        y: vec![-1.0, 1.0],
        values: vec![vec![Some(1.0), Some(2.0)], vec![Some(3.0), Some(100.0)]],
        value_axis: Axis::new("value"),
        limit: None,
        mark: None,
    };
    map.value_axis.limits = Some((2.0, 4.0));
    let svg = Svg::read(&Drawing::HeatMap(map).svg(Paper::default()).unwrap());
    svg.says(&["4 and more", "2 and less"]);
}

#[test]
fn the_data_are_the_numbers_that_are_drawn() {
    let mut panel = panel_with_line("line");
    let label = "end".to_owned();
    panel.limits.push(Limit { label, at: 0.16, direction: Direction::Vertical });
    let drawing = Drawing::Panels(figure_of_panels("t", vec![panel]));
    let data = drawing.data();
    let curve: Vec<&Datum> = data.iter().filter(|datum| datum.kind == "curve").collect();
    assert_eq!(curve.len(), 11);
    assert!(
        curve.iter().all(|datum| datum.name == "line" && datum.x_axis == "x (mm)" && datum.y_axis == "y (N)")
    );
    assert_eq!((curve[3].x, curve[3].y), (Some(3.0), Some(30.0)));
    let limit = data.iter().find(|datum| datum.kind == "limit").unwrap();
    assert_eq!((limit.x, limit.y), (Some(0.16), None));
}
