//! Finds the models that a call names: files, folders and standard input. Recognises file names with blanks without quotes.

use std::collections::HashSet;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_model::files::Failure;
use osim_model::messages::{Input, phrase};
use osim_requests::options::OutputOptions;
use walkdir::{DirEntry, WalkDir};

use crate::file_access::{self, NameDigest, digest_of_name};
use crate::paths::{Resolver, resolved};

/// Default ending of the name of a folder with the variants of a sweep. Folders with this ending are not searched for models.
pub(crate) const SWEEP_FOLDER_ENDING: &str = ".sweep";

/// The path of one model, and how the user named it: itself, by its folder, or in a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelSource {
    /// The path of the model; `-` is standard input.
    pub path: PathBuf,
    /// The folder that the user named, if the model was found in it.
    pub folder: Option<Arc<Path>>,
    /// Whether the user named the model itself. Then the model may be a pipe; models in folders and tables have to be ordinary files.
    pub named: bool,
}

impl ModelSource {
    /// The source of a model whose path the user typed.
    pub fn file(path: &Path) -> Self {
        Self { path: path.to_owned(), folder: None, named: true }
    }

    /// Whether the model was found in a folder and failed only because it has no contacts. Such models are skipped.
    pub(crate) fn is_skipped(&self, failure: &Failure) -> bool {
        failure.code == "no-contacts" && self.folder.is_some()
    }

    /// Whether the model comes from standard input.
    pub fn is_stdin(&self) -> bool {
        self.path.as_os_str() == "-"
    }

    pub fn shown(&self) -> String {
        self.path.display().to_string()
    }

    /// The path below the folder that the user named, else the file's name.
    pub(crate) fn below_folder(&self) -> &Path {
        let below = self.folder.as_ref().and_then(|folder| self.path.strip_prefix(folder).ok());
        below.or_else(|| self.path.file_name().map(Path::new)).unwrap_or(&self.path)
    }
}

/// The models that a call names, including the models in folders that it names.
#[derive(Debug, Default)]
pub struct Sources {
    pub models: Vec<ModelSource>,
    /// Files and folders that cannot be listed.
    pub failures: Vec<Failure>,
    pub remarks: Vec<String>,
}

impl Sources {
    /// Finds the models among the files and in the folders that are `named`. The output folder `skip` is not searched.
    pub fn find(named: &[PathBuf], skip: Option<&Path>) -> Self {
        let mut sources = Self::default();
        let mut seen = SeenModels::default();
        let mut next = 0;
        for (index, path) in named.iter().enumerate() {
            if index < next {
                continue;
            }
            if let Some(split) = SplitName::beginning_at(named, index) {
                // The words of one name are one failure.
                next = split.words.end;
                sources.failures.push(Failure::outside(path.as_path(), "unreadable", split.reason()));
            } else if path.is_dir() {
                sources.search_folder(path, skip, &mut seen);
            } else if seen.insert(path) {
                sources.models.push(ModelSource::file(path));
            }
        }
        sources
    }

    /// Adds the models in a folder and below it, in the order of their names.
    fn search_folder(&mut self, folder: &Path, skip: Option<&Path>, seen: &mut SeenModels) {
        let skip = skip.and_then(|path| path.canonicalize().ok());
        if skip.is_some() && folder.canonicalize().ok() == skip {
            let other = Input::OutputDir.with_placeholder("DIR");
            let why = phrase!["results would be written over its models: name another folder with ", other];
            self.failures.push(Failure::outside(folder, "no-models", why));
            return;
        }
        let is_skipped = |path: &Path| skip.is_some() && path.canonicalize().ok() == skip;
        let (mut own_outputs, mut repeated, mut sweeps) = (0, 0, 0);
        let mut has_models = false;
        let shared: Arc<Path> = Arc::from(folder);
        // Links are followed; a link that leads back into a folder above it is a failure.
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
                Err(error) => self.failures.push(failure_of_listing(folder, &error)),
                Ok(entry) if !has_name_of_model(entry.path()) || entry.file_type().is_dir() => {}
                // Reading a pipe might never end.
                Ok(entry) if !entry.file_type().is_file() => {
                    has_models = true;
                    let why = "this is not an ordinary file, and is read only where it is named itself";
                    self.failures.push(Failure::outside(entry.path(), "unreadable", why));
                }
                Ok(entry) if is_own_output(entry.path()) => own_outputs += 1,
                Ok(entry) => {
                    has_models = true;
                    if seen.insert(entry.path()) {
                        let folder = Some(Arc::clone(&shared));
                        self.models.push(ModelSource { path: entry.into_path(), folder, named: false });
                    } else {
                        repeated += 1;
                    }
                }
            }
        }
        if let Some(skipped) = skip.as_ref().filter(|skipped| skipped.starts_with(resolved(folder))) {
            self.remarks.push(format!("{}: the output folder is not read", skipped.display()));
        }
        let shown = folder.display();
        let left_out = [
            (own_outputs, format!("outputs of this tool (*{}.osim) skipped", OutputOptions::RESULT_SUFFIX)),
            (sweeps, format!("folders of sweeps (*{SWEEP_FOLDER_ENDING}) skipped")),
            (repeated, "models that are there a second time (named or linked)".to_owned()),
        ];
        let left_out = left_out.into_iter().filter(|(count, _)| *count > 0);
        self.remarks.extend(left_out.map(|(count, what)| format!("{shown}: {what}: {count}")));
        if !has_models {
            let why = "no .osim models in this folder: name a model, or the folder that holds them";
            self.failures.push(Failure::outside(folder, "no-models", why));
        }
    }
}

