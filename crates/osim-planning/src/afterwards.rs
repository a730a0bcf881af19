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

use crate::planner::Change;
use crate::rules;

/// No remedy is asked for: what can be changed does not matter.
const NO_REMEDIES: Changeable = Changeable { numbers: false, radii: false };

impl Change {
    /// Plans for a model that was [opened](Self::open), as the request says: with its note, with what is odd about the model itself
    /// among the warnings, and what the change makes worse.
    ///
    /// # Errors
    /// Those of [`plan_beside`](Self::plan_beside); a change after which the model is wrong, unless the caller means it.
    pub fn plan(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let mut plan = self.unjudged(opened, files)?;
        if !plan.is_empty() {
            let changed = Changed::of(&plan, opened)?;
            self.judge(opened, &mut plan, &changed)?;
        }
        Ok(plan)
    }

    /// Plans like [`plan`](Self::plan), and gives the model as it will be, which was read from its new bytes; `None` where nothing
    /// changes.
    ///
    /// # Errors
    /// Those of [`plan`](Self::plan).
    pub fn plan_with_result(
        &self,
        opened: &OpenModel,
        files: &dyn Files,
    ) -> Result<(Plan, Option<Model>), Failure> {
        let mut plan = self.unjudged(opened, files)?;
        if plan.is_empty() {
            return Ok((plan, None));
        }
        let changed = Changed::read(&plan, opened)?;
        self.judge(opened, &mut plan, &changed)?;
        Ok((plan, Some(changed.into_model())))
    }

    /// The plan, with its note and with what is odd about the model itself.
    fn unjudged(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let model = &opened.model;
        let mut plan = self.plan_beside(opened, files)?;
        if self.output.no_note {
            plan.without_note();
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
        let standing = standing_findings(&plan, model);
        plan.warnings.splice(0..0, standing);
        plan.remarks.extend(describe_unmatched_patterns(
            &self.options.selection,
            &self.options.masses,
            model,
        ));
        Ok(plan)
    }

    /// Adds to `plan` what it makes worse.
    fn judge(&self, opened: &OpenModel, plan: &mut Plan, changed: &Changed) -> Result<(), Failure> {
        for mut finding in worse_findings(self, opened, plan, changed)? {
            self.keep_ways_out(&mut finding.message);
            plan.warnings.push(finding);
        }
        Ok(())
    }

    /// Whether the contacts are to carry the mass that they are scaled to, whatever the bodies weigh.
    fn carries_target(&self) -> bool {
        self.verb == Verb::Rescale
    }

    /// Whether the caller gave the numbers themselves, and not what they follow from: a model that is wrong with them is not refused.
    fn is_as_given(&self) -> bool {
        matches!(self.verb, Verb::Set | Verb::Design | Verb::Fit)
    }

    /// How the new model is inspected, where the old one weighs `weighs_kg`: its contacts carry the body that they were scaled for.
    pub(crate) fn options_after(&self, plan: &Plan, weighs_kg: Option<f64>) -> InspectOptions {
        let mut options = self.options.clone();
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        // The note has it; without one the caller has to give it.
        options.masses.contacts_mass_kg = target_mass_kg.filter(|_| plan.note().is_none());
        if let Some(target_mass_kg) = target_mass_kg.filter(|_| self.carries_target())
            && weighs_kg.is_none_or(|weighs| !same_mass(weighs, target_mass_kg))
        {
            options.masses.model_kg = Some(target_mass_kg);
        }
        // A gravity that figures are asked for (as in a design) is that of both states.
        options.stance.gravity_m_s2 = self.target_gravity_m_s2.or(options.stance.gravity_m_s2);
        options
    }

    /// How the old model is inspected, to be compared with the new one: its contacts carry the body that they were made for, where the
    /// new ones carry theirs.
    fn options_before(&self, plan: &Plan) -> InspectOptions {
        let mut options = self.options.clone();
        if let Some(masses) = plan.masses.as_ref().filter(|_| self.carries_target()) {
            options.masses.model_kg = Some(masses.contacts_mass.kg);
        }
        options
    }

    /// Whether the contacts are for a body that the bodies of the model still have to become: contacts are often scaled before the body
    /// is. What its default pose is then nobody knows yet, so that every isometric rescaling to another mass would warn of the pose
    /// that is.
    fn is_to_be_scaled(&self, plan: &Plan, weighs_kg: Option<f64>) -> bool {
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        let is_other = |target| weighs_kg.is_none_or(|weighs| !same_mass(weighs, target));
        self.carries_target() && target_mass_kg.is_some_and(is_other)
    }
}

/// What is odd about `model` itself and stays so: a finding about an object that goes, or that becomes another one, is no longer one.
fn standing_findings(plan: &Plan, model: &Model) -> Vec<Finding> {
    let key = |finding: &Finding| (finding.code(), finding.place.clone());
    let still: HashSet<_> = model_findings(plan.ground(model)).iter().map(key).collect();
    model_findings(model).iter().filter(|finding| still.contains(&key(finding))).cloned().collect()
}

/// The model that a plan makes.
#[derive(Debug)]
enum Changed {
    /// Nothing but numbers of contacts is other: most of it is what it was, and nobody has read a file.
    InNumbers(Model),
    /// It was read from its new bytes.
    Read(Model),
}

impl Changed {
    /// That of `plan`, which was made for `opened`, without its bytes if that can be.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    fn of(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.with_contact_numbers(&opened.model)
            .map_or_else(|| Self::read(plan, opened), |model| Ok(Self::InNumbers(model)))
    }

