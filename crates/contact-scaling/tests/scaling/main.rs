//! The tests of `contact-scaling` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

mod drop_test;
mod equations;
mod fit;
mod register;
mod table1;
