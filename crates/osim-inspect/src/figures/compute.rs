//! What a model's contacts do under its weight: one source for the table, CSV, JSON and `check`.
//!
//! Each chosen sphere is looked at with its share of the weight of the body on one limb, W/n, and with all spheres of the
//! limb, chosen or not, level on the floor, where they have one indentation x (theory of mixed radii). Both are the same where the spheres of a
//! limb are alike.

use contact_scaling::{SharedLoad, Spheres, equilibrium, mixed_radii, restitution};
use foldhash::{HashMap, HashMapExt};
use osim_model::feet::{DefaultPose, RestLaw, Standing};
use osim_model::messages::Phrase;
use osim_model::{
    CountedSpheres, Fault, ForceId, GravityFor, Limbs, Mass, Model, Needed, Selected, SphereId,
    loaded_spheres,
};

use super::register::Figure;
use crate::figures::on_floor::{OnFloor, Rest, SphereLoads, Weight, sphere_loads};
use crate::figures::register::{Figures, LimbFigures, SphereFigures};
use crate::floors::weight_share_at;
use crate::load::{LoadSharing, Stance};

impl Figures {
    /// Figures of the `selected` forces of `model`, whose weight is shared as `sharing` says; those at the default pose follow from how
    /// the bodies are `standing` there, as far as it is known.
    ///
    /// # Errors
    /// A value that is not a plain number or outside its domain, with its place.
    pub fn of(
        model: &Model,
        selected: &Selected,
        sharing: &LoadSharing,
        mass: Option<&Mass>,
        stance: &Stance,
        standing: &[Standing],
    ) -> Result<Self, Fault> {
        let loads = sphere_loads(&loaded_spheres(model, &selected.forces)?)?;
        // Without the others nothing is known of a limb that stands level.
        let all = loaded_spheres(model, sharing.forces()).and_then(|all| sphere_loads(&all)).ok();
        let gravity =
            stance.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0 && gravity.is_finite());
        let speed =
            stance.impact_speed_m_s.or_else(|| default_speed(all.as_deref().unwrap_or(&loads), gravity));
        let pose = DefaultPose::of(model);
        let weight = mass.zip(gravity).map(|(mass, gravity)| Weight {
            mass_kg: mass.kg,
            gravity_m_s2: gravity * weight_share_at(model, sharing.forces(), &pose),
        });
        let mut why: Option<Phrase> = match (mass, gravity) {
            (None, _) => Some("what the model weighs is not known".into()),
            (_, None) => Some(Needed::Gravity { purpose: GravityFor::Figures }.phrase()),
            _ => None,
        };
        let mut limbs = Vec::new();
        let trees = by_sphere(standing);
        let mut by_limb = all.as_ref().map(|all| by_limb(sharing.limbs(), all));
        for (place, group) in groups(sharing.limbs(), &loads, stance.spheres, stance.limbs_of(model)) {
            if group.count.is_none() && why.is_none() {
                why = limbs_unknown(sharing.limbs());
            }
            let limb = LoadedLimb {
                model,
                members: &group.members,
                all: by_limb.as_mut().and_then(|all| all.get_mut(place)).map(std::mem::take),
                count: group.count,
                trees: &trees,
                weight,
                speed,
            };
            limbs.push(LimbFigures {
                limb: group.name,
                side: group.side,
                sphere_count: group.count,
                spheres: limb.spheres(),
            });
        }
        if limbs.is_empty() && why.is_none() {
            // Forces of several bodies, and nobody chose among them.
            why = sharing.limbs().why_unknown().cloned();
        }
        Ok(Self {
            mass_kg: mass.map(|mass| mass.kg),
            gravity_m_s2: gravity,
            impact_speed_m_s: speed,
            why_no_body_weight: why,
            limbs,
        })
    }
}

/// The chosen spheres of a limb, and n.
struct Group<'p> {
    name: Option<String>,
    side: Option<&'static str>,
    count: Option<f64>,
    members: Vec<&'p SphereLoads>,
}

