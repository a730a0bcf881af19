//! How a body is over its floor at the default pose, and what puts it on its feet: as data, and in the words that `check`, `inspect` and changes share.

use std::collections::BTreeMap;

use foldhash::HashMap;
use osim_model::feet::{RestOnFloor, RestingSphere, SphereOverFloor, Standing};
use osim_model::messages::{readable, shown};
use osim_model::{Limb, Limbs, Model, SphereId};
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::Serialize;

/// Bottoms of limbs this close are equally low, m.
const LEVEL_M: f64 = 1e-9;
/// A sphere this deep, in its radius, is inside the floor.
const INSIDE: f64 = 0.5;
/// A body this high is above the floor, m.
const ABOVE_M: f64 = 0.020;
/// A body this little below where it stands, in the radius of its lowest sphere, stands.
const STANDS: f64 = 0.1;

/// Which rests are worked out: each takes as long as reading its spheres.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rests {
    All,
    /// On all feet, of bodies that are perhaps inside their floor or above it.
    OfOdd,
}

/// A joint tree over its floor, its joints as they are at the default pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct StandingBody {
    /// The body on top of the tree, which is joined to ground.
    pub body: String,
    /// Mass of the bodies that the coordinate moves, kg: no platforms, balls or chairs.
    pub mass_kg: Option<f64>,
    /// The part of their weight along the floor's normal, N.
    pub weight_n: Option<f64>,
    /// The free coordinate that moves all its spheres alike along the normal; null if there is none.
    pub coordinate: Option<String>,
    /// The joint that has it.
    pub joint: Option<String>,
    /// Why there is none, in words.
    pub why_no_coordinate: Option<String>,
    /// The coordinate's value at the default pose, m.
    pub default_m: Option<f64>,
    /// Its value at which the lowest sphere just touches the floor, m.
    pub touching_m: Option<f64>,
    /// Its spheres that press on floors, in file order.
    pub bottoms: Vec<Bottom>,
    /// On all its feet, each sphere at its own height; null if its weight or a contact is not known, nothing carries it, or
    /// a number is more than a double holds.
    pub as_posed: Option<OnFeet>,
    /// On the spheres of one limb alone, the lower one or, of equally low ones, the first; of several stance limbs with its share of the
    /// weight. Null also where limbs are not known.
    pub on_one_limb: Option<OnFeet>,
}

/// The lowest point of a sphere over its floor.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Bottom {
    /// Name of the sphere.
    pub sphere: String,
    /// Its component path.
    pub path: String,
    /// Height over the floor along the floor's normal, m; below 0 inside the floor.
    pub height_m: f64,
    /// Radius of the sphere, m.
    pub radius_m: f64,
    /// Angle between the floor's normal and the axis of the sphere's body that is nearest to it, rad: 0 if the body is upright.
    pub tilt_rad: f64,
}

/// A body at rest on spheres, by the laws of the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct OnFeet {
    /// The limb whose spheres alone carry it; null for all of its limbs.
    pub limb: Option<String>,
    /// The coordinate's value there, m.
    pub value_m: Option<f64>,
    /// How far the body is below its default pose there, along the normal, m; below 0 if it is above.
    pub down_m: f64,
    /// What the spheres carry along the normal, N.
    pub load_n: f64,
    /// Whether each sphere is less deep than its radius: beyond that no contact law knows it.
    pub carried: bool,
    /// Each of these spheres, in file order.
    pub spheres: Vec<StandingSphere>,
}

/// A sphere of a body at rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct StandingSphere {
    /// Its name.
    pub sphere: String,
    /// Its component path.
    pub path: String,
    /// How deep it is in the floor, in its radius; not above 0 if it does not touch.
    pub relative_indentation: f64,
    /// What it carries along the normal, N.
    pub force_n: f64,
}

impl StandingSphere {
    pub fn touches(&self) -> bool {
        self.relative_indentation > 0.0
    }
}

impl OnFeet {
    /// Whether doubles hold all of its numbers.
    fn is_finite(&self) -> bool {
        let spheres = self.spheres.iter().flat_map(|one| [one.relative_indentation, one.force_n]);
        spheres.chain([self.down_m, self.load_n]).all(f64::is_finite)
    }

    pub fn touching(&self) -> impl Iterator<Item = &StandingSphere> {
        self.spheres.iter().filter(|one| one.touches())
    }

