//! Makes a [`Model`] from documents, and from another model with new numbers.

use std::sync::{Arc, OnceLock};

use crate::model::contacts::ContactReader;
use crate::model::{
    Companion, Components, Document, Fault, FaultKind, FileId, MissingFact, Model, Note, NoteDoubt, Result,
    Skeleton, Value, ValueKey, ValueOrigin,
};

impl Model {
    /// Reads a model from the bytes of its only file.
    pub fn parse(bytes: impl Into<Vec<u8>>) -> Result<Self> {
        Self::read(Document::parse(bytes)?)
    }

    /// Reads a model that is in one file.
    pub fn read(document: Document) -> Result<Self> {
        Self::read_with(document, vec![])
    }

    /// Reads a model from its main file and the other files that belong to it.
    ///
    /// # Errors
    /// The document is neither a model nor a force set with its geometry, or a connection refers to no component.
    pub fn read_with(document: Document, companions: Vec<Companion>) -> Result<Self> {
        check_data_root(&document, companions.is_empty()).map_err(|fault| fault.located(document.bytes()))?;
        let components = Components::new(document, companions);
        let mut skeleton = Skeleton::read(&components);
        let mut reader = ContactReader::new(&components, &skeleton);
        if let Err(fault) = reader.read() {
            let document = components.document(fault.file);
            return Err(fault.located(document.bytes()));
        }
        let ContactReader { spheres, forces, irregularities, .. } = reader;
        skeleton.exclude_plates(&components, &forces, &spheres);
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
        let (note, note_fault) = match Note::find_or_unreadable(document)? {
            Some(Ok(note)) => (Some(note), None),
            Some(Err(_)) => (None, Some(NoteDoubt::Unreadable)),
            None => (None, None),
        };
        let named = |companion: &Companion| {
            let file = document.tree().attribute(companion.included_by?, "file")?;
            Some(file.into_owned())
        };
        let included = companions.iter().map(named).collect();
        let mut model = Self {
            components: Arc::new(components),
            skeleton: Arc::new(skeleton),
            body_facts: Arc::default(),
            half_spaces: OnceLock::new(),
            spheres,
            forces,
            note_fault,
            included,
            name,
            gravity_m_s2,
            note,
            irregularities,
            doubt_about_note: OnceLock::new(),
            findings: OnceLock::new(),
        };
        model.compare_notes();
        Ok(model)
    }

    /// Reads the model again after a change, from new `bytes` of its main file and of the files in `others`. Other files are unchanged.
    pub fn read_again(&self, bytes: Vec<u8>, others: &[(FileId, Vec<u8>)]) -> Result<Self> {
        let document = Document::parse(bytes)?;
        let mut named = document.included_files().into_iter();
        let companions = self.companions().map(|(file, companion)| {
            let included_by = companion.included_by.and_then(|_| named.next()).map(|(element, _)| element);
            let document = match others.iter().find(|(other, _)| *other == file) {
                Some((_, bytes)) => Document::parse(bytes.as_slice())?,
                None => companion.document.clone(),
            };
            Ok(Companion { document, included_by })
        });
        let companions = companions.collect::<Result<_>>()?;
        Self::read_with(document, companions)
    }

    /// Compares the notes of a force set and a geometry set. If both were written together, they have the same digest.
    fn compare_notes(&mut self) {
        let ours = self.note.as_ref().map(|note| note.digest.as_str());
        let is_beside =
            |companion: &Companion| companion.included_by.is_none() && !companion.document.is_model();
        let differs = |companion: &Companion| {
            Note::find(&companion.document).map(|note| note.digest).as_deref() != ours
        };
        if self.components.companions().iter().any(|companion| is_beside(companion) && differs(companion)) {
            self.note_fault = Some(NoteDoubt::MixedPair);
        }
    }
}

fn check_data_root(document: &Document, alone: bool) -> Result<()> {
    let tree = document.tree();
    let root = document.data_root();
    let kind = match tree.name(root) {
        "ForceSet" if alone => FaultKind::MissingFact(MissingFact::Geometry),
        "Model" | "ForceSet" => return Ok(()),
        "ContactGeometrySet" => FaultKind::MissingFact(MissingFact::ForceSet),
        tag => FaultKind::WrongDataRoot { tag: tag.to_owned() },
    };
    Err(Fault::at_span(kind, tree.open_span(root)))
}

// A model with other numbers of its contacts, made without bytes, so that a change can be judged before it is written.

impl Model {
    /// The model as it would be read after a change of numbers, without writing a file. `changed` gives the new values, and `note` is the
    /// new note. Places in the file are those before the change, and new numbers have no text.
    ///
    /// `None` if the result cannot be known without a file: the model has several files, or an earlier note is removed or cannot be read.
    pub fn with_contact_numbers(
        &self,
        changed: impl Fn(ValueKey) -> Option<f64>,
        note: Option<&Note>,
    ) -> Option<Self> {
        let is_alone = self.components.companions().is_empty() && self.document().is_model();
        let note = match note {
            Some(note) => Some(note.read_back()?),
            None if self.note.is_some() => return None,
            None => None,
        };
        if !is_alone || self.note_fault.is_some() {
            return None;
        }
        let (doubt_about_note, findings) = (OnceLock::new(), OnceLock::new());
        let mut model = Self { note_fault: None, note, doubt_about_note, findings, ..self.clone() };
        model.set_contact_numbers(changed);
        Some(model)
    }

    fn set_contact_numbers(&mut self, changed: impl Fn(ValueKey) -> Option<f64>) {
        let set_number = |file, object, value: &mut Value| {
            if let Some(number) = changed(ValueKey::new(file, object, value.property)) {
                value.set_number(number);
            }
        };
        for sphere in &mut self.spheres {
            let old = sphere.radius.number;
            set_number(sphere.file, sphere.element, &mut sphere.radius);
            let factor = sphere.radius.number / old;
            sphere.radii_m = sphere.radii_m.map(|radii| radii.map(|radius| radius * factor));
        }
        for force in &mut self.forces {
            for set in &mut force.sets {
                set.values.iter_mut().for_each(|value| set_number(force.file, set.element, value));
            }
            set_number(force.file, force.element, &mut force.transition_velocity);
        }
    }
}

impl Value {
    /// Sets the number as if it had been read from the object's own element, without a text.
    fn set_number(&mut self, number: f64) {
        (self.number, self.origin, self.fault) = (number, ValueOrigin::Element, None);
        self.text.clear();
    }
}
