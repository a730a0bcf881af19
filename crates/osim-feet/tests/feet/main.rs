//! The tests of `osim-feet` from outside, in one program: each that is linked takes a second.

#![allow(missing_docs, reason = "tests have names that say it")]

mod bones;
mod given;
mod meshes;
mod pose;
mod scene;
mod soles;
