//! The tests of `osim-model` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

mod loops;
mod reading;
mod words;
