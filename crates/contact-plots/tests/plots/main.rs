//! The tests of `contact-plots` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

#[allow(dead_code, reason = "tests/plots.rs of the project has it, too")]
mod document;
mod figures;
mod layout;
mod pictures;
mod scene;
