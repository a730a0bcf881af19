//! Where a property is in a file.

use std::ops::Range;

use crate::model::class::Class;
use crate::model::fault::FileId;
use crate::xml::ElementId;

/// Where the text of a property is, or the object that would get it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Slot {
    /// Which of the files.
    pub file: FileId,
    /// The object that has the property.
    pub object: ElementId,
    /// Its class, which says the order of its elements.
    pub class: Class,
    /// Tag of the property's element.
    pub tag: &'static str,
    /// The bytes of its text; `None` where the object has no such element.
    pub span: Option<Range<usize>>,
    /// First byte to point at, from 0: the text, or the object that lacks it.
    pub offset: usize,
}
