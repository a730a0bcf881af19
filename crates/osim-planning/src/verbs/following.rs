//! By how much bodies were scaled, where a rescaling moves spheres with them.

use osim_model::compare::ScaleFile;
use osim_model::messages::readable;
use osim_model::{Fault, Model, Needed, Note, ScaledSinceNote};
use osim_patch::{FOLLOWING, FOLLOWING_NOTE};

/// Factors that differ by more than this (relative) are not the same.
const SAME_FACTOR: f64 = 1e-4;

/// Where the factors come from.
pub(super) enum Following {
    /// Spheres stay.
    Nothing,
    /// From the sizes in the note.
    Note,
    /// From the ScaleSet that the Scale Tool applied.
    File(ScaleFile),
}

impl Following {
    /// The operation, as the note has it.
    pub(super) const fn operation(&self) -> &'static str {
        match self {
            Self::Nothing => "rescale",
            Self::Note => FOLLOWING_NOTE,
            Self::File(_) => FOLLOWING,
        }
    }

    /// The factors for `model`; `None` where spheres stay.
    ///
    /// # Errors
    /// The note does not say them, says others than the ScaleSet, or says that spheres followed already.
    pub(super) fn factors(&self, model: &Model) -> Result<Option<ScaleFile>, Fault> {
        match self {
            Self::Nothing => Ok(None),
            Self::Note => of_note(model).map(Some),
            Self::File(file) => {
                match model.scaled_since_note() {
                    Some(since) if since.is_scaled() => compare(&since, file)?,
                    Some(_) if model.note.as_ref().is_some_and(Note::placed) => {
                        return Err(Fault::new(Needed::Followed));
                    }
                    _ => {}
                }
                Ok(Some(file.clone()))
            }
        }
    }
}

fn of_note(model: &Model) -> Result<ScaleFile, Fault> {
    let unknown = || Fault::new(Needed::NotedSizes);
    let since = model.scaled_since_note().ok_or_else(unknown)?;
    if !since.has_all_carriers(model) {
        return Err(unknown());
    }
    Ok(ScaleFile::of_factors(since.factors))
}

/// Checks that the ScaleSet is that of this model.
fn compare(since: &ScaledSinceNote, file: &ScaleFile) -> Result<(), Fault> {
    for (body, noted) in &since.factors {
        let given = file.of(body)?;
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_FACTOR * b.abs();
        if !noted.iter().zip(&given).all(same) {
            return Err(Fault::refused(format!(
                "the ScaleSet scales {body} by {}, and by the note in the file it was scaled by {}: expected the ScaleSet \
                 that was applied to this model",
                in_words(given),
                in_words(*noted)
            )));
        }
    }
    Ok(())
}

/// Factors along x, y and z.
fn in_words(factors: [f64; 3]) -> String {
    factors.map(readable).join(", ")
}
