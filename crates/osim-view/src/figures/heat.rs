//! Heat maps: a quantity as colours over two parameters, or as a curve over one parameter.

use contact_plots::{Axis, Curve, Drawing, Figure, HeatLimit, HeatMap, Limit, Look, Mark, Panel, Point};
use contact_scaling::limits;
use osim_inspect::series::{self, ContactBody, HeatParameter, Profile};
use osim_model::files::Failure;
use osim_model::least_and_most;
use osim_model::messages::{Input, phrase};
use osim_planning::HeatTable;
use osim_requests::QuantityChoice;
use osim_requests::options::FallOptions;

use crate::figures::axes::{Result, plot_failure};

/// A heat map over E₁* and α for the only contact of the only body. The functions `stiffness` and `dissipation` make the axes from its own
/// E₁* (N/m²) and α (s/m). If only one of the two changes the quantity, the figure is a curve over that parameter.
///
/// # Errors
/// There are several bodies or contacts, the weight is not known, or the dissipation is 0 and has no multiples.
pub fn heat(
    bodies: &[ContactBody],
    quantity: QuantityChoice,
    fall: &FallOptions,
    stiffness: impl FnOnce(f64) -> Vec<f64>,
    dissipation: impl FnOnce(f64) -> Vec<f64>,
    wanted_title: Option<&str>,
) -> Result<Drawing> {
    let [body] = bodies else {
        let why = phrase!["a sweep is about one body: name one model, without ", Input::TargetMass];
        return Err(plot_failure(bodies, why));
    };
    let series = series::heat(body, quantity, fall, stiffness, dissipation)?;
    let words = QuantityWords::of_quantity(quantity);
    let title = wanted_title.map_or_else(|| format!("{}: {}", words.title, body.name), str::to_owned);
    if let Some(profile) = series.profile {
        return Ok(Drawing::Panels(curve_figure(profile, series.limit, &words, title, &body.name)));
    }
    Ok(Drawing::HeatMap(HeatMap {
        title,
        description: format!(
            "{} of {} as a colour, over stiffness E₁* and dissipation α, both on logarithmic axes.",
            words.label, body.name
        ),
        x_axis: Axis::logarithmic(STIFFNESS_LABEL),
        y_axis: Axis::logarithmic(DISSIPATION_LABEL),
        value_axis: value_axis(words.label, &series.values),
        values: series.values,
        x: series.x,
        y: series.y,
        limit: series.limit.map(|at| HeatLimit { label: words.limit.clone(), at }),
        mark: Some((format!("{} now", body.name), series.present)),
    }))
}

/// The label of an axis of stiffness.
const STIFFNESS_LABEL: &str = "stiffness E₁* (N/m²)";
/// The label of an axis of dissipation.
const DISSIPATION_LABEL: &str = "dissipation α (s/m)";
/// Colours are logarithmic if the largest value over the smallest is more than this.
const LOGARITHMIC_RATIO: f64 = 8.0;

/// The axis of colours for the values of a heat map.
pub(super) fn value_axis(label: &str, values: &[Vec<Option<f64>>]) -> Axis {
    let (low, high) = least_and_most(values.iter().flatten().flatten().copied());
    if low > 0.0 && high > LOGARITHMIC_RATIO * low { Axis::logarithmic(label) } else { Axis::new(label) }
}

/// The figure of a quantity over the only parameter that changes it.
fn curve_figure(
    profile: Profile,
    limit: Option<f64>,
    words: &QuantityWords,
    title: String,
    body: &str,
) -> Figure {
    let (axis, other) = match profile.along {
        HeatParameter::Stiffness => (STIFFNESS_LABEL, "dissipation α"),
        HeatParameter::Dissipation => (DISSIPATION_LABEL, "stiffness E₁*"),
    };
    let mut panel = Panel::new("", Axis::logarithmic(axis), Axis::new(words.label));
    panel.curves.push(Curve::new(words.curve, profile.points, Look::HERTZ));
    panel.marks.extend(profile.present.map(|at| Mark { label: format!("{body} now"), at, look: Look::OWN }));
    panel.limits.extend(limit.map(|at| Limit::horizontal(&words.limit, at)));
    let description = format!(
        "{} of {body} over {axis}, on a logarithmic axis. It does not depend on the {other}, so it is a curve and no \
         heat map.",
        words.label
    );
    Figure::in_column(title, description, vec![panel])
}

/// Texts about the quantity of a heat map.
struct QuantityWords {
    title: &'static str,
    label: &'static str,
    /// Name of the quantity's curve in the legend.
    curve: &'static str,
    limit: String,
}

impl QuantityWords {
    fn of_quantity(quantity: QuantityChoice) -> Self {
        match quantity {
            QuantityChoice::Indentation => Self {
                title: "Indentation at rest",
                label: "x̂ under body weight, Hertz (–)",
                curve: "at rest, by (11)",
                limit: format!("x̂ = {}, limit of the Hertz law", limits::INDENTATION.value),
            },
            QuantityChoice::Restitution => Self {
                title: "Restitution",
                label: "coefficient of restitution (–)",
                curve: "exact, at the impact speed",
                limit: format!("{} by (13), limit of the Hunt–Crossley law", limits::RESTITUTION.value),
            },
            QuantityChoice::PeakForce => Self {
                title: "Peak force of the drop",
                label: "peak force / body weight (–)",
                curve: "in the drop",
                limit: String::new(),
            },
        }
    }
}

