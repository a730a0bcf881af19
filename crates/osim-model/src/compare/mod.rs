//! Compares two OpenSim models: the scale factors of their bodies, whether one model is a scaled copy of the other, and the right places of
//! the contact spheres in a scaled model.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. [`Factors`] gives the growth of each body, [`Follow`] the
//! right places of its spheres, and [`SpherePlacements`] checks the present places: whether
//! spheres are where the scaling of their bodies moves them, compared with the unscaled model.
//!
//! ```
//! use std::collections::BTreeMap;
//! use osim_model::compare::Factors;
//! use osim_model::{Anatomy, Model};
//!
//! let bytes: &[u8] = include_bytes!("../../tests/data/one_foot.osim");
//! let anatomy = Anatomy::of(&Model::parse(bytes)?)?;
//! let given = BTreeMap::from([("foot_r".to_owned(), [1.2, 1.1, 1.0])]);
//! let factors = Factors::find(&anatomy, &anatomy, None, &given)?;
//! assert_eq!(factors.body_factors("foot_r")?, [1.2, 1.1, 1.0]);
//! # Ok::<(), osim_model::Fault>(())
//! ```
//!
//! # What it will not do
//!
//! This module makes plans and changes nothing. It knows no files, no options and no terminal.

mod follow;
mod similarity;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::DVec3;

use crate::messages::{Input, Phrase, Verb};
use crate::model::{
    Anatomy, AnatomySphere, Fault, LevelAxis, Model, Note, RadiusAxis, Result, SphereId, Step, TextPosition,
};

pub use follow::{
    AxisFactor, BodyFactors, CopyDifference, FactorSource, Factors, Follow, FollowRequest, FollowedSphere,
    OwnRadii, ScaleFile, bone_of_mesh,
};
pub use similarity::{
    ComparedFactors, LengthFrom, ModelSize, Similarity, SimilarityRow, SizeRatios, SizeVerdict, Spread,
    moco_bounds, refuse_without_moco_phase, similarity_formula,
};

/// Two places are equal if they differ by no more than this, m.
const SAME_PLACE_M: f64 = 1e-6;
/// Factors that somebody typed with three digits differ by up to this (relative) from those of the bones.
const ROUNDING_OF_FACTORS: f64 = 1e-3;
/// If the y factor of a foot differs from √(x z) by more than this (relative), `rescale --follow-bodies` should not keep spheres on the
/// scaled sole (`level`).
const MOST_STRETCH_FOR_LEVEL: f64 = 0.2;

/// The spheres of a scaled model, compared with those of the unscaled model: from [`SpherePlacements::compare`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SpherePlacements {
    /// Path of the unscaled model, as the caller named it.
    pub from: PathBuf,
    /// Path of the Scale Tool's ScaleSet file, if the caller named one.
    pub body_scale_file: Option<PathBuf>,
    /// Each sphere that both models have on the same body.
    pub spheres: Vec<PlacedSphere>,
    /// A remark on each sphere that is missing in one of the models, or is on another body.
    pub unmatched: Vec<Phrase>,
    /// Why the models cannot be compared, in words.
    pub unknown: Option<Phrase>,
    /// Whether the comparison failed because the caller named a wrong model.
    pub is_wrong_model: bool,
    /// Whether a transfer with `level` is possible: no sphere is an ellipsoid.
    pub suits_level: bool,
    /// Whether, by the note in the model, this program wrote the present radii.
    noted_radii: bool,
}

/// The present place of a sphere and its right place, in the sphere's frame, m.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedSphere {
    pub name: String,
    pub path: String,
    /// Place of the sphere's element.
    pub position: TextPosition,
    pub here_m: [f64; 3],
    /// The right place of the sphere: its place in the unscaled model times the factors of its body; the bottom of a round sphere, whose
    /// radius follows the mass (the body, if a mass is not known), stays on the scaled sole.
    pub belongs_m: [f64; 3],
    /// Whether the sphere is at its right place, or its centre or its bottom is where the scaling takes it.
    pub follows: bool,
    /// Whether place and radius are equal to those in the unscaled model.
    untouched: bool,
    /// Whether the radius is equal to that in the unscaled model.
    has_old_radius: bool,
    radius_m: f64,
    /// Whether the place is equal to the place in the unscaled model.
    pub stayed: bool,
}

