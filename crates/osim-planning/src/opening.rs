//! Files that a request names, opened through whatever holds them.

use std::path::Path;

use osim_model::compare::{ScaleFile, refuse_without_moco_phase};
use osim_model::files::{Beside, Failure, FileError, Files, ModelFiles, OpenModel};
use osim_model::{Document, FileId};

/// Opens a model that stands alone.
///
/// # Errors
/// It cannot be read.
pub(crate) fn open(path: &Path, files: &dyn Files) -> Result<OpenModel, Failure> {
    open_with(path, Beside::default(), files)
}

/// Opens a model with the files that are given beside it.
///
/// # Errors
/// It cannot be read.
pub fn open_with(path: &Path, beside: Beside<'_>, files: &dyn Files) -> Result<OpenModel, Failure> {
    let bytes = read(path, files)?;
    ModelFiles::read(path, bytes, beside, files)?.open()
}

pub(crate) fn read(path: &Path, files: &dyn Files) -> Result<Vec<u8>, Failure> {
    let failed = |error: FileError| Failure::outside(path, "unreadable", error.to_string());
    files.read(path).map_err(failed)
}

/// Reads the Scale Tool's applied factors.
///
/// # Errors
/// The file cannot be read, or is not a ScaleSet.
pub fn scale_file(path: &Path, files: &dyn Files) -> Result<ScaleFile, Failure> {
    let bytes = read(path, files)?;
    let document = Document::parse(bytes).map_err(|fault| Failure::of_fault(path, fault))?;
    ScaleFile::read(&document)
        .map_err(|fault| Failure::of_fault(path, fault.in_file(FileId::MAIN).located(document.bytes())))
}

/// Reads a setup of Moco.
///
/// # Errors
/// The file cannot be read, or has no problem of Moco in it.
pub(crate) fn moco_setup(path: &Path, files: &dyn Files) -> Result<Document, Failure> {
    let bytes = read(path, files)?;
    let document = Document::parse(bytes).map_err(|fault| Failure::of_fault(path, fault))?;
    let problem = refuse_without_moco_phase(&document);
    problem.map_err(|fault| Failure::of_fault(path, fault.in_file(FileId::MAIN)))?;
    Ok(document)
}
