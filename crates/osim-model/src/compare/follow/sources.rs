//! What each source says about the factors of a body, and which is taken.

use crate::model::{Anatomy, FactorQuestion, Side, without_side};
use foldhash::{HashMap, HashMapExt};

use super::body_factors::{AXES, AxisFactor, FactorSource, length};
use super::bones::{self, BonePair};
use super::copy::SHORTEST_OFFSET_M;
use super::distance::{Distance, Distances};
use super::scale_file::ScaleFile;

/// Sources of a scaled copy that differ by more than this (relative) disagree.
const AGREEMENT_IN_A_COPY: f64 = 0.01;
/// Sources that differ by more than this between different models disagree.
pub(super) const AGREEMENT: f64 = 0.05;

/// A bone in a mesh that differs by more than this ratio from what the joints of its body say is another animal's: bones of one name
/// have other proportions, and no two published models differ so much in them.
const OTHER_BONE: f64 = 2.0;

/// What each source says about one body.
#[derive(Debug)]
pub(super) struct Sources<'a> {
    pub(super) body: &'a str,
    /// Sources with their factors, in the order in which they count.
    pub(super) said: Vec<(FactorSource, [Option<f64>; 3])>,
    /// Meshes that show the same bone.
    pub(super) meshes: Vec<BonePair>,
    /// Between different models: the joint that the distance goes to.
    distance: Option<Distance<'a>>,
    in_a_copy: bool,
}

impl<'a> Sources<'a> {
    pub(super) fn of(
        scaled: &'a Anatomy,
        reference: &Anatomy,
        body: &'a str,
        file: Option<&ScaleFile>,
        given: Option<&[f64; 3]>,
        distances: Option<&Distances<'a>>,
    ) -> Self {
        let in_a_copy = distances.is_none();
        let meshes = bones::pairs(scaled, reference, body);
        let distance = distances.and_then(|distances| distances.farthest(body));
        let mut said = Vec::new();
        if let Some(given) = given {
            said.push((FactorSource::Given, given.map(Some)));
        }
        if let Some(values) = file.and_then(|file| file.factors(body)) {
            said.push((FactorSource::ScaleFile, values.map(Some)));
        }
        said.push((FactorSource::Mesh, meshes.first().map_or([None; 3], |pair| pair.factors)));
        if in_a_copy {
            said.push((FactorSource::Joint, joint_factors(scaled, reference, body)));
        } else {
            let ratio = distance.as_ref().map(Distance::ratio);
            said.push((FactorSource::Distance, [ratio; 3]));
        }
        said.retain(|(_, values)| values.iter().any(Option::is_some));
        Self { body, said, meshes, distance, in_a_copy }
    }

    fn value(&self, source: FactorSource, axis: usize) -> Option<f64> {
        self.said.iter().find(|(known, _)| *known == source).and_then(|(_, values)| values[axis])
    }

    fn first(&self, axis: usize) -> Option<AxisFactor> {
        let mut known = self.said.iter();
        known.find_map(|(source, values)| Some(AxisFactor { factor: values[axis]?, source: *source }))
    }

    /// Sources that do not say what was taken.
    pub(super) fn disagreements(&self, taken: &[Option<AxisFactor>; 3]) -> Vec<String> {
        let limit = if self.in_a_copy { AGREEMENT_IN_A_COPY } else { AGREEMENT };
        let mut messages = Vec::new();
        for (axis, name) in AXES.iter().enumerate() {
            let Some(AxisFactor { factor, source }) = taken[axis] else { continue };
            let others =
                self.said.iter().filter(|(other, _)| *other > source && *other != FactorSource::Distance);
            for (other, value) in others.filter_map(|(other, values)| Some((other, values[axis]?))) {
                if (value - factor).abs() > limit * factor {
                    messages.push(format!(
                        "body {}, {name}: {} says {factor:.6}, {} says {value:.6}; took the first",
                        self.body,
                        source.as_str(),
                        other.as_str()
                    ));
                }
            }
        }
        messages.extend(self.distance_disagrees(taken));
        messages
    }

    /// A distance is one number: it is compared with what the factors make of the same distance.
    fn distance_disagrees(&self, taken: &[Option<AxisFactor>; 3]) -> Option<String> {
        let (distance, source, [along, ratio]) = self.distance_ratios(taken)?;
        ((ratio - along).abs() > AGREEMENT * along).then(|| {
            format!(
                "body {}: {} says {along:.6} for the distance to joint {}, but the distance is {ratio:.6} of the reference's; took the \
                 first",
                self.body,
                source.as_str(),
                distance.joint
            )
        })
    }

