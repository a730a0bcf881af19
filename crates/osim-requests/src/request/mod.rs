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

pub use add::{AddRequest, TransferRequest};
#[cfg(feature = "clap")]
pub(crate) use any::relations_of;
#[cfg(feature = "schemas")]
pub use any::schema_of;
pub use any::{NoteDetails, Request, silent_fields, takes};
pub use change::{ConvertRequest, RemoveRequest, RescaleRequest, SetRequest};
pub use inspect::{CheckRequest, Deny, InspectRequest, NoteRequest};
pub use knowledge::{ExplainRequest, PresetsRequest, ReproduceRequest, fig1, no_fig1};
pub use library::{BatchRequest, SweepRequest};
pub use motion::{AngleChoice, DropTestRequest, MotionFormat, MotionRequest, SeriesFormat};
pub use parameters::{BranchChoice, DesignRequest, FitRequest, FittedChoice, HeightChoice};
pub use plot::{AxesChoice, FigureOptions, HeatOptions, HeatQuantity, PlotKind, PlotRequest, QuantityChoice};
