//! The files that people gave to the web page.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_model::files::{FileError, Files, InMemory};

/// The files that people gave to the web page, by their names.
///
/// People drop files without their folders. A file that a model names in a folder (`../parts/bodies.xml`) is then found by its name
/// without that folder, if exactly one file has this name.
#[derive(Debug, Default)]
pub(crate) struct GivenFiles {
    files: InMemory,
    /// Names of the files that people gave to the page.
    names: BTreeSet<PathBuf>,
}

impl GivenFiles {
    /// Adds a file, or replaces the file of the same name.
    pub(crate) fn put(&mut self, name: &str, bytes: Vec<u8>) {
        self.names.insert(name.into());
        self.files.add(name, bytes);
    }

    /// Sets the date for notes in changed models.
    pub(crate) fn set_today(&mut self, date: &str) {
        self.files.set_today(date);
    }

    /// Removes a file that people gave to the page.
    pub(crate) fn remove(&mut self, name: &str) {
        self.names.remove(Path::new(name));
        self.files.remove(Path::new(name));
    }

    /// The file whose name without a folder is the name in `path`; `None` if several files have this name.
    fn only_file_named_like(&self, path: &Path) -> Option<&Path> {
        let wanted = path.file_name()?;
        let mut alike = self.names.iter().filter(|name| name.file_name() == Some(wanted));
        let first = alike.next()?;
        alike.next().is_none().then_some(first.as_path())
    }
}

impl Files for GivenFiles {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        if self.files.exists(path) {
            return self.files.read(path);
        }
        match self.only_file_named_like(path) {
            Some(name) => self.files.read(name),
            None => Err(FileError::new("this file was not given to the page: add it to the model")),
        }
    }

    fn exists(&self, path: &Path) -> bool {
        self.files.exists(path) || self.only_file_named_like(path).is_some()
    }

    fn today(&self) -> Option<String> {
        self.files.today()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files_named(names: &[&str]) -> GivenFiles {
        let mut files = GivenFiles::default();
        names.iter().for_each(|name| files.put(name, name.as_bytes().to_vec()));
        files
    }

    #[track_caller]
    fn assert_finds(files: &GivenFiles, path: &str, found: Option<&str>) {
        let read = files.read(Path::new(path)).ok();
        assert_eq!(read.as_deref(), found.map(str::as_bytes), "{path}");
        assert_eq!(files.exists(Path::new(path)), found.is_some(), "{path}");
    }

    #[test]
    fn a_file_without_its_folder_is_found_by_its_name() {
        let files = files_named(&["human.osim", "bodies.xml"]);
        assert_finds(&files, "../parts/bodies.xml", Some("bodies.xml"));
        assert_finds(&files, "parts/forces.xml", None);
    }

    #[test]
    fn a_file_with_its_folder_comes_first_and_ambiguous_names_find_none() {
        let files = files_named(&["a/bodies.xml", "b/bodies.xml", "a/human.osim"]);
        assert_finds(&files, "a/bodies.xml", Some("a/bodies.xml"));
        assert_finds(&files, "c/bodies.xml", None);
    }

    #[test]
    fn a_file_that_the_user_removed_from_the_page_is_not_found() {
        let mut files = files_named(&["human.osim"]);
        files.remove("human.osim");
        assert_finds(&files, "human.osim", None);
    }
}
