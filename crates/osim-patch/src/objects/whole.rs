//! Which models can get or lose whole objects.

use osim_model::{Fault, FaultKind, Model};

/// The sets that whole objects go into.
pub(super) const FORCES: &str = "ForceSet";
pub(super) const GEOMETRY: &str = "ContactGeometrySet";

/// Objects are changed in models that are one file: a set in another file belongs to other models, too.
///
/// # Errors
/// A set that stands alone, or one that is in another file.
pub(super) fn refuse_parts(model: &Model) -> Result<(), Fault> {
    let document = model.document();
    let (tree, root) = (document.tree(), document.data_root());
    if tree.name(root) != "Model" {
        return Err(Fault::over(
            FaultKind::Refused(
                "this is a set that stands alone: whole contacts are added to, changed in and removed from models only; name the \
                 model that it belongs to"
                    .to_owned(),
            ),
            tree.open_span(root),
        ));
    }
    for (element, file) in document.included_files() {
        if [FORCES, GEOMETRY].contains(&tree.name(element)) {
            let (path, span) = (tree.name(element).to_owned(), tree.open_span(element));
            return Err(Fault::over(FaultKind::IncludedFile { path, file }, span));
        }
    }
    Ok(())
}
