//! The figure of contacts along a recorded motion: forces of model and plates, indentations, and forces on the sole.

use contact_plots::{Axis, Curve, Dash, Figure, Limit, Look, Mark, Panel, Width};
use contact_scaling::limits;
use osim_model::DVec3;
use osim_model::feet::ViewAxes;
use osim_model::files::FileName;
use osim_motion::{FootSummary, PressureOnSole, Wrench};
use osim_planning::MotionResult;

/// A figure of forces and depths over time and over strides, and two panels of the sole, for each foot; in three columns if all panels
/// exist.
pub(crate) fn motion(result: &MotionResult, title: Option<&str>) -> Figure {
    let feet = &result.summary.feet;
    let default_title = || {
        format!("{} along {}", name_without_ending(result.opened.name()), name_without_ending(&result.motion))
    };
    let feet_panels: Vec<FootPanels> =
        feet.iter().enumerate().map(|(index, foot)| FootPanels::of_foot(result, index, foot)).collect();
    let has_all_panels =
        feet_panels.iter().all(|feet_panels| feet_panels.strides.is_some() && feet_panels.sole.is_some());
    Figure {
        title: title.map_or_else(default_title, str::to_owned),
        description: format!(
            "Force along the normal of the floor over body weight of {}, of the model and, where they are there, of the plates; and \
             indentation over radius of each sphere, against time and over strides; where the force acts on the sole; and forces as \
             arrows along the foot.",
            feet.iter().map(|foot| foot.foot.name.as_str()).collect::<Vec<_>>().join(" and ")
        ),
        width: Width::Page,
        columns: if has_all_panels { 3 } else { 2 },
        panels: feet_panels.into_iter().flat_map(|feet_panels| feet_panels.panels(has_all_panels)).collect(),
    }
}

/// The panels about one foot: over time, over strides, and on its sole.
struct FootPanels {
    times: [Panel; 2],
    strides: Option<[Panel; 2]>,
    sole: Option<[Panel; 2]>,
}

impl FootPanels {
    fn of_foot(result: &MotionResult, index: usize, foot: &FootSummary) -> Self {
        let on_sole = result.on_soles.get(index).and_then(Option::as_ref);
        let sole =
            on_sole.map(|sole| [path_panel(result, foot, sole), arrow_panel(result, index, foot, sole)]);
        Self {
            times: [force_panel(result, index, foot), depth_panel(result, foot)],
            strides: stride_panels(result, index, foot),
            // A foot in the air has no centre of pressure.
            sole: sole.filter(|panels| panels.iter().all(|panel| !panel.curves.is_empty())),
        }
    }

    /// The panels in order: two rows of three panels, or pairs side by side.
    fn panels(self, has_all_panels: bool) -> Vec<Panel> {
        let pairs = [Some(self.times), self.strides, self.sole];
        if !has_all_panels {
            return pairs.into_iter().flatten().flatten().collect();
        }
        let (above, below): (Vec<Panel>, Vec<Panel>) =
            pairs.into_iter().flatten().map(|[above, below]| (above, below)).unzip();
        above.into_iter().chain(below).collect()
    }
}

fn force_panel(result: &MotionResult, index: usize, foot: &FootSummary) -> Panel {
    let along = |wrench: &Wrench| along_normal(result, foot, wrench);
    let times = || result.states.time_s.iter().copied();
    let mut panel = Panel::new(
        foot.foot.name.clone(),
        Axis::new("time (s)"),
        Axis::new("normal force / body weight (–)"),
    );
    panel.limits.push(Limit::horizontal("body weight", 1.0));
    let points = times().zip(foot.wrenches.iter().map(along)).collect();
    panel.curves.push(Curve::new("model", points, Look::series(0)));
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    if let Some(measured) = measured {
        // The line is interrupted where the plates have no force.
        let points = times().zip(measured).map(|(time, one)| Some((time, along(one.as_ref()?))));
        add_runs(&mut panel, "plates", 1, points);
    }
    panel
}

/// A curve for each run of known points.
fn add_runs(panel: &mut Panel, label: &str, series: usize, points: impl Iterator<Item = Option<(f64, f64)>>) {
    let points: Vec<_> = points.collect();
    for run in points.chunk_by(|before, after| before.is_some() == after.is_some()) {
        let points: Vec<(f64, f64)> = run.iter().copied().flatten().collect();
        if points.len() > 1 {
            panel.curves.push(Curve::new(label, points, Look::series(series)));
        }
    }
}

/// The name of the file without its folders and its extension.
fn name_without_ending(name: &FileName) -> String {
    let path = name.to_path();
    path.file_stem().map_or_else(|| name.to_string(), |stem| stem.to_string_lossy().into_owned())
}

/// Spheres higher above the floor than this are not drawn, in radii.
const LEAST_DEPTH_SHOWN: f64 = -0.5;

fn depth_panel(result: &MotionResult, foot: &FootSummary) -> Panel {
    let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("indentation / radius (–)"));
    panel.limits.push(hertz_limit());
    for (index, &pair) in foot.foot.pairs.iter().enumerate() {
        let Some(known) = result.states.pairs.get(pair) else { continue };
        let sphere = result.opened.model.sphere(known.sphere).map(|sphere| sphere.name.clone());
        let depth = result.states.pair(pair).map(|state| state.indentation_m / known.radius_m);
        let points = result.states.time_s.iter().copied().zip(depth).collect();
        panel.curves.push(Curve::new(sphere.unwrap_or_default(), points, Look::series(index)));
    }
    let deepest = foot.spheres.iter().map(|sphere| sphere.largest_relative_indentation).fold(0.2, f64::max);
    panel.y.limits = Some((LEAST_DEPTH_SHOWN, 1.05 * deepest));
    panel
}

