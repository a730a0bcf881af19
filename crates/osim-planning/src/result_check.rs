//! Judges a plan by the model after the change: how this model is inspected, and what is worse in it than in the model before.

use std::collections::{HashMap, HashSet};

use osim_inspect::{
    Bottom, Figures, FindingIndex, FindingWithRemedy, InspectOptions, LoadSharing, SphereFigures, Stance,
    StandingBody, all_findings, check_without_remedies, describe_unmatched_patterns, sort_findings,
    without_effects,
};
use osim_model::feet::{MOST_LEAN_RAD, PoseFault, Standing};
use osim_model::files::{Failure, Files, OpenModel};
use osim_model::messages::{Input, Phrase, Verb, phrase};
use osim_model::{
    Fault, Finding, FindingCode, Limb, Model, Property, Selection, Severity, Source, Suspicion, YesQuestion,
    are_equal_masses, is_at_target, least_and_most,
};
use osim_patch::{ChangedBy, Plan, StepDetails};
use osim_requests::NoteDetails;

use crate::{PreparedChange, rules};

impl PreparedChange {
    /// Plans the change of a model that was [opened](Self::open). The plan has a note. Its findings are those about the changed model, and
    /// those about the change itself.
    ///
    /// # Errors
    /// Those of [`plan_with_companions`](Self::plan_with_companions); a change after which the model is wrong, unless the caller means it.
    pub fn plan(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        self.plan_with_result(opened, files, Plan::model_to_inspect).map(|(plan, _)| plan)
    }

    /// Plans like [`plan`](Self::plan), and also returns the changed model as `changed` makes it; `None` if nothing changes.
    ///
    /// # Errors
    /// Those of [`plan`](Self::plan).
    pub fn plan_with_result(
        &self,
        opened: &OpenModel,
        files: &dyn Files,
        changed: fn(&Plan, &Model) -> Result<Model, Fault>,
    ) -> Result<(Plan, Option<Model>), Failure> {
        let mut plan = self.plan_with_note(opened, files)?;
        let changed = (!plan.is_empty()).then(|| changed(&plan, &opened.model)).transpose();
        let changed = changed.map_err(|fault| opened.failure(fault))?;
        self.judge(opened, &mut plan, changed.as_ref())?;
        Ok((plan, changed))
    }

