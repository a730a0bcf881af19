//! What is done to the model at a point: rescaled, then set, then designed, as far as the point asks.

use anyhow::{Result, bail};
use osim_patch::Property;

use super::grid::{Name, Point};
use crate::args::{DesignArgs, OutputArgs, PartArgs, RescaleArgs, RunArgs, ScalingArgs, SetArgs, SweepArgs};
use crate::run::Planner;
use crate::verbs;

/// The plans that lead to a point, one after the other.
pub(super) type Stages = Vec<Box<dyn Planner>>;

/// The stages of a point of a grid.
///
/// # Errors
/// Values that say nothing together.
pub(super) fn of_point(args: &SweepArgs, point: &Point<'_>) -> Result<Stages> {
    let number = |wanted: Name| point.values.iter().find(|(name, _)| *name == wanted).map(|(_, v)| v.number);
    let (indentation, restitution) = (number(Name::Indentation), number(Name::Restitution));
    let designs = indentation.is_some() || restitution.is_some() || asks(args);
    let mut stages = Stages::new();
    if let Some(mass) = number(Name::TargetMass) {
        if designs {
            bail!(
                "target-mass and a design (indentation, restitution, ...) contradict each other in one sweep"
            );
        }
        stages.push(rescale(args, mass)?);
    }
    let assignments: Vec<String> = point
        .values
        .iter()
        .filter_map(|(name, value)| match name {
            Name::Property(property) => Some(format!("{property}={}", value.exact())),
            _ => None,
        })
        .collect();
    if !assignments.is_empty() {
        stages.push(set(args, &assignments)?);
    }
    if designs {
        stages.push(design(args, indentation, restitution)?);
    }
    Ok(stages)
}

/// Whether the call designs something at every point.
fn asks(args: &SweepArgs) -> bool {
    let wanted = &args.wanted;
    wanted.indentation.is_some()
        || wanted.restitution.is_some()
        || wanted.young.is_some()
        || wanted.constant_indentation.is_some()
        || wanted.state_width.is_some()
        || wanted.speed_width.is_some()
        || wanted.radius.is_some()
        || wanted.contact_stiffness.is_some()
}

/// Axes that would undo each other.
///
/// # Errors
/// Which.
pub(super) fn check(args: &SweepArgs) -> Result<()> {
    let has = |name: Name| args.grid.iter().any(|axis| axis.name == name);
    for (index, axis) in args.grid.iter().enumerate() {
        if args.grid.iter().take(index).any(|other| other.name == axis.name) {
            bail!("--grid {}: there twice, expected one list of values", axis.name.as_str());
        }
    }
    let wanted = &args.wanted;
    for (quantity, option, given, property) in [
        (Name::Indentation, "--indentation", wanted.indentation, Property::Stiffness),
        (Name::Restitution, "--restitution", wanted.restitution, Property::Dissipation),
    ] {
        if has(quantity) && given.is_some() {
            bail!("{option} and --grid {} both say what it is: leave one out", quantity.as_str());
        }
        if (has(quantity) || given.is_some()) && has(Name::Property(property)) {
            bail!("{} and {property} both say what {property} is: leave one out", quantity.as_str());
        }
    }
    Ok(())
}

/// `design` with what the point and the call want.
pub(super) fn design(
    args: &SweepArgs,
    indentation: Option<f64>,
    restitution: Option<f64>,
) -> Result<Box<dyn Planner>> {
    let mut wanted = args.wanted.clone();
    wanted.indentation = indentation.or(wanted.indentation);
    wanted.restitution = restitution.or(wanted.restitution);
    let verb = verbs::design::verb(DesignArgs {
        models: Vec::new(),
        wanted,
        load: args.load.clone(),
        masses: args.masses.clone(),
        counts: args.counts.clone(),
        choice: args.choice.clone(),
        output: OutputArgs::default(),
        run: RunArgs::default(),
        parts: PartArgs::default(),
    })?;
    Ok(verb.planner)
}

/// `set` with assignments such as `stiffness=x2`.
pub(super) fn set(args: &SweepArgs, assignments: &[String]) -> Result<Box<dyn Planner>> {
    let model = args.model.as_os_str().to_owned();
    let verb = verbs::set::verb(SetArgs {
        items: std::iter::once(model).chain(assignments.iter().map(Into::into)).collect(),
        masses: args.masses.clone(),
        choice: args.choice.clone(),
        output: OutputArgs::default(),
        run: RunArgs::default(),
        parts: PartArgs::default(),
    })?;
    Ok(verb.planner)
}

fn rescale(args: &SweepArgs, target_mass: f64) -> Result<Box<dyn Planner>> {
    let verb = verbs::rescale::verb(RescaleArgs {
        models: Vec::new(),
        target_mass: Some(target_mass),
        masses: args.masses.clone(),
        scaling: ScalingArgs::default(),
        choice: args.choice.clone(),
        output: OutputArgs::default(),
        run: RunArgs::default(),
        parts: PartArgs::default(),
    })?;
    Ok(verb.planner)
}
