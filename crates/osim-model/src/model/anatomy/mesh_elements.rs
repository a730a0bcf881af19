//! Files and scale factors in the elements of meshes.

use crate::xml::ElementId;

use crate::model::document::Document;

/// Documents before this version list file names alone.
pub(super) const GEOMETRY_SETS: u32 = 20101;

pub(super) fn file_of(document: &Document, element: ElementId, tag: &str) -> String {
    let tree = document.tree();
    tree.child(element, tag).map(|file| tree.text_of(file).into_owned()).unwrap_or_default()
}

/// Factors that are written but are not numbers stay visible as NaN: they must not pass for 1.
pub(super) fn scale(document: &Document, element: ElementId) -> [f64; 3] {
    let missing = document.tree().child(element, "scale_factors").is_none();
    document.triple(element, "scale_factors").unwrap_or([if missing { 1.0 } else { f64::NAN }; 3])
}
