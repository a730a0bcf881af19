//! What is known of the contacts of an OpenSim model, for people and for scripts.
//!
//! [`figures`] gives points titles, labels and limits, for `contact_plots` to draw; [`report`] makes tables, records and
//! explanations; [`html`] puts both on one page about a run. Nothing is computed or decided here, and no file is opened.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod figures;
pub mod html;
pub mod report;
