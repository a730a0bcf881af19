//! Moves contact spheres after OpenSim has scaled their bodies: finds the scale factors of the bodies, and the new places of the spheres.
//!
//! OpenSim's scaling leaves `ContactSphere` radius and location as they were. Comparing the scaled model with the generic model gives the
//! factors of each body ([`Factors`]); spheres of the same name then move and grow with their body ([`Follow`]).

mod body_factors;
mod scale_file;
mod scaled_copy;
mod sources;

use std::collections::BTreeMap;

use foldhash::HashSet;

use crate::messages::Phrase;
use crate::model::{
    Anatomy, AnatomySphere, Fault, FaultKind, Finding, LevelAxis, MissingFact, Model, MovedSpheres,
    RadiusAxis, Result, SphereId, rules,
};

use body_factors::{AXIS_NAMES, BodyIndex, ComparedJoints};
pub use body_factors::{AxisFactor, BodyFactors, FactorSource, bone_of_mesh};
pub use scale_file::ScaleFile;
pub use scaled_copy::CopyDifference;
use sources::BodyFactorSources;

// Where the spheres of a scaled model belong, and how large they are there.

/// If a location or radius changed by less than this part of the radius, nobody edited it.
const LARGEST_SHIFT_OF_UNTOUCHED_RADII: f64 = 1e-6;

/// Rules for radii that do not use the factors of bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OwnRadii {
    /// The reference's radii times this factor: as large against the body as in the reference, (8).
    Isometric(f64),
    /// One radius for all spheres, m.
    Metres(f64),
}

/// The options for moving spheres with their bodies: see [`Follow`] for an example.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FollowRequest {
    /// The rule that makes one ratio of radii from the three factors of a body.
    pub radius_axis: RadiusAxis,
    /// The axis along which the bottom of each sphere stays on the scaled sole. `None`: the centre is scaled with the body, whatever the
    /// radius.
    pub level: Option<LevelAxis>,
    /// Whether the centres of ellipsoids are scaled with their bodies although `level` is given; else they are refused.
    pub spares_ellipsoids: bool,
    /// What to do with spheres that somebody has already moved or resized.
    pub moved: MovedSpheres,
    /// Whether spheres keep the radii that they have in the scaled model.
    pub keep_radii: bool,
    /// A rule for radii without the factors of bodies. `None`: `radius_axis` decides.
    pub own_radii: Option<OwnRadii>,
}

/// The new place and radius of one sphere that follows its body: from [`Follow::sphere`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedSphere {
    /// Radius of the sphere in the reference model, m.
    pub old_radius_m: f64,
    pub radius_m: f64,
    /// New location of the sphere in its frame, m.
    pub location_m: [f64; 3],
}

/// The new places and radii of spheres in a model that OpenSim has scaled.
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
/// [`Follow`] changes no file: a transfer writes the places and radii.
#[derive(Debug, Clone, PartialEq)]
pub struct Follow {
    spheres: BTreeMap<SphereId, FollowedSphere>,
    /// Geometric mean of the factors of all bodies with spheres: the new size over the old size.
    pub size_ratio: f64,
    /// Whether any sphere was placed: others stay where they were moved to.
    pub is_placed: bool,
    /// Whether radii follow from the factors of bodies.
    pub has_radii_of_bodies: bool,
}

impl Follow {
    /// Radius of `sphere` in the reference, m; `None` for a sphere that does not follow a body.
    pub fn old_radius(&self, sphere: SphereId) -> Option<f64> {
        self.spheres.get(&sphere).map(|followed| followed.old_radius_m)
    }

    /// Every sphere that follows a body, with its new place and radius.
    pub fn spheres(&self) -> impl Iterator<Item = (SphereId, &FollowedSphere)> {
        self.spheres.iter().map(|(sphere, place)| (*sphere, place))
    }

    /// The new place and radius of `sphere`; `None` for a sphere that does not follow a body.
    pub fn sphere(&self, sphere: SphereId) -> Option<&FollowedSphere> {
        self.spheres.get(&sphere)
    }

