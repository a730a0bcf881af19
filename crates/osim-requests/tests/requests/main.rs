//! The tests of `osim-requests` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

mod dictionaries;
