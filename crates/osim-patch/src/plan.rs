//! The plan: every number that changes, with its old and new value and its equation.
//!
//! Tables, diffs, JSON, dry runs and writing all read a [`Plan`]; it is the only way to change a model.

use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashSet};
use osim_model::messages::{Dialect, Phrase};
use osim_model::{
    Class, ElementId, Fault, FileId, Finding, Mass, MassRequest, Model, Note, Property, Result, Scope,
    Sphere, SphereId, Step, ValueKey, is_at_target,
};

use crate::change::{ChangedBy, NumberChange, PlaceChange};
use crate::edit::{Edit, Patch};
use crate::insert::{NewElement, insert};
use crate::note_edits::{self, NotedMass, StepDetails};
use crate::objects::{EarlierNote, ObjectChange, RebuiltModel};

/// All changes of one model, made by [`rescale`](crate::rescale), [`transfer`](crate::transfer()), [`design`](crate::design()) or
/// [`set`](crate::set()). The caller shows and writes them.
///
/// ```
/// # use osim_model::{FileId, MassRequest, Model, Selection};
/// # use osim_patch::{Rescale, rescale};
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// # let model = Model::parse(bytes)?;
/// # let selected = Selection::default().apply(&model)?;
/// # let (mass, _) = MassRequest::default().contacts_mass(&model)?;
/// // One sphere of 0.03 m, scaled from 10 to 80 kg.
/// let plan = rescale(&model, &selected, &Rescale::new(80.0, mass))?;
///
/// // What to show: every number that changes, and what the user should know.
/// let rows = plan.changes.iter().map(|change| format!("{} {} -> {}", change.property, change.from, change.to));
/// assert_eq!(rows.collect::<Vec<_>>()[..2], ["radius 0.03 -> 0.06", "stiffness 1000000 -> 2000000"]);
/// assert!(plan.findings.is_empty());
/// // The file will say what its contacts were made for.
/// assert_eq!(plan.note().and_then(|note| note.contacts_mass_kg), Some(80.0));
///
/// // What to write.
/// let patched = plan.patched(&model, FileId::MAIN)?;
/// assert!(String::from_utf8_lossy(&patched).contains("<radius>0.06</radius>"));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[must_use]
pub struct Plan {
    /// The numbers that change, each once: radii first, then force by force.
    pub changes: Vec<NumberChange>,
    pub moves: Vec<PlaceChange>,
    /// The mass that the contacts were made for, before and after the change; `None` if it is neither known nor needed.
    pub masses: Option<Masses>,
    /// The first line of every report: the masses or values from which the change starts, and their sources.
    pub taken: Phrase,
    pub findings: Vec<Finding>,
    /// Remarks about the whole change, such as the parts of the model that stay.
    pub remarks: Vec<Phrase>,
    pub errors: Option<RecordingErrors>,
    /// How far the floor of each recording is above that of the unchanged model, m; empty if no height was fitted.
    pub floor_up_m: Vec<f64>,
    pub(crate) note: Option<Note>,
    /// Whether the note is written even if no number changes, so that the output differs from the original file.
    pub requires_note: bool,
    /// The model with objects added or removed, if there are any. Numbers then change in this model.
    pub(crate) rebuilt: Option<RebuiltModel>,
}

/// Differences between the forces of a fit and of force plates: for the foot with the largest difference in the first trial. The
/// vertical errors also include all feet of the other trials.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordingErrors {
    /// Root mean square of the difference along the normal of the floor, in body weights.
    pub vertical_rms_bw: f64,
    /// The error of the vertical force for data that were not used in the fit, in body weights; `None` if no data could be kept apart.
    pub held_out_vertical_rms_bw: Option<f64>,
    /// The error of the vertical force of a model that never touches, for the foot with the smallest force, in body weights.
    pub null_vertical_rms_bw: f64,
    /// Root mean square of the difference parallel to the floor, in body weights.
    pub horizontal_rms_bw: f64,
    /// Root mean square of the distance between the centres of pressure, m; `None` if there are no centres of pressure.
    pub cop_rms_m: Option<f64>,
    /// The largest relative indentation x/R in the recording.
    pub largest_relative_indentation: f64,
    /// The feet of the first recording under which the plates measured a force.
    pub feet: Vec<FittedFoot>,
    pub parameters: Vec<FittedNumber>,
    /// The names of each two parameters with their correlation, which is not a number if one is at its bound.
    pub correlations: Vec<([String; 2], f64)>,
}

