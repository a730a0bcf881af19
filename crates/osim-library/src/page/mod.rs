//! Runs over many models with the page that reports them: what front ends with a disk share.
//!
//! [`Survey`] inspects and checks models; [`entry`] is what a page shows of one that was changed; [`ReportPage`] is the file.
//!
//! # What it will not do
//!
//! It knows no terminal and no Python: what is wrong is a [`LibraryFault`](crate::LibraryFault), which its caller spells.

mod entry;
mod nameless_file;
mod report_page;
mod survey;
mod words;

pub use entry::{bare_entry, entry};
pub use report_page::{Replace, ReportPage};
pub use survey::{Inspected, Survey};
pub use words::Words;
