//! Circles of modules of every make.

use super::super::support::{refused, shown, workspace};

/// The fourth module uses the circle and is no part of it.
#[test]
fn three_modules() {
    refused(
        "three-modules",
        &[
            "crate::a -> crate::b: crate::b::B (src/a.rs:1)",
            "crate::b -> crate::c: crate::c::C (src/b.rs:1)",
            "crate::c -> crate::a: crate::a::A (src/c.rs:1)",
        ],
    );
}

/// Two rings that share a module are one circle; the shorter one is shown first.
#[test]
fn four_modules() {
    refused(
        "four-modules",
        &[
            "crate::a -> crate::b: crate::b::B (src/a.rs:1)",
            "crate::b -> crate::c: crate::c::C (src/b.rs:1)",
            "crate::c -> crate::a: crate::a::A (src/c.rs:1)",
            "crate::c -> crate::d: crate::d::D (src/c.rs:2)",
            "crate::d -> crate::c: crate::c::C (src/d.rs:1)",
            "crate::d -> crate::c: crate::c::C (src/d.rs:3)",
        ],
    );
}

/// Circles that do not meet are told apart, even if one uses the other.
#[test]
fn two_circles() {
    refused(
        "two-circles",
        &[
            "crate::a -> crate::b: crate::b::B (src/a.rs:1)",
            "crate::b -> crate::a: crate::a::A (src/b.rs:1)",
            "crate::c -> crate::d: crate::d::D (src/c.rs:1)",
            "crate::d -> crate::c: crate::c::C (src/d.rs:1)",
        ],
    );
}

#[test]
fn inline_module() {
    refused(
        "inline-module",
        &[
            "crate::a::inner -> crate::b: crate::b::B (src/lib.rs:5)",
            "crate::b -> crate::a::inner: inner::of (src/lib.rs:15)",
        ],
    );
}

/// A file module in an inline module in a file.
#[test]
fn inline_in_file() {
    refused(
        "inline-in-file",
        &[
            "crate::a::inner -> crate::a::inner::leaf: leaf::four (src/a.rs:7)",
            "crate::a::inner::leaf -> crate::a::inner: super::Inner (src/a/inner/leaf.rs:2)",
        ],
    );
}

/// Modules inside of a file named by `#[path]` are looked for beside it.
#[test]
fn path_attribute() {
    refused(
        "path-attribute",
        &[
            "crate::a::inside -> crate::b: crate::b::B (src/elsewhere/inside.rs:1)",
            "crate::b -> crate::a::inside: crate::a::A (src/elsewhere/second.rs:1)",
        ],
    );
}

/// One module with a file for each system: both are read.
#[test]
fn path_by_system() {
    refused(
        "path-by-system",
        &[
            "crate::a -> crate::system: crate::system::four (src/a.rs:1)",
            "crate::system -> crate::a: crate::a::A (src/other.rs:1)",
        ],
    );
}

#[test]
fn program() {
    refused(
        "program",
        &["crate -> crate::a: a::run (src/main.rs:6)", "crate::a -> crate: crate::NAME (src/a.rs:1)"],
    );
}

/// A program in `src/bin` is a tree of its own, with a root of its own.
#[test]
fn several_targets() {
    refused(
        "several-targets",
        &[
            "crate -> crate::a: a::run (src/bin/tool.rs:7)",
            "crate::a -> crate: crate::NAME (src/bin/tool/a.rs:2)",
        ],
    );
}

/// Modules that belong to a library and to a program are shown once.
#[test]
fn library_and_program() {
    refused(
        "library-and-program",
        &["crate::a -> crate::b: crate::b::B (src/a.rs:1)", "crate::b -> crate::a: crate::a::A (src/b.rs:1)"],
    );
}

/// A library and a program whose places the manifest gives, and a program with a folder of its own.
#[test]
fn targets_elsewhere() {
    let circles = workspace("targets/elsewhere").circles();
    let arrows: Vec<String> = circles.iter().flat_map(|circle| shown(&circle.arrows)).collect();
    let expected = [
        "crate -> crate::a: a::A (library/root.rs:3)",
        "crate::a -> crate: crate::Root (library/a.rs:1)",
        "crate -> crate::b: b::run (programs/first.rs:6)",
        "crate::b -> crate: crate::First (programs/b.rs:2)",
        "crate -> crate::c: c::run (src/bin/second/main.rs:6)",
        "crate::c -> crate: crate::Second (src/bin/second/c.rs:2)",
    ];
    assert_eq!(arrows, expected);
}
