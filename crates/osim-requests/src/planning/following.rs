//! By how much bodies were scaled, where a rescaling moves spheres with them.

use osim_model::{Fault, Model, Needed, ScaledSinceNote};
use osim_patch::{FOLLOWING, FOLLOWING_NOTE, ScaleFile};

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
    /// The note does not say them, or it says that spheres followed already (unless `again`), or says others than the ScaleSet.
    pub(super) fn factors(&self, model: &Model, again: bool) -> Result<Option<ScaleFile>, Fault> {
        match self {
            Self::Nothing => Ok(None),
            Self::Note => of_note(model).map(Some),
            Self::File(file) => {
                if let Some(since) = model.scaled_since_note().filter(|_| !again) {
                    compare(model, &since, file)?;
                }
                Ok(Some(file.clone()))
            }
        }
    }
}

fn of_note(model: &Model) -> Result<ScaleFile, Fault> {
    let unknown = || Fault::new(Needed::NotedSizes);
    let since = model.scaled_since_note().ok_or_else(unknown)?;
    let carriers = model.loaded_spheres(&model.force_ids());
    let mut bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_ref());
    if bodies.any(|body| !since.factors.contains_key(body)) {
        return Err(unknown());
    }
    Ok(ScaleFile::of_factors(since.factors))
}

/// Sees that the ScaleSet was not applied to these spheres before, and is that of this model.
fn compare(model: &Model, since: &ScaledSinceNote, file: &ScaleFile) -> Result<(), Fault> {
    if !since.is_scaled() {
        let placed = model.note.as_ref().is_some_and(osim_model::Note::placed);
        let repeated = || Fault::new(Needed::Repetition { operation: FOLLOWING.to_owned() });
        return if placed { Err(repeated()) } else { Ok(()) };
    }
    for (body, noted) in &since.factors {
        let given = file.of(body)?;
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_FACTOR * b.abs();
        if !noted.iter().zip(&given).all(same) {
            return Err(Fault::refused(format!(
                "the ScaleSet scales {body} by {given:?}, and by the note in the file it was scaled by {noted:?}: expected the \
                 ScaleSet that was applied to this model"
            )));
        }
    }
    Ok(())
}
