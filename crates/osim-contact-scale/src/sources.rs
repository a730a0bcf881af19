//! Which models a call is about: files, folders and standard input.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use walkdir::WalkDir;

use crate::failure::Failure;
use crate::paths::resolved;

/// End of the name of files that this tool writes by default.
pub(crate) const OUTPUT_MARK: &str = ".scaled";

/// One model to read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Source {
    /// Where it is; `-` is standard input.
    pub path: PathBuf,
    /// The folder that was named, when the model was found by walking it.
    pub folder: Option<PathBuf>,
}

impl Source {
    pub(crate) fn is_stdin(&self) -> bool {
        self.path.as_os_str() == "-"
    }

    /// As shown to the user.
    pub(crate) fn shown(&self) -> String {
        self.path.display().to_string()
    }
}

/// What was named on the command line, with folders walked.
#[derive(Debug, Default)]
pub(crate) struct Sources {
    pub models: Vec<Source>,
    pub failures: Vec<Failure>,
    /// Things to say aloud: what was passed over.
    pub remarks: Vec<String>,
}

impl Sources {
    /// Expands `named`; `skip` is the output folder, which is never walked.
    pub(crate) fn find(named: &[PathBuf], skip: Option<&Path>) -> Self {
        let mut sources = Self::default();
        for path in named {
            if path.is_dir() {
                sources.walk(path, skip);
            } else if !sources.models.iter().any(|known| same(&known.path, path)) {
                sources.models.push(Source { path: path.clone(), folder: None });
            }
        }
        sources
    }

    fn walk(&mut self, folder: &Path, skip: Option<&Path>) {
        let skip = skip.and_then(|path| path.canonicalize().ok());
        let is_skipped = |path: &Path| skip.is_some() && path.canonicalize().ok() == skip;
        let mut own = 0;
        let before = self.models.len();
        let walk = WalkDir::new(folder).sort_by_file_name().into_iter();
        for entry in walk.filter_entry(|entry| !(entry.file_type().is_dir() && is_skipped(entry.path()))) {
            let entry = match entry {
                Ok(entry) => entry,
                Err(error) => {
                    let path = error.path().unwrap_or(folder).display().to_string();
                    self.failures.push(Failure::outside(&path, "unreadable", &anyhow!(error)));
                    continue;
                }
            };
            let path = entry.path();
            let is_model = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("osim"));
            if !is_model || entry.file_type().is_dir() {
                continue;
            }
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            if stem.ends_with(OUTPUT_MARK) {
                own += 1;
                continue;
            }
            self.models.push(Source { path: path.to_owned(), folder: Some(folder.to_owned()) });
        }
        if let Some(skipped) = skip.as_ref().filter(|skipped| skipped.starts_with(resolved(folder))) {
            self.remarks.push(format!("{}: the output folder is not read", skipped.display()));
        }
        if own > 0 {
            let shown = folder.display();
            self.remarks
                .push(format!("{shown}: outputs of this tool (*{OUTPUT_MARK}.osim) passed over: {own}"));
        }
        if self.models.len() == before {
            let error =
                anyhow!("no .osim models in this folder: name a model, or the folder that holds them");
            self.failures.push(Failure::outside(&folder.display().to_string(), "no-models", &error));
        }
    }
}

/// One model named twice is one model.
fn same(a: &Path, b: &Path) -> bool {
    a == b || (a.as_os_str() != "-" && b.as_os_str() != "-" && resolved(a) == resolved(b))
}

/// Reads a whole file, or standard input.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        std::io::Read::read_to_end(&mut std::io::stdin().lock(), &mut bytes)
            .context("cannot read standard input")?;
        return Ok(bytes);
    }
    match std::fs::read(path) {
        Ok(bytes) => Ok(bytes),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            Err(anyhow!("there is no such file: check the name and the folder"))
        }
        Err(error) => Err(anyhow!(error).context("cannot be read")),
    }
}
