//! This crate keeps its own rules, and no fixture lies around without a test.

use std::fs;
use std::path::Path;

use house_rules::{Limits, Workspace};

use crate::support::{fixture, shown};

#[test]
fn keeps_its_rules() {
    let workspace = Workspace::read(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap();
    assert_eq!(workspace.crates().collect::<Vec<_>>(), ["house-rules"]);
    assert_eq!(shown(&workspace.circles()), [""; 0]);
    let limits = Limits { of_crate: 3500, of_folder: 1500, of_file: 300 };
    assert_eq!(shown(&workspace.too_large(&limits)), [""; 0]);
}

#[test]
fn every_fixture_has_its_test() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rules/circles");
    let texts: Vec<String> =
        fs::read_dir(tests).unwrap().map(|file| fs::read_to_string(file.unwrap().path()).unwrap()).collect();
    let mut seen = 0;
    for group in ["circles", "no-circles"] {
        for dir in fs::read_dir(fixture(group)).unwrap() {
            let name = format!("\"{}\"", dir.unwrap().file_name().into_string().unwrap());
            assert!(texts.iter().any(|text| text.contains(&name)), "{group}: no test of {name}");
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
}
