//! What cannot be read is an error: a rule that read only half of a workspace would hold only half.

use house_rules::{Error, Workspace};

use crate::support::fixture;

fn error_of_sources(name: &str) -> Error {
    Workspace::of_sources(name, &fixture("broken").join(name)).unwrap_err()
}

fn error_of_workspace(name: &str) -> Error {
    Workspace::read(&fixture("broken").join(name)).unwrap_err()
}

#[test]
fn a_module_without_a_file() {
    let error = error_of_sources("no-file");
    assert_eq!(error.to_string(), "src/there.rs:3: no file for the module gone");
}

#[test]
fn a_file_that_is_not_rust() {
    let error = error_of_sources("no-rust");
    assert_eq!(error.to_string(), "src/a.rs:3: expected identifier");
}

#[test]
fn a_member_that_is_no_crate() {
    let error = error_of_workspace("no-package").to_string();
    assert!(error.ends_with("Cargo.toml: this member has no [package]"), "{error}");
}

#[test]
fn a_member_that_is_not_there() {
    assert!(matches!(error_of_workspace("no-member"), Error::Read { .. }));
}

#[test]
fn a_manifest_that_is_none() {
    assert!(matches!(error_of_workspace("no-manifest"), Error::Manifest { .. }));
}
