//! Plans of the verb `note`, which writes the mass that contacts were made for into the file, and notes after changes of objects.

use osim_model::messages::{Input, phrase, readable};
use osim_model::{Mass, MassSource, Model, Note, Result, Scope, Step, positive_mass};

use crate::note_edits::{self, NotedMass};
use crate::objects::{EarlierNote, RebuiltModel};
use crate::plan::{Masses, NoteFacts, Plan};
use crate::rules;

/// Plans a note that the contacts of `model` were made for `contacts_mass_kg` at `gravity_m_s2`, without a change of numbers. The
/// note also records how many `stance_limbs` share the weight, if given. Later changes read these facts from the note, also after
/// OpenSim has saved or scaled the model.
///
/// ```
/// use osim_model::{FileId, MassRequest, MassSource, Model};
/// use osim_patch::note;
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// let model = Model::parse(bytes)?;
/// let plan = note(&model, 62.0, model.gravity(), None)?;
/// assert!(plan.changes.is_empty() && plan.moves.is_empty());
///
/// let noted = Model::parse(plan.patched(&model, FileId::MAIN)?)?;
/// let (mass, _) = MassRequest::default().contacts_mass(&noted)?;
/// assert_eq!((mass.kg, mass.source), (62.0, MassSource::Note));
/// # Ok::<(), osim_model::Fault>(())
/// ```
pub fn note(
    model: &Model,
    contacts_mass_kg: f64,
    gravity_m_s2: Option<f64>,
    stance_limbs: Option<f64>,
) -> Result<Plan> {
    let kg = positive_mass(Input::ContactsMass, contacts_mass_kg)?;
    let contacts_mass = Mass { kg, source: MassSource::ContactsMass };
    let taken =
        phrase![&contacts_mass.contacts_made_for(), ": the note in the file says so; no number changes"];
    let made = NotedMass::new(Some(kg), true);
    let facts = NoteFacts { made, gravity_m_s2, operation: "note", followed: None };
    let masses = Some(Masses::unchanged(contacts_mass));
    let plan = Plan::new(model, Plan { masses, taken, ..Plan::default() }, &facts);
    let same = format!("the note in the file says {} kg already", readable(kg));
    Ok(with_new_note(plan, model, stance_limbs, same))
}

/// Plans a note of how many `stance_limbs` share the weight. The mass that the contacts of `model` were made for stays as in the
/// present note; without a note, the contacts count as made for the mass of the bodies.
pub fn note_stance_limbs(model: &Model, stance_limbs: f64) -> Plan {
    let gravity_m_s2 = model.note.as_ref().map_or(model.gravity(), |note| note.gravity_m_s2);
    let made = NotedMass::of(model, None);
    let facts = NoteFacts { made, gravity_m_s2, operation: "note", followed: None };
    let limbs = note_edits::limbs_in_words(stance_limbs);
    let taken = format!("{limbs}: the note in the file says so; no number changes");
    let plan = Plan::new(model, Plan { taken: taken.into(), ..Plan::default() }, &facts);
    with_new_note(plan, model, Some(stance_limbs), format!("the note in the file says {limbs} already"))
}

/// `plan` with its new note. If the present note has the same content, `plan` without a note and with the finding `same`.
fn with_new_note(mut plan: Plan, model: &Model, stance_limbs: Option<f64>, same: String) -> Plan {
    plan.requires_note = true;
    plan.note_stance_limbs(stance_limbs);
    if plan.note().zip(model.note.as_ref()).is_some_and(|(new, old)| has_same_content(new, old)) {
        plan.findings.push(rules::nothing_to_change(same));
        plan.requires_note = false;
    }
    plan
}

/// The note of `model` after an `operation` on its objects (`rebuilt`) that does not change the mass that contacts were made for;
/// `None` if the model has no note. If contacts were changed since the note was written, the new note records that, too.
pub fn kept_note(model: &Model, rebuilt: &RebuiltModel, operation: &str) -> Option<Note> {
    let new = rebuilt.model();
    let Some(old) = &model.note else {
        return model.doubt_about_note().map(|_| note_in_doubt(model, new, operation));
    };
    let mut note = old.with_updated_record(model, new);
    note.version = env!("CARGO_PKG_VERSION").to_owned();
    note.steps = note_edits::steps_after(note_edits::earlier_steps(model), Step::new(operation));
    Some(note)
}

/// A note in place of one that cannot be read: the mass that the contacts of `new` were made for is not known.
fn note_in_doubt(model: &Model, new: &Model, operation: &str) -> Note {
    Note {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scope: Scope::Partial,
        steps: vec![Step::new(note_edits::STEP_OF_OTHER_PROGRAMS), Step::new(operation)],
        digest: new.contact_digest(|_| None),
        radii: new.radii_digest(|_| None),
        parts: new.noted_parts(|_| None),
        added_to_file: note_edits::made_letters(model, None),
        ..Note::default()
    }
}

/// The note after [`remove`](crate::objects::remove()) has removed some contacts of `model`: it covers only a part of the
/// contacts. `None` if no contact is left, or if the model has no note.
pub fn note_of_remaining(model: &Model, rebuilt: &RebuiltModel) -> Option<Note> {
    let is_out = rebuilt.earlier_note == EarlierNote::TakenOut;
    let is_about_nothing = model.note.is_none() && !leaves_noted_contacts(model, rebuilt.model());
    let note = kept_note(model, rebuilt, "remove").filter(|_| !is_out && !is_about_nothing)?;
    // Where nobody said a mass, that of the bodies is as good for a part.
    let scope = if note.contacts_mass_kg.is_none() { note.scope } else { Scope::Partial };
    Some(Note { scope, added_to_file: rebuilt.made.clone(), ..note })
}

/// Whether `rebuilt` still has contacts that the note of `model` describes.
pub(crate) fn leaves_noted_contacts(model: &Model, rebuilt: &Model) -> bool {
    let on_ground = |model: &Model| model.forces().iter().any(|force| model.meets_half_space(force));
    on_ground(rebuilt) || (!on_ground(model) && !rebuilt.forces().is_empty())
}

/// Whether two notes have the same content; the version of the program and the steps do not count.
fn has_same_content(new: &Note, old: &Note) -> bool {
    let facts = |note: &Note| {
        (
            note.contacts_mass_kg,
            note.gravity_m_s2,
            note.scope,
            note.stance_limbs,
            note.digest.clone(),
            note.parts.clone(),
            note.places.clone(),
            note.sizes.clone(),
        )
    };
    facts(new) == facts(old)
}
