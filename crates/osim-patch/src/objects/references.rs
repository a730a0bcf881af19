//! Places of a file that name contact geometry.

use osim_model::{Document, ElementId, ForceKind, opensim_text};

use super::covered::Covered;

/// The elements of `document` that name contact geometry. What `<defaults>` name for forces is not among them: it counts only for
/// forces that have nothing of their own there.
pub(super) fn references(document: &Document) -> impl Iterator<Item = ElementId> + '_ {
    let tree = document.tree();
    let of_forces = |&id: &ElementId| {
        let kinds = [ForceKind::HuntCrossley, ForceKind::SmoothSphereHalfSpace];
        kinds.iter().any(|kind| kind.as_str() == tree.name(id))
    };
    let defaults = document.defaults().into_iter().flat_map(|defaults| tree.children(defaults));
    let left_out = Covered::of(defaults.filter(of_forces).map(|element| tree.span(element)).collect());
    tree.elements().filter(move |&id| is_reference(tree.name(id)) && !left_out.covers(&tree.span(id)))
}

/// The names that the text of such an element gives, without their paths.
pub(super) fn names(text: &str) -> impl Iterator<Item = &str> {
    opensim_text::list(text).map(|word| word.rsplit('/').next().unwrap_or(word))
}

/// Whether elements of this name name contact geometry.
fn is_reference(tag: &str) -> bool {
    ["geometry", "socket_sphere", "socket_half_space", "socket_contact_geometry"].contains(&tag)
}
