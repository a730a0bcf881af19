//! Units, titles, limits and remarks for the axes of figures.

use contact_plots::{Axis, Limit};
use contact_scaling::limits;
use osim_inspect::series::{
    self, ContactBody, ForceUnit, IndentationUnit, PlotUnits, SphereKind, bodies_and_kinds,
};
use osim_model::files::Failure;
use osim_model::messages::{Dialect, Phrase, counted, readable};
use osim_requests::AxesChoice;

/// The wanted units. The default is x/R, with newtons if the figure has one contact, and with shares of the weight if it has several.
pub fn units_for(bodies: &[ContactBody], wanted: Option<AxesChoice>) -> PlotUnits {
    let single = bodies_and_kinds(bodies).count() == 1;
    let indentation = match wanted {
        Some(AxesChoice::Real) => IndentationUnit::Millimetre,
        _ => IndentationUnit::Relative,
    };
    let shares = wanted.map_or(!single, |wanted| wanted == AxesChoice::Dimensionless);
    let force = if shares { ForceUnit::WeightShare } else { ForceUnit::Newton };
    PlotUnits { indentation, force }
}

/// A part of a figure, or the reason why it cannot be drawn.
pub(super) type Result<T, E = Failure> = std::result::Result<T, E>;

pub(super) fn indentation_axis(units: PlotUnits) -> Axis {
    Axis::new(match units.indentation {
        IndentationUnit::Relative => "relative indentation x̂ = x/R (–)",
        IndentationUnit::Millimetre => "indentation x (mm)",
    })
}

pub(super) fn force_axis(units: PlotUnits) -> Axis {
    Axis::new(match units.force {
        ForceUnit::Newton => "force of one sphere (N)",
        ForceUnit::WeightShare => "force of one sphere / its share Mg/n (–)",
    })
}

/// The wanted title, else a title that describes the figure.
pub(super) fn title_for(what: &str, bodies: &[ContactBody], wanted: Option<&str>) -> String {
    match (wanted, bodies) {
        (Some(title), _) => title.to_owned(),
        (None, [one]) => format!("{what}: {}", one.name),
        (None, _) => what.to_owned(),
    }
}

/// The failure that a figure of these bodies cannot be drawn.
pub(super) fn plot_failure(bodies: &[ContactBody], why: impl Into<Phrase>) -> Failure {
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    Failure::outside(names.join(", "), "plot", why)
}

/// The limit of the Hertz law as a line, if it is the same for all bodies on this axis.
pub(super) fn hertz_limit(units: PlotUnits) -> Vec<Limit> {
    match units.indentation {
        IndentationUnit::Relative => {
            let at = limits::INDENTATION.value;
            vec![Limit::vertical(format!("x̂ = {at}"), at)]
        }
        // In millimetres, each radius has another limit.
        IndentationUnit::Millimetre => vec![],
    }
}

/// Lines where the contact state is t and 1 − t (C.6).
pub(super) fn threshold_limits(kind: &SphereKind, units: PlotUnits) -> Vec<Limit> {
    let limit = |(state, at): (f64, f64)| Limit::vertical(format!("state {state}"), at);
    series::thresholds(kind, units).into_iter().map(limit).collect()
}

/// One line for each body: its mass, number of spheres and gravity, or the reason why they are not known.
pub fn weights_in_words(bodies: &[ContactBody], dialect: &dyn Dialect) -> String {
    let line = |body: &ContactBody| match &body.weight {
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
