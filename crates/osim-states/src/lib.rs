//! A model before and after a change: what is known of both states before anything is written.
//!
//! # What it will not do
//!
//! It plans nothing and writes nothing: the plan comes from `osim-requests`, the new bytes from callers that write them.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod before_after;
mod states;

pub use before_after::BeforeAfter;
pub use states::States;

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
