//! The height of a body over its floor at the default pose, and the coordinate with which the body stands: as data, and in the words of
//! `check`, `inspect` and changes.

use std::collections::BTreeMap;

use foldhash::HashMap;
use osim_model::DVec3;
use osim_model::feet::{RestOnFloor, RestingSphere, SphereOverFloor, Standing};
use osim_model::messages::{four_significant, readable, shown};
use osim_model::{Limb, Limbs, Model, Sphere, SphereId};
use serde::Serialize;

use crate::serialized::json_records;

/// Bottoms whose heights differ by no more than this are equally low, m.
const SAME_HEIGHT_M: f64 = 1e-9;
/// A sphere that is deeper in the floor than this part of its radius is inside the floor.
const INSIDE_FLOOR_RADII: f64 = 0.5;
/// A body whose lowest sphere is higher than this, m, is above the floor.
const GAP_ABOVE_FLOOR_M: f64 = 0.020;
/// A body stands if it is at most this far below the height at which its spheres carry it, in radii of its lowest sphere.
const STANDING_DEPTH_RADII: f64 = 0.1;

/// Whom a model is inspected for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum InspectedFor {
    /// People and scripts: with all that is known.
    Readers,
    /// The rules: without what no rule needs. The equilibrium is computed only of bodies that may be inside their floor or above it, with
    /// the weight on all feet.
    Rules,
}

/// A joint tree over its floor at the default pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct StandingBody {
    /// The top body of the tree, which a joint connects with ground.
    pub body: String,
    /// Mass of the bodies that the coordinate moves, kg; without platforms, balls or chairs.
    pub mass_kg: Option<f64>,
    /// The weight of the moved bodies along the normal of the floor, N.
    pub weight_n: Option<f64>,
    /// The free coordinate that moves all its spheres alike along the normal; null if there is none.
    pub coordinate: Option<String>,
    /// The joint of that coordinate.
    pub joint: Option<String>,
    /// Why no coordinate moves all spheres of the tree alike, in words.
    pub why_no_coordinate: Option<String>,
    /// The coordinate's value at the default pose, m.
    pub default_m: Option<f64>,
    /// Value of the coordinate at which the lowest sphere just touches the floor, m.
    pub touching_m: Option<f64>,
    /// The tree's spheres that press on floors, in file order.
    pub bottoms: Vec<Bottom>,
    /// The body at rest on all its feet, each sphere at its own height; null if its weight or a contact is not known, nothing carries it,
    /// or a number is more than a double holds.
    pub as_posed: Option<BodyAtRest>,
    /// The body at rest on the spheres of its lowest limb alone (of equally low ones the first), with the share of the weight that one of
    /// several stance limbs has. Null also if limbs are not known.
    pub on_one_limb: Option<BodyAtRest>,
}

json_records! {
    /// The lowest point of a sphere over its floor.
    Bottom from (over, sphere): (&SphereOverFloor, &Sphere) {
        /// Name of the sphere.
        sphere: String = sphere.name.clone(),
        /// Component path of the coordinate.
        path: String = sphere.path.clone(),
        /// Height over the floor along the floor's normal, m; below 0 inside the floor.
        height_m: f64 = over.gap_m,
        /// Radius of the sphere, m.
        radius_m: f64 = sphere.radius.number,
        /// Angle between the floor's normal and the axis of the sphere's body that is nearest to it, or is up with all coordinates at 0
        /// if the model lies, rad: 0 if the body is upright.
        tilt_rad: f64 = over.tilt_rad,
        /// The body that the frame belongs to.
        #[serde(skip)]
        body: Option<String> = sphere.body.clone(),
        /// The centre of the sphere in ground, m.
        #[serde(skip)]
        centre_m: DVec3 = over.centre_m,
        /// Height of the bottom with all coordinates at 0, along the axis of ground nearest to the normal, m; null if it is not known.
        #[serde(skip)]
        height_at_zero_m: Option<f64> = over.height_at_zero_m,
    }

    /// A body at rest on spheres, by the contact laws of the file.
    BodyAtRest from (model, standing, rest, limb): (&Model, &Standing, &RestOnFloor, Option<&Limb>) {
        /// The limb whose spheres alone carry the body; null if all limbs do.
        limb: Option<String> = limb.map(|limb| limb.name.clone()),
        /// The value of the coordinate at rest, m.
        value_m: Option<f64> = standing.coordinate_at(rest.down_m),
        /// How far the body at rest is below its default pose, along the normal, m; below 0 if it is above.
        down_m: f64 = rest.down_m,
        /// Load of the spheres along the normal, N.
        load_n: f64 = rest.load_n,
        /// Whether each sphere is less deep than its radius; beyond that no contact law holds.
        carried: bool = rest.is_carried(),
        /// The spheres that carry the body, in file order.
        spheres: Vec<StandingSphere> = {
            let sphere = |one: &RestingSphere| Some((one, model.sphere(one.sphere)?).into());
            rest.spheres.iter().filter_map(sphere).collect()
        },
    }

    /// A sphere of a body at rest.
    StandingSphere from (at_rest, sphere): (&RestingSphere, &Sphere) {
        /// Name of the sphere.
        sphere: String = sphere.name.clone(),
        /// Component path of the sphere.
        path: String = sphere.path.clone(),
        /// Depth of the sphere in the floor, in its radius; not above 0 if it does not touch.
        relative_indentation: f64 = at_rest.relative_indentation,
        /// Load of the sphere along the normal, N.
        force_n: f64 = at_rest.force_n,
    }
}

