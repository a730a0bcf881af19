//! Names that hide items of the same name: variables and generic types.

use std::collections::HashSet;

use syn::Generics;
use syn::ext::IdentExt;
use syn::visit::{self, Visit};

/// Names of variables and of generic types in a function.
#[derive(Default)]
pub(crate) struct Names(HashSet<String>);

impl<'ast> Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        if !is_constant(&pattern.ident) {
            self.0.insert(pattern.ident.unraw().to_string());
        }
        visit::visit_pat_ident(self, pattern);
    }

    fn visit_type_param(&mut self, parameter: &'ast syn::TypeParam) {
        self.0.insert(parameter.ident.unraw().to_string());
    }
}

pub(crate) fn variables(walk: impl FnOnce(&mut Names)) -> HashSet<String> {
    let mut names = Names::default();
    walk(&mut names);
    names.0
}

/// The generic types of an item that is no function.
pub(crate) fn of_generics(item: &syn::Item) -> HashSet<String> {
    let none = Generics::default();
    let generics = match item {
        syn::Item::Enum(item) => &item.generics,
        syn::Item::Impl(item) => &item.generics,
        syn::Item::Struct(item) => &item.generics,
        syn::Item::Trait(item) => &item.generics,
        syn::Item::Type(item) => &item.generics,
        syn::Item::Union(item) => &item.generics,
        _ => &none,
    };
    generics.type_params().map(|parameter| parameter.ident.unraw().to_string()).collect()
}

/// By the custom of Rust, which the compiler warns about.
pub(crate) fn is_constant(ident: &syn::Ident) -> bool {
    ident.to_string().starts_with(char::is_uppercase)
}
