//! Spheres of the two sides that belong together: by their places, since names number the spheres of some models otherwise on the left
//! than on the right.

use std::collections::BTreeMap;

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use osim_model::{DVec3, Force, Model, ParameterSet, Side, Sphere, SphereId, without_side};

use crate::sides::mirror::{BodyPair, BodyPairs, Bones, near};

/// Published pairs are at most 0.023 of the limb's longest bone apart: beyond this part of it the places differ.
pub(crate) const SAME_PLACE: f64 = 0.03;
/// Spheres of a body that are paired although they are far apart and their names do not agree.
const MOST_BY_ORDER: usize = 32;

/// A sphere on the right and its counterpart on the left.
#[derive(Debug, Clone)]
pub(crate) struct SpherePair<'m> {
    pub right: Placed<'m>,
    pub left: Placed<'m>,
    /// Their bodies, if these are counterparts.
    pub bodies: Option<BodyPair<'m>>,
}

/// A sphere without a counterpart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Alone<'m> {
    pub sphere: Placed<'m>,
    /// The body of the other side that lacks a sphere; `None` where the model has no such body.
    pub other_body: Option<&'m str>,
}

/// All pairs, and the spheres that are left.
#[derive(Debug, Default)]
pub(crate) struct Pairs<'m> {
    pub pairs: Vec<SpherePair<'m>>,
    pub alone: Vec<Alone<'m>>,
}

impl<'m> Pairs<'m> {
    pub(crate) fn of(spheres: Vec<Placed<'m>>, bodies: &'m BodyPairs, bones: &Bones<'_>) -> Self {
        let mut found = Self::default();
        let mut left_over = Vec::new();
        let mut by_body: BTreeMap<String, [Vec<Placed<'m>>; 2]> = BTreeMap::new();
        for placed in spheres {
            let [right, left] = by_body.entry(without_side(placed.body)).or_default();
            if placed.side == Side::Right { right } else { left }.push(placed);
        }
        for (_, [right, left]) in by_body {
            let some = right.first().or(left.first()).and_then(|placed| bodies.pair(placed.body, bones));
            let Some(pair) = some else {
                found
                    .alone
                    .extend(right.into_iter().chain(left).map(|sphere| Alone { sphere, other_body: None }));
                continue;
            };
            let mut on_body = OnBody { pair, right, left };
            found.pairs.extend(on_body.pairs());
            left_over.extend(on_body.alone());
        }
        found.across_bodies(left_over);
        found.pairs.sort_by_key(|pair| pair.left.sphere.id);
        found.alone.sort_by_key(|alone| alone.sphere.sphere.id);
        found
    }

    /// Pairs what is left on different bodies: by names, or the only two. A sphere on the wrong side is of the side in its name.
    fn across_bodies(&mut self, left_over: Vec<Alone<'m>>) {
        let side = |alone: &Alone<'_>| Side::of_name(&alone.sphere.sphere.name).unwrap_or(alone.sphere.side);
        let (mut right, mut left): (Vec<_>, Vec<_>) =
            left_over.into_iter().partition(|alone| side(alone) == Side::Right);
        let mut found = by_name(&mut right, &mut left, |alone| &alone.sphere.sphere.name);
        if right.len() == 1 && left.len() == 1 {
            found.extend(right.drain(..).zip(left.drain(..)));
        }
        let pair = |(right, left): (Alone<'m>, Alone<'m>)| SpherePair {
            right: right.sphere,
            left: left.sphere,
            bodies: None,
        };
        self.pairs.extend(found.into_iter().map(pair));
        self.alone.extend(right.into_iter().chain(left));
    }
}

/// The spheres of two bodies that are counterparts; those that are paired are taken out.
struct OnBody<'m> {
    pair: BodyPair<'m>,
    right: Vec<Placed<'m>>,
    left: Vec<Placed<'m>>,
}

impl<'m> OnBody<'m> {
    fn pairs(&mut self) -> Vec<SpherePair<'m>> {
        let mut found = self.by_place();
        found.extend(by_name(&mut self.right, &mut self.left, |placed| &placed.sphere.name));
        if self.right.len().max(self.left.len()) <= MOST_BY_ORDER {
            found.extend(self.by_distance());
        }
        let both = self.right.len().min(self.left.len());
        found.extend(self.right.drain(..both).zip(self.left.drain(..both)));
        found
            .into_iter()
            .map(|(right, left)| SpherePair { right, left, bodies: Some(self.pair.clone()) })
            .collect()
    }

    /// How far apart spheres are paired by place alone, m.
    fn within_m(&self) -> f64 {
        let radius_m = || self.left.first().map_or(0.0, |placed| placed.sphere.radius.number);
        self.pair.bone_m.map_or_else(radius_m, |bone_m| SAME_PLACE * bone_m)
    }

    fn by_place(&mut self) -> Vec<(Placed<'m>, Placed<'m>)> {
        self.paired_within(self.within_m())
    }

    /// Pairs however far apart.
    fn by_distance(&mut self) -> Vec<(Placed<'m>, Placed<'m>)> {
        let all = self.right.iter().chain(&self.left).flat_map(|placed| placed.place_m.to_array());
        let farthest_m = all.map(f64::abs).fold(0.0, f64::max);
        // No two places of a cube are farther apart, and each cell of it is beside all others.
        self.paired_within(4.0 * farthest_m)
    }

    fn paired_within(&mut self, within_m: f64) -> Vec<(Placed<'m>, Placed<'m>)> {
        let images: Option<Vec<_>> =
            self.right.iter().map(|placed| self.pair.images(placed.place_m)).collect();
        let Some(images) = images else { return Vec::new() };
        let others: Vec<DVec3> = self.left.iter().map(|placed| placed.place_m).collect();
        let found = near(&images, &others, within_m);
        take(&mut self.right, &mut self.left, &found)
    }

    fn alone(self) -> impl Iterator<Item = Alone<'m>> {
        let of = |other_body: &'m str| move |sphere| Alone { sphere, other_body: Some(other_body) };
        let (right, left) = (self.pair.right, self.pair.left);
        self.right.into_iter().map(of(left)).chain(self.left.into_iter().map(of(right)))
    }
}

