//! Plans that are judged by the model that they make: how it is inspected, and what is worse in it than before.

use std::collections::{HashMap, HashSet};

use osim_inspect::{
    Bottom, Changeable, FindingIndex, FindingWithRemedy, InspectOptions, LoadSharing, Stance, StandingBody,
    check_model, check_numbers, describe_unmatched_patterns, model_findings,
};
use osim_model::feet::{MOST_LEAN_RAD, PoseFault, Standing};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Phrase, Verb, phrase};
use osim_model::{
    Fault, Finding, FindingCode, Limb, Model, NeedsAnswer, Property, Question, Severity, Source, same_mass,
};
use osim_patch::{ChangedBy, Plan, StepDetails};
use osim_requests::NoteDetails;

use crate::prepared_change::PreparedChange;
use crate::rules;

/// For a check without remedies, which need not know what can be changed.
const NO_REMEDIES: Changeable = Changeable { numbers: false, radii: false };

impl PreparedChange {
    /// Plans the change of a model that was [opened](Self::open). The plan has a note; its findings name what is odd about the model
    /// itself, and what the change makes worse.
    ///
    /// # Errors
    /// Those of [`plan_beside`](Self::plan_beside); a change after which the model is wrong, unless the caller means it.
    pub fn plan(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let mut plan = self.plan_with_note(opened, files)?;
        if !plan.is_empty() {
            let changed = ResultingModel::renumbered_or_read(&plan, opened)?;
            self.add_worse_findings(opened, &mut plan, &changed)?;
        }
        Ok(plan)
    }

    /// Plans like [`plan`](Self::plan), and also returns the changed model, read from its new bytes; `None` if nothing changes.
    ///
    /// # Errors
    /// Those of [`plan`](Self::plan).
    pub fn plan_with_result(
        &self,
        opened: &OpenModel,
        files: &dyn Files,
    ) -> Result<(Plan, Option<Model>), Failure> {
        let mut plan = self.plan_with_note(opened, files)?;
        if plan.is_empty() {
            return Ok((plan, None));
        }
        let changed = ResultingModel::read(&plan, opened)?;
        self.add_worse_findings(opened, &mut plan, &changed)?;
        Ok((plan, Some(changed.into_model())))
    }

    /// The plan with its note and the findings about the model itself, without those about the result.
    fn plan_with_note(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let model = &opened.model;
        let mut plan = self.plan_beside(opened, files)?;
        if self.output.no_note {
            plan.drop_note();
            if model.note.is_some() && !plan.is_empty() {
                let text = "the note is removed: the next run cannot know what the contacts are made for";
                plan.remarks.push(text.into());
            }
        } else {
            let reference = self.reference.as_ref();
            let reference = reference
                .map(|reference| Source { name: reference.name.clone(), digest: reference.digest.clone() });
            let NoteDetails { options, stance_limbs } = self.details.clone();
            plan.add_details(StepDetails { options, reference, stance_limbs, date: files.today() });
        }
        if plan.adds_credits(model) {
            let text = "the model has no <credits>: they are added for the note, because OpenSim drops comments when it saves";
            plan.remarks.push(text.into());
        }
        let remaining = remaining_findings(&plan, model);
        plan.findings.splice(0..0, remaining);
        plan.remarks.extend(describe_unmatched_patterns(
            &self.options.selection,
            &self.options.masses,
            model,
        ));
        Ok(plan)
    }

    /// Adds findings about what `plan` makes worse to its findings.
    fn add_worse_findings(
        &self,
        opened: &OpenModel,
        plan: &mut Plan,
        changed: &ResultingModel,
    ) -> Result<(), Failure> {
        for mut finding in worse_findings(self, opened, plan, changed)? {
            self.keep_ways_out(&mut finding.message);
            plan.findings.push(finding);
        }
        Ok(())
    }

    /// Whether the contacts are judged under the target mass instead of the mass of the bodies.
    fn is_for_target_mass(&self) -> bool {
        self.verb == Verb::Rescale
    }

    /// Whether the caller gave the new numbers themselves: then a model that is wrong with them is not refused.
    fn writes_given_numbers(&self) -> bool {
        matches!(self.verb, Verb::Set | Verb::Design | Verb::Fit)
    }

