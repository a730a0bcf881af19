//! Computes what the contacts of a model do under its weight, such as indentation and stiffness, for tables, CSV, JSON and `check`. Each of
//! these numbers is a figure in a register.
//!
//! Each chosen sphere gets figures for its share of the weight on one limb, W/n, and figures for all spheres of the limb, chosen or not,
//! with level bottoms and one common indentation x (theory of mixed radii). If the spheres of a limb are alike, both are equal.

mod register;
mod sphere_on_floor;

use contact_scaling::{SharedLoad, Spheres, equilibrium, mixed_radii, restitution};
use foldhash::{HashMap, HashMapExt};
use osim_model::feet::{DefaultPose, RestLaw, Standing};
use osim_model::messages::Phrase;
use osim_model::{
    CountedSpheres, ForceId, GravityFor, Limbs, Mass, MissingFact, Model, Result, Selected, SphereId,
    loaded_round_spheres, loaded_spheres,
};

use crate::figures::sphere_on_floor::{
    SphereContacts, SphereOnFloor, SphereRest, WeightOnFloor, contacts_by_sphere,
};
use crate::plane_judgement::weight_share_at_pose;
use crate::{LoadSharing, Stance};

pub use register::{Figure, FigureVisibility, Figures, LimbFigures, LimitCheck, SphereFigures};
pub(crate) use register::{ROUNDING_RADII, UP_TO_CENTRE_RADII};

impl Figures {
    /// The figures of the `selected` forces of `model`, whose weight is shared as `sharing` says. Figures at the default pose need
    /// `standing`, the bodies over their floors.
    ///
    /// # Errors
    /// A value that is not a plain number or outside its domain, with its place.
    pub fn compute(
        model: &Model,
        selected: &Selected,
        sharing: &LoadSharing,
        mass: Option<&Mass>,
        stance: &Stance,
        standing: &[Standing],
    ) -> Result<Self> {
        let loads = contacts_by_sphere(&loaded_round_spheres(model, &selected.forces)?)?;
        // If a sphere that was not chosen cannot be read, or is an ellipsoid, level figures are not known.
        let all = loaded_spheres(model, &sharing.forces).and_then(|all| contacts_by_sphere(&all)).ok();
        let gravity =
            stance.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0 && gravity.is_finite());
        let speed = stance
            .impact_speed_m_s
            .or_else(|| default_impact_speed(all.as_deref().unwrap_or(&loads), gravity));
        let pose = DefaultPose::of(model);
        let weight = mass.zip(gravity).map(|(mass, gravity)| WeightOnFloor {
            mass_kg: mass.kg,
            gravity_m_s2: gravity * weight_share_at_pose(model, &sharing.forces, &pose),
        });
        let mut why_no_body_weight: Option<Phrase> = match (mass, gravity) {
            (None, _) => Some("the mass of the model is not known".into()),
            (_, None) => Some(MissingFact::Gravity { purpose: GravityFor::Figures }.phrase()),
            _ => None,
        };
        let mut limbs = Vec::new();
        let standing: StandingBySphere<'_> = standing
            .iter()
            .flat_map(|tree| tree.spheres.iter().map(move |over| (over.sphere, tree)))
            .collect();
        let mut all_by_limb = all.as_ref().map(|all| split_by_limb(&sharing.limbs, all));
        let chosen_by_limb = split_by_limb(&sharing.limbs, &loads).into_iter().enumerate();
        for (place, chosen) in chosen_by_limb.filter(|(_, chosen)| !chosen.is_empty()) {
            let limb = sharing.limbs.if_known().and_then(|limbs| limbs.get(place));
            let on_limb = |limb| LoadSharing::count_on_limb(limb, stance.spheres, stance.limb_count(model));
            let sphere_count = limb.map(on_limb).or(stance.spheres).filter(|&count| count >= 1.0);
            if sphere_count.is_none() && why_no_body_weight.is_none() {
                let why = sharing.limbs.why_unknown().cloned();
                why_no_body_weight =
                    why.map(|why| MissingFact::SphereCount { of: CountedSpheres::Model, why }.phrase());
            }
            let loaded = LoadedLimb {
                model,
                chosen: &chosen,
                all: all_by_limb.as_mut().and_then(|all| all.get_mut(place)).map(std::mem::take),
                count: sphere_count,
                standing: &standing,
                weight,
                speed,
            };
            limbs.push(LimbFigures {
                limb: limb.map(|limb| limb.name.clone()),
                side: limb.map(|limb| limb.side.as_str()),
                sphere_count,
                spheres: loaded.sphere_figures(),
            });
        }
        if limbs.is_empty() && why_no_body_weight.is_none() {
            // The forces belong to several bodies, and the caller chose none of these.
            let ellipsoids =
                model.loaded_spheres(&selected.forces).into_iter().filter_map(|id| model.sphere(id));
            let why_none = ellipsoids.filter_map(|sphere| sphere.round_radius_m().err()).next();
            why_no_body_weight =
                why_none.map(|fault| fault.phrase()).or(sharing.limbs.why_unknown().cloned());
        }
        let (mass_kg, gravity_m_s2, impact_speed_m_s) = (mass.map(|mass| mass.kg), gravity, speed);
        Ok(Self { mass_kg, gravity_m_s2, impact_speed_m_s, why_no_body_weight, limbs })
    }
}

