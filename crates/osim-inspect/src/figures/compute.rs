//! What a model's contacts do under its weight: one source for the table, CSV, JSON and `check`.
//!
//! Each chosen sphere is looked at with its share of the weight of the body on one limb, W/n, and with all spheres of the
//! limb, chosen or not, level on the floor, where they have one indentation x (theory of mixed radii). Both are the same where the spheres of a
//! limb are alike.

use contact_scaling::{mixed_radii, restitution};
use foldhash::{HashMap, HashMapExt};
use osim_model::feet::DefaultPose;
use osim_model::feet::Standing;
use osim_model::messages::Phrase;
use osim_model::{
    CountOf, Fault, GravityFor, Limbs, Mass, Model, Needed, Selected, SphereId, loaded_spheres,
};

use super::bottoms::by_sphere;
use super::data::{Figures, LimbFigures};
use super::limb::LoadedLimb;
use super::on_floor::Weight;
use super::sphere_loads::{SphereLoads, sphere_loads};
use crate::floors::weight_share_at;
use crate::load_sharing::LoadSharing;
use crate::options::Stance;

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
            why = sharing.limbs().unknown().cloned();
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
    let Some(limbs) = limbs.known() else { return vec![all.iter().collect()] };
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
        let limb = limbs.known().and_then(|limbs| limbs.get(place));
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
        Limbs::Unknown(why) => Some(Needed::SphereCount { of: CountOf::Model, why: why.clone() }.phrase()),
        Limbs::Known(_) => None,
    }
}
