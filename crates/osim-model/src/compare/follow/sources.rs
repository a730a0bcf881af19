//! Collects the factors that each source gives a body, and chooses among them.

use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};
use glam::DVec3;

use super::body_factors::{
    AXIS_NAMES, AxisFactor, BodyFactors, BodyIndex, BonePair, ComparedJoints, FactorSource, SharedOffset,
    bone_pairs,
};
use super::scale_file::ScaleFile;
use super::scaled_copy::SHORTEST_OFFSET_M;
use crate::messages::{Phrase, four_significant};
use crate::model::{Anatomy, Fault, MissingFact, Side, UnknownFactors, without_side};

/// Two sources of a scaled copy disagree if their factors differ by more than this (relative).
const TOLERANCE_IN_A_COPY: f64 = 0.01;
/// Two sources for different models disagree if their factors differ by more than this (relative).
const TOLERANCE_OF_DIFFERENT_MODELS: f64 = 0.05;

/// A mesh belongs to another animal if its factor is more than this many times the factor from the joints of its body, or less than one
/// part in so many. In published models, bones of one name do not differ so much in their proportions.
const LARGEST_MESH_RATIO: f64 = 2.0;

/// The factors that each source gives one body.
pub(super) struct BodyFactorSources<'a> {
    pub(super) body: &'a str,
    /// Sources with their factors, the preferred source first.
    pub(super) by_source: Vec<(FactorSource, [Option<f64>; 3])>,
    /// Pairs of meshes of one bone in both models.
    pub(super) meshes: Vec<BonePair>,
    /// The joint to which a distance is measured in two different models.
    distance: Option<SharedOffset<'a>>,
    in_a_copy: bool,
}

impl<'a> BodyFactorSources<'a> {
    /// What each source gives for `body`: the caller, the Scale Tool's file, meshes and joint offsets. `distances` is given if the
    /// scaled model is not a copy of the reference.
    pub(super) fn of(
        scaled: &'a Anatomy,
        reference: &Anatomy,
        body: &'a str,
        file: Option<&ScaleFile>,
        given: Option<&[f64; 3]>,
        distances: Option<&ComparedJoints<'a>>,
    ) -> Self {
        let in_a_copy = distances.is_none();
        let meshes = bone_pairs(scaled, reference, body);
        let distance = distances.and_then(|distances| distances.farthest(body));
        let mut by_source = Vec::new();
        if let Some(given) = given {
            by_source.push((FactorSource::Given, given.map(Some)));
        }
        if let Some(values) = file.and_then(|file| file.factors(body)) {
            by_source.push((FactorSource::ScaleFile, values.map(Some)));
        }
        by_source.push((FactorSource::Mesh, meshes.first().map_or([None; 3], |pair| pair.factors)));
        if in_a_copy {
            by_source.push((FactorSource::Joint, joint_factors(scaled, reference, body)));
        } else {
            let ratio = distance.as_ref().map(SharedOffset::ratio);
            by_source.push((FactorSource::Distance, [ratio; 3]));
        }
        by_source.retain(|(_, values)| values.iter().any(Option::is_some));
        Self { body, by_source, meshes, distance, in_a_copy }
    }

    fn factor_from(&self, source: FactorSource, axis: usize) -> Option<f64> {
        self.by_source.iter().find(|(known, _)| *known == source).and_then(|(_, values)| values[axis])
    }

    fn preferred_factor(&self, axis: usize) -> Option<AxisFactor> {
        let mut sources = self.by_source.iter();
        sources.find_map(|(source, values)| Some(AxisFactor { factor: values[axis]?, source: *source }))
    }

    /// Descriptions of the sources that disagree with the factors `taken`.
    pub(super) fn disagreements(&self, taken: &[Option<AxisFactor>; 3]) -> Vec<String> {
        let limit = if self.in_a_copy { TOLERANCE_IN_A_COPY } else { TOLERANCE_OF_DIFFERENT_MODELS };
        let mut messages = Vec::new();
        for (axis, name) in AXIS_NAMES.iter().enumerate() {
            let Some(AxisFactor { factor, source }) = taken[axis] else { continue };
            let others = self
                .by_source
                .iter()
                .filter(|(other, _)| *other > source && *other != FactorSource::Distance);
            for (other, value) in others.filter_map(|(other, values)| Some((other, values[axis]?))) {
                if (value - factor).abs() > limit * factor {
                    messages.push(format!(
                        "body {}, {name}: {} gives {}, {} gives {}; the first was used",
                        self.body,
                        source.as_str(),
                        four_significant(factor),
                        other.as_str(),
                        four_significant(value)
                    ));
                }
            }
        }
        messages.extend(self.distance_disagrees(taken));
        messages
    }

