//! The models to which contacts are added: all models of the project, each also in other forms of text.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use osim_model::files::{FileError, Files, InMemory};

/// The bytes of a model, and its name for messages.
#[derive(Clone)]
pub struct Document {
    pub name: String,
    pub bytes: Vec<u8>,
}

/// All files in `fixtures/`, by their paths in this folder, and in `corpus/` the files of the folder OSIM_CORPUS, if this variable is set.
pub fn all_files() -> InMemory {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut files = InMemory::default();
    let mut take = |folder: &Path, name: &str| {
        for path in files_below(folder) {
            let own = Path::new(name).join(path.strip_prefix(folder).unwrap());
            files.add(own, std::fs::read(&path).unwrap());
        }
    };
    take(&fixtures, "");
    if let Some(corpus) = std::env::var_os("OSIM_CORPUS") {
        take(Path::new(&corpus), "corpus");
    }
    files
}

/// The models among `files`, except those that are wrong on purpose.
pub fn models(files: &InMemory) -> Vec<Document> {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut names: Vec<String> = files_below(&fixtures)
        .into_iter()
        .map(|path| path.strip_prefix(&fixtures).unwrap().to_string_lossy().into_owned())
        .collect();
    if let Some(corpus) = std::env::var_os("OSIM_CORPUS") {
        let own = |path: PathBuf| format!("corpus/{}", path.file_name().unwrap().to_string_lossy());
        names.extend(files_below(Path::new(&corpus)).into_iter().map(own));
    }
    names.retain(|name| name.ends_with(".osim") && !name.starts_with("bad/"));
    names.sort();
    let read = |name: String| Document { bytes: files.read(Path::new(&name)).unwrap(), name };
    names.into_iter().map(read).collect()
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(files_below(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

/// The files of the project, with some files replaced or added.
pub struct ChangedFiles<'f> {
    pub files: &'f InMemory,
    pub own: BTreeMap<PathBuf, Vec<u8>>,
}

impl Files for ChangedFiles<'_> {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.own.get(path).map_or_else(|| self.files.read(path), |bytes| Ok(bytes.clone()))
    }

    fn exists(&self, path: &Path) -> bool {
        self.own.contains_key(path) || self.files.exists(path)
    }
}
