//! Documents → [`Model`], and models with other numbers of their contacts.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::model::components::{Companion, ComponentId, Components};
use crate::model::contact_digest::ValueKey;
use crate::model::contacts::ContactReader;
use crate::model::document::Document;
use crate::model::fault::{Fault, FaultKind, FileId, Needed, NoteDoubt};
use crate::model::finding::Finding;
use crate::model::note::{Note, NotesFound};
use crate::model::property::{Origin, Value};
use crate::model::rules::{self, reading};
use crate::model::skeleton::Skeleton;
use crate::model::typed_model::{BodyFacts, Model};
use crate::xml::{ElementId, KeptElements};

/// Elements of a model that say nothing of bodies, joints and frames.
const APART_FROM_BODIES: [&str; 3] = ["ContactGeometrySet", "ForceSet", "credits"];

impl Model {
    /// Reads a model from the bytes of one file.
    ///
    /// # Errors
    /// Those of [`Document::parse`] and of [`Model::read_with`].
    pub fn parse(bytes: impl Into<Vec<u8>>) -> Result<Self, Fault> {
        Self::read(Document::parse(bytes)?)
    }

    /// Reads a model from one file.
    ///
    /// # Errors
    /// See [`Model::read_with`].
    pub fn read(document: Document) -> Result<Self, Fault> {
        Self::read_with(document, vec![])
    }

    /// Reads a model from its main file and the companions that belong to it.
    ///
    /// # Errors
    /// A document that is not a model and no force set with its geometry, or a connection that leads nowhere.
    pub fn read_with(document: Document, companions: Vec<Companion>) -> Result<Self, Fault> {
        check_data_root(&document, companions.is_empty()).map_err(|fault| fault.located(document.bytes()))?;
        let components = Components::new(document, companions);
        let skeleton = Skeleton::read(&components);
        Self::of_components(components, skeleton, Arc::default())
    }

    fn of_components(
        components: Components,
        skeleton: Skeleton,
        body_facts: Arc<BodyFacts>,
    ) -> Result<Self, Fault> {
        let mut reader = ContactReader::new(&components, &skeleton);
        if let Err(fault) = reader.read() {
            let document = components.document(fault.file);
            return Err(fault.located(document.bytes()));
        }
        let ContactReader { spheres, forces, warnings, .. } = reader;
        let (document, companions) = (components.main(), components.companions());
        let gravity = match components.model_file().map(|file| components.document(file)) {
            Some(document) => document
                .whole_triple(document.data_root(), "gravity")
                .map_err(|fault| fault.located(document.bytes()))?,
            None => None,
        };
        let gravity_m_s2 = gravity
            .or(Some(Self::DEFAULT_GRAVITY))
            .filter(|gravity| gravity.iter().all(|value| value.is_finite()));
        let name = document.tree().attribute(document.data_root(), "name").unwrap_or_default().into_owned();
        let notes = NotesFound::of(document)?;
        let named = |companion: &Companion| {
            let file = document.tree().attribute(companion.included_by?, "file")?;
            Some(file.into_owned())
        };
        let included = companions.iter().map(named).collect();
        let mut model = Self {
            components: Arc::new(components),
            skeleton: Arc::new(skeleton),
            body_facts,
            half_spaces: OnceLock::new(),
            spheres,
            forces,
            note_fault: None,
            included,
            name,
            gravity_m_s2,
            note: None,
            found_by: Vec::new(),
            warnings: Vec::new(),
        };
        model.take_note(notes);
        let found = rules::find(&model);
        model.warn(warnings, found);
        model.compare_notes();
        Ok(model)
    }

    /// The same model with other bytes of its main file; `edits` says where these are new, as for [`Document::edited`]. Files beside
    /// it stay, but for `others`, which have new bytes.
    ///
    /// # Errors
    /// Those of [`Document::parse`] and of [`Model::read_with`].
    pub fn rebuilt(
        &self,
        bytes: Vec<u8>,
        edits: &[(Range<usize>, usize)],
        others: &[(FileId, Vec<u8>)],
    ) -> Result<Self, Fault> {
        let document = self.document().edited(bytes, edits)?;
        let mut named = document.included_files().into_iter();
        let companions = self.companions().map(|(file, companion)| {
            let changed = others.iter().find(|(other, _)| *other == file);
            let included_by = companion.included_by.and_then(|_| named.next()).map(|(element, _)| element);
            let document = match changed {
                Some((_, bytes)) => Document::parse(bytes.as_slice())?,
                None => companion.document.clone(),
            };
            Ok(Companion { document, included_by })
        });
        let companions = companions.collect::<Result<_, Fault>>()?;
        match self.kept_elements(&document, edits).filter(|_| others.is_empty()) {
            Some(kept) => {
                let components = self.components.moved(document, companions, &kept);
                let skeleton = self.skeleton.moved(&components);
                Self::of_components(components, skeleton, Arc::clone(&self.body_facts))
            }
            None => Self::read_with(document, companions),
        }
    }

