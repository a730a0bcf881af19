//! The spheres of a limb on the floor: what each does under its share of the weight.

use contact_scaling::{
    Contact, Hertz, SharedLoad, Spheres, equilibrium, limits, patch, restitution, smoothing, stiffness,
};
use osim_model::{ForceId, Model};

use super::data::{BODY_WEIGHTS, LoadFigures, SphereFigures};
use super::limits::limit_checks;
use super::sphere_loads::SphereLoads;

#[derive(Clone, Copy)]
pub(super) struct Weight {
    pub(super) mass_kg: f64,
    pub(super) gravity_m_s2: f64,
}

/// A limb on the floor.
pub(super) struct LoadedLimb<'s> {
    pub(super) model: &'s Model,
    pub(super) members: &'s [&'s SphereLoads],
    /// Spheres that share the weight.
    pub(super) count: Option<f64>,
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
        let mut known: Vec<(&SphereLoads, Vec<LoadFigures>)> = Vec::new();
        let mut figures = Vec::new();
        for &one in self.members {
            let alike = known.iter().find(|(other, _)| other.laws == one.laws);
            let loads = match alike {
                Some((_, loads)) => loads.clone(),
                None => level.iter().map(|level| under(one, level)).collect(),
            };
            if alike.is_none() {
                known.push((one, loads.clone()));
            }
            figures.push(self.sphere(one, loads));
        }
        figures
    }

    /// The limb under `body_weights`, all its spheres level.
    fn level(&self, body_weights: f64) -> Option<Level> {
        let load_n = self.load(body_weights)?.per_sphere_n();
        let first = self.members.first()?;
        if self.members.iter().all(|member| member.laws == first.laws) {
            return Some(Level { body_weights, load_n, rest: None });
        }
        let all: Vec<Spheres> = self.members.iter().flat_map(|member| member.laws.iter().copied()).collect();
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let on_limb = load_n * self.members.len() as f64;
        let hertz = equilibrium::hertz_indentation(&all, on_limb).ok();
        let own = equilibrium::indentation(&all, on_limb).ok();
        Some(Level { body_weights, load_n, rest: Some((hertz, own)) })
    }

    fn sphere(&self, one: &SphereLoads, loads: Vec<LoadFigures>) -> SphereFigures {
        let name = self.model.sphere(one.sphere);
        let force = |&id: &ForceId| self.model.force(id).map(|force| force.name.clone());
        let composite: f64 = one.contacts.iter().map(Contact::composite_modulus).sum();
        let dissipation = one.contacts.first().map(Contact::dissipation);
        let dissipation = dissipation.filter(|&alpha| one.contacts.iter().all(|c| c.dissipation() == alpha));
        let mut figures = SphereFigures {
            sphere: name.map(|sphere| sphere.name.clone()).unwrap_or_default(),
            path: name.map(|sphere| sphere.path.clone()).unwrap_or_default(),
            forces: one.forces.iter().filter_map(force).collect(),
            radius_m: one.radius_m,
            composite_modulus_n_m2: composite,
            loads,
            contact_stiffness_n_m: None,
            dimensionless_stiffness: None,
            natural_frequency_hz: None,
            mean_contact_stress_n_m2: None,
            dissipation_s_m: dissipation,
            restitution_exact: self.speed.zip(dissipation).and_then(|(v, a)| restitution::exact(a, v).ok()),
            restitution_approximate: self
                .speed
                .zip(dissipation)
                .and_then(|(v, a)| restitution::approximate(a, v).ok()),
            constant_indentation: None,
            transition_width: None,
            force_just_touching_n: None,
            touching_share: None,
            limits: Vec::new(),
        };
        self.stiffness(&mut figures);
        self.smoothing(one, &mut figures);
        figures.limits = limit_checks(&figures, self.speed);
        figures
    }

    /// k, k̂, f_n and σ under one body weight, by the Hertz law.
    fn stiffness(&self, figures: &mut SphereFigures) {
        let (Some(load), Some(weight)) = (self.load(1.0), self.weight) else { return };
        let Some(x_hat) = figures.load(1.0).and_then(|load| load.hertz) else { return };
        let hertz = Hertz::sphere(figures.composite_modulus_n_m2, figures.radius_m);
        let Ok(k) = hertz.map(|hertz| hertz.stiffness_at_relative_indentation(x_hat)) else { return };
        figures.contact_stiffness_n_m = Some(k);
        figures.dimensionless_stiffness = stiffness::dimensionless(k, figures.radius_m, &load).ok();
        figures.natural_frequency_hz =
            stiffness::natural_frequency(k, weight.mass_kg / load.sphere_count()).ok();
        figures.mean_contact_stress_n_m2 =
            patch::mean_stress(load.per_sphere_n(), figures.radius_m, x_hat).ok();
    }

    /// What the smoothing does; of several forces the one that does most.
    fn smoothing(&self, one: &SphereLoads, figures: &mut SphereFigures) {
        let smoothed = || one.contacts.iter().filter_map(Contact::smoothing);
        let most = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::max);
        figures.constant_indentation =
            most(&mut smoothed().filter_map(|s| {
                smoothing::constant_indentation(s.constant_contact_force, one.radius_m).ok()
            }));
        figures.transition_width = most(&mut smoothed().filter_map(|s| {
            smoothing::transition_width(limits::TRANSITION_THRESHOLD, s.hertz_smoothing, one.radius_m).ok()
        }));
        if smoothed().next().is_some() {
            let touching: f64 = one.laws.iter().map(|law| law.law().rest_force(0.0)).sum();
            figures.force_just_touching_n = Some(touching);
            figures.touching_share = self.load(1.0).map(|load| touching / load.per_sphere_n());
        }
    }
}

/// A limb under a load.
struct Level {
    body_weights: f64,
    /// The share of each sphere, N.
    load_n: f64,
    /// Indentation of all spheres by the Hertz law and by the law of the file, m; `None` where the spheres are alike, so
    /// that they stand level with equal shares.
    rest: Option<(Option<f64>, Option<f64>)>,
}

/// One sphere of the limb.
fn under(one: &SphereLoads, level: &Level) -> LoadFigures {
    let relative = |x: f64| Some(x / one.radius_m).filter(|x| x.is_finite());
    let hertz = equilibrium::hertz_indentation(&one.laws, level.load_n).ok();
    let own = equilibrium::indentation(&one.laws, level.load_n).ok();
    let (level_hertz, level_own) = level.rest.unwrap_or((hertz, own));
    LoadFigures {
        body_weights: level.body_weights,
        load_n: level.load_n,
        hertz: hertz.and_then(relative),
        own: own.and_then(relative),
        level_hertz: level_hertz.and_then(relative),
        level_own: level_own.and_then(relative),
    }
}
