//! Sizes, without tests where the rule says so.

use house_rules::Limits;

use crate::support::{shown, sources};

/// Without tests there are 3 lines of `lib.rs`, 7 of `model.rs`, 5 of `plan/mod.rs`, 1 and 5 below it. `checks.rs` is for
/// tests, with the file that it declares.
#[test]
fn counted() {
    let expected = [
        "tests-apart: 21 lines without tests",
        "src/checks: 0 lines without tests",
        "src/plan: 11 lines without tests",
        "src/plan/deep: 5 lines without tests",
        "src/checks.rs: 5 lines",
        "src/checks/more.rs: 2 lines",
        "src/lib.rs: 5 lines",
        "src/model.rs: 15 lines",
        "src/plan/deep/mod.rs: 3 lines",
        "src/plan/deep/no_module.rs: 2 lines",
        "src/plan/draft.rs: 1 lines",
        "src/plan/mod.rs: 7 lines",
    ];
    let mut found = sources("sizes", "tests-apart").sizes();
    found.sort();
    assert_eq!(shown(&found), expected);
}

#[test]
fn too_large() {
    let limits = Limits { of_crate: 20, of_folder: 10, of_file: 14 };
    let expected = [
        "tests-apart: 21 lines without tests, allowed are 20",
        "src/plan: 11 lines without tests, allowed are 10",
        "src/model.rs: 15 lines, allowed are 14",
    ];
    assert_eq!(shown(&sources("sizes", "tests-apart").too_large(&limits)), expected);
}

#[test]
fn just_allowed() {
    let limits = Limits { of_crate: 21, of_folder: 11, of_file: 15 };
    assert_eq!(shown(&sources("sizes", "tests-apart").too_large(&limits)), [""; 0]);
}

#[test]
fn of_the_house() {
    let limits = Limits::default();
    assert_eq!((limits.of_crate, limits.of_folder, limits.of_file), (9000, 3000, 400));
}