/// Takes those with equal names, apart from the side, out of both lists; of those with one name the first.
fn by_name<T: Copy>(right: &mut Vec<T>, left: &mut Vec<T>, name: impl Fn(&T) -> &str) -> Vec<(T, T)> {
    let mut named: HashMap<String, usize> = HashMap::new();
    for (index, one) in right.iter().enumerate() {
        named.entry(without_side(name(one))).or_insert(index);
    }
    let pair = |(index, one): (usize, &T)| Some((named.remove(&without_side(name(one)))?, index));
    let found: Vec<(usize, usize)> = left.iter().enumerate().filter_map(pair).collect();
    take(right, left, &found)
}

/// Takes pairs, by their indices, out of both lists.
fn take<T: Copy>(right: &mut Vec<T>, left: &mut Vec<T>, pairs: &[(usize, usize)]) -> Vec<(T, T)> {
    let taken = pairs.iter().filter_map(|&(r, l)| Some((*right.get(r)?, *left.get(l)?))).collect();
    let keep = |list: &mut Vec<T>, gone: std::collections::HashSet<usize>| {
        let mut index = 0..;
        list.retain(|_| index.next().is_none_or(|index| !gone.contains(&index)));
    };
    keep(right, pairs.iter().map(|pair| pair.0).collect());
    keep(left, pairs.iter().map(|pair| pair.1).collect());
    taken
}

// Spheres on limbs: those of forces that meet a floor, by body and side.

/// Places that are this close on one body are one place, m.
pub(crate) const SAME_PLACE_M: f64 = 1e-6;

/// A sphere that meets a floor, and where it is on its body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'m> {
    pub sphere: &'m Sphere,
    pub body: &'m str,
    pub side: Side,
    pub place_m: DVec3,
}

/// The parameter sets by which each sphere meets a floor, in file order.
#[derive(Debug)]
pub(crate) struct Users<'m>(BTreeMap<SphereId, Vec<(&'m Force, &'m ParameterSet)>>);

impl<'m> Users<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        let mut users: BTreeMap<SphereId, Vec<_>> = BTreeMap::new();
        for force in model.forces().iter().filter(|force| model.meets_half_space(force)) {
            for set in &force.sets {
                set.spheres.iter().for_each(|&sphere| users.entry(sphere).or_default().push((force, set)));
            }
        }
        Self(users)
    }

    pub(crate) fn of_sphere(&self, sphere: SphereId) -> &[(&'m Force, &'m ParameterSet)] {
        self.0.get(&sphere).map(Vec::as_slice).unwrap_or_default()
    }

    /// Whether some force of `sphere` is switched on.
    pub(crate) fn applies(&self, sphere: SphereId) -> bool {
        self.of_sphere(sphere).iter().any(|(force, _)| force.applies)
    }

    /// The moving spheres, in file order, with their places on their bodies.
    pub(crate) fn spheres(&self, model: &'m Model) -> impl Iterator<Item = (&'m Sphere, &'m str, DVec3)> {
        let spheres = self.0.keys().filter_map(|&id| model.sphere(id)).filter(|sphere| !sphere.fixed);
        spheres.filter_map(|sphere| Some((sphere, sphere.body.as_deref()?, model.centre_m(sphere.id)?)))
    }

    /// Those on bodies whose name has a side. Of several at one place the first counts.
    pub(crate) fn on_sides(&self, model: &'m Model) -> Vec<Placed<'m>> {
        let mut seen = HashSet::new();
        let on_side = |(sphere, body, place_m)| {
            let side = Side::of_name(body)?;
            seen.insert((body, place_key(place_m))).then_some(Placed { sphere, body, side, place_m })
        };
        self.spheres(model).filter_map(on_side).collect()
    }
}

/// Equal for places that are one.
#[expect(clippy::cast_possible_truncation, reason = "a cast of a float ends at the largest number")]
pub(crate) fn place_key(place_m: DVec3) -> [i64; 3] {
    place_m.to_array().map(|value| (value / SAME_PLACE_M).round() as i64)
}
