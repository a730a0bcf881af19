//! Numbers and ranges as people type them.

mod decimal;
mod range;

pub use decimal::{
    LENGTHS, MASSES, UnitSpelling, converted, factor, number, number_in, plain, positive, positive_number,
};
pub use range::{Range, respelled, spaced, with_colons};