impl StandingSphere {
    /// Whether the sphere is in the floor.
    pub fn touches(&self) -> bool {
        self.relative_indentation > 0.0
    }
}

impl BodyAtRest {
    /// Whether all numbers of the equilibrium are finite.
    fn is_finite(&self) -> bool {
        let spheres = self.spheres.iter().flat_map(|one| [one.relative_indentation, one.force_n]);
        spheres.chain([self.down_m, self.load_n]).all(f64::is_finite)
    }

    /// The spheres that are in the floor.
    pub fn touching(&self) -> impl Iterator<Item = &StandingSphere> {
        self.spheres.iter().filter(|one| one.touches())
    }

    /// The sphere with the largest indentation in its radius; of several, the first.
    pub fn deepest(&self) -> Option<&StandingSphere> {
        self.spheres.iter().reduce(|a, b| if b.relative_indentation > a.relative_indentation { b } else { a })
    }
}

impl StandingBody {
    /// Summaries of all joint trees in `standing`. `limbs` are the limbs of the model, and `stance_limbs` of them share the weight.
    pub fn all(model: &Model, standing: &[Standing], limbs: &Limbs, stance_limbs: f64) -> Vec<Self> {
        Self::with_rests(model, standing, limbs, stance_limbs, InspectedFor::Readers)
    }

    /// Summaries of all joint trees, with the equilibria that are needed.
    pub(super) fn with_rests(
        model: &Model,
        standing: &[Standing],
        limbs: &Limbs,
        stance_limbs: f64,
        inspected_for: InspectedFor,
    ) -> Vec<Self> {
        let share = 1.0 / stance_limbs;
        let limbs = limbs.if_known().unwrap_or_default();
        let places = limbs.iter().enumerate();
        let limb_of = places.flat_map(|(at, limb)| limb.spheres.iter().map(move |&sphere| (sphere, at)));
        let limb_of: HashMap<SphereId, usize> = limb_of.collect();
        let carrying_limb =
            |tree| limbs.get(lowest_limb(tree, &limb_of)?).filter(|_| inspected_for == InspectedFor::Readers);
        standing
            .iter()
            .map(|tree| Self::new(model, tree, carrying_limb(tree), share, inspected_for))
            .collect()
    }

    /// Summarises one joint tree. `lowest_limb` is the index of the limb that can carry the tree alone.
    fn new(
        model: &Model,
        standing: &Standing,
        lowest_limb: Option<&Limb>,
        share: f64,
        inspected_for: InspectedFor,
    ) -> Self {
        let spheres: Vec<SphereId> = standing.spheres.iter().map(|over| over.sphere).collect();
        let rest = |chosen: &[SphereId], share, limb: Option<&Limb>| {
            let rest = standing.rest_on_floor(chosen, share)?.ok()?;
            Some(BodyAtRest::from((model, standing, &rest, limb))).filter(BodyAtRest::is_finite)
        };
        let lift = standing.lift.as_ref();
        let bottom = |over: &SphereOverFloor| Some((over, model.sphere(over.sphere)?).into());
        let bottoms: Vec<Bottom> = standing.spheres.iter().filter_map(bottom).collect();
        let is_off_floor =
            bottoms.iter().any(Bottom::is_inside) || lowest_bottom(&bottoms).is_some_and(Bottom::is_above);
        let is_wanted = inspected_for == InspectedFor::Readers || is_off_floor;
        Self {
            body: standing.top.clone(),
            mass_kg: standing.mass_kg,
            weight_n: standing.load_n,
            coordinate: lift.ok().map(|lift| lift.coordinate.clone()),
            joint: lift.ok().map(|lift| lift.joint.clone()),
            why_no_coordinate: lift.err().map(ToString::to_string),
            default_m: lift.ok().map(|lift| lift.default_m),
            touching_m: standing.lowest().and_then(|lowest| standing.coordinate_at(lowest.gap_m)),
            as_posed: is_wanted.then(|| rest(&spheres, 1.0, None)).flatten(),
            on_one_limb: lowest_limb.and_then(|limb| rest(&limb.spheres, share, Some(limb))),
            bottoms,
        }
    }

    /// Whether at the default pose a sphere is inside the floor, and the body is lower than in the equilibrium on its feet.
    pub fn is_inside_floor(&self) -> bool {
        let Some(lowest) = self.lowest() else { return false };
        let is_deeper =
            self.as_posed.as_ref().is_none_or(|rest| rest.down_m < -STANDING_DEPTH_RADII * lowest.radius_m);
        is_deeper && self.bottoms.iter().any(Bottom::is_inside)
    }

