//! Removes contacts from a model: forces, spheres that only these forces use, and sets made for them; and finds references to the
//! removed objects.

use std::collections::BTreeSet;

use foldhash::{HashSet, HashSetExt};
use indexmap::IndexMap;
use osim_model::{
    ComponentId, Document, ElementId, Fault, FaultKind, FileId, Force, ForceId, GEOMETRY_CLASSES, HalfSpace,
    Model, Note, OTHER_CONTACT_CLASSES, Result, Selected, SphereId, Tree, moving_spheres, opensim_text,
};

use crate::builder::refuse_included;
use crate::edit::{Edit, model_with_edits};
use crate::insert::removal_edit;
use crate::objects::add::MARK_OF_MADE_FLOOR;
use crate::objects::rebuilt::{
    EarlierNote, ObjectAction, ObjectChange, OuterSpans, RebuiltModel, geometry_names, geometry_references,
};
use crate::objects::sets::{FORCE_SET, GEOMETRY_SET, refuse_partial_model};

/// `model` without the forces `selected`, the forces of other classes `others`, and the moving geometry that only these use. A floor or set that [`add_contacts`]
/// made is removed, too, if nothing uses it. If all contacts from [`add_contacts`] are removed, also with changed numbers, the
/// file has the same bytes as before they were added.
///
/// [`add_contacts`]: crate::objects::add_contacts
///
/// # Errors
/// - A file that is a set and no model, or a model with a set in another file.
/// - A sphere or force that something else uses, such as another force class, by name.
pub fn remove(model: &Model, selected: &Selected, others: &[ComponentId]) -> Result<RebuiltModel> {
    refuse_partial_model(model)?;
    let going: HashSet<ForceId> = selected.forces.iter().copied().collect();
    let staying = || model.forces().iter().filter(|force| !going.contains(&force.id));
    let used: HashSet<SphereId> = staying().flat_map(Force::spheres).copied().collect();
    let mut elements: Vec<ElementId> = Vec::new();
    let mut objects: Vec<ObjectChange> = Vec::new();
    let removed =
        |class, of: [&str; 2], body: Option<&str>| ObjectChange::new(ObjectAction::Removed, class, of, body);
    let mut spheres: BTreeSet<SphereId> = BTreeSet::new();
    for force in selected.forces.iter().filter_map(|&id| model.force(id)) {
        refuse_included(model, force.file, &force.path)?;
        elements.push(force.element);
        let moving = moving_spheres(model, &[force.id]).into_iter().filter_map(|id| model.sphere(id));
        let body = moving.clone().find_map(|sphere| sphere.body.clone());
        objects.push(removed(force.kind.as_str(), [&force.name, &force.path], body.as_deref()));
        spheres.extend(moving.filter(|sphere| !sphere.is_inside_force()).map(|sphere| sphere.id));
    }
    spheres.retain(|sphere| !used.contains(sphere));
    let mut going_names: HashSet<String> = HashSet::new();
    for sphere in spheres.iter().filter_map(|&id| model.sphere(id)) {
        refuse_included(model, sphere.file, &sphere.path)?;
        elements.push(sphere.element);
        going_names.insert(sphere.name.clone());
        objects.push(removed(sphere.class.as_str(), [&sphere.name, &sphere.path], sphere.body.as_deref()));
    }
    remove_others(model, others, (&mut elements, &mut objects, &mut going_names))?;
    let mut made = model.note.as_ref().map(|note| note.added_to_file.clone()).unwrap_or_default();
    if made.contains(MARK_OF_MADE_FLOOR) {
        let planes = |force: &Force| -> Vec<HalfSpace> {
            force.sets.iter().flat_map(|set| model.half_spaces_of(set)).collect()
        };
        let still_used: HashSet<(FileId, ElementId)> =
            staying().flat_map(planes).map(|plane| (plane.file, plane.element)).collect();
        let mut floors = selected.forces.iter().filter_map(|&id| model.force(id)).flat_map(planes);
        let floor = floors.find(|plane| !still_used.contains(&(plane.file, plane.element)));
        if let Some(floor) = floor.filter(|floor| floor.file == FileId::MAIN) {
            elements.push(floor.element);
            going_names.insert(floor.name.clone());
            objects.push(removed("ContactHalfSpace", [&floor.name, &floor.path], None));
            made.retain(|letter| letter != MARK_OF_MADE_FLOOR);
        }
    }
    refuse_users(model, &elements, &going_names)?;
    let mut rebuilt = model_with_edits(model, removal_edits(model, &elements, &mut made))?;
    let is_last = !crate::note::leaves_noted_contacts(model, &rebuilt) || removes_all_added(model, &going);
    if is_last {
        // Without contacts, a note about contacts would be wrong.
        rebuilt = model_with_edits(&rebuilt, crate::note_edits::remove_note(rebuilt.document()))?;
    }
    let made = crate::note_edits::merged_letters(&made, "");
    let mut rebuilt = RebuiltModel::new(rebuilt, objects, made);
    if is_last {
        rebuilt.earlier_note = EarlierNote::TakenOut;
    }
    Ok(rebuilt)
}

