//! What each changing verb plans for a model.

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use contact_scaling::SharedLoad;
use osim_patch::{
    Anatomy, Assignment, Design, DesignModulus, Document, Factors, Fault, FaultKind, Follow, FollowRequest,
    Mass, MassRequest, MassSource, Model, Plan, Property, RadiusRule, Reference, Rescale, ScaleFile,
    ScalingRule, Selected, Selection, Set, Transfer, Warning, design, moving_spheres, reference_of_model,
    rescale, set, shortest, transfer,
};

use crate::args::{
    DesignArgs, OutputArgs, PartArgs, RescaleArgs, RuleArg, SetArgs, TransferArgs, assignment, set_of,
};
use crate::change::Planner;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::presets;
use crate::sources::{Source, read};

/// A factor that the note says was applied already is not applied once more in place.
fn refuse_again(model: &Model<'_, '_>, operation: &str, output: &OutputArgs) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation == operation);
    if !done || !output.in_place || output.force {
        return Ok(());
    }
    Err(Fault::new(FaultKind::NeedsAnswer {
        code: "same-operation",
        question: format!("the note in the file says that '{operation}' was done already"),
        way_out: "apply it once more with --force".to_owned(),
    }))
}

/// The verb, and the factor of the radius where one is given.
fn operation(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// `--target-mass`.
pub(crate) struct RescaleVerb<'v> {
    args: &'v RescaleArgs,
    target_mass_kg: f64,
    selection: Selection,
    masses: MassRequest,
}

impl<'v> RescaleVerb<'v> {
    pub(crate) fn new(args: &'v RescaleArgs, target_mass_kg: f64) -> Result<Self> {
        args.scaling.check()?;
        let masses = MassRequest { target_kg: Some(target_mass_kg), ..args.masses.request()? };
        Ok(Self { args, target_mass_kg, selection: args.choice.selection()?, masses })
    }
}

impl Planner for RescaleVerb<'_> {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        let scaling = &self.args.scaling;
        let operation = operation("rescale", scaling.radius);
        if matches!(scaling.radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, &self.args.output)?;
        }
        let contacts_mass = self.masses.of_contacts(model, &mut warnings)?;
        let wanted = Rescale {
            target_mass_kg: self.target_mass_kg,
            contacts_mass,
            radius: scaling.radius.unwrap_or(RadiusRule::Isometric),
            properties: scaling.properties(),
            dissipation_by: scaling.dissipation(),
            target_gravity_m_s2: scaling.target_gravity,
            contacts_gravity_m_s2: scaling.contacts_gravity,
            level: scaling.level_axis(model.gravity_m_s2),
        };
        let mut plan = rescale(model, &selected, &wanted)?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

/// `transfer --from`.
pub(crate) struct TransferVerb<'v> {
    args: &'v TransferArgs,
    selection: Selection,
    masses: MassRequest,
    reference: Reference,
    /// The generic model's bones and the Scale Tool's factors, where spheres follow their bodies.
    generic: Option<Generic>,
}

/// What spheres follow from.
struct Generic {
    anatomy: Anatomy,
    file: Option<ScaleFile>,
    /// What to ask about the reference's sphere count, once its spheres are matched.
    count_unknown: Option<Fault>,
}

impl<'v> TransferVerb<'v> {
    /// Reads the reference once, for all models.
    ///
    /// # Errors
    /// The reference is no preset and no file (wrong usage), or a model that cannot be a reference.
    pub(crate) fn new(args: &'v TransferArgs) -> Result<Result<Self, Failure>> {
        if args.masses.contacts_mass.is_some() {
            bail!(
                "--contacts-mass says nothing here: the reference's mass is --reference-mass, this model's --mass"
            );
        }
        let selection = args.choice.selection()?;
        let masses = args.masses.request()?;
        if args.scaling.level && !args.follow.follow_bodies {
            bail!("--level in a transfer needs --follow-bodies: without it neither radii nor soles change");
        }
        if args.scaling.radius.is_some() && args.follow.follow_bodies {
            bail!(
                "--radius says nothing with --follow-bodies: radii follow the bodies (--radius-axis), or stay with \
                 --keep radius"
            );
        }
        let reference = match preset(args)? {
            Some(_) if args.follow.follow_bodies => {
                bail!("--follow-bodies needs the generic model as --from, a preset has no bodies")
            }
            Some(reference) => Ok((reference, None)),
            None => reference_from_file(args),
        };
        Ok(reference.map(|(mut reference, generic)| {
            let given = &args.reference;
            reference.gravity_m_s2 = given.reference_gravity.or(reference.gravity_m_s2);
            Self { args, selection, masses, reference, generic }
        }))
    }
}