/// A figure of a column of a table: a heat map over two columns that vary, or a curve over one.
///
/// # Errors
/// No column varies, two rows are about one point, or no row has a number in all columns.
pub(super) fn table_figure(table: &HeatTable, wanted_title: Option<&str>) -> Result<Drawing> {
    let failed = |why: String| Failure::outside(&table.name, "plot", why);
    let title = wanted_title.map_or_else(|| format!("{}: {}", table.value.name, table.name), str::to_owned);
    let x = distinct_values(&table.x.values);
    let y =
        table.y.as_ref().map(|column| (column, distinct_values(&column.values))).filter(|(_, y)| y.len() > 1);
    match y {
        _ if x.len() < 2 => Err(failed(format!(
            "the column '{}' has {} value, expected two or more: choose another for the horizontal axis",
            table.x.name,
            x.len()
        ))),
        Some((column, y)) => {
            let values = grid_of_values(table, &column.values, (&x, &y)).map_err(failed)?;
            Ok(Drawing::HeatMap(HeatMap {
                title,
                description: format!(
                    "The column {} of {} as a colour, over {} and {}.",
                    table.value.name, table.name, table.x.name, column.name
                ),
                x_axis: axis_for_values(&table.x.name, &x),
                y_axis: axis_for_values(&column.name, &y),
                value_axis: value_axis(&table.value.name, &values),
                x,
                y,
                values,
                limit: None,
                mark: None,
            }))
        }
        None => {
            let mut panel = Panel::new("", axis_for_values(&table.x.name, &x), Axis::new(&table.value.name));
            let points = points_of_table(table).map_err(failed)?;
            panel.curves.push(Curve::new("", points, Look::HERTZ));
            let description =
                format!("The column {} of {} over {}.", table.value.name, table.name, table.x.name);
            Ok(Drawing::Panels(Figure::in_column(title, description, vec![panel])))
        }
    }
}

/// The values of a column without repetitions, sorted.
fn distinct_values(values: &[Option<f64>]) -> Vec<f64> {
    let mut values: Vec<f64> = values.iter().flatten().copied().collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// An axis for the values: logarithmic if their ratios are more alike than their differences, else linear.
fn axis_for_values(name: &str, values: &[f64]) -> Axis {
    let spread = |steps: Vec<f64>| {
        let (low, high) = steps
            .into_iter()
            .fold((f64::INFINITY, 0.0_f64), |(low, high), step| (low.min(step), high.max(step)));
        high / low
    };
    let differences = spread(values.windows(2).map(|pair| pair[1] - pair[0]).collect());
    let ratios = || spread(values.windows(2).map(|pair| (pair[1] / pair[0]).ln()).collect());
    let is_positive = values.first().is_some_and(|first| *first > 0.0);
    if is_positive && ratios() < differences { Axis::logarithmic(name) } else { Axis::new(name) }
}

/// The value of the table at each point of the grid; `None` if the table has no value for the point.
fn grid_of_values(
    table: &HeatTable,
    y_values: &[Option<f64>],
    (x, y): (&[f64], &[f64]),
) -> Result<Vec<Vec<Option<f64>>>, String> {
    let mut cells = vec![vec![None; x.len()]; y.len()];
    let mut seen = vec![vec![false; x.len()]; y.len()];
    for (row, (at_x, at_y)) in table.x.values.iter().zip(y_values).enumerate() {
        let place = |values: &[f64], at: f64| values.binary_search_by(|value| value.total_cmp(&at)).ok();
        let (Some(at_x), Some(at_y)) = (*at_x, *at_y) else { continue };
        let place_in_grid = place(x, at_x).zip(place(y, at_y));
        let Some((cell, seen)) = place_in_grid.and_then(|(column, line)| {
            Some((cells.get_mut(line)?.get_mut(column)?, seen.get_mut(line)?.get_mut(column)?))
        }) else {
            continue;
        };
        if std::mem::replace(seen, true) {
            return Err(fault_of_repeated_point(&format!("{} = {at_x}, {at_y}", table.x.name)));
        }
        *cell = table.value.values.get(row).copied().flatten();
    }
    Ok(cells)
}

/// The points of a curve, from left to right.
fn points_of_table(table: &HeatTable) -> Result<Vec<Point>, String> {
    let pairs = table.x.values.iter().zip(&table.value.values);
    let mut points: Vec<Point> = pairs.filter_map(|(x, value)| Some(((*x)?, (*value)?))).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    match points.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(pair) => Err(fault_of_repeated_point(&format!("{} = {}", table.x.name, pair[0].0))),
        None => Ok(points),
    }
}

fn fault_of_repeated_point(point: &str) -> String {
    format!(
        "several rows are about {point}: other columns vary, too, so leave rows out, or choose other columns for the axes"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_follow_the_spacing_of_their_values() {
        assert!(axis_for_values("E", &[1e5, 1e6, 1e7]).logarithmic);
        assert!(!axis_for_values("x", &[1.0, 2.0, 3.0]).logarithmic);
        assert!(!axis_for_values("x", &[0.0, 1.0, 10.0]).logarithmic);
        assert!(!axis_for_values("x", &[-1.0, 1.0]).logarithmic);
    }
}