    /// How the new model is inspected, if the old one weighs `weighs_kg`: under the mass that its contacts were scaled for.
    pub(crate) fn options_after(&self, plan: &Plan, weighs_kg: Option<f64>) -> InspectOptions {
        let mut options = self.options.clone();
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        // The inspection reads this mass from the note; if the plan writes no note, it has to be told.
        options.masses.contacts_mass_kg = target_mass_kg.filter(|_| plan.note().is_none());
        if let Some(target_mass_kg) = target_mass_kg.filter(|_| self.is_for_target_mass())
            && weighs_kg.is_none_or(|weighs| !same_mass(weighs, target_mass_kg))
        {
            options.masses.model_kg = Some(target_mass_kg);
        }
        // If the caller gave a gravity for figures (as for a design), both states are inspected with it.
        options.stance.gravity_m_s2 = self.target_gravity_m_s2.or(options.stance.gravity_m_s2);
        options
    }

    /// How the old model is inspected, to be compared with the new one: under the mass that its contacts were made for, if the new
    /// ones are inspected under their target mass.
    fn options_before(&self, plan: &Plan) -> InspectOptions {
        let mut options = self.options.clone();
        if let Some(masses) = plan.masses.as_ref().filter(|_| self.is_for_target_mass()) {
            options.masses.model_kg = Some(masses.contacts_mass.kg);
        }
        options
    }

    /// Whether the contacts are scaled before the bodies, which still have another mass. Then nobody knows the default pose of the scaled
    /// bodies yet, and a warning about the pose of the present ones would come with every rescaling to another mass.
    fn bodies_await_scaling(&self, plan: &Plan, weighs_kg: Option<f64>) -> bool {
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        let is_other = |target| weighs_kg.is_none_or(|weighs| !same_mass(weighs, target));
        self.is_for_target_mass() && target_mass_kg.is_some_and(is_other)
    }
}

/// Findings about `model` that the change leaves: a finding about an object that the plan removes or replaces is left out.
fn remaining_findings(plan: &Plan, model: &Model) -> Vec<Finding> {
    let key = |finding: &Finding| (finding.code(), finding.place.clone());
    let remaining: HashSet<_> = model_findings(plan.base_model(model)).iter().map(key).collect();
    model_findings(model).iter().filter(|finding| remaining.contains(&key(finding))).cloned().collect()
}

/// The model that a plan makes.
#[derive(Debug)]
enum ResultingModel {
    /// The old model with other numbers of contacts: no bytes were read again.
    NumbersChanged(Model),
    /// Read from its new bytes.
    Read(Model),
}

impl ResultingModel {
    /// The model that `plan` makes of `opened`. It is read from its new bytes only if something else than numbers changes.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    fn renumbered_or_read(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.with_contact_numbers(&opened.model)
            .map_or_else(|| Self::read(plan, opened), |model| Ok(Self::NumbersChanged(model)))
    }

    /// The model that `plan` makes of `opened`, read from its new bytes.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    fn read(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.changed_model(&opened.model).map(Self::Read).map_err(|fault| opened.failure(fault))
    }

    fn into_model(self) -> Model {
        let (Self::NumbersChanged(model) | Self::Read(model)) = self;
        model
    }

    fn model(&self) -> &Model {
        let (Self::NumbersChanged(model) | Self::Read(model)) = self;
        model
    }

    /// Findings about `model`, which is this model or the one before the change, without remedies. If only numbers changed, only the
    /// rules about numbers are checked.
    fn findings_without_remedies(
        &self,
        options: &InspectOptions,
        opened: &OpenModel,
        model: &Model,
    ) -> Vec<FindingWithRemedy> {
        match self {
            Self::NumbersChanged(_) => {
                let inspected = options.inspect_for_rules(opened.name(), model);
                check_numbers(options, model, &inspected)
            }
            Self::Read(_) => findings_without_remedies(options, opened, model),
        }
    }
}

/// Warnings and errors of the resulting model that the model before does not have, or has with a lower level; and findings about
/// bodies that stood at their default pose and do not any more.
///
/// # Errors
/// An error among them, unless the caller confirmed it.
fn worse_findings(
    change: &PreparedChange,
    opened: &OpenModel,
    plan: &Plan,
    changed: &ResultingModel,
) -> Result<Vec<Finding>, Failure> {
    let masses = &change.options.masses;
    let weighs = masses.model_mass(&opened.model).ok();
    let weighs = weighs.or_else(|| Some(masses.contacts_mass(&opened.model).ok()?.0));
    let weighs_kg = weighs.map(|mass| mass.kg);
    // A change that is taken back gives a model that was there before: nobody has to be asked about it.
    let is_confirmed = change.writes_given_numbers()
        || plan.restores_original()
        || change.answers.has(Question::WrongAfterwards);
    let (before, after) = (change.options_before(plan), change.options_after(plan, weighs_kg));
    let worse = findings_that_became_worse(&before, &after, opened, plan, changed);
    let mut findings: Vec<Finding> = match worse.iter().find(|one| one.severity == Severity::Error) {
        Some(wrong) if !is_confirmed => return Err(opened.failure(Fault::new(question_about(wrong)))),
        _ => worse.iter().map(about_new_model).collect(),
    };
    if !change.bodies_await_scaling(plan, weighs_kg) {
        findings.extend(bottoms_moved(plan, &opened.model, changed.model(), &findings));
    }
    Ok(findings)
}

