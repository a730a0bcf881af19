//! Inspects and checks models with the options of a request, and compares them with a generic model if one is named.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use contact_scaling::Ratios;
use osim_inspect::{
    CONTACTS_ARE_EXCHANGED, CheckResult, FindingWithRemedy, InspectOptions, Inspection, ReferenceContacts,
    SignsOfScaling, SizeList, check_without_remedies, find_misplaced_spheres, unexplained_mass,
};
use osim_model::compare::{Factors, ModelSize, ScaleFile, Similarity, SpherePlacements, moco_bounds};
use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::messages::{Phrase, phrase};
use osim_model::{
    Anatomy, Document, Fault, FaultKind, Finding, FindingCode, MassRequest, Model, Selection, Severity,
};
use osim_requests::options::{AnswerOptions, InspectionOptions, SetFiles};
use osim_requests::{CheckRequest, InspectRequest, Kilograms};

use crate::motion_consistency::MotionRemark;
use crate::motion_remarks::CheckedMotion;
use crate::opening::{open, read_moco_setup, read_scale_file};
use crate::remedies::{NO_CODES, RemedyTrials};
use crate::verbs::reference::{MassOfPublished, mass_of_contacts};
use crate::{MotionResult, check_with_trials, rules};

/// Inspects and checks models as one request says, beside the files that all of its models are compared with.
pub struct Inspector {
    pub options: InspectOptions,
    pub set_files: SetFiles,
    /// The generic model, if the request names one. If it cannot be read, each model fails.
    generic: Option<Result<GenericModel, Failure>>,
    /// The files of the generic model, if `check` compares the places of spheres with it. (`inspect` compares the sizes of bodies instead.)
    place_reference: Option<(PathBuf, Option<PathBuf>)>,
    /// All files that are read in addition to the models.
    pub extra_files: Vec<PathBuf>,
    /// A mass, kg. The inspection lists the other numbers of the model that would follow a body of this mass.
    target_mass_kg: Option<f64>,
    /// The recording that the contacts are compared with, if one is given.
    motion: Option<CheckedMotion>,
    /// The caller's answers to questions about masses; `None` if the masses were already checked.
    answers: Option<AnswerOptions>,
}

/// The generic model, with which scaled models are compared.
struct GenericModel {
    anatomy: Anatomy,
    contacts: ReferenceContacts,
    /// The factors by which OpenSim's Scale Tool scaled the bodies.
    file: Option<ScaleFile>,
    /// The mass from which a transfer scales the contacts, kg, if it is known.
    contacts_kg: Option<f64>,
    /// The size of the generic model, and the quantities in it that follow size.
    size: ModelSize,
    /// Root mean square of the radii of its contacts, m, and dissipation of the first, s/m.
    radius_and_dissipation: Option<[f64; 2]>,
    /// The Moco setup for the models that are compared with the generic model.
    moco: Option<Document>,
    /// Codes of the findings about the generic model. Models with its contacts have the same faults.
    codes: BTreeSet<FindingCode>,
    /// The reason why nothing can be compared with the generic model: an error in it.
    fault: Option<Phrase>,
    /// What it shows about whether it was scaled itself.
    signs: SignsOfScaling,
}

/// Reads the generic model, and the ScaleSet beside it if there is one.
fn generic_model(
    from: &Path,
    body_scale_file: Option<&Path>,
    masses: &MassRequest,
    files: &dyn Files,
) -> Result<GenericModel, Failure> {
    let generic = open(from, files)?;
    let anatomy = Anatomy::of(&generic.model).map_err(|fault| generic.failure(fault))?;
    let file = body_scale_file.map(|path| read_scale_file(path, files)).transpose()?;
    let mass = |selected| mass_of_contacts(&generic.model, &selected, MassOfPublished::OfBodies);
    let contacts_kg = Selection::default().apply(&generic.model).and_then(mass).ok().map(|mass| mass.kg);
    let contacts = ReferenceContacts::from_model(&from.display().to_string(), &generic.model);
    // The masses of the request are those of the scaled model.
    let masses = MassRequest { exclude_bodies: masses.exclude_bodies.clone(), ..MassRequest::default() };
    let size = ModelSize::of(&generic.model, &masses);
    let options = InspectOptions { masses, ..InspectOptions::default() };
    let inspected = options.inspect_for_rules(generic.name(), &generic.model);
    let findings = check_without_remedies(&options, &generic.model, &inspected);
    let has_fault = |one: &&FindingWithRemedy| {
        one.severity == Severity::Error
            || (one.severity == Severity::Warning && one.code() == FindingCode::SpheresMisplaced)
    };
    let fault = findings.iter().find(has_fault).map(|one| {
        phrase![format!("{} has a fault of its own [{}]: ", from.display(), one.code()), &one.message]
    });
    Ok(GenericModel {
        anatomy,
        contacts,
        file,
        contacts_kg,
        size,
        radius_and_dissipation: rules::radius_and_dissipation(&generic.model),
        moco: None,
        codes: findings.iter().map(|one| one.code()).collect(),
        fault,
        signs: SignsOfScaling::of(&generic.model, &options.masses),
    })
}

