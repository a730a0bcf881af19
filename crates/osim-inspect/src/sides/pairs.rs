//! Pairs the spheres of the two sides by their places. Names alone are not enough, because some models number the left and the right
//! spheres differently.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use osim_model::{DVec3, Force, Model, ParameterSet, Side, Sphere, SphereId, without_side};

use crate::sides::mirror::{BodyPair, BodyPairs, pair_nearest};

/// Two spheres are at the same place if one is at most this part of the limb's longest bone from the mirror image of the other. Published
/// pairs are at most 0.023 apart.
pub(crate) const SAME_PLACE_OF_BONE: f64 = 0.03;
/// At most this many spheres of a body are paired by distance although they are far apart and have different names.
const MOST_BY_DISTANCE: usize = 32;

/// A sphere on the right and its counterpart on the left.
#[derive(Debug, Clone)]
pub(crate) struct SpherePair<'m> {
    pub right: SideSphere<'m>,
    pub left: SideSphere<'m>,
    /// The bodies of the two spheres, if these bodies are counterparts, too.
    pub bodies: Option<BodyPair<'m>>,
}

/// A sphere without a counterpart on the other side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UnpairedSphere<'m> {
    pub sphere: SideSphere<'m>,
    /// The body of the other side that lacks a sphere; `None` if the model has no such body.
    pub other_body: Option<&'m str>,
}

/// All pairs of spheres, and the spheres without a counterpart.
#[derive(Debug, Default)]
pub(crate) struct SpherePairs<'m> {
    pub pairs: Vec<SpherePair<'m>>,
    pub unpaired: Vec<UnpairedSphere<'m>>,
}

impl<'m> SpherePairs<'m> {
    /// Pairs the `spheres` of both sides: on bodies that are counterparts first, then across bodies.
    pub(crate) fn of(spheres: Vec<SideSphere<'m>>, bodies: &'m BodyPairs, model: &Model) -> Self {
        let mut result = Self::default();
        let mut left_over = Vec::new();
        let mut by_body: BTreeMap<String, [Vec<SideSphere<'m>>; 2]> = BTreeMap::new();
        for placed in spheres {
            let [right, left] = by_body.entry(without_side(placed.body)).or_default();
            if placed.side == Side::Right { right } else { left }.push(placed);
        }
        for (_, [right, left]) in by_body {
            let first = right.first().or(left.first());
            let Some(pair) = first.and_then(|sphere| bodies.pair(sphere.body, model)) else {
                let unpaired = |sphere| UnpairedSphere { sphere, other_body: None };
                result.unpaired.extend(right.into_iter().chain(left).map(unpaired));
                continue;
            };
            let mut spheres = UnpairedOfBodies { pair, right, left };
            result.pairs.extend(spheres.take_pairs());
            left_over.extend(spheres.into_unpaired());
        }
        result.pair_across_bodies(left_over);
        result.pairs.sort_by_key(|pair| pair.left.sphere.id);
        result.unpaired.sort_by_key(|unpaired| unpaired.sphere.sphere.id);
        result
    }

    /// Pairs spheres on bodies that are not counterparts: by their names, or the only two spheres. The side of a sphere is the side in its
    /// name, because its body can be on the wrong side.
    fn pair_across_bodies(&mut self, left_over: Vec<UnpairedSphere<'m>>) {
        let side = |unpaired: &UnpairedSphere<'_>| {
            Side::of_name(&unpaired.sphere.sphere.name).unwrap_or(unpaired.sphere.side)
        };
        let (mut right, mut left): (Vec<_>, Vec<_>) =
            left_over.into_iter().partition(|unpaired| side(unpaired) == Side::Right);
        let mut pairs = take_same_names(&mut right, &mut left, |unpaired| &unpaired.sphere.sphere.name);
        if right.len() == 1 && left.len() == 1 {
            pairs.extend(right.drain(..).zip(left.drain(..)));
        }
        let pair = |(right, left): (UnpairedSphere<'m>, UnpairedSphere<'m>)| SpherePair {
            right: right.sphere,
            left: left.sphere,
            bodies: None,
        };
        self.pairs.extend(pairs.into_iter().map(pair));
        self.unpaired.extend(right.into_iter().chain(left));
    }
}

/// The spheres of two bodies that are counterparts. Spheres that are paired are taken out.
struct UnpairedOfBodies<'m> {
    pair: BodyPair<'m>,
    right: Vec<SideSphere<'m>>,
    left: Vec<SideSphere<'m>>,
}

