//! The spheres of a limb on the floor: where each rests under its share of the weight.

use contact_scaling::{SharedLoad, Spheres, equilibrium};
use foldhash::{HashMap, HashMapExt};
use osim_model::{ForceId, Model};

use super::bottoms::{Stand, Trees};
use super::data::SphereFigures;
use super::on_floor::{OnFloor, Rest, Weight};
use super::register::Figure;
use super::sphere_loads::SphereLoads;

/// The loads that are looked at, in body weights.
const BODY_WEIGHTS: [f64; 2] = [1.0, 2.0];

/// A limb on the floor.
pub(super) struct LoadedLimb<'s> {
    pub(super) model: &'s Model,
    /// The chosen spheres, which have figures.
    pub(super) members: &'s [&'s SphereLoads],
    /// All its spheres; `None` where not all can be read.
    pub(super) all: Option<Vec<&'s SphereLoads>>,
    /// Spheres that share the weight.
    pub(super) count: Option<f64>,
    /// Bodies on their floors at the default pose, as far as they are known.
    pub(super) trees: &'s Trees<'s>,
    pub(super) weight: Option<Weight>,
    /// Speed before an impact, m/s.
    pub(super) speed: Option<f64>,
}

impl LoadedLimb<'_> {
    fn load(&self, body_weights: f64) -> Option<SharedLoad> {
        let weight = self.weight?;
        SharedLoad::new(body_weights * weight.mass_kg * weight.gravity_m_s2, self.count?).ok()
    }

    /// Figures of every sphere. Where a law rests is looked for once: the spheres of a limb are mostly alike.
    pub(super) fn spheres(&self) -> Vec<SphereFigures> {
        let level: Vec<Level> = BODY_WEIGHTS.iter().filter_map(|&weights| self.level(weights)).collect();
        let stand =
            self.all.as_deref().zip(self.load(1.0)).map(|(all, load)| Stand::of(all, load, self.trees));
        let mut known: HashMap<Vec<u64>, Vec<Rest>> = HashMap::new();
        let mut figures = Vec::new();
        for &one in self.members {
            let rests = known
                .entry(one.key())
                .or_insert_with(|| level.iter().map(|level| under(one, level)).collect());
            let mut rests = rests.clone();
            if let (Some(stand), Some(rest)) =
                (&stand, rests.iter_mut().find(|rest| rest.body_weights == 1.0))
            {
                (rest.standing_hertz, rest.standing_model_law) = stand.relative(one);
            }
            figures.push(self.sphere(one, &rests));
        }
        figures
    }

    /// The limb under `body_weights`, all its spheres level.
    fn level(&self, body_weights: f64) -> Option<Level> {
        let load_n = self.load(body_weights)?.per_sphere_n();
        let Some(all) = &self.all else {
            return Some(Level { body_weights, load_n, rest: Some((None, None)) });
        };
        let first = all.first()?;
        if all.iter().all(|member| member.laws == first.laws) {
            return Some(Level { body_weights, load_n, rest: None });
        }
        let laws: Vec<Spheres> = all.iter().flat_map(|member| member.laws.iter().copied()).collect();
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let on_limb = load_n * all.len() as f64;
        let hertz = equilibrium::hertz_indentation(&laws, on_limb).ok();
        let model_law = equilibrium::indentation(&laws, on_limb).ok();
        Some(Level { body_weights, load_n, rest: Some((hertz, model_law)) })
    }

    fn sphere(&self, one: &SphereLoads, rests: &[Rest]) -> SphereFigures {
        let name = self.model.sphere(one.sphere);
        let force = |&id: &ForceId| self.model.force(id).map(|force| force.name.clone());
        let on_floor = OnFloor {
            sphere: one,
            weight: self.weight,
            one_body_weight: self.load(1.0),
            impact_speed_m_s: self.speed,
            rests,
        };
        let answers = Figure::ALL.iter().map(|figure| figure.answer(&on_floor)).collect();
        SphereFigures {
            sphere: name.map(|sphere| sphere.name.clone()).unwrap_or_default(),
            path: name.map(|sphere| sphere.path.clone()).unwrap_or_default(),
            forces: one.forces.iter().filter_map(force).collect(),
            answers,
        }
    }
}

/// A limb under a load.
struct Level {
    body_weights: f64,
    /// The share of each sphere, N.
    load_n: f64,
    /// Indentation of all spheres by the Hertz law and by the model's, m; `None` where the spheres are alike, so that they
    /// stand level with equal shares.
    rest: Option<(Option<f64>, Option<f64>)>,
}

/// One sphere of the limb.
fn under(one: &SphereLoads, level: &Level) -> Rest {
    let relative = |x: f64| Some(x / one.radius_m).filter(|x| x.is_finite());
    let hertz = equilibrium::hertz_indentation(&one.laws, level.load_n).ok();
    let model_law = equilibrium::indentation(&one.laws, level.load_n).ok();
    let (level_hertz, level_model_law) = level.rest.unwrap_or((hertz, model_law));
    Rest {
        body_weights: level.body_weights,
        load_n: level.load_n,
        hertz: hertz.and_then(relative),
        model_law: model_law.and_then(relative),
        level_hertz: level_hertz.and_then(relative),
        level_model_law: level_model_law.and_then(relative),
        standing_hertz: None,
        standing_model_law: None,
    }
}
