//! The tests of `osim-model` from outside, in one program: linking each separate program would take a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod reading;
mod sized;
mod words;
