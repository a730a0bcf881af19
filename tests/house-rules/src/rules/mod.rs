//! The rules, each with what it finds.

mod bans;
mod circles;
mod layers;
mod options;
mod sizes;
mod words;

pub use bans::{Ban, Banned};
pub use circles::{Arrow, Circle};
pub use layers::LayerFault;
pub use options::OptionNamed;
pub use sizes::{Limits, Measured, Size, TooLarge};
pub use words::{Example, Forbidden, Words};

pub(crate) use bans::banned;
pub(crate) use circles::{arrows_of, circles};
pub(crate) use layers::layer_faults;
pub(crate) use options::options_named;
pub(crate) use sizes::{sizes, too_large};
