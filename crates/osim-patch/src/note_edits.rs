//! The edits that leave a note in a file, or take it out.

use std::ops::Range;

use osim_model::{BodySize, Credits, Document, ElementId, Model, Note, PieceKind, Tree};

use crate::edit::Edit;
use crate::insert::{insert, insert_first, with_white_space_before};

/// What OpenSim writes before and after `<credits>` in a model.
const ORDER: [&str; 6] = ["defaults", "Ground", "gravity", "credits", "publications", "length_units"];
const CREDITS: &str = "credits";
/// Letters in a note's list of what was made: the element `<credits>` was added, or opened from one of these tags. Without the
/// note the file is again what it was.
const MADE_CREDITS: char = 'c';
const OPENED: [(char, &str); 2] = [('s', "<credits/>"), ('b', "<credits />")];

/// Whether `document` keeps its note in credits that it does not have yet.
pub(crate) fn adds_credits(document: &Document) -> bool {
    is_model(document) && matches!(Credits::of(document), Ok(None))
}

/// `made` of an earlier note and what a note in `document` adds.
pub(crate) fn made(document: &Document, earlier: Option<&Note>) -> String {
    let before = earlier.map_or_else(Note::nothing_made, |note| note.made.clone());
    let added = if adds_credits(document) { Some(MADE_CREDITS) } else { opened(document) };
    let Some(added) = added.filter(|letter| !before.contains(*letter)) else { return before };
    before.chars().filter(char::is_ascii_alphabetic).chain([added]).collect()
}

fn opened(document: &Document) -> Option<char> {
    let credits = Credits::of(document).ok()??;
    let tag = document.tree().slice(document.tree().span(credits.element));
    OPENED.into_iter().find(|(_, closed)| *closed == tag).map(|(letter, _)| letter)
}

/// Sizes of the bodies for which the spheres are placed: those that the earlier note gives while its places stay, else those of
/// today. A model that OpenSim scaled after the note was written goes on saying which size its spheres belong to, until they
/// `follow` their bodies.
pub(crate) fn sizes(model: &Model, follow: bool) -> Vec<BodySize> {
    let unmoved =
        |note: &&Note| note.places.as_ref().is_some_and(|places| *places == model.places_digest(|_| None));
    match model.note.as_ref().filter(|note| !follow && !note.sizes.is_empty()).filter(unmoved) {
        Some(note) => note.sizes.clone(),
        None => model.body_sizes(),
    }
}

/// Leaves `note` in `document`, in the place of an earlier one.
pub(crate) fn leave(document: &Document, note: &Note) -> Vec<Edit> {
    let (tree, root) = (document.tree(), document.data_root());
    let comment = Note::comment_span(document);
    if !is_model(document) {
        let text = note.comment();
        return vec![match comment {
            Some(span) => Edit { span, text },
            None => insert_first(tree, root, &text),
        }];
    }
    // A comment of an earlier version would be lost when OpenSim saves the file: its note moves.
    let mut edits: Vec<Edit> = comment.map(|span| without(tree, span)).into_iter().collect();
    match Credits::of(document) {
        Ok(Some(credits)) => edits.push(filled(tree, &credits, Some(note))),
        Ok(None) => edits.extend(insert(tree, root, &ORDER, &[(CREDITS, note.text())])),
        // Reading such a model was refused.
        Err(_) => {}
    }
    edits
}

/// Takes the note out of `document`, and the element `<credits>` where it was added for it.
pub(crate) fn remove(document: &Document) -> Vec<Edit> {
    let tree = document.tree();
    let mut edits: Vec<Edit> =
        Note::comment_span(document).map(|span| without(tree, span)).into_iter().collect();
    if let Ok(Some(credits)) = Credits::of(document) {
        let edit = filled(tree, &credits, None);
        let made = Note::find(document).map(|note| note.made).unwrap_or_default();
        let is_bare = edit.text.is_empty() && contains_only_text(tree, credits.element);
        let closed = OPENED.into_iter().find(|(letter, _)| made.contains(*letter)).map(|(_, tag)| tag);
        if is_bare && made.contains(MADE_CREDITS) {
            edits.push(without(tree, tree.span(credits.element)));
        } else if let (true, Some(tag)) = (is_bare, closed) {
            edits.push(Edit { span: tree.span(credits.element), text: tag.to_owned() });
        } else if tree.slice(edit.span.clone()) != edit.text {
            edits.push(edit);
        }
    }
    edits
}

/// The text of `credits` with `note` at its end.
fn filled(tree: &Tree, credits: &Credits<'_>, note: Option<&Note>) -> Edit {
    let text = credits.with(note);
    if !tree.is_empty_tag(credits.element) {
        return Edit { span: credits.span.clone(), text };
    }
    let span = tree.span(credits.element);
    let tag = tree.slice(span.clone());
    let open = tag.strip_suffix("/>").unwrap_or(tag).trim_ascii_end();
    let text = if text.is_empty() { tag.to_owned() } else { format!("{open}>{text}</{CREDITS}>") };
    Edit { span, text }
}

fn without(tree: &Tree, span: Range<usize>) -> Edit {
    Edit { span: with_white_space_before(tree, span), text: String::new() }
}

fn contains_only_text(tree: &Tree, element: ElementId) -> bool {
    tree.content(element).all(|piece| piece.kind == PieceKind::Text)
}

fn is_model(document: &Document) -> bool {
    document.tree().name(document.data_root()) == "Model"
}
