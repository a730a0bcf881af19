//! The tests of `osim-patch` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

mod choices;
mod consequences;
mod convert;
mod edits;
mod given;
mod notes;
mod objects;
mod plan;
mod refusals;
mod round_trip;
mod standing;