impl SpherePlacements {
    /// Compares `model` with the `original` that OpenSim scaled, by the factors in the ScaleSet `file` if it is given. Radii by mass are the
    /// original's times `radius_ratio`; `None` if a mass is not known.
    pub fn compare(
        model: &Model,
        from: &Path,
        body_scale_file: Option<&Path>,
        original: &Anatomy,
        file: Option<&ScaleFile>,
        radius_ratio: Option<f64>,
    ) -> Self {
        let unknown = |why| Self {
            from: from.to_owned(),
            body_scale_file: body_scale_file.map(Path::to_owned),
            unknown: Some(why),
            noted_radii: has_radii_of_note(model),
            ..Self::default()
        };
        let placed = || {
            // Those who only look at a model cannot say factors.
            let in_words = |fault: Fault| {
                let mut why = fault.phrase();
                why.choose_alternatives(&|input| input != Input::BodyScale);
                why
            };
            let scaled = Anatomy::of(model).map_err(in_words)?;
            // Without a common sphere nothing is compared, whatever the bones are.
            let common = |&id: &SphereId| original.sphere(&model.sphere(id)?.name);
            if model.loaded_spheres(&model.force_ids()).iter().all(|id| common(id).is_none()) {
                return Ok((Vec::new(), Vec::new(), false));
            }
            let factors = Factors::find(&scaled, original, file, &BTreeMap::new()).map_err(in_words)?;
            if let Some(difference) = &factors.difference {
                let mut why = difference.phrase();
                why.push("this model is not a scaled copy of that one");
                return Err(why);
            }
            placed_spheres(model, &scaled, original, &factors, radius_ratio).map_err(in_words)
        };
        match placed() {
            Ok((spheres, on_other_bodies, _)) if spheres.is_empty() => {
                let first = on_other_bodies.into_iter().next();
                let why = first.unwrap_or_else(|| "it has no sphere of the same name".into());
                unknown("".into()).of_wrong_model(why)
            }
            Ok((spheres, unmatched, suits_level)) => {
                Self { spheres, suits_level, unmatched, unknown: None, ..unknown("".into()) }
            }
            Err(why) => unknown(why),
        }
    }

    /// A result without a comparison, because the caller named a wrong model: `why` says in which way.
    pub fn of_wrong_model(self, why: Phrase) -> Self {
        Self { spheres: Vec::new(), unmatched: Vec::new(), unknown: Some(why), is_wrong_model: true, ..self }
    }

    /// Whether every sphere is at its right place.
    pub fn is_right(&self) -> bool {
        self.unknown.is_none()
            && self.unmatched.is_empty()
            && self.spheres.iter().all(|sphere| sphere.follows)
    }

    /// Whether a sphere is not at its right place.
    pub fn is_wrong(&self) -> bool {
        self.spheres.iter().any(|sphere| !sphere.follows)
    }

    /// Whether a sphere still has its place from before the scaling, which is wrong now.
    pub fn was_left_behind(&self) -> bool {
        self.spheres.iter().any(|sphere| !sphere.follows && sphere.stayed)
    }

    /// Whether a transfer can place all spheres: the radius of each is unscaled or written by this program, and each stayed, is at its
    /// right place, or is farther from it than its radius. Another radius, or a place nearby, may be meant.
    pub fn can_follow(&self) -> bool {
        let is_movable = |sphere: &PlacedSphere| {
            let is_far = sphere.distance_m() > sphere.radius_m;
            (sphere.has_old_radius || self.noted_radii) && (sphere.stayed || sphere.follows || is_far)
        };
        self.is_wrong() && self.unmatched.is_empty() && self.spheres.iter().all(is_movable)
    }

    /// Whether a sphere has another place or radius than in the unscaled model. A transfer then asks the caller what to do with it.
    pub fn has_changed_spheres(&self) -> bool {
        self.spheres.iter().any(|sphere| !sphere.untouched)
    }
}

impl PlacedSphere {
    /// The distance of the sphere from its right place, m.
    pub fn distance_m(&self) -> f64 {
        DVec3::from(self.here_m).distance(self.belongs_m.into())
    }
}

/// Whether the note says that this program scaled the radii, and nobody has changed them since.
fn has_radii_of_note(model: &Model) -> bool {
    let scales =
        |note: &Note| matches!(note.steps.last().and_then(Step::verb), Some(Verb::Rescale | Verb::Transfer));
    model.note.as_ref().is_some_and(scales) && model.doubt_about_note().is_none()
}

/// A remark on each sphere that is in only one of the models, or on different bodies: its right place is not known.
fn remarks_on_unmatched_spheres(model: &Model, scaled: &Anatomy, original: &Anatomy) -> Vec<Phrase> {
    let loaded = model.loaded_spheres(&model.force_ids());
    let here = loaded.into_iter().filter_map(|id| scaled.spheres.get(id.index()));
    let other = here.filter_map(|now| {
        let (name, body) = (&now.name, now.body.as_ref()?);
        let Some(old) = original.sphere(name) else {
            return Some(format!("{name} is not in the model that was scaled: where it belongs is not known"));
        };
        let was = old.body.as_deref().unwrap_or("ground");
        (was != body).then(|| {
            format!("{name} is on {body}, and on {was} in the model that was scaled: where it belongs is not known")
        })
    });
    let there =
        original.spheres.iter().filter(|old| old.body.is_some() && scaled.sphere(&old.name).is_none());
    let missing = there.map(|old| format!("{} of the model that was scaled is missing here", old.name));
    other.chain(missing).map(Phrase::from).collect()
}