    /// Whether a mesh shows a bone of quite another size than the joints of the body do, or, where there is none for that, those of
    /// the body `above`.
    pub(super) fn shows_other_bone(
        &self,
        taken: &[Option<AxisFactor>; 3],
        above: Option<&Self>,
    ) -> Option<FactorQuestion> {
        let own = self.distance_ratios(taken);
        let (distance, source, ratios) = own.or_else(|| {
            let distance = above?.distance.as_ref()?;
            let [Some(x), Some(y), Some(z)] = *taken else { return None };
            let mean = (x.factor * y.factor * z.factor).cbrt();
            Some((distance, x.source, [mean, distance.ratio()]))
        })?;
        let [by_mesh, by_joint] = ratios;
        let apart = (by_mesh / by_joint).max(by_joint / by_mesh) > OTHER_BONE;
        let (body, joint) = (self.body.to_owned(), distance.joint.to_owned());
        (apart && source == FactorSource::Mesh).then_some(FactorQuestion::OtherBone { body, joint, ratios })
    }

    /// What was taken, and what the distance itself is, as ratios of the distance in the reference.
    fn distance_ratios(
        &self,
        taken: &[Option<AxisFactor>; 3],
    ) -> Option<(&Distance<'a>, FactorSource, [f64; 2])> {
        let distance = self.distance.as_ref()?;
        let [Some(x), Some(y), Some(z)] = *taken else { return None };
        if x.source >= FactorSource::Distance {
            return None;
        }
        let [old_x, old_y, old_z] = distance.old_m;
        let along = length([x.factor * old_x, y.factor * old_y, z.factor * old_z]) / length(distance.old_m);
        Some((distance, x.source, [along, distance.ratio()]))
    }
}

/// What is taken of each body: on each axis the first source that both sides of a pair have, else the first of its own.
pub(super) fn taken(all: &[Sources<'_>]) -> Vec<[Option<AxisFactor>; 3]> {
    let pairs = Pairs::of(all);
    let of = |one: &Sources<'_>| {
        let other = pairs.other_side(one.body);
        std::array::from_fn(|axis| {
            let first = one.first(axis).filter(|first| first.source > FactorSource::Given);
            let shared = || {
                let other = other.filter(|other| other.value(FactorSource::Given, axis).is_none())?;
                one.said.iter().find_map(|(source, values)| {
                    other.value(*source, axis)?;
                    Some(AxisFactor { factor: values[axis]?, source: *source })
                })
            };
            match first {
                Some(first) => Some(shared().unwrap_or(first)),
                None => one.first(axis),
            }
        })
    };
    all.iter().map(of).collect()
}

/// Bodies whose names differ only in the side.
pub(super) struct Pairs<'s, 'a>(HashMap<String, Vec<&'s Sources<'a>>>);

impl<'s, 'a> Pairs<'s, 'a> {
    pub(super) fn of(all: &'s [Sources<'a>]) -> Self {
        let mut pairs: HashMap<String, Vec<&Sources<'_>>> = HashMap::new();
        for one in all {
            pairs.entry(without_side(one.body)).or_default().push(one);
        }
        Self(pairs)
    }

    /// The body on the other side, where names say that there is exactly one.
    pub(super) fn other_side(&self, body: &str) -> Option<&'s Sources<'a>> {
        let side = Side::of_name(body)?;
        let mut others = self.0.get(&without_side(body))?.iter().filter(|other| other.body != body);
        let only =
            others.next().filter(|other| Side::of_name(other.body).is_some_and(|other| other != side))?;
        others.next().is_none().then_some(*only)
    }
}

/// New over old translation of the same frame; the longest offset of each axis is the most exact.
fn joint_factors(scaled: &Anatomy, reference: &Anatomy, body: &str) -> [Option<f64>; 3] {
    let (Some(new), Some(old)) = (scaled.offsets.get(body), reference.offsets.get(body)) else {
        return [None; 3];
    };
    std::array::from_fn(|axis| {
        let pairs = old.iter().filter_map(|(name, old)| Some((old[axis], new.get(name)?[axis])));
        let longest = pairs
            .filter(|(old, _)| old.abs() > SHORTEST_OFFSET_M)
            .max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        longest.map(|(old, new)| new / old)
    })
}
