//! A model with all the files that belong to it.

use std::path::{Path, PathBuf};

use anyhow::Context;
use osim_patch::{Document, ElementId, Model, Part};

use crate::args::PartArgs;
use crate::failure::Failure;
use crate::sources::{Source, read};

/// Bytes of a model's files; documents and models borrow from it.
pub(crate) struct Loaded {
    pub shown: String,
    pub bytes: Vec<u8>,
    pub parts: Vec<LoadedPart>,
}

pub(crate) struct LoadedPart {
    pub path: PathBuf,
    bytes: Vec<u8>,
    included_by: Option<ElementId>,
}

impl Loaded {
    /// Reads `source`, the files it includes and those given beside it.
    pub(crate) fn read(source: &Source, beside: &PartArgs) -> Result<Self, Failure> {
        let shown = source.shown();
        let bytes = read(&source.path).map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
        let mut parts = Vec::new();
        for path in [&beside.geometry, &beside.model].into_iter().flatten() {
            parts.push(Self::part(path.clone(), None)?);
        }
        if !osim_patch::may_include(&bytes) {
            return Ok(Self { shown, bytes, parts });
        }
        let document = Document::parse(&bytes).map_err(|fault| Failure::of_fault(&shown, fault, &bytes))?;
        for (element, file) in document.included_files() {
            let folder = source.path.parent().unwrap_or(Path::new(""));
            let path = folder.join(&file);
            let part = Self::part(path, Some(element)).map_err(|failure| Failure {
                // The place in the model is what the user can mend.
                model: shown.clone(),
                line: Some(document.line(document.tree().span(element).start)),
                column: Some(document.position(document.tree().span(element).start).column),
                message: format!("it includes file=\"{file}\", and {}: {}", failure.model, failure.message),
                ..failure
            })?;
            parts.push(part);
        }
        drop(document);
        Ok(Self { shown, bytes, parts })
    }

    fn part(path: PathBuf, included_by: Option<ElementId>) -> Result<LoadedPart, Failure> {
        let shown = path.display().to_string();
        let bytes = read(&path)
            .with_context(|| "a file that belongs to the model".to_owned())
            .map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
        Ok(LoadedPart { path, bytes, included_by })
    }

    /// Bytes of file number `file`.
    pub(crate) fn file(&self, file: usize) -> (&str, &[u8]) {
        match file.checked_sub(1).and_then(|part| self.parts.get(part)) {
            Some(part) => (part.path.to_str().unwrap_or(&self.shown), &part.bytes),
            None => (&self.shown, &self.bytes),
        }
    }

    /// Parses all files, reads the model and hands it to `then`.
    pub(crate) fn with_model<T>(
        &self,
        then: impl FnOnce(&Model<'_, '_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let document = self.parse(0)?;
        let mut documents = Vec::new();
        for index in 0..self.parts.len() {
            documents.push(self.parse(index + 1)?);
        }
        let parts: Vec<Part<'_, '_>> = documents
            .iter()
            .zip(&self.parts)
            .map(|(document, part)| Part { document, included_by: part.included_by })
            .collect();
        let model = Model::read_with(&document, &parts).map_err(|fault| self.failure(fault))?;
        then(&model)
    }

    fn parse(&self, file: usize) -> Result<Document<'_>, Failure> {
        let (shown, bytes) = self.file(file);
        Document::parse(bytes).map_err(|fault| Failure::of_fault(shown, fault, bytes))
    }

    /// A fault, shown in the file it is about.
    pub(crate) fn failure(&self, fault: osim_patch::Fault) -> Failure {
        let (shown, bytes) = self.file(fault.source_file);
        Failure::of_fault(shown, fault, bytes)
    }
}
