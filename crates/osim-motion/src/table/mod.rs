//! OpenSim's tables over time: `.mot` and `.sto` files.

mod data;
mod header;
mod rows;
mod times;

pub use data::{Column, Table};
pub use header::AngleUnit;