fn has_name_of_model(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("osim"))
}

/// Whether the error is about a link to a missing file, and the name of the link is neither a model's nor a folder's.
fn is_dead_link_beside_models(error: &walkdir::Error) -> bool {
    let path = error.path().filter(|path| path.extension().is_some() && !has_name_of_model(path));
    error.loop_ancestor().is_none() && path.is_some_and(is_dead_link)
}

fn is_dead_link(path: &Path) -> bool {
    path.is_symlink() && !path.exists()
}

/// Whether the name of a file is that of a result of this program.
fn is_own_output(path: &Path) -> bool {
    path.file_stem().unwrap_or_default().as_encoded_bytes().ends_with(OutputOptions::RESULT_SUFFIX.as_bytes())
}

/// Whether the name of a folder is that of a sweep.
fn is_sweep(folder: &Path) -> bool {
    folder.file_name().unwrap_or_default().as_encoded_bytes().ends_with(SWEEP_FOLDER_ENDING.as_bytes())
}

/// The failure of a folder that cannot be searched.
fn failure_of_listing(folder: &Path, error: &walkdir::Error) -> Failure {
    let path = error.path().unwrap_or(folder);
    let reason = match (error.loop_ancestor(), error.io_error()) {
        (Some(ancestor), _) => format!(
            "a link that leads back to {}: remove the link, or name the folders that hold the models",
            ancestor.display()
        ),
        _ if is_dead_link(path) => {
            "a link that leads nowhere: remove it, or bring back what it leads to".to_owned()
        }
        // The message is shown after the path.
        (None, Some(error)) => format!("cannot be read: {}", file_access::reason(error)),
        (None, None) => "cannot be read".to_owned(),
    };
    Failure::outside(path, "unreadable", reason)
}

/// Models that were found already. A model that is named twice, or has several links, counts once.
#[derive(Debug, Default)]
struct SeenModels {
    resolver: Resolver,
    files: HashSet<NameDigest>,
}

impl SeenModels {
    /// Adds a model, and says whether it is new.
    fn insert(&mut self, path: &Path) -> bool {
        let real = if path.as_os_str() == "-" { path.to_owned() } else { self.resolver.resolved(path) };
        self.files.insert(digest_of_name(real.as_os_str()))
    }
}

/// Most arguments of the command line that are tried as parts of one file name.
const MOST_NAME_PARTS: usize = 12;

/// A file name with blanks that the user typed without quotes, so that it came as several arguments.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SplitName {
    pub words: Range<usize>,
    /// The name that the arguments give if they are joined by blanks.
    pub name: PathBuf,
    pub exists: bool,
}

impl SplitName {
    /// Finds the first arguments that are the name of an existing file when they are joined by blanks, or else the first whose joined
    /// name ends like a model's. The first argument alone may not be a file.
    pub fn find(words: &[PathBuf]) -> Option<Self> {
        (0..words.len()).find_map(|start| Self::beginning_at(words, start))
    }

    /// The split file name that begins with the argument of index `start`, if there is one.
    pub(super) fn beginning_at(words: &[PathBuf], start: usize) -> Option<Self> {
        let rest = words.get(start..)?;
        let parts =
            rest.iter().skip(1).take_while(|word| word.as_os_str() != "-").take(MOST_NAME_PARTS).count() + 1;
        let mut name =
            rest.first().filter(|word| !word.exists() && !has_name_of_model(word))?.as_os_str().to_owned();
        let mut likely = None;
        let mut are_parts = true;
        for end in 1..parts {
            let word = rest.get(end)?;
            name.push(" ");
            name.push(word);
            let path = PathBuf::from(&name);
            let exists = path.exists();
            // A word that is a file itself is part of a name only if the whole name exists.
            are_parts = are_parts && !word.exists();
            let name_of_words = Self { words: start..start + end + 1, name: path, exists };
            if exists {
                return Some(name_of_words);
            }
            likely = likely
                .or_else(|| (are_parts && has_name_of_model(&name_of_words.name)).then_some(name_of_words));
        }
        likely
    }

    /// A message that the argument `first` is not a file, with the whole name in quotes as the user should write it.
    pub fn message(&self, first: &Path) -> String {
        format!("'{}' is {}", first.display(), self.reason())
    }

    /// Why the argument does not name a file, with the name in quotes.
    pub fn reason(&self) -> String {
        let name = self.name.display();
        let there = if self.exists { format!(", but '{name}' is") } else { String::new() };
        format!("not there{there}: a name with a blank needs quotes, \"{name}\"")
    }
}
