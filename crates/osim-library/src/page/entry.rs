//! What a page shows of one model of a run.

use osim_planning::BeforeAfter;
use osim_view::html::{Changed, DetailLevel, EarlierRun, Entry, Files, NamedDigest, RowError, RunRow};

use crate::Disk;
use crate::page::words::Words;
use crate::run::{ChangedModel, Record};

/// What a page shows of a model that was changed, of both its states.
#[must_use]
pub fn entry(changed: &ChangedModel<'_>, both: &BeforeAfter, detail: DetailLevel, words: Words) -> Entry {
    let record = changed.record;
    let names = changed.opened.files().map(|(name, _)| name.to_owned());
    let inputs = names.zip(changed.inputs.iter().cloned()).map(|(name, sha256)| NamedDigest { name, sha256 });
    let digests = [&record.sha256_output, &record.sha256_geometry_output];
    let paths = changed.written.paths().iter().map(|path| path.display().to_string());
    let outputs = paths.zip(digests.into_iter().flatten().cloned());
    let outputs = outputs.map(|(name, sha256)| NamedDigest { name, sha256 }).collect();
    let result = match changed.earlier {
        true => record.status.describe().to_owned(),
        false => changed.written.describe(),
    };
    let files = Files { inputs: inputs.collect(), result, outputs };
    let mut change = Changed::of_states(changed.plan, both, files);
    if let Some(feet) = change.feet.last_mut() {
        feet.add_bones(&changed.opened.model, &changed.task.source.path, None, &Disk);
    }
    let followed = both.recording.as_ref();
    change.recording = followed.map(|seen| osim_view::html::recording(&seen.0, &seen.1, words));
    change.in_file = !changed.written.paths().is_empty();
    let entry = osim_view::html::changed(&row(record), change, detail, words);
    if changed.earlier { entry.of_earlier_run() } else { entry }
}

/// A model with only its line in the summary.
#[must_use]
pub fn bare_entry(record: &Record, earlier: bool) -> Entry {
    if !earlier {
        let error = record.error_code.as_ref().zip(record.error.as_ref());
        let error = error.map(|(code, message)| {
            RowError::new(code.as_str(), message.as_str()).at(record.line, record.column)
        });
        return Entry::of_row(&row(record), error.as_ref());
    }
    let mut left = EarlierRun::default();
    left.radius_factor = record.radius_factor;
    left.stiffness_factor = record.stiffness_factor;
    left.dissipation_factor = record.dissipation_factor;
    left.unequal_factors = record.unequal_factors.split(' ').map(str::to_owned).collect();
    left.warnings = record.warnings.split_ascii_whitespace().count();
    Entry::left_by_earlier_run(&row(record), &left)
}

fn row(record: &Record) -> RunRow {
    let mut row = RunRow::new(record.model.as_str(), record.status.describe());
    row.row = record.row;
    row.output.clone_from(&record.output);
    row.contacts_mass_kg = record.contacts_mass_kg;
    row.target_mass_kg = record.target_mass_kg;
    row.changes = record.changes;
    row
}