/// The generic model with which `check` compares, and the setups of Moco.
fn generic_model_for_check(
    from: &Path,
    request: &CheckRequest,
    masses: &MassRequest,
    files: &dyn Files,
) -> Result<GenericModel, Failure> {
    let mut generic = generic_model(from, request.body_scale_file.as_deref(), masses, files)?;
    if let Some(path) = &request.moco_setup {
        generic.moco = Some(read_moco_setup(path, files)?);
    }
    if let Some(path) = &request.from_moco_setup {
        let model = open(from, files)?.model;
        generic.size = generic.size.with_values(moco_bounds(&read_moco_setup(path, files)?, &model));
    }
    Ok(generic)
}

impl Inspector {
    /// An inspector for the verb `inspect`; reads the files that all models are compared with.
    pub fn for_inspect(request: &InspectRequest, files: &dyn Files) -> Self {
        let plain = Self::asking_about_masses(&request.options);
        let read = |from: &Path| {
            generic_model(from, request.body_scale_file.as_deref(), &plain.options.masses, files)
        };
        let named = request.from.iter().chain(&request.body_scale_file).cloned();
        let extra_files = request.options.set_files.paths().cloned().chain(named).collect();
        let target_mass_kg = request.target_mass.map(Kilograms::get);
        Self { generic: request.from.as_deref().map(read), extra_files, target_mass_kg, ..plain }
    }

    /// An inspector for the verb `check`; reads the files that all models are compared with.
    pub fn for_check(request: &CheckRequest, files: &dyn Files) -> Self {
        let plain =
            Self { motion: CheckedMotion::of(request), ..Self::asking_about_masses(&request.options) };
        let Some(from) = request.from.clone() else { return plain };
        let file = request.body_scale_file.clone();
        let generic = Some(generic_model_for_check(&from, request, &plain.options.masses, files));
        let setups = request.moco_setup.iter().chain(&request.from_moco_setup);
        let extra_files =
            plain.extra_files.iter().chain([&from]).chain(&file).chain(setups).cloned().collect();
        Self { generic, place_reference: Some((from, file)), extra_files, ..plain }
    }

    /// An inspector with these options, which compares with no other file.
    pub fn new(options: &InspectionOptions) -> Self {
        Self {
            options: InspectOptions::from(options),
            set_files: options.set_files.clone(),
            generic: None,
            place_reference: None,
            extra_files: options.set_files.paths().cloned().collect(),
            target_mass_kg: None,
            motion: None,
            answers: None,
        }
    }

    /// An inspector that asks about a mass that looks like a typing mistake or another unit.
    fn asking_about_masses(options: &InspectionOptions) -> Self {
        Self { answers: Some(options.answers.clone()), ..Self::new(options) }
    }

    /// The reason why the generic model cannot be read.
    pub fn generic_failure(&self) -> Option<&Failure> {
        self.generic.as_ref()?.as_ref().err()
    }

    /// Inspects a model with the options of the request.
    ///
    /// # Errors
    /// The generic model cannot be read, factors cannot be determined, or a mass that the caller gave looks like a mistake.
    pub fn inspect(&self, opened: &OpenModel) -> Result<Inspection, Failure> {
        if let Some(answers) = &self.answers {
            let options = &self.options;
            let suspicion = unexplained_mass(&options.masses, &opened.model, &options.selection);
            let asked = answers.require_yes(suspicion);
            asked.map_err(|kind| opened.failure(Fault::new(kind)))?;
        }
        let generic = self.generic.as_ref().map(Result::as_ref).transpose().map_err(Failure::clone)?;
        let factors = match (generic, &self.place_reference) {
            (Some(GenericModel { anatomy, file, .. }), None) => {
                let scaled = Anatomy::of(&opened.model).map_err(|fault| opened.failure(fault))?;
                let found = Factors::find(&scaled, anatomy, file.as_ref(), &BTreeMap::new());
                Some(found.map_err(|fault| opened.failure(fault))?)
            }
            _ => None,
        };
        let mut inspection = self.options.inspect(opened.name(), &opened.model, factors.as_ref());
        self.add_comparison(&opened.model, &mut inspection);
        if let Some(kg) = self.target_mass_kg {
            let size = ModelSize::of(&opened.model, &self.options.masses);
            inspection.similarity = Some(Similarity::at_mass(&size, kg).into());
        }
        Ok(inspection)
    }

