//! The tests of `osim-inspect` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

#[allow(dead_code, unreachable_pub, reason = "osim-planning has these feet, too")]
mod feet;
mod figures;
mod load_sharing;
mod register;