    /// Where the elements are in `document`, which `edits` made of the main file, if these changed nothing but the properties of contacts
    /// and forces, and credits; `None` if they did more, or moved an element that something is known of.
    fn kept_elements(&self, document: &Document, edits: &[(Range<usize>, usize)]) -> Option<KeptElements> {
        let tree = self.document().tree();
        let is_apart = |owner: ElementId| {
            let above = std::iter::successors(Some(owner), |&id| tree.parent(id));
            let above: Vec<&str> = above.map(|id| tree.name(id)).collect();
            // What is put among objects is a new component.
            !["objects", "components"].contains(&tree.name(owner))
                && above.iter().any(|tag| APART_FROM_BODIES.contains(tag))
                && !above.iter().any(|tag| is_of_bodies(tag))
        };
        let kept = tree.kept_elements(document.tree(), edits, is_apart)?;
        let stays = |id: ComponentId| {
            let element = self.components.element(id);
            !is_of_bodies(self.components.tag(id))
                || self.components.file_of(id) != FileId::MAIN
                || kept.place(element) == element
        };
        self.components.tree.iter().all(|(id, _)| stays(id)).then_some(kept)
    }

    /// Of the note in the credits and that of an earlier version in a comment, the one that describes these contacts counts;
    /// where neither does, or both do, the one in the credits.
    fn take_note(&mut self, notes: NotesFound) {
        let found: Vec<_> = [notes.credits, notes.comment].into_iter().flatten().collect();
        let fits = |note: &Note| found.len() > 1 && self.has_values_of(note);
        let chosen = found.iter().position(|note| note.as_ref().is_ok_and(fits)).unwrap_or(0);
        match found.into_iter().nth(chosen) {
            Some(Ok(note)) => self.note = Some(note),
            Some(Err(_)) => self.note_fault = Some(NoteDoubt::Unreadable),
            None => {}
        }
    }

    /// A force set and a geometry set that were written together carry the same digest.
    fn compare_notes(&mut self) {
        let ours = self.note.as_ref().map(|note| note.digest.as_str());
        let beside = self.components.companions().iter();
        let beside = beside
            .filter(|companion| companion.included_by.is_none() && !companion.document.is_model())
            .filter(|companion| Note::find(&companion.document).map(|note| note.digest).as_deref() != ours)
            .count();
        for _ in 0..beside {
            self.note_fault = Some(NoteDoubt::MixedPair);
            self.warnings.push(reading::mixed_pair());
        }
    }
}

/// Whether what is known of bodies is read from elements called so.
fn is_of_bodies(tag: &str) -> bool {
    tag == "Body" || tag.ends_with("Joint") || tag.ends_with("Frame")
}

fn check_data_root(document: &Document, alone: bool) -> Result<(), Fault> {
    let tree = document.tree();
    let root = document.data_root();
    let kind = match tree.name(root) {
        "ForceSet" if alone => FaultKind::Needed(Needed::Geometry),
        "Model" | "ForceSet" => return Ok(()),
        "ContactGeometrySet" => FaultKind::Needed(Needed::ForceSet),
        tag => FaultKind::WrongDataRoot { tag: tag.to_owned() },
    };
    Err(Fault::over(kind, tree.open_span(root)))
}

// A model with other numbers of its contacts, made without bytes: for who judges a change before it is written.

