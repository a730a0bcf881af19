//! Spheres of a limb at their own heights: how deep each is where together they carry the body.

use std::collections::HashMap;

use contact_scaling::equilibrium::{self, Raised};
use contact_scaling::{DomainError, SharedLoad};
use osim_feet::DefaultPose;
use osim_model::{Model, SphereId};

use super::sphere_loads::SphereLoads;

/// Heights of the bottoms of spheres in ground at the default pose, m, as far as they are known.
pub(super) struct Bottoms(HashMap<SphereId, f64>);

impl Bottoms {
    pub(super) fn of(model: &Model, pose: &DefaultPose, spheres: impl Iterator<Item = SphereId>) -> Self {
        let up = model.up();
        let height = |id: SphereId| {
            let sphere = model.sphere(id)?;
            let body = pose.placement(sphere.body.as_deref()?).ok()?;
            let centre = body.point(model.centre_m(id)?);
            let height: f64 = centre.iter().zip(up).map(|(a, b)| a * b).sum();
            Some(height - sphere.radius_m().ok()?).filter(|height| height.is_finite())
        };
        Self(spheres.filter_map(|id| Some((id, height(id)?))).collect())
    }
}

/// A limb that carries the body, its bodies as they are at the default pose.
pub(super) struct Stand<'b> {
    bottoms: &'b Bottoms,
    lowest_m: f64,
    /// Indentation of the lowest sphere, by the Hertz law and by the model's, m.
    hertz: Option<f64>,
    model_law: Option<f64>,
}

impl<'b> Stand<'b> {
    /// `all` spheres of a limb; each carries its share of `load` on the average.
    pub(super) fn of(all: &[&SphereLoads], load: SharedLoad, bottoms: &'b Bottoms) -> Self {
        let heights: Option<Vec<f64>> = all.iter().map(|one| bottoms.0.get(&one.sphere).copied()).collect();
        let lowest_m = heights.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let raised: Option<Vec<Raised>> = heights.and_then(|heights| {
            let with_laws = all
                .iter()
                .zip(heights)
                .flat_map(|(one, height)| one.laws.iter().map(move |&law| (law, height)));
            with_laws.map(|(law, height)| Raised::new(law, height - lowest_m).ok()).collect()
        });
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let on_limb = load.per_sphere_n() * all.len() as f64;
        let rest = |of: fn(&[Raised], f64) -> Result<f64, DomainError>| of(raised.as_deref()?, on_limb).ok();
        let hertz = rest(equilibrium::hertz_indentation_of_lowest);
        let model_law = rest(equilibrium::indentation_of_lowest);
        Self { bottoms, lowest_m, hertz, model_law }
    }

    /// x̂ of one sphere by both laws.
    pub(super) fn relative(&self, one: &SphereLoads) -> (Option<f64>, Option<f64>) {
        let height = self.bottoms.0.get(&one.sphere).map(|bottom| bottom - self.lowest_m);
        let relative = |x: Option<f64>| Some((x? - height?) / one.radius_m).filter(|x| x.is_finite());
        (relative(self.hertz), relative(self.model_law))
    }
}
