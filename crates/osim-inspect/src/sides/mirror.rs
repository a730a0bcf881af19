//! The mirror between two bodies: how large the bones of both sides are, which axis changes its sign, and which places belong together.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::{DVec3, Model, Side, without_side};

/// Sizes of the bones that carry spheres: factors of their meshes, and distances between their joints.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bones<'m> {
    model: &'m Model,
}

impl<'m> Bones<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model }
    }

    /// The longest bone of the limb to which `body` belongs, m; `None` where no body of it has two joints.
    pub(crate) fn longest_of_limb_m(&self, body: &str) -> Option<f64> {
        self.model.joint_distances().longest_in_limb(body)
    }

    /// By how much the body `left` is larger than `right`, along x, y and z: by their meshes, else by the distances between
    /// their joints; `None` where neither says it.
    pub(crate) fn ratios(&self, left: &str, right: &str) -> Option<[f64; 3]> {
        self.of_meshes(left, right).or_else(|| {
            let distances = self.model.joint_distances();
            let ratio = distances.longest_in_body(left)? / distances.longest_in_body(right)?;
            (ratio.is_finite() && ratio > 0.0).then_some([ratio; 3])
        })
    }

    /// The reflection that meshes show; `None` where no mesh shows the same bone, or these do not agree.
    fn of_meshes(&self, left: &str, right: &str) -> Option<[f64; 3]> {
        let meshes = self.model.mesh_factors();
        let (left, right) = (meshes.get(left)?, meshes.get(right)?);
        let mut ratios = same_bones(left, right).into_iter().filter_map(|(l, r)| ratio(l, r));
        let first = ratios.next()?;
        ratios.all(|other| other.into_iter().zip(first).all(|(a, b)| close(a, b))).then_some(first)
    }
}

type Factors<'b> = (&'b [f64; 3], &'b [f64; 3]);

/// The factors of meshes of the same bone: by their names, else in their order.
fn same_bones<'b>(
    left: &'b BTreeMap<String, [f64; 3]>,
    right: &'b BTreeMap<String, [f64; 3]>,
) -> Vec<Factors<'b>> {
    let by_name: HashMap<String, &[f64; 3]> =
        right.iter().map(|(file, factors)| (without_side(file), factors)).collect();
    let named: Vec<Factors<'b>> =
        left.iter().filter_map(|(file, l)| Some((l, *by_name.get(&without_side(file))?))).collect();
    let in_order = || left.values().zip(right.values()).collect();
    if named.is_empty() && left.len() == right.len() { in_order() } else { named }
}

/// Left over right. An axis without a number takes the mean of the others, so that it does not end the comparison; `None` where
/// no axis has one.
fn ratio(left: &[f64; 3], right: &[f64; 3]) -> Option<[f64; 3]> {
    // A mirrored mesh has a negative factor.
    let of_axes: [f64; 3] = std::array::from_fn(|axis| (left[axis] / right[axis]).abs());
    let is_known = |ratio: &f64| ratio.is_finite() && *ratio > 0.0;
    let known: Vec<f64> = of_axes.into_iter().filter(is_known).collect();
    #[expect(clippy::cast_precision_loss, reason = "at most three axes")]
    let mean = known.iter().sum::<f64>() / known.len() as f64;
    (!known.is_empty()).then(|| of_axes.map(|ratio| if is_known(&ratio) { ratio } else { mean }))
}

/// Whether two values are the same, apart from rounding.
pub(crate) fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-6 * expected.abs()
}

// The mirror between two bodies: which axis of their frames changes its sign from one side to the other.

/// Frames of two bodies are mirror images where their joints and centres of mass are that close, as a part of the limb's longest bone.
const SURE: f64 = 0.05;
/// Up to here, the mirror of the other bodies is taken: the bones of some people differ that much, and centres of mass of some models are
/// not mirrored.
const LIKELY: f64 = 0.15;
/// Another mirror than z has to be that much closer: a body with all joints in one plane shows none.
const CLOSER: f64 = 0.5;

/// OpenSim's own models have z to the right on both sides, so z comes first; some models have another lateral axis, and some have a
/// left frame in which all three axes are reversed.
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
    /// The signs that lead from the right frame to the left one; `None` where the frames are not mirror images.
    signs: Option<DVec3>,
    /// Left over right.
    sizes: Option<DVec3>,
    /// The longest bone of the limb, m.
    pub bone_m: Option<f64>,
}

