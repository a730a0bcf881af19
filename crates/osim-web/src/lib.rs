//! What is Rust of the page in `web/`: files in memory, questions in JSON, answers in JSON.
//!
//! It binds and computes nothing itself. The page puts the bytes of files into an [`Engine`] and asks it [`EngineQuestion`]s; what
//! comes back is JSON with HTML of the report's renderer in it, and the bytes of changed files.
//!
//! # What it will not do
//!
//! It knows no browser: no element, no event, no address. Those are the page's, in `web/src/`.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod change;
mod engine;
mod given_files;
mod knowledge;
mod look;
mod problem;

pub use crate::engine::Engine;
pub use crate::knowledge::EngineQuestion;
