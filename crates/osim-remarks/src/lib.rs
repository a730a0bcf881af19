//! What is to be said when contacts are made, converted or removed, beside the numbers that change: remarks about the result,
//! questions about values that are probably in another unit, and what is refused.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod class_age;
mod known;
mod planes;
mod smoothing;
mod sphere_pairs;
mod standing;
mod still_named;
mod units;

pub use class_age::too_new;
pub use known::refuse_known;
pub use planes::{leaning, planes_left};
pub use smoothing::{smoothed, too_smooth};
pub use sphere_pairs::dropped_pairs;
pub use standing::standing;
pub use still_named::{shortened, still_named};
pub use units::{Bones, Distance, pad_slip, scale_slip};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