fn preset(args: &TransferArgs) -> Result<Option<Reference>> {
    if let Some(preset) = presets::find(&args.from, args.presets.as_deref())? {
        let mut reference = Reference::from(&preset);
        if let Some(kg) = args.reference.reference_mass {
            reference.mass = reference_mass(kg);
        }
        reference.sphere_count = args.reference.reference_spheres.unwrap_or(reference.sphere_count);
        return Ok(Some(reference));
    }
    if !args.from.exists() {
        bail!(
            "--from '{}': there is no such file and no such preset, expected a model or one of: {}",
            args.from.display(),
            presets::names(args.presets.as_deref())
        );
    }
    Ok(None)
}

fn reference_mass(kg: f64) -> Mass {
    Mass { kg, source: MassSource::Reference, told_by: "--reference-mass".to_owned() }
}

fn reference_from_file(args: &TransferArgs) -> Result<(Reference, Option<Generic>), Failure> {
    let source = Source { path: args.from.clone(), folder: None };
    let loaded = Loaded::read(&source, &PartArgs { geometry: None, model: None })?;
    let reference = loaded.with_model(|model| {
        let (reference, count_unknown) =
            reference_from_model(model, args).map_err(|fault| loaded.failure(fault))?;
        if !args.follow.follow_bodies {
            return Ok((reference, None));
        }
        let anatomy = Anatomy::of(model).map_err(|fault| loaded.failure(fault))?;
        let file = args.follow.body_scale_file.as_deref().map(scale_file).transpose()?;
        Ok((reference, Some(Generic { anatomy, file, count_unknown })))
    });
    reference.map_err(|failure| match failure.code {
        // The usual way out, --geometry, is about the model that gets the contacts.
        "incomplete-set" => Failure {
            message: "a set that stands alone cannot be a reference: name the model it belongs to".to_owned(),
            ..failure
        },
        _ => failure,
    })
}

/// Reads the Scale Tool's applied factors.
pub(crate) fn scale_file(path: &Path) -> Result<ScaleFile, Failure> {
    let shown = path.display().to_string();
    let bytes = read(path).map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
    let document = Document::parse(&bytes).map_err(|fault| Failure::of_fault(&shown, fault, &bytes))?;
    ScaleFile::read(&document).map_err(|fault| Failure::of_fault(&shown, fault, &bytes))
}

fn reference_from_model(
    model: &Model<'_, '_>,
    args: &TransferArgs,
) -> Result<(Reference, Option<Fault>), Fault> {
    let select = set_of(&args.reference.reference_select).unwrap_or_default();
    let selection = Selection { select, ..Selection::default() };
    let selected = selection.apply(model).map_err(about_reference)?;
    let mass = match args.reference.reference_mass {
        Some(kg) => reference_mass(kg),
        None => MassRequest::default().of_contacts(model, &mut Vec::new())?,
    };
    // --stance-limbs is about this model; a reference that stands on several limbs says --reference-spheres.
    let (count, unknown) = match args.reference.reference_spheres {
        Some(count) => (count, None),
        None => match sphere_count(model, 1.0, "--reference-spheres") {
            Ok(count) => (count, None),
            // A sphere that is missing on one side is named first, by comparing the two models.
            Err(fault) if args.follow.follow_bodies => (f64::NAN, Some(fault)),
            Err(fault) => return Err(fault),
        },
    };
    let mut reference = reference_of_model(model, &selected, mass, count)?;
    reference.name =
        args.from.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Ok((reference, unknown))
}

/// Ways out that are about the reference, not about the model that gets its contacts.
fn about_reference(mut fault: Fault) -> Fault {
    if let FaultKind::NeedsAnswer { way_out, .. } = &mut fault.kind {
        *way_out = way_out.replace("--select", "--reference-select");
    }
    fault
}

/// n as found per limb times the stance limbs, or a question.
///
/// All spheres that stand count, whichever forces were selected: those left out carry weight too.
pub(crate) fn sphere_count(model: &Model<'_, '_>, stance_limbs: f64, option: &str) -> Result<f64, Fault> {
    let all: Vec<usize> = (0..model.forces.len()).collect();
    let limbs = model.limbs(&all);
    match limbs.spheres_per_limb() {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        Ok(count) => Ok(count as f64 * stance_limbs),
        Err(why) => Err(Fault::new(FaultKind::NeedsAnswer {
            code: "sphere-count",
            question: format!("how many spheres share the body weight is not known: {why}"),
            way_out: format!("say it with {option} N"),
        })),
    }
}