    /// Checks that the scaled model has every contact sphere of the `reference`, by its name.
    pub fn refuse_missing<'n>(scaled: &Anatomy, reference: impl Iterator<Item = &'n String>) -> Result<()> {
        let mut missing: Vec<&str> =
            reference.map(String::as_str).filter(|name| scaled.sphere(name).is_none()).collect();
        missing.dedup();
        if missing.is_empty() {
            return Ok(());
        }
        Err(Fault::refused(format!(
            "these spheres of the reference are not in the scaled model: {}: was it scaled from another one?",
            missing.join(", ")
        )))
    }

    /// Matches the spheres `wanted` of `model` with the reference's spheres of the same name, and moves them with their bodies.
    ///
    /// # Errors
    /// A sphere without a sphere of its name in `generic`, or on another body than there; a sphere that somebody has moved already
    /// ([`MissingFact::MovedSpheres`]); a body without known factors ([`MissingFact::BodyFactors`]).
    pub fn find(
        model: &Model,
        wanted: &[SphereId],
        scaled: &Anatomy,
        generic: &Anatomy,
        factors: &Factors,
        request: &FollowRequest,
    ) -> Result<Self> {
        let (mut spheres, mut moved) = (BTreeMap::new(), Vec::new());
        let (mut logarithms, mut count, mut is_placed) = (0.0, 0.0, false);
        refuse_unmatched_spheres(model, wanted, generic)?;
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
            let level = match own.round_radius_m() {
                Err(fault) if request.level.is_some() && !request.spares_ellipsoids => return Err(fault),
                round => request.level.filter(|_| round.is_ok()),
            };
            let body_factors =
                factors.body_factors(body).map_err(|fault| fault.at_element(own.path.clone()))?;
            let [x, y, z] = body_factors;
            logarithms += libm::log(x * y * z) / 3.0;
            count += 1.0;
            let is_changed = !now.is_as_in(old);
            let place = if request.moved == MovedSpheres::Keep && is_changed {
                let (radius_m, location_m) = (now.radius_m, now.location_m);
                FollowedSphere { old_radius_m: old.radius_m, radius_m, location_m }
            } else {
                is_placed = true;
                moved_sphere(now, old, body_factors, level, request)
            };
            // After a transfer they are at their right places.
            let followed =
                AnatomySphere { radius_m: place.radius_m, location_m: place.location_m, ..now.clone() };
            if request.moved == MovedSpheres::Refuse && is_changed && !now.is_as_in(&followed) {
                moved.push(now.name.clone());
            }
            spheres.insert(id, place);
        }
        if !moved.is_empty() {
            return Err(Fault::new(MissingFact::MovedSpheres { model: model.name.clone(), spheres: moved }));
        }
        let size_ratio = if count > 0.0 { libm::exp(logarithms / count) } else { 1.0 };
        let has_radii_of_bodies = !request.keep_radii && request.own_radii.is_none();
        Ok(Self { spheres, size_ratio, is_placed, has_radii_of_bodies })
    }
}

fn moved_sphere(
    now: &AnatomySphere,
    old: &AnatomySphere,
    factors: [f64; 3],
    level: Option<LevelAxis>,
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
    let location_m = match level {
        Some(axis) => {
            axis.in_frame(&now.rotation).levelled_centre(old.location_m, old.radius_m, radius_m, scaled)
        }
        None => scaled(old.location_m),
    };
    FollowedSphere { old_radius_m: old.radius_m, radius_m, location_m }
}

impl AnatomySphere {
    /// Whether a sphere of a scaled model has the same place and radius as the sphere of the `generic` model.
    pub(crate) fn is_as_in(&self, generic: &Self) -> bool {
        let place_limit_m = (LARGEST_SHIFT_OF_UNTOUCHED_RADII * generic.radius_m).max(self.rounding_m);
        let mut axes = self.location_m.iter().zip(generic.location_m);
        axes.all(|(here, was)| (here - was).abs() <= place_limit_m) && self.has_radius_of(generic)
    }