/// The spheres of each limb among `all`, in their order; all together where limbs are not known.
fn by_limb<'a>(limbs: &Limbs, all: &'a [SphereLoads]) -> Vec<Vec<&'a SphereLoads>> {
    let Some(limbs) = limbs.if_known() else { return vec![all.iter().collect()] };
    let mut limb_of: HashMap<SphereId, usize> = HashMap::new();
    for (place, limb) in limbs.iter().enumerate() {
        limb_of.extend(limb.spheres.iter().map(|&sphere| (sphere, place)));
    }
    let mut found = vec![Vec::new(); limbs.len()];
    for one in all {
        if let Some(limb) = limb_of.get(&one.sphere).and_then(|&place| found.get_mut(place)) {
            limb.push(one);
        }
    }
    found
}

/// √(gR/2) with R = √(Σ R_i²/n) of all spheres.
fn default_speed(loads: &[SphereLoads], gravity: Option<f64>) -> Option<f64> {
    let radii: Vec<f64> = loads.iter().map(|one| one.radius_m).collect();
    let radius = mixed_radii::mean_square(&radii).ok()?.sqrt();
    restitution::drop_speed(gravity?, radius).ok()
}

/// The chosen spheres of each limb that has some, with its place among the limbs; all together where limbs are not known.
fn groups<'p>(
    limbs: &Limbs,
    loads: &'p [SphereLoads],
    spheres: Option<f64>,
    stance_limbs: f64,
) -> Vec<(usize, Group<'p>)> {
    let at_least_one = |count: &f64| *count >= 1.0;
    let members = by_limb(limbs, loads).into_iter().enumerate().filter(|(_, members)| !members.is_empty());
    let group = |(place, members): (usize, Vec<&'p SphereLoads>)| {
        let limb = limbs.if_known().and_then(|limbs| limbs.get(place));
        let count = match limb {
            None => spheres,
            Some(limb) => Some(LoadSharing::count_on(limb, spheres, stance_limbs)),
        };
        let group = Group {
            name: limb.map(|limb| limb.name.clone()),
            side: limb.map(|limb| limb.side.as_str()),
            count: count.filter(at_least_one),
            members,
        };
        (place, group)
    };
    members.map(group).collect()
}

fn limbs_unknown(limbs: &Limbs) -> Option<Phrase> {
    match limbs {
        Limbs::Unknown(why) => {
            Some(Needed::SphereCount { of: CountedSpheres::Model, why: why.clone() }.phrase())
        }
        Limbs::Known(_) => None,
    }
}

/// The loads that are looked at, in body weights.
const BODY_WEIGHTS: [f64; 2] = [1.0, 2.0];

/// A limb on the floor.
struct LoadedLimb<'s> {
    pub(super) model: &'s Model,
    /// The chosen spheres, which have figures.
    members: &'s [&'s SphereLoads],
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

// Spheres of a limb at their own heights: how deep each is where together they carry the body.

/// The joint tree of each sphere on a floor, which all its limb is on.
type Trees<'s> = HashMap<SphereId, &'s Standing>;

fn by_sphere(standing: &[Standing]) -> Trees<'_> {
    standing.iter().flat_map(|tree| tree.spheres.iter().map(move |over| (over.sphere, tree))).collect()
}

/// x̂ of the spheres of a limb that carries the body, its bodies as they are at the default pose; empty where the pose or a sphere
/// is not known.
struct Stand {
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
        Self { hertz: rest(RestLaw::Hertz), model_law: rest(RestLaw::OfFile) }
    }

    /// x̂ of one sphere by both laws.
    pub(super) fn relative(&self, one: &SphereLoads) -> (Option<f64>, Option<f64>) {
        let of = |known: &HashMap<SphereId, f64>| known.get(&one.sphere).copied();
        (of(&self.hertz), of(&self.model_law))
    }
}
