//! Models inspected and checked as a request says.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_inspect::{
    CheckResult, InspectOptions, Inspection, ReferenceContacts, SizeList, unexplained_mass_slip,
};
use osim_model::compare::{Factors, ModelSize, ScaleFile, Similarity, SpherePlacements, moco_bounds};
use osim_model::files::{Failure, FileName, Files, OpenModel};
use osim_model::{Anatomy, Document, Fault, Finding, MassRequest, Model, Severity};
use osim_requests::options::{AnswerOptions, InspectionOptions, SetFiles};
use osim_requests::{CheckRequest, InspectRequest, Kilograms};

use crate::motion::MotionResult;
use crate::motion_remarks::{CheckedMotion, MotionRemark};
use crate::opening::{moco_setup, open, scale_file};
use crate::planner::check_with_trials;
use crate::remedies::Trials;
use crate::rules;

#[derive(Debug)]
pub struct Inspector {
    options: InspectOptions,
    set_files: SetFiles,
    /// The generic model's bones and the Scale Tool's factors, where a generic model is named; why not, where it cannot be
    /// read: that is a failure of each model.
    generic: Option<Result<Generic, Failure>>,
    /// The names of both files, where they are for the places of spheres and not for factors.
    places: Option<OriginalFiles>,
    reads: Vec<PathBuf>,
    /// The mass of a body that is asked about, kg: what else would follow its size is listed.
    target_mass_kg: Option<f64>,
    /// The recording that the contacts are compared with, if one is given.
    motion: Option<CheckedMotion>,
    /// Answers to questions about masses that the caller gave; `None` if the masses were asked about already.
    answers: Option<AnswerOptions>,
}

#[derive(Debug)]
struct Generic {
    anatomy: Anatomy,
    contacts: ReferenceContacts,
    /// The Scale Tool's factors.
    file: Option<ScaleFile>,
    /// How large it is, and what may follow that.
    size: ModelSize,
    /// The Moco setup of the models that are compared with it.
    moco: Option<Document>,
}

/// Names of the files that say where spheres belong.
#[derive(Debug)]
struct OriginalFiles {
    from: PathBuf,
    body_scale_file: Option<PathBuf>,
}

fn generic_model(
    from: &Path,
    body_scale_file: Option<&Path>,
    masses: &MassRequest,
    files: &dyn Files,
) -> Result<Generic, Failure> {
    let generic = open(from, files)?;
    let anatomy = Anatomy::of(&generic.model).map_err(|fault| generic.failure(fault))?;
    let file = body_scale_file.map(|path| scale_file(path, files)).transpose()?;
    let contacts = ReferenceContacts::from_model(&from.display().to_string(), &generic.model);
    // What the caller says of masses is about the scaled model.
    let masses = MassRequest { exclude_bodies: masses.exclude_bodies.clone(), ..MassRequest::default() };
    let size = ModelSize::of(&generic.model, &masses);
    Ok(Generic { anatomy, contacts, file, size, moco: None })
}

/// The generic model that `check` compares with, and the setups of Moco.
fn checked_generic(
    from: &Path,
    request: &CheckRequest,
    masses: &MassRequest,
    files: &dyn Files,
) -> Result<Generic, Failure> {
    let mut generic = generic_model(from, request.body_scale_file.as_deref(), masses, files)?;
    if let Some(path) = &request.moco_setup {
        generic.moco = Some(moco_setup(path, files)?);
    }
    if let Some(path) = &request.from_moco_setup {
        let model = open(from, files)?.model;
        generic.size = generic.size.with_values(moco_bounds(&moco_setup(path, files)?, &model));
    }
    Ok(generic)
}

impl Inspector {
    /// As `inspect` is asked; reads what is needed for all models.
    pub fn of_inspect(request: &InspectRequest, files: &dyn Files) -> Self {
        let plain = Self::asking(&request.options);
        let read = |from: &Path| {
            generic_model(from, request.body_scale_file.as_deref(), &plain.options.masses, files)
        };
        let named = request.from.iter().chain(&request.body_scale_file).cloned();
        let reads = request.options.set_files.paths().cloned().chain(named).collect();
        let target_mass_kg = request.target_mass.map(Kilograms::get);
        Self { generic: request.from.as_deref().map(read), reads, target_mass_kg, ..plain }
    }

    /// As `check` is asked; reads what is needed for all models.
    pub fn of_check(request: &CheckRequest, files: &dyn Files) -> Self {
        let plain = Self { motion: CheckedMotion::of(request), ..Self::asking(&request.options) };
        let Some(from) = request.from.clone() else { return plain };
        let file = request.body_scale_file.clone();
        let generic = Some(checked_generic(&from, request, &plain.options.masses, files));
        let setups = request.moco_setup.iter().chain(&request.from_moco_setup);
        let reads = plain.reads.iter().chain([&from]).chain(&file).chain(setups).cloned().collect();
        Self { generic, places: Some(OriginalFiles { from, body_scale_file: file }), reads, ..plain }
    }

    /// Inspects by these options, without a generic model.
    pub fn new(options: &InspectionOptions) -> Self {
        Self {
            options: InspectOptions::from(options),
            set_files: options.set_files.clone(),
            generic: None,
            places: None,
            reads: options.set_files.paths().cloned().collect(),
            target_mass_kg: None,
            motion: None,
            answers: None,
        }
    }

