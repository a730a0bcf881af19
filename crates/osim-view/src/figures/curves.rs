//! Figures with curves: force and contact state against indentation, loops of dissipation, drops, and the indentations of many models.

use contact_plots::{Area, Axis, Curve, Dash, Figure, Limit, Look, Mark, Panel, Paper, Point, figure};
use contact_scaling::limits;
use osim_inspect::series::{
    self, ContactBody, DropSeries, ForceSeries, IndentationUnit, LoopSeries, PlotUnits, SphereKind,
};
use osim_model::messages::Phrase;
use osim_requests::DropHeight;

use crate::figures::axes::{
    Result, force_axis, hertz_limit, indentation_axis, plot_failure, threshold_limits, title_for,
};

/// A force axis ends at this many times the share of the weight that one sphere carries. Running animals push this hard, and the
/// equilibrium can still be seen.
const MOST_SHARES_SHOWN: f64 = 3.0;

/// The force curves of one kind of sphere.
pub(super) struct KindOfSphereLaws {
    /// Name of the body, if the figure has several bodies; else empty.
    pub(super) name: String,
    pub(super) series: ForceSeries,
    /// The indentation in equilibrium, in brackets, if it is outside the figure; else empty.
    pub(super) remark: String,
}

/// Force against indentation for every kind of sphere of `bodies`, as in Fig. C.5. The horizontal axis has the range `limits`; the default
/// is from above the ground to a little deeper than the equilibria of the bodies, at most to the centre of a sphere.
///
/// # Errors
/// The weight of a body is not known, and forces are shares of the weight.
pub fn contact_force(
    bodies: &[ContactBody],
    units: PlotUnits,
    limits: Option<(f64, f64)>,
    wanted_title: Option<&str>,
) -> Result<Figure> {
    let mut drawn = Vec::new();
    for (body, kind) in series::bodies_and_kinds(bodies) {
        let radius_m = kind.radius_m;
        let (from_m, to_m) = match limits {
            Some((from, to)) => (units.metres(from, radius_m), units.metres(to, radius_m)),
            None => {
                let (from, to) = series::default_range(bodies);
                (from * radius_m, to * radius_m)
            }
        };
        let series = series::force(body, kind, units, (from_m, to_m))?;
        let outside = series.rest.map(|(x, _)| x).filter(|x| *x > units.x(to_m, radius_m));
        let remark = outside.map(|x| match units.indentation {
            IndentationUnit::Relative => format!(" (rests at x̂ = {x:.2}, outside the figure)"),
            IndentationUnit::Millimetre => format!(" (rests at {x:.1} mm, outside the figure)"),
        });
        let name = series::curve_name(body, kind, bodies.len() == 1);
        drawn.push(KindOfSphereLaws { name, series, remark: remark.unwrap_or_default() });
    }
    let description = match drawn.as_slice() {
        [one] if !one.series.model_law.is_empty() => format!(
            "Force against indentation of {}: the Hertz law, the Hertz law with the constant indentation, and the \
             smoothed law. The force before contact is shaded.",
            one.name
        ),
        laws => format!("Force against indentation of {}.", joined_names(laws.iter().map(|one| &one.name))),
    };
    let top = limits.is_none().then(|| end_of_force_axis(&drawn)).flatten();
    let mut panel = force_panel(drawn, units);
    panel.y.limits = top.map(|top| (0.0, top));
    Ok(Figure::in_column(title_for("Contact force", bodies, wanted_title), description, vec![panel]))
}

