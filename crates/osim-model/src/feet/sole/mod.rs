//! The sole of each foot, the contact spheres that stand on it, and how feet are posed by default: whether their soles lie flat, and
//! whether left and right are posed alike.

mod footprint;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use glam::{DVec2, DVec3};
use indexmap::{IndexMap, IndexSet};

use crate::feet::bones::Bone;
use crate::feet::convex_hull::{convex_hull, sort_and_dedup};
use crate::feet::default_pose::DefaultPose;
use crate::feet::fault::{FeetFault, Result};
use crate::feet::movements::CoordinateValues;
use crate::feet::sole::footprint::{BonePoint, FootAxes, GroundPoint, extent, spread_bottoms};
use crate::messages::{readable, shown};
use crate::model::{Model, ModelJoint, Placement, Side, angle_between, without_side};

pub use footprint::Footprint;

/// A bone point is near the ground if its height above the lowest point is at most this part of the foot's length or width, whichever is
/// larger.
const NEAR_GROUND_SHARE: f64 = 0.1;
/// The largest number of spheres under one limb.
const MOST_SPHERES: usize = 60;
/// Size of a grid square in which only one bone point counts, m.
const THINNING_CELL_M: f64 = 1e-3;
/// The largest number of grid squares along the foot's length: in a long foot, the squares are larger than [`THINNING_CELL_M`].
const THINNING_CELLS_PER_LENGTH: f64 = 150.0;

/// The number and radius of the spheres for each limb, and the distance of the sole below the bones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoleRequest {
    /// Number of spheres for each limb.
    pub count: usize,
    pub radius_m: f64,
    /// Distance of the sole below the lowest point of the bones, m: meshes of bones have no skin.
    pub pad_m: f64,
}

/// The sole of one limb at the default pose, and the spheres that stand on the sole.
#[derive(Debug, Clone, PartialEq)]
pub struct Sole {
    /// The bodies of the foot, in the order of the bones that the caller gave.
    pub bodies: Vec<String>,
    /// Left or right, if the names of all bodies agree.
    pub side: Option<Side>,
    /// The direction opposite to gravity, in ground; of length 1.
    pub up: DVec3,
    /// The height of the sole's plane: the component of its points along `up`, m.
    pub height_m: f64,
    /// Corners of the outline of the sole, in ground, m: the convex hull of all bone points near the ground.
    pub outline_m: Vec<DVec3>,
    /// The part of the foot that is near the ground.
    pub footprint: Footprint,
    pub spheres: Vec<SoleSphere>,
}

/// A sphere under a sole, laid there for `add`.
#[derive(Debug, Clone, PartialEq)]
pub struct SoleSphere {
    /// The body that carries the sphere: the body of the bone point that is nearest to the bottom of the sphere.
    pub body: String,
    /// Centre of the sphere in the frame of its body, m.
    pub centre_m: DVec3,
    /// Radius of the sphere, m.
    pub radius_m: f64,
    /// Lowest point of the sphere in ground at the default pose, m.
    pub bottom_m: DVec3,
}

/// The soles of the limbs that own `bones`, with spheres. Bodies that joints connect are one foot; also bodies of one side that are joined
/// to another body of this side.
///
/// Each sole's plane is normal to gravity. The first spheres are under extreme corners of the outline. Four or more: under the rearmost,
/// foremost, outermost and innermost corners (in a human: heel, tip of the toes, both sides of the forefoot), measured along the outline if
/// it is long. Three: without the foremost corner. Two: under the corners that are farthest apart. One: in the middle. Each further sphere
/// is under the bone point that is farthest from all other spheres. Left and right soles are mirror images if the bones are.
///
/// # Errors
/// The model has no gravity, the place of a body is not known, the radius is not above 0, no sphere is requested, or bottoms would be
/// closer than 1 mm.
pub fn soles(model: &Model, bones: &[Bone], request: &SoleRequest) -> Result<Vec<Sole>> {
    refuse_bad_request(request)?;
    let up = direction_up(model).ok_or(FeetFault::NoGravity)?;
    let pose = DefaultPose::of(model);
    let mut placements: HashMap<&str, Placement> = HashMap::new();
    for bone in bones {
        placements.insert(&bone.body, *pose.placement(&bone.body)?);
    }
    let feet = group_bodies(model, bones);
    let soles = feet.iter().map(|foot| {
        let points = points_in_ground(foot, bones, &placements);
        let across = foot.pair_in(&feet).and_then(|pair| left_to_right(foot, pair, &pose));
        let axes = FootAxes::of(up, foot.side, &points, across);
        let (bodies, count) = (foot.bodies.clone(), request.count);
        let sole = sole(foot, &points, &axes, request);
        let sole = sole.map_err(|fits| FeetFault::TooManySpheres { bodies, count, fits })?;
        Ok(sole.in_bodies(&placements))
    });
    soles.collect()
}

