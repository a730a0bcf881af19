//! A model before and after a change: what is known of both states before anything is written.

mod before_after;
mod both;

pub use before_after::BeforeAfter;
pub use both::States;
