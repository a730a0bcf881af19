//! What a model's contacts do under its weight: one source for the table, CSV, JSON and `check`.
//!
//! Each sphere is looked at with its share of the weight of the body on one limb, W/n, and with all spheres of the limb
//! level on the floor, where they have one indentation x (theory of mixed radii). Both are the same where the spheres of a
//! limb are alike.

use contact_scaling::{EQUAL_SURFACES, mixed_radii, restitution};
use osim_patch::{Fault, Limbs, Mass, Model, Selected, loaded_spheres};
use serde::Serialize;

use super::standing::{Pressed, Stand, Weight, pressed};
use super::verdict::Verdict;

/// The loads that are looked at, in body weights.
pub(crate) const BODY_WEIGHTS: [f64; 2] = [1.0, 2.0];

/// What the command line says about the load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stance {
    /// Spheres that share the body weight, all stance limbs together; `None`: as found on a limb.
    pub spheres: Option<f64>,
    /// Limbs that share the body weight.
    pub limbs: f64,
    /// Speed before an impact, m/s; `None`: √(gR/2).
    pub impact_speed_m_s: Option<f64>,
    /// Gravity instead of the model's own, m/s².
    pub gravity_m_s2: Option<f64>,
}

/// Figures of one model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Figures {
    /// Mass whose weight the spheres carry: what the model weighs, else what its contacts stand for, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that was taken, m/s²: the model's own as a rule; `None` without gravity.
    pub gravity_m_s2: Option<f64>,
    /// Speed before an impact, m/s: given, or √(gR/2) with R = √(Σ R_i²/n) of all spheres, as in a drop test.
    pub impact_speed_m_s: Option<f64>,
    /// Why figures under body weight are absent, in words.
    pub without_weight: Option<String>,
    /// Each limb; one entry without a name where limbs are not known.
    pub limbs: Vec<LimbFigures>,
}

/// Figures of one limb.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct LimbFigures {
    /// First body below the place where left and right part; `None` where limbs are not known.
    pub limb: Option<String>,
    /// `right` or `left`.
    pub side: Option<&'static str>,
    /// Spheres n that share the body weight; `None` where it cannot be told.
    pub sphere_count: Option<f64>,
    /// Each sphere, in file order.
    pub spheres: Vec<SphereFigures>,
}

/// Figures of one sphere.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SphereFigures {
    /// Name of the sphere.
    pub sphere: String,
    /// Its component path.
    pub path: String,
    /// Names of the forces that press it on the floor.
    pub forces: Vec<String>,
    /// Radius R, m.
    pub radius_m: f64,
    /// Composite modulus E* (A.3), N/m²; the sum where several forces press the sphere.
    pub composite_modulus_n_m2: f64,
    /// Under body weights; empty where the weight is not known.
    pub loads: Vec<LoadFigures>,
    /// Stiffness k of the Hertz law under one body weight (B.2), N/m.
    pub contact_stiffness_n_m: Option<f64>,
    /// k̂ = k R n / F at one body weight (B.3), without unit.
    pub dimensionless_stiffness: Option<f64>,
    /// Natural frequency f_n about the rest under one body weight, by k and M/n (B.4), Hz.
    pub natural_frequency_hz: Option<f64>,
    /// Mean contact stress σ under one body weight (15), N/m².
    pub mean_contact_stress_n_m2: Option<f64>,
    /// Dissipation α, s/m; `None` where forces of different α press the sphere.
    pub dissipation_s_m: Option<f64>,
    /// Restitution c_r of the law at the impact speed, without unit.
    pub restitution_exact: Option<f64>,
    /// Restitution by (13); `None` where it is below 0, or the speed is not known.
    pub restitution_approximate: Option<f64>,
    /// √cf / R (C.2), without unit; `None` for a `HuntCrossleyForce`.
    pub constant_indentation: Option<f64>,
    /// Width Δx̂ over which the contact state goes from 5 % to 95 % (C.7), in radii.
    pub transition_width: Option<f64>,
    /// Elastic force while the sphere just touches, x = 0 (C.3), N.
    pub force_just_touching_n: Option<f64>,
    /// The same over the sphere's share of one body weight.
    pub touching_share: Option<f64>,
    /// Each figure that has a limit, against it.
    pub limits: Vec<Verdict>,
}

