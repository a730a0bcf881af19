//! Where results go.

use std::path::{Path, PathBuf};

use osim_requests::options::OutputOptions;

use crate::source::Source;

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
            None => Self::File(OutputOptions::beside(&source.path)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(path: &str, folder: Option<&str>) -> Source {
        Source { path: path.into(), folder: folder.map(|folder| Path::new(folder).into()), named: true }
    }

    #[test]
    fn a_folder_keeps_its_shape() {
        assert_eq!(source("lib/a/x.osim", Some("lib")).below_folder(), Path::new("a/x.osim"));
        assert_eq!(source("lib/a/x.osim", None).below_folder(), Path::new("x.osim"));
    }
}
