//! A design without a model: from what is known, every figure that follows, with its equation and limit.

mod at_rest;
mod calculate;
mod given;
mod register;
mod sheet;

pub use calculate::design_sheet;
pub use register::DesignQuantity;
pub use sheet::{DesignFigure, DesignLimit, DesignSheet};
