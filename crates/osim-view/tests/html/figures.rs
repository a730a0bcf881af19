//! Tests of figures: titles, units, limits, and the text in place of a figure that cannot be drawn.

use contact_plots::{Drawing, Figure, Paper, figure};
use osim_inspect::InspectOptions;
use osim_inspect::series::ContactBody;
use osim_requests::options::FallOptions;
use osim_requests::spell::{CommandLine, Python};
use osim_requests::{AxesChoice, DropHeight, QuantityChoice};
use osim_view::figures;

use crate::support::open;

const DROP_HEIGHT: DropHeight = DropHeight::Radii(0.25);

fn body_called(name: &str) -> ContactBody {
    let model = open(&format!("table1/{name}.osim"));
    let options = InspectOptions::default();
    ContactBody::from_inspected_model(name.to_owned(), &model.model, &options, &|fault| model.failure(fault))
        .unwrap()
}

/// Labels of the horizontal and the vertical axis of the first panel.
fn axes(figure: &Figure) -> (&str, &str) {
    (&figure.panels[0].x.label, &figure.panels[0].y.label)
}

fn curve_names(figure: &Figure) -> Vec<&str> {
    figure.panels[0].curves.iter().map(|curve| curve.label.as_str()).collect()
}

fn limit_names(figure: &Figure) -> Vec<&str> {
    figure.panels[0].limits.iter().map(|limit| limit.label.as_str()).collect()
}

#[test]
fn one_contact_is_drawn_in_newtons_and_several_in_shares_of_the_weight() {
    let (mouse, horse) = (body_called("mouse_smooth_sphere"), body_called("horse_smooth_sphere"));
    let one = [mouse];
    let figure = figures::contact_force(&one, figures::units_for(&one, None), None, None).unwrap();
    assert_eq!(axes(&figure), ("relative indentation x̂ = x/R (–)", "force of one sphere (N)"));
    assert_eq!(figure.title, "Contact force: mouse_smooth_sphere");
    assert_eq!(curve_names(&figure), ["Hertz (1)", "Hertz with cf (C.1)", "smoothed, at rest (C.9)"]);
    assert!(figure.description.contains("of mouse_smooth_sphere: the Hertz law"), "{}", figure.description);
    let panel = &figure.panels[0];
    assert_eq!(panel.marks[0].label, "at rest under body weight");
    assert_eq!(limit_names(&figure), ["x̂ = 0.16"]);
    // The shade ends where contact begins.
    assert_eq!(
        (panel.areas[0].label.as_str(), panel.areas[0].points.last().unwrap().0),
        ("before contact", 0.0)
    );
    let [mouse] = one;
    let two = [mouse, horse];
    let figure = figures::contact_force(&two, figures::units_for(&two, None), None, None).unwrap();
    assert_eq!(axes(&figure).1, "force of one sphere / its share Mg/n (–)");
    assert_eq!(figure.title, "Contact force");
    assert_eq!(curve_names(&figure), ["mouse_smooth_sphere", "horse_smooth_sphere"]);
    let figure =
        figures::contact_force(&two, figures::units_for(&two, Some(AxesChoice::Real)), None, Some("Both"))
            .unwrap();
    assert_eq!(axes(&figure).0, "indentation x (mm)");
    assert_eq!((figure.title.as_str(), limit_names(&figure).len()), ("Both", 0));
}

#[test]
fn thresholds_and_the_step_are_drawn_for_one_contact_only() {
    let one = [body_called("mouse_smooth_sphere")];
    let figure = figures::contact_state(&one, figures::units_for(&one, None), None, None).unwrap();
    assert_eq!(limit_names(&figure), ["state 0.05", "state 0.95"]);
    assert_eq!(axes(&figure).1, "contact state (–)");
    assert_eq!(curve_names(&figure), ["binary contact, without smoothing", "smoothed (C.4)"]);
    let two = [body_called("mouse_smooth_sphere"), body_called("horse_smooth_sphere")];
    let figure = figures::contact_state(&two, figures::units_for(&two, None), None, None).unwrap();
    assert!(limit_names(&figure).is_empty());
    assert_eq!(curve_names(&figure), ["mouse_smooth_sphere", "horse_smooth_sphere"]);
}

#[test]
fn a_law_without_smoothing_has_no_state() {
    let bodies = [body_called("mouse_hunt_crossley")];
    let failure = figures::contact_state(&bodies, figures::units_for(&bodies, None), None, None).unwrap_err();
    assert_eq!(
        failure.message.spelled(&CommandLine),
        "a HuntCrossleyForce has no contact state to draw: there, contact is a step; plot force shows its law"
    );
    assert!(failure.message.spelled(&Python).contains("ocs.plot(\"force\") shows its law"));
}

