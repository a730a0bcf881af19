//! What looks like a circle and is none.

use super::super::support::passes;

/// A `mod.rs` that only declares and passes on: its children use each other through it.
#[test]
fn facade() {
    passes("facade");
}

/// The same with `use super::*`: a facade has nothing of its own that this could bring in.
#[test]
fn facade_by_glob() {
    passes("facade-by-glob");
}

#[test]
fn root_as_facade() {
    passes("root-as-facade");
}

/// Test code may use what it tests and what is above it, wherever it stands.
#[test]
fn tests() {
    passes("tests");
}

/// Methods and implementations of traits name no module.
#[test]
fn methods() {
    passes("methods");
}

/// Links in documentation are no code, in macros neither; nor is a text that looks like a path.
#[test]
fn documentation() {
    passes("documentation");
}

#[test]
fn third_module() {
    passes("third-module");
}

/// `pub(in crate::a)` says who sees something, and uses nothing.
#[test]
fn visibility() {
    passes("visibility");
}

/// `super::second::f` uses `second`, not the parent on the way.
#[test]
fn sibling_through_parent() {
    passes("sibling-through-parent");
}

/// The same where the parent was imported first.
#[test]
fn through_imported_parent() {
    passes("through-imported-parent");
}

/// A child that uses what its parent has imported uses the module it was imported from.
#[test]
fn import_of_parent() {
    passes("import-of-parent");
}

/// A variable or a generic type hides what a glob brings in.
#[test]
fn variable_and_glob() {
    passes("variable-and-glob");
}

/// `::std_like` is another crate, even where a module has that name.
#[test]
fn other_crates() {
    passes("other-crates");
}

/// A field, a method or a function in a function may have the name of a module.
#[test]
fn fields_and_names() {
    passes("fields-and-names");
}

#[test]
fn inline_modules() {
    passes("inline-modules");
}

/// A program that uses the library of its own package uses another crate.
#[test]
fn library_and_program() {
    passes("library-and-program");
}

/// Only what is passed on uses the child on the way: a private `use` uses the module that defines the item.
#[test]
fn private_use_through_child() {
    passes("private-use-through-child");
}

/// Nor does the facade count where it stands elsewhere.
#[test]
fn passed_on_from_elsewhere() {
    passes("passed-on-from-elsewhere");
}

/// A private glob brings nothing to others.
#[test]
fn private_glob() {
    passes("private-glob");
}

/// What stands in an `impl` or has no name of its own is no item of the module.
#[test]
fn nested_in_macro_call() {
    passes("nested-in-macro-call");
}

/// What a function defines or imports is not seen outside of it.
#[test]
fn names_in_functions() {
    passes("names-in-functions");
}

/// A glob brings in what can be seen, and no more.
#[test]
fn private_items() {
    passes("private-items");
}

/// Fields, methods, lifetimes, metavariables, paths of other crates, definitions, lone words, and documentation.
#[test]
fn lookalikes_in_macros() {
    passes("lookalikes-in-macros");
}
