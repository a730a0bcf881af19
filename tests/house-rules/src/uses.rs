//! Which module uses which: the arrows between the modules of a crate.

use std::collections::BTreeSet;

use crate::resolve::{Resolver, Target};
use crate::syntax::{Import, Mention, Path, Spaces};
use crate::tree::{Module, ModuleId, Tree};

/// One module names what another one defines.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Use {
    pub(crate) from: ModuleId,
    pub(crate) to: ModuleId,
    pub(crate) line: usize,
    /// As it is written.
    pub(crate) path: String,
}

/// All uses in a tree, each place once.
pub(crate) fn uses(tree: &Tree, crates: &[String]) -> Vec<Use> {
    let resolver = Resolver::new(tree, crates);
    let mut finder = Finder { resolver, found: BTreeSet::new() };
    for (id, module) in tree.iter() {
        for import in &module.facts.imports {
            finder.import(id, module, import, tree);
        }
        for mention in &module.facts.mentions {
            finder.mention(id, mention);
        }
    }
    finder.found.into_iter().collect()
}

struct Finder<'t> {
    resolver: Resolver<'t>,
    found: BTreeSet<Use>,
}

impl Finder<'_> {
    fn add(&mut self, from: ModuleId, to: ModuleId, line: usize, path: String) {
        if from != to {
            self.found.insert(Use { from, to, line, path });
        }
    }

    fn import(&mut self, from: ModuleId, module: &Module, import: &Import, tree: &Tree) {
        let targets = self.resolver.import(from, import);
        let path = if import.glob { format!("{}::*", import.path) } else { import.path.to_string() };
        for target in &targets {
            match target {
                Target::Item { home, .. } => self.add(from, *home, import.line, path.clone()),
                Target::Module(whole) if import.glob => {
                    for to in self.through_glob(from, *whole, import) {
                        self.add(from, to, import.line, path.clone());
                    }
                }
                Target::Module(whole) => {
                    if !import.sight.is_private() || !leads_on(module, import) {
                        self.add(from, *whole, import.line, path.clone());
                    }
                }
                Target::Outside(_) => {}
            }
        }
        if !import.sight.is_private() && !import.glob {
            self.facade(from, import, tree);
        }
    }

    /// The modules that a glob uses. One that passes names on uses all that they come from. A private one uses the
    /// module, if there is something of its own to be seen, and traits, which nobody names; what else it brings in
    /// counts where it is named.
    fn through_glob(&self, from: ModuleId, whole: ModuleId, import: &Import) -> Vec<ModuleId> {
        let passes_on = !import.sight.is_private();
        let contents = self.resolver.contents(whole, from);
        let homes = contents.iter().filter_map(|target| match target {
            Target::Item { home, is_trait, .. } => (passes_on || *is_trait).then_some(*home),
            _ => None,
        });
        let mut used: Vec<ModuleId> = homes.collect();
        let own = |target: &Target| matches!(target, Target::Item { home, .. } if *home == whole);
        if passes_on || contents.iter().any(own) {
            used.push(whole);
        }
        used
    }

    /// `pub use child::Item` uses `child`, even where `child` has the item from elsewhere.
    fn facade(&mut self, from: ModuleId, import: &Import, tree: &Tree) {
        let Some((_, prefix)) = import.path.segments.split_last() else { return };
        let prefix = Path { global: import.path.global, segments: prefix.to_vec() };
        for target in self.resolver.path(from, &prefix, Spaces::ALL) {
            if let Target::Module(passed) = target
                && tree.upwards(passed).any(|above| above == from)
            {
                self.add(from, passed, import.line, import.path.to_string());
            }
        }
    }

    /// A path in the code. One that begins with an imported item says nothing that its `use` has not said.
    fn mention(&mut self, from: ModuleId, mention: &Mention) {
        let Some((first, rest)) = mention.path.segments.split_first() else { return };
        let imported = self.resolver.imports_named(from, first);
        let module_meant = !rest.is_empty() || mention.want == Spaces::ALL;
        let is_module = |target: &Target| matches!(target, Target::Module(_));
        let leads_on = module_meant && imported.iter().any(is_module);
        if !imported.is_empty() && !leads_on {
            return;
        }
        for target in self.resolver.path(from, &mention.path, mention.want) {
            let to = match target {
                Target::Module(to) | Target::Item { home: to, .. } => to,
                Target::Outside(_) => continue,
            };
            let mark = if mention.want == Spaces::MACROS { "!" } else { "" };
            self.add(from, to, mention.line, format!("{}{mark}", mention.path));
        }
    }
}

/// Whether a path of the same module goes on from an imported module. Then that path says what is used.
fn leads_on(module: &Module, import: &Import) -> bool {
    let Some(name) = &import.name else { return false };
    let goes_on = |path: &Path| path.segments.len() > 1 && path.segments.first() == Some(name);
    module.facts.mentions.iter().any(|mention| goes_on(&mention.path))
        || module.facts.imports.iter().any(|import| goes_on(&import.path))
}
