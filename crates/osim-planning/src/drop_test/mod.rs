//! A body that falls on its contacts: the fall, and the register of what it shows.

mod register;
mod result;
mod run;

pub use register::{DropColumn, DropFigure, DropRow};
pub use result::{ComparedDrop, DropResult};
pub use run::run_drop_test;
