//! What is in an OpenSim model: bodies, limbs, contact spheres and contact forces, typed, each value with its place.
//!
//! The reading direction never turns back: bytes → [`Document`] (exact spans) → [`Model`] (typed, effective values).
//! Nothing is decoded and encoded again; a [`Slot`] says where a property stands, for code that changes it
//! (the crate `osim-patch` does).
//!
//! # Where to begin
//!
//! - [`Model::parse`] reads one file, [`files::ModelFiles`] one with the files that belong to it.
//! - [`Model`] has [bodies](Body), [spheres](Sphere) and [forces](Force); each number is a [`Value`], which says where it comes
//!   from and whether its text is what it looks like.
//! - [`Selection`] chooses forces, [`MassRequest`] finds masses, [`Model::limbs`] finds limbs.
//! - What is wrong is a [`Fault`], what is odd a [`Finding`], what only the caller can know is [`Needed`].
//!
//! # What it will not do
//!
//! It knows no file system (only [`files::Files`]), no terminal and no options: what the caller can say is in messages as
//! a [`Input`](crate::messages::Input). It reads what a model says, not what OpenSim would make of a file it cannot load.

mod anatomy;
mod assignment;
mod body_facts;
mod body_shapes;
mod body_sizes;
mod class;
mod components;
mod contact_digest;
mod contacts;
mod contacts_elsewhere;
mod dissipation_by;
mod document;
mod fault;
pub mod files;
mod finding;
mod following;
mod footing_tree;
mod frames;
mod ground_planes;
mod joint_distances;
mod limbs;
mod loops;
mod made;
mod mass;
mod mass_slip;
mod masses_beside;
mod note;
mod object_name;
mod pattern;
mod property;
mod property_set;
mod radius_rule;
mod read;
mod reference_frame;
mod renumbered;
mod rules;
mod selected;
mod selection;
mod side;
mod sides;
mod sized;
mod skeleton;
mod slip;
mod typed_model;
mod value;

pub use crate::xml::opensim_text::{self, NumberFault};
pub use crate::xml::{
    Children, ElementId, LineIndex, Piece, PieceKind, Position, RawText, SyntaxFault, Tree,
};
pub use anatomy::{
    Anatomy, AnatomyJoint, AnatomySphere, AttachedMesh, CoordinateFunction, JointCoordinate, ModelJoint,
    Speeds,
};
pub use assignment::Assignment;
pub use body_sizes::ScaledSinceNote;
pub use class::Class;
pub use components::Companion;
pub use contact_digest::{ValueKey, short_digest};
pub use contacts::{
    Force, ForceId, ForceKind, FrameProperty, HalfSpace, LoadedSphere, Orientation, ParameterSet, SetId,
    Slot, Sphere, SphereId, Surfaces, contact_of_pair, contact_of_set, loaded_spheres, moving_spheres,
    root_mean_square, sphere_sets,
};
pub use dissipation_by::DissipationBy;
pub use document::{Document, may_include};
pub use fault::{
    CountOf, Excerpt, FactorQuestion, Fault, FaultKind, FileId, GravityFor, Needed, NeedsAnswer, NoteDoubt,
    Question, RadiusFrom, TreeOfForces, probable_units,
};
pub use finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
pub use following::{MovedSpheres, RadiusAxis};
pub use ground_planes::GroundPlane;
pub use joint_distances::JointDistances;
pub use limbs::{Limb, Limbs};
pub use mass::{Mass, MassRequest, MassSource, SAME_MASS, positive_mass, same_gravity, same_mass};
pub use mass_slip::MassSlip;
pub use masses_beside::MassesBeside;
pub use note::{
    BodySize, ChangedContacts, ChangedSinceNote, Credits, Note, NotedNames, NotedParts, Scope, Source, Step,
};
pub use object_name::{refuse_name, refuse_name_in_paths};
pub use pattern::{Pattern, PatternError};
pub use property::Property;
pub use property_set::PropertySet;
pub use radius_rule::RadiusRule;
pub use reference_frame::{Axis, LevelAxis, MovingPlacement, Placement, Rotation, cross};
pub use rules::RULES;
pub use selected::Selected;
pub use selection::Selection;
pub use side::{Side, without_side};
pub use sides::BothSides;
pub use sized::{Dimension, NotRead, SizedKind, SizedValue, SizedValues};
pub use skeleton::Body;
pub use slip::mass_slip;
pub use typed_model::Model;
pub use value::{Origin, Value};
