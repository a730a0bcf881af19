//! A request for each verb: everything that can be asked, typed.

mod add;
mod any;
mod change;
mod inspect;
mod knowledge;
mod library;
mod motion;
mod parameters;
mod plot;
mod verbs;

pub use add::{AddRequest, TransferRequest};
pub use any::NoteDetails;
pub use change::{ConvertRequest, RemoveRequest, RescaleRequest, SetRequest};
pub use inspect::{CheckRequest, Deny, InspectRequest, NoteRequest};
pub use knowledge::{ExplainRequest, PresetsRequest, ReproduceRequest, fig1, no_fig1};
pub use library::{BatchRequest, SweepRequest};
pub use motion::{AngleChoice, DropTestRequest, MotionFormat, MotionRequest, SeriesFormat};
pub use parameters::{BranchChoice, DesignRequest, FitRequest, FittedChoice, HeightChoice};
pub use plot::{AxesChoice, FigureOptions, HeatOptions, HeatQuantity, PlotKind, PlotRequest, QuantityChoice};
#[cfg(feature = "clap")]
pub(crate) use verbs::check_value;
#[cfg(any(feature = "clap", feature = "schemas"))]
pub(crate) use verbs::relations_of;
#[cfg(feature = "schemas")]
pub(crate) use verbs::type_schema;
pub(crate) use verbs::verb_title;
pub use verbs::{CHANGING, Request, VerbEntry, VerbGroup, silent_fields, takes, verb_entry};