#[test]
fn loops_of_one_contact_have_three_speeds_and_those_of_several_one_each() {
    let one = [body_called("mouse_smooth_sphere")];
    let figure = figures::loops(&one, figures::units_for(&one, None), DROP_HEIGHT, None).unwrap();
    assert_eq!((curve_names(&figure).len(), curve_names(&figure)[0]), (4, "force at rest"));
    let described = &figure.description;
    assert!(described.contains("the largest of them that of a fall from 0.25 R."), "{described}");
    let short = figures::impact_loops(&one, figures::units_for(&one, None), DROP_HEIGHT, None).unwrap();
    let (short, whole) = (&short.panels[0].curves[0], &figure.panels[0].curves[3]);
    assert_eq!((&short.label, &short.points), (&whole.label, &whole.points));
    let two = [body_called("mouse_smooth_sphere"), body_called("horse_smooth_sphere")];
    let figure = figures::loops(&two, figures::units_for(&two, None), DROP_HEIGHT, None).unwrap();
    assert_eq!(curve_names(&figure).len(), 2);
    assert!(curve_names(&figure)[1].starts_with("horse_smooth_sphere: "), "{:?}", curve_names(&figure));
}

#[test]
fn drops_stand_over_seconds_and_over_time_without_dimensions() {
    let two = [body_called("mouse_smooth_sphere"), body_called("horse_smooth_sphere")];
    let figure = figures::drops(&two, DROP_HEIGHT, "a height", Some(0.5), None).unwrap();
    assert!(figure.description.ends_with("They fall from a height."), "{}", figure.description);
    assert_eq!(
        (limit_names(&figure), curve_names(&figure)),
        (vec!["body weight"], vec![&*two[0].name, &two[1].name])
    );
    assert_eq!(axes(&figure), ("time t (s)", "normal force / body weight (–)"));
    assert_eq!(figure.panels[1].x.label, "non-dimensional time t/√(R/g) (–)");
    // The horse's time passes more slowly, so its fall ends first.
    let ends = |panel: usize| figure.panels[panel].curves.iter().map(|curve| curve.points.last().unwrap().0);
    let horse = ends(1).nth(1).unwrap();
    assert!(ends(1).all(|end| end >= horse));
    assert_eq!(
        (figure.panels[0].x.limits, figure.panels[1].x.limits),
        (Some((0.0, 0.5)), Some((0.0, horse)))
    );
}

#[test]
fn a_heat_map_is_about_one_body() {
    let restitution = QuantityChoice::Restitution;
    let fall = FallOptions { height: DROP_HEIGHT, duration: None };
    let axis = |now: f64| vec![0.5 * now, now, 2.0 * now];
    let one = [body_called("mouse_smooth_sphere")];
    // Stiffness does not change the restitution of an impact without gravity: a curve over the dissipation.
    let curve = figures::heat(&one, restitution, &fall, axis, axis, None);
    let Ok(Drawing::Panels(curve)) = curve else { panic!() };
    assert_eq!(curve.title, "Restitution: mouse_smooth_sphere");
    assert_eq!(curve.panels[0].x.label, "dissipation α (s/m)");
    assert_eq!(curve.panels[0].limits[0].label, "0.8 by (13), limit of the Hunt–Crossley law");
    let peak = QuantityChoice::PeakForce;
    let Ok(Drawing::HeatMap(map)) = figures::heat(&one, peak, &fall, axis, axis, None) else { panic!() };
    assert_eq!((map.x.len(), map.values.len()), (3, 3));
    let two = [body_called("mouse_smooth_sphere"), body_called("horse_smooth_sphere")];
    let failure = figures::heat(&two, restitution, &fall, axis, axis, None).unwrap_err();
    assert_eq!(&*failure.model, "mouse_smooth_sphere, horse_smooth_sphere");
    assert_eq!(
        failure.message.spelled(&CommandLine),
        "a sweep is about one body: name one model, without --target-mass"
    );
}

#[test]
fn too_many_curves_are_refused_with_a_way_out() {
    let bodies: Vec<ContactBody> = (0..12).map(|_| body_called("mouse_smooth_sphere")).collect();
    let figure = figures::contact_force(&bodies, figures::units_for(&bodies, None), None, None).unwrap();
    let failure = figures::failure_of_plot(figure.distinct().unwrap_err(), &bodies);
    let message = failure.message.spelled(&CommandLine);
    assert!(message.ends_with("expected at most 8: choose with --select GLOB"), "{message}");
}

#[test]
fn figures_of_the_paper_are_drawn() {
    for (figure_of_paper, title) in [
        (figures::paper::fig4(None), "Effect of scaling the dissipation α (Fig. 4)"),
        (figures::paper::fig_c5(Some("Smoothing")), "Smoothing"),
    ] {
        let figure_of_paper = figure_of_paper.unwrap();
        assert_eq!((figure_of_paper.title.as_str(), figure_of_paper.panels.len()), (title, 4));
        assert!(figure(&figure_of_paper, Paper::default()).unwrap().starts_with("<svg"));
    }
}