    /// Compares the ratio of a joint's distances with the ratio that the factors `taken` give for the same distance. Returns the
    /// disagreement in words.
    fn distance_disagrees(&self, taken: &[Option<AxisFactor>; 3]) -> Option<String> {
        let (distance, source, [along, ratio]) = self.distance_ratios(taken)?;
        ((ratio - along).abs() > TOLERANCE_OF_DIFFERENT_MODELS * along).then(|| {
            format!(
                "body {}: {} gives {} for the distance to joint {}, but the distance is {} of the reference's; the first was used",
                self.body,
                source.as_str(),
                four_significant(along),
                distance.joint,
                four_significant(ratio)
            )
        })
    }

    /// The doubt if the size of the mesh differs far too much from the distances of the joints. Without a distance on this body, the
    /// distance on the body `above` is compared.
    fn mesh_of_other_animal(
        &self,
        taken: &[Option<AxisFactor>; 3],
        above: Option<&Self>,
    ) -> Option<UnknownFactors> {
        let of_this_body = self.distance_ratios(taken);
        let (distance, source, ratios) = of_this_body.or_else(|| {
            let distance = above?.distance.as_ref()?;
            let [Some(x), Some(y), Some(z)] = *taken else { return None };
            let mean = (x.factor * y.factor * z.factor).cbrt();
            Some((distance, x.source, [mean, distance.ratio()]))
        })?;
        let [by_mesh, by_joint] = ratios;
        let apart = (by_mesh / by_joint).max(by_joint / by_mesh) > LARGEST_MESH_RATIO;
        let (body, joint) = (self.body.to_owned(), distance.joint.to_owned());
        (apart && source == FactorSource::Mesh).then_some(UnknownFactors::OtherBone { body, joint, ratios })
    }

    /// Two ratios of a joint's distance in the new model to the reference: by the factors `taken`, and as measured.
    fn distance_ratios(
        &self,
        taken: &[Option<AxisFactor>; 3],
    ) -> Option<(&SharedOffset<'a>, FactorSource, [f64; 2])> {
        let distance = self.distance.as_ref()?;
        let [Some(x), Some(y), Some(z)] = *taken else { return None };
        if x.source >= FactorSource::Distance {
            return None;
        }
        let taken = DVec3::new(x.factor, y.factor, z.factor) * distance.reference_m;
        let along = taken.length() / distance.reference_m.length();
        Some((distance, x.source, [along, distance.ratio()]))
    }
}

/// Chooses the factors of each body. Each axis takes the first source that both bodies of a left-right pair have, else the first source of
/// the body.
pub(super) fn choose_factors(all: &[BodyFactorSources<'_>]) -> Vec<[Option<AxisFactor>; 3]> {
    let pairs = SidePairs::of(all);
    let choose = |one: &BodyFactorSources<'_>| {
        let other = pairs.other_side(one.body);
        std::array::from_fn(|axis| {
            let first = one.preferred_factor(axis).filter(|first| first.source > FactorSource::Given);
            let shared = || {
                let other = other.filter(|other| other.factor_from(FactorSource::Given, axis).is_none())?;
                one.by_source.iter().find_map(|(source, values)| {
                    other.factor_from(*source, axis)?;
                    Some(AxisFactor { factor: values[axis]?, source: *source })
                })
            };
            match first {
                Some(first) => Some(shared().unwrap_or(first)),
                None => one.preferred_factor(axis),
            }
        })
    };
    all.iter().map(choose).collect()
}

/// Left and right bodies, listed under their common name without the side.
pub(super) struct SidePairs<'s, 'a>(HashMap<String, Vec<&'s BodyFactorSources<'a>>>);

