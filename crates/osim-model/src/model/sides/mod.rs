//! Contacts of the left and the right side, paired and compared.

mod bones;
mod carriers;
mod differences;
mod mirror;
mod near;
mod pairs;

use std::collections::{BTreeMap, BTreeSet};

use foldhash::{HashMap, HashMapExt};

use self::bones::{Bones, close};
use self::carriers::Users;
pub(crate) use self::carriers::{Placed, place_key};
pub(crate) use self::differences::Difference;
use self::differences::{SetPair, Usual, of_radii};
use self::mirror::BodyPairs;
pub(crate) use self::mirror::distance;
use self::pairs::Pairs;
pub(crate) use self::pairs::{Alone, SAME_PLACE, SpherePair};
use crate::model::contacts::{Force, ForceId, SetId, Sphere};
use crate::model::side::Side;
use crate::model::typed_model::Model;

/// The contacts of both sides, paired by mirrored place: from [`Model::both_sides`].
///
/// ```
/// # let bytes: &[u8] = include_bytes!("../../../tests/data/one_foot.osim");
/// let model = osim_model::Model::parse(bytes)?;
/// // One foot has no counterpart.
/// assert!(model.both_sides().right_of(&model.forces()[0]).is_none());
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug)]
pub struct BothSides<'m> {
    model: &'m Model,
    by_path: HashMap<&'m str, &'m Force>,
    users: Users<'m>,
    bones: Bones<'m>,
    bodies: &'m BodyPairs,
    usual: Usual<'m>,
    pub(crate) pairs: Vec<SpherePair<'m>>,
    /// Spheres without a counterpart, where both sides have spheres.
    pub(crate) alone: Vec<Alone<'m>>,
    /// The spheres of a model that has spheres on one side alone, although it has bodies on both.
    pub(crate) one_side: Vec<Placed<'m>>,
    /// In the order of the forces on the left.
    sets: Vec<SetPair<'m>>,
}

impl Model {
    /// The contacts of both sides, paired.
    #[must_use]
    pub fn both_sides(&self) -> BothSides<'_> {
        BothSides::of(self)
    }
}

impl<'m> BothSides<'m> {
    fn of(model: &'m Model) -> Self {
        let users = Users::of(model);
        let bones = Bones::of(model);
        let spheres = users.on_sides(model);
        let has = |side| spheres.iter().any(|placed| placed.side == side);
        let bodies = model.of_bodies(BodyPairs::of);
        let (mut found, mut one_side) = (Pairs::default(), Vec::new());
        match (has(Side::Right), has(Side::Left)) {
            (true, true) => found = Pairs::of(spheres, bodies, &bones),
            (true, false) if bodies.has(Side::Left) => one_side = spheres,
            (false, true) if bodies.has(Side::Right) => one_side = spheres,
            _ => {}
        }
        let sets = set_pairs(&found.pairs, &users);
        let mut by_path = HashMap::new();
        for force in model.forces() {
            by_path.entry(force.path.as_str()).or_insert(force);
        }
        let (usual, Pairs { pairs, alone }) = (Usual::of(model), found);
        Self { model, by_path, users, bones, bodies, usual, pairs, alone, one_side, sets }
    }