    /// An inspector that asks if a mass that the caller gave looks like a slip.
    fn asking(options: &InspectionOptions) -> Self {
        Self { answers: Some(options.answers.clone()), ..Self::new(options) }
    }

    /// Why the generic model cannot be used, where one is named and cannot.
    pub fn generic_failure(&self) -> Option<&Failure> {
        self.generic.as_ref()?.as_ref().err()
    }

    pub fn options(&self) -> &InspectOptions {
        &self.options
    }

    pub fn set_files(&self) -> &SetFiles {
        &self.set_files
    }

    /// Files that are read beside the models.
    pub fn reads(&self) -> &[PathBuf] {
        &self.reads
    }

    /// Everything about a model.
    ///
    /// # Errors
    /// The generic model cannot be read, factors cannot be determined, or a mass that the caller gave looks like a slip.
    pub fn inspect(&self, opened: &OpenModel) -> Result<Inspection, Failure> {
        if let Some(answers) = &self.answers {
            let options = &self.options;
            let asked =
                answers.ask(unexplained_mass_slip(&options.masses, &opened.model, &options.selection));
            asked.map_err(|kind| opened.failure(Fault::new(kind)))?;
        }
        let generic = self.generic.as_ref().map(Result::as_ref).transpose().map_err(Failure::clone)?;
        let factors = match (generic, &self.places) {
            (Some(Generic { anatomy, file, .. }), None) => {
                let scaled = Anatomy::of(&opened.model).map_err(|fault| opened.failure(fault))?;
                let found = Factors::find(&scaled, anatomy, file.as_ref(), &BTreeMap::new());
                Some(found.map_err(|fault| opened.failure(fault))?)
            }
            _ => None,
        };
        let mut inspection = self.options.inspect(opened.name(), &opened.model, factors.as_ref());
        self.compare(&opened.model, &mut inspection);
        if let Some(kg) = self.target_mass_kg {
            let size = ModelSize::of(&opened.model, &self.options.masses);
            inspection.similarity = Some(Similarity::at_mass(&size, kg).into());
        }
        Ok(inspection)
    }

    /// What is wrong with a model that was inspected, with remedies that were tried; `compiled` names files that other programs would
    /// read instead of it. `files` has those that remedies name, and the meshes of feet.
    pub fn check(
        &self,
        model: &Model,
        inspected: &Inspection,
        compiled: Option<&Finding>,
        files: &dyn Files,
    ) -> CheckResult {
        let name = FileName::from_parts(inspected.model.clone(), inspected.model_bytes.clone());
        let mesh = rules::find_odd_mesh(model, &name.to_path(), files);
        let beside: Vec<Finding> = compiled.cloned().into_iter().chain(mesh).collect();
        let found = check_with_trials(&self.options, model, inspected, &beside);
        let inspect = |name: &FileName, model: &Model| self.inspect_again(name, model);
        let mut found = Trials { options: &self.options, files, inspect: &inspect }.tried(model, found);
        found.similarity = self.similarity(model);
        found.verdicts.extend(self.motion.as_ref().map(|motion| motion.verdict(&name.to_path(), files)));
        found
    }

    /// What else of `model` follows its size, where it is compared with the model that was scaled.
    fn similarity(&self, model: &Model) -> Option<SizeList> {
        let (Some(Ok(generic)), Some(_)) = (&self.generic, &self.places) else { return None };
        let mut size = ModelSize::of(model, &self.options.masses);
        if let Some(setup) = &generic.moco {
            size = size.with_values(moco_bounds(setup, model));
        }
        Some(Similarity::between(&size, &generic.size).into())
    }

    /// What the contacts of the model at `path` do along the recording, where one was named and can be followed.
    pub fn recording(&self, path: &Path, files: &dyn Files) -> Option<(MotionResult, Vec<MotionRemark>)> {
        self.motion.as_ref()?.followed(path, files).ok()
    }

    /// A model that a remedy made, inspected like the first.
    fn inspect_again(&self, name: &FileName, model: &Model) -> Inspection {
        let mut inspection = self.options.inspect(name.clone(), model, None);
        self.compare(model, &mut inspection);
        inspection
    }

    /// Adds the places of the spheres compared with those in the generic model, and its contacts, where one is named for that.
    fn compare(&self, model: &Model, inspection: &mut Inspection) {
        let (Some(Ok(generic)), Some(files)) = (&self.generic, &self.places) else { return };
        let (from, scale_file) = (&files.from, files.body_scale_file.as_deref());
        let placement =
            SpherePlacements::compare(model, from, scale_file, &generic.anatomy, generic.file.as_ref());
        inspection.placement = Some(placement);
        inspection.reference_contacts = Some(generic.contacts.clone());
    }

    /// Refuses a model that has no contacts and nothing else that is wrong with it, so that one in a folder is skipped.
    pub fn refuse_without_contacts(&self, opened: &OpenModel, inspected: &Inspection) -> Result<(), Failure> {
        match self.options.selection.apply(&opened.model) {
            Err(fault)
                if fault.code() == "no-contacts"
                    && !inspected.warnings.iter().any(|warning| warning.severity == Severity::Error) =>
            {
                Err(opened.failure(fault))
            }
            _ => Ok(()),
        }
    }
}
