//! n, the number of spheres that share the body weight: the one rule for it.

use osim_model::messages::Phrase;
use osim_model::{CountOf, Fault, ForceId, Limb, Limbs, Model, Needed};

/// Which spheres share the weight of the body that chosen forces belong to.
///
/// All spheres that stand count, whichever forces were chosen: those left out carry weight too. What stands beside the body,
/// joined to it only through ground, does not count.
///
/// ```
/// use osim_inspect::LoadSharing;
/// use osim_model::{CountOf, Model, Selection};
///
/// # let bytes: &[u8] = include_bytes!("../../osim-model/tests/data/one_foot.osim");
/// // One sphere on one limb; n on two such limbs is 2.
/// let model = Model::parse(bytes)?;
/// let selected = Selection::default().apply(&model)?;
/// let sharing = LoadSharing::of(&model, &selected.forces);
/// assert_eq!(sharing.count(None, 2.0, CountOf::Model)?, 2.0);
/// // A number that was given goes before.
/// assert_eq!(sharing.count(Some(6.0), 2.0, CountOf::Model)?, 6.0);
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoadSharing {
    limbs: Limbs,
    forces: Vec<ForceId>,
}

impl LoadSharing {
    /// For the body that the spheres of `chosen` belong to.
    #[must_use]
    pub fn of(model: &Model, chosen: &[ForceId]) -> Self {
        let forces = model.forces_of_same_body(chosen);
        Self { limbs: model.limbs(&forces), forces }
    }

    /// For a model whose forces cannot be chosen.
    pub(crate) fn unknown(why: Phrase) -> Self {
        Self { limbs: Limbs::Unknown(why), forces: Vec::new() }
    }

    /// The limbs, with every sphere that stands.
    #[must_use]
    pub fn limbs(&self) -> &Limbs {
        &self.limbs
    }

    /// The forces through which the body stands, chosen or not.
    #[must_use]
    pub fn forces(&self) -> &[ForceId] {
        &self.forces
    }

    /// n: as `given`, else the spheres of a limb times the `stance_limbs`. `of` says whose spheres a question is about.
    ///
    /// # Errors
    /// None was given, and left and right are not known, or limbs have different numbers of spheres.
    pub fn count(&self, given: Option<f64>, stance_limbs: f64, of: CountOf) -> Result<f64, Fault> {
        if let Some(count) = given {
            return Ok(count);
        }
        match self.limbs.spheres_per_limb() {
            Ok(spheres) => Ok(on_limbs(spheres, stance_limbs)),
            Err(why) => Err(Fault::new(Needed::SphereCount { of, why })),
        }
    }

    /// n while the body stands on limbs like `limb`: figures are given for each limb, even where limbs differ.
    #[must_use]
    pub fn count_on(limb: &Limb, given: Option<f64>, stance_limbs: f64) -> f64 {
        given.unwrap_or_else(|| on_limbs(limb.spheres.len(), stance_limbs))
    }
}

#[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
fn on_limbs(spheres: usize, stance_limbs: f64) -> f64 {
    spheres as f64 * stance_limbs
}