    /// Checks a model that was inspected, and tries the remedies. `compiled` names files that other programs would read instead of the
    /// model. `files` has the files that remedies name, and the meshes of feet.
    pub fn check(
        &self,
        model: &Model,
        inspected: &Inspection,
        compiled: Option<&Finding>,
        files: &dyn Files,
    ) -> CheckResult {
        let name = FileName::from_parts(inspected.model.clone(), inspected.model_bytes.clone());
        let mesh = rules::find_odd_mesh(model, &name.to_path(), files);
        let similarity = self.scaled_with_size(model);
        let density = similarity.as_ref().and_then(rules::find_mass_against_length);
        let forms = similarity.as_ref().and_then(|sizes| self.dissipation_forms(model, inspected, sizes));
        let mut beside: Vec<Finding> = [mesh, density, forms].into_iter().flatten().collect();
        // The results of steps have other names, so no compiled file is beside them.
        let of_steps = beside.clone();
        beside.extend(compiled.cloned());
        let result = check_with_trials(&self.options, model, inspected, &beside);
        let inspect = |name: &FileName, model: &Model| {
            let mut inspection = self.options.inspect(name.clone(), model, None);
            self.add_comparison(model, &mut inspection);
            inspection
        };
        let of_reference = match (&self.generic, &self.place_reference) {
            (Some(Ok(generic)), Some(_)) => &generic.codes,
            _ => &NO_CODES,
        };
        let (options, inspect) = (&self.options, &inspect);
        let mut result = RemedyTrials { options, files, inspect, of_reference, beside: &of_steps }
            .with_tried_remedies(model, result);
        result.similarity = similarity;
        if let Some(motion) = &self.motion {
            let (answer, remark, consistency) = motion.answer(&name.to_path(), files);
            result.consistency = consistency;
            result.add_recording(answer, remark);
        }
        result
    }

    /// The remark on dissipation by radius and by mass (14), if the contacts are no longer those of the generic model.
    fn dissipation_forms(&self, model: &Model, inspected: &Inspection, sizes: &SizeList) -> Option<Finding> {
        let Some(Ok(generic)) = &self.generic else { return None };
        inspected.placement.as_ref().filter(|placement| !placement.was_left_behind())?;
        let now = rules::radius_and_dissipation(model)?;
        rules::find_dissipation_forms(sizes, generic.radius_and_dissipation?, now)
    }

    /// The numbers of `model`, besides contacts, that follow its size, compared with the generic model.
    fn scaled_with_size(&self, model: &Model) -> Option<SizeList> {
        let (Some(Ok(generic)), Some(_)) = (&self.generic, &self.place_reference) else { return None };
        let mut size = ModelSize::of(model, &self.options.masses);
        if let Some(setup) = &generic.moco {
            size = size.with_values(moco_bounds(setup, model));
        }
        Some(Similarity::between(&size, &generic.size).into())
    }

    /// Computes the contacts of the model at `path` along the recording that the request names; `None` without a recording, or if it cannot
    /// be computed.
    pub fn recording(&self, path: &Path, files: &dyn Files) -> Option<(MotionResult, Vec<MotionRemark>)> {
        self.motion.as_ref()?.follow(path, files).ok()
    }

    /// Adds to the inspection how the places of spheres and the contacts differ from the generic model, if `check` names one.
    fn add_comparison(&self, model: &Model, inspection: &mut Inspection) {
        let (Some(Ok(generic)), Some((from, scale_file))) = (&self.generic, &self.place_reference) else {
            return;
        };
        if model.loaded_spheres(&model.force_ids()).is_empty() {
            // A model without contacts has a finding of its own.
            return;
        }
        let mass = self.options.masses.model_mass(model).ok().zip(generic.contacts_kg);
        let ratios = mass.and_then(|(mass, contacts_kg)| Ratios::isometric(mass.kg / contacts_kg).ok());
        let radius_ratio = ratios.map(|ratios| ratios.radius());
        let (file, scale_file) = (generic.file.as_ref(), scale_file.as_deref());
        let mut placement =
            SpherePlacements::compare(model, from, scale_file, &generic.anatomy, file, radius_ratio);
        let other_left_behind = generic.codes.contains(&FindingCode::SpheresLeftBehind);
        let alone = || other_left_behind && find_misplaced_spheres(model).is_none();
        let by_signs = || SignsOfScaling::of(model, &self.options.masses).why_exchanged(generic.signs);
        let exchanged = || alone().then_some(CONTACTS_ARE_EXCHANGED).or_else(by_signs);
        let exchanged = placement.was_left_behind().then(exchanged).flatten();
        if let Some(why) = exchanged.map(Phrase::from).or_else(|| generic.fault.clone()) {
            placement = placement.of_wrong_model(why);
        }
        inspection.placement = Some(placement);
        inspection.reference_contacts = Some(generic.contacts.clone());
    }

    /// Refuses a model that has no contacts and no other fault, so that a folder can have such models, which are skipped.
    pub fn refuse_without_contacts(&self, opened: &OpenModel, inspected: &Inspection) -> Result<(), Failure> {
        let has_error = inspected.findings.iter().any(|finding| finding.severity == Severity::Error);
        match self.options.selection.apply(&opened.model) {
            Err(fault) if matches!(fault.kind, FaultKind::NoContacts { .. }) && !has_error => {
                Err(opened.failure(fault))
            }
            _ => Ok(()),
        }
    }
}