impl<'m> UnpairedOfBodies<'m> {
    /// Pairs spheres by place, then by name, then by distance, then by order. Takes the paired spheres out.
    fn take_pairs(&mut self) -> Vec<SpherePair<'m>> {
        let mut pairs = self.take_within(self.same_place_m());
        pairs.extend(take_same_names(&mut self.right, &mut self.left, |placed| &placed.sphere.name));
        if self.right.len().max(self.left.len()) <= MOST_BY_DISTANCE {
            pairs.extend(self.take_nearest());
        }
        let count = self.right.len().min(self.left.len());
        pairs.extend(self.right.drain(..count).zip(self.left.drain(..count)));
        pairs
            .into_iter()
            .map(|(right, left)| SpherePair { right, left, bodies: Some(self.pair.clone()) })
            .collect()
    }

    /// The largest distance, m, of two spheres at the same place.
    fn same_place_m(&self) -> f64 {
        let radius_m = || self.left.first().map_or(0.0, |placed| placed.sphere.radius.number);
        self.pair.bone_m.map_or_else(radius_m, |bone_m| SAME_PLACE_OF_BONE * bone_m)
    }

    /// Pairs spheres at any distance, the nearest spheres first.
    fn take_nearest(&mut self) -> Vec<(SideSphere<'m>, SideSphere<'m>)> {
        let all = self.right.iter().chain(&self.left).flat_map(|placed| placed.place_m.to_array());
        let farthest_m = all.map(f64::abs).fold(0.0, f64::max);
        // All places are in a cube of this size: none are farther apart, and all its cells are neighbours.
        self.take_within(4.0 * farthest_m)
    }

    /// Pairs spheres whose places are mirror images within this distance, m, and takes them out.
    fn take_within(&mut self, within_m: f64) -> Vec<(SideSphere<'m>, SideSphere<'m>)> {
        let images: Option<Vec<_>> =
            self.right.iter().map(|placed| self.pair.mirror_images(placed.place_m)).collect();
        let Some(images) = images else { return Vec::new() };
        let others: Vec<DVec3> = self.left.iter().map(|placed| placed.place_m).collect();
        let pairs = pair_nearest(&images, &others, within_m);
        take_matched(&mut self.right, &mut self.left, &pairs)
    }

    /// The spheres that were not paired, with the body of the other side.
    fn into_unpaired(self) -> impl Iterator<Item = UnpairedSphere<'m>> {
        let lacking_on =
            |other_body: &'m str| move |sphere| UnpairedSphere { sphere, other_body: Some(other_body) };
        let (right, left) = (self.pair.right, self.pair.left);
        self.right.into_iter().map(lacking_on(left)).chain(self.left.into_iter().map(lacking_on(right)))
    }
}

/// Takes pairs with equal names, apart from the side, out of both lists. Of several with the same name, it takes the first.
fn take_same_names<T: Copy>(right: &mut Vec<T>, left: &mut Vec<T>, name: impl Fn(&T) -> &str) -> Vec<(T, T)> {
    let mut right_by_name: HashMap<String, usize> = HashMap::new();
    for (index, one) in right.iter().enumerate() {
        right_by_name.entry(without_side(name(one))).or_insert(index);
    }
    let pair = |(index, one): (usize, &T)| Some((right_by_name.remove(&without_side(name(one)))?, index));
    let pairs: Vec<(usize, usize)> = left.iter().enumerate().filter_map(pair).collect();
    take_matched(right, left, &pairs)
}

/// Takes pairs, by their indices, out of both lists.
fn take_matched<T: Copy>(right: &mut Vec<T>, left: &mut Vec<T>, pairs: &[(usize, usize)]) -> Vec<(T, T)> {
    let taken = pairs.iter().filter_map(|&(r, l)| Some((*right.get(r)?, *left.get(l)?))).collect();
    let keep = |list: &mut Vec<T>, gone: std::collections::HashSet<usize>| {
        let mut index = 0..;
        list.retain(|_| index.next().is_none_or(|index| !gone.contains(&index)));
    };
    keep(right, pairs.iter().map(|pair| pair.0).collect());
    keep(left, pairs.iter().map(|pair| pair.1).collect());
    taken
}

/// Places on one body that are at most this far apart are the same, m.
const SAME_PLACE_M: f64 = 1e-6;

/// A sphere that meets a floor, on a body whose name has a side.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SideSphere<'m> {
    pub sphere: &'m Sphere,
    pub body: &'m str,
    pub side: Side,
    /// The centre in the frame of the body, m.
    pub place_m: DVec3,
}

/// For each sphere, the parameter sets by which it meets a floor, in file order.
pub(crate) struct SetsBySphere<'m>(BTreeMap<SphereId, Vec<(&'m Force, &'m ParameterSet)>>);

impl<'m> SetsBySphere<'m> {
    /// The parameter sets of all forces of `model` that can press a moving sphere on a half-space.
    pub(crate) fn of(model: &'m Model) -> Self {
        let mut sets: BTreeMap<SphereId, Vec<_>> = BTreeMap::new();
        for force in model.forces().iter().filter(|force| model.meets_half_space(force)) {
            for set in &force.sets {
                set.spheres.iter().for_each(|&sphere| sets.entry(sphere).or_default().push((force, set)));
            }
        }
        Self(sets)
    }

    /// The forces, with their parameter sets, by which `sphere` meets a floor.
    pub(crate) fn get(&self, sphere: SphereId) -> &[(&'m Force, &'m ParameterSet)] {
        self.0.get(&sphere).map(Vec::as_slice).unwrap_or_default()
    }

    /// Whether a force that presses `sphere` is switched on.
    pub(crate) fn applies(&self, sphere: SphereId) -> bool {
        self.get(sphere).iter().any(|(force, _)| force.applies)
    }

    /// The moving spheres, in file order, with their places on their bodies.
    pub(crate) fn spheres(&self, model: &'m Model) -> impl Iterator<Item = (&'m Sphere, &'m str, DVec3)> {
        let spheres = self.0.keys().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
        spheres.filter_map(|sphere| Some((sphere, sphere.body.as_deref()?, model.centre_m(sphere.id)?)))
    }

    /// The moving spheres on bodies whose name has a side. Of several spheres at one place, only the first counts.
    pub(crate) fn spheres_on_sides(&self, model: &'m Model) -> Vec<SideSphere<'m>> {
        let mut seen = HashSet::new();
        let on_side = |(sphere, body, place_m)| {
            let side = Side::of_name(body)?;
            seen.insert((body, place_key(place_m))).then_some(SideSphere { sphere, body, side, place_m })
        };
        self.spheres(model).filter_map(on_side).collect()
    }
}

/// A key for a place on a body. Places that differ only by rounding have the same key.
pub(crate) fn place_key(place_m: DVec3) -> [i64; 3] {
    place_m.to_array().map(|value| (value / SAME_PLACE_M).round() as i64)
}
