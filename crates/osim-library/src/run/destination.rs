//! Where results go.

use std::path::{Path, PathBuf};

use osim_requests::options::OutputOptions;

use crate::source::{OUTPUT_MARK, Source};

/// Where one model's result goes.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Destination {
    /// Standard output.
    Stdout,
    /// A file of its own.
    File(PathBuf),
    /// The model itself.
    Itself,
}

impl Destination {
    /// The file that is written for `source`.
    #[must_use]
    pub fn path<'p>(&'p self, source: &'p Source) -> Option<&'p Path> {
        match self {
            Self::Stdout => None,
            Self::File(path) => Some(path),
            Self::Itself => Some(&source.path),
        }
    }

    /// Where the result of `source` goes.
    #[must_use]
    pub fn of(source: &Source, output: &OutputOptions) -> Self {
        if let Some(path) = &output.output {
            return if path.as_os_str() == "-" { Self::Stdout } else { Self::File(path.clone()) };
        }
        if source.is_stdin() {
            return match &output.output_dir {
                Some(folder) => Self::File(folder.join("stdin.osim")),
                None => Self::Stdout,
            };
        }
        if output.in_place {
            return Self::Itself;
        }
        match &output.output_dir {
            // A file goes to DIR/its name, a folder's files to DIR/their path below that folder.
            Some(folder) => Self::File(folder.join(source.below_folder())),
            None => Self::File(beside(&source.path)),
        }
    }
}

/// `NAME.scaled.osim` beside the model.
fn beside(path: &Path) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_owned();
    name.push(OUTPUT_MARK);
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
}

/// Where the changed geometry set of a standalone force set goes.
pub(super) fn geometry_destination(geometry: &Path, output: &OutputOptions) -> PathBuf {
    match (&output.geometry_output, &output.output_dir) {
        _ if output.in_place => geometry.to_owned(),
        (Some(path), _) => path.clone(),
        (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
        (None, None) => beside(geometry),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> Source {
        Source { path: path.into(), folder: folder.map(|folder| Path::new(folder).into()) }
    }

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }

    #[test]
    fn a_folder_keeps_its_shape() {
        assert_eq!(source("lib/a/x.osim", Some("lib")).below_folder(), Path::new("a/x.osim"));
        assert_eq!(source("lib/a/x.osim", None).below_folder(), Path::new("x.osim"));
    }
}
