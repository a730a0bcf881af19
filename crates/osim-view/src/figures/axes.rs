//! Units, titles, lines where a law ends, and remarks beside a figure.

use contact_plots::{Axis, Limit};
use contact_scaling::limits;
use osim_inspect::series::{self, Body, ForceUnit, IndentationUnit, SphereKind, Units, bodies_and_kinds};
use osim_model::files::Failure;
use osim_model::messages::{Dialect, Phrase, counted, readable};

/// Which units are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axes {
    /// x/R, and force over the weight's share of one sphere.
    Dimensionless,
    /// mm and N.
    Real,
}

/// The units wanted, else those that compare well: x/R, and newtons for one contact, shares of the weight for several.
pub fn units(bodies: &[Body], wanted: Option<Axes>) -> Units {
    let single = bodies_and_kinds(bodies).count() == 1;
    let indentation = match wanted {
        Some(Axes::Real) => IndentationUnit::Millimetre,
        _ => IndentationUnit::Relative,
    };
    let shares = wanted.map_or(!single, |wanted| wanted == Axes::Dimensionless);
    let force = if shares { ForceUnit::WeightShare } else { ForceUnit::Newton };
    Units { indentation, force }
}

pub(super) fn indentation_axis(units: Units) -> Axis {
    Axis::new(match units.indentation {
        IndentationUnit::Relative => "relative indentation x̂ = x/R (–)",
        IndentationUnit::Millimetre => "indentation x (mm)",
    })
}

pub(super) fn force_axis(units: Units) -> Axis {
    Axis::new(match units.force {
        ForceUnit::Newton => "force of one sphere (N)",
        ForceUnit::WeightShare => "force of one sphere / its share Mg/n (–)",
    })
}

/// The title wanted, else what the figure shows of whom.
pub(super) fn title(what: &str, bodies: &[Body], wanted: Option<&str>) -> String {
    match (wanted, bodies) {
        (Some(title), _) => title.to_owned(),
        (None, [one]) => format!("{what}: {}", one.name),
        (None, _) => what.to_owned(),
    }
}

/// A figure of these bodies that cannot be drawn.
pub(super) fn failure(bodies: &[Body], why: impl Into<Phrase>) -> Failure {
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    Failure::outside(names.join(", "), "plot", why)
}

// Lines where a law ends, and where contact begins.

/// The limit of the Hertz law, where the axis can show it for all bodies.
pub(super) fn hertz_limit(units: Units) -> Vec<Limit> {
    match units.indentation {
        IndentationUnit::Relative => {
            let at = limits::INDENTATION.value;
            vec![Limit::vertical(format!("x̂ = {at}"), at)]
        }
        // It is another length for each radius.
        IndentationUnit::Millimetre => vec![],
    }
}

/// Where the contact state is t and 1 − t (C.6).
pub(super) fn thresholds(kind: &SphereKind, units: Units) -> Vec<Limit> {
    let limit = |(state, at): (f64, f64)| Limit::vertical(format!("state {state}"), at);
    series::thresholds(kind, units).into_iter().map(limit).collect()
}

/// What each body is taken to weigh and to stand on, one line each; or why it is not known, if it is not needed.
pub fn weights(bodies: &[Body], dialect: &dyn Dialect) -> String {
    let line = |body: &Body| match &body.weight {
        Ok(weight) => format!(
            "{}: {} kg on {}, {} m/s2\n",
            body.name,
            readable(weight.mass_kg),
            counted(readable(weight.sphere_count), "sphere"),
            readable(weight.gravity_m_s2)
        ),
        Err(failure) => {
            let why = failure.message.spelled(dialect);
            format!("{}: its share of the weight is not drawn: {why}\n", body.name)
        }
    };
    bodies.iter().map(line).collect()
}