/// The forces of one foot after a fit, compared with those of its plates, in body weights.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedFoot {
    pub name: String,
    pub vertical_rms_bw: f64,
    pub vertical_rms_before_bw: f64,
    pub horizontal_rms_bw: f64,
    /// Root mean square of the distance between both centres of pressure, m.
    pub cop_rms_m: Option<f64>,
    pub peak_bw: f64,
    pub measured_peak_bw: f64,
}

/// A parameter that was fitted to recordings.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedNumber {
    /// The name for scripts, with the unit.
    pub name: String,
    pub value: f64,
    /// The lowest and highest value that fits nearly as well.
    pub nearly_as_good: (f64, f64),
    pub at_bound: bool,
    /// Whether the model gets the value.
    pub is_written: bool,
}

/// The mass that contacts were made for, before and after a change.
#[derive(Debug, Clone, PartialEq)]
pub struct Masses {
    /// The mass for which the contacts were made before the change; in a transfer, the contacts of the reference.
    pub contacts_mass: Mass,
    /// The mass for which the contacts are made after the change, kg.
    pub target_mass_kg: f64,
}

impl Masses {
    /// The masses of a change after which contacts are made for the same mass as before.
    pub(crate) fn unchanged(contacts_mass: Mass) -> Self {
        Self { target_mass_kg: contacts_mass.kg, contacts_mass }
    }
}

/// The name of a transfer among the operations in the note.
pub(crate) const TRANSFER_OPERATION: &str = "transfer";

/// Facts for the note of a plan besides digests of the values.
pub(crate) struct NoteFacts<'o> {
    pub(crate) made: NotedMass,
    pub(crate) gravity_m_s2: Option<f64>,
    pub(crate) operation: &'o str,
    /// Spheres that move with their bodies, also if their location does not change; `None` if spheres do not move with
    /// bodies.
    pub(crate) followed: Option<&'o BTreeSet<SphereId>>,
}

/// A mass rounded to 15 digits, because a sum of bodies may be 20.000000000000018 kg.
fn rounded_to_15_digits(kg: f64) -> f64 {
    format!("{kg:.14e}").parse().ok().filter(|rounded: &f64| rounded.is_finite()).unwrap_or(kg)
}

impl Plan {
    /// Removes the note from the plan. If a number changes, an earlier note in the file is removed, because it would be
    /// wrong.
    pub fn drop_note(&mut self) {
        self.note = None;
    }

    /// Records the operation with its details in the note instead of only the verb: `rescale radius=x2`.
    pub fn name_operation(&mut self, operation: &str) {
        if let Some(step) = self.last_step() {
            step.operation = Note::operation_text(operation);
        }
    }

    /// Joins the last two steps of the note if they are parts of the same operation.
    pub fn join_steps(&mut self) {
        if let Some(note) = &mut self.note
            && let [.., before, last] = note.steps.as_slice()
            && before.operation == last.operation
        {
            note.steps.pop();
        }
    }

    /// Removes all steps but the last from the note, because the earlier steps are about other contacts.
    pub fn forget_earlier_steps(&mut self) {
        if let Some(note) = &mut self.note {
            note.steps.drain(..note.steps.len().saturating_sub(1));
        }
    }

