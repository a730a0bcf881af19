//! Changes the contacts of an OpenSim model: a plan, edits, and new bytes.
//!
//! A [`Plan`] lists every number that changes: old value, new value, equation. Its [`Edit`]s replace exactly the bytes of these
//! numbers; all other bytes of the file stay.
//!
//! ```
//! use osim_model::{FileId, MassRequest, Model, Selection};
//! use osim_patch::{Rescale, rescale};
//!
//! # fn main() -> Result<(), osim_model::Fault> {
//! let bytes = include_bytes!("../../osim-model/tests/data/one_foot.osim");
//! let model = Model::parse(bytes.as_slice())?;
//! let selected = Selection::default().apply(&model)?;
//! let (contacts_mass, _findings) = MassRequest::default().contacts_mass(&model)?;
//! let plan = rescale(&model, &selected, &Rescale::new(8.0 * contacts_mass.kg, contacts_mass))?;
//! // Eight times the mass is twice the length, and twice the stiffness (10).
//! assert_eq!(plan.changes[0].to, 2.0 * plan.changes[0].from);
//! let patched = plan.patched(&model, FileId::MAIN)?;
//! # assert_ne!(patched, bytes);
//! # Ok(())
//! # }
//! ```
//!
//! # Changes that can be planned
//!
//! - [`rescale()`]: the model's own contacts at another mass or gravity.
//! - [`transfer()`]: the contacts of another model or of a preset, scaled to the size of this model. If OpenSim has scaled the
//!   model, its spheres can move and grow with their bodies ([`Follow`](osim_model::compare::Follow)).
//! - [`design()`]: parameters from the wanted behaviour of a contact, such as its indentation or restitution.
//! - [`set()`]: given values and factors.
//! - [`note()`]: no number changes; the mass that the contacts were made for is written into the file.
//!
//! # Limits
//!
//! This crate reads and writes no files and knows no terminal and no options. It does not decode and encode a file again. It
//! never changes the document version, the order of elements or names, and never edits `<defaults>`.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod builder;
mod change;
mod design;
mod edit;
mod insert;
mod new_radii;
mod note;
mod note_edits;
mod objects;
mod plan;
mod rescale;
mod rules;
mod set;
mod transfer;

pub use crate::change::{ChangedBy, NumberChange, PlaceChange};
pub use crate::design::{Design, DesignModulus, design, indentation_of_stress};
pub use crate::edit::{Edit, Patch, splice};
pub use crate::note::{kept_note, note, note_of_remaining, note_stance_limbs};
pub use crate::note_edits::StepDetails;
pub use crate::objects::{
    ContactLayout, Convert, Converted, DanglingReference, NewContact, NewSphere, ObjectAction, ObjectChange,
    RebuiltModel, add_contacts, added_forces, connect_sockets, convert, dangling_references, preset_model,
    presets_with_places, remove,
};
pub use crate::plan::{FittedFoot, FittedNumber, Masses, Plan, RecordingErrors};
pub use crate::rescale::{
    OPERATION_FOLLOWING_BODIES, OPERATION_FOLLOWING_NOTE, OPERATION_FOLLOWING_SCALE_FILE, Rescale, rescale,
};
pub use crate::rules::{REMARK_PLACES_STAY, RULES, forms_of_dissipation};
pub use crate::set::{Set, set};
pub use crate::transfer::{
    Reference, ReferenceContact, ScalingRule, Transfer, reference_of_layout, reference_of_model, transfer,
};

/// The example of the README, which must compile.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
