//! What has grown large: places to look, not limits.

use std::collections::BTreeMap;

/// Lines of a file, with its tests; of a folder and of a crate, without tests.
pub const LARGE: [usize; 3] = [400, 3_000, 12_000];

/// The files, folders and crates above [`LARGE`]; `files` are paths such as `crates/a/src/b.rs` with their lines in all, and without tests.
#[must_use]
pub fn large(files: &BTreeMap<String, (usize, usize)>) -> Vec<String> {
    let mut folders: BTreeMap<&str, usize> = BTreeMap::new();
    let mut found = Vec::new();
    for (path, (all, without_tests)) in files {
        if *all > LARGE[0] {
            found.push(format!("{path}: {all} lines"));
        }
        // `crates/a/src` is the crate.
        for (end, _) in path.match_indices('/').skip(2) {
            *folders.entry(&path[..end]).or_default() += without_tests;
        }
    }
    for (path, lines) in folders {
        let limit = if path.ends_with("/src") { LARGE[2] } else { LARGE[1] };
        if lines > limit {
            found.push(format!("{path}/: {lines} lines without tests"));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_large() {
        let files = [
            ("crates/a/src/lib.rs", (400, 400)),
            ("crates/a/src/b/c.rs", (401, 9_000)),
            ("crates/a/src/d/e.rs", (9, 3_000)),
        ];
        let files = files.map(|(path, lines)| (path.to_owned(), lines)).into();
        let expected = [
            "crates/a/src/b/c.rs: 401 lines",
            "crates/a/src/: 12400 lines without tests",
            "crates/a/src/b/: 9000 lines without tests",
        ];
        assert_eq!(large(&files), expected);
    }
}
