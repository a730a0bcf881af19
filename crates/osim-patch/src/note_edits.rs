//! The edits that write a note into a file or remove it, and the list of operations (steps) in a note.

use std::collections::BTreeSet;
use std::ops::Range;

use foldhash::{HashMap, HashMapExt};
use osim_model::messages::readable;
use osim_model::{
    BodySize, Credits, Document, Force, Mass, MassSource, Model, Note, NoteDoubt, PieceKind, Scope, Source,
    SphereId, Step, Tree,
};

use crate::edit::{Edit, splice};
use crate::insert::{EmptyForm, NewElement, end_of_empty_tag, insert, insert_first_comment, removal_edit};

/// The elements that OpenSim writes before and after `<credits>` in a model.
const ORDER_AROUND_CREDITS: [&str; 6] =
    ["defaults", "Ground", "gravity", "credits", "publications", "length_units"];
/// The tag of the element that has a model's note.
const CREDITS_TAG: &str = "credits";
/// The letter in a note's list of made elements by which the program added `<credits>`. With it, removing the note restores the file.
const MADE_CREDITS_MARK: char = 'c';
/// The letters in a note's list of made elements by which the program opened an empty `<credits>` of each form.
const OPENED_MARKS: [(char, EmptyForm); 2] = [('s', EmptyForm::Closed), ('b', EmptyForm::ClosedWithBlank)];

/// The mass and scope of the note after a change.
pub(crate) struct NotedMass {
    pub(crate) kg: Option<f64>,
    pub(crate) scope: Scope,
}

impl NotedMass {
    /// A note about `all` contacts or a part of them.
    pub(crate) fn new(kg: Option<f64>, all: bool) -> Self {
        Self { kg, scope: if all { Scope::All } else { Scope::Partial } }
    }

    /// Decides the mass and scope of the note after a change of `model`; `contacts_mass` is the mass that its contacts were made for.
    /// In the table, a note has a mass (M) or none, and the scope all or partial:
    ///
    /// | note before the change | source of `contacts_mass` | note after the change |
    /// |---|---|---|
    /// | none | the mass of the bodies | no mass, all |
    /// | none, or any note | the caller | mass of the caller, all |
    /// | M, all | the note | M, all |
    /// | no mass, all | the mass of the bodies | no mass, all |
    /// | no mass, all, but the bodies were scaled later | the mass of the bodies | no mass, partial |
    /// | in doubt: partial, values changed later, or not readable | not the caller | mass of the note if any, partial |
    pub(crate) fn of(model: &Model, contacts_mass: Option<&Mass>) -> Self {
        let said = contacts_mass.filter(|mass| mass.source == MassSource::ContactsMass);
        let noted = model.note.as_ref().and_then(|note| note.contacts_mass_kg);
        match said {
            Some(mass) => Self::new(Some(mass.kg), true),
            None => Self::new(noted, model.doubt_about_note().is_none()),
        }
    }
}

/// Whether a note needs an element `<credits>` that `document` does not have.
pub(crate) fn adds_credits(document: &Document) -> bool {
    document.is_model() && matches!(Credits::of(document), Ok(None))
}

/// The letters in a note for elements that the program made in the model: those of the earlier note, and those that the new note adds;
/// `followed` as in [`noted_sizes`].
pub(crate) fn made_letters(model: &Model, followed: Option<&BTreeSet<SphereId>>) -> String {
    let document = model.document();
    let earlier = model.note.as_ref();
    let mut letters: BTreeSet<char> =
        earlier.map(|note| note.added_to_file.chars()).into_iter().flatten().collect();
    letters.retain(char::is_ascii_alphabetic);
    let was_placed =
        letters.remove(&Note::PLACED_MARK) && earlier.is_some_and(|note| is_unmoved(note, model));
    let follow = |followed: &BTreeSet<SphereId>| {
        model.loaded_spheres(&model.force_ids()).iter().all(|sphere| followed.contains(sphere))
    };
    if followed.map_or(was_placed, follow) {
        letters.insert(Note::PLACED_MARK);
    }
    // The letter for the form of an empty `<credits>` that the note opens.
    let opened = || {
        let credits = Credits::of(document).ok()??;
        let form = EmptyForm::of(document.tree(), credits.element);
        OPENED_MARKS.into_iter().find(|(_, known)| *known == form).map(|(letter, _)| letter)
    };
    letters.extend(if adds_credits(document) { Some(MADE_CREDITS_MARK) } else { opened() });
    if letters.is_empty() { Note::nothing_added() } else { letters.into_iter().collect() }
}