impl<'s, 'a> SidePairs<'s, 'a> {
    /// Pairs the bodies of both sides by their names.
    pub(super) fn of(all: &'s [BodyFactorSources<'a>]) -> Self {
        let mut pairs: HashMap<String, Vec<&BodyFactorSources<'_>>> = HashMap::new();
        for one in all {
            pairs.entry(without_side(one.body)).or_default().push(one);
        }
        Self(pairs)
    }

    /// The body on the other side, if exactly one has the matching name.
    fn other_side(&self, body: &str) -> Option<&'s BodyFactorSources<'a>> {
        let side = Side::of_name(body)?;
        let mut others = self.0.get(&without_side(body))?.iter().filter(|other| other.body != body);
        let only =
            others.next().filter(|other| Side::of_name(other.body).is_some_and(|other| other != side))?;
        others.next().is_none().then_some(*only)
    }
}

/// The new translation of a frame over the old one. The longest offset along each axis counts, because it is the most exact.
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

// Factors between models of which neither is a scaled copy of the other.

/// If two meshes of one body differ by more than this (relative), the caller has to say which is right.
const SAME_MESH_FACTOR: f64 = 0.01;

/// Gives a body at the end of a limb, without any source, the factors of its parent body. The body of the other side does the same.
pub(super) fn inherit_from_body_above(
    factors: &mut [BodyFactors],
    by_name: &BodyIndex,
    scaled: &Anatomy,
    carriers: &[&str],
) -> Vec<Phrase> {
    let is_last = |body: &str| scaled.joints_below(body).next().is_none();
    let unknown =
        |factors: &[BodyFactors], body: &str| by_name.axes_of_body(factors, body).iter().all(Option::is_none);
    let mut pairs: HashMap<String, Vec<&String>> = HashMap::new();
    for body in &scaled.bodies {
        pairs.entry(without_side(body)).or_default().push(body);
    }
    let carrying: HashSet<&str> = carriers.iter().copied().collect();
    let last: Vec<&String> = carriers
        .iter()
        .filter(|body| is_last(body) && unknown(factors, body))
        .flat_map(|body| pairs.get(&without_side(body)).into_iter().flatten().copied())
        .filter(|body| is_last(body) && carrying.contains(body.as_str()))
        .filter(|body| !is_given(&by_name.axes_of_body(factors, body)))
        .collect();
    let mut inherited: HashSet<&str> = HashSet::new();
    let mut nearest = NearestKnown::new();
    let mut remarks = Vec::new();
    for body in last {
        if inherited.contains(body.as_str()) {
            continue;
        }
        let Some((above, axes)) = nearest_known_above(factors, by_name, scaled, body, &mut nearest) else {
            continue;
        };
        let [x, y, z] = axes.map(|axis| axis.factor);
        remarks.push(
            format!("{body} takes the factors of {above}, its parent body: {x:.4}, {y:.4}, {z:.4}").into(),
        );
        inherited.insert(body);
        let Some(found) = by_name.index_of(body).and_then(|at| factors.get_mut(at)) else { continue };
        found.axes = axes.map(|axis| Some(AxisFactor { factor: axis.factor, source: FactorSource::Above }));
        found.sources.push((FactorSource::Above, axes.map(|axis| Some(axis.factor))));
    }
    remarks
}

/// For each body that was visited: the nearest body above it with known factors. A cache, because limbs share the bodies above.
type NearestKnown<'a> = HashMap<&'a str, Option<(&'a str, [AxisFactor; 3])>>;

/// The nearest body above `body` with known factors, and these factors.
fn nearest_known_above<'a>(
    factors: &[BodyFactors],
    by_name: &BodyIndex,
    scaled: &'a Anatomy,
    body: &'a str,
    nearest: &mut NearestKnown<'a>,
) -> Option<(&'a str, [AxisFactor; 3])> {
    let mut passed = Vec::new();
    let mut at = body;
    let nearest_above = loop {
        if let Some(known) = nearest.get(at) {
            break *known;
        }
        // A loop of joints ends here, too.
        nearest.insert(at, None);
        passed.push(at);
        let Some(joint) = scaled.joint_above(at) else { break None };
        at = &joint.parent;
        if let [Some(x), Some(y), Some(z)] = by_name.axes_of_body(factors, at) {
            break Some((at, [x, y, z]));
        }
    };
    nearest.extend(passed.into_iter().map(|body| (body, nearest_above)));
    nearest_above
}

fn is_given(axes: &[Option<AxisFactor>; 3]) -> bool {
    axes.iter().flatten().any(|axis| axis.source <= FactorSource::ScaleFile)
}

