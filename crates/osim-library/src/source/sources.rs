//! Which models a call is about: files, folders and standard input; and names with blanks that came without quotes.

use std::collections::HashSet;
use std::ffi::OsString;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_model::files::Failure;
use osim_requests::options::OutputOptions;
use walkdir::{DirEntry, WalkDir};

use crate::digest::{self, NameDigest};
use crate::file_access;
use crate::paths::{Resolver, resolved};

/// End of the name of the folder that variants are written into by default. Walks over folders leave it out.
pub(crate) const FOLDER_MARK: &str = ".sweep";

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Where it is; `-` is standard input.
    pub path: PathBuf,
    /// The folder that was named, when the model was found by walking it.
    pub folder: Option<Arc<Path>>,
    /// Whether the user gave this very name: then it may be a pipe. Names in folders and tables are those of ordinary files.
    pub named: bool,
}

impl Source {
    /// A model that was named itself.
    pub fn file(path: &Path) -> Self {
        Self { path: path.to_owned(), folder: None, named: true }
    }

    /// A model that a table names.
    pub(crate) fn in_table(path: &Path) -> Self {
        Self { named: false, ..Self::file(path) }
    }

    /// Whether the model is skipped because it has no contacts: a folder may hold such models; one that was named may not be such.
    pub(crate) fn is_skipped(&self, failure: &Failure) -> bool {
        failure.code == "no-contacts" && self.folder.is_some()
    }

    /// Whether it is standard input.
    pub fn is_stdin(&self) -> bool {
        self.path.as_os_str() == "-"
    }

    pub fn shown(&self) -> String {
        self.path.display().to_string()
    }

    /// Its name, or its path below the folder that was named.
    pub(crate) fn below_folder(&self) -> &Path {
        let below = self.folder.as_ref().and_then(|folder| self.path.strip_prefix(folder).ok());
        below.or_else(|| self.path.file_name().map(Path::new)).unwrap_or(&self.path)
    }
}

/// What was named, with folders walked.
#[derive(Debug, Default)]
pub struct Sources {
    pub models: Vec<Source>,
    /// What could not even be listed.
    pub failures: Vec<Failure>,
    /// Things to report: what was skipped.
    pub remarks: Vec<String>,
}

impl Sources {
    /// Expands `named`; `skip` is the output folder, which is never walked.
    pub fn find(named: &[PathBuf], skip: Option<&Path>) -> Self {
        let mut sources = Self::default();
        let mut known = Known::default();
        let mut next = 0;
        for (index, path) in named.iter().enumerate() {
            if index < next {
                continue;
            }
            if let Some(split) = SplitName::at(named, index) {
                // One name that was split is one failure.
                next = split.words.end;
                sources.failures.push(Failure::outside(path.as_path(), "unreadable", split.reason()));
            } else if path.is_dir() {
                sources.walk(path, skip, &mut known);
            } else if known.is_new(path) {
                sources.models.push(Source::file(path));
            }
        }
        sources
    }

    fn walk(&mut self, folder: &Path, skip: Option<&Path>, known: &mut Known) {
        let skip = skip.and_then(|path| path.canonicalize().ok());
        let is_skipped = |path: &Path| skip.is_some() && path.canonicalize().ok() == skip;
        let (mut own, mut again, mut sweeps) = (0, 0, 0);
        let mut found = false;
        let shared: Arc<Path> = Arc::from(folder);
        // Links are followed, as a file manager does; a link that leads back into its own folder is a failure.
        let walk = WalkDir::new(folder).follow_links(true).sort_by_file_name().into_iter();
        let enters = |entry: &DirEntry| {
            let is_sweep = entry.depth() > 0 && entry.file_type().is_dir() && is_sweep(entry.path());
            sweeps += usize::from(is_sweep);
            let skipped = is_sweep || (entry.file_type().is_dir() && is_skipped(entry.path()));
            !skipped
        };
        for entry in walk.filter_entry(enters) {
            match entry {
                Err(error) if is_dead_link_beside_models(&error) => {}
                Err(error) => self.failures.push(unreadable(folder, &error)),
                Ok(entry) if !is_model_entry(&entry) => {}
                // A pipe would never end, or never begin.
                Ok(entry) if !entry.file_type().is_file() => {
                    found = true;
                    let why = "this is not an ordinary file, and is read only where it is named itself";
                    self.failures.push(Failure::outside(entry.path(), "unreadable", why));
                }
                Ok(entry) if is_own_output(entry.path()) => own += 1,
                Ok(entry) => {
                    found = true;
                    if known.is_new(entry.path()) {
                        let folder = Some(Arc::clone(&shared));
                        self.models.push(Source { path: entry.into_path(), folder, named: false });
                    } else {
                        again += 1;
                    }
                }
            }
        }
        if let Some(skipped) = skip.as_ref().filter(|skipped| skipped.starts_with(resolved(folder))) {
            self.remarks.push(format!("{}: the output folder is not read", skipped.display()));
        }
        let shown = folder.display();
        if own > 0 {
            self.remarks.push(format!(
                "{shown}: outputs of this tool (*{}.osim) skipped: {own}",
                OutputOptions::MARK
            ));
        }
        if sweeps > 0 {
            self.remarks.push(format!("{shown}: folders of sweeps (*{FOLDER_MARK}) skipped: {sweeps}"));
        }
        if again > 0 {
            self.remarks
                .push(format!("{shown}: models that are there a second time (named or linked): {again}"));
        }
        if !found {
            let why = "no .osim models in this folder: name a model, or the folder that holds them";
            self.failures.push(Failure::outside(folder, "no-models", why));
        }
    }
}

