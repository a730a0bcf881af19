//! Whole objects: contacts that a model gets or loses.

mod add;
mod convert;
mod layout;
mod rebuilt;
mod remove;
mod sets;
mod spelling;

pub use add::{NewSphere, add_contacts};
pub(crate) use convert::keeps_inside;
pub use convert::{Convert, Converted, convert};
pub use layout::{Layout, NewContact, preset_model, presets_with_places};
pub(crate) use rebuilt::EarlierNote;
pub use rebuilt::{Deed, ObjectChange, Rebuilt};
pub use remove::{Leftover, added_forces, leftovers, remove};