/// Takes back the factors of bodies about which the sources do not agree: of differing meshes of one body, of differing sides, of a body
/// without any source. The caller has to give these factors.
pub(super) fn withdraw_doubtful_factors(
    factors: &mut [BodyFactors],
    by_name: &BodyIndex,
    all_sources: &[BodyFactorSources<'_>],
    scaled: &Anatomy,
) {
    let pairs = SidePairs::of(all_sources);
    let of_body: HashMap<&str, &BodyFactorSources<'_>> =
        all_sources.iter().map(|one| (one.body, one)).collect();
    let above = |body: &str| of_body.get(scaled.joint_above(body)?.parent.as_str()).copied();
    let doubts: Vec<Option<UnknownFactors>> = all_sources
        .iter()
        .map(|sources| {
            let axes = by_name.axes_of_body(factors, sources.body);
            if is_given(&axes) {
                return None;
            }
            let uses_mesh = axes.iter().flatten().any(|axis| axis.source == FactorSource::Mesh);
            let of_meshes = || differing_meshes(sources).filter(|_| uses_mesh);
            let of_sides = || {
                let other = pairs.other_side(sources.body)?;
                differing_sides(sources.body, &axes, other.body, &by_name.axes_of_body(factors, other.body))
            };
            let nothing = || UnknownFactors::NoSource { body: sources.body.to_owned() };
            of_meshes()
                .or_else(|| sources.mesh_of_other_animal(&axes, above(sources.body)))
                .or_else(of_sides)
                .or_else(|| axes.iter().all(Option::is_none).then(nothing))
        })
        .collect();
    for (body, doubt) in factors.iter_mut().zip(doubts) {
        if let Some(doubt) = doubt {
            body.why_unknown = Some(Fault::new(MissingFact::Factors(doubt)));
            body.axes = [None; 3];
        }
    }
}

fn differing_meshes(sources: &BodyFactorSources<'_>) -> Option<UnknownFactors> {
    let (first, others) = sources.meshes.split_first()?;
    let differs = |other: &&BonePair| {
        let apart = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() > SAME_MESH_FACTOR * a.abs(),
            _ => false,
        };
        first.factors.iter().zip(&other.factors).any(apart)
    };
    let other = others.iter().find(differs)?;
    let mesh_and_factors =
        |pair: &BonePair| (pair.mesh.clone(), pair.factors.map(|factor| factor.unwrap_or(f64::NAN)));
    Some(UnknownFactors::Meshes {
        body: sources.body.to_owned(),
        meshes: [mesh_and_factors(first), mesh_and_factors(other)],
    })
}

/// The doubt if left and right differ in size, compared on the axes with a factor on both sides.
fn differing_sides(
    body: &str,
    axes: &[Option<AxisFactor>; 3],
    other: &str,
    others: &[Option<AxisFactor>; 3],
) -> Option<UnknownFactors> {
    if is_given(others) {
        return None;
    }
    let apart = |(one, two): (&Option<AxisFactor>, &Option<AxisFactor>)| match (one, two) {
        (Some(one), Some(two)) => {
            (one.factor - two.factor).abs() > TOLERANCE_OF_DIFFERENT_MODELS * one.factor.min(two.factor).abs()
        }
        _ => false,
    };
    let factors = |axes: &[Option<AxisFactor>; 3]| axes.map(|axis| axis.map_or(f64::NAN, |axis| axis.factor));
    axes.iter().zip(others).any(apart).then(|| UnknownFactors::Sides {
        bodies: [body.to_owned(), other.to_owned()],
        factors: [factors(axes), factors(others)],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factors_of_axes(factors: [f64; 3]) -> [Option<AxisFactor>; 3] {
        let known = |factor: f64| AxisFactor { factor, source: FactorSource::Mesh };
        factors.map(|factor| (!factor.is_nan()).then(|| known(factor)))
    }

    #[test]
    fn an_axis_without_a_factor_does_not_end_the_comparison() {
        let right = factors_of_axes([1.02, f64::NAN, 0.95]);
        let differ = |left| differing_sides("calcn_r", &right, "calcn_l", &factors_of_axes(left));
        // 1.09 over 1.02 is 6.9 % more.
        let Some(UnknownFactors::Sides { factors: [[x, y, z], _], .. }) = differ([1.09, 0.9, 0.95]) else {
            panic!("not asked")
        };
        assert!((x, z) == (1.02, 0.95) && y.is_nan());
        assert_eq!(differ([1.02, 0.5, 0.95]), None);
        assert_eq!(differ([f64::NAN, 0.5, 0.95]), None);
    }
}
