//! What each verb does when it is called: read, plan, write, report.

mod batch;
mod calculators;
mod change;
mod completions;
mod dispatch;
mod lookups;
mod motion;
mod output;
mod plot;
mod reproduce;
mod survey;
mod sweep;

pub(crate) use dispatch::call;
