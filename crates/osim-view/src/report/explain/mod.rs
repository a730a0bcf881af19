//! Explanations of equations, quantities, findings and errors.

mod equations;
mod errors;
mod record;
mod text;
mod topic;
mod traps;

pub use equations::{equation, equations};
pub use errors::{ErrorCode, ErrorGroup, error, errors};
pub use record::{FormulaRecord, SymbolRecord, TopicRecord, answer};
pub use text::{Alphabet, list, text};
pub use topic::{QuantityTopic, Topic, UnknownTopic};