    /// The force with this component path.
    #[must_use]
    pub fn force(&self, path: &str) -> Option<&'m Force> {
        self.by_path.get(path).copied()
    }

    /// The force on the right whose spheres are the mirror images of those of `left`.
    #[must_use]
    pub fn right_of(&self, left: &Force) -> Option<&'m Force> {
        self.sets_of(left).first().map(|pair| pair.right.0)
    }

    /// The forces of one side that have counterparts, in file order.
    #[must_use]
    pub fn forces_on(&self, side: Side) -> Vec<ForceId> {
        let of = |pair: &SetPair<'_>| if side == Side::Right { pair.right.0.id } else { pair.left.0.id };
        self.sets.iter().map(of).collect::<BTreeSet<ForceId>>().into_iter().collect()
    }

    /// Whether the bones under the spheres of `left` are of another size than those under `right`.
    #[must_use]
    pub fn bones_differ(&self, left: &Force, right: &Force) -> bool {
        let sets = self.sets_of(left).iter().filter(|pair| pair.right.0.id == right.id);
        let spheres = sets.flat_map(|pair| &pair.spheres);
        let mut pairs = spheres.filter_map(|&index| self.pairs.get(index));
        pairs.any(|pair| {
            let ratios = self.bones.ratios(pair.left.body, pair.right.body);
            ratios.is_some_and(|ratios| ratios.into_iter().any(|ratio| !close(ratio, 1.0)))
        })
    }

    /// The side whose numbers are unlike those of most other contacts of the model, where `left` and its counterpart differ;
    /// `None` if the majority does not show it.
    #[must_use]
    pub fn odd_side(&self, left: &Force) -> Option<Side> {
        let all = self.sets_of(left).iter().flat_map(|pair| self.differences_of(pair));
        let mut odd = all.filter(|difference| !difference.is_small).map(|difference| difference.odd);
        let first = odd.next()??;
        odd.all(|side| side == Some(first)).then_some(first)
    }

    /// The parameter sets of `left` that have counterparts.
    fn sets_of(&self, left: &Force) -> &[SetPair<'m>] {
        let start = self.sets.partition_point(|pair| pair.left.0.id < left.id);
        let end = self.sets.partition_point(|pair| pair.left.0.id <= left.id);
        self.sets.get(start..end).unwrap_or_default()
    }

    /// Forces that differ, the left one first, with what differs.
    pub(crate) fn differences(&self) -> Vec<(&'m Force, &'m Force, Vec<Difference>)> {
        let mut found: BTreeMap<(ForceId, ForceId), (&Force, &Force, Vec<Difference>)> = BTreeMap::new();
        for pair in &self.sets {
            let (left, right) = (pair.left.0, pair.right.0);
            let (_, _, all) = found.entry((left.id, right.id)).or_insert((left, right, Vec::new()));
            all.extend(self.differences_of(pair));
        }
        found.into_values().filter(|(_, _, differences)| !differences.is_empty()).collect()
    }

    fn differences_of(&self, pair: &SetPair<'_>) -> Vec<Difference> {
        let spheres = pair.spheres.iter().filter_map(|&index| self.pairs.get(index));
        let radii = spheres.filter_map(|spheres| of_radii(spheres, &self.bones, &self.usual));
        // Numbers may differ because radii do.
        radii.chain(pair.differing_values(self.model, &self.usual)).collect()
    }

    /// Whether a force by which `sphere` meets a floor is switched on.
    pub(crate) fn applies(&self, sphere: &Sphere) -> bool {
        self.users.applies(sphere.id)
    }

    /// All moving spheres that meet a floor, in file order, with their bodies and their places there, m.
    pub(crate) fn spheres(&self) -> impl Iterator<Item = (&'m Sphere, &'m str, [f64; 3])> {
        self.users.spheres(self.model)
    }

    /// The longest bone of the limb to which `body` belongs, m; `None` where no body of it has two joints.
    pub(crate) fn longest_of_limb_m(&self, body: &str) -> Option<f64> {
        self.bones.longest_of_limb_m(body)
    }

    /// The axis of its frame (0, 1 or 2) that leads from `body` sideways; `None` if no body of the other side is its mirror image in one
    /// axis.
    pub(crate) fn sideways_axis(&self, body: &str) -> Option<usize> {
        self.bodies.pair(body, &self.bones)?.reversed_axis()
    }
}

/// Parameter sets that are counterparts because their spheres are: those of the first sphere that they share.
fn set_pairs<'m>(pairs: &[SpherePair<'m>], users: &Users<'m>) -> Vec<SetPair<'m>> {
    let mut found: BTreeMap<(ForceId, SetId, ForceId, SetId), SetPair<'m>> = BTreeMap::new();
    for (index, pair) in pairs.iter().enumerate() {
        let of = |placed: &Placed<'_>| users.of_sphere(placed.sphere.id).iter().copied();
        for (left, right) in of(&pair.left).zip(of(&pair.right)) {
            let key = (left.0.id, left.1.id, right.0.id, right.1.id);
            let empty = || SetPair { right, left, spheres: Vec::new() };
            found.entry(key).or_insert_with(empty).spheres.push(index);
        }
    }
    found.into_values().collect()
}
