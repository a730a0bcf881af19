//! The Rust part of the web page in `web/`: files in memory, calls in JSON, answers in JSON.
//!
//! The crate only calls the other crates and computes nothing itself. The page puts the bytes of files into an [`Engine`] and makes
//! [`EngineCall`]s. The answers are JSON, which contains HTML as in reports; the bytes of changed files can be fetched, too.
//!
//! # What it will not do
//!
//! The crate does not use the browser: elements, events and addresses belong to the code in `web/src/`.
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod change;
mod engine;
mod given_files;
mod knowledge;
mod opened_model;
mod problem;
mod recording;

pub use crate::engine::Engine;
pub use crate::knowledge::EngineCall;
