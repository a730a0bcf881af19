//! Forces and depths over whole strides, from touch-down (0 %) to the next one (100 %).

use contact_plots::{Axis, Curve, Look, Panel};
use osim_motion::FootSummary;
use osim_planning::MotionResult;

use super::foot::{along_normal, hertz_limit};

/// The force and the deepest sphere; `None` where no stride is seen whole.
pub(super) fn panels(result: &MotionResult, index: usize, foot: &FootSummary) -> Option<[Panel; 2]> {
    let strides = foot.strides();
    if strides.is_empty() {
        return None;
    }
    let axis = || Axis::over("stride (%)", 0.0, 100.0);
    let mut forces = Panel::new("over strides", axis(), Axis::new("normal force / body weight (–)"));
    let mut depths = Panel::new("", axis(), Axis::new("deepest x/R (–)"));
    depths.limits.push(hertz_limit());
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    for &stride in &strides {
        let plates = |frame: usize| Some(along_normal(result, foot, measured?.get(frame)?.as_ref()?));
        let model = |frame: usize| Some(along_normal(result, foot, foot.wrenches.get(frame)?));
        add(&mut forces, result, stride, ("model", 0), model);
        add(&mut forces, result, stride, ("plates", 1), plates);
        add(&mut depths, result, stride, ("model", 0), |frame| deepest(result, foot, frame));
    }
    Some([forces, depths])
}

/// Adds a curve of what is known of a stride, up to the first frame of which nothing is.
fn add(
    panel: &mut Panel,
    result: &MotionResult,
    (from_s, to_s): (f64, f64),
    (label, series): (&str, usize),
    value: impl Fn(usize) -> Option<f64>,
) {
    let times = result.states.time_s.as_slice();
    let first = times.partition_point(|&time_s| time_s < from_s);
    let inside = times.iter().copied().enumerate().skip(first).take_while(|(_, time_s)| *time_s <= to_s);
    let percent = |time_s: f64| 100.0 * (time_s - from_s) / (to_s - from_s);
    let points: Vec<(f64, f64)> =
        inside.map_while(|(frame, time_s)| Some((percent(time_s), value(frame)?))).collect();
    if points.len() > 1 {
        panel.curves.push(Curve { label: label.to_owned(), points, look: Look::series(series) });
    }
}

fn deepest(result: &MotionResult, foot: &FootSummary, frame: usize) -> Option<f64> {
    let relative = |&pair: &usize| {
        let state = result.states.frame(frame).get(pair)?;
        Some(state.indentation_m / result.states.pairs.get(pair)?.radius_m)
    };
    foot.foot.pairs.iter().filter_map(relative).reduce(f64::max)
}
