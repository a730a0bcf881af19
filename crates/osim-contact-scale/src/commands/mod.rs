//! What each verb does when it is called: read, plan, write, report.

mod asked;
mod batch;
mod change;
mod check;
mod completions;
mod design;
mod dispatch;
mod drop_test;
mod explain;
mod fit;
mod inspect;
mod manual;
mod motion;
mod page;
mod plot;
mod presets;
mod reproduce;
mod request;
mod rescale;
mod run;
mod shown;
mod sweep;
mod unmatched;

pub(crate) use dispatch::call;
