//! Why a drop test has no result.

use crate::DomainError;

/// Why a drop test has no result.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DropError {
    /// A number is outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The integration did not get through: the contact is too stiff or too dissipative for its duration.
    #[error(
        "the drop could not be followed past {time_s:?} s, expected a softer contact or a shorter duration"
    )]
    Integration {
        /// How far it got, in s.
        time_s: f64,
    },
}
