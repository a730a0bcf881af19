//! What a model's contacts do under its weight: one source for the table, CSV, JSON and `check`.
//!
//! Each sphere is looked at with its share of the weight of the body on one limb, W/n, and with all spheres of the limb
//! level on the floor, where they have one indentation x (theory of mixed radii). Both are the same where the spheres of a
//! limb are alike.

use contact_scaling::{mixed_radii, restitution};
use osim_model::wording::{Input, Phrase, phrase};
use osim_model::{Fault, Limbs, Mass, Model, Selected, SphereId};
use osim_patch::loaded_spheres;

use super::data::{Figures, LimbFigures};
use super::limb::{LoadedLimb, Weight};
use super::sphere_loads::{SphereLoads, sphere_loads};
use crate::options::Stance;

impl Figures {
    /// Figures of the `selected` forces of `model`.
    ///
    /// # Errors
    /// A value that is no plain number or outside its domain, with its place.
    pub fn of(
        model: &Model,
        selected: &Selected,
        limbs: &Limbs,
        mass: Option<&Mass>,
        stance: &Stance,
    ) -> Result<Self, Fault> {
        let loads = sphere_loads(&loaded_spheres(model, &selected.forces)?)?;
        let gravity =
            stance.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0 && gravity.is_finite());
        let speed = stance.impact_speed_m_s.or_else(|| default_speed(&loads, gravity));
        let weight =
            mass.zip(gravity).map(|(mass, gravity)| Weight { mass_kg: mass.kg, gravity_m_s2: gravity });
        let groups = groups(limbs, &loads);
        let mut without: Option<Phrase> = match (mass, gravity) {
            (None, _) => Some("what the model weighs is not known".into()),
            (_, None) => Some("the model has no gravity".into()),
            _ => None,
        };
        let mut figures = Vec::new();
        for group in groups {
            let count = sphere_count(limbs, &group, stance);
            if count.is_none() && without.is_none() {
                without = limbs_unknown(limbs);
            }
            let limb = LoadedLimb { model, members: &group.members, count, weight, speed };
            figures.push(LimbFigures {
                limb: group.name,
                side: group.side,
                sphere_count: count,
                spheres: limb.spheres(),
            });
        }
        Ok(Self {
            mass_kg: mass.map(|mass| mass.kg),
            gravity_m_s2: gravity,
            impact_speed_m_s: speed,
            without_weight: without,
            limbs: figures,
        })
    }
}

struct Group<'p> {
    name: Option<String>,
    side: Option<&'static str>,
    members: Vec<&'p SphereLoads>,
}

/// √(gR/2) with R = √(Σ R_i²/n) of all spheres.
fn default_speed(loads: &[SphereLoads], gravity: Option<f64>) -> Option<f64> {
    let radii: Vec<f64> = loads.iter().map(|one| one.radius_m).collect();
    let radius = mixed_radii::mean_square(&radii).ok()?.sqrt();
    restitution::drop_speed(gravity?, radius).ok()
}

/// The spheres of each limb; all together where limbs are not known.
fn groups<'p>(limbs: &Limbs, loads: &'p [SphereLoads]) -> Vec<Group<'p>> {
    let Some(limbs) = limbs.known() else {
        let members: Vec<&SphereLoads> = loads.iter().collect();
        let none = members.is_empty();
        let group = Group { name: None, side: None, members };
        return if none { Vec::new() } else { vec![group] };
    };
    let of_limb = |spheres: &[SphereId]| loads.iter().filter(|one| spheres.contains(&one.sphere)).collect();
    limbs
        .iter()
        .map(|limb| Group {
            name: Some(limb.name.clone()),
            side: Some(limb.side.as_str()),
            members: of_limb(&limb.spheres),
        })
        .collect()
}

/// n: as said, else as found on this limb times the stance limbs.
fn sphere_count(limbs: &Limbs, group: &Group<'_>, stance: &Stance) -> Option<f64> {
    #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
    let found = group.members.len() as f64 * stance.limbs;
    stance.spheres.or_else(|| limbs.known().map(|_| found)).filter(|&count| count >= 1.0)
}

fn limbs_unknown(limbs: &Limbs) -> Option<Phrase> {
    match limbs {
        Limbs::Unknown(why) => Some(phrase![
            "how many spheres share the weight is not known (",
            why,
            "); say it with ",
            Input::Spheres.like("N"),
        ]),
        Limbs::Known(_) => None,
    }
}
