//! The tests of `osim-model` from outside, in one program: each that is linked takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod loops;
mod names;
mod places;
#[allow(dead_code, reason = "other tests need more of it")]
#[path = "../../../osim-planning/tests/planning/random.rs"]
mod random;
mod reading;
mod scenery;
mod sides;
mod sized;
mod words;