    /// Adds to the note the details of the change that only the caller knows.
    pub fn add_details(&mut self, details: StepDetails) {
        let StepDetails { options, reference, stance_limbs, date } = details;
        self.note_stance_limbs(stance_limbs);
        if let Some(step) = self.last_step() {
            step.options = Note::operation_text(&options);
            step.reference = reference;
            step.date = date;
        }
    }

    /// Records in the note how many limbs share the weight, if the number is given.
    pub(crate) fn note_stance_limbs(&mut self, stance_limbs: Option<f64>) {
        if let Some(note) = &mut self.note {
            note.stance_limbs = stance_limbs.or(note.stance_limbs);
        }
    }

    fn last_step(&mut self) -> Option<&mut Step> {
        self.note.as_mut()?.steps.last_mut()
    }

    /// Records in the note that all values of the contacts are made for its mass, also the values of new contacts that the
    /// plan does not change.
    pub fn note_all_values(&mut self) {
        if let Some(note) = &mut self.note {
            note.scope = Scope::All;
        }
    }

    /// The note that would be written; `None` if nothing changes.
    pub fn note(&self) -> Option<&Note> {
        self.note.as_ref().filter(|_| !self.is_empty())
    }

    /// Whether the output equals the input byte for byte.
    pub fn is_empty(&self) -> bool {
        let numbers = self.changes.is_empty() && self.moves.is_empty();
        numbers && self.objects().is_empty() && !(self.requires_note && self.note.is_some())
    }

    /// `plan` with the note that records it.
    pub(crate) fn new(model: &Model, plan: Self, facts: &NoteFacts<'_>) -> Self {
        let changed: HashMap<ValueKey, f64> = plan.changes.iter().map(NumberChange::key_and_value).collect();
        let moved: HashMap<&str, [f64; 3]> =
            plan.moves.iter().map(|place| (place.path.as_str(), place.to)).collect();
        let is_other = |masses: &&Masses| !is_at_target(masses.contacts_mass.kg, masses.target_mass_kg);
        let from_mass_kg = plan.masses.as_ref().filter(is_other).map(|masses| masses.contacts_mass.kg);
        let step = Step { from_mass_kg, ..Step::new(facts.operation) };
        // Earlier steps are about other contacts if all contacts are new.
        let is_new = facts.operation == TRANSFER_OPERATION && facts.made.scope == Scope::All;
        let earlier = if is_new { Vec::new() } else { note_edits::earlier_steps(model) };
        let note = Some(Note {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            contacts_mass_kg: facts.made.kg.map(rounded_to_15_digits),
            gravity_m_s2: facts.gravity_m_s2,
            scope: facts.made.scope,
            steps: note_edits::steps_after(earlier, step),
            stance_limbs: model.note.as_ref().and_then(|note| note.stance_limbs),
            weighed_kg: MassRequest::default().bodies_kg(model).map(rounded_to_15_digits),
            sizes: note_edits::noted_sizes(model, facts.followed),
            digest: model.contact_digest(|key| changed.get(&key).copied()),
            radii: model.radii_digest(|key| changed.get(&key).copied()),
            parts: model.noted_parts(|key| changed.get(&key).copied()),
            places: Some(model.places_digest(|sphere| moved.get(sphere.path.as_str()).copied())),
            added_to_file: note_edits::made_letters(model, facts.followed),
            added_forces: model.note.as_ref().map(|note| note.added_forces.clone()).unwrap_or_default(),
        });
        Self { note, ..plan }
    }

    /// Attaches a plan for the new model in `rebuilt` to the original model.
    pub fn attach_to(mut self, rebuilt: RebuiltModel) -> Self {
        if let Some(note) = &mut self.note {
            let model = rebuilt.model();
            if rebuilt.earlier_note == EarlierNote::KeptBeside {
                let earlier = model.note.as_ref().map_or("", |note| note.added_to_file.as_str());
                note.added_to_file = note_edits::letters_without_earlier(&note.added_to_file, earlier);
                note.added_forces.clear();
            }
            note.added_forces.extend(rebuilt.added.iter().cloned());
            note.added_to_file = note_edits::merged_letters(&note.added_to_file, &rebuilt.made);
        }
        self.rebuilt = Some(rebuilt);
        self
    }

