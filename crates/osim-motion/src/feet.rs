//! Which contacts belong to one foot.

use std::collections::{BTreeSet, HashMap};

use osim_model::{ForceId, Model, Side, SphereId};

use crate::states::ContactStates;

/// The contacts of one limb.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Foot {
    /// `right foot`, `left foot`, or the name of the limb's first body.
    pub name: String,
    /// Its side, where its names say one.
    pub side: Option<Side>,
    /// Its pairs among all.
    pub pairs: Vec<usize>,
    /// Its bodies with spheres, in their order.
    pub bodies: Vec<String>,
}

impl Foot {
    /// The feet of `model` by the limbs of its applied `forces`; where limbs are not known, by the side of the spheres' bodies.
    #[must_use]
    pub fn all(model: &Model, states: &ContactStates, forces: &[ForceId]) -> Vec<Self> {
        let limbs = model.limbs(forces);
        let groups: Vec<(String, Option<Side>, Vec<usize>)> = match limbs.known() {
            Some(limbs) => {
                let by_sphere = reactions_by_sphere(states);
                let of = |spheres: &[SphereId]| {
                    let own = spheres.iter().filter_map(|sphere| by_sphere.get(sphere)).flatten();
                    own.copied().collect::<BTreeSet<usize>>().into_iter().collect()
                };
                limbs.iter().map(|limb| (limb.name.clone(), Some(limb.side), of(&limb.spheres))).collect()
            }
            None => by_side(states),
        };
        let count = |side: Side| groups.iter().filter(|(_, other, _)| *other == Some(side)).count();
        let [right, left] = [Side::Right, Side::Left].map(count);
        let several = |side: Side| (if side == Side::Right { right } else { left }) > 1;
        groups
            .iter()
            .filter(|(_, _, pairs)| !pairs.is_empty())
            .map(|(name, side, pairs)| Self {
                name: match side {
                    Some(side) if !several(*side) => format!("{} foot", side.as_str()),
                    _ => name.clone(),
                },
                side: *side,
                bodies: bodies(states, pairs),
                pairs: pairs.clone(),
            })
            .collect()
    }
}

fn pairs(states: &ContactStates, is_own: impl Fn(usize) -> bool) -> Vec<usize> {
    (0..states.pairs.len()).filter(|&index| is_own(index)).collect()
}

/// The pairs of each sphere through which the ground pushes.
fn reactions_by_sphere(states: &ContactStates) -> HashMap<SphereId, Vec<usize>> {
    let mut found: HashMap<SphereId, Vec<usize>> = HashMap::new();
    for index in pairs(states, |index| is_reaction(states, index)) {
        if let Some(pair) = states.pairs.get(index) {
            found.entry(pair.sphere).or_default().push(index);
        }
    }
    found
}

/// Whether the ground pushes through it.
fn is_reaction(states: &ContactStates, index: usize) -> bool {
    states.pairs.get(index).is_some_and(|pair| pair.applies && pair.is_ground)
}

fn by_side(states: &ContactStates) -> Vec<(String, Option<Side>, Vec<usize>)> {
    let side = |index: usize| states.pairs.get(index).and_then(|pair| Side::of_name(&pair.body));
    let group = |name: &str, wanted: Option<Side>| {
        (name.to_owned(), wanted, pairs(states, |index| is_reaction(states, index) && side(index) == wanted))
    };
    vec![group("right", Some(Side::Right)), group("left", Some(Side::Left)), group("all contacts", None)]
}

fn bodies(states: &ContactStates, pairs: &[usize]) -> Vec<String> {
    let mut bodies: Vec<String> = Vec::new();
    for pair in pairs.iter().filter_map(|&index| states.pairs.get(index)) {
        if !bodies.contains(&pair.body) {
            bodies.push(pair.body.clone());
        }
    }
    bodies
}