/// The spheres of each limb among `all`, in the order of `all`. If the limbs are not known, one list with all spheres.
fn split_by_limb<'a>(limbs: &Limbs, all: &'a [SphereContacts]) -> Vec<Vec<&'a SphereContacts>> {
    let Some(limbs) = limbs.if_known() else { return vec![all.iter().collect()] };
    let mut limb_of: HashMap<SphereId, usize> = HashMap::new();
    for (place, limb) in limbs.iter().enumerate() {
        limb_of.extend(limb.spheres.iter().map(|&sphere| (sphere, place)));
    }
    let mut on_limbs = vec![Vec::new(); limbs.len()];
    for one in all {
        if let Some(limb) = limb_of.get(&one.sphere).and_then(|&place| on_limbs.get_mut(place)) {
            limb.push(one);
        }
    }
    on_limbs
}

/// The default speed before an impact, √(gR/2) with R = √(Σ R_i²/n) of all spheres, m/s.
fn default_impact_speed(loads: &[SphereContacts], gravity: Option<f64>) -> Option<f64> {
    let radii: Vec<f64> = loads.iter().map(|one| one.radius_m).collect();
    let radius = mixed_radii::mean_square(&radii).ok()?.sqrt();
    restitution::drop_speed(gravity?, radius).ok()
}

/// The loads for which figures are computed, in body weights.
const LOADS_BW: [f64; 2] = [1.0, 2.0];

/// A limb that carries the body, with its chosen spheres and the numbers from which their figures are computed.
struct LoadedLimb<'s> {
    model: &'s Model,
    /// The chosen spheres of the limb, for which figures are computed.
    chosen: &'s [&'s SphereContacts],
    /// Contacts of all spheres of the limb, chosen or not; `None` if one of them cannot be read.
    all: Option<Vec<&'s SphereContacts>>,
    /// Number of spheres that share the weight; `None` if it is not known.
    count: Option<f64>,
    standing: &'s StandingBySphere<'s>,
    weight: Option<WeightOnFloor>,
    /// Speed of the spheres before an impact, m/s; `None` if it is not known.
    speed: Option<f64>,
}

