//! A `use` with its groups, taken apart.

use syn::UseTree;
use syn::ext::IdentExt;

use super::facts::Spaces;

/// One name that a `use` brings in.
pub(crate) struct Leaf {
    pub(crate) segments: Vec<String>,
    pub(crate) name: Option<String>,
    pub(crate) glob: bool,
    pub(crate) spaces: Spaces,
    pub(crate) line: usize,
}

/// All names of a tree of `use` that stands behind the segments of `prefix`.
pub(crate) fn leaves(tree: &UseTree, prefix: &[String]) -> Vec<Leaf> {
    match tree {
        UseTree::Path(path) => {
            let mut longer = prefix.to_vec();
            longer.push(path.ident.unraw().to_string());
            leaves(&path.tree, &longer)
        }
        UseTree::Name(name) => vec![named(&name.ident, None, prefix)],
        UseTree::Rename(rename) => vec![named(&rename.ident, Some(&rename.rename), prefix)],
        UseTree::Glob(glob) => vec![Leaf {
            segments: prefix.to_vec(),
            name: None,
            glob: true,
            spaces: Spaces::ALL,
            line: glob.star_token.spans[0].start().line,
        }],
        UseTree::Group(group) => group.items.iter().flat_map(|tree| leaves(tree, prefix)).collect(),
    }
}

/// The leaf `ident as rename`.
fn named(ident: &syn::Ident, rename: Option<&syn::Ident>, prefix: &[String]) -> Leaf {
    let mut segments = prefix.to_vec();
    let itself = ident == "self" && !prefix.is_empty();
    if !itself {
        segments.push(ident.unraw().to_string());
    }
    let name = match rename {
        Some(rename) if rename == "_" => None,
        Some(rename) => Some(rename.unraw().to_string()),
        None => segments.last().cloned(),
    };
    let spaces = if itself { Spaces::TYPES } else { Spaces::ALL };
    Leaf { segments, name, glob: false, spaces, line: ident.span().start().line }
}