/// A panel with all force laws of one kind of sphere, where the force before contact is shaded; or with one law for each of several kinds.
pub(super) fn force_panel(laws: Vec<KindOfSphereLaws>, units: PlotUnits) -> Panel {
    let mut panel = Panel::new("", indentation_axis(units), force_axis(units));
    panel.limits = hertz_limit(units);
    let rest = |at| Mark { label: "at rest under body weight".to_owned(), at, look: Look::OWN };
    panel.marks = laws.iter().filter_map(|one| one.series.rest).map(rest).collect();
    let is_single = laws.len() == 1;
    for (index, KindOfSphereLaws { name, series, remark }) in laws.into_iter().enumerate() {
        let ForceSeries { hertz, with_constant, model_law, .. } = series;
        panel.curves.extend(match (is_single, model_law.is_empty()) {
            (false, is_plain) => {
                let points = if is_plain { hertz } else { model_law };
                vec![Curve::new(format!("{name}{remark}"), points, Look::series(index))]
            }
            (true, true) => vec![Curve::new(format!("Hertz (1){remark}"), hertz, Look::HERTZ)],
            (true, false) => {
                panel.areas.push(area_before_contact(&model_law));
                vec![
                    Curve::new("Hertz (1)", hertz, Look::HERTZ),
                    Curve::new("Hertz with cf (C.1)", with_constant, Look::WITH_CONSTANT),
                    Curve::new(format!("smoothed, at rest (C.9){remark}"), model_law, Look::OWN),
                ]
            }
        });
    }
    panel
}

/// The area below the curve before contact, up to x = 0.
fn area_before_contact(points: &[Point]) -> Area {
    let mut part: Vec<Point> = points.iter().copied().take_while(|(x, _)| *x <= 0.0).collect();
    let next = points.get(part.len());
    if let (Some(&(x0, y0)), Some(&(x1, y1))) = (part.last(), next)
        && x0 < 0.0
    {
        part.push((0.0, y0 + (y1 - y0) * (0.0 - x0) / (x1 - x0)));
    }
    Area { label: "before contact".to_owned(), points: part }
}

fn joined_names<'n>(names: impl Iterator<Item = &'n String>) -> String {
    names.map(String::as_str).collect::<Vec<_>>().join(", ")
}

/// The end of the force axis, if forces are much larger than in equilibrium.
fn end_of_force_axis(drawn: &[KindOfSphereLaws]) -> Option<f64> {
    let rests: Option<Vec<f64>> = drawn.iter().map(|one| one.series.rest.map(|(_, force)| force)).collect();
    let top = MOST_SHARES_SHOWN * rests?.into_iter().fold(0.0, f64::max);
    let highest = drawn.iter().flat_map(|one| one.series.hertz.iter().chain(&one.series.model_law));
    let highest = highest.fold(0.0_f64, |most, (_, force)| most.max(*force));
    (highest > top && top > 0.0).then_some(top)
}

/// Loops of force against indentation while spheres move into the ground and out again; the area inside a loop is the lost energy. A single
/// contact has loops at a quarter, half and all of the speed of a fall from `height`, and its force at speed 0; several contacts have one
/// loop each at this speed.
///
/// # Errors
/// The weight of a body is not known.
pub fn loops(
    bodies: &[ContactBody],
    units: PlotUnits,
    height: DropHeight,
    wanted_title: Option<&str>,
) -> Result<Figure> {
    let mut loops = Vec::new();
    let mut at_rest = Vec::new();
    let only = series::bodies_and_kinds(bodies).count() == 1;
    for (body, kind) in series::bodies_and_kinds(bodies) {
        if !only {
            let name = series::curve_name(body, kind, bodies.len() == 1);
            loops.push(with_body_name(&name, impact_loop(body, kind, units, height)?));
            continue;
        }
        let speed = series::impact_speed(body, kind, height)?;
        at_rest = series::force_at_rest(body, kind, units)?;
        for share in [0.25, 0.5, 1.0] {
            loops.push(series::hysteresis(body, kind, units, share * speed)?);
        }
    }
    let motion = format!(
        "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed in the \
         legend, the largest of them that of a fall from {}. The restitution is that of a free impact at that \
         speed, by the exact law.",
        height.describe("m", "R")
    );
    Ok(loop_figure(title_for("Dissipation", bodies, wanted_title), &motion, units, at_rest, loops))
}

