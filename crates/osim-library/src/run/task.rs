//! One model and what is to be done with it.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use osim_requests::options::OutputOptions;

use super::conflicts::PathOwner;
use super::destination::Destination;
use super::settings::JobSettings;
use crate::source::Source;

/// One model with its settings.
#[non_exhaustive]
pub struct Task {
    /// The model.
    pub source: Source,
    /// Where its result goes.
    pub destination: Destination,
    /// Where the changed geometry set of a standalone force set goes.
    pub geometry_output: Option<PathBuf>,
    /// Whether the output was asked for by name: then it is written even if nothing changes.
    pub(super) asked: bool,
    pub(super) settings: Arc<JobSettings>,
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
    /// Columns of the manifest that are the user's own: name and text.
    pub remarks: Vec<(String, String)>,
}

impl Task {
    /// A model that is done by these settings.
    pub(super) fn new(source: Source, output: &OutputOptions, settings: Arc<JobSettings>) -> Self {
        let geometry = settings.set_files.geometry.as_deref();
        Self {
            destination: Destination::of(&source, output),
            geometry_output: geometry.map(|geometry| output.of_geometry(geometry)),
            asked: output.output.is_some() || output.output_dir.is_some(),
            source,
            settings,
            row: None,
            remarks: Vec::new(),
        }
    }

    /// The same, as row `row` of a manifest.
    pub(super) fn of_row(self, row: usize) -> Self {
        Self { row: Some(row), ..self }
    }

    /// The same with columns of the user's own, which a summary copies.
    pub(super) fn with_remarks(self, remarks: Vec<(String, String)>) -> Self {
        Self { remarks, ..self }
    }

    /// The file that is written.
    #[must_use]
    pub fn output(&self) -> Option<&Path> {
        self.destination.path(&self.source)
    }

    /// As named in messages about several models.
    pub(super) fn owner(&self) -> PathOwner<'_> {
        PathOwner::Model(&self.source.path, self.row)
    }
}
