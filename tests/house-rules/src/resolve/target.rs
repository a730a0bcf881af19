//! What a path leads to.

use crate::syntax::{Item, Spaces};
use crate::tree::ModuleId;

/// What a path leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Target {
    /// A module as a whole.
    Module(ModuleId),
    /// An item, or something that belongs to it.
    Item {
        /// The module that defines it.
        home: ModuleId,
        name: String,
        spaces: Spaces,
        is_trait: bool,
    },
    /// Something of another crate, by its full path.
    Outside(Vec<String>),
}

impl Target {
    /// An item of `home`.
    pub(super) fn of_item(home: ModuleId, item: &Item) -> Self {
        Self::Item { home, name: item.name.clone(), spaces: item.spaces, is_trait: item.is_trait }
    }

    /// Something in `home` of which only the name is known.
    pub(super) fn named(home: ModuleId, name: &str, spaces: Spaces) -> Self {
        Self::Item { home, name: name.to_owned(), spaces, is_trait: false }
    }

    /// The name spaces in which it stands.
    pub(super) fn spaces(&self) -> Spaces {
        match self {
            Self::Module(_) => Spaces::TYPES,
            Self::Item { spaces, .. } => *spaces,
            Self::Outside(_) => Spaces::ALL,
        }
    }
}
