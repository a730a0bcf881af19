//! Changes the contacts of an OpenSim model: a plan, edits, and new bytes.
//!
//! A [`Plan`] says every number that changes: old value, new value, equation. Its [`Edit`]s replace exactly those bytes; every
//! other byte of the file stays.
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
//! # What can be wanted
//!
//! - [`rescale()`]: the model's own contacts at another mass or gravity.
//! - [`transfer()`]: the contacts of another model or of a preset, given the size of this one. Spheres of a model that OpenSim
//!   has scaled can follow their bodies ([`Follow`](osim_model::compare::Follow)).
//! - [`design()`]: parameters from what is wanted of a contact, such as its indentation or restitution.
//! - [`set()`]: plain values and factors.
//! - [`note()`]: no number changes; the mass that the contacts were made for is written down.
//!
//! # What it will not do
//!
//! It knows no file system, no terminal and no options, decodes and re-encodes nothing, never changes the document version,
//! element order or names, and never edits `<defaults>`.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod builder;
mod change;
mod design;
mod edit;
mod insert;
mod note;
mod note_edits;
mod objects;
mod plan;
mod radii;
mod rescale;
mod rules;
mod set;
mod transfer;

pub use crate::change::{ChangedBy, NumberChange, PlaceChange};
pub use crate::design::{Design, DesignModulus, design};
pub use crate::edit::{Edit, Patch, splice};
pub use crate::note::{kept_note, note, note_of_remaining, note_stance_limbs};
pub use crate::note_edits::StepDetails;
pub use crate::objects::{
    ContactLayout, Convert, Converted, DanglingReference, NewContact, NewSphere, ObjectAction, ObjectChange,
    RebuiltModel, add_contacts, added_forces, convert, dangling_references, preset_model,
    presets_with_places, remove,
};
pub use crate::plan::{Masses, Plan, RecordingErrors};
pub use crate::rescale::{
    RESCALE_FOLLOWING_NOTE, RESCALE_FOLLOWING_SCALE_FILE, Rescale, TRANSFER_FOLLOWING_BODIES, rescale,
};
pub use crate::rules::{PLACES_STAY, RULES};
pub use crate::set::{Set, set};
pub use crate::transfer::{
    Reference, ReferenceContact, ScalingRule, Transfer, reference_of_layout, reference_of_model, transfer,
};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
