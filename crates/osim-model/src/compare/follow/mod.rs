//! Contacts that follow a body which OpenSim has scaled: what its bones say about the factors, and where its spheres
//! belong.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. Comparing the scaled model with the generic
//! one it came from gives each body's factors ([`Factors`]); spheres of the same name then move and grow with their body
//! ([`Follow`]).

mod body_factors;
mod factors;
mod scaled_copy;
mod sources;

use std::collections::BTreeMap;

use crate::model::{
    Anatomy, AnatomySphere, Fault, LevelAxis, Model, MovedSpheres, Needed, RadiusAxis, SphereId,
};
pub use body_factors::{AxisFactor, BodyFactors, FactorSource, bone_of_mesh};
pub use factors::Factors;
pub use scaled_copy::{CopyDifference, ScaleFile};

// Where the spheres of a scaled model belong, and how large they are there.

/// A location or radius that differs by less than this (relative to the radius) was not touched.
const UNTOUCHED: f64 = 1e-6;

/// Radii that do not follow from the factors of bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OwnRadii {
    /// As large against the body as in the reference (8): its radii times this.
    Isometric(f64),
    /// All are this, m.
    Metres(f64),
}

/// How spheres follow their bodies: see [`Follow`] for an example.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FollowRequest {
    /// How a radius follows from the three factors of its body.
    pub radius_axis: RadiusAxis,
    /// The axis along which bottoms stay on the scaled sole; `None`: centres are scaled, whatever the radius.
    pub level: Option<LevelAxis>,
    /// What to do with spheres that were changed already.
    pub moved: MovedSpheres,
    /// Whether radii stay as they are in the scaled model.
    pub keep_radii: bool,
    /// Radii that do not follow from factors; where there are none, `radius_axis` counts.
    pub own_radii: Option<OwnRadii>,
}

/// The new place and radius of one sphere: from [`Follow::sphere`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedSphere {
    /// Radius in the reference, m.
    pub old_radius_m: f64,
    /// New radius, m.
    pub radius_m: f64,
    /// New location in its frame, m.
    pub location_m: [f64; 3],
}

/// New places and radii of the spheres of a model that OpenSim has scaled.
///
/// ```
/// use std::collections::BTreeMap;
/// use osim_model::{Anatomy, Model};
/// use osim_model::compare::{Factors, Follow, FollowRequest};
/// use osim_model::{RadiusAxis, moving_spheres};
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// // OpenSim scales bones and leaves contact spheres as they were: 0.03 m at (0.05, -0.01, 0) m.
/// let text = text.replace("<radius>", "<location>0.05 -0.01 0</location><radius>");
/// let scaled = Model::parse(text.as_str())?;
/// let spheres = moving_spheres(&scaled, &scaled.force_ids());
/// # let generic = Model::parse(text.as_str())?;
/// let (here, there) = (Anatomy::of(&scaled)?, Anatomy::of(&generic)?);
///
/// // The foot is twice as long; the caller says so.
/// let given = BTreeMap::from([("foot_r".to_owned(), [2.0, 1.0, 1.0])]);
/// let factors = Factors::find(&here, &there, None, &given)?;
/// let mut request = FollowRequest::default();
/// request.radius_axis = RadiusAxis::X;
/// let follow = Follow::find(&scaled, &spheres, &here, &there, &factors, &request)?;
///
/// let heel = follow.sphere(spheres[0]).expect("it stands on the foot");
/// assert_eq!((heel.radius_m, heel.location_m), (0.06, [0.1, -0.01, 0.0]));
/// # Ok::<(), osim_model::Fault>(())
/// ```
///
/// A transfer writes them.
#[derive(Debug, Clone, PartialEq)]
pub struct Follow {
    spheres: BTreeMap<SphereId, FollowedSphere>,
    /// Geometric mean of the factors of the bodies that carry spheres: the ratio of sizes, new over old.
    pub size_ratio: f64,
}

impl Follow {
    /// Radius of `sphere` in the reference, m; `None` where it does not follow a body.
    pub fn old_radius(&self, sphere: SphereId) -> Option<f64> {
        self.spheres.get(&sphere).map(|followed| followed.old_radius_m)
    }

    /// Every sphere that follows a body, with its new place.
    pub fn spheres(&self) -> impl Iterator<Item = (SphereId, &FollowedSphere)> {
        self.spheres.iter().map(|(sphere, place)| (*sphere, place))
    }

    /// The new place of `sphere`; `None` where it does not follow a body.
    pub fn sphere(&self, sphere: SphereId) -> Option<&FollowedSphere> {
        self.spheres.get(&sphere)
    }

