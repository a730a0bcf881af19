//! Reads the modules of a target, beginning with its `lib.rs` or `main.rs`.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::syntax::{Child, Record, docs_of, gather, only_in_tests};

use super::module::{Branch, ModuleId, Tree};
use super::place::Dir;

/// Reads a target. Findings show its files relative to `base`.
pub(crate) fn read(root: &Path, base: &Path) -> Result<Tree, Error> {
    let mut reader = Reader { base, tree: Tree::default() };
    reader.file(None, "crate", root, &Dir::beside(root))?;
    let mut tree = reader.tree;
    call_macros(&mut tree);
    Ok(tree)
}

/// A path as findings show it: relative, with `/` on every system.
pub(crate) fn shown(path: &Path, base: &Path) -> String {
    let path = path.strip_prefix(base).unwrap_or(path);
    let names: Vec<_> = path.components().map(|name| name.as_os_str().to_string_lossy()).collect();
    names.join("/")
}

/// Where the module that is read stands.
struct Here<'a> {
    parent: Option<ModuleId>,
    name: &'a str,
    file: &'a Path,
    dir: &'a Dir,
}

struct Reader<'b> {
    base: &'b Path,
    tree: Tree,
}

impl Reader<'_> {
    /// Reads a module in a file of its own; `None` where the file is for tests alone.
    fn file(
        &mut self,
        parent: Option<ModuleId>,
        name: &str,
        file: &Path,
        dir: &Dir,
    ) -> Result<Option<ModuleId>, Error> {
        let parsed = self.parsed(file)?;
        if only_in_tests(&parsed.attrs) {
            self.file_of_tests(file, dir)?;
            return Ok(None);
        }
        self.tree.files.entry(file.to_owned()).or_default().get_or_insert_default();
        let id = self.module(&Here { parent, name, file, dir }, &parsed.items)?;
        if let Some(module) = self.tree.get_mut(id) {
            docs_of(&parsed.attrs, &mut module.facts);
        }
        Ok(Some(id))
    }

    fn parsed(&self, file: &Path) -> Result<syn::File, Error> {
        let text =
            fs::read_to_string(file).map_err(|source| Error::Read { path: file.to_owned(), source })?;
        syn::parse_file(&text).map_err(|error| Error::Syntax {
            file: shown(file, self.base),
            line: error.span().start().line,
            message: error.to_string(),
        })
    }

    /// Reads the items of a module, and the modules in it.
    fn module(&mut self, here: &Here<'_>, items: &[syn::Item]) -> Result<ModuleId, Error> {
        let id = self.tree.add(here.parent, here.name, shown(here.file, self.base));
        let Record { facts, children, test_lines, .. } = gather(items);
        for rules in &facts.macros {
            self.tree.macros.entry(rules.name.clone()).or_default().push(id);
        }
        if let Some(module) = self.tree.get_mut(id) {
            module.facts = facts;
        }
        if let Some(Some(lines)) = self.tree.files.get_mut(here.file) {
            lines.extend(test_lines);
        }
        for child in children {
            if child.for_tests {
                self.child_of_tests(&child, here.dir)?;
            } else {
                self.child(id, &child, here)?;
            }
        }
        Ok(id)
    }

    fn child(&mut self, parent: ModuleId, child: &Child<'_>, here: &Here<'_>) -> Result<(), Error> {
        let name = child.name.as_str();
        let mut found = Vec::new();
        if let Some(items) = child.items {
            let dir = here.dir.inline(name, child.attributes);
            found.push(self.module(&Here { parent: Some(parent), name, file: here.file, dir: &dir }, items)?);
        } else {
            let files = here.dir.files(name, child.attributes);
            if files.is_empty() {
                let (file, line) = (shown(here.file, self.base), child.line);
                return Err(Error::NoFile { file, line, name: name.to_owned() });
            }
            for (file, dir) in files {
                found.extend(self.file(Some(parent), name, &file, &dir)?);
            }
        }
        if let Some(module) = self.tree.get_mut(parent) {
            module.children.extend(found.into_iter().map(|id| Branch {
                name: name.to_owned(),
                id,
                sight: child.sight,
            }));
        }
        Ok(())
    }

    /// Marks the files of a module for tests, which may be missing.
    fn child_of_tests(&mut self, child: &Child<'_>, dir: &Dir) -> Result<(), Error> {
        if let Some(items) = child.items {
            let dir = dir.inline(&child.name, child.attributes);
            return self.children_of_tests(items, &dir);
        }
        for (file, dir) in dir.files(&child.name, child.attributes) {
            self.file_of_tests(&file, &dir)?;
        }
        Ok(())
    }

    fn file_of_tests(&mut self, file: &Path, dir: &Dir) -> Result<(), Error> {
        self.tree.files.entry(PathBuf::from(file)).or_insert(None);
        let parsed = self.parsed(file)?;
        self.children_of_tests(&parsed.items, dir)
    }

    fn children_of_tests(&mut self, items: &[syn::Item], dir: &Dir) -> Result<(), Error> {
        for child in gather(items).children {
            self.child_of_tests(&child, dir)?;
        }
        Ok(())
    }
}

/// Gives the modules that call a macro of this crate the items whose names stand in its body.
fn call_macros(tree: &mut Tree) {
    let mut made = Vec::new();
    for (id, module) in tree.iter() {
        for called in &module.facts.called {
            let homes = tree.macros.get(called).into_iter().flatten();
            for home in homes.filter_map(|home| tree.get(*home)) {
                let rules = home.facts.macros.iter().filter(|rules| rules.name == *called);
                made.extend(rules.flat_map(|rules| &rules.defines).map(|item| (id, item.clone())));
            }
        }
    }
    for (id, item) in made {
        if let Some(module) = tree.get_mut(id) {
            module.facts.items.push(item);
        }
    }
}
