//! Numbers and ranges as people type them.

mod blanks;
mod decimal;
mod range;

pub use blanks::trimmed;
pub use decimal::{
    LENGTHS, MASSES, UnitSpelling, converted, factor, not_negative, number, number_in, plain, positive,
    positive_number,
};
pub use range::{Range, respelled, spaced, with_colons};
