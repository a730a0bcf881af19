//! The chart of relative indentations at rest of many models.

use contact_plots::{Axis, Curve, Figure, Limit, Look, Mark, Panel, Paper, Point, figure};
use contact_scaling::limits;

/// End of the axis of x̂. Larger values, which are wrong anyway, are drawn there.
const END_OF_AXIS: f64 = 1.0;
/// Models have dots if there are at most this many.
const MOST_MODELS_WITH_DOTS: usize = 60;

/// x̂ at rest of all models in one state.
pub struct State<'s> {
    /// The name in the legend.
    pub name: &'s str,
    /// Relative indentation x̂ = x/R of the deepest sphere of each model.
    pub indentations: &'s [f64],
}

/// The chart of x̂ of models, sorted in each state, with the limit of the Hertz law; `None` if no state has two models.
pub fn indentations(states: &[State<'_>]) -> Option<String> {
    let models = states.iter().map(|state| state.indentations.len()).max().filter(|models| *models > 1)?;
    let limit = limits::INDENTATION.value;
    let mut panel = Panel::new(
        "",
        Axis::over("models, in order of x̂", 0.0, as_number(models + 1)),
        Axis::new("x̂ = x/R at rest (–)"),
    );
    panel.limits.push(Limit::horizontal(format!("limit, x̂ = {limit}"), limit));
    let drawn = states.iter().enumerate().filter(|(_, state)| state.indentations.len() > 1);
    for (index, state) in drawn {
        let (look, points) = (Look::series(index), ranked_points(state.indentations));
        if points.len() <= MOST_MODELS_WITH_DOTS {
            // The legend names the curve; its dots have no name.
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

/// The number of values that are drawn at the end of the axis because they are above it.
pub(crate) fn count_above_axis(indentations: &[f64]) -> usize {
    indentations.iter().filter(|value| **value > END_OF_AXIS).count()
}

fn ranked_points(indentations: &[f64]) -> Vec<Point> {
    let mut sorted = indentations.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.iter().enumerate().map(|(rank, value)| (as_number(rank + 1), value.min(END_OF_AXIS))).collect()
}

#[expect(clippy::cast_precision_loss, reason = "models of a library")]
fn as_number(count: usize) -> f64 {
    count as f64
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
        assert!(indentations(&[State { name: "", indentations: &[0.3] }]).is_none());
        let drawn = indentations(&[State { name: "after", indentations: &[0.3, 0.1] }]).unwrap();
        assert!(drawn.contains("limit, x̂ = 0.16") && drawn.contains("after"), "{drawn}");
    }
}
