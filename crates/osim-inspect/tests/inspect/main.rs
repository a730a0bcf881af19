//! The tests of `osim-inspect` from outside, in one program: each that is linked takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[allow(dead_code, unreachable_pub, reason = "osim-planning has these feet, too")]
mod feet;
mod figures;
mod load_sharing;
mod register;
