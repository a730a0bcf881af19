//! Remarks when contacts are made, converted or removed, beside the numbers that change: remarks about the result,
//! questions about values that are probably in another unit, and what is refused.

mod class_age;
mod feet;
mod friction;
mod known;
mod noted_limbs;
mod planes;
mod smoothing;
mod sphere_pairs;
mod standing;
mod still_named;
mod units;

pub(crate) use class_age::too_new;
pub(crate) use feet::parts_of_feet;
pub(crate) use friction::friction_stays;
pub(crate) use known::refuse_known;
pub(crate) use noted_limbs::noted_limbs;
pub(crate) use planes::{leaning, planes_left};
pub(crate) use smoothing::{smoothed, too_smooth};
pub(crate) use sphere_pairs::dropped_pairs;
pub(crate) use standing::standing;
pub(crate) use still_named::still_named;
pub(crate) use units::{Bones, pad_slip, scale_slip};