/// The direction from the beginning of the left limb to the beginning of the right limb of a pair.
fn left_to_right(foot: &SoleBodies, pair: &SoleBodies, pose: &DefaultPose) -> Option<DVec3> {
    let origin = |foot: &SoleBodies| Some(pose.placement(&foot.limb).ok()?.translation_m);
    let (own, other) = (origin(foot)?, origin(pair)?);
    let sign = if foot.side == Some(Side::Left) { -1.0 } else { 1.0 };
    Some(sign * (own - other))
}

fn refuse_bad_request(request: &SoleRequest) -> Result<()> {
    let SoleRequest { count, radius_m, pad_m } = *request;
    let wrong = |what, value, expected| Err(FeetFault::Request { what, value, expected });
    if !(1..=MOST_SPHERES).contains(&count) {
        return wrong("number of spheres", count as f64, "a whole number from 1 to 60");
    }
    if !(radius_m > 0.0 && radius_m.is_finite()) {
        return wrong("radius", radius_m, "a number above 0 m");
    }
    if !pad_m.is_finite() {
        return wrong("pad", pad_m, "a finite number of m");
    }
    Ok(())
}

fn direction_up(model: &Model) -> Option<DVec3> {
    let size = model.gravity().filter(|size| size.is_finite() && *size > 0.0)?;
    // Not -0, where gravity has 0.
    Some(DVec3::ZERO - DVec3::from(model.gravity_m_s2?) / size)
}

fn points_in_ground(
    foot: &SoleBodies,
    bones: &[Bone],
    placements: &HashMap<&str, Placement>,
) -> Vec<BonePoint> {
    let mut points = Vec::new();
    for (body, name) in foot.bodies.iter().enumerate() {
        let Some(placement) = placements.get(name.as_str()) else { continue };
        let of_body = bones.iter().filter(|bone| bone.body == *name).flat_map(|bone| &bone.points_m);
        points.extend(of_body.map(|&point| BonePoint { at: placement.point(point), body }));
    }
    points
}

/// The sole of one foot. The error is the number of spheres that fit.
fn sole(
    foot: &SoleBodies,
    points: &[BonePoint],
    axes: &FootAxes,
    request: &SoleRequest,
) -> Result<Sole, usize> {
    let flat: Vec<GroundPoint> = axes.points_along_ground(points);
    let near = points_near_ground(&flat);
    let corners = convex_hull(&near);
    let bottoms = spread_bottoms(&corners, &thinned_points(&near), request.count)?;
    let height_m = axes.lowest - request.pad_m;
    let spheres = bottoms.into_iter().map(|bottom| {
        let body = nearest_body(&flat, bottom, -request.pad_m).and_then(|body| foot.bodies.get(body));
        SoleSphere {
            body: body.cloned().unwrap_or_default(),
            // Moved into its body later.
            centre_m: axes.in_ground(bottom, height_m + request.radius_m),
            radius_m: request.radius_m,
            bottom_m: axes.in_ground(bottom, height_m),
        }
    });
    Ok(Sole {
        bodies: foot.bodies.clone(),
        side: foot.side,
        up: axes.up,
        height_m,
        footprint: Footprint::around(&flat, &near),
        spheres: spheres.collect(),
        outline_m: corners.into_iter().map(|corner| axes.in_ground(corner, height_m)).collect(),
    })
}

