//! Mirror images between left and right bodies: sizes of the bones, the axis that changes its sign, and places that are counterparts.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::{DVec3, Model, Side, without_side};

/// The size of the body `left` over the size of `right`, along x, y and z: by their meshes, else by the distances between their joints;
/// `None` if neither is known.
pub(crate) fn bone_ratios(model: &Model, left: &str, right: &str) -> Option<[f64; 3]> {
    ratios_of_meshes(model, left, right).or_else(|| {
        let distances = model.joint_distances();
        let ratio = distances.longest_in_body(left)? / distances.longest_in_body(right)?;
        (ratio.is_finite() && ratio > 0.0).then_some([ratio; 3])
    })
}

/// The ratios of the scale factors of meshes of the same bone; `None` if no bone is in both bodies, or the ratios of several bones differ.
fn ratios_of_meshes(model: &Model, left: &str, right: &str) -> Option<[f64; 3]> {
    let meshes = model.mesh_factors();
    let (left, right) = (meshes.get(left)?, meshes.get(right)?);
    let mut ratios = same_bones(left, right).into_iter().filter_map(|(l, r)| left_over_right(l, r));
    let first = ratios.next()?;
    ratios.all(|other| other.into_iter().zip(first).all(|(a, b)| is_close(a, b))).then_some(first)
}

/// The scale factors of a left and a right mesh.
type FactorPair<'b> = (&'b [f64; 3], &'b [f64; 3]);

/// Pairs the left and right meshes of the same bone: by their names, else by their order.
fn same_bones<'b>(
    left: &'b BTreeMap<String, [f64; 3]>,
    right: &'b BTreeMap<String, [f64; 3]>,
) -> Vec<FactorPair<'b>> {
    let by_name: HashMap<String, &[f64; 3]> =
        right.iter().map(|(file, factors)| (without_side(file), factors)).collect();
    let same_names: Vec<FactorPair<'b>> =
        left.iter().filter_map(|(file, l)| Some((l, *by_name.get(&without_side(file))?))).collect();
    let in_order = || left.values().zip(right.values()).collect();
    if same_names.is_empty() && left.len() == right.len() { in_order() } else { same_names }
}

/// Ratios of scale factors along x, y and z. An axis without a ratio above 0 gets the mean of the other axes; `None` if no axis has such a
/// ratio.
fn left_over_right(left: &[f64; 3], right: &[f64; 3]) -> Option<[f64; 3]> {
    // A mirrored mesh has a negative factor.
    let ratios: [f64; 3] = std::array::from_fn(|axis| (left[axis] / right[axis]).abs());
    let is_known = |ratio: &f64| ratio.is_finite() && *ratio > 0.0;
    let known: Vec<f64> = ratios.into_iter().filter(is_known).collect();
    let mean = known.iter().sum::<f64>() / known.len() as f64;
    (!known.is_empty()).then(|| ratios.map(|ratio| if is_known(&ratio) { ratio } else { mean }))
}

/// Whether two values are equal apart from rounding.
pub(crate) fn is_close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-6 * expected.abs()
}

// Which axis of the frames of two bodies changes its sign from one side to the other.

/// Frames of two bodies are mirror images if their joints and centres of mass agree within this part of the limb's longest bone.
const CERTAIN_MIRROR: f64 = 0.05;
/// If joints and centres of mass of a pair of bodies only agree within this part of the longest bone, the pair gets the mirror that fits
/// most bodies. The bones of some people differ as much, and some models do not mirror centres of mass.
const LIKELY_MIRROR: f64 = 0.15;
/// A mirror in x or y must fit better than the mirror in z by this factor, because a body with all joints in one plane fits several
/// mirrors.
const CLEARLY_CLOSER: f64 = 0.5;

/// The signs of the possible mirrors. OpenSim's models have z to the right on both sides, so the mirror in z is the first. Some models have
/// another lateral axis, and in some all three axes of the left frame are reversed.
const MIRRORS: [DVec3; 4] =
    [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, 1.0), DVec3::NEG_ONE];

