//! What is written down while a module is walked through.

use std::collections::{BTreeSet, HashSet};

use proc_macro2::Span;
use syn::ext::IdentExt;
use syn::{Attribute, Visibility};

use super::facts::{Facts, Import, Item, Literal, Mention, Path, Sight, Spaces};
use super::imports::leaves;

/// A `mod` in a module.
pub(crate) struct Child<'ast> {
    pub(crate) name: String,
    pub(crate) sight: Sight,
    pub(crate) line: usize,
    pub(crate) attributes: &'ast [Attribute],
    /// What stands in it, where it has no file of its own.
    pub(crate) items: Option<&'ast [syn::Item]>,
    pub(crate) for_tests: bool,
}

/// What one module says, and the modules in it.
#[derive(Default)]
pub(crate) struct Record<'ast> {
    pub(crate) facts: Facts,
    pub(crate) children: Vec<Child<'ast>>,
    /// Lines of test code.
    pub(crate) test_lines: BTreeSet<usize>,
    /// How many blocks deep the walk is: what stands in a block is seen in the module alone.
    pub(crate) depth: usize,
    /// Names of variables and of generic types, which hide items of the same name.
    pub(crate) hidden: Vec<HashSet<String>>,
}

impl<'ast> Record<'ast> {
    /// An item of this module.
    pub(crate) fn define(&mut self, ident: &syn::Ident, spaces: Spaces, visibility: &Visibility) {
        self.define_with(ident, spaces, visibility, false, Vec::new());
    }

    /// An item of this module that is a trait, or an enum with variants.
    pub(crate) fn define_with(
        &mut self,
        ident: &syn::Ident,
        spaces: Spaces,
        visibility: &Visibility,
        is_trait: bool,
        variants: Vec<String>,
    ) {
        let (name, sight, local) = (ident.unraw().to_string(), sight(visibility), self.depth > 0);
        self.facts.items.push(Item { name, spaces, is_trait, variants, sight, local });
    }

    /// All names of a `use`.
    pub(crate) fn import(&mut self, item: &syn::ItemUse) {
        let (global, sight, local) = (item.leading_colon.is_some(), sight(&item.vis), self.depth > 0);
        for leaf in leaves(&item.tree, &[]) {
            self.facts.imports.push(Import {
                path: Path { global, segments: leaf.segments },
                name: leaf.name,
                glob: leaf.glob,
                spaces: leaf.spaces,
                sight,
                local,
                line: leaf.line,
            });
        }
    }

    /// `extern crate`, which is a `use` in other words.
    pub(crate) fn import_crate(&mut self, item: &syn::ItemExternCrate) {
        let own = item.ident == "self";
        let segment = if own { "crate".to_owned() } else { item.ident.unraw().to_string() };
        let name = item.rename.as_ref().map_or(&item.ident, |(_, name)| name);
        self.facts.imports.push(Import {
            path: Path { global: !own, segments: vec![segment] },
            name: (name != "_" && name != "self").then(|| name.unraw().to_string()),
            glob: false,
            spaces: Spaces::TYPES,
            sight: sight(&item.vis),
            local: self.depth > 0,
            line: item.ident.span().start().line,
        });
    }

    /// A module in this one.
    pub(crate) fn child(&mut self, item: &'ast syn::ItemMod, for_tests: bool) {
        self.children.push(Child {
            name: item.ident.unraw().to_string(),
            sight: sight(&item.vis),
            line: item.ident.span().start().line,
            attributes: &item.attrs,
            items: item.content.as_ref().map(|(_, items)| items.as_slice()),
            for_tests,
        });
    }

    /// A path, with what can be meant by it.
    pub(crate) fn mention(&mut self, path: &syn::Path, want: Spaces) {
        let segments: Vec<String> =
            path.segments.iter().map(|segment| segment.ident.unraw().to_string()).collect();
        let Some(first) = path.segments.first() else { return };
        let global = path.leading_colon.is_some();
        let alone = segments.len() == 1;
        let own = first.ident == "Self" || (alone && first.ident == "self");
        if own || (!global && !want.meets(Spaces::MACROS) && self.is_hidden(&segments[0], alone)) {
            return;
        }
        let line = first.ident.span().start().line;
        self.facts.mentions.push(Mention { path: Path { global, segments }, want, line });
    }

    /// Whether a variable or a generic type has this name. Only a type has something behind a `::`.
    fn is_hidden(&self, name: &str, alone: bool) -> bool {
        (alone || name.starts_with(char::is_uppercase))
            && self.hidden.iter().any(|names| names.contains(name))
    }

    /// A string literal.
    pub(crate) fn literal(&mut self, literal: &proc_macro2::Literal) {
        self.facts.literals.push(Literal { source: literal.to_string(), line: literal.span().start().line });
    }

    /// Something that is for tests alone, and left out of everything but the sizes of files.
    pub(crate) fn leave_out(&mut self, span: Span) {
        self.test_lines.extend(span.start().line..=span.end().line);
    }
}

/// From where something with this visibility is seen. A visibility is no use of the modules it names.
fn sight(visibility: &Visibility) -> Sight {
    let Visibility::Restricted(restricted) = visibility else {
        return if matches!(visibility, Visibility::Public(_)) { Sight::Depth(0) } else { Sight::Up(0) };
    };
    let segments = &restricted.path.segments;
    match segments.first() {
        Some(first) if first.ident == "crate" => Sight::Depth(segments.len() - 1),
        _ => Sight::Up(segments.iter().filter(|segment| segment.ident == "super").count()),
    }
}