/// Loops of force against indentation, one for each kind of sphere of `bodies`. Each begins with the speed of a fall from `height`.
///
/// # Errors
/// The weight of a body is not known.
pub fn impact_loops(
    bodies: &[ContactBody],
    units: PlotUnits,
    height: DropHeight,
    wanted_title: Option<&str>,
) -> Result<Figure> {
    let mut loops = Vec::new();
    for (body, kind) in series::bodies_and_kinds(bodies) {
        let impact = impact_loop(body, kind, units, height)?;
        // One curve of one model needs no name.
        let is_alone = bodies.len() == 1 && kind.spheres.is_empty();
        let name = || series::curve_name(body, kind, bodies.len() == 1);
        loops.push(if is_alone { impact } else { with_body_name(&name(), impact) });
    }
    let from = match height {
        DropHeight::Radii(0.25) => "a quarter of the radius".to_owned(),
        other => other.describe("m", "R"),
    };
    let motion = format!(
        "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed of a fall \
         from {from}."
    );
    Ok(loop_figure(title_for("Dissipation", bodies, wanted_title), &motion, units, vec![], loops))
}

/// A figure of loops. `motion` describes in words how the spheres moved; `at_rest` has points of the force at speed 0, if they are drawn.
fn loop_figure(
    title: String,
    motion: &str,
    units: PlotUnits,
    at_rest: Vec<Point>,
    loops: Vec<LoopSeries>,
) -> Figure {
    let mut panel = Panel::new("", indentation_axis(units), force_axis(units));
    panel.limits = hertz_limit(units);
    if !at_rest.is_empty() {
        let look = Look { colour: (0x77, 0x77, 0x77), dash: Dash::Solid, width_pt: 0.8 };
        panel.curves.push(Curve::new("force at rest", at_rest, look));
    }
    let curve = |(index, one): (usize, LoopSeries)| Curve::new(one.name, one.points, Look::series(index));
    panel.curves.extend(loops.into_iter().enumerate().map(curve));
    let description = format!("Force against indentation while a sphere goes in and out. {motion}");
    Figure::in_column(title, description, vec![panel])
}

/// The loop that begins with the speed of a fall from the given height.
fn impact_loop(
    body: &ContactBody,
    kind: &SphereKind,
    units: PlotUnits,
    height: DropHeight,
) -> Result<LoopSeries> {
    series::hysteresis(body, kind, units, series::impact_speed(body, kind, height)?)
}

fn with_body_name(name: &str, series: LoopSeries) -> LoopSeries {
    LoopSeries { name: format!("{name}: {}", series.name), ..series }
}

/// Contact state (C.4) against indentation for every kind of sphere of `bodies`. The horizontal axis has the range `limits`; the default is
/// half a radius above and below the floor.
///
/// # Errors
/// No body has a smoothed law.
pub fn contact_state(
    bodies: &[ContactBody],
    units: PlotUnits,
    limits: Option<(f64, f64)>,
    wanted_title: Option<&str>,
) -> Result<Figure> {
    let mut states = Vec::new();
    let mut marked = Vec::new();
    for (body, kind) in series::bodies_and_kinds(bodies) {
        let metres = |(from, to)| (units.metres(from, kind.radius_m), units.metres(to, kind.radius_m));
        if let Some(points) = series::contact_state(body, kind, units, limits.map(metres))? {
            states.push((series::curve_name(body, kind, bodies.len() == 1), points));
        }
        marked = threshold_limits(kind, units);
    }
    if states.is_empty() {
        let why = "a HuntCrossleyForce has no contact state to draw: there, contact is a step; `plot kind=force` shows \
                   its law";
        return Err(plot_failure(bodies, Phrase::template(why)));
    }
    // Each contact has thresholds of its own; those of several would be too many lines.
    if states.len() > 1 {
        marked.clear();
    }
    let of = joined_names(states.iter().map(|(name, _)| name));
    let description = format!("Contact state, from 0 to 1, against indentation of {of}.");
    let panel = Panel { limits: marked, ..state_panel(states, units) };
    Ok(Figure::in_column(title_for("Contact state", bodies, wanted_title), description, vec![panel]))
}