/// The letters of two notes for elements that the program made, each once.
pub(crate) fn merged_letters(made: &str, others: &str) -> String {
    let letters: BTreeSet<char> =
        made.chars().chain(others.chars()).filter(char::is_ascii_alphabetic).collect();
    if letters.is_empty() { Note::nothing_added() } else { letters.into_iter().collect() }
}

/// The letters of a note about new objects for elements that the program made, without the letters `earlier` of the note about the other
/// objects of the model.
pub(crate) fn letters_without_earlier(made: &str, earlier: &str) -> String {
    let own = |letter: &char| *letter == Note::PLACED_MARK || !earlier.contains(*letter);
    merged_letters(&made.chars().filter(own).collect::<String>(), "")
}

/// Whether all spheres are at the places that the note records.
fn is_unmoved(note: &Note, model: &Model) -> bool {
    model.has_places_of(note) == Some(true)
}

/// Sizes of the bodies for which the spheres are placed. A body has today's size if all its spheres moved with it (`followed`),
/// or if the earlier note gives no size or its spheres have moved since; else it has the size in the earlier note. So the note of
/// a model that OpenSim scaled later still gives the size of the body at which its spheres were placed. A body of which only some
/// spheres followed has no size in the note.
pub(crate) fn noted_sizes(model: &Model, followed: Option<&BTreeSet<SphereId>>) -> Vec<BodySize> {
    let noted = model.note.as_ref().filter(|note| !note.sizes.is_empty() && is_unmoved(note, model));
    let noted: HashMap<&str, &BodySize> =
        noted.into_iter().flat_map(|note| &note.sizes).rev().map(|old| (old.body.as_str(), old)).collect();
    let mut sizes = model.body_sizes();
    // Of each body, how many spheres followed it, and how many it has.
    let mut counts: HashMap<&str, (usize, usize)> = HashMap::new();
    let spheres: BTreeSet<SphereId> = model.forces().iter().flat_map(Force::spheres).copied().collect();
    for id in spheres {
        let Some(body) = model.sphere(id).and_then(|sphere| sphere.body.as_deref()) else { continue };
        let (some, all) = counts.entry(body).or_default();
        *some += usize::from(followed.is_some_and(|followed| followed.contains(&id)));
        *all += 1;
    }
    sizes.retain_mut(|size| match counts.get(size.body.as_str()).copied().unwrap_or_default() {
        (some, all) if some == all => true,
        (0, _) => {
            if let Some(before) = noted.get(size.body.as_str()) {
                size.factors = before.factors;
            }
            true
        }
        _ => false,
    });
    sizes
}

/// Writes `note` into the credits of a model, or as a comment into a set, and removes all earlier notes. With `is_second`, an earlier note
/// in the credits, about contacts that were removed, stays beside it; without the new note the text is as it was.
pub(crate) fn write_note(document: &Document, note: &Note, is_second: bool) -> Vec<Edit> {
    let (tree, root) = (document.tree(), document.data_root());
    if !document.is_model() {
        let (mut comments, text) = (Note::comment_spans(document), note.comment());
        let own = match comments.next() {
            Some(span) => Edit { span, text },
            None => insert_first_comment(tree, root, &text),
        };
        return std::iter::once(own).chain(comments.map(|span| removal_edit(tree, span))).collect();
    }
    match Credits::of(document) {
        Ok(Some(credits)) => {
            let edits = if is_second { credits.edits_for_another(note) } else { credits.edits(Some(note)) };
            edits_in_credits(tree, &credits, edits)
        }
        Ok(None) => insert(tree, root, &ORDER_AROUND_CREDITS, &[NewElement::leaf(CREDITS_TAG, note.text())]),
        // Reading such a model was refused.
        Err(_) => Vec::new(),
    }
}

/// Removes the note from `document`, and the element `<credits>` if it was added for the note.
pub(crate) fn remove_note(document: &Document) -> Vec<Edit> {
    let tree = document.tree();
    let made = Note::find(document).map(|note| note.added_to_file).unwrap_or_default();
    let mut edits: Vec<Edit> = Note::comment_spans(document).map(|span| removal_edit(tree, span)).collect();
    if let Ok(Some(credits)) = Credits::of(document) {
        let is_bare = credits.is_note_only()
            && tree.content(credits.element).all(|piece| piece.kind == PieceKind::Text);
        let form = OPENED_MARKS.into_iter().find(|(letter, _)| made.contains(*letter)).map(|(_, form)| form);
        if is_bare && made.contains(MADE_CREDITS_MARK) {
            edits.push(removal_edit(tree, tree.span(credits.element)));
        } else if let (true, Some(form)) = (is_bare, form) {
            edits.push(form.restored(tree, credits.element));
        } else {
            edits.extend(edits_in_credits(tree, &credits, credits.edits(None)));
        }
    }
    edits
}

