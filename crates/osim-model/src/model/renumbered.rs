//! A model with other numbers of its contacts, made without bytes: for who judges a change before it is written.

use std::sync::Arc;

use crate::model::contact_digest::ValueKey;
use crate::model::finding::Finding;
use crate::model::note::Note;
use crate::model::rules;
use crate::model::typed_model::Model;
use crate::model::value::{Origin, Value};

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
