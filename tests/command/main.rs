//! Runs the command and tests its output, the files that it writes and the files that it leaves unchanged.
//!
//! Layout and wording are snapshots in `tests/snapshots`; bytes and numbers are plain assertions. Each test works in a
//! temporary folder with copies of fixtures.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stderr,
    reason = "a test fails by panicking and says aloud what it skips"
)]

mod add;
mod add_feet;
mod add_questions;
mod add_table;
mod bad_input;
mod batch;
mod bytes;
mod cases;
mod cases_shapes;
mod cases_skeleton;
mod cases_terminal;
mod cases_unread;
mod check;
mod check_output;
mod check_sides;
mod convert;
mod corpus;
mod data_loss;
mod explain;
mod figures;
mod files;
mod floors;
mod html;
mod implausible_numbers;
mod inspect_folder;
mod json;
mod json_types;
#[cfg(unix)]
mod line_breaks;
mod masses;
mod note_changes;
mod note_history;
mod options_in_messages;
mod output;
mod report_pages;
mod reproduce;
mod request;
mod result_check;
mod scaled_bodies;
mod schemas;
mod shells;
mod similarity;
mod suggestions;
mod summaries;
mod support;
mod sweep;
#[cfg(unix)]
mod terminal;
mod transfer;
mod untrusted_text;
#[cfg(unix)]
mod widths;
mod workbooks;
mod zero_constant_contact_force;
