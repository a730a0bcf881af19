//! No arrow upwards between crates.

use crate::support::{shown, workspace};

/// A dependency for one system and by another name, one in the same layer, one of a build script. Those of tests may
/// point upwards.
#[test]
fn upwards() {
    let faults = workspace("layers/upwards").arrows(&[&["low"], &["middle", "side"], &["high"]]);
    let expected = [
        "crates/low/Cargo.toml:9: low depends on high, which does not stand below it",
        "crates/middle/Cargo.toml:8: middle depends on side, which does not stand below it",
        "crates/side/Cargo.toml:9: side depends on high, which does not stand below it",
    ];
    assert_eq!(shown(&faults), expected);
}

#[test]
fn downwards() {
    let workspace = workspace("layers/downwards");
    assert_eq!(workspace.crates().collect::<Vec<_>>(), ["low", "middle", "side", "high"]);
    let faults = workspace.arrows(&[&["low"], &["middle", "side"], &["high"]]);
    assert_eq!(shown(&faults), [""; 0]);
}

/// A crate that was forgotten, and a name that was misspelt, would make the rule hold for less than it seems to.
#[test]
fn nobody_is_left_out() {
    let faults = workspace("layers/downwards").arrows(&[&["low"], &["midle"], &["side", "high"]]);
    let expected = ["a layer names midle, which is no crate of the workspace", "middle stands in no layer"];
    assert_eq!(shown(&faults), expected);
}

/// A `*` in `members` is any part of a name of a folder.
#[test]
fn members_by_pattern() {
    let workspace = workspace("members/patterns");
    assert_eq!(workspace.crates().collect::<Vec<_>>(), ["first", "named"]);
}