/// A body on the right and its counterpart on the left.
///
/// Places are compared in the frames of the two bodies, not in ground: the default pose of many models is a step, in which one foot
/// is ahead of the other, while the frames of a foot are the same in every pose.
#[derive(Debug, Clone)]
pub(crate) struct BodyPair<'m> {
    pub right: &'m str,
    pub left: &'m str,
    /// The signs by which a place in the right frame becomes its mirror image in the left frame; `None` if the frames are not mirror
    /// images.
    signs: Option<DVec3>,
    /// Sizes of the left bones over the sizes of the right bones.
    sizes: Option<DVec3>,
    /// Length of the longest bone of the limb, m.
    pub bone_m: Option<f64>,
}

impl BodyPair<'_> {
    /// The two mirror images on the left body of a place on the right body: without scaling, and scaled by the sizes of the bones.
    pub(crate) fn mirror_images(&self, right_m: DVec3) -> Option<[DVec3; 2]> {
        let mirrored = self.signs? * right_m;
        Some([mirrored, self.sizes.unwrap_or(DVec3::ONE) * mirrored])
    }

    /// The axis (0, 1 or 2) that leads sideways in both frames, because it alone changes its sign.
    pub(crate) fn reversed_axis(&self) -> Option<usize> {
        let signs = self.signs?;
        let mut reversed = (0..3).filter(|&axis| signs[axis] < 0.0);
        reversed.next().filter(|_| reversed.next().is_none())
    }

    /// The distance of a place on the left body from the nearest mirror image of a place on the right body, m.
    pub(crate) fn apart_m(&self, right_m: DVec3, left_m: DVec3) -> Option<f64> {
        nearest_distance(self.mirror_images(right_m)?, left_m)
    }

    /// The axis whose sign is wrong in one of two places: with the other sign the places are mirror images within `within_m`.
    pub(crate) fn axis_with_wrong_sign(&self, right_m: DVec3, left_m: DVec3, within_m: f64) -> Option<char> {
        let images = self.mirror_images(right_m)?;
        let axis = (0..3).find(|&axis| {
            let mut other = left_m;
            other[axis] = -other[axis];
            nearest_distance(images, other).is_some_and(|apart| apart <= within_m)
        })?;
        ['x', 'y', 'z'].get(axis).copied()
    }
}

/// The distance of a place from the nearer of two mirror images, m.
fn nearest_distance(images: [DVec3; 2], place: DVec3) -> Option<f64> {
    images.into_iter().map(|image| image.distance(place)).reduce(f64::min)
}

/// The pairs of right and left bodies of a model, and the mirror that fits most of them.
pub(crate) struct BodyPairs {
    /// Pairs of bodies by their common name without the side. Sorted, so that sums have the same last bit in each run.
    by_name: BTreeMap<String, LeftAndRightBody>,
    /// The signs of the mirror that fits most bodies.
    common_mirror: DVec3,
}

/// A right and a left body whose names differ only in the side.
#[derive(Debug, Default)]
struct LeftAndRightBody {
    right: Option<String>,
    left: Option<String>,
    /// Centres of mass and joints that both bodies have, in the right and in the left frame, m.
    landmarks: Vec<(DVec3, DVec3)>,
}

impl BodyPairs {
    /// Pairs the moving bodies of `model` whose names differ only in the side.
    pub(crate) fn of(model: &Model) -> Self {
        let mut bodies: BTreeMap<String, [Option<&str>; 2]> = BTreeMap::new();
        for body in model.bodies().iter().filter(|body| !body.fixed) {
            let Some(side) = Side::of_name(&body.name) else { continue };
            let [right, left] = bodies.entry(without_side(&body.name)).or_default();
            let place = if side == Side::Right { right } else { left };
            place.get_or_insert(&body.name);
        }
        let paired = bodies.values().filter_map(|&[right, left]| Some([right?, left?])).flatten().collect();
        let landmarks = landmarks(model, &paired);
        let common_landmarks = |[right, left]: [Option<&str>; 2]| {
            let (right, left) = (landmarks.get(right?)?, landmarks.get(left?)?);
            Some(right.iter().filter_map(|(name, &at_m)| Some((at_m, *left.get(name)?))).collect())
        };
        let same_name = |sides: [Option<&str>; 2]| {
            let [right, left] = sides.map(|name| name.map(str::to_owned));
            LeftAndRightBody { right, left, landmarks: common_landmarks(sides).unwrap_or_default() }
        };
        let by_name = bodies.into_iter().map(|(name, sides)| (name, same_name(sides))).collect();
        Self { common_mirror: common_mirror(&by_name), by_name }
    }

