//! How deep the spheres of many models sink in at rest.

use contact_plots::{Axis, Curve, Figure, Limit, Look, Mark, Panel, Paper, Point, figure};
use contact_scaling::limits;

/// Where the axis ends: a sphere that is pressed in by more than its radius is wrong, by however much.
const TOP: f64 = 1.0;
/// Each model has a dot if there are at most this many.
const DOTS: usize = 60;

/// x̂ at rest of each model in one state, in any order.
pub struct State<'s> {
    /// The name in the legend.
    pub name: &'s str,
    /// Relative indentation x̂ = x/R of the deepest sphere of each model.
    pub indentations: &'s [f64],
}

/// x̂ of models in one state or several, each state from the smallest value to the largest, with the limit of the Hertz law.
/// `None` where no state has two models.
pub fn indentations(states: &[State<'_>]) -> Option<String> {
    let models = states.iter().map(|state| state.indentations.len()).max().filter(|models| *models > 1)?;
    let limit = limits::INDENTATION.value;
    let mut panel = Panel::new(
        "",
        Axis::over("models, in order of x̂", 0.0, float(models + 1)),
        Axis::new("x̂ = x/R at rest (–)"),
    );
    panel.limits.push(Limit::horizontal(format!("limit, x̂ = {limit}"), limit));
    let drawn = states.iter().enumerate().filter(|(_, state)| state.indentations.len() > 1);
    for (index, state) in drawn {
        let (look, points) = (Look::series(index), ranked(state.indentations));
        if points.len() <= DOTS {
            // The legend has the curve; dots on it need no name of their own.
            panel.marks.extend(points.iter().map(|&at| Mark { label: String::new(), at, look }));
        }
        panel.curves.push(Curve::new(state.name, points, look));
    }
    let description = format!(
        "Relative indentation at rest of {models} models under body weight, in order, with the limit of {limit} as a line."
    );
    let title = "Relative indentation at rest over the models";
    figure(&Figure::in_column(title, description, vec![panel]), Paper::default()).ok()
}

/// How many values are drawn at the top of the axis because they are above it.
pub(crate) fn above_the_axis(indentations: &[f64]) -> usize {
    indentations.iter().filter(|value| **value > TOP).count()
}

fn ranked(indentations: &[f64]) -> Vec<Point> {
    let mut sorted = indentations.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.iter().enumerate().map(|(rank, value)| (float(rank + 1), value.min(TOP))).collect()
}

#[expect(clippy::cast_precision_loss, reason = "models of a library")]
fn float(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_ranked_and_end_at_the_top_of_the_axis() {
        assert_eq!(ranked(&[0.3, 2.5, 0.1]), [(1.0, 0.1), (2.0, 0.3), (3.0, 1.0)]);
        assert_eq!(above_the_axis(&[0.3, 2.5, 1.0]), 1);
    }

    #[test]
    fn one_model_is_no_chart() {
        assert!(indentations(&[State { name: "", indentations: &[0.3] }]).is_none());
        let drawn = indentations(&[State { name: "after", indentations: &[0.3, 0.1] }]).unwrap();
        assert!(drawn.contains("limit, x̂ = 0.16") && drawn.contains("after"), "{drawn}");
    }
}