/// A panel with the smoothed state of one body and the step without smoothing, or with the states of several bodies.
pub(super) fn state_panel(states: Vec<(String, Vec<Point>)>, units: PlotUnits) -> Panel {
    let mut panel = Panel::new("", indentation_axis(units), Axis::covering("contact state (–)", 0.0, 1.05));
    if let [(_, points)] = states.as_slice() {
        let ends = points.first().zip(points.last()).map(|(first, last)| (first.0, last.0));
        if let Some((from, to)) = ends.filter(|(from, to)| *from < 0.0 && *to > 0.0) {
            let step = vec![(from, 0.0), (0.0, 0.0), (0.0, 1.0), (to, 1.0)];
            panel.curves.push(Curve::new("binary contact, without smoothing", step, Look::HERTZ));
        }
        panel.areas.push(area_before_contact(points));
        panel.curves.push(Curve::new("smoothed (C.4)", points.clone(), Look::OWN));
        return panel;
    }
    let curve = |(index, (name, points))| Curve::new(name, points, Look::series(index));
    panel.curves = states.into_iter().enumerate().map(curve).collect();
    panel
}

/// The label of an axis of time in seconds.
pub(super) const TIME_IN_SECONDS: &str = "time t (s)";
/// The label of an axis of dimensionless time.
pub(super) const DIMENSIONLESS_TIME: &str = "non-dimensional time t/√(R/g) (–)";

/// If no duration is given, a fall is drawn until all bodies are at rest, and longer by this factor.
const DURATION_OVER_REST_TIME: f64 = 1.15;

/// Force over body weight of bodies that fall from `height`, against time and against dimensionless time, as in Fig. 4. The fall lasts
/// `duration_s`, else 20 √(R/g) of the slowest body; the figure ends soon after all bodies are at rest. `from` is the height in words.
///
/// # Errors
/// The weight of a body is not known, or its contacts are too stiff to follow the fall.
pub fn drops(
    bodies: &[ContactBody],
    height: DropHeight,
    from: &str,
    duration_s: Option<f64>,
    wanted_title: Option<&str>,
) -> Result<Figure> {
    let followed_s = match duration_s {
        Some(duration_s) => duration_s,
        None => series::default_duration(bodies)?,
    };
    let falls = bodies.iter().map(|body| series::drop_force(body, height, followed_s));
    let falls: Vec<DropSeries> = falls.collect::<Result<_, _>>()?;
    let at_rest = |unit: &dyn Fn(&DropSeries) -> f64| {
        DURATION_OVER_REST_TIME * falls.iter().map(|fall| fall.settled_s / unit(fall)).fold(0.0, f64::max)
    };
    let at_rest_s = at_rest(&|_| 1.0);
    let ends_early = duration_s.is_none() && at_rest_s > 0.0 && at_rest_s < followed_s;
    let panel = |time, unit: &dyn Fn(&DropSeries) -> f64| {
        let falls = falls.iter().map(|fall| (fall.name.as_str(), fall.points.as_slice(), unit(fall)));
        drop_panel(falls, time, ends_early.then(|| at_rest(unit)))
    };
    let description = format!(
        "Normal force over body weight of {} in a drop test, against time and against non-dimensional time. They fall \
         from {from}.",
        joined_names(falls.iter().map(|fall| &fall.name))
    );
    let panels = vec![panel(TIME_IN_SECONDS, &|_| 1.0), panel(DIMENSIONLESS_TIME, &|fall| fall.time_unit_s)];
    Ok(Figure::in_column(title_for("Drop test", bodies, wanted_title), description, panels))
}

