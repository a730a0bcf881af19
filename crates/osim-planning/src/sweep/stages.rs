//! What is done to the model at a point: rescaled, then set, then designed, each if the point asks for it.

use std::sync::Arc;

use osim_model::messages::{Input, phrase, shortest};
use osim_model::{Assignment, Property};
use osim_requests::{
    AxisName, DesignRequest, Kilograms, RelativeIndentation, RequestFault, RescaleRequest,
    RestitutionCoefficient, SetRequest, SweepRequest,
};

use super::grid::Point;
use crate::planner::Planner;
use crate::verbs::{design, rescale, set};

/// The plans that lead to a point, one after the other.
pub(super) type Stages = Vec<Arc<dyn Planner>>;

/// The stages of a point of a grid.
///
/// # Errors
/// Values that do not go together.
pub(super) fn of_point(request: &SweepRequest, point: &Point<'_>) -> Result<Stages, RequestFault> {
    let (indentation, restitution) =
        (point.number(AxisName::Indentation), point.number(AxisName::Restitution));
    let wanted = &request.wanted;
    let designs =
        indentation.is_some() || restitution.is_some() || wanted.asks() || wanted.contact_stiffness.is_some();
    let mut stages = Stages::new();
    if let Some(target_mass_kg) = point.number(AxisName::TargetMass) {
        if designs {
            return Err(RequestFault::general(
                "target_mass and a design (indentation, restitution, ...) contradict each other in one sweep",
            ));
        }
        stages.push(rescale(request, target_mass_kg)?);
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
    design::prepare(design).map(|change| change.planner)
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
    set::prepare(set).map(|change| change.planner)
}

fn rescale(request: &SweepRequest, target_mass_kg: f64) -> Result<Arc<dyn Planner>, RequestFault> {
    let target_mass =
        Kilograms::new(target_mass_kg).map_err(|why| RequestFault::refused(Input::TargetMass, why))?;
    let request = RescaleRequest {
        target_mass: Some(target_mass),
        masses: request.masses.clone(),
        choice: request.choice.clone(),
        answers: request.answers.clone(),
        ..RescaleRequest::default()
    };
    rescale::with_bodies(request, None).map(|change| change.planner)
}
