//! Circles by `use`.

use super::super::support::refused;

#[test]
fn plain_use() {
    refused(
        "plain-use",
        &["crate::a -> crate::b: crate::b::B (src/a.rs:1)", "crate::b -> crate::a: crate::a::A (src/b.rs:1)"],
    );
}

#[test]
fn by_super() {
    refused(
        "super",
        &["crate::a -> crate::b: super::b::B (src/a.rs:1)", "crate::b -> crate::a: super::a::A (src/b.rs:1)"],
    );
}

#[test]
fn by_super_super() {
    refused(
        "super-super",
        &[
            "crate::a -> crate::deep::inner: super::deep::inner::B (src/a.rs:1)",
            "crate::deep::inner -> crate::a: super::super::a::A (src/deep/inner.rs:1)",
        ],
    );
}

/// A group over several lines: each name has its own line. `self` is used where it leads on, in line 9.
#[test]
fn grouped_use() {
    refused(
        "grouped-use",
        &[
            "crate::a -> crate::b: crate::b::Other (src/a.rs:5)",
            "crate::a -> crate::b: b::B (src/a.rs:9)",
            "crate::a -> crate::b::inner: crate::b::inner::Deep (src/a.rs:4)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:3)",
            "crate::b::inner -> crate::a: crate::a::A (src/b/inner.rs:1)",
        ],
    );
}

#[test]
fn renamed_use() {
    refused(
        "renamed-use",
        &[
            "crate::a -> crate::b: crate::b::B (src/a.rs:2)",
            "crate::a -> crate::b: other::four (src/a.rs:7)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// A module that is imported is used where a path goes on from it.
#[test]
fn imported_module() {
    refused(
        "imported-module",
        &["crate::a -> crate::b: b::four (src/a.rs:6)", "crate::b -> crate::a: a::A (src/b.rs:4)"],
    );
}

#[test]
fn self_import() {
    refused(
        "self-import",
        &[
            "crate::parent -> crate::parent::child: self::child::four (src/parent/mod.rs:3)",
            "crate::parent -> crate::parent::child: inner::one (src/parent/mod.rs:9)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child.rs:1)",
        ],
    );
}

/// Nobody sees what a macro does with a module, so the import counts.
#[test]
fn self_import_for_macro() {
    refused(
        "self-import-for-macro",
        &[
            "crate::parent -> crate::parent::child: self::child (src/parent/mod.rs:3)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child.rs:2)",
        ],
    );
}

/// A module that is passed on under another name.
#[test]
fn module_passed_on() {
    refused(
        "module-passed-on",
        &[
            "crate::parent -> crate::parent::child: outside::passed::four (src/parent/mod.rs:10)",
            "crate::parent::child -> crate::parent: super::Parent (src/parent/child.rs:2)",
        ],
    );
}

/// A glob counts, and each name that it brings in.
#[test]
fn glob_use() {
    refused(
        "glob-use",
        &[
            "crate::a -> crate::b: crate::b::* (src/a.rs:1)",
            "crate::a -> crate::b: B (src/a.rs:5)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// A glob of a facade: the facade has nothing of its own, so the name says what is used.
#[test]
fn name_through_glob() {
    refused(
        "name-through-glob",
        &["crate::a -> crate::b: B (src/a.rs:5)", "crate::b -> crate::a: crate::a::A (src/b.rs:1)"],
    );
}

/// The methods of a trait are called without its name, so the glob counts.
#[test]
fn trait_through_glob() {
    refused(
        "trait-through-glob",
        &[
            "crate::a -> crate::b: crate::facade::* (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

#[test]
fn variant_through_glob() {
    refused(
        "variant-through-glob",
        &[
            "crate::a -> crate::b: crate::b::Kind::* (src/a.rs:1)",
            "crate::a -> crate::b: crate::b::Kind (src/a.rs:5)",
            "crate::a -> crate::b: Hard (src/a.rs:6)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:2)",
        ],
    );
}

#[test]
fn use_in_function() {
    refused(
        "use-in-function",
        &[
            "crate::a -> crate::b: crate::b::four (src/a.rs:4)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}

/// Code for every system counts, wherever the test runs.
#[test]
fn both_systems() {
    refused(
        "both-systems",
        &[
            "crate::a -> crate::windows: crate::windows::four (src/a.rs:4)",
            "crate::windows -> crate::a: crate::a::A (src/windows.rs:1)",
        ],
    );
}

/// `extern crate self as library`.
#[test]
fn own_crate_by_name() {
    refused(
        "own-crate-by-name",
        &[
            "crate::a -> crate::b: library::b::B (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
        ],
    );
}
