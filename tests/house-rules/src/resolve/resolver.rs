//! Answers what a path or an import of a module means.

use crate::syntax::{Import, Path, Spaces};
use crate::tree::{ModuleId, Tree};

use super::build::scopes;
use super::scopes::Scopes;
use super::target::Target;

/// Looks names up in a tree.
pub(crate) struct Resolver<'t> {
    scopes: Scopes<'t>,
}

impl<'t> Resolver<'t> {
    /// For the modules of `tree`, whose crate depends on `crates`.
    pub(crate) fn new(tree: &'t Tree, crates: &'t [String]) -> Self {
        Self { scopes: scopes(tree, crates) }
    }

    /// Everything that a path outside of `use` can mean at this place.
    pub(crate) fn path(&self, from: ModuleId, path: &Path, want: Spaces) -> Vec<Target> {
        let mut found = self.scopes.follow(from, path, true);
        if let ([name], true, Spaces::MACROS) = (path.segments.as_slice(), found.is_empty(), want) {
            return self.textual_macro(from, name);
        }
        found.retain(|target| {
            target.spaces().meets(want) && (want == Spaces::ALL || !matches!(target, Target::Module(_)))
        });
        found
    }

    /// Everything that an import brings in. For a glob, this is the module or enum before the `*`.
    pub(crate) fn import(&self, from: ModuleId, import: &Import) -> Vec<Target> {
        let mut found = self.scopes.follow(from, &import.path, true);
        found.retain(|target| target.spaces().meets(import.spaces));
        found
    }

    /// What the imports of a module that bring in this name mean, leaving globs out.
    pub(crate) fn imports_named(&self, module: ModuleId, name: &str) -> Vec<Target> {
        let imports = self.scopes.tree.get(module).into_iter().flat_map(|module| &module.facts.imports);
        let named = imports.filter(|import| import.name.as_deref() == Some(name));
        named.flat_map(|import| self.import(module, import)).collect()
    }

    /// Everything that `viewer` sees in a module, through re-exports too.
    pub(crate) fn contents(&self, module: ModuleId, viewer: ModuleId) -> Vec<Target> {
        self.scopes.seen(module, viewer).into_iter().map(|(_, entry)| entry.target).collect()
    }

    /// A macro that is in scope because its `macro_rules!` stands before: in this module, one above, or any.
    fn textual_macro(&self, from: ModuleId, name: &str) -> Vec<Target> {
        let Some(homes) = self.scopes.tree.macros.get(name) else { return Vec::new() };
        let nearest = self.scopes.tree.upwards(from).find(|above| homes.contains(above));
        let homes = nearest.map_or_else(|| homes.clone(), |home| vec![home]);
        homes.into_iter().map(|home| Target::named(home, name, Spaces::MACROS)).collect()
    }
}
