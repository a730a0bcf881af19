//! Contacts along a recorded motion: force beside the plates', how deep each sphere is, and where forces act on the sole.

mod foot;
mod sole;
mod stride;

use self::foot::{along_normal, hertz_limit};
use contact_plots::{Axis, Curve, Direction, Figure, Limit, Look, Panel, Width};
use osim_model::files::FileName;
use osim_motion::{FootSummary, Wrench};
use osim_planning::MotionResult;

/// Forces and depths over time and over strides, and two panels of the sole, for each foot: in three columns where all are there.
pub(super) fn motion(result: &MotionResult, title: Option<&str>) -> Figure {
    let feet = &result.summary.feet;
    let own = || format!("{} along {}", stem(result.opened.name()), stem(&result.motion));
    let rows: Vec<Rows> =
        feet.iter().enumerate().map(|(index, foot)| Rows::of(result, index, foot)).collect();
    let is_whole = rows.iter().all(|rows| rows.strides.is_some() && rows.sole.is_some());
    Figure {
        title: title.map_or_else(own, str::to_owned),
        description: format!(
            "Force along the normal of the floor over body weight of {}, of the model and, where they are there, of the plates; and \
             indentation over radius of each sphere, against time and over strides; where the force acts on the sole; and forces as \
             arrows along the foot.",
            feet.iter().map(|foot| foot.foot.name.as_str()).collect::<Vec<_>>().join(" and ")
        ),
        width: Width::Page,
        columns: if is_whole { 3 } else { 2 },
        panels: rows.into_iter().flat_map(|rows| rows.panels(is_whole)).collect(),
    }
}

/// The panels of one foot, in pairs.
struct Rows {
    times: [Panel; 2],
    strides: Option<[Panel; 2]>,
    sole: Option<[Panel; 2]>,
}

impl Rows {
    fn of(result: &MotionResult, index: usize, foot: &FootSummary) -> Self {
        let on_sole = result.on_soles.get(index).and_then(Option::as_ref);
        let sole = on_sole.map(|on_sole| sole::panels(result, index, foot, on_sole));
        Self {
            times: [forces(result, index, foot), depths(result, foot)],
            strides: stride::panels(result, index, foot),
            // A foot in the air has no centre of pressure.
            sole: sole.filter(|panels| panels.iter().all(|panel| !panel.curves.is_empty())),
        }
    }

    /// Three above three, or pairs side by side.
    fn panels(self, is_whole: bool) -> Vec<Panel> {
        let pairs = [Some(self.times), self.strides, self.sole];
        if !is_whole {
            return pairs.into_iter().flatten().flatten().collect();
        }
        let (above, below): (Vec<Panel>, Vec<Panel>) =
            pairs.into_iter().flatten().map(|[above, below]| (above, below)).unzip();
        above.into_iter().chain(below).collect()
    }
}

fn forces(result: &MotionResult, index: usize, foot: &FootSummary) -> Panel {
    let along = |wrench: &Wrench| along_normal(result, foot, wrench);
    let times = || result.states.time_s.iter().copied();
    let mut panel = Panel::new(
        foot.foot.name.clone(),
        Axis::new("time (s)"),
        Axis::new("normal force / body weight (–)"),
    );
    panel.limits.push(Limit { label: "body weight".to_owned(), at: 1.0, direction: Direction::Horizontal });
    panel.curves.push(Curve {
        label: "model".to_owned(),
        points: times().zip(foot.wrenches.iter().map(along)).collect(),
        look: Look::series(0),
    });
    let measured = result.measured.as_ref().and_then(|measured| measured.feet.get(index));
    if let Some(measured) = measured {
        let all: Vec<Option<(f64, f64)>> =
            times().zip(measured).map(|(time, one)| Some((time, along(one.as_ref()?)))).collect();
        // No line leads over a time of which the plates know nothing.
        for run in all.chunk_by(|before, after| before.is_some() == after.is_some()) {
            let points: Vec<(f64, f64)> = run.iter().copied().flatten().collect();
            if points.len() > 1 {
                panel.curves.push(Curve { label: "plates".to_owned(), points, look: Look::series(1) });
            }
        }
    }
    panel
}

/// The file's name without its folders and its ending.
fn stem(name: &FileName) -> String {
    let path = name.to_path();
    path.file_stem().map_or_else(|| name.to_string(), |stem| stem.to_string_lossy().into_owned())
}

/// A sphere further above the floor than so many radii says nothing of its contact.
const ABOVE: f64 = -0.5;

fn depths(result: &MotionResult, foot: &FootSummary) -> Panel {
    let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("indentation / radius (–)"));
    panel.limits.push(hertz_limit());
    for (index, &pair) in foot.foot.pairs.iter().enumerate() {
        let Some(known) = result.states.pairs.get(pair) else { continue };
        let sphere = result.opened.model.sphere(known.sphere).map(|sphere| sphere.name.clone());
        let depth = result.states.pair(pair).map(|state| state.indentation_m / known.radius_m);
        panel.curves.push(Curve {
            label: sphere.unwrap_or_default(),
            points: result.states.time_s.iter().copied().zip(depth).collect(),
            look: Look::series(index),
        });
    }
    let deepest = foot.spheres.iter().map(|sphere| sphere.largest_relative_indentation).fold(0.2, f64::max);
    panel.y.limits = Some((ABOVE, 1.05 * deepest));
    panel
}