impl BodyPair<'_> {
    /// Where a place on the right body belongs on the left one: as far from its origin, and as the sizes of the bones have it.
    pub(crate) fn images(&self, right_m: DVec3) -> Option<[DVec3; 2]> {
        let mirrored = self.signs? * right_m;
        Some([mirrored, self.sizes.unwrap_or(DVec3::ONE) * mirrored])
    }

    /// The only axis that changes its sign (0, 1 or 2): in the frames of both bodies it leads sideways.
    pub(crate) fn reversed_axis(&self) -> Option<usize> {
        let signs = self.signs?;
        let mut reversed = (0..3).filter(|&axis| signs[axis] < 0.0);
        reversed.next().filter(|_| reversed.next().is_none())
    }

    /// How far a place on the left body is from the mirror image of one on the right body, m.
    pub(crate) fn apart_m(&self, right_m: DVec3, left_m: DVec3) -> Option<f64> {
        nearest(self.images(right_m)?, left_m)
    }

    /// The axis that would have to change its sign on the left body for the places to be mirror images; `None` if none would
    /// bring them closer than `within_m`.
    pub(crate) fn other_sign(&self, right_m: DVec3, left_m: DVec3, within_m: f64) -> Option<char> {
        let images = self.images(right_m)?;
        let axis = (0..3).find(|&axis| {
            let mut other = left_m;
            other[axis] = -other[axis];
            nearest(images, other).is_some_and(|apart| apart <= within_m)
        })?;
        ['x', 'y', 'z'].get(axis).copied()
    }
}

fn nearest(images: [DVec3; 2], place: DVec3) -> Option<f64> {
    images.into_iter().map(|image| image.distance(place)).reduce(f64::min)
}

#[derive(Debug)]
pub(crate) struct BodyPairs {
    /// By the name without its side; in order, so that sums have the same last bit in each run.
    named: BTreeMap<String, Named>,
    /// The mirror that fits most bodies.
    usual: DVec3,
}

/// Bodies of one name but for its side.
#[derive(Debug, Default)]
struct Named {
    right: Option<String>,
    left: Option<String>,
    /// Centres of mass and joints that both have, in the frame of each, m: right, left.
    marks: Vec<(DVec3, DVec3)>,
}

impl Named {
    fn both(&self) -> Option<(&str, &str)> {
        Some((self.right.as_deref()?, self.left.as_deref()?))
    }
}

impl BodyPairs {
    pub(crate) fn of(model: &Model) -> Self {
        let mut bodies: BTreeMap<String, [Option<&str>; 2]> = BTreeMap::new();
        for body in model.bodies().iter().filter(|body| !body.fixed) {
            let Some(side) = Side::of_name(&body.name) else { continue };
            let [right, left] = bodies.entry(without_side(&body.name)).or_default();
            let own = if side == Side::Right { right } else { left };
            own.get_or_insert(&body.name);
        }
        let paired = bodies.values().filter_map(|&[right, left]| Some([right?, left?])).flatten().collect();
        let marks = marks(model, &paired);
        let of_both = |[right, left]: [Option<&str>; 2]| {
            let (right, left) = (marks.get(right?)?, marks.get(left?)?);
            Some(right.iter().filter_map(|(name, &at_m)| Some((at_m, *left.get(name)?))).collect())
        };
        let named = |sides: [Option<&str>; 2]| {
            let [right, left] = sides.map(|name| name.map(str::to_owned));
            Named { right, left, marks: of_both(sides).unwrap_or_default() }
        };
        let named = bodies.into_iter().map(|(name, sides)| (name, named(sides))).collect();
        Self { usual: usual(&named), named }
    }

    pub(crate) fn has(&self, side: Side) -> bool {
        let mut all = self.named.values();
        all.any(|names| if side == Side::Right { &names.right } else { &names.left }.is_some())
    }

    /// The pair to which `body` belongs; `None` if it has no counterpart.
    pub(crate) fn pair(&self, body: &str, bones: &Bones<'_>) -> Option<BodyPair<'_>> {
        let names = self.named.get(&without_side(body))?;
        let (right, left) = names.both()?;
        let bone_m =
            [right, left].into_iter().filter_map(|body| bones.longest_of_limb_m(body)).reduce(f64::max);
        let sizes = bones.ratios(left, right).map(DVec3::from);
        let pair = BodyPair { right, left, signs: Some(self.usual), sizes, bone_m };
        let Some(bone_m) = bone_m else { return Some(pair) };
        Some(BodyPair { signs: self.signs(&pair, &names.marks, bone_m), ..pair })
    }

    /// The mirror in which the marks of the two bodies are close; `None` if there is none.
    fn signs(&self, pair: &BodyPair<'_>, marks: &[(DVec3, DVec3)], bone_m: f64) -> Option<DVec3> {
        let apart = |signs: DVec3| {
            let pair = BodyPair { signs: Some(signs), ..pair.clone() };
            let apart_m = marks.iter().filter_map(|&(right_m, left_m)| pair.apart_m(right_m, left_m));
            apart_m.fold(0.0, f64::max) / bone_m
        };
        if apart(self.usual) <= LIKELY {
            return Some(self.usual);
        }
        MIRRORS.into_iter().find(|&signs| apart(signs) <= SURE)
    }
}

/// The mirror in which the marks of all bodies together are closest.
fn usual(named: &BTreeMap<String, Named>) -> DVec3 {
    let apart_m = |signs: DVec3| -> f64 {
        let marks = named.values().flat_map(|names| &names.marks);
        marks.map(|&(right_m, left_m)| (signs * right_m).distance(left_m)).sum()
    };
    let of_z = apart_m(MIRRORS[0]);
    let others = MIRRORS.into_iter().map(|signs| (apart_m(signs), signs));
    let best = others.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(apart_m, _)| *apart_m < CLOSER * of_z);
    best.map_or(MIRRORS[0], |(_, signs)| signs)
}

