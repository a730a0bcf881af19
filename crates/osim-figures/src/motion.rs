//! Contacts along a recorded motion: force beside the plates', how deep each sphere is, and where forces act on the sole.

mod sole;

use contact_plots::{Axis, Curve, Direction, Figure, Limit, Look, Panel, Width};
use contact_scaling::limits;
use osim_feet::dot;
use osim_model::files::FileName;
use osim_motion::{FootSummary, Wrench};
use osim_planning::MotionResult;

/// Four panels for each foot.
pub(super) fn motion(result: &MotionResult, title: Option<&str>) -> Figure {
    let feet = &result.summary.feet;
    let own = || format!("{} along {}", stem(result.opened.name()), stem(&result.motion));
    Figure {
        title: title.map_or_else(own, str::to_owned),
        description: format!(
            "Force along the normal of the floor over body weight of {}, of the model and, where they are there, of the plates; and \
             indentation over radius of each sphere, against time; where the force acts on the sole; and forces as arrows along the foot.",
            feet.iter().map(|foot| foot.foot.name.as_str()).collect::<Vec<_>>().join(" and ")
        ),
        width: Width::Page,
        columns: 2,
        panels: feet
            .iter()
            .enumerate()
            .flat_map(|(index, foot)| {
                let of_sole = result.on_soles.get(index).and_then(Option::as_ref);
                let of_sole = of_sole.map(|on_sole| sole::panels(result, index, foot, on_sole));
                // A foot in the air has no centre of pressure.
                let of_sole = of_sole.into_iter().flatten().filter(|panel| !panel.curves.is_empty());
                [forces(result, index, foot), depths(result, foot)].into_iter().chain(of_sole)
            })
            .collect(),
    }
}

fn forces(result: &MotionResult, index: usize, foot: &FootSummary) -> Panel {
    let weight_n = result.summary.weight_n;
    let normal = foot.foot.pairs.first().and_then(|&pair| result.states.frame(0).get(pair));
    let normal = normal.map_or([0.0, 1.0, 0.0], |state| state.normal);
    let along = |wrench: &Wrench| dot(wrench.force_n, normal) / weight_n;
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
    panel.limits.push(Limit {
        label: "Hertz".to_owned(),
        at: limits::INDENTATION.value,
        direction: Direction::Horizontal,
    });
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
