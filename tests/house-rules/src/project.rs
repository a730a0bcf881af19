//! All crates of this project.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::module::{Tree, sources, trees};

/// Their modules, and the sizes of their files.
#[derive(Debug, Default)]
pub struct Project {
    /// The modules of each crate, those of its library and its program.
    pub trees: BTreeMap<String, Vec<Tree>>,
    /// Lines of each file, in all and without tests.
    pub lines: BTreeMap<String, (usize, usize)>,
}

impl Project {
    /// Reads the folder `crates` of a project.
    ///
    /// # Errors
    /// A file that cannot be read, or a module without one.
    pub fn read(root: &Path) -> Result<Self, String> {
        let folder = root.join("crates");
        let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let mut project = Self::default();
        for entry in entries.flatten().filter(|entry| entry.path().join("src").is_dir()) {
            let name = entry.file_name().to_string_lossy().into_owned();
            let (code, lines) = sources(&entry.path())?;
            let mut found = trees(&code).map_err(|error| format!("crates/{name}/{error}"))?;
            for module in found.iter_mut().flat_map(BTreeMap::values_mut) {
                module.file = format!("crates/{name}/{}", module.file);
            }
            project
                .lines
                .extend(lines.into_iter().map(|(file, lines)| (format!("crates/{name}/{file}"), lines)));
            project.trees.insert(name, found);
        }
        Ok(project)
    }

    /// What a rule finds in all crates but some, each once: a module of a library and a program is read for both.
    #[must_use]
    pub fn found(&self, rule: impl Fn(&Tree) -> Vec<String>, but: &[&str]) -> Vec<String> {
        let crates = self.trees.iter().filter(|(name, _)| !but.contains(&name.as_str()));
        let mut found: Vec<String> = crates.flat_map(|(_, trees)| trees).flat_map(rule).collect();
        found.sort();
        found.dedup();
        found
    }
}