/// What a mark is, in the order in which they are compared.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Mark {
    Centre,
    /// A joint, by its name without its side; above the body or below it.
    Joint {
        name: String,
        is_below: bool,
    },
}

/// Centres of mass and joints of the bodies `paired`, which have counterparts.
fn marks<'m>(model: &Model, paired: &HashSet<&'m str>) -> HashMap<&'m str, BTreeMap<Mark, DVec3>> {
    let components = model.components();
    let mut marks: HashMap<&str, BTreeMap<Mark, DVec3>> = HashMap::new();
    for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
        let Some(&body) = paired.get(components.name(id).as_ref()) else { continue };
        if let Some(centre) = components.doc(id).triple(components.element(id), "mass_center") {
            marks.entry(body).or_default().insert(Mark::Centre, centre.into());
        }
    }
    for joint in model.joints_between_bodies() {
        let ends = [(&joint.parent, joint.in_parent_m, true), (&joint.child, joint.in_child_m, false)];
        for (body, at_m, is_below) in ends {
            if let Some(&body) = paired.get(body.as_str()) {
                let mark = Mark::Joint { name: without_side(&joint.name), is_below };
                marks.entry(body).or_default().insert(mark, at_m);
            }
        }
    }
    marks
}

// Places of two sets that belong together because they are near.

/// How many places around one are looked at: where more are in so small a space, they are not those of a foot.
const MOST_AROUND: usize = 64;

/// Pairs of places, as indices of `images` and `others`, that are at most `within_m` apart: the nearest ones first, each place once.
pub(super) fn near(images: &[[DVec3; 2]], others: &[DVec3], within_m: f64) -> Vec<(usize, usize)> {
    if !(within_m.is_finite() && within_m > 0.0) {
        return Vec::new();
    }
    let cells = Cells::of(images, within_m);
    let mut found: Vec<(f64, usize, usize)> = Vec::new();
    for (other, &place) in others.iter().enumerate() {
        let around = cells.around(place).take(MOST_AROUND);
        let apart = around.map(|(image, there)| (there.distance(place), image, other));
        found.extend(apart.filter(|(apart, _, _)| *apart <= within_m));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    each_once(found.into_iter().map(|(_, image, other)| (image, other)), images.len(), others.len())
}

/// The first pairs whose places are in no earlier one.
fn each_once(
    pairs: impl Iterator<Item = (usize, usize)>,
    images: usize,
    others: usize,
) -> Vec<(usize, usize)> {
    let (mut image_used, mut other_used) = (vec![false; images], vec![false; others]);
    let mut chosen = Vec::new();
    for (image, other) in pairs {
        let (Some(one), Some(two)) = (image_used.get_mut(image), other_used.get_mut(other)) else { continue };
        if !*one && !*two {
            (*one, *two) = (true, true);
            chosen.push((image, other));
        }
    }
    chosen
}

/// Places by the cube of space that they are in, so that what is near is found without looking at all.
struct Cells {
    side_m: f64,
    places: HashMap<[i64; 3], Vec<(usize, DVec3)>>,
}

impl Cells {
    fn of(images: &[[DVec3; 2]], side_m: f64) -> Self {
        let mut cells = Self { side_m, places: HashMap::new() };
        for (index, both) in images.iter().enumerate() {
            let twice = both[0] == both[1];
            for &place in both.iter().take(if twice { 1 } else { 2 }) {
                cells.places.entry(cells.cell(place)).or_default().push((index, place));
            }
        }
        cells
    }

    #[expect(clippy::cast_possible_truncation, reason = "a cast of a float ends at the largest number")]
    fn cell(&self, place: DVec3) -> [i64; 3] {
        place.to_array().map(|value| (value / self.side_m).floor() as i64)
    }

    /// The places in the cell of `place` and those beside it.
    fn around(&self, place: DVec3) -> impl Iterator<Item = (usize, DVec3)> {
        let [x, y, z] = self.cell(place);
        let beside = |value: i64| [value, value.saturating_sub(1), value.saturating_add(1)];
        let cells = beside(x)
            .into_iter()
            .flat_map(move |x| beside(y).into_iter().flat_map(move |y| beside(z).map(move |z| [x, y, z])));
        cells.filter_map(|cell| self.places.get(&cell)).flatten().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place_has_the_nearest_one_that_is_free() {
        let at = |x: f64| DVec3::new(x, 0.0, 0.0);
        let twice = |x: f64| [at(x); 2];
        let others = [0.011, 0.002, 0.5].map(at);
        // 1 mm and 2 mm apart; nothing is near 0.5.
        assert_eq!(near(&[twice(0.0), twice(0.01)], &others, 0.012), [(1, 0), (0, 1)]);
        assert_eq!(near(&[twice(0.0)], &others, f64::NAN), []);
        // Across the border of a cell.
        assert_eq!(near(&[twice(-1e-9)], &[at(1e-9)], 0.01), [(0, 0)]);
        assert_eq!(near(&[twice(1e300)], &[at(1e300)], 0.01), [(0, 0)]);
    }
}