    /// A plan that changes objects and no numbers; `taken` is the first line of reports.
    pub fn from_objects(rebuilt: RebuiltModel, taken: Phrase) -> Self {
        Self { taken, rebuilt: Some(rebuilt), ..Self::default() }
    }

    /// The plan with another note.
    pub fn with_note(mut self, note: Option<Note>) -> Self {
        self.note = note;
        self
    }

    /// Objects that are added or removed, in the order of reports.
    pub fn objects(&self) -> &[ObjectChange] {
        self.rebuilt.as_ref().map_or(&[], |rebuilt| &rebuilt.objects)
    }

    /// Whether the plan removes everything that the program added to the model, so that the file is the original again.
    pub fn restores_original(&self) -> bool {
        self.rebuilt.as_ref().is_some_and(|rebuilt| rebuilt.earlier_note == EarlierNote::TakenOut)
    }

    /// The model in which numbers change: `model`, or the model with objects added or removed.
    pub(crate) fn base_model<'m>(&'m self, model: &'m Model) -> &'m Model {
        self.rebuilt.as_ref().map_or(model, RebuiltModel::model)
    }

    /// The fault for the first new radius that is probably a typing error: a sphere larger than the bones around it.
    /// Unchanged radii are not checked.
    pub fn implausible_radius(&self, model: &Model) -> Option<Fault> {
        let mut radii = self.changes.iter().filter(|change| change.property == Property::Radius).peekable();
        radii.peek()?;
        let model = self.base_model(model);
        let distances = model.joint_distances();
        let spheres: HashMap<&str, &Sphere> =
            model.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere)).collect();
        radii.find_map(|change| {
            let sphere = spheres.get(change.path.as_str())?;
            let said = change.by == ChangedBy::Given && change.factor.is_none();
            let odd = distances.implausible_radius(sphere, change.to, said)?;
            Some(Fault::at(odd, sphere.radius.offset).at_element(change.path.clone()).in_file(change.file()))
        })
    }

    /// Puts all messages of the plan into the words of a user interface.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.taken.spell(dialect);
        self.remarks.iter_mut().for_each(|remark| remark.spell(dialect));
        self.findings.iter_mut().for_each(|finding| finding.spell(dialect));
    }

    /// Whether the note needs an element `<credits>` that the model does not have.
    pub fn adds_credits(&self, model: &Model) -> bool {
        self.note().is_some() && note_edits::adds_credits(self.base_model(model).document())
    }

    /// The credits of the new model as OpenSim reads them, with the note; `None` if the model has no credits, or if the file
    /// is a set. A caller that changes a model in memory must set them, too: without the note, the next change would start
    /// from the old mass.
    pub fn credits(&self, model: &Model) -> Option<String> {
        let document = self.base_model(model).document();
        note_edits::credits_after(document, &self.edits(model, FileId::MAIN).ok()?)
    }

    /// The files that change: the model's own, and the geometry set beside a standalone force set if it changes, too.
    pub fn files<'m>(&'m self, model: &'m Model) -> impl Iterator<Item = FileId> {
        let model = self.base_model(model);
        let slots = self.changes.iter().map(|change| &change.slot);
        let with_slots: HashSet<FileId> =
            slots.chain(self.moves.iter().map(|place| &place.slot)).map(|slot| slot.file).collect();
        let others = model.companions().filter(move |(file, companion)| {
            let document = &companion.document;
            with_slots.contains(file) || document.tree().name(document.data_root()) == "ContactGeometrySet"
        });
        let stays = move |file: &FileId| self.edits(model, *file).is_ok_and(|edits| edits.is_empty());
        let changed = others.map(|(file, _)| file).filter(move |file| !stays(file));
        std::iter::once(FileId::MAIN).chain(changed)
    }

    /// The edits of `file`, with those of the note. `model` is the model for which the plan was made. If objects are added or
    /// removed, the edits apply to the file after that.
    ///
    /// # Errors
    /// A number that is not finite, or outside its domain, with its place.
    pub fn edits(&self, model: &Model, file: FileId) -> Result<Vec<Edit>> {
        let document = self.base_model(model).file(file);
        let tree = document.tree();
        let mut edits = Vec::new();
        // Elements that are inserted into one object, and its class.
        let mut absent: BTreeMap<ElementId, (Class, Vec<NewElement>)> = BTreeMap::new();
        let numbers = self.changes.iter().map(|change| (&change.slot, change.text()));
        let places = self.moves.iter().map(|place| (&place.slot, place.text()));
        for (slot, text) in numbers.chain(places).filter(|(slot, _)| slot.file == file) {
            let text = text?;
            match &slot.span {
                Some(span) => edits.push(Edit { span: span.clone(), text }),
                None => {
                    let (_, elements) = absent.entry(slot.object).or_insert((slot.class, vec![]));
                    elements.push(NewElement::leaf(slot.tag, text));
                }
            }
        }
        for (parent, (class, elements)) in &absent {
            edits.extend(insert(tree, *parent, class.element_order(), elements));
        }
        // A geometry set changes together with its force set and gets the same note; a model that was only read none.
        let noted = file == FileId::MAIN
            || !edits.is_empty()
            || tree.name(document.data_root()) == "ContactGeometrySet";
        let earlier = self.rebuilt.as_ref().map_or(EarlierNote::Replaced, |rebuilt| rebuilt.earlier_note);
        if let (Some(note), true) = (&self.note, noted && !self.is_empty()) {
            edits.extend(note_edits::write_note(document, note, earlier == EarlierNote::KeptBeside));
        } else if noted
            && !self.is_empty()
            && !matches!(earlier, EarlierNote::TakenOut | EarlierNote::Untouched)
        {
            // Without a new note the old one would lie: it goes.
            edits.extend(note_edits::remove_note(document));
        }
        Ok(edits)
    }

    /// The model after the plan, read from its new bytes.
    pub fn changed_model(&self, model: &Model) -> Result<Model> {
        let others = self.files(model).filter(|&file| file != FileId::MAIN);
        let others = others.map(|file| Ok((file, self.patched(model, file)?))).collect::<Result<Vec<_>>>()?;
        self.base_model(model).read_again(self.patched(model, FileId::MAIN)?, &others)
    }

    /// The new model for inspection only, read from its new bytes only if the plan changes more than numbers of contacts.
    pub fn model_to_inspect(&self, model: &Model) -> Result<Model> {
        self.with_contact_numbers(model).map_or_else(|| self.changed_model(model), Ok)
    }

    /// The new model for inspection only: its numbers and note are new, but its positions in the file are the old ones.
    /// `None` if the plan changes more than numbers of contacts.
    pub fn with_contact_numbers(&self, model: &Model) -> Option<Model> {
        if self.rebuilt.is_some() || !self.moves.is_empty() {
            return None;
        }
        let numbers: HashMap<ValueKey, f64> = self.changes.iter().map(NumberChange::key_and_value).collect();
        model.with_contact_numbers(|key| numbers.get(&key).copied(), self.note())
    }

    /// The patched bytes of `file`; identical to the original if nothing changes.
    ///
    /// # Errors
    /// A number that is not finite, with its place; or overlapping edits, which would be a defect of this crate.
    pub fn patched(&self, model: &Model, file: FileId) -> Result<Vec<u8>> {
        self.patch(model, file).map(|patch| patch.to_vec())
    }

    /// The new file without a copy: slices of the original and of new text alternate.
    pub fn patch<'m>(&'m self, model: &'m Model, file: FileId) -> Result<Patch<'m>> {
        Patch::new(self.base_model(model).file(file).bytes(), self.edits(model, file)?)
    }
}