    /// The plan with its note, and with the findings about the change itself.
    fn plan_with_note(&self, opened: &OpenModel, files: &dyn Files) -> Result<Plan, Failure> {
        let model = &opened.model;
        let mut plan = self.plan_with_companions(opened, files)?;
        if self.output.no_note {
            plan.drop_note();
            if model.note.is_some() && !plan.is_empty() {
                let text =
                    "the note is removed: the next run cannot read the mass that the contacts are made for";
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
        let InspectOptions { selection, masses, .. } = &self.options;
        plan.remarks.extend(describe_unmatched_patterns(selection, masses, model));
        Ok(plan)
    }

    /// Adds the findings of `check` about the `changed` model; `None` means that the model stays as it was.
    ///
    /// # Errors
    /// An error that neither the model before nor the reference has, unless the caller confirmed it.
    fn judge(&self, opened: &OpenModel, plan: &mut Plan, changed: Option<&Model>) -> Result<(), Failure> {
        let masses = &self.options.masses;
        let weighs = masses.model_mass(&opened.model).ok();
        let weighs = weighs.or_else(|| Some(masses.contacts_mass(&opened.model).ok()?.0));
        let weighs_kg = weighs.map(|mass| mass.kg);
        let chosen = [self.options_before(plan), self.options_after(plan, weighs_kg)];
        let (judged, figures) = self.findings_of_result(&chosen, opened, changed);
        let is_sunk_in = |one: &&Finding| {
            one.code() == FindingCode::SunkIn && !(one.had_before && one.severity == Severity::Error)
        };
        // Contacts are scaled before the bodies, which then still have another mass. The default pose of the scaled bodies is not known, and
        // a warning about the present pose would come with every rescaling to another mass.
        let is_other = |target| weighs_kg.is_none_or(|weighs| !are_equal_masses(weighs, target));
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        let awaits = self.is_for_target_mass() && target_mass_kg.is_some_and(is_other);
        let moved = changed.filter(|_| !awaits || judged.iter().any(|one| is_sunk_in(&one)));
        let mut moved = moved.map_or_else(MovedBottoms::default, |changed| {
            MovedBottoms::between(plan, &opened.model, changed)
        });
        // Numbers that the caller gave are meant, even if the model is wrong with them; and so is what is taken out, even if the rest
        // cannot carry the body.
        // A change that is taken back gives a model that was there before: nobody has to be asked about it.
        let is_confirmed = matches!(self.verb, Verb::Set | Verb::Design | Verb::Fit | Verb::Remove)
            || plan.restores_original()
            || self.answers.confirms(YesQuestion::WrongAfterwards);
        // Where lower spheres carry the body alone, the change is wrong only if it moved bottoms apart, or if spheres of the reference do
        // not sink in: else they hung lower before.
        let has_parted = !moved.uneven.is_empty();
        let is_known = self.reference.as_ref().is_some_and(|reference| reference.figures.is_some());
        let is_reference_right =
            is_known && self.findings_of_reference().iter().all(|one| one.code() != FindingCode::SunkIn);
        let mut spheres = figures.iter().flat_map(Figures::spheres);
        let is_too_soft = spheres.any(SphereFigures::is_in_to_centre);
        let is_wrong = |one: &&Finding| {
            let is_error = one.severity == Severity::Error && !one.had_before;
            match is_sunk_in(one) {
                true => has_parted || (is_error && (is_too_soft || is_reference_right)),
                false => is_error,
            }
        };
        let wrong = judged.iter().find(is_wrong);
        if let Some(wrong) = wrong.filter(|_| !is_confirmed) {
            let has_parted = has_parted && is_sunk_in(&wrong);
            let mut question = opened.failure(Fault::new(question_about(wrong, has_parted)));
            self.keep_ways_out(&mut question.message);
            return Err(question);
        }
        // Forces that were not chosen are judged, too, and nobody is asked about them: they may be the next change.
        let all = Selection::default();
        let judged = match chosen[0].selection != all && all.apply(&opened.model).is_ok() {
            true => {
                let all = chosen.map(|options| InspectOptions { selection: all.clone(), ..options });
                self.findings_of_result(&all, opened, changed).0
            }
            false => judged,
        };
        let cases: HashSet<_> = judged.iter().flat_map(cases_of).collect();
        plan.findings.retain(|own| !cases_of(own).all(|case| cases.contains(&case)));
        if awaits {
            // Nobody knows the default pose of the scaled bodies yet.
            moved = MovedBottoms::default();
        } else if judged.iter().any(|one| one.code() == FindingCode::UnevenBottoms) {
            // A foot is called uneven once.
            moved.uneven.clear();
        }
        // Where a foot leans the pose decides which of its spheres is low.
        let uneven = moved.uneven.into_iter().filter(|(_, leans)| !leans).map(|(finding, _)| finding);
        let all = judged.into_iter().map(about_new_model).chain(moved.off_floor).chain(uneven);
        plan.findings.extend(all.map(|mut finding| {
            self.keep_ways_out(&mut finding.message);
            finding
        }));
        Ok(())
    }

    /// The findings of `check` about the `changed` model, inspected with the options for the old and for the new model. Each is marked if
    /// the old model or the reference has it. Also the figures of the new model; `None` means that the model stays as it was.
    fn findings_of_result(
        &self,
        [options_before, options_after]: &[InspectOptions; 2],
        opened: &OpenModel,
        changed: Option<&Model>,
    ) -> (Vec<Finding>, Option<Figures>) {
        let inspected = changed.map(|changed| options_after.inspect_for_rules(opened.name(), changed));
        let after = changed
            .zip(inspected.as_ref())
            .map(|(changed, inspected)| all_findings(options_after, changed, inspected));
        let inspected_before = match &after {
            Some(after) => options_before.inspect_to_compare(opened.name(), &opened.model, after),
            None => options_before.inspect_for_rules(opened.name(), &opened.model),
        };
        // With what only follows from other findings: where these are gone, the rest is not new.
        let mut before = all_findings(options_before, &opened.model, &inspected_before);
        let after = after.unwrap_or_else(|| before.clone());
        let (after, _) = without_effects(changed.unwrap_or(&opened.model), after);
        if after.iter().any(|one| one.severity == Severity::Error) {
            // A cause is as severe as what follows from it.
            before.extend(without_effects(&opened.model, before.clone()).0);
        }
        // The worst of a kind is first.
        let judged = self.mark_known(&sort_findings(before), &sort_findings(after));
        (judged, inspected.map(|inspected| inspected.figures))
    }

    /// The findings `after` a change. Each is marked if the model had it `before`, or the reference has it.
    fn mark_known(&self, before: &[FindingWithRemedy], after: &[FindingWithRemedy]) -> Vec<Finding> {
        let index = FindingIndex::new(before);
        let was_same = |one: &FindingWithRemedy, was: &FindingWithRemedy| match was.code() == one.code() {
            // A finding with another code in the same place is not new, either.
            false => was.rule.severity >= one.rule.severity,
            // Masses differ in another way where other numbers are said.
            true if one.code() == FindingCode::MassSourcesDisagree => was.message == one.message,
            true => was.severity >= one.severity,
        };
        let is_of = |one: &FindingWithRemedy, reference: &FindingWithRemedy| {
            // An error of the reference is new in a model that has none.
            one.severity < Severity::Error
                && reference.code() == one.code()
                && reference.severity >= one.severity
        };
        let had = |one: &FindingWithRemedy| {
            let is_known = |code| code != one.code() || index.has_all_places(one);
            let was = index.find_same_or_other_depth(one).filter(|was| is_known(was.code()));
            was.is_some_and(|was| was_same(one, was))
                || self.findings_of_reference().iter().any(|reference| is_of(one, reference))
        };
        let judged = |one: &FindingWithRemedy| Finding { had_before: had(one), ..one.finding.clone() };
        after.iter().map(judged).collect()
    }

    /// The findings about the reference, if the contacts come from one.
    fn findings_of_reference(&self) -> &[FindingWithRemedy] {
        self.reference.as_ref().map_or(&[], |reference| &reference.findings)
    }

    /// Whether the contacts are judged under the target mass instead of the mass of the bodies.
    fn is_for_target_mass(&self) -> bool {
        self.verb == Verb::Rescale
    }

    /// The options with which the new model is inspected, if the old model weighs `weighs_kg`: under the mass that its contacts were scaled
    /// for.
    pub(crate) fn options_after(&self, plan: &Plan, weighs_kg: Option<f64>) -> InspectOptions {
        let mut options = self.options.clone();
        let target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        // The inspection reads this mass from the note; if the plan writes no note, it has to be told.
        options.masses.contacts_mass_kg = target_mass_kg.filter(|_| plan.note().is_none());
        if let Some(target_mass_kg) = target_mass_kg.filter(|_| self.is_for_target_mass())
            && weighs_kg.is_none_or(|weighs| !is_at_target(weighs, target_mass_kg))
        {
            options.masses.model_kg = Some(target_mass_kg);
        }
        // If the caller gave a gravity for figures (as for a design), both states are inspected with it.
        options.stance.gravity_m_s2 = self.target_gravity_m_s2.or(options.stance.gravity_m_s2);
        options
    }

    /// The options with which the old model is inspected, for a comparison with the new one. If the new model is inspected under its target
    /// mass, the old one is inspected under the mass that its contacts were made for.
    fn options_before(&self, plan: &Plan) -> InspectOptions {
        let mut options = self.options.clone();
        if let Some(masses) = plan.masses.as_ref().filter(|_| self.is_for_target_mass()) {
            options.masses.model_kg = Some(masses.contacts_mass.kg);
        } else {
            // What the caller says now was not in the file.
            options.masses.contacts_mass_kg = None;
        }
        options
    }
}

/// A key for each place of a finding. If two findings have a key in common, they are about the same fault at the same place.
fn cases_of(finding: &Finding) -> impl Iterator<Item = (FindingCode, Option<&str>, Severity)> {
    finding.paths_or_none().map(|place| (finding.code(), place, finding.severity))
}

/// All findings about `model`, without remedies.
pub(crate) fn findings_without_remedies(
    options: &InspectOptions,
    opened: &OpenModel,
    model: &Model,
) -> Vec<FindingWithRemedy> {
    let inspected = options.inspect_for_rules(opened.name(), model);
    check_without_remedies(options, model, &inspected)
}

/// The question whether the caller wants a result with the fault `wrong`. `has_parted` says that the change moved bottoms of a foot apart.
fn question_about(wrong: &Finding, has_parted: bool) -> Suspicion {
    let advice = match wrong.code() {
        _ if has_parted => phrase![
            "Radii that differ change around centres that stay, so lowest points move apart. Keep the lowest points \
            where they are with {}, or the radii with {}";
            Input::Level, Input::Radius.with_value("keep")
        ],
        FindingCode::Floats => {
            let options = phrase![
                ", with {} and {}, or confirm this and do what {} then proposes";
                Input::ConstantContactForce, Input::HertzSmoothing, Verb::Check.call()
            ];
            phrase![&wrong.advice, Input::ConstantContactForce.either(options, "")]
        }
        _ => wrong.advice.clone(),
    };
    let text: Phrase = phrase![
        "the model would be wrong afterwards [{}]: {}. {}";
        wrong.code().as_str(), &wrong.message, &advice
    ];
    Suspicion::Other { question: YesQuestion::WrongAfterwards, text }
}

/// A finding about the new model for people who have only the old file. Its line is left out, because it is a line of the new file.
fn about_new_model(found: Finding) -> Finding {
    if found.had_before {
        return found.with_position(None);
    }
    let message = match found.code() {
        // Only part of the contacts was changed.
        FindingCode::StaleNote => "the next run will ask for which mass the contacts are made".into(),
        _ => found.message.clone(),
    };
    found.with_message(phrase!["in the new model: ", &message]).with_position(None)
}

// What a change does to the bottoms of spheres: bodies that stood at their default pose and no longer do, and feet that it makes
// uneven.

/// If a bottom moves by less than this, in radii of the sphere, the move has no effect on findings.
const SMALL_MOVE_RADII: f64 = 0.1;
/// A body stands if the distance of its lowest sphere from the floor is at most this, in radii of the sphere.
const STANDING_DISTANCE_RADII: f64 = 0.5;

/// Findings about the bottoms of spheres, if a plan moves them.
///
/// Spheres that follow their bodies are not judged: before, they were in wrong places. Nor are new spheres: `add` says where they are.
#[derive(Default)]
struct MovedBottoms {
    /// Findings about bodies that stood at their default pose before the change, and do not stand after it.
    off_floor: Vec<Finding>,
    /// Findings about limbs whose bottoms the change moves apart, each with whether the limb leans.
    uneven: Vec<(Finding, bool)>,
}

impl MovedBottoms {
    /// The findings about bottoms that `plan` moves, from the models before and after it.
    fn between(plan: &Plan, before: &Model, after: &Model) -> Self {
        let radii = plan.changes.iter().any(|change| change.property == Property::Radius);
        let follow = plan.moves.iter().any(|one| one.by == ChangedBy::Follow);
        if (!radii && plan.moves.is_empty()) || follow || !plan.objects().is_empty() {
            return Self::default();
        }
        let both = BodiesOverFloor::at_default_pose(before).zip(BodiesOverFloor::at_default_pose(after));
        both.map_or_else(Self::default, |(before, after)| Self {
            off_floor: after.no_longer_standing(&before).collect(),
            uneven: after.uneven_limbs(&before),
        })
    }
}

/// The bodies of a model at its default pose, with the heights of their spheres over the floors.
struct BodiesOverFloor<'m> {
    model: &'m Model,
    standing: Vec<StandingBody>,
    sharing: LoadSharing,
}

impl<'m> BodiesOverFloor<'m> {
    /// The bodies at the default pose; `None` if this pose is not known.
    fn at_default_pose(model: &'m Model) -> Option<Self> {
        let (standing, sharing) = standing_bodies(model).ok()?;
        Some(Self { model, standing, sharing })
    }