fn is_model_entry(entry: &DirEntry) -> bool {
    has_name_of_model(entry.path()) && !entry.file_type().is_dir()
}

fn has_name_of_model(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("osim"))
}

/// Whether it is a link that leads nowhere and, by its name, never led to a model or a folder.
fn is_dead_link_beside_models(error: &walkdir::Error) -> bool {
    let path = error.path().filter(|path| path.extension().is_some() && !has_name_of_model(path));
    error.loop_ancestor().is_none() && path.is_some_and(is_dead_link)
}

fn is_dead_link(path: &Path) -> bool {
    path.is_symlink() && !path.exists()
}

fn is_own_output(path: &Path) -> bool {
    path.file_stem().unwrap_or_default().as_encoded_bytes().ends_with(OutputOptions::MARK.as_bytes())
}

fn is_sweep(folder: &Path) -> bool {
    folder.file_name().unwrap_or_default().as_encoded_bytes().ends_with(FOLDER_MARK.as_bytes())
}

fn unreadable(folder: &Path, error: &walkdir::Error) -> Failure {
    let path = error.path().unwrap_or(folder);
    let reason = match (error.loop_ancestor(), error.io_error()) {
        (Some(ancestor), _) => format!(
            "a link that leads back to {}: remove the link, or name the folders that hold the models",
            ancestor.display()
        ),
        _ if is_dead_link(path) => {
            "a link that leads nowhere: remove it, or bring back what it leads to".to_owned()
        }
        // Without the path, which is before it.
        (None, Some(error)) => format!("cannot be read: {}", file_access::reason(error)),
        (None, None) => "cannot be read".to_owned(),
    };
    Failure::outside(path, "unreadable", reason)
}

/// One model named twice, or linked, is one model.
#[derive(Debug, Default)]
struct Known {
    resolver: Resolver,
    files: HashSet<NameDigest>,
}

impl Known {
    fn is_new(&mut self, path: &Path) -> bool {
        let real = if path.as_os_str() == "-" { path.to_owned() } else { self.resolver.resolved(path) };
        self.files.insert(digest::digest_of_name(real.as_os_str()))
    }
}

/// More words than this are not one name.
const MOST_WORDS: usize = 12;

/// Words that are one name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SplitName {
    pub words: Range<usize>,
    /// The name that they make with blanks between them.
    pub name: PathBuf,
    pub exists: bool,
}

impl SplitName {
    /// The first run of words that are files only together, or look like one: the last is the first with the ending of a model.
    pub fn find(words: &[PathBuf]) -> Option<Self> {
        (0..words.len()).find_map(|start| Self::at(words, start))
    }

    /// A name that begins with word `start`.
    pub(super) fn at(words: &[PathBuf], start: usize) -> Option<Self> {
        let rest = words.get(start..)?;
        let parts =
            rest.iter().skip(1).take_while(|word| word.as_os_str() != "-").take(MOST_WORDS).count() + 1;
        let mut name =
            rest.first().filter(|word| !word.exists() && !has_name_of_model(word))?.as_os_str().to_owned();
        let mut likely = None;
        let mut are_parts = true;
        for end in 1..parts {
            let word = rest.get(end)?;
            name = joined(name, word);
            let path = PathBuf::from(&name);
            let exists = path.exists();
            // What is there by itself is a part only of what is there as a whole.
            are_parts = are_parts && !word.exists();
            let found = Self { words: start..start + end + 1, name: path, exists };
            if exists {
                return Some(found);
            }
            likely = likely.or_else(|| (are_parts && has_name_of_model(&found.name)).then_some(found));
        }
        likely
    }

    /// What is wrong, and what to write.
    pub fn message(&self, first: &Path) -> String {
        format!("'{}' is {}", first.display(), self.reason())
    }

    pub fn reason(&self) -> String {
        let name = self.name.display();
        let there = if self.exists { format!(", but '{name}' is") } else { String::new() };
        format!("not there{there}: a name with a blank needs quotes, \"{name}\"")
    }
}

fn joined(mut name: OsString, word: &Path) -> OsString {
    name.push(" ");
    name.push(word);
    name
}