/// A panel of falls. Each fall has a name, points in s and body weights, and the unit of its `time`, s. The time axis ends at `end`, or
/// with the shortest fall.
pub(super) fn drop_panel<'f>(
    falls: impl Iterator<Item = (&'f str, &'f [Point], f64)>,
    time: &str,
    end: Option<f64>,
) -> Panel {
    let mut panel = Panel::new("", Axis::new(time), Axis::new("normal force / body weight (–)"));
    panel.limits.push(Limit::horizontal("body weight", 1.0));
    for (index, (name, points, unit_s)) in falls.enumerate() {
        let points = points.iter().map(|&(time_s, force)| (time_s / unit_s, force)).collect();
        panel.curves.push(Curve::new(name, points, Look::series(index)));
    }
    let ends = panel.curves.iter().map(|curve| curve.points.last().map_or(0.0, |point| point.0));
    let until = ends.chain(end).fold(f64::INFINITY, f64::min);
    if until > 0.0 && until.is_finite() {
        panel.x.limits = Some((0.0, until));
    }
    panel
}

/// End of the axis of x̂. Larger values, which are wrong anyway, are drawn at the end of the axis.
const END_OF_AXIS: f64 = 1.0;
/// The models are drawn as dots if there are at most this many.
const MOST_MODELS_WITH_DOTS: usize = 60;

/// The chart of x̂ = x/R of the deepest sphere of each model in equilibrium, sorted in each state, with the limit of the Hertz law;
/// `None` if no state has two models. Each state, for example that before a change, has its name in the legend.
pub fn indentations(states: &[(&str, &[f64])]) -> Option<String> {
    let models =
        states.iter().map(|(_, indentations)| indentations.len()).max().filter(|models| *models > 1)?;
    let limit = limits::INDENTATION.value;
    let mut panel = Panel::new(
        "",
        Axis::covering("models, in order of x̂", 0.0, (models + 1) as f64),
        Axis::new("x̂ = x/R at rest (–)"),
    );
    panel.limits.push(Limit::horizontal(format!("limit, x̂ = {limit}"), limit));
    let drawn = states.iter().enumerate().filter(|(_, (_, indentations))| indentations.len() > 1);
    for (index, &(name, indentations)) in drawn {
        let (look, points) = (Look::series(index), ranked_points(indentations));
        if points.len() <= MOST_MODELS_WITH_DOTS {
            // The legend names the curve; its dots have no name.
            panel.marks.extend(points.iter().map(|&at| Mark { label: String::new(), at, look }));
        }
        panel.curves.push(Curve::new(name, points, look));
    }
    let description = format!(
        "Relative indentation at rest of {models} models under body weight, in order, with the limit of {limit} as a line."
    );
    let title = "Relative indentation at rest over the models";
    figure(&Figure::in_column(title, description, vec![panel]), Paper::default()).ok()
}

/// The number of values that are larger than the end of the axis, where they are drawn.
pub(crate) fn count_above_axis(indentations: &[f64]) -> usize {
    indentations.iter().filter(|value| **value > END_OF_AXIS).count()
}

fn ranked_points(indentations: &[f64]) -> Vec<Point> {
    let mut sorted = indentations.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.iter().enumerate().map(|(rank, value)| ((rank + 1) as f64, value.min(END_OF_AXIS))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_ranked_and_end_at_the_top_of_the_axis() {
        assert_eq!(ranked_points(&[0.3, 2.5, 0.1]), [(1.0, 0.1), (2.0, 0.3), (3.0, 1.0)]);
        assert_eq!(count_above_axis(&[0.3, 2.5, 1.0]), 1);
    }

    #[test]
    fn one_model_has_no_chart() {
        assert!(indentations(&[("", &[0.3])]).is_none());
        let drawn = indentations(&[("after", &[0.3, 0.1])]).unwrap();
        assert!(drawn.contains("limit, x̂ = 0.16") && drawn.contains("after"), "{drawn}");
    }
}
