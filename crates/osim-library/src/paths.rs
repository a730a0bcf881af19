//! Makes absolute and relative paths, also of files and folders that do not exist yet; and makes folders.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};

use osim_model::nearest_names;

use crate::fault::{Context, LibraryFault, Result};

/// The absolute path without links, `.` and `..`; parts that do not exist yet stay as they are written.
pub fn resolved(path: &Path) -> PathBuf {
    if let Ok(real) = path.canonicalize() {
        return real;
    }
    // Windows has two spellings of a folder; all resolved paths have the one that `canonicalize` gives: `\\?\C:\here`, not `C:\here`.
    let here = || std::env::current_dir().map(|here| here.canonicalize().unwrap_or(here)).unwrap_or_default();
    let mut real = if path.is_absolute() { PathBuf::new() } else { here() };
    for component in path.components() {
        match component {
            Component::ParentDir => {
                real.pop();
            }
            Component::CurDir => {}
            other => {
                real.push(other);
                real = real.canonicalize().unwrap_or(real);
            }
        }
    }
    real
}

/// The relative path from one folder to another, both [`resolved`]; `.` if they are equal, and `to` itself if it is on another drive.
pub(crate) fn relative_path(from: &Path, to: &Path) -> PathBuf {
    let same = from.components().zip(to.components()).take_while(|(from, to)| from == to).count();
    if same == 0 {
        return to.to_owned();
    }
    let up = from.components().skip(same).map(|_| Component::ParentDir);
    let way: PathBuf = up.chain(to.components().skip(same)).collect();
    if way.as_os_str().is_empty() { Path::new(".").to_owned() } else { way }
}

/// The folder of a file: `.` for a bare name.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The file that a missing `path` may mean: its name has the ending of a model, too, or is nearly the same. Names of subjects, which
/// differ in a number, are not near.
pub(crate) fn similar_file(path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let number = |name: &str| name.chars().filter(char::is_ascii_digit).collect::<String>();
    let files = std::fs::read_dir(folder_of(path)).ok()?.flatten().take(1000);
    let names = files.filter_map(|file| file.file_name().into_string().ok());
    let names: Vec<String> = names.filter(|other| number(other) == number(name)).collect();
    let model = names.iter().find(|other| other.eq_ignore_ascii_case(&format!("{name}.osim")));
    // The ending makes no names alike.
    let stem = path.file_stem()?.to_str()?;
    let is_alike = |other: &&String| {
        let other = Path::new(other.as_str()).file_stem().and_then(OsStr::to_str).unwrap_or_default();
        !nearest_names(stem, [other], 2).is_empty()
    };
    let near = || nearest_names(name, names.iter().filter(is_alike).map(String::as_str), 2).first().copied();
    Some(path.with_file_name(model.map(String::as_str).or_else(near)?))
}

/// Refuses the file `path`, which the user named, if its folder is not there and none of the `results` is written into it.
pub fn require_folder_of<'p>(path: &Path, results: impl IntoIterator<Item = &'p Path>) -> Result<()> {
    let folder = folder_of(path);
    refuse_file_as_folder(folder)?;
    // A folder that cannot be looked at is left to the system's own message.
    let is_missing = folder.try_exists().is_ok_and(|there| !there);
    let is_of_results = || results.into_iter().any(|result| resolved(result).starts_with(resolved(folder)));
    if is_missing && !is_of_results() {
        let folder = folder.display();
        return Err(LibraryFault::new(format!("the folder {folder} is not there: make it first")));
    }
    Ok(())
}

/// Refuses a folder that is a file, or that would be below one.
pub(crate) fn refuse_file_as_folder(folder: &Path) -> Result<()> {
    let Some(file) = folder.ancestors().find(|path| path.is_file()) else { return Ok(()) };
    let shown = file.display();
    Err(LibraryFault::new(format!("{shown} is a file, expected a folder: choose another name")))
}

/// Makes the folder of `path` and the folders above it.
pub fn make_folder_of(path: &Path) -> Result<()> {
    let folder = folder_of(path);
    if folder.is_dir() {
        return Ok(());
    }
    refuse_file_as_folder(folder)?;
    let cannot = || format!("cannot make the folder {}", folder.display());
    resolved(path).parent().map_or(Ok(()), |folder| std::fs::create_dir_all(folder).context(cannot))
}

/// Makes many paths absolute as [`resolved`] does, but looks at each folder only once.
#[derive(Debug, Default)]
pub(crate) struct Resolver {
    folders: HashMap<PathBuf, PathBuf>,
}

impl Resolver {
    /// The absolute path, as the function `resolved` gives it.
    pub(crate) fn resolved(&mut self, path: &Path) -> PathBuf {
        let Some(name) = path.file_name() else { return resolved(path) };
        if path.is_symlink() {
            return resolved(path);
        }
        let folder = folder_of(path);
        self.folders.entry(folder.to_owned()).or_insert_with(|| resolved(folder)).join(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relative_paths_lead_up_and_down() {
        for (from, to, expected) in
            [("/a/b", "/a/b", "."), ("/a", "/a/b/c", "b/c"), ("/a/b/c", "/a/d", "../../d")]
        {
            assert_eq!(relative_path(Path::new(from), Path::new(to)), Path::new(expected), "{from} {to}");
        }
    }

    #[test]
    fn paths_through_folders_that_do_not_exist_are_resolved() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.osim");
        std::fs::write(&file, "").unwrap();
        assert_eq!(resolved(&folder.path().join("new/../a.osim")), resolved(&file));
        assert_eq!(resolved(&folder.path().join("./new")), resolved(folder.path()).join("new"));
        for new in ["new.osim", "new/a.osim"] {
            assert!(resolved(Path::new(new)).starts_with(resolved(Path::new("."))), "{new}");
        }
        let mut resolver = Resolver::default();
        for path in ["new/../a.osim", "./a.osim", "new/b.osim", ".."] {
            let path = folder.path().join(path);
            assert_eq!(resolver.resolved(&path), resolved(&path));
        }
    }
}
