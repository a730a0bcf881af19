//! Spheres of a limb at their own heights: how deep each is where together they carry the body.

use contact_scaling::SharedLoad;
use foldhash::HashMap;
use osim_model::SphereId;
use osim_model::feet::{ByLaw, Standing};

use super::sphere_loads::SphereLoads;

/// The joint tree of each sphere on a floor, which all its limb is on.
pub(super) type Trees<'s> = HashMap<SphereId, &'s Standing>;

/// By sphere, the tree that it is on.
pub(super) fn by_sphere(standing: &[Standing]) -> Trees<'_> {
    standing.iter().flat_map(|tree| tree.spheres.iter().map(move |over| (over.sphere, tree))).collect()
}

/// x̂ of the spheres of a limb that carries the body, its bodies as they are at the default pose; empty where the pose or a sphere
/// is not known.
pub(super) struct Stand {
    hertz: HashMap<SphereId, f64>,
    model_law: HashMap<SphereId, f64>,
}

impl Stand {
    /// `all` spheres of a limb; each carries its share of `load` on the average.
    pub(super) fn of(all: &[&SphereLoads], load: SharedLoad, trees: &Trees<'_>) -> Self {
        let spheres: Vec<SphereId> = all.iter().map(|one| one.sphere).collect();
        let own = spheres.first().and_then(|first| trees.get(first));
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let on_limb = load.per_sphere_n() * all.len() as f64;
        let rest = |law| {
            let rest = own.and_then(|own| own.rest_under(&spheres, on_limb, law)?.ok());
            let spheres = rest.into_iter().flat_map(|rest| rest.spheres);
            let relative = spheres.map(|one| (one.sphere, one.relative_indentation));
            relative.filter(|(_, x_hat)| x_hat.is_finite()).collect()
        };
        Self { hertz: rest(ByLaw::Hertz), model_law: rest(ByLaw::OfFile) }
    }

    /// x̂ of one sphere by both laws.
    pub(super) fn relative(&self, one: &SphereLoads) -> (Option<f64>, Option<f64>) {
        let of = |known: &HashMap<SphereId, f64>| known.get(&one.sphere).copied();
        (of(&self.hertz), of(&self.model_law))
    }
}
