//! Units of the axes.

use contact_plots::{ForceAxis, IndentationAxis};
use osim_inspect::series::{Body, ForceUnit, IndentationUnit, Units, kinds};

/// Which units are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Axes {
    /// x/R, and force over the weight's share of one sphere.
    Dimensionless,
    /// mm and N.
    Real,
}

/// The units wanted, else those that compare well: x/R, and newtons for one contact, shares of the weight for several.
#[must_use]
pub fn units(bodies: &[Body], wanted: Option<Axes>) -> Units {
    let single = kinds(bodies).count() == 1;
    let indentation = match wanted {
        Some(Axes::Real) => IndentationUnit::Millimetre,
        _ => IndentationUnit::Relative,
    };
    let shares = wanted.map_or(!single, |wanted| wanted == Axes::Dimensionless);
    let force = if shares { ForceUnit::WeightShare } else { ForceUnit::Newton };
    Units { indentation, force }
}

pub(super) fn indentation_axis(units: Units) -> IndentationAxis {
    match units.indentation {
        IndentationUnit::Relative => IndentationAxis::Relative,
        IndentationUnit::Millimetre => IndentationAxis::Millimetre,
    }
}

pub(super) fn force_axis(units: Units) -> ForceAxis {
    match units.force {
        ForceUnit::Newton => ForceAxis::Newton,
        ForceUnit::WeightShare => ForceAxis::WeightShare,
    }
}