impl Planner for TransferVerb<'_> {
    fn reads(&self) -> Vec<PathBuf> {
        std::iter::once(&self.args.from).chain(&self.args.follow.body_scale_file).cloned().collect()
    }

    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let scaling = &self.args.scaling;
        let mut warnings = Vec::new();
        let follow = match &self.generic {
            Some(generic) => Some(self.follow(model, &selected, generic, &mut warnings)?),
            None => None,
        };
        let sphere_count = match self.args.counts.spheres {
            Some(count) => count,
            None => sphere_count(model, self.args.counts.stance_limbs, "--spheres")?,
        };
        let operation = operation("transfer", scaling.radius);
        if matches!(scaling.radius, Some(RadiusRule::Factor(_))) {
            refuse_again(model, &operation, &self.args.output)?;
        }
        let mass = self.masses.of_model(model)?;
        self.masses.compare(model, &mass, &mut warnings);
        let rule = self.rule(follow.as_ref())?;
        let mut plan = transfer(
            model,
            &selected,
            &Transfer {
                reference: self.reference.clone(),
                reference_sphere: self.args.reference.reference_sphere.clone(),
                mass,
                sphere_count,
                radius: scaling.radius.unwrap_or(RadiusRule::Keep),
                properties: scaling.properties(),
                dissipation_by: scaling.dissipation(),
                target_gravity_m_s2: scaling.target_gravity,
                follow,
                rule,
                strict: self.args.follow.strict,
            },
        )?;
        plan.name_operation(&operation);
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

impl TransferVerb<'_> {
    fn follow(
        &self,
        model: &Model<'_, '_>,
        selected: &Selected,
        generic: &Generic,
        warnings: &mut Vec<Warning>,
    ) -> Result<Follow, Fault> {
        let args = &self.args.follow;
        let scaled = Anatomy::of(model)?;
        let factors = Factors::find(&scaled, &generic.anatomy, generic.file.as_ref(), &args.given())?;
        warnings.extend(factors.warnings.iter().cloned());
        let request = FollowRequest {
            radius_axis: args.radius_axis(),
            level: self.args.scaling.level_axis(model.gravity_m_s2),
            moved: args.moved(),
            keep_radii: !self.args.scaling.properties().contains(Property::Radius),
        };
        Follow::refuse_missing(&scaled, self.reference.contacts.iter().flat_map(|contact| &contact.spheres))?;
        let spheres = moving_spheres(model, &selected.forces);
        let follow = Follow::find(model, &spheres, &scaled, &generic.anatomy, &factors, &request)?;
        match &generic.count_unknown {
            Some(fault) => Err(fault.clone()),
            None => Ok(follow),
        }
    }

    fn rule(&self, follow: Option<&Follow>) -> Result<ScalingRule, Fault> {
        if self.args.follow.rule == RuleArg::Paper {
            return Ok(ScalingRule::Paper);
        }
        let ratio = self.args.follow.height_ratio.or(follow.map(|follow| follow.size_ratio));
        let Some(height_ratio) = ratio else {
            return Err(Fault::new(FaultKind::Refused(
                "--rule predsim needs the ratio of heights: say --height-ratio RATIO, or --follow-bodies"
                    .to_owned(),
            )));
        };
        Ok(ScalingRule::PredSim { height_ratio })
    }
}

/// `set`.
pub(crate) struct SetVerb {
    pub models: Vec<PathBuf>,
    assignments: Vec<(Property, Assignment)>,
    selection: Selection,
    masses: MassRequest,
    again: bool,
}

impl SetVerb {
    /// Parts the words of the command line into models and assignments.
    ///
    /// # Errors
    /// No model, nothing to set, an unknown property or a value that is no number.
    pub(crate) fn new(args: &SetArgs) -> Result<Self> {
        let mut models = Vec::new();
        let mut assignments: Vec<(Property, Assignment)> = Vec::new();
        for item in &args.items {
            // A name that is not UTF-8 is no assignment.
            match item.to_str().and_then(|item| item.split_once('=')) {
                Some((name, value)) if !Path::new(item).exists() => {
                    let new = assignment(name, value).map_err(|why| anyhow!(why))?;
                    if assignments.iter().any(|(property, _)| *property == new.0) {
                        bail!("{} is set twice", new.0);
                    }
                    assignments.push(new);
                }
                _ => models.push(PathBuf::from(item)),
            }
        }
        if models.is_empty() {
            bail!("no model given, expected one or more .osim files or folders (see set --help)");
        }
        if assignments.is_empty() {
            bail!("nothing to set, expected PROPERTY=VALUE or PROPERTY=xFACTOR, for example stiffness=x2");
        }
        Ok(Self {
            models,
            assignments,
            selection: args.choice.selection()?,
            masses: args.masses.request()?,
            again: args.output.force || !args.output.in_place,
        })
    }
}

impl Planner for SetVerb {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        // A plain change needs no mass; where one is known, the note goes on saying it.
        let of_note = || {
            let kg = model.note.as_ref()?.mass_kg?;
            Some(Mass { kg, source: MassSource::Note, told_by: "note in the file".to_owned() })
        };
        let contacts_mass = self.masses.of_contacts(model, &mut warnings).ok().or_else(of_note);
        let assignments = self.assignments.clone();
        let mut plan = set(model, &selected, &Set { assignments, contacts_mass, again: self.again })?;
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}

