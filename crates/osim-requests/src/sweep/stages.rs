//! What is done to the model at a point: rescaled, then set, then designed, as far as the point asks.

use std::sync::Arc;

use osim_model::Assignment;
use osim_model::wording::{Input, Phrase, phrase};
use osim_model::{Property, shortest};
use osim_values::{AxisName, Kilograms, RelativeIndentation, RestitutionCoefficient};

use super::grid::Point;
use crate::planner::Planner;
use crate::request::{DesignRequest, RescaleRequest, SetRequest, SweepRequest};
use osim_options::RequestFault;

/// The plans that lead to a point, one after the other.
pub(super) type Stages = Vec<Arc<dyn Planner>>;

/// The stages of a point of a grid.
///
/// # Errors
/// Values that say nothing together.
pub(super) fn of_point(request: &SweepRequest, point: &Point<'_>) -> Result<Stages, RequestFault> {
    let (indentation, restitution) =
        (point.number(AxisName::Indentation), point.number(AxisName::Restitution));
    let wanted = &request.wanted;
    let designs =
        indentation.is_some() || restitution.is_some() || wanted.asks() || wanted.contact_stiffness.is_some();
    let mut stages = Stages::new();
    if let Some(mass) = point.number(AxisName::TargetMass) {
        if designs {
            return Err(RequestFault::general(
                "target-mass and a design (indentation, restitution, ...) contradict each other in one sweep",
            ));
        }
        stages.push(rescale(request, mass)?);
    }
    let assignments: Vec<(Property, Assignment)> = point
        .values
        .iter()
        .filter_map(|(name, value)| match name {
            AxisName::Property(property) if value.is_factor => {
                Some((*property, Assignment::Factor(value.number)))
            }
            AxisName::Property(property) => Some((*property, Assignment::Value(value.number))),
            _ => None,
        })
        .collect();
    if !assignments.is_empty() {
        stages.push(set(request, assignments)?);
    }
    if designs {
        stages.push(design(request, indentation, restitution)?);
    }
    Ok(stages)
}

/// Axes that would undo each other.
///
/// # Errors
/// Which.
pub(super) fn check(request: &SweepRequest) -> Result<(), RequestFault> {
    let has = |name: AxisName| request.grid.iter().any(|axis| axis.name == name);
    let refused = |message: Phrase| Err(RequestFault::refused(Input::Grid, message));
    for (index, axis) in request.grid.iter().enumerate() {
        if request.grid.iter().take(index).any(|other| other.name == axis.name) {
            return refused(phrase![
                Input::Grid,
                format!(" {}: given twice, expected one list of values", axis.name.as_str()),
            ]);
        }
    }
    let wanted = &request.wanted;
    for (quantity, input, given, property) in [
        (AxisName::Indentation, Input::Indentation, wanted.indentation.is_some(), Property::Stiffness),
        (AxisName::Restitution, Input::Restitution, wanted.restitution.is_some(), Property::Dissipation),
    ] {
        if has(quantity) && given {
            return refused(phrase![
                input,
                " and ",
                Input::Grid,
                format!(" {} both say what it is: leave one out", quantity.as_str()),
            ]);
        }
        if (has(quantity) || given) && has(AxisName::Property(property)) {
            return refused(
                format!("{} and {property} both say what {property} is: leave one out", quantity.as_str())
                    .into(),
            );
        }
    }
    Ok(())
}

/// `design` with what the point and the request want.
pub(super) fn design(
    request: &SweepRequest,
    indentation: Option<f64>,
    restitution: Option<f64>,
) -> Result<Arc<dyn Planner>, RequestFault> {
    let refused = |name: AxisName, number: f64| {
        move |why: String| {
            let value = format!(" {}={}: {why}", name.as_str(), shortest(number));
            RequestFault::refused(Input::Grid, phrase![Input::Grid, value])
        }
    };
    let mut wanted = request.wanted.clone();
    if let Some(x) = indentation {
        wanted.indentation = Some(RelativeIndentation::new(x).map_err(refused(AxisName::Indentation, x))?);
    }
    if let Some(restitution) = restitution {
        wanted.restitution = Some(
            RestitutionCoefficient::new(restitution).map_err(refused(AxisName::Restitution, restitution))?,
        );
    }
    let design = DesignRequest {
        wanted,
        load: request.load.clone(),
        masses: request.masses.clone(),
        counts: request.counts.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..DesignRequest::default()
    };
    design.prepare().map(|change| change.planner)
}

/// `set` with these assignments.
pub(super) fn set(
    request: &SweepRequest,
    assignments: Vec<(Property, Assignment)>,
) -> Result<Arc<dyn Planner>, RequestFault> {
    let set = SetRequest {
        models: request.model.iter().cloned().collect(),
        set: assignments.into_iter().collect(),
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..SetRequest::default()
    };
    set.prepare().map(|change| change.planner)
}

fn rescale(request: &SweepRequest, target_mass: f64) -> Result<Arc<dyn Planner>, RequestFault> {
    let target_mass =
        Kilograms::new(target_mass).map_err(|why| RequestFault::refused(Input::TargetMass, why))?;
    let rescale = RescaleRequest {
        target_mass: Some(target_mass),
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..RescaleRequest::default()
    };
    rescale.with_bodies(None).map(|change| change.planner)
}