    /// The same from its bytes.
    ///
    /// # Errors
    /// Those of [`Plan::changed`].
    fn read(plan: &Plan, opened: &OpenModel) -> Result<Self, Failure> {
        plan.changed(&opened.model).map(Self::Read).map_err(|fault| opened.failure(fault))
    }

    fn into_model(self) -> Model {
        let (Self::InNumbers(model) | Self::Read(model)) = self;
        model
    }

    fn model(&self) -> &Model {
        let (Self::InNumbers(model) | Self::Read(model)) = self;
        model
    }

    /// What is found in `model`, which is this one or the one that was changed, as far as the change decides it, without remedies.
    fn unmended(
        &self,
        options: &InspectOptions,
        opened: &OpenModel,
        model: &Model,
    ) -> Vec<FindingWithRemedy> {
        match self {
            Self::InNumbers(_) => {
                let inspected = options.inspect_for_rules(opened.name(), model);
                check_numbers(options, model, &inspected)
            }
            Self::Read(_) => unmended(options, opened, model),
        }
    }
}

/// Warnings and errors of the model as `changed` by `plan` that the model without it does not have, or has as less bad; and what the
/// plan does to bottoms that stood.
///
/// # Errors
/// An error among them, unless the caller means it.
fn worse_findings(
    change: &Change,
    opened: &OpenModel,
    plan: &Plan,
    changed: &Changed,
) -> Result<Vec<Finding>, Failure> {
    let masses = &change.options.masses;
    let weighs = masses.model_mass(&opened.model).ok();
    let weighs = weighs.or_else(|| Some(masses.contacts_mass(&opened.model).ok()?.0));
    let weighs_kg = weighs.map(|mass| mass.kg);
    // A model that is as it was before nobody has to be asked about.
    let is_meant = change.is_as_given() || plan.takes_back() || change.answers.has(Question::WrongAfterwards);
    let (before, after) = (change.options_before(plan), change.options_after(plan, weighs_kg));
    let worse = worse_than(&before, &after, opened, plan, changed);
    let mut said: Vec<Finding> = match worse.iter().find(|one| one.severity == Severity::Error) {
        Some(wrong) if !is_meant => return Err(opened.failure(Fault::new(asks(wrong)))),
        _ => worse.iter().map(of_new_model).collect(),
    };
    if !change.is_to_be_scaled(plan, weighs_kg) {
        said.extend(moved_bottoms(plan, &opened.model, changed.model(), &said));
    }
    Ok(said)
}

/// What is wrong with the model `changed` by `plan`, and was not, or less.
fn worse_than(
    before: &InspectOptions,
    after: &InspectOptions,
    opened: &OpenModel,
    plan: &Plan,
    changed: &Changed,
) -> Vec<FindingWithRemedy> {
    let found = changed.unmended(after, opened, changed.model());
    let is_bad =
        |one: &&FindingWithRemedy| one.severity >= Severity::Warning && !is_due(one) && !is_known(plan, one);
    let bad: Vec<&FindingWithRemedy> = found.iter().filter(is_bad).collect();
    if bad.is_empty() {
        return Vec::new();
    }
    let old = changed.unmended(before, opened, &opened.model);
    let previous = FindingIndex::new(&old);
    // Contacts that are no longer those of a published model are not worse for it.
    let is_worse = |one: &&FindingWithRemedy| {
        let was = previous.find_same_or_other_depth(one);
        was.is_none_or(|was| was.code() != one.code() && was.rule.severity < one.rule.severity)
    };
    bad.into_iter().filter(is_worse).cloned().collect()
}

/// Whether it only says that the bodies are not scaled yet: contacts are often scaled before them.
pub(crate) fn is_due(one: &FindingWithRemedy) -> bool {
    one.code() == FindingCode::MassSourcesDisagree
}

