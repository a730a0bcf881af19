//! `explain` has a topic for every equation and every error code that a table, JSON or a failure names.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_model::YesQuestion;
use serde_json::Value;

use crate::support::{TestDir, root};

/// Files below `folder` with one of these extensions.
fn files_with_extension(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files_with_extension(&path, extensions));
        } else if path.extension().is_some_and(|e| extensions.iter().any(|wanted| e == *wanted)) {
            found.push(path);
        }
    }
    found
}

/// All topics of one kind that `explain` lists in JSON, by their `label` or `code`.
fn explained_names(kind: &str, key: &str) -> BTreeSet<String> {
    let out = TestDir::new().run("explain --format json").succeeded().out();
    let topics = out.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    topics
        .filter(|topic| topic["kind"] == kind)
        .map(|topic| topic[key].as_str().unwrap().to_owned())
        .collect()
}

/// Values of `"equation":"…"` in lines of JSON.
fn collect_from_json(text: &str, found: &mut BTreeSet<String>) {
    for part in text.split("\"equation\":\"").skip(1) {
        found.insert(part.split('"').next().unwrap().to_owned());
    }
}

/// Cells below the header "equation" of a table for people (`by`, for centres).
fn collect_from_tables(text: &str, found: &mut BTreeSet<String>) {
    let mut column = None;
    for line in text.lines() {
        let header =
            ["  equation", "new z  by"].iter().find_map(|header| line.find(header).map(|at| (header, at)));
        if let (Some((header, at)), false) = (header, line.starts_with('|')) {
            column = Some(
                line[..at].chars().count() + header.len()
                    - header.trim_start().rsplit(' ').next().unwrap().len(),
            );
        } else if line.is_empty() || line.starts_with("  (") || line.starts_with("remark:") {
            column = None;
        } else if let Some(column) = column {
            let cell: String = line.chars().skip(column).collect();
            let cell = cell.split("  ").next().unwrap();
            if !cell.is_empty() {
                found.insert(cell.to_owned());
            }
        }
    }
}

/// Text in quotes that looks like equation numbers, in code outside tests: `"C.5"`, `"11, B.2"`, `"(12)"`.
fn collect_from_source(text: &str, found: &mut BTreeSet<String>) {
    let code = text.split("#[cfg(test)]").next().unwrap();
    for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
        for literal in line.split('"').skip(1).step_by(2) {
            let number = |part: &str| {
                let part = part.trim_start_matches('(').trim_end_matches(')');
                let digits = ["A.", "B.", "C."].iter().find_map(|letter| part.strip_prefix(letter));
                digits.is_some_and(|digits| digits.parse::<u8>().is_ok())
            };
            if literal.split(", ").any(number) {
                found.insert(literal.to_owned());
            }
        }
    }
}

/// The crates that print the equation from which a number came. Other crates name equations only in the texts of rules, which
/// `explain` reads, and in plots.
const CRATES_WITH_EQUATIONS: [&str; 2] = ["osim-patch", "osim-requests"];

/// The crates that make errors with codes.
const CRATES_WITH_ERRORS: [&str; 7] = [
    "osim-model",
    "osim-patch",
    "osim-inspect",
    "osim-requests",
    "osim-planning",
    "osim-library",
    "osim-view",
];

/// Every source file of these crates, with its text.
fn source_files(crates: &[&str]) -> Vec<(PathBuf, String)> {
    let folders = crates.iter().map(|name| root().join("crates").join(name).join("src"));
    let all = folders.flat_map(|folder| files_with_extension(&folder, &["rs"]));
    all.map(|file| (file.clone(), std::fs::read_to_string(file).unwrap())).collect()
}

/// All equations that snapshots, the documentation and the source print.
fn printed_equations() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut pages = files_with_extension(&root().join("tests/snapshots"), &["snap"]);
    pages.extend(files_with_extension(&root().join("docs"), &["md"]));
    pages.push(root().join("README.md"));
    // It shows the tree of the code, and nothing that the program prints.
    pages.retain(|page| !page.ends_with("docs/developers/architecture.md"));
    for page in pages {
        let text = std::fs::read_to_string(page).unwrap();
        collect_from_json(&text, &mut found);
        collect_from_tables(&text, &mut found);
    }
    for (file, source) in source_files(&CRATES_WITH_EQUATIONS) {
        let mut stems = file.components().map(|part| Path::new(part.as_os_str()).file_stem());
        if !stems.any(|stem| stem == Some("rules".as_ref()) || stem == Some("register".as_ref())) {
            collect_from_source(&source, &mut found);
        }
    }
    found
}

#[test]
fn every_equation_that_is_printed_can_be_explained() {
    let printed = printed_equations();
    for example in
        ["10", "(C.5)", "11, B.2", "given", "follow", "predsim", "exact law", "A.1, A.5", "C.8", "(12)"]
    {
        assert!(printed.contains(example), "{example} is not among {printed:?}");
    }
    let dir = TestDir::new();
    let explained = explained_names("equation", "label");
    for name in printed.iter().chain(&explained) {
        let output = dir.command("explain").arg(name).output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && !output.stdout.is_empty(), "{name}: {error}");
    }
}

/// The texts in quotes that follow one of `marks`.
fn literals_after(text: &str, marks: &[&str]) -> BTreeSet<String> {
    let literal = |part: &str| part.split('"').next().unwrap().to_owned();
    marks.iter().flat_map(|mark| text.split(mark).skip(1).map(literal)).collect()
}

/// The code among the arguments of a call: the first text in quotes of small letters and hyphens.
fn error_code_in(arguments: &str) -> Option<String> {
    let statement = arguments.split(';').next()?;
    let is_code = |text: &&str| text.chars().all(|c| c.is_ascii_lowercase() || c == '-') && !text.is_empty();
    statement.split('"').skip(1).step_by(2).find(is_code).map(str::to_owned)
}

#[test]
fn every_error_code_can_be_explained() {
    let mut raised: BTreeSet<String> = YesQuestion::ALL.iter().map(ToString::to_string).collect();
    for (_, text) in source_files(&CRATES_WITH_ERRORS) {
        let code = text.split("#[cfg(test)]").next().unwrap();
        raised.extend(code.split("Failure::outside(").skip(1).filter_map(error_code_in));
        raised.extend(code.split(".into_failure(").skip(1).filter_map(error_code_in));
        for codes in code.split("fn code(&self) -> &'static str {").skip(1) {
            raised.extend(literals_after(codes.split("\n    }\n").next().unwrap(), &["=> \""]));
        }
    }
    assert_eq!(explained_names("error", "code"), raised);
}
