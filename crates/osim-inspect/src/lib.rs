//! Inspects and checks the contacts of a model: computes their figures under its weight, and finds what is wrong with them.
//!
//! ```
//! use osim_inspect::{ChangeableValues, Figure, InspectOptions, check_model};
//! use osim_model::Model;
//!
//! # fn main() -> Result<(), osim_model::Fault> {
//! let model = Model::parse(include_bytes!("../../osim-model/tests/data/one_foot.osim").as_slice())?;
//! let options = InspectOptions::default();
//! let inspected = options.inspect("one_foot.osim", &model, None);
//! let sphere = &inspected.figures.limbs[0].spheres[0];
//! assert!(sphere.value(Figure::Indentation).is_some_and(|x| x > 0.0));
//! let result = check_model(&options, &model, &inspected, &[], ChangeableValues::ASSUME_ALL);
//! assert_eq!(result.counts.error, 0);
//! # Ok(())
//! # }
//! ```
//!
//! # What it will not do
//!
//! It knows no files, no terminal and no HTML, and does not spell remedies: a remedy is a [`Request`](osim_requests::Request), which a front
//! end prints or runs.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod body_bones;
mod figures;
mod findings;
mod inspection;
mod known_contacts;
mod load;
mod place_evidence;
mod plane_judgement;
mod published_layouts;
mod quantity;
mod reach;
mod real_feet;
mod reference_contacts;
mod rules;
mod serialized;
pub mod series;
mod sides;
mod similarity;
mod verdicts;

pub use figures::{Figure, FigureVisibility, Figures, LimbFigures, LimitCheck, SphereFigures};
pub use findings::{
    ChangeableValues, CheckResult, ConsistencyRecord, CorrectedErrorRecord, Counts, FindingIndex,
    FindingWithRemedy, JointMomentsRecord, ResidualRecord, RootResidualRecord, all_findings, check_model,
    check_without_remedies, sort_findings, without_effects,
};
pub use inspection::{
    BodyAtRest, Bottom, ContactsMass, Dimensionless, InspectedBody, InspectedFactors, InspectedForce,
    InspectedLimb, InspectedSphere, Inspection, NoteStep, NoteSummary, StandingBody, StandingSphere,
};
pub use known_contacts::KnownContacts;
pub use load::{
    ContactsOrigin, InspectOptions, LoadSharing, MassMismatch, Stance, first_unexplained, unexplained_mass,
};
pub use place_evidence::{CONTACTS_ARE_EXCHANGED, SignsOfScaling};
pub use plane_judgement::weight_share_on_floor;
pub use quantity::Quantity;
pub use reference_contacts::ReferenceContacts;
pub use rules::{
    describe_unmatched_patterns, find_gravity_not_down, find_misplaced_spheres, model_findings, rules,
    ways_within_hertz,
};
#[cfg(feature = "schemas")]
pub use serialized::ObjectSchema;
pub use serialized::{FindingRecord, SCHEMA_VERSION};
pub use series::ReferenceState;
pub use sides::BothSides;
pub use similarity::{SizeList, SizeRow, SizeSpread, UnreadObjects};
pub use verdicts::{Sign, Verdict};
