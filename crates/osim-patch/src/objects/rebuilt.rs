//! A model whose objects are others: what a plan builds on before numbers change.

use std::sync::Arc;

use osim_model::{FileId, Model, Property};

/// What happens to a whole object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Deed {
    Added,
    Removed,
}

impl Deed {
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Added => "added",
            Self::Removed => "removed",
        }
    }
}

/// One object that a plan adds or takes out.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjectChange {
    pub deed: Deed,
    /// OpenSim's class, such as `ContactSphere`.
    pub class: &'static str,
    pub name: String,
    /// Its component path: where it will be, or was.
    pub path: String,
    /// The body that carries it, or carries its sphere; `None` for ground.
    pub body: Option<String>,
    /// Parameters that a converted force is written with, in their own units; nothing for all others: what new contacts have
    /// are changes.
    pub parameters: Vec<(Property, f64)>,
}

/// A model with other objects than the one it was made from.
#[derive(Debug, Clone)]
pub struct Rebuilt {
    model: Arc<Model>,
    /// What was added or taken out, in the order in which reports list it.
    pub objects: Vec<ObjectChange>,
    /// Letters for a note's list of what was made: in addition, or what is left of it after a removal.
    pub(crate) made: String,
    /// Names of the forces that are new, for the note, where the model has others.
    pub(crate) added: Vec<String>,
    pub(crate) earlier_note: EarlierNote,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EarlierNote {
    /// Its contacts: a new note takes its place.
    OfContacts,
    /// Other contacts, which went before these were added: it stays beside a new one.
    OfOthers,
    /// The contacts are of others, and the note of those that went now is out already.
    TakenOut,
}

impl Rebuilt {
    pub(crate) fn new(model: Model, objects: Vec<ObjectChange>, made: String) -> Self {
        let (model, added) = (Arc::new(model), Vec::new());
        Self { model, objects, made, added, earlier_note: EarlierNote::OfContacts }
    }

    pub fn after(mut self, first: &Self) -> Self {
        self.objects.splice(0..0, first.objects.iter().cloned());
        // A part is left of what the earlier note is about: the new one takes its place.
        if first.earlier_note != EarlierNote::TakenOut {
            self.earlier_note = EarlierNote::OfContacts;
        }
        self
    }

    /// The model as it is then, before numbers change.
    pub fn model(&self) -> &Model {
        &self.model
    }
}

impl PartialEq for Rebuilt {
    /// Whether bytes and objects are the same.
    fn eq(&self, other: &Self) -> bool {
        let bytes = |of: &'_ Self| of.model.file(FileId::MAIN).bytes().to_vec();
        self.objects == other.objects && self.made == other.made && bytes(self) == bytes(other)
    }
}
