//! The rules, each with fixtures that it refuses and fixtures that pass.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test fails by panicking"
)]

mod bans;
mod broken;
mod circles;
mod itself;
mod layers;
mod options;
mod sizes;
mod support;
mod words;
