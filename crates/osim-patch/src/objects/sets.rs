//! The sets of contact objects: inserts new members, and records in the note how to remove them again. Also writes
//! the paths of sockets whose paths lead nowhere.

use osim_model::{ElementId, Fault, FaultKind, Irregularity, Model, Result, Tree};

use crate::edit::{Edit, model_with_edits};
use crate::insert::{EmptyForm, NewElement, append, escaped_attribute, fill, insert, removal_edit};
use crate::objects::rebuilt::{EarlierNote, ObjectAction, ObjectChange, RebuiltModel};

/// The elements of a model around its sets, in the order in which OpenSim writes them.
const ORDER_OF_SETS_IN_MODEL: [&str; 15] = [
    "Ground",
    "gravity",
    "credits",
    "publications",
    "length_units",
    "force_units",
    "BodySet",
    "JointSet",
    "ControllerSet",
    "ConstraintSet",
    FORCE_SET_TAG,
    "MarkerSet",
    GEOMETRY_SET_TAG,
    "ProbeSet",
    "ComponentSet",
];
/// The tag of the list of members in a set.
const OBJECTS_TAG: &str = "objects";

/// `ForceSet` or `ContactGeometrySet`, with the letters by which a note says which elements of it the program made. With them, removing
/// the members restores the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct ObjectSet {
    pub(super) tag: &'static str,
    /// The letter for a whole set that the program made.
    whole: char,
    /// The letter for an element `<objects>` that the program made in the set.
    objects: char,
    /// Letters for an empty element that the program opened, by its original form: for the set, and for its `<objects>`.
    opened: [[(char, EmptyForm); 3]; 2],
}

/// The set that has the forces of a model.
pub(super) const FORCE_SET: ObjectSet = ObjectSet {
    tag: FORCE_SET_TAG,
    whole: 'f',
    objects: 'o',
    opened: [
        [('t', EmptyForm::Closed), ('u', EmptyForm::ClosedWithBlank), ('v', EmptyForm::Open)],
        [('a', EmptyForm::Closed), ('d', EmptyForm::ClosedWithBlank), ('e', EmptyForm::Open)],
    ],
};
/// The set that has the contact geometry of a model.
pub(super) const GEOMETRY_SET: ObjectSet = ObjectSet {
    tag: GEOMETRY_SET_TAG,
    whole: 'g',
    objects: 'O',
    opened: [
        [('T', EmptyForm::Closed), ('U', EmptyForm::ClosedWithBlank), ('V', EmptyForm::Open)],
        [('A', EmptyForm::Closed), ('D', EmptyForm::ClosedWithBlank), ('E', EmptyForm::Open)],
    ],
};

impl ObjectSet {
    /// The first set of this kind in a model: OpenSim ignores a second one.
    pub(super) fn element(&self, tree: &Tree, model: ElementId) -> Option<ElementId> {
        tree.child(model, self.tag)
    }

    /// Puts `members` at the end of the set, and records the letters of the elements made for them.
    pub(super) fn add(
        &self,
        tree: &Tree,
        model: ElementId,
        members: &[NewElement],
        made: &mut String,
    ) -> Vec<Edit> {
        let Some(set) = self.element(tree, model) else {
            made.push(self.whole);
            let objects = NewElement::parent(OBJECTS_TAG, members.to_vec());
            let whole = NewElement::object(self.tag, &self.tag.to_ascii_lowercase(), vec![objects]);
            return insert(tree, model, &ORDER_OF_SETS_IN_MODEL, &[whole]);
        };
        let [of_set, of_objects] = &self.opened;
        let Some(objects) = tree.child(set, OBJECTS_TAG) else {
            made.push(self.objects);
            let list = NewElement::parent(OBJECTS_TAG, members.to_vec());
            return append_first(tree, set, &list)
                .map_or_else(|| fill_empty(tree, set, &[list], of_set, made), |edit| vec![edit]);
        };
        append(tree, objects, members)
            .map_or_else(|| fill_empty(tree, objects, members, of_objects, made), |edit| vec![edit])
    }

    /// A note's letters `made` for elements that the program made, without the letters for elements of this set.
    pub(super) fn without_letters(&self, made: &str) -> String {
        let own = |letter: char| {
            [self.whole, self.objects].contains(&letter)
                || self.opened.iter().flatten().any(|(known, _)| *known == letter)
        };
        made.chars().filter(|&letter| !own(letter)).collect()
    }

