//! The figures of a model's contacts, as data.

use osim_model::wording::{Dialect, Phrase};
use schemars::JsonSchema;
use serde::Serialize;

use super::limit_check::{Figure, LimitCheck};
use crate::serialized::optional_phrase;

/// The loads that are looked at, in body weights.
pub(super) const BODY_WEIGHTS: [f64; 2] = [1.0, 2.0];

/// Figures of one model.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct Figures {
    /// Mass whose weight the spheres carry: what the model weighs, else the mass that its contacts are made for, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that was taken, m/s²: the model's own as a rule; `None` without gravity.
    pub gravity_m_s2: Option<f64>,
    /// Speed before an impact, m/s: given, or √(gR/2) with R = √(Σ R_i²/n) of all spheres, as in a drop test.
    pub impact_speed_m_s: Option<f64>,
    /// Why figures under body weight are absent, in words.
    #[serde(serialize_with = "optional_phrase")]
    #[schemars(with = "Option<String>")]
    pub without_weight: Option<Phrase>,
    /// Each limb; one entry without a name where limbs are not known.
    pub limbs: Vec<LimbFigures>,
}

/// Figures of one limb.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct LimbFigures {
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
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct SphereFigures {
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
    pub limits: Vec<LimitCheck>,
}

/// One sphere under one load.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[non_exhaustive]
pub struct LoadFigures {
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
    /// No figures, and why.
    pub(crate) fn absent(why: Phrase) -> Self {
        Self {
            mass_kg: None,
            gravity_m_s2: None,
            impact_speed_m_s: None,
            without_weight: Some(why),
            limbs: Vec::new(),
        }
    }

    /// Every sphere.
    pub fn spheres(&self) -> impl Iterator<Item = &SphereFigures> {
        self.limbs.iter().flat_map(|limb| &limb.spheres)
    }

    /// Spells what they say in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.without_weight.iter_mut().for_each(|why| why.spell(dialect));
    }
}

impl LimbFigures {
    /// `true` where the spheres differ, so that level figures say something of their own.
    #[must_use]
    pub fn is_mixed(&self) -> bool {
        let differs = |load: &LoadFigures| match (load.hertz, load.level_hertz) {
            (Some(equal), Some(level)) => (equal - level).abs() > 1e-9 * equal.abs(),
            _ => false,
        };
        self.spheres.iter().any(|sphere| sphere.loads.iter().any(differs))
    }
}

impl SphereFigures {
    /// The figures under `body_weights`.
    #[must_use]
    pub fn load(&self, body_weights: f64) -> Option<&LoadFigures> {
        self.loads.iter().find(|load| load.body_weights == body_weights)
    }

    /// Whether `figure` is within its limit; `None` where it is not known.
    #[must_use]
    pub fn is_within(&self, figure: Figure) -> Option<bool> {
        self.limits.iter().find(|check| check.figure == figure).map(|check| check.within_limit)
    }
}