/// Adds the forces of other classes `others` to what is removed, and the geometry that nothing else uses. Their half-spaces stay.
fn remove_others(
    model: &Model,
    others: &[ComponentId],
    (elements, objects, names): (&mut Vec<ElementId>, &mut Vec<ObjectChange>, &mut HashSet<String>),
) -> Result<()> {
    let components = model.components();
    let mut add = |id: ComponentId| -> Result<()> {
        let (path, name) = (components.tree.path(id), components.name(id));
        refuse_included(model, components.file_of(id), &path)?;
        elements.push(components.element(id));
        let mut classes = OTHER_CONTACT_CLASSES.into_iter().chain(GEOMETRY_CLASSES);
        let class = classes.find(|class| *class == components.tag(id)).unwrap_or_default();
        objects.push(ObjectChange::new(ObjectAction::Removed, class, [&name, &path], None));
        Ok(())
    };
    others.iter().try_for_each(|&force| add(force))?;
    let tree = model.document().tree();
    let spans = others.iter().map(|&force| tree.span(components.element(force)));
    let gone = OuterSpans::of(spans.collect());
    let staying = geometry_references(model.document()).filter(|&element| !gone.covers(&tree.span(element)));
    let texts: Vec<_> = staying.map(|element| tree.text_of(element)).collect();
    let used: HashSet<&str> = texts.iter().flat_map(|text| geometry_names(text)).collect();
    let by_force = model.surfaces_of_other_classes();
    for &id in others.iter().filter_map(|force| by_force.get(force)).flatten() {
        let name = components.name(id).into_owned();
        let stays = components.tag(id) == "ContactHalfSpace" || used.contains(name.as_str());
        if !stays && names.insert(name) {
            add(id)?;
        }
    }
    Ok(())
}

/// The forces that were added to `model` and are recorded in its note; `None` if the note has no such record.
pub fn added_forces(model: &Model) -> Option<Vec<ForceId>> {
    let note = model.note.as_ref()?;
    let all = note.added_to_file.contains(Note::ALL_ADDED_MARK);
    let is_named = note.is_added_force();
    let is_added = |force: &&Force| {
        if all { force.sets.iter().any(|set| set.half_spaces > 0) } else { is_named(&force.name) }
    };
    let forces: Vec<ForceId> = model.forces().iter().filter(is_added).map(|force| force.id).collect();
    (!forces.is_empty()).then_some(forces)
}

/// Whether all forces recorded as added are removed, so that the note is about no force any more.
fn removes_all_added(model: &Model, going: &HashSet<ForceId>) -> bool {
    let beside_others = model.note.as_ref().is_some_and(|note| !note.added_forces.is_empty());
    beside_others && added_forces(model).is_some_and(|added| added.iter().all(|force| going.contains(force)))
}

/// Edits that remove `elements`. If a set loses all its members, the elements in `made` are removed from it, too, with their
/// letters.
fn removal_edits(model: &Model, elements: &[ElementId], made: &mut String) -> Vec<Edit> {
    let document = model.document();
    let (tree, root) = (document.tree(), document.data_root());
    let going: HashSet<ElementId> = elements.iter().copied().collect();
    let mut edits: Vec<Edit> = Vec::new();
    for set in [FORCE_SET, GEOMETRY_SET] {
        if is_emptied(tree, set.element(tree, root), &going) {
            edits.extend(set.restoring_edit(tree, root, made));
            *made = set.without_letters(made);
        }
    }
    let restored = OuterSpans::of(edits.iter().map(|edit| edit.span.clone()).collect());
    let gone = OuterSpans::of(elements.iter().map(|&element| tree.span(element)).collect());
    for span in gone.spans() {
        let edit = removal_edit(tree, span.clone());
        if !restored.covers(&edit.span) {
            edits.push(edit);
        }
    }
    edits
}

/// Whether a set loses all of its members.
fn is_emptied(tree: &Tree, set: Option<ElementId>, going: &HashSet<ElementId>) -> bool {
    let Some(objects) = set.and_then(|set| tree.child(set, "objects")) else { return false };
    let mut members = tree.children(objects).peekable();
    members.peek().is_some() && members.all(|member| going.contains(&member))
}

/// Refuses to remove geometry to which other elements of the file refer, because OpenSim would refuse the file.
fn refuse_users(model: &Model, elements: &[ElementId], going: &HashSet<String>) -> Result<()> {
    let document = model.document();
    let tree = document.tree();
    let gone = OuterSpans::of(elements.iter().map(|&element| tree.span(element)).collect());
    for element in geometry_references(document) {
        let span = tree.span(element);
        let text = tree.text_of(element);
        let Some(name) = geometry_names(&text).find(|name| going.contains(*name)) else { continue };
        if !gone.covers(&span) {
            return Err(Fault::at_span(in_use_fault(document, element, name), span));
        }
    }
    Ok(())
}

