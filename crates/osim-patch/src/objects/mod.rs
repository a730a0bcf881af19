//! Adds, removes and converts whole contact objects.

mod add;
mod convert;
mod layout;
mod nodes;
mod rebuilt;
mod remove;
mod sets;

pub use add::{NewSphere, add_contacts};
pub(crate) use convert::keeps_sphere_inside;
pub use convert::{Convert, Converted, convert};
pub use layout::{ContactLayout, NewContact, preset_model, presets_with_places};
pub(crate) use rebuilt::EarlierNote;
pub use rebuilt::{ObjectAction, ObjectChange, RebuiltModel};
pub use remove::{DanglingReference, added_forces, dangling_references, remove};
pub use sets::connect_sockets;