    /// Whether a body of this side exists.
    pub(crate) fn has_side(&self, side: Side) -> bool {
        let mut all = self.by_name.values();
        all.any(|names| if side == Side::Right { &names.right } else { &names.left }.is_some())
    }

    /// The pair to which `body` belongs; `None` if `body` has no counterpart.
    pub(crate) fn pair(&self, body: &str, model: &Model) -> Option<BodyPair<'_>> {
        let bodies = self.by_name.get(&without_side(body))?;
        let (right, left) = (bodies.right.as_deref()?, bodies.left.as_deref()?);
        let bones_m = [right, left].map(|body| model.joint_distances().longest_in_limb(body));
        let bone_m = bones_m.into_iter().flatten().reduce(f64::max);
        let sizes = bone_ratios(model, left, right).map(DVec3::from);
        let pair = BodyPair { right, left, signs: Some(self.common_mirror), sizes, bone_m };
        let Some(bone_m) = bone_m else { return Some(pair) };
        Some(BodyPair { signs: self.signs(&pair, &bodies.landmarks, bone_m), ..pair })
    }

    /// The signs of the mirror in which the landmarks of the two bodies are close; `None` if there is none.
    fn signs(&self, pair: &BodyPair<'_>, landmarks: &[(DVec3, DVec3)], bone_m: f64) -> Option<DVec3> {
        let apart = |signs: DVec3| {
            let pair = BodyPair { signs: Some(signs), ..pair.clone() };
            let apart_m = landmarks.iter().filter_map(|&(right_m, left_m)| pair.apart_m(right_m, left_m));
            apart_m.fold(0.0, f64::max) / bone_m
        };
        if apart(self.common_mirror) <= LIKELY_MIRROR {
            return Some(self.common_mirror);
        }
        MIRRORS.into_iter().find(|&signs| apart(signs) <= CERTAIN_MIRROR)
    }
}

/// The signs of the mirror in which the landmarks of all bodies together are closest.
fn common_mirror(bodies: &BTreeMap<String, LeftAndRightBody>) -> DVec3 {
    let apart_m = |signs: DVec3| -> f64 {
        let landmarks = bodies.values().flat_map(|bodies| &bodies.landmarks);
        landmarks.map(|&(right_m, left_m)| (signs * right_m).distance(left_m)).sum()
    };
    let in_z_m = apart_m(MIRRORS[0]);
    let mirrors = MIRRORS.into_iter().map(|signs| (apart_m(signs), signs));
    let best =
        mirrors.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(apart_m, _)| *apart_m < CLEARLY_CLOSER * in_z_m);
    best.map_or(MIRRORS[0], |(_, signs)| signs)
}

/// A point of a body, which is compared with the same point of the body on the other side.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Landmark {
    /// The centre of mass of a body.
    CentreOfMass,
    /// A joint, by its name without its side. `is_below` says whether it leads to a child of the body and not to its parent.
    Joint { name: String, is_below: bool },
}

/// Centres of mass and joints of the bodies `paired`, which have counterparts.
fn landmarks<'m>(model: &Model, paired: &HashSet<&'m str>) -> HashMap<&'m str, BTreeMap<Landmark, DVec3>> {
    let components = model.components();
    let mut landmarks: HashMap<&str, BTreeMap<Landmark, DVec3>> = HashMap::new();
    for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
        let Some(&body) = paired.get(components.name(id).as_ref()) else { continue };
        if let Some(centre) = components.document_of(id).triple(components.element(id), "mass_center") {
            landmarks.entry(body).or_default().insert(Landmark::CentreOfMass, centre.into());
        }
    }
    for joint in model.joints_between_bodies() {
        let ends = [(&joint.parent, joint.in_parent_m, true), (&joint.child, joint.in_child_m, false)];
        for (body, at_m, is_below) in ends {
            if let Some(&body) = paired.get(body.as_str()) {
                let landmark = Landmark::Joint { name: without_side(&joint.name), is_below };
                landmarks.entry(body).or_default().insert(landmark, at_m);
            }
        }
    }
    landmarks
}

