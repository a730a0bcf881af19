//! Whole objects: contacts that a model gets or loses.

mod add;
mod class;
mod convert;
mod covered;
mod floor;
mod inside;
mod layout;
mod leftovers;
mod mirror;
mod names;
mod new_spheres;
mod pairs;
mod presets;
mod rebuilt;
mod references;
mod remove;
mod sets;
mod spelling;
mod whole;

pub use add::add_contacts;
pub(crate) use convert::keeps_inside;
pub use convert::{Convert, Converted, convert};
pub use layout::{Layout, NewContact};
pub use leftovers::{Leftover, leftovers};
pub use new_spheres::NewSphere;
pub use presets::{preset_model, presets_with_places};
pub(crate) use rebuilt::EarlierNote;
pub use rebuilt::{Deed, ObjectChange, Rebuilt};
pub use remove::{added_forces, remove};
