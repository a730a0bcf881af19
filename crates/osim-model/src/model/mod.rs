//! The contents of an OpenSim model as typed data: bodies, limbs, contact spheres and contact forces, each value with its place in the
//! file.
//!
//! Reading goes in one direction: bytes → [`Document`] (exact places) → [`Model`] (typed, effective values). No file is decoded and encoded
//! again: a [`Slot`] is the place of a property, for code that changes it (the crate `osim-patch`).
//!
//! # Where to begin
//!
//! - [`Model::parse`] reads a model from one file, [`crate::model::files::ModelFiles`] a model from several files.
//! - [`Model`] has [bodies](Body), [spheres](Sphere) and [forces](Force). Each number is a [`Value`], with its origin and the fault of its
//!   text, if there is one.
//! - [`Selection`] chooses forces, [`MassRequest`] finds masses, [`Model::limbs`] finds limbs.
//! - A [`Fault`] is an error, a [`Finding`] an unusual property of a model, [`MissingFact`] a fact that only the caller knows.
//!
//! # What it will not do
//!
//! This module knows no file system (only [`crate::model::files::Files`]), no terminal and no options: inputs in messages are data, an
//! [`Input`](crate::messages::Input). It reads the contents of a model; it does not predict what OpenSim would do with a file that OpenSim
//! cannot load.

mod anatomy;
mod body_sizes;
mod choices;
mod components;
mod contact_digest;
mod contacts;
mod document;
mod fault;
pub mod files;
mod finding;
mod limbs;
mod mass;
mod names_and_sides;
mod note;
mod numbers_with_units;
mod placement;
mod property;
mod read;
pub(crate) mod rules;
mod skeleton;
mod typed_model;

pub use crate::xml::opensim_text::{self, NumberFault};
pub use crate::xml::{
    Children, ElementId, LineIndex, Piece, PieceKind, RawText, SyntaxFault, TextPosition, Tree,
};
pub use anatomy::bone_sizes::{BoneLengths, TriplesByBody};
pub use anatomy::{
    Anatomy, AnatomyJoint, AnatomySphere, CoordinateFunction, JointCoordinate, ModelJoint, Speeds,
    rounding_of_places_m,
};
pub use body_sizes::{AttachedMesh, BodyShape, ScaledSinceNote};
pub use choices::{
    Assignment, DissipationBy, MovedSpheres, PropertySet, RadiusAxis, RadiusRule, Selected, Selection,
};
pub use components::{Companion, Component, ComponentId, ComponentTree, Components, component_classes};
pub use contact_digest::{ValueKey, short_digest};
pub use contacts::{
    Force, ForceId, ForceKind, FrameProperty, GEOMETRY_CLASSES, GroundPlane, HalfSpace, Irregularity,
    LAST_VERSION_WITH_IS_DISABLED, LoadedSphere, OTHER_CONTACT_CLASSES, Orientation, ParameterSet, SetId,
    Slot, Sphere, SphereId, Surfaces, contact_of_pair, contact_of_set, loaded_round_spheres, loaded_spheres,
    moving_spheres, radius_of_equal_volume, root_mean_square, sphere_sets,
};
pub use document::Document;
pub use fault::{
    CountedSpheres, Excerpt, Fault, FaultKind, FileId, ForcesOfAnimal, GravityFor, MassMistake,
    MassesOfOtherRows, MissingFact, NoteDoubt, RadiusChangeReason, Result, Suspicion, UnknownFactors,
    YesQuestion, advice_on_units, probable_units,
};
pub use finding::{Example, Finding, FindingCode, Measure, Repair, Rule, Severity, VerdictTopic};
pub use limbs::{Limb, Limbs};
pub use mass::{
    Mass, MassRequest, MassSource, are_equal_gravities, are_equal_masses, implausible_mass, is_at_target,
    positive_mass,
};
pub use names_and_sides::{
    Pattern, PatternError, Side, has_word, nearest_names, refuse_name, refuse_name_in_paths, without_side,
};
pub use note::{
    BodySize, ChangedContacts, ChangedSinceNote, Credits, Note, NotedNames, NotedParts, Scope, Source, Step,
};
pub use numbers_with_units::{Dimension, NotRead, SizedKind, SizedValue, SizedValues};
pub use placement::{Axis, LevelAxis, MovingPlacement, Placement, Rotation, angle_between, least_and_most};
pub use property::{Class, Property, Value, ValueOrigin};
pub use rules::RULES;
pub use skeleton::{Body, Loops, Skeleton};
pub use typed_model::Model;
