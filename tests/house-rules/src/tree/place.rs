//! Where the file of a `mod x;` is.

use std::path::{Path, PathBuf};

use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Lit, Meta, Token};

/// Where the files of a module's modules are looked for, in the compiler's way.
#[derive(Debug, Clone)]
pub(crate) struct Dir {
    path: PathBuf,
    /// The name of the file, where its modules are in a folder of that name: all but `mod.rs` and the like.
    below: Option<String>,
}

impl Dir {
    /// For a file like `mod.rs`, whose modules stand beside it.
    pub(crate) fn beside(file: &Path) -> Self {
        Self { path: file.parent().unwrap_or(Path::new("")).to_owned(), below: None }
    }

    /// For the `mod name { … }` with these attributes.
    pub(crate) fn inline(&self, name: &str, attributes: &[Attribute]) -> Self {
        let path = match paths_in(attributes).first() {
            Some(written) => self.path.join(written),
            None => self.children().join(name),
        };
        Self { path, below: None }
    }

    /// The files of the `mod name;` with these attributes, each with the place for its own modules. There are several
    /// where `cfg_attr` chooses between them.
    pub(crate) fn files(&self, name: &str, attributes: &[Attribute]) -> Vec<(PathBuf, Self)> {
        let written = paths_in(attributes).into_iter().map(|written| self.path.join(written));
        let mut found: Vec<(PathBuf, Self)> =
            written.map(|file| (file.clone(), Self::beside(&file))).collect();
        let folder = self.children();
        let own = folder.join(format!("{name}.rs"));
        let inside = folder.join(name).join("mod.rs");
        if !attributes.iter().any(|attribute| attribute.path().is_ident("path")) {
            found.push((own, Self { path: folder, below: Some(name.to_owned()) }));
            found.push((inside.clone(), Self::beside(&inside)));
        }
        found.retain(|(file, _)| file.is_file());
        found
    }

    fn children(&self) -> PathBuf {
        self.below.as_ref().map_or_else(|| self.path.clone(), |below| self.path.join(below))
    }
}

/// Every `path = "…"` of these attributes, those in `cfg_attr` too.
fn paths_in(attributes: &[Attribute]) -> Vec<String> {
    let mut paths = Vec::new();
    for attribute in attributes {
        if attribute.path().is_ident("cfg_attr") {
            let parts = attribute.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated);
            paths.extend(parts.unwrap_or_default().iter().skip(1).filter_map(path_in));
        } else {
            paths.extend(path_in(&attribute.meta));
        }
    }
    paths
}

fn path_in(meta: &Meta) -> Option<String> {
    match meta {
        Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        },
        _ => None,
    }
}