impl Model {
    /// The model that reading its file would give once it has these numbers: `changed` gives the new value of those that change, and `note`
    /// is its new note. Lines and other places in the file are those of the file as it is now, and new numbers have no text.
    ///
    /// `None` where this cannot be known without a file: other files belong to the model, or an earlier note goes or cannot be read.
    #[must_use]
    pub fn renumbered(&self, changed: impl Fn(ValueKey) -> Option<f64>, note: Option<&Note>) -> Option<Self> {
        let is_alone = self.components.companions().is_empty() && self.document().is_model();
        let note = match note {
            Some(note) => Some(note.as_read()?),
            None if self.note.is_some() => return None,
            None => None,
        };
        if !is_alone || self.note_fault.is_some() {
            return None;
        }
        let mut model = Self {
            components: Arc::clone(&self.components),
            skeleton: Arc::clone(&self.skeleton),
            body_facts: Arc::clone(&self.body_facts),
            half_spaces: self.half_spaces.clone(),
            spheres: self.spheres.clone(),
            forces: self.forces.clone(),
            note_fault: None,
            included: self.included.clone(),
            name: self.name.clone(),
            gravity_m_s2: self.gravity_m_s2,
            note,
            warnings: Vec::new(),
            found_by: Vec::new(),
        };
        model.take_numbers(changed);
        let mut before = self.warnings_by_finder();
        let read = before.next().unwrap_or_default().to_vec();
        let found = rules::find_again(&model, before);
        model.warn(read, found);
        Some(model)
    }

    fn take_numbers(&mut self, changed: impl Fn(ValueKey) -> Option<f64>) {
        let take = |file, object, value: &mut Value| {
            if let Some(number) = changed(ValueKey::new(file, object, value.property)) {
                value.take(number);
            }
        };
        for sphere in &mut self.spheres {
            take(sphere.file, sphere.element, &mut sphere.radius);
        }
        for force in &mut self.forces {
            for set in &mut force.sets {
                set.values.iter_mut().for_each(|value| take(force.file, set.element, value));
            }
            take(force.file, force.element, &mut force.transition_velocity);
        }
    }

    /// Adds what reading the contacts showed, and then what each rule found.
    pub(crate) fn warn(&mut self, read: Vec<Finding>, found: Vec<Vec<Finding>>) {
        for found in std::iter::once(read).chain(found) {
            self.found_by.push(found.len());
            self.warnings.extend(found);
        }
    }

    /// The same again, one by one.
    fn warnings_by_finder(&self) -> impl Iterator<Item = &[Finding]> {
        let mut start = 0;
        self.found_by.iter().map(move |count| {
            let own = start..start + count;
            start = own.end;
            self.warnings.get(own).unwrap_or_default()
        })
    }
}

impl Value {
    /// Becomes what is read where `number` is written; nobody asks for the text of a number that is one.
    fn take(&mut self, number: f64) {
        (self.number, self.origin, self.fault) = (number, Origin::Element, None);
        self.text.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = include_str!("../../tests/data/one_foot.osim");

    /// Whether the model with `new` in the place of `old` is taken for one with the same bodies.
    fn keeps_bodies(old: &str, new: &str) -> bool {
        let model = Model::parse(TEXT).unwrap();
        let at = TEXT.find(old).unwrap();
        let text = TEXT.replacen(old, new, 1);
        // What differs.
        let before = old.bytes().zip(new.bytes()).take_while(|(a, b)| a == b).count();
        let ends = old.bytes().skip(before).rev().zip(new.bytes().skip(before).rev());
        let after = ends.take_while(|(a, b)| a == b).count();
        let edits = [(at + before..at + old.len() - after, new.len() - before - after)];
        let rebuilt = model.rebuilt(text.clone().into_bytes(), &edits, &[]).unwrap();
        let read = Model::parse(text).unwrap();
        let tags = |model: &Model| {
            let of = |(id, _)| (model.components.tree.path(id), model.components.tag(id).to_owned());
            model.components.tree.iter().map(of).collect::<Vec<_>>()
        };
        assert_eq!(tags(&rebuilt), tags(&read));
        assert_eq!(rebuilt.joints(), read.joints());
        Arc::ptr_eq(&model.body_facts, &rebuilt.body_facts)
    }

    #[test]
    fn a_change_of_contacts_alone_keeps_what_is_known_of_bodies() {
        let sphere = "</ContactSphere>";
        assert!(keeps_bodies("<radius>0.03", "<radius>0.035"));
        assert!(keeps_bodies(
            "\n\t\t\t\t</ContactSphere>",
            "\n\t\t\t\t\t<location>0 0.1 0</location>\n\t\t\t\t</ContactSphere>"
        ));
        // A mass, a new sphere, a name.
        assert!(!keeps_bodies("<mass>10", "<mass>20"));
        let another = format!("{sphere}<ContactSphere><socket_frame>/ground</socket_frame>{sphere}");
        assert!(!keeps_bodies(sphere, &another));
        assert!(!keeps_bodies("name=\"contact_heel_r\"", "name=\"other\""));
    }
}
