//! The tests of the public functions of `osim-inspect`, in one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

#[allow(dead_code, unreachable_pub, reason = "osim-planning has these feet, too")]
mod feet;
mod figures;
mod fixed_to_ground;
mod load_sharing;
mod loops;
mod names;
mod places;
#[allow(dead_code, reason = "other tests need more of it")]
#[path = "../../../osim-planning/tests/planning/random.rs"]
mod random;
mod register;
mod rules;
mod sides;
mod skeleton;
mod unread;