impl Sole {
    /// Converts the centres of the spheres from ground to the frames of their bodies.
    fn in_bodies(mut self, placements: &HashMap<&str, Placement>) -> Self {
        for sphere in &mut self.spheres {
            if let Some(placement) = placements.get(sphere.body.as_str()) {
                sphere.centre_m = placement.inverse().point(sphere.centre_m);
            }
        }
        self
    }
}

/// The points near the ground, as coordinates along the ground. They are sorted, so that the order in the files does not matter.
fn points_near_ground(flat: &[GroundPoint]) -> Vec<DVec2> {
    let places: Vec<DVec2> = flat.iter().map(|point| point.at).collect();
    let near = NEAR_GROUND_SHARE * extent(&places, DVec2::X).max(extent(&places, DVec2::Y));
    let mut points: Vec<DVec2> =
        flat.iter().filter(|point| point.height <= near).map(|point| point.at).collect();
    sort_and_dedup(&mut points);
    points
}

/// Keeps only the first of several points that are close together. `points` are sorted.
fn thinned_points(points: &[DVec2]) -> Vec<DVec2> {
    let ends = points.first().zip(points.last());
    let length = ends.map_or(0.0, |(first, last)| last.x - first.x);
    let cell = THINNING_CELL_M.max(length / THINNING_CELLS_PER_LENGTH);
    let mut seen = HashSet::new();
    let number = |point: &DVec2| (*point / cell).floor().to_array().map(f64::to_bits);
    points.iter().filter(|point| seen.insert(number(point))).copied().collect()
}

/// The index of the body whose bone point is nearest to a sphere's `bottom`. `height` is the height of the bottom above the lowest point.
fn nearest_body(flat: &[GroundPoint], bottom: DVec2, height: f64) -> Option<usize> {
    let distance = |point: &GroundPoint| {
        (point.at - bottom).length_squared() + (point.height - height) * (point.height - height)
    };
    flat.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|point| point.body)
}

// Which bodies are one foot.

/// The largest number of joints between a body and the top of its limb.
const MOST_JOINTS: usize = 64;

/// The bodies of one foot with bones, and the limb that they belong to.
#[derive(Debug, Clone, PartialEq)]
struct SoleBodies {
    pub bodies: Vec<String>,
    pub side: Option<Side>,
    /// The highest body of the foot's side above the foot: the beginning of the limb.
    pub limb: String,
}

impl SoleBodies {
    /// The matching foot of the other side.
    fn pair_in<'f>(&self, feet: &'f [Self]) -> Option<&'f Self> {
        let names = |foot: &Self| {
            let mut names: Vec<String> = foot.bodies.iter().map(|body| without_side(body)).collect();
            names.sort();
            names
        };
        let side = self.side?;
        feet.iter().find(|foot| foot.side.is_some_and(|other| other != side) && names(foot) == names(self))
    }
}

/// Groups the bodies of `bones` into feet, in the order of the first body of each foot.
fn group_bodies(model: &Model, bones: &[Bone]) -> Vec<SoleBodies> {
    let joints = model.joints().iter();
    let parents: HashMap<String, String> =
        joints.filter_map(|joint| Some((joint.child.clone()?, joint.parent.clone()?))).collect();
    let listed: IndexSet<&str> = bones.iter().map(|bone| bone.body.as_str()).collect();
    let mut feet: IndexMap<String, SoleBodies> = IndexMap::new();
    for body in &listed {
        let limb = topmost_body_of_side(body, &parents);
        let new = SoleBodies { bodies: Vec::new(), side: None, limb };
        feet.entry(top_of_foot(body, &listed, &parents)).or_insert(new).bodies.push((*body).to_owned());
    }
    let sided = |mut foot: SoleBodies| {
        let mut sides = foot.bodies.iter().map(|body| Side::of_name(body));
        let first = sides.next().flatten();
        foot.side = first.filter(|_| sides.all(|side| side == first));
        foot
    };
    feet.into_values().map(sided).collect()
}

