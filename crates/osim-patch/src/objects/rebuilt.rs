//! Models with objects added or removed, before a plan changes numbers in them; and names of new objects.

use std::ops::Range;
use std::sync::Arc;

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::messages::named;
use osim_model::{
    Document, ElementId, Fault, FileId, ForceKind, Model, Property, Result, opensim_text,
    refuse_name_in_paths,
};

named! {
    /// What a change does to a whole object: it adds, removes or connects it.
    pub enum ObjectAction {
        Added = "added",
        Removed = "removed",
        /// A socket of the object gets the path that OpenSim finds.
        Connected = "connected",
    }
}

/// An object that a plan adds, removes or connects.
#[derive(Debug, Clone, PartialEq)]
pub struct ObjectChange {
    pub action: ObjectAction,
    /// OpenSim's class of the object, such as `ContactSphere`; of a connected object, the tag of its socket.
    pub class: &'static str,
    pub name: String,
    /// Component path of the new object, or of the removed object before its removal.
    pub path: String,
    /// The body to which the object is attached, or for a force, its sphere; `None` for ground. For a connected object, the path that its
    /// socket gets.
    pub body: Option<String>,
    /// Parameters of a converted force, in their own units; empty for all other objects.
    pub parameters: Vec<(Property, f64)>,
}

impl ObjectChange {
    /// A change of the object with a name and a path, without parameters.
    pub(super) fn new(action: ObjectAction, class: &'static str, of: [&str; 2], body: Option<&str>) -> Self {
        let [name, path] = of.map(str::to_owned);
        Self { action, class, name, path, body: body.map(str::to_owned), parameters: Vec::new() }
    }
}

/// A model after objects were added or removed.
#[derive(Debug, Clone)]
pub struct RebuiltModel {
    model: Arc<Model>,
    /// Added and removed objects, in the order of reports.
    pub objects: Vec<ObjectChange>,
    /// Letters for the note's list of elements that the program made: letters of new elements, or those left after a removal.
    pub(crate) made: String,
    /// Names of new forces, for the note of a model that also has older contacts.
    pub(crate) added: Vec<String>,
    pub(crate) earlier_note: EarlierNote,
}

/// What happens to the earlier note of a model when objects change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EarlierNote {
    /// The earlier note is about these contacts: a new note replaces it.
    Replaced,
    /// The earlier note is about contacts that were removed before the new ones were added: it stays beside the new note.
    KeptBeside,
    /// The earlier note was about contacts that are now removed; the note is removed already.
    TakenOut,
    /// Only sockets change: the earlier note stays as it is.
    Untouched,
}

impl RebuiltModel {
    /// A rebuilt model; `made` are the letters of the elements that the program made in it.
    pub(crate) fn new(model: Model, objects: Vec<ObjectChange>, made: String) -> Self {
        let (model, added) = (Arc::new(model), Vec::new());
        Self { model, objects, made, added, earlier_note: EarlierNote::Replaced }
    }

    /// The model as if both steps were one change: with the changed objects of the `first` step, too.
    pub fn with_earlier_step(mut self, first: &Self) -> Self {
        self.objects.splice(0..0, first.objects.iter().cloned());
        // The earlier note still is about some contacts, so the new one replaces it.
        if first.earlier_note != EarlierNote::TakenOut {
            self.earlier_note = EarlierNote::Replaced;
        }
        self
    }

    /// The model with the new objects, before numbers change.
    pub fn model(&self) -> &Model {
        &self.model
    }
}

impl PartialEq for RebuiltModel {
    /// Whether bytes and objects are the same.
    fn eq(&self, other: &Self) -> bool {
        let bytes = |of: &'_ Self| of.model.file(FileId::MAIN).bytes().to_vec();
        self.objects == other.objects && self.made == other.made && bytes(self) == bytes(other)
    }
}

// Names for new objects, and elements of a file that refer to contact geometry by name.

/// Names that are used in a model or reserved for new objects.
pub(super) struct TakenNames {
    names: HashSet<String>,
    /// The first number that is not tried yet after a name.
    numbers: HashMap<String, u64>,
}