    /// The sphere that is deepest, in its radius; the first of several.
    pub fn deepest(&self) -> Option<&StandingSphere> {
        self.spheres.iter().reduce(|a, b| if b.relative_indentation > a.relative_indentation { b } else { a })
    }
}

impl StandingBody {
    /// Each of `standing`; `limbs` are those of its spheres; `stance_limbs` of them share the weight.
    pub fn all(model: &Model, standing: &[Standing], limbs: &Limbs, stance_limbs: f64) -> Vec<Self> {
        Self::those(model, standing, limbs, stance_limbs, Rests::All)
    }

    /// Bodies that stand with these rests.
    pub(super) fn those(
        model: &Model,
        standing: &[Standing],
        limbs: &Limbs,
        stance_limbs: f64,
        rests: Rests,
    ) -> Vec<Self> {
        let share = 1.0 / stance_limbs;
        let limbs = limbs.if_known().unwrap_or_default();
        let places = limbs.iter().enumerate();
        let limb_of = places.flat_map(|(at, limb)| limb.spheres.iter().map(move |&sphere| (sphere, at)));
        let limb_of: HashMap<SphereId, usize> = limb_of.collect();
        let lower = |one| limbs.get(lower(one, &limb_of)?);
        let of_one_limb = |one| lower(one).filter(|_| rests == Rests::All);
        standing.iter().map(|one| Self::new(model, one, of_one_limb(one), share, rests)).collect()
    }

    /// `lower` is the limb that can carry it alone.
    fn new(model: &Model, standing: &Standing, lower: Option<&Limb>, share: f64, rests: Rests) -> Self {
        let spheres: Vec<SphereId> = standing.spheres.iter().map(|over| over.sphere).collect();
        let rest = |chosen: &[SphereId], share, limb: Option<&Limb>| {
            let rest = standing.rest(chosen, share)?.ok()?;
            Some(on_feet(model, standing, &rest, limb)).filter(OnFeet::is_finite)
        };
        let lift = standing.lift.as_ref();
        let bottoms = bottoms(model, standing);
        let is_asked = rests == Rests::All || is_odd(&bottoms);
        Self {
            body: standing.top.clone(),
            mass_kg: standing.mass_kg,
            weight_n: standing.load_n,
            coordinate: lift.ok().map(|lift| lift.coordinate.clone()),
            joint: lift.ok().map(|lift| lift.joint.clone()),
            why_no_coordinate: lift.err().map(ToString::to_string),
            default_m: lift.ok().map(|lift| lift.default_m),
            touching_m: standing.lowest().and_then(|lowest| standing.coordinate_at(lowest.gap_m)),
            as_posed: is_asked.then(|| rest(&spheres, 1.0, None)).flatten(),
            on_one_limb: lower.and_then(|limb| rest(&limb.spheres, share, Some(limb))),
            bottoms,
        }
    }

    /// Whether a sphere is inside the floor at the default pose and the body deeper than where its feet carry it.
    pub fn is_inside_floor(&self) -> bool {
        let Some(lowest) = self.lowest() else { return false };
        let deeper = self.as_posed.as_ref().is_none_or(|rest| rest.down_m < -STANDS * lowest.radius_m);
        deeper && self.bottoms.iter().any(Bottom::is_inside)
    }

    pub(crate) fn is_above_floor(&self) -> bool {
        self.lowest().is_some_and(Bottom::is_above)
    }

    /// The lowest of its bottoms; of equally low ones the first.
    pub fn lowest(&self) -> Option<&Bottom> {
        lowest(&self.bottoms)
    }
}

impl Bottom {
    fn is_inside(&self) -> bool {
        self.height_m < -INSIDE * self.radius_m
    }

    fn is_above(&self) -> bool {
        self.height_m > ABOVE_M
    }
}

fn lowest(bottoms: &[Bottom]) -> Option<&Bottom> {
    bottoms.iter().reduce(|a, b| if b.height_m < a.height_m - LEVEL_M { b } else { a })
}

/// Whether a body with these bottoms is perhaps inside its floor, or above it.
fn is_odd(bottoms: &[Bottom]) -> bool {
    bottoms.iter().any(Bottom::is_inside) || lowest(bottoms).is_some_and(Bottom::is_above)
}

fn bottoms(model: &Model, standing: &Standing) -> Vec<Bottom> {
    let bottom = |over: &SphereOverFloor| {
        let sphere = model.sphere(over.sphere)?;
        let (height_m, radius_m, tilt_rad) = (over.gap_m, sphere.radius.number, over.tilt_rad);
        Some(Bottom { sphere: sphere.name.clone(), path: sphere.path.clone(), height_m, radius_m, tilt_rad })
    };
    standing.spheres.iter().filter_map(bottom).collect()
}

