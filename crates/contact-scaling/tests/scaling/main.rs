//! The integration tests of `contact-scaling`, as one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod drop_test;
mod equations;
mod fit;
mod register;
mod table1;
