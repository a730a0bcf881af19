//! n, the number of spheres that share the body weight.

use osim_model::{CountOf, Fault, Model, Needed};

/// n as found per limb times the stance limbs, or a question.
///
/// All spheres that stand count, whichever forces were selected: those left out carry weight too.
///
/// # Errors
/// Left and right cannot be determined, or limbs have different numbers of spheres.
pub fn sphere_count(model: &Model, stance_limbs: f64, of: CountOf) -> Result<f64, Fault> {
    match model.limbs(&model.force_ids()).spheres_per_limb() {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        Ok(count) => Ok(count as f64 * stance_limbs),
        Err(why) => Err(Fault::new(Needed::SphereCount { of, why })),
    }
}