    /// Whether a sphere of a scaled model has the radius of the sphere of the `generic` model.
    pub(crate) fn has_radius_of(&self, generic: &Self) -> bool {
        (self.radius_m - generic.radius_m).abs() <= LARGEST_SHIFT_OF_UNTOUCHED_RADII * generic.radius_m
    }
}

fn refuse_unmatched_spheres(model: &Model, wanted: &[SphereId], generic: &Anatomy) -> Result<()> {
    let names = || wanted.iter().filter_map(|&id| model.sphere(id)).map(|sphere| &sphere.name);
    if let Some(name) = names().find(|name| generic.has_several_spheres(name)) {
        return Err(Fault::refused(format!("the reference has several spheres called {name}: expected one")));
    }
    let unmatched: Vec<&str> =
        names().filter(|name| generic.sphere(name).is_none()).map(String::as_str).collect();
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

/// The factors of all bodies of a model against a reference: new lengths over old lengths.
///
/// If the model is a scaled copy of the reference, it has no [`difference`](Self::difference), and the factors are exact. Each axis takes
/// the first source that has a factor: the caller, the Scale Tool's file, meshes, joint offsets. Between different models, joint offsets
/// are not factors: a body takes the ratio of the mesh factors of one bone, or one ratio of distances to a joint below the body. A body at
/// the end of a limb without a source takes the factors of its parent body. Left and right take the same source.
///
/// ```
/// use std::collections::BTreeMap;
/// use osim_model::{Anatomy, Document, Model};
/// use osim_model::compare::{FactorSource, Factors, ScaleFile};
///
/// # let bytes: &[u8] = include_bytes!("../../../tests/data/one_foot.osim");
/// // The file in which the Scale Tool says what it did: foot_r is 1.2 times as long.
/// let text = r#"<OpenSimDocument Version="40000"><ScaleSet><objects><Scale>
///     <scales>1.2 1.1 1</scales><segment>foot_r</segment><apply>true</apply>
/// </Scale></objects></ScaleSet></OpenSimDocument>"#;
/// let file = ScaleFile::read(&Document::parse(text)?)?;
///
/// // The model here has no meshes and no joints, which would say the same.
/// let anatomy = Anatomy::of(&Model::parse(bytes)?)?;
/// let factors = Factors::find(&anatomy, &anatomy, Some(&file), &BTreeMap::new())?;
/// assert_eq!(factors.body_factors("foot_r")?, [1.2, 1.1, 1.0]);
/// assert_eq!(factors.bodies[0].axes[0].map(|axis| axis.source), Some(FactorSource::ScaleFile));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Factors {
    /// Scale factors of the bodies, in file order of the scaled model.
    pub bodies: Vec<BodyFactors>,
    /// Warnings: the sources of a body with spheres disagree, by more than 1 % in a scaled copy or 5 % between different models; or the
    /// models are different.
    pub findings: Vec<Finding>,
    /// Remarks on other decisions, such as a body that takes the factors of its parent.
    pub remarks: Vec<Phrase>,
    /// The first difference that proves that the model is not a scaled copy of the reference; `None` for a scaled copy.
    pub difference: Option<CopyDifference>,
    by_name: BodyIndex,
}

