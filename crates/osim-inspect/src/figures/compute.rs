//! What a model's contacts do under its weight: one source for the table, CSV, JSON and `check`.
//!
//! Each chosen sphere is looked at with its share of the weight of the body on one limb, W/n, and with all spheres of the
//! limb, chosen or not, level on the floor, where they have one indentation x (theory of mixed radii). Both are the same where the spheres of a
//! limb are alike.

use contact_scaling::{mixed_radii, restitution};
use osim_model::wording::Phrase;
use osim_model::{CountOf, Fault, GravityFor, Limbs, Mass, Model, Needed, Selected, SphereId};
use osim_patch::loaded_spheres;

use super::data::{Figures, LimbFigures};
use super::limb::LoadedLimb;
use super::on_floor::Weight;
use super::sphere_loads::{SphereLoads, sphere_loads};
use crate::load_sharing::LoadSharing;
use crate::options::Stance;

impl Figures {
    /// Figures of the `selected` forces of `model`, whose weight is shared as `sharing` says.
    ///
    /// # Errors
    /// A value that is not a plain number or outside its domain, with its place.
    pub fn of(
        model: &Model,
        selected: &Selected,
        sharing: &LoadSharing,
        mass: Option<&Mass>,
        stance: &Stance,
    ) -> Result<Self, Fault> {
        let loads = sphere_loads(&loaded_spheres(model, &selected.forces)?)?;
        // Without the others nothing is known of a limb that stands level.
        let standing = loaded_spheres(model, sharing.forces()).and_then(|all| sphere_loads(&all)).ok();
        let gravity =
            stance.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0 && gravity.is_finite());
        let speed =
            stance.impact_speed_m_s.or_else(|| default_speed(standing.as_deref().unwrap_or(&loads), gravity));
        let weight =
            mass.zip(gravity).map(|(mass, gravity)| Weight { mass_kg: mass.kg, gravity_m_s2: gravity });
        let mut why: Option<Phrase> = match (mass, gravity) {
            (None, _) => Some("what the model weighs is not known".into()),
            (_, None) => Some(Needed::Gravity { purpose: GravityFor::Figures }.phrase()),
            _ => None,
        };
        let mut limbs = Vec::new();
        for group in groups(sharing.limbs(), &loads, stance) {
            if group.count.is_none() && why.is_none() {
                why = limbs_unknown(sharing.limbs());
            }
            let limb = LoadedLimb {
                model,
                members: &group.members,
                standing: standing.as_ref().map(|all| group.standing(all)),
                count: group.count,
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
    /// All spheres of the limb; `None` where limbs are not known.
    spheres: Option<&'p [SphereId]>,
}

impl Group<'_> {
    /// Every sphere of the limb, chosen or not, among `all`.
    fn standing<'a>(&self, all: &'a [SphereLoads]) -> Vec<&'a SphereLoads> {
        all.iter().filter(|one| self.spheres.is_none_or(|spheres| spheres.contains(&one.sphere))).collect()
    }
}

/// √(gR/2) with R = √(Σ R_i²/n) of all spheres.
fn default_speed(loads: &[SphereLoads], gravity: Option<f64>) -> Option<f64> {
    let radii: Vec<f64> = loads.iter().map(|one| one.radius_m).collect();
    let radius = mixed_radii::mean_square(&radii).ok()?.sqrt();
    restitution::drop_speed(gravity?, radius).ok()
}

/// The chosen spheres of each limb; all together where limbs are not known.
fn groups<'p>(limbs: &'p Limbs, loads: &'p [SphereLoads], stance: &Stance) -> Vec<Group<'p>> {
    let at_least_one = |count: &f64| *count >= 1.0;
    let groups: Vec<Group<'p>> = match limbs.known() {
        None => {
            let members = loads.iter().collect();
            let count = stance.spheres.filter(at_least_one);
            vec![Group { name: None, side: None, count, members, spheres: None }]
        }
        Some(limbs) => limbs
            .iter()
            .map(|limb| Group {
                name: Some(limb.name.clone()),
                side: Some(limb.side.as_str()),
                count: Some(LoadSharing::count_on(limb, stance.spheres, stance.limbs)).filter(at_least_one),
                members: loads.iter().filter(|one| limb.spheres.contains(&one.sphere)).collect(),
                spheres: Some(&limb.spheres),
            })
            .collect(),
    };
    groups.into_iter().filter(|group| !group.members.is_empty()).collect()
}

fn limbs_unknown(limbs: &Limbs) -> Option<Phrase> {
    match limbs {
        Limbs::Unknown(why) => Some(Needed::SphereCount { of: CountOf::Model, why: why.clone() }.phrase()),
        Limbs::Known(_) => None,
    }
}
