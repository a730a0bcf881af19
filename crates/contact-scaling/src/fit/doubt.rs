//! What a fit cannot say with these data.

use super::estimate::Estimate;
use super::parameter::Parameter;

/// Below this R² the law explains less than half of what the force does.
const LITTLE: f64 = 0.5;

/// Residuals of less than this share of the largest force are those of calculated numbers.
const ROUNDING: f64 = 1e-12;

/// Why a result must not be taken as it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The law explains less than half of what the force does.
    LowRSquared {
        /// R².
        r_squared: f64,
    },
    /// The 95 % interval holds 0, or reaches below it where a value must be above: the data cannot distinguish the parameter from 0.
    Undetermined {
        /// The parameter.
        parameter: Parameter,
    },
    /// Nothing is left over, as with calculated data: how sure the parameters are is not known, and their intervals are not
    /// numbers.
    NoResiduals,
}

impl Doubt {
    /// Stable short name.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::LowRSquared { .. } => "low-r-squared",
            Self::Undetermined { .. } => "parameter-undetermined",
            Self::NoResiduals => "no-residuals",
        }
    }
}

/// Whether nothing is left over but rounding.
pub(super) fn is_exact(residuals_n: &[f64], forces_n: impl Iterator<Item = f64>) -> bool {
    let most = forces_n.fold(0.0, |most: f64, force| most.max(force.abs()));
    residuals_n.iter().all(|residual| residual.abs() <= ROUNDING * most)
}

/// What these results leave in doubt.
pub(super) fn doubts(
    r_squared: f64,
    exact: bool,
    estimates: &[(Parameter, Option<&Estimate>)],
) -> Vec<Doubt> {
    let low = (r_squared < LITTLE).then_some(Doubt::LowRSquared { r_squared });
    let holds_zero = |estimate: &Estimate| estimate.low <= 0.0 && estimate.high >= 0.0;
    let undetermined = estimates
        .iter()
        .filter(|(_, estimate)| estimate.is_some_and(holds_zero))
        .map(|&(parameter, _)| Doubt::Undetermined { parameter });
    low.into_iter().chain(undetermined).chain(exact.then_some(Doubt::NoResiduals)).collect()
}