/// The normal of the floor under the foot.
fn floor_normal(result: &MotionResult, foot: &FootSummary) -> DVec3 {
    let first = foot.foot.pairs.first().and_then(|&pair| result.states.frame(0).get(pair));
    first.map_or(DVec3::Y, |state| state.normal)
}

/// A force along the normal of the foot's floor, body weights.
fn along_normal(result: &MotionResult, foot: &FootSummary, wrench: &Wrench) -> f64 {
    wrench.force_n.dot(floor_normal(result, foot)) / result.summary.weight_n
}

/// The limit of the Hertz law as a line.
fn hertz_limit() -> Limit {
    Limit::horizontal("Hertz", limits::INDENTATION.value)
}

/// The largest number of arrows of one stance.
const MOST_ARROWS: usize = 25;
/// How far an arrow leans for a force of one body weight along the foot, mm.
const LEAN_PER_BODY_WEIGHT_MM: f64 = 100.0;

fn path_panel(result: &MotionResult, foot: &FootSummary, on_sole: &PressureOnSole) -> Panel {
    let mut panel = Panel::new(
        "centre of pressure on the sole",
        Axis::new("along the foot (mm)"),
        Axis::new("to the right of the foot (mm)"),
    );
    for (label, points, series) in [("model", &on_sole.model_m, 0), ("plates", &on_sole.measured_m, 1)] {
        // The line is interrupted where there is no centre of pressure.
        let points = points.iter().map(|at| at.map(|[ahead, right]| (1e3 * ahead, 1e3 * right)));
        add_runs(&mut panel, label, series, points);
    }
    for (&pair, [ahead, right]) in foot.foot.pairs.iter().zip(&on_sole.spheres_m) {
        if result.states.pairs.get(pair).is_some() {
            let at = (1e3 * ahead, 1e3 * right);
            panel.marks.push(Mark { label: "sphere".to_owned(), at, look: Look::series(3) });
        }
    }
    panel
}

/// Arrows of the force, from the centre of pressure, in some frames of a stance: the first complete stance, or the first stance if none is
/// complete.
fn arrow_panel(result: &MotionResult, index: usize, foot: &FootSummary, on_sole: &PressureOnSole) -> Panel {
    let mut panel = Panel::new(
        "forces of one stance",
        Axis::new("along the foot (mm)"),
        Axis::new("normal force / body weight (–)"),
    );
    let complete_stance = foot.stances.iter().find(|one| one.stance.duration_s().is_some());
    let Some(stance) = complete_stance.or(foot.stances.first()).map(|one| one.stance) else { return panel };
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    let step = ((stance.last - stance.first) / MOST_ARROWS).max(1);
    for frame in (stance.first..=stance.last).step_by(step) {
        let default_title = on_sole.model_m.get(frame).copied().flatten().zip(foot.wrenches.get(frame));
        let plate = on_sole.measured_m.get(frame).copied().flatten();
        let plate = plate.zip(measured.and_then(|all| all.get(frame)?.as_ref()));
        for (one, series) in [(default_title, 0), (plate, 1)] {
            if let Some(([ahead_m, _], wrench)) = one {
                let forward = ViewAxes::with_up(floor_normal(result, foot)).forward;
                let lean = wrench.force_n.dot(forward) / result.summary.weight_n;
                let (leans_mm, up) = (LEAN_PER_BODY_WEIGHT_MM * lean, along_normal(result, foot, wrench));
                let start_mm = 1e3 * ahead_m;
                let points = vec![(start_mm, 0.0), (start_mm + leans_mm, up)];
                let look = Look { dash: Dash::Solid, ..Look::series(series) };
                // Other panels explain the colours.
                panel.curves.push(Curve::new("", points, look));
            }
        }
    }
    panel
}

/// Panels of the force and of the deepest sphere over strides: from one touch-down (0 %) to the next (100 %); `None` without a complete
/// stride.
fn stride_panels(result: &MotionResult, index: usize, foot: &FootSummary) -> Option<[Panel; 2]> {
    let strides = foot.strides();
    if strides.is_empty() {
        return None;
    }
    let axis = || Axis::covering("stride (%)", 0.0, 100.0);
    let mut forces = Panel::new("over strides", axis(), Axis::new("normal force / body weight (–)"));
    let mut depths = Panel::new("", axis(), Axis::new("deepest x/R (–)"));
    depths.limits.push(hertz_limit());
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    for &stride in &strides {
        let plates = |frame: usize| Some(along_normal(result, foot, measured?.get(frame)?.as_ref()?));
        let model = |frame: usize| Some(along_normal(result, foot, foot.wrenches.get(frame)?));
        add_stride(&mut forces, result, stride, ("model", 0), model);
        add_stride(&mut forces, result, stride, ("plates", 1), plates);
        add_stride(&mut depths, result, stride, ("model", 0), |frame| deepest_at(result, foot, frame));
    }
    Some([forces, depths])
}

/// Adds the curve of one stride, up to the first frame without a value.
fn add_stride(
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
        panel.curves.push(Curve::new(label, points, Look::series(series)));
    }
}

fn deepest_at(result: &MotionResult, foot: &FootSummary, frame: usize) -> Option<f64> {
    let relative = |&pair: &usize| {
        let state = result.states.frame(frame).get(pair)?;
        Some(state.indentation_m / result.states.pairs.get(pair)?.radius_m)
    };
    foot.foot.pairs.iter().filter_map(relative).reduce(f64::max)
}