    /// Checks that every contact sphere of the `reference`, by name, is in the scaled model.
    pub fn refuse_missing<'n>(
        scaled: &Anatomy,
        reference: impl Iterator<Item = &'n String>,
    ) -> Result<(), Fault> {
        let mut missing: Vec<&str> =
            reference.map(String::as_str).filter(|name| scaled.sphere(name).is_none()).collect();
        missing.dedup();
        if missing.is_empty() {
            return Ok(());
        }
        Err(Fault::refused(format!(
            "these spheres of the reference are not in the scaled model: {}",
            missing.join(", ")
        )))
    }

    /// Matches the spheres `wanted` of `model` with those of the reference by name and moves them with their bodies.
    ///
    /// # Errors
    /// A sphere that has no counterpart of its name in `generic`, is on another body there, or was moved already
    /// ([`Needed::MovedSpheres`]); a body whose factors are not known ([`Needed::BodyFactors`]).
    pub fn find(
        model: &Model,
        wanted: &[SphereId],
        scaled: &Anatomy,
        generic: &Anatomy,
        factors: &Factors,
        request: &FollowRequest,
    ) -> Result<Self, Fault> {
        let mut spheres = BTreeMap::new();
        let (mut logarithms, mut count) = (0.0, 0.0);
        refuse_unmatched(model, wanted, generic)?;
        refuse_moved(model, wanted, scaled, generic, request.moved)?;
        for &id in wanted {
            let (Some(now), Some(own)) = (scaled.spheres.get(id.index()), model.sphere(id)) else {
                continue;
            };
            let Some(old) = generic.sphere(&now.name) else { continue };
            if old.body != now.body {
                return Err(Fault::refused(format!(
                    "sphere {} is on {} here and on {} in the reference, expected the same body",
                    own.path,
                    now.body.as_deref().unwrap_or("ground"),
                    old.body.as_deref().unwrap_or("ground")
                )));
            }
            let Some(body) = &old.body else { continue };
            let body_factors =
                factors.body_factors(body).map_err(|fault| fault.at_element(own.path.clone()))?;
            let [x, y, z] = body_factors;
            logarithms += libm::log(x * y * z) / 3.0;
            count += 1.0;
            let place = if request.moved == MovedSpheres::Keep && differs(now, old) {
                FollowedSphere {
                    old_radius_m: old.radius_m,
                    radius_m: now.radius_m,
                    location_m: now.location_m,
                }
            } else {
                follow_one(now, old, body_factors, request)
            };
            spheres.insert(id, place);
        }
        let size_ratio = if count > 0.0 { libm::exp(logarithms / count) } else { 1.0 };
        Ok(Self { spheres, size_ratio })
    }
}

fn follow_one(
    now: &AnatomySphere,
    old: &AnatomySphere,
    factors: [f64; 3],
    request: &FollowRequest,
) -> FollowedSphere {
    let times = |ratio: f64| if ratio == 1.0 { old.radius_m } else { old.radius_m * ratio };
    let radius_m = match request.own_radii {
        _ if request.keep_radii => now.radius_m,
        Some(OwnRadii::Metres(metres)) => metres,
        Some(OwnRadii::Isometric(ratio)) => times(ratio),
        None => times(request.radius_axis.radius_ratio(factors)),
    };
    // The frame of the scaled model: OpenSim moves it but does not turn it.
    let scaled = |vector: [f64; 3]| now.rotation.scaled_in_frame(factors, vector);
    let location_m = match request.level {
        Some(axis) => {
            axis.in_frame(&now.rotation).levelled_centre(old.location_m, old.radius_m, radius_m, scaled)
        }
        None => scaled(old.location_m),
    };
    FollowedSphere { old_radius_m: old.radius_m, radius_m, location_m }
}

/// Whether the scaled model's sphere is no longer as in the generic model.
fn differs(now: &AnatomySphere, old: &AnatomySphere) -> bool {
    let limit = UNTOUCHED * old.radius_m;
    let moved = now.location_m.iter().zip(old.location_m).any(|(now, old)| (now - old).abs() > limit);
    moved || (now.radius_m - old.radius_m).abs() > limit
}

fn refuse_unmatched(model: &Model, wanted: &[SphereId], generic: &Anatomy) -> Result<(), Fault> {
    let names = wanted.iter().filter_map(|&id| model.sphere(id)).map(|sphere| &sphere.name);
    if let Some(name) = names.into_iter().find(|name| generic.has_several_spheres(name)) {
        return Err(Fault::refused(format!("the reference has several spheres called {name}: expected one")));
    }
    let unmatched: Vec<&str> = wanted
        .iter()
        .filter_map(|&id| model.sphere(id))
        .filter(|sphere| generic.sphere(&sphere.name).is_none())
        .map(|sphere| sphere.name.as_str())
        .collect();
    if unmatched.is_empty() {
        return Ok(());
    }
    let reference_names: Vec<&str> = generic.spheres.iter().map(|sphere| sphere.name.as_str()).collect();
    Err(Fault::refused(format!(
        "the reference has no spheres with these names: {}; it has {}",
        unmatched.join(", "),
        if reference_names.is_empty() { "none".to_owned() } else { reference_names.join(", ") }
    )))
}

fn refuse_moved(
    model: &Model,
    wanted: &[SphereId],
    scaled: &Anatomy,
    generic: &Anatomy,
    moved: MovedSpheres,
) -> Result<(), Fault> {
    if moved != MovedSpheres::Refuse {
        return Ok(());
    }
    let changed: Vec<&str> = wanted
        .iter()
        .filter_map(|&id| scaled.spheres.get(id.index()))
        .filter(|now| generic.sphere(&now.name).is_some_and(|old| differs(now, old)))
        .map(|now| now.name.as_str())
        .collect();
    if changed.is_empty() {
        return Ok(());
    }
    let spheres = changed.into_iter().map(str::to_owned).collect();
    Err(Fault::new(Needed::MovedSpheres { model: model.name.clone(), spheres }))
}
