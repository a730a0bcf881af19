//! What each changing verb plans for a model.

pub(crate) mod design;
mod reference;
pub(crate) mod rescale;
pub(crate) mod set;
pub(crate) mod transfer;

use std::path::Path;

use anyhow::Result;
use osim_patch::{Fault, FaultKind, Model, RadiusRule, shortest};

pub(crate) use reference::scale_file;

/// A factor that the note says was applied already is not applied once more in place, unless `again` is wanted.
fn refuse_again(model: &Model, operation: &str, again: bool) -> Result<(), Fault> {
    let done = model.note.as_ref().is_some_and(|note| note.operation == operation);
    if !done || again {
        return Ok(());
    }
    Err(Fault::new(FaultKind::NeedsAnswer {
        code: "same-operation",
        question: format!("the note in the file says that '{operation}' was done already"),
        way_out: "apply it once more with --force".to_owned(),
    }))
}

/// The verb, and the factor of the radius where one is given.
fn operation(verb: &str, radius: Option<RadiusRule>) -> String {
    match radius {
        Some(RadiusRule::Factor(factor)) => format!("{verb} radius=x{}", shortest(factor)),
        _ => verb.to_owned(),
    }
}

/// n as found per limb times the stance limbs, or a question.
///
/// All spheres that stand count, whichever forces were selected: those left out carry weight too.
pub(crate) fn sphere_count(model: &Model, stance_limbs: f64, option: &str) -> Result<f64, Fault> {
    let all: Vec<usize> = (0..model.forces.len()).collect();
    let limbs = model.limbs(&all);
    match limbs.spheres_per_limb() {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        Ok(count) => Ok(count as f64 * stance_limbs),
        Err(why) => Err(Fault::new(FaultKind::NeedsAnswer {
            code: "sphere-count",
            question: format!("how many spheres share the body weight is not known: {why}"),
            way_out: format!("say it with {option} N"),
        })),
    }
}

/// `true` for a path that a model may have.
pub(crate) fn looks_like_verb(path: &Path) -> bool {
    let text = path.to_string_lossy();
    !path.exists() && !text.contains(['.', '/', '\\']) && text != "-"
}