/// The fault for the use of the geometry `name` by `element`.
fn in_use_fault(document: &Document, element: ElementId, name: &str) -> FaultKind {
    let tree = document.tree();
    let is_above = |defaults| OuterSpans::of(vec![tree.span(defaults)]).covers(&tree.span(element));
    let (place, way_out) = match document.defaults().is_some_and(is_above) {
        true => (
            " in <defaults>",
            "take that out of the file in a text editor first, as OpenSim does not show it",
        ),
        false => ("", "take that out in OpenSim first"),
    };
    FaultKind::Refused(format!(
        "<{}>{place} uses {name}, which would go: {way_out}, or choose the forces that go",
        tree.name(element)
    ))
}

/// An object that still refers to removed objects by name. OpenSim reads such a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DanglingReference {
    /// Class and name of the object, such as `ObjectGroup feet`.
    pub object: String,
    /// The names of removed objects, in the order in which the object has them.
    pub names: Vec<String>,
}

/// Finds objects of `rebuilt` that refer to removed objects: groups refer by names, reporters and other objects by paths.
pub fn dangling_references(rebuilt: &RebuiltModel) -> Vec<DanglingReference> {
    let paths = |action: ObjectAction| {
        let own = rebuilt.objects.iter().filter(move |object| object.action == action);
        own.map(|object| object.path.as_str()).collect::<HashSet<&str>>()
    };
    let new = paths(ObjectAction::Added);
    let gone: HashSet<&str> =
        paths(ObjectAction::Removed).into_iter().filter(|path| !new.contains(path)).collect();
    if gone.is_empty() {
        return Vec::new();
    }
    let tree = rebuilt.model().document().tree();
    let mut by_owner: IndexMap<Option<ElementId>, Vec<String>> = IndexMap::new();
    for leaf in tree.elements().filter(|&id| tree.children(id).next().is_none()) {
        let names = names_of_removed(tree, leaf, &gone);
        if names.is_empty() {
            continue;
        }
        by_owner.entry(named_owner(tree, leaf)).or_default().extend(names);
    }
    let reference = |(owner, mut names): (Option<ElementId>, Vec<String>)| {
        let mut said = HashSet::new();
        names.retain(|name| said.insert(name.clone()));
        DanglingReference { object: class_and_name(tree, owner), names }
    };
    by_owner.into_iter().map(reference).collect()
}

/// The names in the text of `leaf` that are in `gone`.
fn names_of_removed(tree: &Tree, leaf: ElementId, gone: &HashSet<&str>) -> Vec<String> {
    let set = if tree.name(leaf) == "members" { set_of_group(tree, leaf) } else { None };
    let text = tree.text_of(leaf);
    // Most texts are numbers.
    if set.is_none() && !text.contains('/') {
        return Vec::new();
    }
    let path = |word: &str| match &set {
        Some(set) => Some(format!("/{set}/{word}")).filter(|path| gone.contains(path.as_str())),
        None => removed_object_in(word, gone),
    };
    opensim_text::list_words(&text)
        .filter_map(path)
        .map(|path| path.rsplit('/').next().unwrap_or_default().to_owned())
        .collect()
}

/// The component path of the set to which the group with the element `members` belongs.
fn set_of_group(tree: &Tree, members: ElementId) -> Option<String> {
    let groups = tree.parent(tree.parent(members)?)?;
    let set = tree.name(tree.parent(groups)?);
    [FORCE_SET.tag, GEOMETRY_SET.tag].contains(&set).then(|| set.to_ascii_lowercase())
}

/// The path in `gone` that is equal to a path or contains it: `/forceset/heel|force` is an output of `/forceset/heel`.
fn removed_object_in(word: &str, gone: &HashSet<&str>) -> Option<String> {
    let path = word.split('|').next().unwrap_or(word).trim_start_matches(['.', '/']);
    let path = format!("/{path}");
    let ends = path.match_indices('/').map(|(at, _)| at).skip(1).chain([path.len()]);
    let mut objects = ends.filter_map(|end| path.get(..end));
    objects.find(|object| gone.contains(object)).map(str::to_owned)
}

/// The named object to which the property `leaf` belongs.
fn named_owner(tree: &Tree, leaf: ElementId) -> Option<ElementId> {
    std::iter::successors(tree.parent(leaf), |&id| tree.parent(id))
        .find(|&id| tree.attribute(id, "name").is_some())
}

/// The class and the name of an object, for messages.
fn class_and_name(tree: &Tree, owner: Option<ElementId>) -> String {
    let name = |id: ElementId| Some(format!("{} {}", tree.name(id), tree.attribute(id, "name")?));
    owner.and_then(name).unwrap_or_default()
}