/// The credits of the new model as OpenSim reads them, after `edits` in `document`; `None` if the new model has no credits.
pub(crate) fn credits_after(document: &Document, edits: &[Edit]) -> Option<String> {
    if !document.is_model() {
        return None;
    }
    let element = match Credits::of(document).ok()? {
        Some(credits) => bytes_with_edits(document, document.tree().span(credits.element), edits)?,
        // Only a note is inserted there.
        None => {
            edits.iter().map(|edit| &edit.text).find(|text| text.contains("<credits>"))?.clone().into_bytes()
        }
    };
    let around = ("<OpenSimDocument Version=\"40000\"><Model>", "</Model></OpenSimDocument>");
    let alone = Document::parse([around.0.as_bytes(), &element, around.1.as_bytes()].concat()).ok()?;
    Credits::of(&alone).ok()?.map(|credits| credits.text().to_owned())
}

/// The bytes of `span` after the edits in it; `None` if the edits remove all of `span`.
fn bytes_with_edits(document: &Document, span: Range<usize>, edits: &[Edit]) -> Option<Vec<u8>> {
    let holds =
        |outer: &Range<usize>, inner: &Range<usize>| outer.start <= inner.start && inner.end <= outer.end;
    if edits.iter().any(|edit| edit.text.is_empty() && holds(&edit.span, &span)) {
        return None;
    }
    // What is inserted beside the element is another one.
    let beside = |edit: &Edit| edit.span.end == span.start || edit.span.start == span.end;
    let within = edits.iter().filter(|edit| holds(&span, &edit.span) && !beside(edit));
    let shifted = within.map(|edit| Edit {
        span: edit.span.start - span.start..edit.span.end - span.start,
        text: edit.text.clone(),
    });
    splice(document.bytes().get(span.clone())?, &shifted.collect::<Vec<_>>()).ok()
}

/// The edits of the text of `<credits>` as edits of the file; an empty tag is opened.
fn edits_in_credits(tree: &Tree, credits: &Credits<'_>, edits: Vec<(Range<usize>, String)>) -> Vec<Edit> {
    if !tree.is_empty_tag(credits.element) {
        let edits = edits.into_iter().map(|(span, text)| Edit { span, text });
        return edits.filter(|edit| tree.slice(edit.span.clone()) != edit.text).collect();
    }
    let text: String = edits.into_iter().map(|(_, text)| text).collect();
    if text.is_empty() {
        return Vec::new();
    }
    vec![Edit { span: end_of_empty_tag(tree, credits.element), text: format!(">{text}</{CREDITS_TAG}>") }]
}

/// The largest number of steps in a note: the first step and the latest ones are kept.
const MOST_STEPS: usize = 8;
/// The operation of a step that records a change of values by another program or person, without a note.
pub(crate) const STEP_OF_OTHER_PROGRAMS: &str = "others";

/// Details of a change for its step in the note, which only the caller knows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StepDetails {
    /// Options that changed the result, as `name=value`.
    pub options: String,
    /// The model or preset that the contacts were taken from.
    pub reference: Option<Source>,
    /// Limbs that share the body weight, if the caller gave them.
    pub stance_limbs: Option<f64>,
    /// The date, such as `2026-11-25`, if known.
    pub date: Option<String>,
}

/// The steps of the note in `model`, with a step [`STEP_OF_OTHER_PROGRAMS`] at the end if values were changed since the note.
pub(crate) fn earlier_steps(model: &Model) -> Vec<Step> {
    let Some(note) = &model.note else { return Vec::new() };
    match model.doubt_about_note() {
        // A step that changes no values does not remove this doubt. The note says only once that others changed values.
        Some(NoteDoubt::ValuesChanged)
            if note.steps.iter().all(|step| step.operation != STEP_OF_OTHER_PROGRAMS) =>
        {
            steps_after(note.steps.clone(), Step::new(STEP_OF_OTHER_PROGRAMS))
        }
        _ => note.steps.clone(),
    }
}

/// `steps` with `step` at the end; a step that is equal to the last one is not added twice.
pub(crate) fn steps_after(mut steps: Vec<Step>, step: Step) -> Vec<Step> {
    if steps.last() != Some(&step) {
        steps.push(step);
    }
    if steps.len() > MOST_STEPS {
        steps.drain(1..=steps.len() - MOST_STEPS);
    }
    steps
}

pub(crate) fn limbs_in_words(stance_limbs: f64) -> String {
    format!("{} stance limb{}", readable(stance_limbs), if stance_limbs == 1.0 { "" } else { "s" })
}
