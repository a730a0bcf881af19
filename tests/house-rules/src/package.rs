//! One crate of a workspace: its manifest, its modules, its files.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use walkdir::WalkDir;

use crate::error::Error;
use crate::manifest::{Dependency, Manifest};
use crate::tree::{self, Tree, shown};

/// A crate.
#[derive(Debug)]
pub(crate) struct Package {
    pub(crate) name: String,
    /// Its `Cargo.toml`, as findings show it.
    pub(crate) manifest: String,
    /// Its folder of sources, as findings show it.
    pub(crate) sources: String,
    pub(crate) dependencies: Vec<Dependency>,
    /// The library, and each program.
    pub(crate) trees: Vec<Tree>,
    pub(crate) files: Vec<SourceFile>,
}

/// A file in `src`.
#[derive(Debug)]
pub(crate) struct SourceFile {
    /// As findings show it.
    pub(crate) path: String,
    /// All its lines.
    pub(crate) lines: usize,
    /// Those of test code.
    pub(crate) lines_of_tests: usize,
}

impl Package {
    /// Reads the crate in a folder. Findings show its files relative to `base`.
    pub(crate) fn read(name: String, dir: &Path, base: &Path, manifest: Manifest) -> Result<Self, Error> {
        let trees = roots(dir, &manifest.roots)?
            .iter()
            .map(|root| tree::read(root, base))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            name,
            manifest: shown(&dir.join("Cargo.toml"), base),
            sources: shown(&dir.join("src"), base),
            dependencies: manifest.dependencies,
            files: files(dir, base, &trees)?,
            trees,
        })
    }

    /// Names of other crates, as the source writes them.
    pub(crate) fn crates(&self) -> Vec<String> {
        self.dependencies.iter().map(|dependency| dependency.key.replace('-', "_")).collect()
    }
}

/// The files that targets begin with: those of the manifest, and those in the usual places.
fn roots(dir: &Path, named: &[PathBuf]) -> Result<BTreeSet<PathBuf>, Error> {
    let mut found: BTreeSet<PathBuf> = named.iter().map(|path| dir.join(path)).collect();
    found.extend(
        ["src/lib.rs", "src/main.rs"].iter().map(|path| dir.join(path)).filter(|path| path.is_file()),
    );
    let programs = dir.join("src/bin");
    if programs.is_dir() {
        let wrong = |source| Error::Read { path: programs.clone(), source };
        for entry in fs::read_dir(&programs).map_err(wrong)? {
            let path = entry.map_err(wrong)?.path();
            let inside = path.join("main.rs");
            if path.extension().is_some_and(|extension| extension == "rs") {
                found.insert(path);
            } else if inside.is_file() {
                found.insert(inside);
            }
        }
    }
    Ok(found)
}

/// All files in `src`, also those that no module is made of.
fn files(dir: &Path, base: &Path, trees: &[Tree]) -> Result<Vec<SourceFile>, Error> {
    let mut files = Vec::new();
    let sources = dir.join("src");
    if !sources.is_dir() {
        return Ok(files);
    }
    for entry in WalkDir::new(&sources).sort_by_file_name() {
        let entry = entry.map_err(|error| Error::Read { path: sources.clone(), source: error.into() })?;
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "rs") || !entry.file_type().is_file() {
            continue;
        }
        let text =
            fs::read_to_string(path).map_err(|source| Error::Read { path: path.to_owned(), source })?;
        let lines = text.lines().count();
        let lines_of_tests = lines_of_tests(path, lines, trees);
        files.push(SourceFile { path: shown(path, base), lines, lines_of_tests });
    }
    Ok(files)
}

/// A file may belong to several targets: it is test code if it is so in all of them.
fn lines_of_tests(path: &Path, lines: usize, trees: &[Tree]) -> usize {
    let known = trees.iter().filter_map(|tree| tree.files.get(path));
    known.map(|tests| tests.as_ref().map_or(lines, BTreeSet::len)).min().unwrap_or(0)
}
