//! Where the spheres of a scaled model belong, and how large they are there.

use std::collections::BTreeMap;

use super::anatomy::{Anatomy, AnatomySphere, Rotation, scaled_in_frame};
use super::factors::Factors;
use crate::error::{Fault, FaultKind};
use crate::model::Model;

/// A location or radius that differs by less than this (relative to the radius) was not touched.
const UNTOUCHED: f64 = 1e-6;

/// Two axes this close to up (difference of their cosines) are equally near.
const TIE: f64 = 1e-9;

/// How a radius follows from three factors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RadiusAxis {
    /// One axis.
    X,
    /// One axis.
    Y,
    /// One axis.
    Z,
    /// The cube root of their product.
    #[default]
    GeometricMean,
    /// The smallest.
    Min,
    /// The largest.
    Max,
}

impl RadiusAxis {
    fn of(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::X => x,
            Self::Y => y,
            Self::Z => z,
            // Three equal factors are their own mean, to the last bit.
            Self::GeometricMean if x == y && y == z => x,
            Self::GeometricMean => libm::cbrt(x * y * z),
            Self::Min => x.min(y).min(z),
            Self::Max => x.max(y).max(z),
        }
    }
}

/// The direction away from the ground, foot flat.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LevelAxis {
    /// 0, 1 or 2.
    pub axis: usize,
    /// The axis points down.
    pub down: bool,
    /// The axis is the body's: each sphere's frame has an axis of its own that is nearest to it.
    pub of_body: bool,
}

impl LevelAxis {
    /// The axis nearest to −gravity; y where a model has no gravity.
    #[must_use]
    pub fn of_gravity(gravity: Option<[f64; 3]>) -> Self {
        let gravity = gravity.unwrap_or([0.0, -1.0, 0.0]);
        let mut axis = 1;
        for (index, value) in gravity.iter().enumerate() {
            if value.abs() > gravity[axis].abs() {
                axis = index;
            }
        }
        Self { axis, down: gravity[axis] > 0.0, of_body: true }
    }

    /// The axis of a frame that is turned by `rotation` in its body.
    pub(crate) fn in_frame(self, rotation: &Rotation) -> Self {
        if !self.of_body {
            return self;
        }
        let sign = if self.down { -1.0 } else { 1.0 };
        // The body's axis in the frame: a row of its rotation. The body's own axis wins a tie.
        let turned: [f64; 3] = rotation[self.axis].map(|value| sign * value);
        let mut axis = self.axis;
        for (index, value) in turned.iter().enumerate() {
            if value.abs() > turned[axis].abs() + TIE {
                axis = index;
            }
        }
        Self { axis, down: turned[axis] < 0.0, of_body: false }
    }

    fn up(self) -> [f64; 3] {
        std::array::from_fn(|index| match index == self.axis {
            true if self.down => -1.0,
            true => 1.0,
            false => 0.0,
        })
    }

    /// Where the centre goes so that the bottom stays on the sole: the bottom point is scaled, the radius is added again.
    pub(crate) fn centre(
        self,
        centre: [f64; 3],
        old_radius: f64,
        new_radius: f64,
        scaled: impl Fn([f64; 3]) -> [f64; 3],
    ) -> [f64; 3] {
        let up = self.up();
        let bottom = std::array::from_fn(|i| centre[i] - old_radius * up[i]);
        let bottom = scaled(bottom);
        std::array::from_fn(|i| bottom[i] + new_radius * up[i])
    }
}

/// What to do with spheres of the scaled model that somebody moved or resized already.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MovedSpheres {
    /// Ask.
    #[default]
    Refuse,
    /// They are right: keep their location and radius.
    Keep,
    /// They are not: place them anew from the reference.
    Replace,
}

/// What is wanted.
#[derive(Debug, Clone, Default)]
pub struct FollowRequest {
    /// How radii follow.
    pub radius_axis: RadiusAxis,
    /// Keep bottoms on the scaled sole.
    pub level: Option<LevelAxis>,
    /// Spheres that were changed by hand.
    pub moved: MovedSpheres,
    /// Radii stay as they are in the scaled model.
    pub keep_radii: bool,
}

/// One sphere's new place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Followed {
    /// Radius in the reference, m.
    pub old_radius_m: f64,
    /// Radius, m.
    pub radius_m: f64,
    /// Location in its frame, m.
    pub location_m: [f64; 3],
}

/// New places of all moving spheres of a scaled model.
#[derive(Debug, Clone, PartialEq)]
pub struct Follow {
    pub(crate) spheres: BTreeMap<usize, Followed>,
    /// Geometric mean of the factors of the bodies that carry spheres: the ratio of sizes.
    pub size_ratio: f64,
}

impl Follow {
    pub(crate) fn old_radius(&self, sphere: usize) -> Option<f64> {
        self.spheres.get(&sphere).map(|followed| followed.old_radius_m)
    }