/// Which of the limbs has the lowest bottom of a tree; of equally low ones the first.
fn lower(standing: &Standing, limb_of: &HashMap<SphereId, usize>) -> Option<usize> {
    let mut lowest: BTreeMap<usize, f64> = BTreeMap::new();
    for over in &standing.spheres {
        let Some(&limb) = limb_of.get(&over.sphere) else { continue };
        let height_m = lowest.entry(limb).or_insert(over.gap_m);
        *height_m = height_m.min(over.gap_m);
    }
    lowest.into_iter().reduce(|a, b| if b.1 < a.1 - LEVEL_M { b } else { a }).map(|(limb, _)| limb)
}

fn on_feet(model: &Model, standing: &Standing, rest: &RestOnFloor, limb: Option<&Limb>) -> OnFeet {
    let sphere = |one: &RestingSphere| {
        let sphere = model.sphere(one.sphere)?;
        Some(StandingSphere {
            sphere: sphere.name.clone(),
            path: sphere.path.clone(),
            relative_indentation: one.relative_indentation,
            force_n: one.force_n,
        })
    };
    OnFeet {
        limb: limb.map(|limb| limb.name.clone()),
        value_m: standing.coordinate_at(rest.down_m),
        down_m: rest.down_m,
        load_n: rest.load_n,
        carried: rest.is_carried(),
        spheres: rest.spheres.iter().filter_map(sphere).collect(),
    }
}

// The words for a body over its floor: `check`, `inspect` and changes share it.

impl StandingBody {
    /// How far inside or above the floor the lowest sphere is: `945 mm inside the floor`; `on the floor` within a tenth of a millimetre.
    pub fn place(&self) -> Option<String> {
        let height_m = self.lowest()?.height_m;
        let millimetres = readable((height_m.abs() * 1e4).round() / 10.0);
        Some(match height_m {
            height if height.abs() < 1e-4 => "on the floor".to_owned(),
            height if height < 0.0 => format!("{millimetres} mm inside the floor"),
            _ => format!("{millimetres} mm above the floor"),
        })
    }

    /// What puts it on its feet: `pelvis_ty = 0.981 (now 0) puts it on its feet`, or why nothing does.
    pub fn way_to_stand(&self) -> String {
        if let Some(why) = &self.why_no_coordinate {
            return format!("no coordinate puts it on its feet: {why}");
        }
        let carried = self.as_posed.as_ref().filter(|rest| rest.carried).and_then(|rest| rest.value_m);
        match (carried, self.touching_m) {
            (Some(value), _) => format!("{} puts it on its feet", self.set_to(value)),
            (None, Some(value)) => format!("{} lets its lowest sphere touch the floor", self.set_to(value)),
            (None, None) => "what puts it on its feet is not known".to_owned(),
        }
    }

    /// The coordinate at a value, and where it is: `pelvis_ty = 0.981 (now 0)`.
    fn set_to(&self, value: f64) -> String {
        let (name, now) = (self.coordinate_name().unwrap_or_default(), self.default_m.unwrap_or_default());
        format!("{name} = {} (now {})", readable(self.rounded(value)), readable(now))
    }

    /// The coordinate, with its joint if OpenSim made the name: `_coord_4` comes more than once.
    fn coordinate_name(&self) -> Option<String> {
        let name = shown(self.coordinate.as_deref()?).to_string();
        let joint = self.joint.as_deref().filter(|joint| name.starts_with("_coord_") && !joint.is_empty());
        Some(joint.map_or(name.clone(), |joint| format!("{name} of {}", shown(joint))))
    }

    /// A value of the coordinate in so many decimals that a hundredth of the smallest radius shows, m.
    pub fn rounded(&self, value_m: f64) -> f64 {
        let smallest = self.bottoms.iter().map(|bottom| bottom.radius_m).fold(1.0, f64::min);
        let decimals = (-(smallest / 100.0).log10().floor()).clamp(2.0, 12.0);
        let unit = 10_f64.powf(decimals);
        (value_m * unit).round() / unit
    }

    /// The coordinate at rest on `feet`: `pelvis_ty = 0.981`; `None` if no coordinate lifts it.
    pub fn coordinate_on(&self, feet: &OnFeet) -> Option<String> {
        Some(format!("{} = {}", self.coordinate_name()?, readable(self.rounded(feet.value_m?))))
    }
}