    /// The bottom of each sphere, by the sphere's component path.
    fn bottoms_by_path(&self) -> HashMap<&str, &Bottom> {
        let all = self.standing.iter().flat_map(|body| &body.bottoms);
        all.map(|bottom| (bottom.path.as_str(), bottom)).collect()
    }

    /// Findings about bodies that stood `before` the change and do not stand after it.
    fn no_longer_standing(&self, before: &Self) -> impl Iterator<Item = Finding> {
        let several = self.standing.len() > 1;
        self.standing.iter().filter_map(move |now| {
            let before = before.standing.iter().find(|old| old.body == now.body)?;
            stands_no_longer(before, now).then(|| rules::bottoms_moved_of_body(before, now, several))?
        })
    }

    /// Findings about limbs whose bottoms are less level than `before` the change, each with whether the limb leans.
    fn uneven_limbs(&self, before: &Self) -> Vec<(Finding, bool)> {
        let (old, new) = (before.bottoms_by_path(), self.bottoms_by_path());
        let pair = |path: &str| Some((*old.get(path)?, *new.get(path)?));
        let limbs = self.sharing.limbs.if_known().unwrap_or_default().iter();
        let of_limb = |limb: &Limb| {
            let spheres = limb.spheres.iter().filter_map(|&id| self.model.sphere(id));
            uneven_limb(&limb.name, &spheres.filter_map(|sphere| pair(&sphere.path)).collect::<Vec<_>>())
        };
        limbs.filter_map(of_limb).collect()
    }
}

/// Whether a body stood `before` the change, and `after` it is inside its floor or above it because the bottoms moved.
fn stands_no_longer(before: &StandingBody, after: &StandingBody) -> bool {
    let Some((was, is)) = before.lowest().zip(after.lowest()) else { return false };
    let stood = was.height_m.abs() <= STANDING_DISTANCE_RADII * was.radius_m;
    let is_off = is.height_m > STANDING_DISTANCE_RADII * is.radius_m || after.is_inside_floor();
    stood && is_off && (is.height_m - was.height_m).abs() > SMALL_MOVE_RADII * is.radius_m
}

/// The finding about a limb whose bottoms a change moves apart, with whether the limb leans. `bottoms` has each before and after it.
fn uneven_limb(limb: &str, bottoms: &[(&Bottom, &Bottom)]) -> Option<(Finding, bool)> {
    let spread = |height_m: fn(&(&Bottom, &Bottom)) -> f64| {
        let (least_m, most_m) = least_and_most(bottoms.iter().map(height_m));
        most_m - least_m
    };
    let moved_m = spread(|(was, is)| is.height_m - was.height_m);
    let (before_m, now_m) = (spread(|(was, _)| was.height_m), spread(|(_, is)| is.height_m));
    let by_height = |a: &&Bottom, b: &&Bottom| a.height_m.total_cmp(&b.height_m);
    let lowest = bottoms.iter().map(|(_, is)| *is).min_by(by_height)?;
    let highest = bottoms.iter().map(|(_, is)| *is).max_by(by_height)?;
    let small_m = SMALL_MOVE_RADII * lowest.radius_m;
    let leans = bottoms.iter().any(|(_, is)| is.tilt_rad > MOST_LEAN_RAD);
    let is_uneven = moved_m > small_m && (leans || now_m - before_m > small_m);
    is_uneven.then(|| (rules::bottoms_moved_of_limb(limb, before_m, lowest, highest), leans))
}

/// The joint trees with spheres over a floor, each standing on one limb alone, and the limbs of the model.
pub(crate) fn standing_bodies(model: &Model) -> Result<(Vec<StandingBody>, LoadSharing), PoseFault> {
    let forces = model.force_ids();
    let standing = Standing::all(model, &forces)?;
    let sharing = LoadSharing::of(model, &forces);
    Ok((StandingBody::all(model, &standing, &sharing.limbs, Stance::default().limb_count(model)), sharing))
}
