//! The integration tests of `osim-requests`, as one program, because linking each program takes a second.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod dictionaries;
