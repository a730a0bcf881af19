//! OpenSim's tables over time: `.mot` and `.sto` files.

mod data;
mod gaps;
mod header;
mod rows;
mod times;

pub use data::{Column, Table};
pub use gaps::Gap;
pub use header::AngleUnit;