/// Compares the moving spheres that both models have. Returns them, remarks on the other spheres, and whether `level` is possible.
fn placed_spheres(
    model: &Model,
    scaled: &Anatomy,
    original: &Anatomy,
    factors: &Factors,
    radius_ratio: Option<f64>,
) -> Result<(Vec<PlacedSphere>, Vec<Phrase>, bool)> {
    let up = LevelAxis::of_gravity(model.gravity_m_s2);
    let (mut compared, mut suits_level) = (Vec::new(), true);
    for id in model.loaded_spheres(&model.force_ids()) {
        let (Some(sphere), Some(now)) = (model.sphere(id), scaled.spheres.get(id.index())) else { continue };
        let Some(old) = original.sphere(&sphere.name).filter(|old| old.body == now.body) else { continue };
        let Some(body) = &now.body else { continue };
        let of_body = factors.body_factors(body)?;
        suits_level &= sphere.round_radius_m().is_ok();
        compared.push((sphere, now, old, of_body));
    }
    let placed = compared.into_iter().map(|(sphere, now, old, of_body)| {
        let scaled_m = now.rotation.scaled_in_frame(of_body, old.location_m);
        let here_m = now.location_m;
        // As the proposed transfer writes it.
        let by_body = || RadiusAxis::default().radius_ratio(of_body);
        let new_radius_m = old.radius_m * radius_ratio.unwrap_or_else(by_body);
        let is_round = sphere.round_radius_m().is_ok();
        let belongs_m =
            if is_round { centre_on_sole(now, old, (of_body, new_radius_m), up) } else { scaled_m };
        // A radius that changes later leaves the place as it is.
        let on_sole = |radius_m| centre_on_sole(now, old, (of_body, radius_m), up);
        let (of_radius_m, of_old_radius_m) = (on_sole(now.radius_m), on_sole(old.radius_m));
        let expected_m = [scaled_m, belongs_m, of_radius_m];
        let is_at = |place_m: [f64; 3], tolerance_m| {
            here_m.iter().zip(place_m).all(|(a, b)| (a - b).abs() <= tolerance_m)
        };
        let rounding_m = SAME_PLACE_M.max(now.rounding_m);
        let of_factors_m = ROUNDING_OF_FACTORS * DVec3::from(scaled_m).length();
        // A place with all its digits is no other place rounded.
        let of_place_m = if is_at(old.location_m, SAME_PLACE_M) { SAME_PLACE_M } else { rounding_m };
        let tolerance_m = of_factors_m.max(of_place_m);
        let stayed = is_at(old.location_m, rounding_m);
        let is_of_radius_between = || {
            let ends = of_radius_m.into_iter().zip(of_old_radius_m);
            here_m
                .iter()
                .zip(ends)
                .all(|(here, (a, b))| (a.min(b) - tolerance_m..=a.max(b) + tolerance_m).contains(here))
        };
        PlacedSphere {
            name: sphere.name.clone(),
            path: sphere.path.clone(),
            position: sphere.position,
            here_m,
            belongs_m,
            follows: expected_m.into_iter().any(|place_m| is_at(place_m, tolerance_m))
                || (!stayed && is_of_radius_between()),
            untouched: now.is_as_in(old),
            has_old_radius: now.has_radius_of(old),
            radius_m: now.radius_m,
            stayed,
        }
    });
    Ok((placed.collect(), remarks_on_unmatched_spheres(model, scaled, original), suits_level))
}

/// Whether a foot was stretched or flattened so much that `rescale --follow-bodies` should not keep bottoms of spheres on the scaled sole.
pub fn is_stretched([x, y, z]: [f64; 3]) -> bool {
    (y / (x * z).sqrt() - 1.0).abs() > MOST_STRETCH_FOR_LEVEL
}

/// The centre of a sphere whose bottom stays on the sole, after its body was scaled by the factors.
fn centre_on_sole(
    now: &AnatomySphere,
    old: &AnatomySphere,
    (factors, radius_m): ([f64; 3], f64),
    up: LevelAxis,
) -> [f64; 3] {
    let scaled = |vector| now.rotation.scaled_in_frame(factors, vector);
    up.in_frame(&now.rotation).levelled_centre(old.location_m, old.radius_m, radius_m, scaled)
}
