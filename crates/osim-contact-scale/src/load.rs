//! A model with all the files that belong to it.

use std::fs::{File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use anyhow::{Context, Result, anyhow, bail};
use osim_patch::{Document, ElementId, Model, Part};

use crate::args::PartArgs;
use crate::digest::sha256;
use crate::failure::Failure;
use crate::paths::folder_of;
use crate::sources::Source;

/// Bytes of a model's files; documents and models borrow from it.
pub(crate) struct Loaded {
    pub shown: String,
    pub bytes: Vec<u8>,
    /// The model as the file system saw it when it was read; none for standard input.
    pub stamp: Option<Stamp>,
    pub parts: Vec<LoadedPart>,
}

#[derive(Clone)]
pub(crate) struct LoadedPart {
    pub path: PathBuf,
    bytes: Vec<u8>,
    stamp: Option<Stamp>,
    included_by: Option<ElementId>,
    /// As the model names it in `file="..."`.
    named: Option<String>,
}

impl Loaded {
    /// Reads `source`, the files it includes and those given beside it.
    pub(crate) fn read(source: &Source, beside: &PartArgs) -> Result<Self, Failure> {
        let shown = source.shown();
        let (bytes, stamp) =
            read_stamped(&source.path).map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
        let mut parts = Vec::new();
        for path in [&beside.geometry, &beside.model].into_iter().flatten() {
            parts.push(Self::part(path.clone(), None)?);
        }
        if !osim_patch::may_include(&bytes) {
            return Ok(Self { shown, bytes, stamp, parts });
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
            parts.push(LoadedPart { named: Some(file), ..part });
        }
        drop(document);
        Ok(Self { shown, bytes, stamp, parts })
    }

    /// Refuses to write the model where OpenSim would not find the files that it includes.
    ///
    /// # Errors
    /// The first that is not there.
    pub(crate) fn find_included_from(&self, output: &Path) -> Result<()> {
        for file in self.parts.iter().filter_map(|part| part.named.as_deref()) {
            if !folder_of(output).join(file).is_file() {
                bail!(
                    "the model includes file=\"{file}\", which is not in {}: copy it there first, or write beside the model",
                    folder_of(output).display()
                );
            }
        }
        Ok(())
    }

    /// The same model with other bytes of its own; included files stay.
    pub(crate) fn with_bytes(&self, bytes: Vec<u8>) -> Self {
        Self { shown: self.shown.clone(), bytes, stamp: self.stamp.clone(), parts: self.parts.clone() }
    }

    /// Gives file number `file`, one that belongs to the model, other bytes.
    pub(crate) fn replace_part(&mut self, file: usize, bytes: Vec<u8>) {
        if let Some(part) = file.checked_sub(1).and_then(|part| self.parts.get_mut(part)) {
            part.bytes = bytes;
        }
    }

    fn part(path: PathBuf, included_by: Option<ElementId>) -> Result<LoadedPart, Failure> {
        let shown = path.display().to_string();
        let (bytes, stamp) = read_stamped(&path)
            .with_context(|| "a file that belongs to the model".to_owned())
            .map_err(|error| Failure::outside(&shown, "unreadable", &error))?;
        Ok(LoadedPart { path, bytes, stamp, included_by, named: None })
    }

    /// Bytes of file number `file`.
    pub(crate) fn file(&self, file: usize) -> (&str, &[u8]) {
        match file.checked_sub(1).and_then(|part| self.parts.get(part)) {
            Some(part) => (part.path.to_str().unwrap_or(&self.shown), &part.bytes),
            None => (&self.shown, &self.bytes),
        }
    }

    /// All files by name, the model first, with the SHA-256 of each.
    pub(crate) fn digests(&self) -> Vec<(String, String)> {
        let file = |file| {
            let (name, bytes) = self.file(file);
            (name.to_owned(), sha256(bytes))
        };
        (0..=self.parts.len()).map(file).collect()
    }

    /// File number `file` as it was when it was read.
    pub(crate) fn stamp_of(&self, file: usize) -> Option<&Stamp> {
        match file.checked_sub(1) {
            Some(part) => self.parts.get(part)?.stamp.as_ref(),
            None => self.stamp.as_ref(),
        }
    }

    /// Parses all files, reads the model and hands it to `then`.
    pub(crate) fn with_model<T>(
        &self,
        then: impl FnOnce(&Model) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let document = self.parse(0)?;
        let mut documents = Vec::new();
        for index in 0..self.parts.len() {
            documents.push(self.parse(index + 1)?);
        }
        let parts: Vec<Part> = documents
            .iter()
            .zip(&self.parts)
            .map(|(document, part)| Part { document, included_by: part.included_by })
            .collect();
        let model = Model::read_with(&document, &parts).map_err(|fault| self.failure(fault))?;
        then(&model)
    }

    fn parse(&self, file: usize) -> Result<Document, Failure> {
        let (shown, bytes) = self.file(file);
        Document::parse(bytes).map_err(|fault| Failure::of_fault(shown, fault, bytes))
    }

    /// A fault, shown in the file it is about.
    pub(crate) fn failure(&self, fault: osim_patch::Fault) -> Failure {
        let (shown, bytes) = self.file(fault.source_file);
        Failure::of_fault(shown, fault, bytes)
    }
}

/// A file's metadata at a moment, to notice that somebody else writes it.
#[derive(Debug, Clone)]
pub(crate) struct Stamp {
    pub metadata: Metadata,
    modified: Option<SystemTime>,
}

impl Stamp {
    fn of(metadata: Metadata) -> Self {
        let modified = metadata.modified().ok();
        Self { metadata, modified }
    }

    /// Refuses a file that is no longer as it was read.
    ///
    /// # Errors
    /// It was changed or removed since.
    pub(crate) fn still_holds(&self, path: &Path) -> Result<()> {
        let gone = || format!("{} is no longer there, so nothing was written", path.display());
        let now = std::fs::metadata(path).with_context(gone)?;
        if now.len() != self.metadata.len() || now.modified().ok() != self.modified {
            bail!(
                "another program changed {} while it was being worked on, so nothing was written: run again",
                path.display()
            );
        }
        Ok(())
    }
}

/// Reads a whole file, or standard input.
///
/// # Errors
/// It is not there, cannot be read, or changes while it is being read.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    read_stamped(path).map(|(bytes, _)| bytes)
}

fn read_stamped(path: &Path) -> Result<(Vec<u8>, Option<Stamp>)> {
    let mut bytes = Vec::new();
    if path.as_os_str() == "-" {
        std::io::stdin().lock().read_to_end(&mut bytes).context("cannot read standard input")?;
        return Ok((bytes, None));
    }
    let mut file = File::open(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => anyhow!("there is no such file: check the name and the folder"),
        _ => anyhow!(error).context("cannot be read"),
    })?;
    let stamp = Stamp::of(file.metadata().context("cannot be read")?);
    let length = usize::try_from(stamp.metadata.len()).unwrap_or(0);
    bytes.try_reserve_exact(length).context("cannot be read: too large for this computer's memory")?;
    file.read_to_end(&mut bytes).context("cannot be read")?;
    let after = file.metadata().context("cannot be read")?;
    let changed = after.modified().ok() != stamp.modified || bytes.len() as u64 != after.len();
    if changed && after.is_file() {
        bail!("another program changed it while it was being read: run again when that is done");
    }
    Ok((bytes, Some(stamp)))
}