    /// The edit that removes the elements that [`Self::add`] made for the set, when none of its members stays; `None` if
    /// there are none.
    pub(super) fn restoring_edit(&self, tree: &Tree, model: ElementId, made: &str) -> Option<Edit> {
        let set = self.element(tree, model)?;
        let form = |letters: &[(char, EmptyForm); 3]| {
            letters.iter().find(|(letter, _)| made.contains(*letter)).map(|(_, form)| *form)
        };
        let [of_set, of_objects] = &self.opened;
        if made.contains(self.whole) {
            return Some(removal_edit(tree, tree.span(set)));
        }
        if let Some(form) = form(of_set) {
            return Some(form.restored(tree, set));
        }
        let objects = tree.child(set, OBJECTS_TAG)?;
        if made.contains(self.objects) {
            return Some(removal_edit(tree, tree.span(objects)));
        }
        form(of_objects).map(|form| form.restored(tree, objects))
    }
}

/// The edit that inserts `list` before the other content of `set`; `None` if the set is empty.
fn append_first(tree: &Tree, set: ElementId, list: &NewElement) -> Option<Edit> {
    let list = std::slice::from_ref(list);
    match tree.children(set).next() {
        Some(_) => insert(tree, set, &[OBJECTS_TAG, "groups"], list).pop(),
        None => append(tree, set, list),
    }
}

/// Puts `nodes` into an empty element, and records in `made` the letter for the form that it had.
fn fill_empty(
    tree: &Tree,
    element: ElementId,
    nodes: &[NewElement],
    letters: &[(char, EmptyForm); 3],
    made: &mut String,
) -> Vec<Edit> {
    let form = EmptyForm::of(tree, element);
    made.extend(letters.iter().find(|(_, known)| *known == form).map(|(letter, _)| *letter));
    fill(tree, element, nodes).into_iter().collect()
}

/// The tag of the set with the forces of a model.
pub(super) const FORCE_SET_TAG: &str = "ForceSet";
/// The tag of the set with the contact geometry of a model.
const GEOMETRY_SET_TAG: &str = "ContactGeometrySet";

/// Refuses a model in several files: a set in another file may belong to other models, too.
pub(super) fn refuse_partial_model(model: &Model) -> Result<()> {
    let document = model.document();
    let (tree, root) = (document.tree(), document.data_root());
    if tree.name(root) != "Model" {
        return Err(Fault::at_span(
            FaultKind::Refused(
                "this is a set without its model: only in whole models can contacts be added, converted or removed; name the \
                 model that it belongs to"
                    .to_owned(),
            ),
            tree.open_span(root),
        ));
    }
    for (element, file) in document.included_files() {
        if [FORCE_SET_TAG, GEOMETRY_SET_TAG].contains(&tree.name(element)) {
            let (path, span) = (tree.name(element).to_owned(), tree.open_span(element));
            return Err(Fault::at_span(FaultKind::IncludedFile { path, file }, span));
        }
    }
    Ok(())
}

/// The tags of sockets, for reports.
const SOCKET_TAGS: [&str; 7] = [
    "socket_frame",
    "socket_parent",
    "socket_parent_frame",
    "socket_child_frame",
    "socket_sphere",
    "socket_half_space",
    "body_name",
];

/// Writes into each socket that was resolved by name the path of the component that was found. No other byte changes.
///
/// # Errors
/// The model with these paths cannot be read.
pub fn connect_sockets(model: &Model) -> Result<RebuiltModel> {
    let tree = model.document().tree();
    let (mut edits, mut objects) = (Vec::new(), Vec::new());
    for irregularity in &model.irregularities {
        if let Irregularity::TakenByName { owner, taken, socket: Some(socket), .. } = irregularity {
            let tag = tree.name(*socket);
            edits.push(Edit { span: tree.raw_text(*socket).span, text: escaped_attribute(taken) });
            let class = SOCKET_TAGS.into_iter().find(|known| *known == tag).unwrap_or("socket");
            let name = owner.rsplit('/').next().unwrap_or_default();
            objects.push(ObjectChange::new(ObjectAction::Connected, class, [name, owner], Some(taken)));
        }
    }
    let mut rebuilt = RebuiltModel::new(model_with_edits(model, edits)?, objects, String::new());
    rebuilt.earlier_note = EarlierNote::Untouched;
    Ok(rebuilt)
}
