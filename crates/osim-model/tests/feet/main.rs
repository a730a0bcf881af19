//! The tests of `osim_model::feet` from outside, in one program: linking each separate program would take a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod bones;
mod fixture_folder;
mod foot_view;
mod level_feet;
mod meshes;
mod planes;
mod pose;
mod soles;
mod standing;
