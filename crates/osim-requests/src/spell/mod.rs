//! How each language spells what can be asked: a command line, Python, MATLAB, JSON, and the page.
//!
//! A [`Speller`] spells whole requests, from their [dictionary](crate::Request::to_map), and the inputs and calls in a sentence. Nothing
//! else may name an option as it is typed. So a remedy, a call to copy, and a message say the same thing in the same words.

mod command_line;
mod fields;
mod front_end;
mod json;
mod matlab;
mod page;
mod python;
mod shell;
mod speller;

pub use command_line::CommandLine;
pub use front_end::FrontEnd;
pub use json::JsonRequest;
pub use matlab::Matlab;
pub use page::Page;
pub use python::{Python, python_quoted};
pub use shell::shell_quoted;
pub use speller::Speller;
