//! The note of a model, for the person who received the file: how the contacts were made, and what changed after that.

use osim_model::messages::{four_significant, four_significant_apart, readable, shown};
use osim_model::{ChangedSinceNote, Model, Note, Scope, Step};
use serde::Serialize;

use crate::serialized::json_records;

/// Content of a model's note.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct NoteSummary {
    /// Version of the tool that wrote the note.
    pub version: String,
    /// Steps of change of the contacts, the oldest first.
    pub steps: Vec<NoteStep>,
    /// Limbs that share the body weight, if the note gives a number.
    pub stance_limbs: Option<f64>,
    /// Mass of all bodies together when the note was written, kg.
    pub weighed_kg: Option<f64>,
    /// Changes since the note was written, in words.
    pub changed_since: Vec<String>,
    /// The whole note in sentences.
    #[serde(skip)]
    pub sentences: Vec<String>,
}

json_records! {
    /// A change of the contacts that the note records.
    NoteStep from step: &Step {
        /// The verb with its values: `set stiffness=x2`; `others` if values were changed without a note.
        operation: String = step.operation.clone(),
        /// Options that mattered, as `name=value`.
        options: String = step.options.clone(),
        /// Mass the contacts were made for before, kg.
        from_mass_kg: Option<f64> = step.from_mass_kg,
        /// Model or preset that the contacts were taken from.
        reference: Option<String> = step.reference.as_ref().map(|source| source.name.clone()),
        /// The first 16 digits of the SHA-256 of the reference's file.
        reference_digest: Option<String> =
            step.reference.as_ref().and_then(|source| source.digest.clone()),
        /// The date of the change, as `2026-11-25`.
        date: Option<String> = step.date.clone(),
    }
}

impl NoteSummary {
    /// Summarises the note of `model`; `None` if the model has no note.
    pub fn of(model: &Model) -> Option<Self> {
        let note = model.note.as_ref()?;
        let changed_since = changes_in_words(&model.changed_since_note());
        let mut sentences = vec![note_in_words(note)];
        if !changed_since.is_empty() {
            sentences.push(format!("Changed since: {}.", changed_since.join("; ")));
        }
        Some(Self {
            version: note.version.clone(),
            steps: note.steps.iter().map(NoteStep::from).collect(),
            stance_limbs: note.stance_limbs,
            weighed_kg: note.weighed_kg,
            changed_since,
            sentences,
        })
    }
}

/// A note in words, for example `These contacts were made for 41 kg: taken from falisse2022, made for 62 kg, on 2026-11-25; with 2 stance
/// limbs.`
fn note_in_words(note: &Note) -> String {
    let which = match note.scope {
        Scope::All => "These contacts",
        Scope::Partial => "Some of these contacts",
    };
    let mass = note
        .contacts_mass_kg
        .map_or("for what the bodies weighed".to_owned(), |kg| format!("for {} kg", four_significant(kg)));
    let limbs = note.stance_limbs.map(|limbs| {
        let s = if limbs == 1.0 { "" } else { "s" };
        format!(", with {} stance limb{s}", readable(limbs))
    });
    let steps: Vec<String> = note.steps.iter().map(step_in_words).collect();
    format!("{which} were made {mass}{}: {}.", limbs.unwrap_or_default(), steps.join("; then "))
}

/// A step of a note in words, for example `transfer from falisse2022, made for 62 kg, on 2025-11-26`.
pub(crate) fn step_in_words(step: &Step) -> String {
    let from = step.from_mass_kg.map(|kg| format!("{} kg", four_significant(kg)));
    let mut text = match (step.operation.as_str(), &step.reference) {
        ("others", _) => "values changed by somebody who left no note".to_owned(),
        (_, Some(source)) => {
            let digest = source.digest.as_ref().map(|digest| format!(" (SHA-256 {digest}...)"));
            let made_for = from.map(|kg| format!(", made for {kg}")).unwrap_or_default();
            let name = shown(&source.name);
            format!("{} from {name}{}{made_for}", shown(&step.operation), digest.unwrap_or_default())
        }
        (operation, None) => {
            let from = from.map(|kg| format!(" from {kg}")).unwrap_or_default();
            format!("{}{from}", shown(operation))
        }
    };
    if !step.options.is_empty() {
        text.push_str(&format!(" with {}", shown(&step.options)));
    }
    text + &step.date.as_ref().map(|date| format!(" on {}", shown(date))).unwrap_or_default()
}

/// The changes since the note was written, each as a part of one sentence; empty if nothing changed.
fn changes_in_words(changed: &ChangedSinceNote) -> Vec<String> {
    let sizes = changed.sizes.then(|| "sizes of bodies".to_owned());
    let weight = changed.weight_kg.map(|(then, now)| {
        let [then, now] = four_significant_apart([then, now]);
        format!("the bodies weighed {then} kg then and weigh {now} kg now")
    });
    let contacts = &changed.contacts;
    let count = |what: &str, count: Option<(usize, usize)>| {
        count.map(|(then, now)| format!("the contacts had {then} {what} then and have {now} now"))
    };
    let counts: Vec<String> = count("spheres", contacts.sphere_count)
        .into_iter()
        .chain(count("forces", contacts.force_count))
        .collect();
    let unknown = (!counts.is_empty())
        .then(|| "the note cannot show whether other numbers of the contacts changed, too".to_owned());
    let others = [
        (contacts.radii, "radii"),
        (contacts.places, "places of spheres"),
        (contacts.sphere_names, "names of spheres"),
        (contacts.force_names, "names of forces"),
        (contacts.exchanged, "which contact has which numbers"),
    ];
    let others = others.into_iter().filter(|(is_changed, _)| *is_changed).map(|(_, name)| name.to_owned());
    let properties = contacts.properties.iter().map(|property| property.as_str().to_owned());
    let of_contacts = counts.into_iter().chain(unknown).chain(others).chain(properties);
    of_contacts.chain(sizes).chain(weight).collect()
}
