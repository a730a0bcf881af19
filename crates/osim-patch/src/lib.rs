//! Bytes of an OpenSim model in; contacts, plan and patched bytes out.
//!
//! The reading direction never turns back:
//!
//! bytes → [`Document`] (exact spans) → [`Model`] (typed, effective values) → [`Plan`] (old value, new value, equation)
//! → [`Edit`]s → bytes.
//!
//! ```
//! use osim_patch::{Document, MassRequest, Model, Rescale, RadiusRule, Selection};
//!
//! # fn main() -> Result<(), osim_patch::Fault> {
//! let bytes = include_bytes!("../tests/data/one_foot.osim");
//! let document = Document::parse(bytes)?;
//! let model = Model::read(&document)?;
//! let selected = Selection::default().apply(&model)?;
//! let contacts_mass = MassRequest::default().of_contacts(&model, &mut Vec::new())?;
//! let plan = osim_patch::rescale(&model, &selected, &Rescale {
//!     target_mass_kg: 8.0 * contacts_mass.kg,
//!     contacts_mass,
//!     radius: RadiusRule::Isometric,
//!     properties: Default::default(),
//!     dissipation_by: Default::default(),
//!     target_gravity_m_s2: None,
//!     contacts_gravity_m_s2: None,
//!     level: None,
//! })?;
//! // Eight times the mass is twice the length, and twice the stiffness (10).
//! assert_eq!(plan.changes[0].to, 2.0 * plan.changes[0].from);
//! let patched = plan.patched(&model, 0)?;
//! # assert_ne!(patched, bytes);
//! # Ok(())
//! # }
//! ```
//!
//! # What it will not do
//!
//! It knows no file system and no terminal, decodes and re-encodes nothing, never changes the document version, element
//! order or names, and never edits `<defaults>`. It reads what a model says, not what OpenSim would make of a file it
//! cannot load.

mod document;
mod edit;
mod error;
mod follow;
mod insert;
mod mass;
mod model;
mod note;
mod number;
mod plan;
mod property;
mod select;
mod warning;
mod xml;

pub use document::{Document, Origin, Value, may_include};
pub use edit::{Edit, Patch, splice};
pub use error::{Fault, FaultKind, NumberFault, SyntaxFault};
pub use follow::{
    Anatomy, AnatomySphere, AxisFactor, BodyFactors, FactorSource, Factors, Follow, FollowRequest, Followed,
    LevelAxis, MovedSpheres, RadiusAxis, ScaleFile,
};
pub use mass::{Mass, MassRequest, MassSource, SAME_MASS, same_mass};
pub use model::{Body, Force, ForceKind, Limb, Limbs, Model, ParameterSet, Part, Side, Sphere};
pub use note::{Note, Scope};
pub use number::{readable, shortest};
pub use plan::{
    Assignment, Change, Design, DesignModulus, DissipationBy, LoadedSphere, Masses, Move, Plan, PropertySet,
    RadiusRule, Reference, ReferenceContact, Rescale, ScalingRule, Set, Transfer, design, loaded_spheres,
    moving_spheres, reference_of_model, rescale, set, transfer,
};
pub use property::Property;
pub use select::{Selected, Selection};
pub use warning::{Seen, Severity, Warning, WarningCode};
pub use xml::{Children, Element, ElementId, LineIndex, Piece, PieceKind, Position, Tree};
