//! Spells requests in each language: a command line, Python, MATLAB, JSON, and the page.
//!
//! A [`FrontEnd`] spells whole requests, from their [dictionary](crate::Request::to_map), and the inputs and calls in a sentence.
//! No other code writes the name of an option as the user types it, so advice, calls to copy, and messages use the same words.

mod command_line;
mod json;
mod matlab;
mod page;
mod python;
mod speller;

pub use command_line::{CommandLine, shell_quoted};
pub use json::JsonRequest;
pub use matlab::Matlab;
pub use page::Page;
pub use python::{Python, python_quoted};
pub use speller::FrontEnd;