/// One sphere under one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct LoadFigures {
    /// The load in body weights.
    pub body_weights: f64,
    /// The sphere's share W/n, N.
    pub load_n: f64,
    /// x̂ under its share, by the Hertz law (11).
    pub hertz: Option<f64>,
    /// x̂ under its share, by the law of the file (C.3); below 0 where the sphere floats.
    pub own: Option<f64>,
    /// x̂ with all spheres of the limb level, by the Hertz law.
    pub level_hertz: Option<f64>,
    /// x̂ with all spheres of the limb level, by the law of the file.
    pub level_own: Option<f64>,
}

impl Figures {
    /// Figures of the `selected` forces of `model`.
    ///
    /// # Errors
    /// A value that is no plain number or outside its domain, with its place.
    pub(crate) fn of(
        model: &Model,
        selected: &Selected,
        limbs: &Limbs,
        mass: Option<&Mass>,
        stance: &Stance,
    ) -> Result<Self, Fault> {
        let pressed = pressed(&loaded_spheres(model, &selected.forces)?)?;
        let gravity =
            stance.gravity_m_s2.or(model.gravity()).filter(|&gravity| gravity > 0.0 && gravity.is_finite());
        let speed = stance.impact_speed_m_s.or_else(|| default_speed(&pressed, gravity));
        let weight =
            mass.zip(gravity).map(|(mass, gravity)| Weight { mass_kg: mass.kg, gravity_m_s2: gravity });
        let groups = groups(limbs, &pressed);
        let mut without = match (mass, gravity) {
            (None, _) => Some("what the model weighs is not known".to_owned()),
            (_, None) => Some("the model has no gravity".to_owned()),
            _ => None,
        };
        let mut figures = Vec::new();
        for group in groups {
            let count = sphere_count(limbs, &group, stance);
            if count.is_none() && without.is_none() {
                without = limbs_unknown(limbs);
            }
            let limb = Stand { model, members: &group.members, count, weight, speed };
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

    /// No figures, and why.
    pub(crate) fn absent(why: String) -> Self {
        Self {
            mass_kg: None,
            gravity_m_s2: None,
            impact_speed_m_s: None,
            without_weight: Some(why),
            limbs: Vec::new(),
        }
    }

    /// Every sphere.
    pub(crate) fn spheres(&self) -> impl Iterator<Item = &SphereFigures> {
        self.limbs.iter().flat_map(|limb| &limb.spheres)
    }
}

impl LimbFigures {
    /// `true` where the spheres differ, so that level figures say something of their own.
    pub(crate) fn is_mixed(&self) -> bool {
        let differs = |load: &LoadFigures| match (load.hertz, load.level_hertz) {
            (Some(equal), Some(level)) => (equal - level).abs() > 1e-9 * equal.abs(),
            _ => false,
        };
        self.spheres.iter().any(|sphere| sphere.loads.iter().any(differs))
    }
}

impl SphereFigures {
    /// The figures under `body_weights`.
    pub(crate) fn load(&self, body_weights: f64) -> Option<&LoadFigures> {
        self.loads.iter().find(|load| load.body_weights == body_weights)
    }
}

struct Group<'p> {
    name: Option<String>,
    side: Option<&'static str>,
    members: Vec<&'p Pressed>,
}

/// √(gR/2) with R = √(Σ R_i²/n) of all spheres.
fn default_speed(pressed: &[Pressed], gravity: Option<f64>) -> Option<f64> {
    let radii: Vec<f64> = pressed.iter().map(|one| one.radius_m).collect();
    let radius = mixed_radii::mean_square(&radii).ok()?.sqrt();
    restitution::drop_speed(gravity?, radius).ok()
}

/// The spheres of each limb; all together where limbs are not known.
fn groups<'p>(limbs: &Limbs, pressed: &'p [Pressed]) -> Vec<Group<'p>> {
    let Some(limbs) = limbs.known() else {
        let members: Vec<&Pressed> = pressed.iter().collect();
        let none = members.is_empty();
        let group = Group { name: None, side: None, members };
        return if none { Vec::new() } else { vec![group] };
    };
    let of_limb = |spheres: &[usize]| pressed.iter().filter(|one| spheres.contains(&one.sphere)).collect();
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

fn limbs_unknown(limbs: &Limbs) -> Option<String> {
    match limbs {
        Limbs::Unknown(why) => {
            Some(format!("how many spheres share the weight is not known ({why}); say it with --spheres N"))
        }
        Limbs::Known(_) => None,
    }
}

/// E* of a sphere and a plane of one material, from its `stiffness` (A.4), N/m².
pub(crate) fn composite_of(stiffness_n_m2: f64) -> f64 {
    stiffness_n_m2 / EQUAL_SURFACES
}
