//! Remarks when contacts are made, converted or removed, beside the numbers that change: remarks about the result,
//! questions about values that are probably in another unit, and what is refused.

mod feet;
mod forces;

pub(crate) use feet::{
    Bones, leaning, noted_limbs, pad_slip, parts_of_feet, planes_left, refuse_known, scale_slip, standing,
};
pub(crate) use forces::{dropped_pairs, friction_stays, smoothed, still_named, too_new, too_smooth};