impl LoadedLimb<'_> {
    /// The load of this many body weights on the spheres of the limb.
    fn load_at(&self, body_weights: f64) -> Option<SharedLoad> {
        let weight = self.weight?;
        SharedLoad::new(body_weights * weight.mass_kg * weight.gravity_m_s2, self.count?).ok()
    }

    /// The figures of each chosen sphere. Equal laws are solved once, because the spheres of a limb are mostly alike.
    fn sphere_figures(&self) -> Vec<SphereFigures> {
        let level: Vec<LevelLimb> = LOADS_BW.iter().filter_map(|&weights| self.level_limb(weights)).collect();
        let at_own_heights = self.all.as_deref().zip(self.load_at(1.0));
        let at_own_heights =
            at_own_heights.map(|(all, load)| OwnHeightRest::compute(all, load, self.standing));
        let mut solved: HashMap<Vec<u64>, Vec<SphereRest>> = HashMap::new();
        let mut figures = Vec::new();
        for &one in self.chosen {
            let rests = solved
                .entry(one.laws_key())
                .or_insert_with(|| level.iter().map(|level| sphere_rest(one, level)).collect());
            let mut rests = rests.clone();
            if let (Some(own), Some(rest)) =
                (&at_own_heights, rests.iter_mut().find(|rest| rest.body_weights == 1.0))
            {
                rest.standing_hertz = own.hertz.get(&one.sphere).copied();
                rest.standing_model_law = own.model_law.get(&one.sphere).copied();
            }
            figures.push(self.figures_of_sphere(one, &rests));
        }
        figures
    }

    /// The equilibrium of the limb under this many body weights, if all bottoms are at one height.
    fn level_limb(&self, body_weights: f64) -> Option<LevelLimb> {
        let load_n = self.load_at(body_weights)?.per_sphere_n();
        let Some(all) = &self.all else {
            return Some(LevelLimb { body_weights, load_n, indentations_m: Some((None, None)) });
        };
        let first = all.first()?;
        if all.iter().all(|member| member.laws == first.laws) {
            return Some(LevelLimb { body_weights, load_n, indentations_m: None });
        }
        let laws: Vec<Spheres> = all.iter().flat_map(|member| member.laws.iter().copied()).collect();
        let on_limb = load_n * all.len() as f64;
        let hertz = equilibrium::hertz_indentation(&laws, on_limb).ok();
        let model_law = equilibrium::indentation(&laws, on_limb).ok();
        Some(LevelLimb { body_weights, load_n, indentations_m: Some((hertz, model_law)) })
    }

    /// The figures of one sphere; `rests` has its depth under each load.
    fn figures_of_sphere(&self, one: &SphereContacts, rests: &[SphereRest]) -> SphereFigures {
        let name = self.model.sphere(one.sphere);
        let force = |&id: &ForceId| self.model.force(id).map(|force| force.name.clone());
        let on_floor = SphereOnFloor {
            contacts: one,
            weight: self.weight,
            one_body_weight: self.load_at(1.0),
            impact_speed_m_s: self.speed,
            rests,
        };
        let computed = Figure::ALL.iter().map(|figure| figure.compute(&on_floor)).collect();
        SphereFigures {
            sphere: name.map(|sphere| sphere.name.clone()).unwrap_or_default(),
            path: name.map(|sphere| sphere.path.clone()).unwrap_or_default(),
            forces: one.forces.iter().filter_map(force).collect(),
            computed,
        }
    }
}

/// A limb under a load, if the bottoms of all its spheres are at one height.
struct LevelLimb {
    body_weights: f64,
    /// The load that each sphere carries on average, N.
    load_n: f64,
    /// The common indentation of all spheres, m: by the Hertz law, and by the law of the model. `None` if all spheres have equal laws: then
    /// equal shares of the load keep the bottoms level.
    indentations_m: Option<(Option<f64>, Option<f64>)>,
}

/// The relative indentations x̂ of the sphere `one` at rest, under the load of `level`.
fn sphere_rest(one: &SphereContacts, level: &LevelLimb) -> SphereRest {
    let relative = |x: f64| Some(x / one.radius_m).filter(|x| x.is_finite());
    let hertz = equilibrium::hertz_indentation(&one.laws, level.load_n).ok();
    let model_law = equilibrium::indentation(&one.laws, level.load_n).ok();
    let (level_hertz, level_model_law) = level.indentations_m.unwrap_or((hertz, model_law));
    SphereRest {
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

// Spheres of a limb at their own heights: how deep each is while together they carry the body.

/// For each sphere over a floor, its joint tree with the heights of the spheres of this tree.
type StandingBySphere<'s> = HashMap<SphereId, &'s Standing>;

/// The relative indentations x̂ of the spheres of a limb that carries the body in its default pose, each sphere at its own height; empty if
/// the pose or a sphere is not known.
struct OwnHeightRest {
    hertz: HashMap<SphereId, f64>,
    model_law: HashMap<SphereId, f64>,
}

impl OwnHeightRest {
    /// Computes the x̂ of `all` spheres of a limb; on average each sphere carries its share of `load`.
    fn compute(all: &[&SphereContacts], load: SharedLoad, standing: &StandingBySphere<'_>) -> Self {
        let spheres: Vec<SphereId> = all.iter().map(|one| one.sphere).collect();
        let tree = spheres.first().and_then(|first| standing.get(first));
        let on_limb = load.per_sphere_n() * all.len() as f64;
        let rest = |law| {
            let rest = tree.and_then(|tree| tree.rest_under(&spheres, on_limb, law)?.ok());
            let spheres = rest.into_iter().flat_map(|rest| rest.spheres);
            let relative = spheres.map(|one| (one.sphere, one.relative_indentation));
            relative.filter(|(_, x_hat)| x_hat.is_finite()).collect()
        };
        Self { hertz: rest(RestLaw::Hertz), model_law: rest(RestLaw::OfFile) }
    }
}