impl TakenNames {
    /// Names of contact geometry and forces of `model`: OpenSim silently renames a second object with the same name. Also
    /// names of missing geometry to which something refers: the reference would find a new object with that name.
    pub(super) fn of(model: &Model) -> Self {
        let geometry = model.spheres().iter().map(|sphere| sphere.name.clone());
        let planes = model.half_spaces().into_iter().map(|plane| plane.name);
        let members = ["ContactGeometrySet", "ForceSet"].into_iter().flat_map(|set| names_in_set(model, set));
        let mut taken: HashSet<String> = geometry.chain(planes).chain(members).collect();
        let document = model.document();
        for element in geometry_references(document) {
            taken.extend(geometry_names(&document.tree().text_of(element)).map(str::to_owned));
        }
        Self { names: taken, numbers: HashMap::new() }
    }

    /// Reserves `name`, with a number after it if it is taken.
    pub(super) fn reserve(&mut self, name: &str) -> Result<String> {
        refuse_name_in_paths(name)?;
        let mut taken = name.to_owned();
        let number = self.numbers.entry(taken.clone()).or_insert(2);
        while !self.names.insert(taken.clone()) {
            taken = format!("{name}_{number}");
            *number += 1;
        }
        Ok(taken)
    }
}

/// Refuses a reference to an object whose name or path is not UTF-8 in the file. Such a `name` was read with question marks, and
/// OpenSim would not find the object.
pub(super) fn refuse_non_utf8_name(model: &Model, name: &str) -> Result<()> {
    if !name.contains('?') || std::str::from_utf8(model.file(FileId::MAIN).bytes()).is_ok() {
        return Ok(());
    }
    Err(Fault::refused(format!(
        "'{name}' is written with bytes that are not UTF-8, so new contacts could not be connected to it: save the model as UTF-8 in \
         a text editor, then do this again"
    )))
}

/// The names of all objects in a set.
fn names_in_set(model: &Model, set: &str) -> Vec<String> {
    let document = model.document();
    let tree = document.tree();
    let objects = tree.child(document.data_root(), set).and_then(|set| tree.child(set, "objects"));
    let children = objects.into_iter().flat_map(|objects| tree.children(objects));
    children.filter_map(|id| Some(tree.attribute(id, "name")?.into_owned())).collect()
}

/// The elements of `document` that refer to contact geometry by name; not those in the `<defaults>` of forces.
pub(super) fn geometry_references(document: &Document) -> impl Iterator<Item = ElementId> + '_ {
    let tree = document.tree();
    let of_forces = |&id: &ElementId| {
        let kinds = [ForceKind::HuntCrossley, ForceKind::SmoothSphereHalfSpace];
        kinds.iter().any(|kind| kind.as_str() == tree.name(id))
    };
    let defaults = document.defaults().into_iter().flat_map(|defaults| tree.children(defaults));
    let left_out = OuterSpans::of(defaults.filter(of_forces).map(|element| tree.span(element)).collect());
    tree.elements().filter(move |&id| is_reference(tree.name(id)) && !left_out.covers(&tree.span(id)))
}

/// The names of geometry in the text of an element, without their paths.
pub(super) fn geometry_names(text: &str) -> impl Iterator<Item = &str> {
    opensim_text::list_words(text).map(|word| word.rsplit('/').next().unwrap_or(word))
}

/// Whether elements with this tag refer to contact geometry by name.
fn is_reference(tag: &str) -> bool {
    ["geometry", "socket_sphere", "socket_half_space", "socket_contact_geometry"].contains(&tag)
}

/// Spans in order, without spans inside other spans.
pub(super) struct OuterSpans(Vec<Range<usize>>);

impl OuterSpans {
    /// Keeps the `spans` that are not inside another span. Spans of elements do not overlap in other ways.
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

    /// Whether one of the spans contains `span`.
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
    fn a_span_covers_those_inside_it() {
        let covered = OuterSpans::of(vec![20..30, 0..10, 20..25, 26..30, 2..3]);
        assert_eq!(covered.spans(), [0..10, 20..30]);
        for (span, goes) in
            [(0..10, true), (2..9, true), (9..11, false), (10..20, false), (25..26, true), (31..32, false)]
        {
            assert_eq!(covered.covers(&span), goes, "{span:?}");
        }
        assert!(!OuterSpans::of(Vec::new()).covers(&(0..1)));
    }
}