/// The largest number of places near a place that are compared. If there are more in such a small space, they are not the spheres of a
/// foot.
const MOST_NEIGHBOURS: usize = 64;

/// Pairs places of one side with the places `others` of the other side, as indices of `images` and `others`. `images` has the two mirror
/// images of each place, and the nearer one must be at most `within_m` away. The nearest pairs come first; each place is in one pair.
pub(super) fn pair_nearest(images: &[[DVec3; 2]], others: &[DVec3], within_m: f64) -> Vec<(usize, usize)> {
    if !(within_m.is_finite() && within_m > 0.0) {
        return Vec::new();
    }
    let grid = PlaceGrid::of(images, within_m);
    let mut near: Vec<(f64, usize, usize)> = Vec::new();
    for (other, &place) in others.iter().enumerate() {
        let neighbours = grid.neighbours(place).take(MOST_NEIGHBOURS);
        let apart = neighbours.map(|(image, there)| (there.distance(place), image, other));
        near.extend(apart.filter(|(apart, _, _)| *apart <= within_m));
    }
    near.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    // A pair is kept if its two places are in no earlier pair.
    let (mut image_used, mut other_used) = (vec![false; images.len()], vec![false; others.len()]);
    let mut chosen = Vec::new();
    for (_, image, other) in near {
        if !image_used[image] && !other_used[other] {
            (image_used[image], other_used[other]) = (true, true);
            chosen.push((image, other));
        }
    }
    chosen
}

/// Places sorted into cubes of space, so that near places are found without comparing all.
struct PlaceGrid {
    cube_m: f64,
    cubes: HashMap<[i64; 3], Vec<(usize, DVec3)>>,
}

impl PlaceGrid {
    /// Sorts pairs of mirrored places into cubes whose edges are `cube_m` long.
    fn of(images: &[[DVec3; 2]], cube_m: f64) -> Self {
        let mut grid = Self { cube_m, cubes: HashMap::new() };
        for (index, both) in images.iter().enumerate() {
            let are_equal = both[0] == both[1];
            for &place in both.iter().take(if are_equal { 1 } else { 2 }) {
                grid.cubes.entry(grid.cube(place)).or_default().push((index, place));
            }
        }
        grid
    }

    /// The cube in which a place is.
    fn cube(&self, place: DVec3) -> [i64; 3] {
        place.to_array().map(|value| (value / self.cube_m).floor() as i64)
    }

    /// The places in the cube of `place` and in the cubes next to it.
    fn neighbours(&self, place: DVec3) -> impl Iterator<Item = (usize, DVec3)> {
        let [x, y, z] = self.cube(place);
        let adjacent = |value: i64| [value, value.saturating_sub(1), value.saturating_add(1)];
        let cubes = adjacent(x).into_iter().flat_map(move |x| {
            adjacent(y).into_iter().flat_map(move |y| adjacent(z).map(move |z| [x, y, z]))
        });
        cubes.filter_map(|cube| self.cubes.get(&cube)).flatten().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place_gets_the_nearest_unpaired_one() {
        let at = |x: f64| DVec3::new(x, 0.0, 0.0);
        let twice = |x: f64| [at(x); 2];
        let others = [0.011, 0.002, 0.5].map(at);
        // 1 mm and 2 mm apart; nothing is near 0.5.
        assert_eq!(pair_nearest(&[twice(0.0), twice(0.01)], &others, 0.012), [(1, 0), (0, 1)]);
        assert_eq!(pair_nearest(&[twice(0.0)], &others, f64::NAN), []);
        // Across the border of a cube.
        assert_eq!(pair_nearest(&[twice(-1e-9)], &[at(1e-9)], 0.01), [(0, 0)]);
        assert_eq!(pair_nearest(&[twice(1e300)], &[at(1e300)], 0.01), [(0, 0)]);
    }
}