impl Factors {
    /// Compares `scaled` with the `reference`. `given` has factors along x, y and z by body name; these are preferred to all other sources.
    ///
    /// # Errors
    /// Factors are given for a body that the model does not have, or the file was applied to another model than the reference.
    pub fn find(
        scaled: &Anatomy,
        reference: &Anatomy,
        file: Option<&ScaleFile>,
        given: &BTreeMap<String, [f64; 3]>,
    ) -> Result<Self> {
        if let Some(name) = given.keys().find(|name| !scaled.has_body(name)) {
            return Err(Fault::new(FaultKind::UnknownBody { body: name.clone() }));
        }
        let carriers = bodies_with_spheres(scaled, reference);
        if let Some(file) = file {
            file.refuse_other_reference(scaled, reference, &carriers)?;
        }
        let difference = scaled_copy::first_difference(scaled, reference);
        let distances = difference.as_ref().map(|_| ComparedJoints::of(scaled, reference));
        let all_sources: Vec<BodyFactorSources> = scaled
            .bodies
            .iter()
            .map(|body| {
                BodyFactorSources::of(scaled, reference, body, file, given.get(body), distances.as_ref())
            })
            .collect();
        let mut factors = Self { difference, ..Self::default() };
        let taken = sources::choose_factors(&all_sources);
        for (sources, axes) in all_sources.iter().zip(taken) {
            factors.bodies.push(BodyFactors {
                body: sources.body.to_owned(),
                axes,
                sources: sources.by_source.clone(),
                why_unknown: None,
            });
        }
        factors.by_name = BodyIndex::of(&factors.bodies);
        if let Some(difference) = &factors.difference {
            factors.findings.push(rules::not_a_scaled_copy(difference.phrase()));
            factors.remarks =
                sources::inherit_from_body_above(&mut factors.bodies, &factors.by_name, scaled, &carriers);
            sources::withdraw_doubtful_factors(&mut factors.bodies, &factors.by_name, &all_sources, scaled);
        }
        factors.refuse_impossible_factors();
        let carrying: HashSet<&str> = carriers.into_iter().collect();
        for sources in all_sources.iter().filter(|sources| carrying.contains(&sources.body)) {
            let messages =
                sources.disagreements(&factors.by_name.axes_of_body(&factors.bodies, sources.body));
            let finding = |message: String| Finding::new(&rules::FACTORS_DISAGREE, message);
            factors.findings.extend(messages.into_iter().map(finding));
        }
        Ok(factors)
    }

    /// Takes back the factors of each body with an impossible one, such as 0.
    fn refuse_impossible_factors(&mut self) {
        for body in &mut self.bodies {
            let bad = AXIS_NAMES.iter().zip(body.axes).find_map(|(name, axis)| {
                let AxisFactor { factor, source } = axis?;
                (!(factor.is_finite() && factor > 0.0)).then_some((name, factor, source))
            });
            let Some((name, factor, source)) = bad else { continue };
            body.why_unknown = Some(Fault::refused(format!(
                "the {name} factor of body {} is {factor} ({}), expected a finite number above 0",
                body.body,
                source.as_str()
            )));
            body.axes = [None; 3];
        }
    }

    /// The scale factors of `body` along x, y and z.
    ///
    /// # Errors
    /// - No source gives the factor of an axis ([`MissingFact::BodyFactors`]): the error names the body and the axis.
    /// - The models are different, and the factors of the body are in doubt ([`MissingFact::Factors`]).
    /// - A factor that is zero, negative or not finite.
    pub fn body_factors(&self, body: &str) -> Result<[f64; 3]> {
        let found = self.by_name.index_of(body).and_then(|at| self.bodies.get(at));
        if let Some(why) = found.and_then(|found| found.why_unknown.clone()) {
            return Err(why);
        }
        let axes = self.by_name.axes_of_body(&self.bodies, body);
        let missing: Vec<&str> =
            AXIS_NAMES.iter().zip(&axes).filter(|(_, axis)| axis.is_none()).map(|(name, _)| *name).collect();
        match axes {
            [Some(x), Some(y), Some(z)] => Ok([x.factor, y.factor, z.factor]),
            _ => Err(Fault::new(MissingFact::BodyFactors { body: body.to_owned(), axes: missing })),
        }
    }
}

/// Bodies of `scaled` that carry spheres in either model. Only their factors matter.
fn bodies_with_spheres<'a>(scaled: &'a Anatomy, reference: &'a Anatomy) -> Vec<&'a str> {
    let spheres = scaled.spheres.iter().chain(&reference.spheres);
    let carrying: HashSet<&str> = spheres.filter_map(|sphere| sphere.body.as_deref()).collect();
    scaled.bodies.iter().map(String::as_str).filter(|body| carrying.contains(body)).collect()
}
