//! Circles through re-exports, and between parents and children.

use super::super::support::refused;

/// Who uses what a facade passes on uses the module that defines it.
#[test]
fn re_export() {
    refused(
        "re-export",
        &[
            "crate::facade::tree -> crate::other: crate::other::Other (src/facade/tree.rs:1)",
            "crate::other -> crate::facade::tree: crate::facade::Tree (src/other.rs:1)",
        ],
    );
}

/// Two facades, and another name on the way.
#[test]
fn re_export_chain() {
    refused(
        "re-export-chain",
        &[
            "crate::first::second::third -> crate::other: crate::other::Other (src/first/second/third.rs:1)",
            "crate::other -> crate::first::second::third: crate::first::Renamed (src/other.rs:1)",
        ],
    );
}

/// Two facades that pass on everything.
#[test]
fn glob_re_export() {
    refused(
        "glob-re-export",
        &[
            "crate::facade::inner::tree -> crate::other: crate::other::Other (src/facade/inner/tree.rs:1)",
            "crate::other -> crate::facade::inner::tree: crate::facade::Tree (src/other.rs:1)",
        ],
    );
}

/// A private import of the parent leads on like a re-export: the parent is no part of the circle.
#[test]
fn import_of_parent() {
    refused(
        "import-of-parent",
        &[
            "crate::other -> crate::parent::child: crate::parent::child::Child (src/other.rs:1)",
            "crate::parent::child -> crate::other: super::Other (src/parent/child.rs:1)",
        ],
    );
}

/// A parent defines what its child uses, and re-exports the child.
#[test]
fn parent_re_exports() {
    refused(
        "parent-re-exports",
        &[
            "crate::parent -> crate::parent::child: child::Child (src/parent/mod.rs:3)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child.rs:1)",
        ],
    );
}

/// A parent defines what its child uses, and uses the child.
#[test]
fn parent_uses() {
    refused(
        "parent-uses",
        &[
            "crate::parent -> crate::parent::child: child::four (src/parent.rs:6)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child.rs:2)",
        ],
    );
}

/// What is re-exported comes from further down, and yet the child on the way is used.
#[test]
fn parent_re_exports_facade() {
    refused(
        "parent-re-exports-facade",
        &[
            "crate::parent -> crate::parent::child: child::Deep (src/parent/mod.rs:3)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child/mod.rs:5)",
        ],
    );
}

/// The root of a library is a module like others.
#[test]
fn crate_root() {
    refused(
        "crate-root",
        &["crate -> crate::a: a::A (src/lib.rs:3)", "crate::a -> crate: crate::Result (src/a.rs:1)"],
    );
}
