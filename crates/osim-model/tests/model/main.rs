//! The tests of `osim-model` from outside, in one program: each that is linked takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod reading;
mod sized;
mod words;