/// Warnings and errors of the resulting model that the old one does not have, or has with a lower level.
fn findings_that_became_worse(
    before: &InspectOptions,
    after: &InspectOptions,
    opened: &OpenModel,
    plan: &Plan,
    changed: &ResultingModel,
) -> Vec<FindingWithRemedy> {
    let new_findings = changed.findings_without_remedies(after, opened, changed.model());
    let is_bad = |one: &&FindingWithRemedy| {
        one.severity >= Severity::Warning && !says_bodies_are_unscaled(one) && !is_reported_by_plan(plan, one)
    };
    let bad: Vec<&FindingWithRemedy> = new_findings.iter().filter(is_bad).collect();
    if bad.is_empty() {
        return Vec::new();
    }
    let old_findings = changed.findings_without_remedies(before, opened, &opened.model);
    let old_index = FindingIndex::new(&old_findings);
    // A finding new another code in the same place is not new: contacts that no longer are those new a published model are not worse.
    let is_worse = |one: &&FindingWithRemedy| {
        let was = old_index.find_same_or_other_depth(one);
        was.is_none_or(|was| was.code() != one.code() && was.rule.severity < one.rule.severity)
    };
    bad.into_iter().filter(is_worse).cloned().collect()
}

/// Whether the finding only says that the bodies are not scaled yet: contacts are often scaled before them.
pub(crate) fn says_bodies_are_unscaled(one: &FindingWithRemedy) -> bool {
    one.code() == FindingCode::MassSourcesDisagree
}

/// All findings about `model`, without remedies.
pub(crate) fn findings_without_remedies(
    options: &InspectOptions,
    opened: &OpenModel,
    model: &Model,
) -> Vec<FindingWithRemedy> {
    let inspected = options.inspect_for_rules(opened.name(), model);
    check_model(options, model, &inspected, &[], NO_REMEDIES).findings
}

/// Whether the plan already reports this finding, with advice of its own, as `convert` does of the smoothing of stiff spheres. Such
/// a finding is neither repeated nor a reason to refuse.
fn is_reported_by_plan(plan: &Plan, one: &FindingWithRemedy) -> bool {
    plan.findings.iter().any(|known| known.code() == one.code() && known.place == one.place)
}

/// The finding for people who have only the old file: its line, which is one of the new file, is left out.
fn about_new_model(found: &FindingWithRemedy) -> Finding {
    let message = phrase!["in the new model: ", &found.message];
    found.finding.clone().with_message(message).with_line(None)
}

fn question_about(wrong: &FindingWithRemedy) -> NeedsAnswer {
    let text: Phrase = phrase![
        "the model would be wrong afterwards [",
        wrong.code().as_str(),
        "]: ",
        &wrong.message,
        ". ",
        &wrong.advice
    ];
    NeedsAnswer::Other { question: Question::WrongAfterwards, text }
}

// What a change does to the bottoms of spheres: bodies that stood at their default pose and no longer do, and feet that it makes
// uneven.

/// A move of a bottom that is smaller than this does not matter, in radii of the sphere.
const SMALL_MOVE_RADII: f64 = 0.1;
/// A body stands if its lowest sphere is at most this far from its floor, in radii of the sphere.
const STANDING_RADII: f64 = 0.5;

/// Findings about the bottoms of spheres that `plan` moves, from the model `before` to the model `after`; `findings` are those about
/// the new model so far.
///
/// Spheres that follow their bodies are not judged: before, they were in wrong places. Nor are new spheres: `add` says where they are.
fn bottoms_moved(plan: &Plan, before: &Model, after: &Model, findings: &[Finding]) -> Vec<Finding> {
    let radii = plan.changes.iter().any(|change| change.property == Property::Radius);
    let follow = plan.moves.iter().any(|one| one.by == ChangedBy::Follow);
    if (!radii && plan.moves.is_empty()) || follow || !plan.objects().is_empty() {
        return Vec::new();
    }
    let Some((before, after)) =
        BodiesOverFloor::at_default_pose(before).zip(BodiesOverFloor::at_default_pose(after))
    else {
        return Vec::new();
    };
    let mut moved: Vec<Finding> = after.no_longer_standing(&before).collect();
    // A foot is called uneven once.
    if !findings.iter().any(|one| one.code() == FindingCode::UnevenBottoms) {
        moved.extend(after.uneven(&before));
    }
    moved
}