/// `design` with models.
pub(crate) struct DesignVerb<'v> {
    args: &'v DesignArgs,
    selection: Selection,
    masses: MassRequest,
}

impl<'v> DesignVerb<'v> {
    /// # Errors
    /// Options that say nothing, or contradict each other.
    pub(crate) fn new(args: &'v DesignArgs) -> Result<Self> {
        let wanted = &args.wanted;
        let sizes = wanted.indentation.is_some() || wanted.young.is_some();
        let asks = sizes
            || wanted.restitution.is_some()
            || wanted.constant_indentation.is_some()
            || wanted.state_width.is_some()
            || wanted.speed_width.is_some()
            || wanted.radius.is_some();
        if args.masses.contacts_mass.is_some() {
            bail!("--contacts-mass says nothing here: a design follows from --mass and the load");
        }
        if wanted.indentation.is_none() && (args.load.load.is_some() || args.load.body_weights.is_some()) {
            bail!(
                "a load says nothing without --indentation X: leave it out, or say the indentation it shall give"
            );
        }
        if wanted.radius == Some(RadiusRule::Isometric) {
            bail!(
                "--radius isometric says nothing here, expected keep, a radius in metres or a factor like x1.5"
            );
        }
        if wanted.stiffness.is_some() {
            bail!("--stiffness is known, not designed: write it with set MODEL stiffness=VALUE");
        }
        if wanted.indentation.is_some() && wanted.young.is_some() {
            bail!("--indentation and --young both say what the stiffness is: leave one out");
        }
        if wanted.contact_stiffness.is_some() && (wanted.indentation.is_none() || wanted.radius.is_some()) {
            bail!(
                "with models, --contact-stiffness needs --indentation, and gives the radius: leave out --radius"
            );
        }
        if !asks {
            bail!(
                "nothing is wanted: say for example --indentation X, --restitution CR or --constant-indentation X"
            );
        }
        Ok(Self { args, selection: args.choice.selection()?, masses: args.masses.request()? })
    }

    fn load(&self, model: &Model<'_, '_>) -> Result<(Option<SharedLoad>, Option<Mass>), Fault> {
        let args = self.args;
        if args.wanted.indentation.is_none() {
            return Ok((None, None));
        }
        let count = match args.counts.spheres {
            Some(count) => count,
            None => sphere_count(model, args.counts.stance_limbs, "--spheres")?,
        };
        let (load_n, mass) = match args.load.load {
            Some(load) => (load, None),
            None => {
                let mass = self.masses.of_model(model)?;
                let gravity = args.load.gravity.or(model.gravity()).filter(|&gravity| gravity > 0.0);
                let Some(gravity) = gravity else {
                    return Err(Fault::new(FaultKind::Refused(
                        "the model has no gravity, so body weight is nothing: say --gravity G or --load N"
                            .to_owned(),
                    )));
                };
                let load = mass.kg * gravity * args.load.body_weights.unwrap_or(1.0);
                (load, Some(mass))
            }
        };
        Ok((Some(SharedLoad::new(load_n, count).map_err(Fault::new)?), mass))
    }
}

impl Planner for DesignVerb<'_> {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let wanted = &self.args.wanted;
        let (load, mass) = self.load(model)?;
        let modulus = match (wanted.indentation, wanted.young.zip(wanted.poisson)) {
            (Some(x), _) => Some(DesignModulus::Indentation(x)),
            (None, Some((young_n_m2, poisson))) => Some(DesignModulus::Young { young_n_m2, poisson }),
            (None, None) => None,
        };
        let radius = match (wanted.contact_stiffness, wanted.indentation, &load) {
            (Some(k), Some(x), Some(load)) => {
                let radius = contact_scaling::design::radius_for_stiffness(k, x, load).map_err(Fault::new)?;
                RadiusRule::Designed(radius)
            }
            _ => wanted.radius.unwrap_or(RadiusRule::Keep),
        };
        let width = |width: Option<f64>| width.map(|width| (wanted.threshold, width));
        design(
            model,
            &selected,
            &Design {
                modulus,
                load,
                restitution: wanted.restitution.map(|restitution| (restitution, wanted.impact_speed)),
                constant_indentation: wanted.constant_indentation,
                state_width: width(wanted.state_width),
                speed_width: width(wanted.speed_width),
                radius,
                mass,
                gravity_m_s2: self.args.load.gravity,
            },
        )
    }
}

/// `true` for a path that a model may have.
pub(crate) fn looks_like_verb(path: &Path) -> bool {
    let text = path.to_string_lossy();
    !path.exists() && !text.contains(['.', '/', '\\']) && text != "-"
}
