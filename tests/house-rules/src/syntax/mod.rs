//! What the source of a module says, before any name is looked up.

mod facts;
mod gather;
mod generated;
mod hidden;
mod imports;
mod record;
mod test_code;
mod tokens;

pub(crate) use facts::{Doc, Facts, Import, Item, Literal, Mention, Path, Sight, Spaces};
pub(crate) use gather::{docs_of, gather};
pub(crate) use record::{Child, Record};
pub(crate) use test_code::only_in_tests;
