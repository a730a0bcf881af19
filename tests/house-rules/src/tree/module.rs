//! A tree of modules.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::PathBuf;

use crate::syntax::{Facts, Sight};

/// Which module of a [`Tree`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct ModuleId(usize);

impl ModuleId {
    /// The module of `lib.rs` or `main.rs`.
    pub(crate) const ROOT: Self = Self(0);
}

/// One module.
#[derive(Debug)]
pub(crate) struct Module {
    /// As in `crate::a::b`.
    pub(crate) path: String,
    pub(crate) parent: Option<ModuleId>,
    /// The file it stands in, as findings show it.
    pub(crate) file: String,
    pub(crate) facts: Facts,
    pub(crate) children: Vec<Branch>,
}

/// A module in a module.
#[derive(Debug)]
pub(crate) struct Branch {
    pub(crate) name: String,
    pub(crate) id: ModuleId,
    pub(crate) sight: Sight,
}

/// All modules of one target. Every module stands behind its parent.
#[derive(Debug, Default)]
pub(crate) struct Tree {
    modules: Vec<Module>,
    /// For each file, its lines of test code; `None` for a file that is nothing else.
    pub(crate) files: BTreeMap<PathBuf, Option<BTreeSet<usize>>>,
    /// Where the `macro_rules!` of each name stand.
    pub(crate) macros: HashMap<String, Vec<ModuleId>>,
}

impl Tree {
    /// Adds a module without contents.
    pub(crate) fn add(&mut self, parent: Option<ModuleId>, name: &str, file: String) -> ModuleId {
        let above = parent.and_then(|parent| self.get(parent)).map(|parent| parent.path.as_str());
        let path = above.map_or_else(|| name.to_owned(), |above| format!("{above}::{name}"));
        let facts = Facts::default();
        self.modules.push(Module { path, parent, file, facts, children: Vec::new() });
        ModuleId(self.modules.len() - 1)
    }

    /// A module; every id that this tree gave out has one.
    pub(crate) fn get(&self, id: ModuleId) -> Option<&Module> {
        self.modules.get(id.0)
    }

    /// The same, to be changed.
    pub(crate) fn get_mut(&mut self, id: ModuleId) -> Option<&mut Module> {
        self.modules.get_mut(id.0)
    }

    /// All modules, parents first.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (ModuleId, &Module)> {
        self.modules.iter().enumerate().map(|(index, module)| (ModuleId(index), module))
    }

    /// The module and all those it stands in, from within outwards.
    pub(crate) fn upwards(&self, id: ModuleId) -> impl Iterator<Item = ModuleId> {
        std::iter::successors(Some(id), |id| self.get(*id).and_then(|module| module.parent))
    }

    /// The module in which something in `home` with this sight is seen, and in all below it.
    pub(crate) fn top(&self, home: ModuleId, sight: Sight) -> ModuleId {
        let way: Vec<ModuleId> = self.upwards(home).collect();
        let steps = match sight {
            Sight::Up(steps) => steps,
            Sight::Depth(depth) => way.len().saturating_sub(depth + 1),
        };
        way.get(steps).copied().unwrap_or(ModuleId::ROOT)
    }
}
