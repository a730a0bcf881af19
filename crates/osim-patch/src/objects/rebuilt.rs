//! A model whose objects are others, what a plan builds on before numbers change; and the names of new objects.

use std::ops::Range;
use std::sync::Arc;

use foldhash::HashSet;
use osim_model::{
    Document, ElementId, Fault, FileId, ForceKind, Model, Property, opensim_text, refuse_name_in_paths,
};

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

// Names of new objects, those that OpenSim takes, each once; and places of a file that name contact geometry.

/// Names that are taken in a model, or will be.
pub(super) struct Names(HashSet<String>);

impl Names {
    /// Those of the contact geometry and the forces of `model`: OpenSim renames the second of one name without a warning. Also
    /// names of geometry that it lacks and something uses: that would meet what is new.
    pub(super) fn of(model: &Model) -> Self {
        let geometry = model.spheres().iter().map(|sphere| sphere.name.clone());
        let planes = model.half_spaces().into_iter().map(|plane| plane.name);
        let members = ["ContactGeometrySet", "ForceSet"].into_iter().flat_map(|set| members(model, set));
        let mut taken: HashSet<String> = geometry.chain(planes).chain(members).collect();
        let document = model.document();
        for element in geometry_references(document) {
            taken.extend(geometry_names(&document.tree().text_of(element)).map(str::to_owned));
        }
        Self(taken)
    }

    /// `name`, or followed by a number where it is taken.
    pub(super) fn take(&mut self, name: &str) -> Result<String, Fault> {
        refuse_name_in_paths(name)?;
        let free = |name: &String| !self.0.contains(name);
        let numbered = (2_u64..).map(|number| format!("{name}_{number}"));
        let taken = std::iter::once(name.to_owned()).chain(numbered).find(free).unwrap_or_default();
        self.0.insert(taken.clone());
        Ok(taken)
    }
}

/// Refuses to call something of `model` by `name`, its name or path, where its bytes are not UTF-8: it was read with a question mark
/// for each of them, and OpenSim would not find it.
pub(super) fn refuse_misread(model: &Model, name: &str) -> Result<(), Fault> {
    if !name.contains('?') || std::str::from_utf8(model.file(FileId::MAIN).bytes()).is_ok() {
        return Ok(());
    }
    Err(Fault::refused(format!(
        "'{name}' is written with bytes that are not UTF-8, so new contacts could not be connected to it: save the model as UTF-8 in \
         a text editor, then do this again"
    )))
}

fn members(model: &Model, set: &str) -> Vec<String> {
    let document = model.document();
    let tree = document.tree();
    let objects = tree.child(document.data_root(), set).and_then(|set| tree.child(set, "objects"));
    let children = objects.into_iter().flat_map(|objects| tree.children(objects));
    children.filter_map(|id| Some(tree.attribute(id, "name")?.into_owned())).collect()
}

/// The elements of `document` that name contact geometry. What `<defaults>` name for forces is not among them: it counts only for
/// forces that have nothing of their own there.
pub(super) fn geometry_references(document: &Document) -> impl Iterator<Item = ElementId> + '_ {
    let tree = document.tree();
    let of_forces = |&id: &ElementId| {
        let kinds = [ForceKind::HuntCrossley, ForceKind::SmoothSphereHalfSpace];
        kinds.iter().any(|kind| kind.as_str() == tree.name(id))
    };
    let defaults = document.defaults().into_iter().flat_map(|defaults| tree.children(defaults));
    let left_out = Covered::of(defaults.filter(of_forces).map(|element| tree.span(element)).collect());
    tree.elements().filter(move |&id| is_reference(tree.name(id)) && !left_out.covers(&tree.span(id)))
}

/// The names that the text of such an element gives, without their paths.
pub(super) fn geometry_names(text: &str) -> impl Iterator<Item = &str> {
    opensim_text::list_words(text).map(|word| word.rsplit('/').next().unwrap_or(word))
}

/// Whether elements of this name name contact geometry.
fn is_reference(tag: &str) -> bool {
    ["geometry", "socket_sphere", "socket_half_space", "socket_contact_geometry"].contains(&tag)
}

/// Spans in order, none inside another one.
pub(super) struct Covered(Vec<Range<usize>>);

impl Covered {
    /// Those of `spans` that are in no other one of them. Spans do not overlap otherwise: they are elements.
    pub(super) fn of(mut spans: Vec<Range<usize>>) -> Self {
        // The longer first where two begin together.
        spans.sort_by_key(|span| (span.start, std::cmp::Reverse(span.end)));
        let mut end = 0;
        spans.retain(|span| {
            let is_outer = span.end > end;
            end = end.max(span.end);
            is_outer
        });
        Self(spans)
    }

    pub(super) fn covers(&self, span: &Range<usize>) -> bool {
        let behind = self.0.partition_point(|own| own.start <= span.start);
        self.0[..behind].last().is_some_and(|own| span.end <= own.end)
    }

    pub(super) fn spans(&self) -> &[Range<usize>] {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_inside_of_what_goes_goes_with_it() {
        let covered = Covered::of(vec![20..30, 0..10, 20..25, 26..30, 2..3]);
        assert_eq!(covered.spans(), [0..10, 20..30]);
        for (span, goes) in
            [(0..10, true), (2..9, true), (9..11, false), (10..20, false), (25..26, true), (31..32, false)]
        {
            assert_eq!(covered.covers(&span), goes, "{span:?}");
        }
        assert!(!Covered::of(Vec::new()).covers(&(0..1)));
    }
}