    /// Every contact sphere of the reference must be in the scaled model.
    ///
    /// # Errors
    /// The names of those that are not.
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
    /// A sphere without a namesake, on another body, or moved already; a body whose factors are not known.
    pub fn find(
        model: &Model<'_, '_>,
        wanted: &[usize],
        scaled: &Anatomy,
        generic: &Anatomy,
        factors: &Factors,
        request: &FollowRequest,
    ) -> Result<Self, Fault> {
        let mut spheres = BTreeMap::new();
        let (mut logarithms, mut count) = (0.0, 0.0);
        refuse_unmatched(model, wanted, generic)?;
        refuse_moved(model, wanted, scaled, generic, request.moved)?;
        for &index in wanted {
            let (Some(now), Some(own)) = (scaled.spheres.get(index), model.spheres.get(index)) else {
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
            let of_body = factors.of(body).map_err(|fault| fault.of(own.path.clone()))?;
            let [x, y, z] = of_body;
            logarithms += libm::log(x * y * z) / 3.0;
            count += 1.0;
            let place = if request.moved == MovedSpheres::Keep && differs(now, old) {
                Followed { old_radius_m: old.radius_m, radius_m: now.radius_m, location_m: now.location_m }
            } else {
                follow_one(now, old, of_body, request)
            };
            spheres.insert(index, place);
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
) -> Followed {
    let ratio = request.radius_axis.of(factors);
    let radius_m = match ratio {
        _ if request.keep_radii => now.radius_m,
        1.0 => old.radius_m,
        ratio => old.radius_m * ratio,
    };
    // The frame of the scaled model: OpenSim moves it but does not turn it.
    let scaled = |vector: [f64; 3]| scaled_in_frame(&now.rotation, factors, vector);
    let location_m = match request.level {
        Some(axis) => axis.in_frame(&now.rotation).centre(old.location_m, old.radius_m, radius_m, scaled),
        None => scaled(old.location_m),
    };
    Followed { old_radius_m: old.radius_m, radius_m, location_m }
}

/// `true` where the scaled model's sphere is not the generic one's any more.
fn differs(now: &AnatomySphere, old: &AnatomySphere) -> bool {
    let limit = UNTOUCHED * old.radius_m;
    let moved = now.location_m.iter().zip(old.location_m).any(|(now, old)| (now - old).abs() > limit);
    moved || (now.radius_m - old.radius_m).abs() > limit
}

fn refuse_unmatched(model: &Model<'_, '_>, wanted: &[usize], generic: &Anatomy) -> Result<(), Fault> {
    let twins = |name: &str| generic.spheres.iter().filter(|sphere| sphere.name == name).count() > 1;
    let names = wanted.iter().filter_map(|&index| model.spheres.get(index)).map(|sphere| &sphere.name);
    if let Some(name) = names.into_iter().find(|name| twins(name)) {
        return Err(Fault::refused(format!(
            "the reference has several spheres called {name}: which is meant cannot be told, expected one"
        )));
    }
    let unmatched: Vec<&str> = wanted
        .iter()
        .filter_map(|&index| model.spheres.get(index))
        .filter(|sphere| generic.sphere(&sphere.name).is_none())
        .map(|sphere| sphere.name.as_str())
        .collect();
    if unmatched.is_empty() {
        return Ok(());
    }
    let known: Vec<&str> = generic.spheres.iter().map(|sphere| sphere.name.as_str()).collect();
    Err(Fault::refused(format!(
        "these spheres have no namesake in the reference: {}; it has {}",
        unmatched.join(", "),
        if known.is_empty() { "none".to_owned() } else { known.join(", ") }
    )))
}

fn refuse_moved(
    model: &Model<'_, '_>,
    wanted: &[usize],
    scaled: &Anatomy,
    generic: &Anatomy,
    moved: MovedSpheres,
) -> Result<(), Fault> {
    if moved != MovedSpheres::Refuse {
        return Ok(());
    }
    let changed: Vec<&str> = wanted
        .iter()
        .filter_map(|&index| scaled.spheres.get(index))
        .filter(|now| generic.sphere(&now.name).is_some_and(|old| differs(now, old)))
        .map(|now| now.name.as_str())
        .collect();
    if changed.is_empty() {
        return Ok(());
    }
    Err(Fault::new(FaultKind::NeedsAnswer {
        code: "moved-spheres",
        question: format!(
            "spheres of {} were moved or resized already, by another tool or by hand: {}",
            model.name,
            changed.join(", ")
        ),
        way_out: "keep them with --moved-spheres keep, or place them anew with --moved-spheres replace"
            .to_owned(),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bottom_stays_on_the_sole() {
        let axis = LevelAxis::of_gravity(Some([0.0, -9.81, 0.0]));
        assert_eq!(axis, LevelAxis { axis: 1, down: false, of_body: true });
        // Bottom at -0.06; the sole is scaled by 2, the radius by 1.5: bottom at -0.12, centre 0.06 above.
        let [x, y, z] = axis.centre([0.1, -0.02, 0.0], 0.04, 0.06, |v| [v[0], 2.0 * v[1], v[2]]);
        assert!((x - 0.1).abs() < 1e-15 && (y + 0.06).abs() < 1e-15 && z == 0.0);
    }

    #[test]
    fn up_is_found_in_a_turned_frame() {
        let up = LevelAxis::of_gravity(None);
        // A quarter turn about z: the frame's x is the body's y; about x: its z is the body's -y.
        let about_z = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        let about_x = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        assert_eq!(up.in_frame(&about_z), LevelAxis { axis: 0, down: false, of_body: false });
        assert_eq!(up.in_frame(&about_x), LevelAxis { axis: 2, down: true, of_body: false });
        let told = LevelAxis { axis: 1, down: false, of_body: false };
        assert_eq!(told.in_frame(&about_z), told);
    }

    #[test]
    fn radii_follow_the_axis_asked_for() {
        let factors = [1.0, 2.0, 4.0];
        let of = |axis: RadiusAxis| axis.of(factors);
        assert_eq!((of(RadiusAxis::X), of(RadiusAxis::Y), of(RadiusAxis::Z)), (1.0, 2.0, 4.0));
        assert_eq!((of(RadiusAxis::Min), of(RadiusAxis::Max)), (1.0, 4.0));
        assert!((of(RadiusAxis::GeometricMean) - 2.0).abs() < 1e-15);
        assert_eq!(RadiusAxis::GeometricMean.of([1.3, 1.3, 1.3]), 1.3);
    }
}