/// The highest body, from `body` upwards, that belongs to the same foot: it is in the list, or it is of the same side and has another
/// listed body below.
fn top_of_foot(body: &str, listed: &IndexSet<&str>, parents: &HashMap<String, String>) -> String {
    let path = bodies_upwards_from(body, parents);
    let shared = |above: &str| {
        let below = |other: &&&str| {
            **other != body && bodies_upwards_from(other, parents).iter().any(|at| at == above)
        };
        listed.iter().any(|other| below(&other))
    };
    let side = Side::of_name(body);
    let belongs = |above: &&String| {
        listed.contains(above.as_str()) || (side.is_some() && Side::of_name(above) == side && shared(above))
    };
    path.iter().rev().find(belongs).cloned().unwrap_or_else(|| body.to_owned())
}

/// The highest body of the same side, from `body` upwards.
fn topmost_body_of_side(body: &str, parents: &HashMap<String, String>) -> String {
    let side = Side::of_name(body);
    let path = bodies_upwards_from(body, parents);
    let of_side = path.iter().rev().find(|above| side.is_some() && Side::of_name(above) == side);
    of_side.cloned().unwrap_or_else(|| body.to_owned())
}

/// `body` and the bodies above it.
fn bodies_upwards_from(body: &str, parents: &HashMap<String, String>) -> Vec<String> {
    let mut path = vec![body.to_owned()];
    while let Some(parent) = path.last().and_then(|body| parents.get(body))
        && path.len() <= MOST_JOINTS
    {
        path.push(parent.clone());
    }
    path
}

/// A coordinate that tilts a foot by less than this is ignored, rad: 0.3 degrees.
const LEAST_TILT_RAD: f64 = 0.005;
/// The largest number of coordinates that a message names.
const MOST_COORDINATES_NAMED: usize = 4;

/// A coordinate whose default value tilts a foot against the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct TiltingCoordinate {
    /// Name of the coordinate, such as `ankle_angle_r`.
    pub name: String,
    /// Value of the coordinate at the default pose, rad.
    pub value: f64,
}

impl Sole {
    /// The coordinates of `model` whose default values tilt the foot or a part of it, beginning at the foot.
    pub fn tilting_coordinates(&self, model: &Model) -> Vec<TiltingCoordinate> {
        let joints = model.joints();
        let coordinates = CoordinateValues::at_default_pose(model);
        let pose = DefaultPose::of(model);
        let mut tilting: Vec<TiltingCoordinate> = Vec::new();
        for joint in self.joints_above(joints) {
            let values: Option<Vec<f64>> =
                joint.coordinates.iter().map(|one| coordinates.values.get(&one.name).copied()).collect();
            let Some(values) = values else { continue };
            let parent = match &joint.parent {
                Some(body) => pose.placement(body).copied().unwrap_or(Placement::IDENTITY),
                None => Placement::IDENTITY,
            };
            let up = |values: &[f64]| {
                let placed = parent.then(&joint.placement(model, values)?);
                Some(placed.rotation.inverse().to_body(self.up))
            };
            for (index, coordinate) in joint.coordinates.iter().enumerate() {
                let mut without = values.clone();
                let Some(value) = without.get_mut(index).map(std::mem::take) else { continue };
                let tilts =
                    up(&values).zip(up(&without)).is_some_and(|(a, b)| a.distance(b) > LEAST_TILT_RAD);
                if tilts && !tilting.iter().any(|known| known.name == coordinate.name) {
                    tilting.push(TiltingCoordinate { name: coordinate.name.clone(), value });
                }
            }
        }
        tilting
    }