/// What is found in `model`, without remedies.
pub(crate) fn unmended(
    options: &InspectOptions,
    opened: &OpenModel,
    model: &Model,
) -> Vec<FindingWithRemedy> {
    let inspected = options.inspect_for_rules(opened.name(), model);
    check_model(options, model, &inspected, &[], NO_REMEDIES).findings
}

/// Whether the verb says it itself, with a way out of its own: then it is neither repeated nor refused, such as what the smoothing of
/// `convert` does on stiff spheres.
fn is_known(plan: &Plan, one: &FindingWithRemedy) -> bool {
    plan.warnings.iter().any(|known| known.code() == one.code() && known.place == one.place)
}

/// Lines are those of a file that nobody has yet: they are left out.
fn of_new_model(found: &FindingWithRemedy) -> Finding {
    let message = phrase!["in the new model: ", &found.message];
    found.finding.clone().with_message(message).with_line(None)
}

fn asks(wrong: &FindingWithRemedy) -> NeedsAnswer {
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

/// Bottoms that move by less, in the radius of a sphere, do not matter.
const SMALL: f64 = 0.1;
/// A body whose lowest sphere is this near to its floor, in its radius, stands.
const STANDS: f64 = 0.5;

/// Findings about the bottoms that `plan` moves from where `before` has them to where `now` has them; `said` are those about the new
/// model that are known already.
///
/// Spheres that follow their bodies are where their bones put them, and before that they were left behind: what they did there is no
/// comparison. New spheres did not stand anywhere, and `add` says where they are.
fn moved_bottoms(plan: &Plan, before: &Model, now: &Model, said: &[Finding]) -> Vec<Finding> {
    let radii = plan.changes.iter().any(|change| change.property == Property::Radius);
    let follow = plan.moves.iter().any(|one| one.by == ChangedBy::Follow);
    if (!radii && plan.moves.is_empty()) || follow || !plan.objects().is_empty() {
        return Vec::new();
    }
    let Some((before, now)) = Bodies::of(before).zip(Bodies::of(now)) else { return Vec::new() };
    let mut found: Vec<Finding> = now.lost(&before).collect();
    // A foot is called uneven once.
    if !said.iter().any(|one| one.code() == FindingCode::UnevenBottoms) {
        found.extend(now.uneven(&before));
    }
    found
}

/// The bodies of a model over their floors.
struct Bodies<'m> {
    model: &'m Model,
    standing: Vec<StandingBody>,
    sharing: LoadSharing,
}

impl<'m> Bodies<'m> {
    /// `None` if it is not known where bodies are at the default pose.
    fn of(model: &'m Model) -> Option<Self> {
        let (standing, sharing) = standing_bodies(model).ok()?;
        Some(Self { model, standing, sharing })
    }

    fn bottoms(&self) -> HashMap<&str, &Bottom> {
        let all = self.standing.iter().flat_map(|body| &body.bottoms);
        all.map(|bottom| (bottom.path.as_str(), bottom)).collect()
    }

    /// Bodies that stood as they were `before` and do not now.
    fn lost(&self, before: &Self) -> impl Iterator<Item = Finding> {
        let several = self.standing.len() > 1;
        self.standing.iter().filter_map(move |now| {
            let before = before.standing.iter().find(|old| old.body == now.body)?;
            is_lost(before, now).then(|| rules::bottoms_moved_of_body(before, now, several))?
        })
    }

    /// Limbs whose bottoms are less level than `before`.
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

/// Whether a body stood `before`, and is inside its floor or above it `now`, because its bottoms moved.
fn is_lost(before: &StandingBody, now: &StandingBody) -> bool {
    let Some((was, is)) = before.lowest().zip(now.lowest()) else { return false };
    let stood = was.height_m.abs() <= STANDS * was.radius_m;
    let is_off = is.height_m > STANDS * is.radius_m || now.is_inside_floor();
    stood && is_off && (is.height_m - was.height_m).abs() > SMALL * is.radius_m
}

/// What a change does to a limb whose bottoms it moves apart; each was at the first place and is at the second.
fn uneven(limb: &str, bottoms: &[(&Bottom, &Bottom)]) -> Option<Finding> {
    let heights = |of: fn(&(&Bottom, &Bottom)) -> f64| bottoms.iter().map(of).collect::<Vec<f64>>();
    let moved_m = spread(&heights(|(was, is)| is.height_m - was.height_m));
    let (before_m, now_m) =
        (spread(&heights(|(was, _)| was.height_m)), spread(&heights(|(_, is)| is.height_m)));
    let by_height = |a: &&Bottom, b: &&Bottom| a.height_m.total_cmp(&b.height_m);
    let lowest = bottoms.iter().map(|(_, is)| *is).min_by(by_height)?;
    let highest = bottoms.iter().map(|(_, is)| *is).max_by(by_height)?;
    let small_m = SMALL * lowest.radius_m;
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
