//! Reads fixtures. They are parsed, never compiled.

use std::path::PathBuf;

use house_rules::{Circle, Workspace};

/// The folder of a fixture.
pub(crate) fn fixture(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

/// A fixture that is one crate without a manifest.
#[track_caller]
pub(crate) fn sources(group: &str, name: &str) -> Workspace {
    let dir = fixture(group).join(name);
    Workspace::of_sources(name, &dir).unwrap_or_else(|error| panic!("{group}/{name}: {error}"))
}

/// A fixture that is a workspace.
#[track_caller]
pub(crate) fn workspace(name: &str) -> Workspace {
    Workspace::read(&fixture(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The circles of a fixture in `circles/`.
#[track_caller]
pub(crate) fn circles(name: &str) -> Vec<Circle> {
    sources("circles", name).circles()
}

/// The fixture in `circles/` has circles of exactly these arrows.
#[track_caller]
pub(crate) fn refused(name: &str, arrows: &[&str]) {
    let circles = circles(name);
    let found: Vec<String> =
        circles.iter().flat_map(|circle| &circle.arrows).map(ToString::to_string).collect();
    assert_eq!(found, arrows, "{name}");
}

/// The fixture in `no-circles/` has none, and yet modules that use each other.
#[track_caller]
pub(crate) fn passes(name: &str) {
    let workspace = sources("no-circles", name);
    let circles: Vec<String> = workspace.circles().iter().map(ToString::to_string).collect();
    assert!(circles.is_empty(), "{name}: {}", circles.join("\n"));
    assert!(!workspace.uses().is_empty(), "{name}: nothing was read");
}

/// Findings as they are shown.
pub(crate) fn shown<T: ToString>(found: &[T]) -> Vec<String> {
    found.iter().map(ToString::to_string).collect()
}