    /// Describes the tilt of a foot that does not lie flat at the default pose; `None` for a flat foot.
    pub fn describe_tilt(&self) -> Option<String> {
        let print = &self.footprint;
        if print.is_flat() {
            return None;
        }
        let tilt = |what: &str, tilt: f64| {
            let degrees = format!("{:.1} degrees", tilt.abs().to_degrees());
            format!("its {what} is {degrees} {}", if tilt < 0.0 { "down" } else { "up" })
        };
        let tilt = match print.pitch_rad.abs() >= print.roll_rad.abs() {
            true => tilt("front", print.pitch_rad),
            false => tilt("outer side", print.roll_rad),
        };
        let percent = |share: f64| format!("{:.0} %", 100.0 * share);
        let bodies: Vec<String> = self.bodies.iter().map(|body| shown(body).to_string()).collect();
        Some(format!(
            "the foot of {} does not lie flat at the default pose: {tilt}, and bones near the ground cover {} of its length and {} \
             of its width, expected at most 10 degrees, and 80 % or more",
            bodies.join(", "),
            percent(print.share_of_length),
            percent(print.share_of_width),
        ))
    }

    /// The joints of the foot's bodies, then the joints above them.
    fn joints_above<'j>(&self, joints: &'j [ModelJoint]) -> Vec<&'j ModelJoint> {
        let above = |body: &str| joints.iter().find(|joint| joint.child.as_deref() == Some(body));
        let mut upwards: Vec<&ModelJoint> = self.bodies.iter().filter_map(|body| above(body)).collect();
        for start in upwards.clone() {
            let mut at = start;
            while let Some(next) = at.parent.as_deref().and_then(above)
                && !upwards.iter().any(|known| std::ptr::eq(*known, next))
                && upwards.len() <= MOST_JOINTS
            {
                upwards.push(next);
                at = next;
            }
        }
        upwards
    }
}

impl TiltingCoordinate {
    /// The names and values of coordinates for a sentence: `ankle_angle_r = 0.2 rad`. Only the first of many are named.
    pub fn listed(all: &[Self]) -> String {
        let one = |own: &Self| format!("{} = {} rad", shown(&own.name), readable(own.value));
        let mut named: Vec<String> = all.iter().take(MOST_COORDINATES_NAMED).map(one).collect();
        if all.len() > MOST_COORDINATES_NAMED {
            named.push(format!("{} more", all.len() - MOST_COORDINATES_NAMED));
        }
        named.join(", ")
    }
}

// Whether two feet are posed as mirror images of each other.

/// The axis of mirroring, one of x, y and z: the frame of a left body is the mirror image of the right body's frame along one of its axes,
/// nearly always z.
const MIRROR_FACTORS: [DVec3; 3] =
    [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, 1.0)];

impl Sole {
    /// The angle by which the pose of this foot differs from the mirror image of the `other` foot at the default pose of `model`, rad. In
    /// the frames of the feet, two directions are compared: up, and towards the other foot. The larger angle counts. `None` if a pose is
    /// not known.
    pub fn pose_asymmetry(&self, other: &Self, model: &Model) -> Option<f64> {
        (self.side? != other.side?).then_some(())?;
        let pose = DefaultPose::of(model);
        let pair = |body: &String| {
            let counterpart = other.bodies.iter().find(|other| without_side(other) == without_side(body))?;
            Some((pose.placement(body).ok()?, pose.placement(counterpart).ok()?))
        };
        let seen = |own: &Placement, there: &Placement, direction: DVec3, mirrored: DVec3| {
            (own.rotation.inverse().to_body(direction), there.rotation.inverse().to_body(mirrored))
        };
        let pairs: Vec<_> = self.bodies.iter().filter_map(pair).collect();
        let up = pairs.iter().map(|(own, there)| seen(own, there, self.up, other.up));
        // One way from foot to foot is enough: where a foot is turned, its foremost body is elsewhere, too.
        let across = pairs.first().map(|(own, there)| {
            let outwards = own.translation_m - there.translation_m;
            seen(own, there, outwards, -outwards)
        });
        let seen: Vec<_> = up.chain(across).collect();
        let apart = |mirror: DVec3| {
            seen.iter().map(|(own, there)| angle_between(*own, mirror * *there)).fold(0.0, f64::max)
        };
        (!seen.is_empty()).then(|| MIRROR_FACTORS.into_iter().map(apart).fold(f64::INFINITY, f64::min))
    }
}