    /// Whether the lowest sphere is clearly above the floor at the default pose.
    pub(crate) fn is_above_floor(&self) -> bool {
        self.lowest().is_some_and(Bottom::is_above)
    }

    /// The lowest bottom of the body's spheres; of equally low bottoms, the first.
    pub fn lowest(&self) -> Option<&Bottom> {
        lowest_bottom(&self.bottoms)
    }
}

impl Bottom {
    /// Whether the sphere is inside the floor, by more than a part of its radius.
    fn is_inside(&self) -> bool {
        self.height_m < -INSIDE_FLOOR_RADII * self.radius_m
    }

    /// Whether the sphere is clearly above the floor.
    fn is_above(&self) -> bool {
        self.height_m > GAP_ABOVE_FLOOR_M
    }
}

/// The lowest of the bottoms; of equally low bottoms, the first.
fn lowest_bottom(bottoms: &[Bottom]) -> Option<&Bottom> {
    bottoms.iter().reduce(|a, b| if b.height_m < a.height_m - SAME_HEIGHT_M { b } else { a })
}

/// The index of the limb with the lowest bottom; of equally low bottoms, the first.
fn lowest_limb(standing: &Standing, limb_of: &HashMap<SphereId, usize>) -> Option<usize> {
    let mut lowest: BTreeMap<usize, f64> = BTreeMap::new();
    for over in &standing.spheres {
        let Some(&limb) = limb_of.get(&over.sphere) else { continue };
        let height_m = lowest.entry(limb).or_insert(over.gap_m);
        *height_m = height_m.min(over.gap_m);
    }
    lowest.into_iter().reduce(|a, b| if b.1 < a.1 - SAME_HEIGHT_M { b } else { a }).map(|(limb, _)| limb)
}

// A body over its floor in words, for `check`, `inspect` and changes.

impl StandingBody {
    /// Where the lowest sphere, and with it the default pose, is: `65 mm too high`; `on the floor` within a tenth of a millimetre.
    pub fn pose_in_words(&self) -> Option<String> {
        let height_m = self.lowest()?.height_m;
        if height_m.abs() < 1e-4 {
            return Some("on the floor".to_owned());
        }
        let side = if height_m < 0.0 { "too low" } else { "too high" };
        Some(format!("{} mm {side}", four_significant((height_m.abs() * 1e4).round() / 10.0)))
    }

    /// The coordinate with which the body stands: `to start there, pelvis_ty = 0.981 (now 0; the spheres then carry the body)`, or why
    /// there is none.
    pub fn describe_way_to_stand(&self) -> String {
        if let Some(why) = &self.why_no_coordinate {
            return format!("no coordinate brings it to the floor: {why}");
        }
        let carried = self.as_posed.as_ref().filter(|rest| rest.carried).and_then(|rest| rest.value_m);
        match (carried, self.touching_m) {
            (Some(value), _) => self.coordinate_set_to(value, "the spheres then carry the body"),
            (None, Some(value)) => self.coordinate_set_to(value, "its lowest sphere then touches the floor"),
            (None, None) => "which coordinate brings it to the floor is not known".to_owned(),
        }
    }

    /// The name of the coordinate with the new value and the present value, and the effect `does` of the new value.
    fn coordinate_set_to(&self, value: f64, does: &str) -> String {
        let (name, now) = (self.coordinate_name().unwrap_or_default(), self.default_m.unwrap_or_default());
        format!(
            "to start there, {name} = {} (now {}; {does})",
            readable(self.rounded_coordinate(value)),
            readable(now)
        )
    }

    /// The name of the coordinate that lifts the body. If OpenSim made the name, the name of the joint is added, because several joints can
    /// have a `_coord_4`.
    fn coordinate_name(&self) -> Option<String> {
        let name = shown(self.coordinate.as_deref()?).to_string();
        let joint = self.joint.as_deref().filter(|joint| name.starts_with("_coord_") && !joint.is_empty());
        Some(joint.map_or(name.clone(), |joint| format!("{name} of {}", shown(joint))))
    }

    /// The value of the coordinate, m, rounded to a hundredth of the smallest radius or less.
    fn rounded_coordinate(&self, value_m: f64) -> f64 {
        let smallest = self.bottoms.iter().map(|bottom| bottom.radius_m).fold(1.0, f64::min);
        let decimals = (-(smallest / 100.0).log10().floor()).clamp(2.0, 12.0);
        let unit = 10_f64.powf(decimals);
        (value_m * unit).round() / unit
    }

    /// The coordinate with which the body is in the equilibrium `rest`: `pelvis_ty = 0.981`; `None` if no coordinate lifts the body.
    pub fn coordinate_at_rest(&self, rest: &BodyAtRest) -> Option<String> {
        Some(format!("{} = {}", self.coordinate_name()?, readable(self.rounded_coordinate(rest.value_m?))))
    }
}
