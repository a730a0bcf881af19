//! Where results go.

use std::path::{Path, PathBuf};

#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::dictionary;
use crate::relation::Relation;
use crate::values::path;

/// Where results go.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct OutputOptions {
    /// Write to this file, or - [default: NAME.scaled.osim beside it]
    #[cfg_attr(feature = "clap", arg(short, long, value_name = "FILE"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output: Option<PathBuf>,
    /// Write the changed ContactGeometrySet of a standalone ForceSet to this file
    #[cfg_attr(feature = "clap", arg(long, value_name = "FILE", hide_short_help = true))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub geometry_output: Option<PathBuf>,
    /// Write into this folder
    #[cfg_attr(feature = "clap", arg(short = 'd', long, value_name = "DIR"))]
    #[serde(with = "path::optional")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<path::PathSchema>"))]
    pub output_dir: Option<PathBuf>,
    /// Change the model itself and keep the old one as NAME.osim.bak
    #[cfg_attr(feature = "clap", arg(long))]
    pub in_place: bool,
    /// With `in_place`: keep no backup
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_backup: bool,
    /// Replace existing files
    #[cfg_attr(feature = "clap", arg(long))]
    pub force: bool,
    /// Leave no note (in the credits) in the model
    #[cfg_attr(feature = "clap", arg(long, hide_short_help = true))]
    pub no_note: bool,
}

impl OutputOptions {
    /// What the names of results end in by default, before their extension.
    pub const MARK: &'static str = ".scaled";

    /// Which of its fields need or exclude others.
    pub const RELATIONS: &'static [Relation] = &[
        Relation::Excludes("output_dir", "output"),
        Relation::Excludes("in_place", "output"),
        Relation::Excludes("in_place", "output_dir"),
        Relation::Excludes("in_place", "geometry_output"),
        Relation::Needs("no_backup", "in_place"),
    ];

    /// Whether a field of this name says which files results are written to. All of its fields do, but for the one that is about
    /// what is in them.
    pub(crate) fn is_about_files(field: &str) -> bool {
        field != "no_note" && dictionary::map(&Self::default()).contains_key(field)
    }

    /// Whether a factor may be applied to a model whose note says that it was applied already: a new file is no mistake.
    pub fn may_repeat(&self) -> bool {
        self.force || !self.in_place
    }

    /// Where a result goes by default: `NAME.scaled.osim` beside the model.
    #[must_use]
    pub fn beside(model: &Path) -> PathBuf {
        let mut name = model.file_stem().unwrap_or_default().to_owned();
        name.push(Self::MARK);
        if let Some(extension) = model.extension() {
            name.push(".");
            name.push(extension);
        }
        model.with_file_name(name)
    }

    /// Where the changed geometry set of a standalone force set goes.
    #[must_use]
    pub fn of_geometry(&self, geometry: &Path) -> PathBuf {
        match (&self.geometry_output, &self.output_dir) {
            _ if self.in_place => geometry.to_owned(),
            (Some(path), _) => path.clone(),
            (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
            (None, None) => Self::beside(geometry),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_a_new_file_beside_the_model() {
        assert_eq!(OutputOptions::beside(Path::new("a/human.osim")), Path::new("a/human.scaled.osim"));
        assert_eq!(OutputOptions::beside(Path::new("set.xml")), Path::new("set.scaled.xml"));
    }
}