/// The bodies of a model at its default pose, with the heights of their spheres over the floors.
struct BodiesOverFloor<'m> {
    model: &'m Model,
    standing: Vec<StandingBody>,
    sharing: LoadSharing,
}

impl<'m> BodiesOverFloor<'m> {
    /// `None` if the default pose is not known.
    fn at_default_pose(model: &'m Model) -> Option<Self> {
        let (standing, sharing) = standing_bodies(model).ok()?;
        Some(Self { model, standing, sharing })
    }

    fn bottoms(&self) -> HashMap<&str, &Bottom> {
        let all = self.standing.iter().flat_map(|body| &body.bottoms);
        all.map(|bottom| (bottom.path.as_str(), bottom)).collect()
    }

    /// Findings about bodies that stood `before` the change and do not any more.
    fn no_longer_standing(&self, before: &Self) -> impl Iterator<Item = Finding> {
        let several = self.standing.len() > 1;
        self.standing.iter().filter_map(move |now| {
            let before = before.standing.iter().find(|old| old.body == now.body)?;
            stands_no_longer(before, now).then(|| rules::bottoms_moved_of_body(before, now, several))?
        })
    }

    /// Findings about limbs whose bottoms are less level than `before` the change.
    fn uneven(&self, before: &Self) -> Vec<Finding> {
        let (old, new) = (before.bottoms(), self.bottoms());
        let pair = |path: &str| Some((*old.get(path)?, *new.get(path)?));
        let limbs = self.sharing.limbs().if_known().unwrap_or_default().iter();
        let of_limb = |limb: &Limb| {
            let spheres = limb.spheres.iter().filter_map(|&id| self.model.sphere(id));
            uneven(&limb.name, &spheres.filter_map(|sphere| pair(&sphere.path)).collect::<Vec<_>>())
        };
        limbs.filter_map(of_limb).collect()
    }
}

/// Whether a body stood `before`, and `after` the change is inside its floor or above it because its bottoms moved.
fn stands_no_longer(before: &StandingBody, after: &StandingBody) -> bool {
    let Some((was, is)) = before.lowest().zip(after.lowest()) else { return false };
    let stood = was.height_m.abs() <= STANDING_RADII * was.radius_m;
    let is_off = is.height_m > STANDING_RADII * is.radius_m || after.is_inside_floor();
    stood && is_off && (is.height_m - was.height_m).abs() > SMALL_MOVE_RADII * is.radius_m
}

/// The finding about a limb whose bottoms a change moves apart; `bottoms` has each before and after the change.
fn uneven(limb: &str, bottoms: &[(&Bottom, &Bottom)]) -> Option<Finding> {
    let heights = |of: fn(&(&Bottom, &Bottom)) -> f64| bottoms.iter().map(of).collect::<Vec<f64>>();
    let moved_m = spread(&heights(|(was, is)| is.height_m - was.height_m));
    let (before_m, now_m) =
        (spread(&heights(|(was, _)| was.height_m)), spread(&heights(|(_, is)| is.height_m)));
    let by_height = |a: &&Bottom, b: &&Bottom| a.height_m.total_cmp(&b.height_m);
    let lowest = bottoms.iter().map(|(_, is)| *is).min_by(by_height)?;
    let highest = bottoms.iter().map(|(_, is)| *is).max_by(by_height)?;
    let small_m = SMALL_MOVE_RADII * lowest.radius_m;
    // Where a foot leans the pose decides which of its spheres is low.
    let leans = bottoms.iter().any(|(_, is)| is.tilt_rad > MOST_LEAN_RAD);
    let is_uneven = moved_m > small_m && now_m - before_m > small_m && !leans;
    is_uneven.then(|| rules::bottoms_moved_of_limb(limb, before_m, lowest, highest))
}

fn spread(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    most - least
}

/// Each joint tree with spheres over a floor, one limb carrying it alone, and its limbs.
pub(crate) fn standing_bodies(model: &Model) -> Result<(Vec<StandingBody>, LoadSharing), PoseFault> {
    let forces = model.force_ids();
    let standing = Standing::all(model, &forces)?;
    let sharing = LoadSharing::of(model, &forces);
    Ok((StandingBody::all(model, &standing, sharing.limbs(), Stance::default().limb_count(model)), sharing))
}
