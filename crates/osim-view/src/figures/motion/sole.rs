//! Where forces act on the sole, and forces along the foot.

use contact_plots::{Axis, Curve, Dash, Look, Mark, Panel};
use osim_model::feet::{ViewAxes, dot};
use osim_motion::{FootSummary, OnSole, Wrench};
use osim_planning::MotionResult;

use super::foot::{along_normal, normal};

/// Arrows of one stance, at most.
const ARROWS: usize = 25;
/// How far a push of one body weight along the foot leans an arrow, mm.
const LEAN_MM: f64 = 100.0;

/// The path of the centre of pressure seen from above, and forces as they stand on the sole.
pub(super) fn panels(
    result: &MotionResult,
    index: usize,
    foot: &FootSummary,
    on_sole: &OnSole,
) -> [Panel; 2] {
    [path(result, foot, on_sole), arrows(result, index, foot, on_sole)]
}

fn path(result: &MotionResult, foot: &FootSummary, on_sole: &OnSole) -> Panel {
    let mut panel = Panel::new(
        "centre of pressure on the sole",
        Axis::new("along the foot (mm)"),
        Axis::new("to the right of the foot (mm)"),
    );
    for (label, points, series) in [("model", &on_sole.model_m, 0), ("plates", &on_sole.measured_m, 1)] {
        // No line leads over a time without a centre of pressure.
        for run in points.chunk_by(|before, after| before.is_some() == after.is_some()) {
            let points: Vec<(f64, f64)> =
                run.iter().flatten().map(|[ahead, right]| (1e3 * ahead, 1e3 * right)).collect();
            if points.len() > 1 {
                panel.curves.push(Curve { label: label.to_owned(), points, look: Look::series(series) });
            }
        }
    }
    for (&pair, [ahead, right]) in foot.foot.pairs.iter().zip(&on_sole.spheres_m) {
        if result.states.pairs.get(pair).is_some() {
            let at = (1e3 * ahead, 1e3 * right);
            panel.marks.push(Mark { label: "sphere".to_owned(), at, look: Look::series(3) });
        }
    }
    panel
}

/// The first stance that is seen whole, else the first one: the force in some of its frames, from where it acts.
fn arrows(result: &MotionResult, index: usize, foot: &FootSummary, on_sole: &OnSole) -> Panel {
    let mut panel = Panel::new(
        "forces of one stance",
        Axis::new("along the foot (mm)"),
        Axis::new("normal force / body weight (–)"),
    );
    let whole = foot.stances.iter().find(|one| one.stance.duration_s().is_some());
    let Some(stance) = whole.or(foot.stances.first()).map(|one| one.stance) else { return panel };
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    let step = ((stance.last - stance.first) / ARROWS).max(1);
    for frame in (stance.first..=stance.last).step_by(step) {
        let own = on_sole.model_m.get(frame).copied().flatten().zip(foot.wrenches.get(frame));
        let plate = on_sole.measured_m.get(frame).copied().flatten();
        let plate = plate.zip(measured.and_then(|all| all.get(frame)?.as_ref()));
        for (one, series) in [(own, 0), (plate, 1)] {
            if let Some(([ahead_m, _], wrench)) = one {
                let (leans_mm, up) = arrow(result, foot, wrench);
                let start_mm = 1e3 * ahead_m;
                panel.curves.push(Curve {
                    // The legend has them by their colours.
                    label: String::new(),
                    points: vec![(start_mm, 0.0), (start_mm + leans_mm, up)],
                    look: Look { dash: Dash::Solid, ..Look::series(series) },
                });
            }
        }
    }
    panel
}

/// How far an arrow leans, mm, and how high it is, body weights.
fn arrow(result: &MotionResult, foot: &FootSummary, wrench: &Wrench) -> (f64, f64) {
    let normal = normal(result, foot);
    let weight_n = result.summary.weight_n;
    let forward = ViewAxes::with_up(normal).forward;
    (LEAN_MM * dot(wrench.force_n, forward) / weight_n, along_normal(result, foot, wrench))
}
