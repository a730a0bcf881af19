//! What each verb does when it is called: read, plan, write, report.

mod calculators;
mod change;
mod completions;
mod dispatch;
mod lookups;
mod motion;
mod plot;
mod survey;
mod sweep;

pub(crate) use dispatch::call;
