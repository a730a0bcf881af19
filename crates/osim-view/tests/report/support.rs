//! Helpers that read, inspect and plan models of the fixtures.

use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, InspectOptions, Inspection};
use osim_model::files::{CompanionPaths, FileError, Files, ModelFiles, OpenModel};
use osim_model::{MassRequest, Model};
use osim_patch::{Plan, Rescale, rescale};
use osim_planning::check_with_remedies;
use osim_requests::spell::FrontEnd;

struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        std::fs::read(path).map_err(|error| FileError::new(error.to_string()))
    }

    fn exists(&self, path: &Path) -> bool {
        path.exists()
    }
}

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(name)
}

/// Opens the model `name` of the fixtures under this name.
pub(crate) fn open(name: &str) -> OpenModel {
    let path = fixture(name);
    let bytes = std::fs::read(&path).unwrap();
    let files = ModelFiles::read(&path, bytes, CompanionPaths::default(), &Disk).unwrap();
    files.with_name(name.to_owned()).open().unwrap()
}

pub(crate) fn inspected(
    options: &InspectOptions,
    model: &OpenModel,
    front_end: &dyn FrontEnd,
) -> (Inspection, CheckResult) {
    let mut inspected = options.inspect(model.name(), &model.model, None);
    let mut found = check_with_remedies(options, &model.model, &inspected, &[]);
    inspected.spell(front_end);
    found.spell(front_end);
    (inspected, found)
}

/// The plan that scales the contacts of `model` to a body of `target_mass_kg`.
pub(crate) fn rescaled(model: &Model, target_mass_kg: f64, front_end: &dyn FrontEnd) -> Plan {
    let options = InspectOptions::default();
    let selected = options.selection.apply(model).unwrap();
    let (mass, _) = MassRequest::default().contacts_mass(model).unwrap();
    let mut plan = rescale(model, &selected, &Rescale::new(target_mass_kg, mass)).unwrap();
    plan.spell(front_end);
    plan
}
