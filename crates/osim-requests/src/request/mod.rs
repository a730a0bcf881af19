//! A request for each verb: everything that can be asked, typed.

mod add;
mod any;
mod convert;
mod design;
mod drop_test;
mod fig1;
mod figure;
mod fit;
mod inspect;
mod knowledge;
mod library;
mod motion;
mod note;
mod noted;
mod plot;
mod remove;
mod reproduce;
mod rescale;
mod set;
mod sweep_points;
mod transfer;

pub use add::AddRequest;
#[cfg(feature = "clap")]
pub(crate) use any::relations_of;
#[cfg(feature = "schemas")]
pub use any::schema_of;
pub use any::{Request, silent_fields, takes};
pub use convert::ConvertRequest;
pub use design::DesignRequest;
pub use drop_test::{DropTestRequest, SeriesFormat};
pub use fig1::{fig1, no_fig1};
pub use figure::{FigureOptions, HeatOptions, HeatQuantity, QuantityChoice};
pub use fit::{BranchChoice, FitRequest, FittedChoice, HeightChoice};
pub use inspect::{CheckRequest, Deny, InspectRequest};
pub use knowledge::{ExplainRequest, PresetsRequest};
pub use library::{BatchRequest, SweepRequest};
pub use motion::{AngleChoice, MotionFormat, MotionRequest};
pub use note::NoteRequest;
pub use noted::NoteDetails;
pub use plot::{AxesChoice, PlotKind, PlotRequest};
pub use remove::RemoveRequest;
pub use reproduce::ReproduceRequest;
pub use rescale::RescaleRequest;
pub use set::SetRequest;
pub use transfer::TransferRequest;
