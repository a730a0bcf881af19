//! Shows the contacts of an OpenSim model to people and to scripts.
//!
//! [`figures`] gives points titles, labels and limits, for `contact_plots` to draw; [`report`] makes tables, records and
//! explanations; [`html`] puts both on one page about a run. Nothing is decided here, no file is opened, and
//! nothing is computed but the figures and the table of the paper.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod figures;
pub mod html;
pub mod report;
