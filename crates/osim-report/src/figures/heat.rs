//! A quantity over stiffness and dissipation.

use contact_plots::{HeatLimit, HeatMap};
use contact_scaling::limits;
use osim_inspect::series::{self, Body, HeatQuantity, HeatRequest};
use osim_model::files::Failure;
use osim_model::wording::{Input, phrase};

use super::names::failure;

/// Colours over E₁* and α for the one contact of the one body; `stiffness` and `dissipation` make axes of its own E₁* (N/m²)
/// and α (s/m).
///
/// # Errors
/// There are several bodies or contacts, the weight is not known, or the contact has no dissipation to multiply.
pub fn heat(
    bodies: &[Body],
    request: &HeatRequest,
    stiffness: impl FnOnce(f64) -> Vec<f64>,
    dissipation: impl FnOnce(f64) -> Vec<f64>,
    wanted_title: Option<&str>,
) -> Result<HeatMap, Failure> {
    let body = only(bodies)?;
    let series = series::heat(body, request, stiffness, dissipation)?;
    let words = Words::of(request.quantity);
    Ok(HeatMap {
        title: wanted_title.map_or_else(|| format!("{}: {}", words.title, body.name), str::to_owned),
        description: format!(
            "{} of {} as a colour, over stiffness E₁* and dissipation α, both on logarithmic axes.",
            words.label, body.name
        ),
        x_label: "stiffness E₁* (N/m²)".to_owned(),
        y_label: "dissipation α (s/m)".to_owned(),
        values: series.values,
        x: series.x,
        y: series.y,
        value_label: words.label.to_owned(),
        limit: series.limit.map(|at| HeatLimit { label: words.limit.clone(), at }),
        mark: Some((format!("{} now", body.name), series.now)),
    })
}

/// The one body of a figure that is about one.
fn only(bodies: &[Body]) -> Result<&Body, Failure> {
    match bodies {
        [one] => Ok(one),
        _ => {
            let why = phrase!["a sweep is about one body: name one model, without ", Input::TargetMass];
            Err(failure(bodies, why))
        }
    }
}

/// How a quantity is called.
struct Words {
    title: &'static str,
    label: &'static str,
    limit: String,
}

impl Words {
    fn of(quantity: HeatQuantity) -> Self {
        match quantity {
            HeatQuantity::Indentation => Self {
                title: "Indentation at rest",
                label: "x̂ under body weight, Hertz (–)",
                limit: format!("x̂ = {}, limit of the Hertz law", limits::INDENTATION.value),
            },
            HeatQuantity::Restitution => Self {
                title: "Restitution",
                label: "coefficient of restitution (–)",
                limit: format!("{} by (13), limit of the Hunt–Crossley law", limits::RESTITUTION.value),
            },
            HeatQuantity::PeakForce => Self {
                title: "Peak force of the drop",
                label: "peak force / body weight (–)",
                limit: String::new(),
            },
        }
    }
}
