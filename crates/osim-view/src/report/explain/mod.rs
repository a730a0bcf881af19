//! What an equation says, and what a warning or an error means and asks for.

mod answer;
mod ascii;
mod equations;
mod errors;
mod letters;
mod quantities;
mod record;
mod rules;
mod text;
mod topic;
mod traps;
mod uses;

pub use answer::answer;
pub use equations::{equation, equations};
pub use errors::{ErrorCode, ErrorGroup, error, errors};
pub use letters::Letters;
pub use quantities::QuantityTopic;
pub use record::{FormulaRecord, SymbolRecord, TopicRecord};
pub use text::{list, text};
pub use topic::{Topic, UnknownTopic};
pub use uses::uses;
