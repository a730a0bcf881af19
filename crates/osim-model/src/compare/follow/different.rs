//! Factors between models if neither is a scaled copy of the other.

use crate::messages::Phrase;
use crate::model::{Anatomy, FactorQuestion, Fault, Needed, without_side};
use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};

use super::body_factors::{AxisFactor, BodyFactors, ByName, FactorSource};
use super::bones::BonePair;
use super::sources::{AGREEMENT, Pairs, Sources};

/// Meshes of one body that differ by more than this (relative) need an answer.
const SAME_BODY: f64 = 0.01;

/// Bodies at the end of a limb, for which there is no source, take the factors of the body they hang on. If one side of a pair
/// does, the other does.
pub(super) fn hang_on(
    factors: &mut [BodyFactors],
    by_name: &ByName,
    scaled: &Anatomy,
    carriers: &[&str],
) -> Vec<Phrase> {
    let is_last = |body: &str| scaled.joints_below(body).next().is_none();
    let unknown =
        |factors: &[BodyFactors], body: &str| by_name.axes(factors, body).iter().all(Option::is_none);
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
        .filter(|body| !is_given(&by_name.axes(factors, body)))
        .collect();
    let mut told: HashSet<&str> = HashSet::new();
    let mut nearest = Nearest::new();
    let mut remarks = Vec::new();
    for body in last {
        if told.contains(body.as_str()) {
            continue;
        }
        let Some((above, axes)) = above(factors, by_name, scaled, body, &mut nearest) else { continue };
        let [x, y, z] = axes.map(|axis| axis.factor);
        remarks.push(
            format!("{body} takes the factors of {above}, on which it hangs: {x:.4}, {y:.4}, {z:.4}").into(),
        );
        told.insert(body);
        let Some(found) = by_name.place(body).and_then(|at| factors.get_mut(at)) else { continue };
        found.axes = axes.map(|axis| Some(AxisFactor { factor: axis.factor, source: FactorSource::Above }));
        found.sources.push((FactorSource::Above, axes.map(|axis| Some(axis.factor))));
    }
    remarks
}

/// What was found above bodies on the way: limbs share them.
type Nearest<'a> = HashMap<&'a str, Option<(&'a str, [AxisFactor; 3])>>;

/// The nearest body above `body` whose factors are known.
fn above<'a>(
    factors: &[BodyFactors],
    by_name: &ByName,
    scaled: &'a Anatomy,
    body: &'a str,
    nearest: &mut Nearest<'a>,
) -> Option<(&'a str, [AxisFactor; 3])> {
    let mut way = Vec::new();
    let mut at = body;
    let found = loop {
        if let Some(known) = nearest.get(at) {
            break *known;
        }
        // A loop of joints ends here, too.
        nearest.insert(at, None);
        way.push(at);
        let Some(joint) = scaled.joint_above(at) else { break None };
        at = &joint.parent;
        if let [Some(x), Some(y), Some(z)] = by_name.axes(factors, at) {
            break Some((at, [x, y, z]));
        }
    };
    nearest.extend(way.into_iter().map(|body| (body, found)));
    found
}

fn is_given(axes: &[Option<AxisFactor>; 3]) -> bool {
    axes.iter().flatten().any(|axis| axis.source <= FactorSource::ScaleFile)
}

/// What only the user can decide: meshes of one body that differ, sides that differ, a body for which there is no source.
pub(super) fn ask(factors: &mut [BodyFactors], by_name: &ByName, said: &[Sources<'_>], scaled: &Anatomy) {
    let pairs = Pairs::of(said);
    let of_body: HashMap<&str, &Sources<'_>> = said.iter().map(|one| (one.body, one)).collect();
    let above = |body: &str| of_body.get(scaled.joint_above(body)?.parent.as_str()).copied();
    let questions: Vec<Option<FactorQuestion>> = said
        .iter()
        .map(|sources| {
            let axes = by_name.axes(factors, sources.body);
            if is_given(&axes) {
                return None;
            }
            let of_meshes = || meshes_differ(sources).filter(|_| takes(&axes, FactorSource::Mesh));
            let of_sides = || {
                let other = pairs.other_side(sources.body)?;
                sides_differ(sources.body, &axes, other.body, &by_name.axes(factors, other.body))
            };
            let nothing = || FactorQuestion::Nothing { body: sources.body.to_owned() };
            of_meshes()
                .or_else(|| sources.shows_other_bone(&axes, above(sources.body)))
                .or_else(of_sides)
                .or_else(|| axes.iter().all(Option::is_none).then(nothing))
        })
        .collect();
    for (body, question) in factors.iter_mut().zip(questions) {
        if let Some(question) = question {
            body.question = Some(Fault::new(Needed::Factors(question)));
            body.axes = [None; 3];
        }
    }
}

fn takes(axes: &[Option<AxisFactor>; 3], source: FactorSource) -> bool {
    axes.iter().flatten().any(|axis| axis.source == source)
}

fn meshes_differ(sources: &Sources<'_>) -> Option<FactorQuestion> {
    let (first, others) = sources.meshes.split_first()?;
    let differs = |other: &&BonePair| {
        let apart = |(a, b): (&Option<f64>, &Option<f64>)| match (a, b) {
            (Some(a), Some(b)) => (a - b).abs() > SAME_BODY * a.abs(),
            _ => false,
        };
        first.factors.iter().zip(&other.factors).any(apart)
    };
    let other = others.iter().find(differs)?;
    let of = |pair: &BonePair| (pair.mesh.clone(), pair.factors.map(|factor| factor.unwrap_or(f64::NAN)));
    Some(FactorQuestion::Meshes { body: sources.body.to_owned(), meshes: [of(first), of(other)] })
}

/// Two sides that are not of one size, by the axes that are known on both.
fn sides_differ(
    body: &str,
    axes: &[Option<AxisFactor>; 3],
    other: &str,
    others: &[Option<AxisFactor>; 3],
) -> Option<FactorQuestion> {
    if is_given(others) {
        return None;
    }
    let apart = |(one, two): (&Option<AxisFactor>, &Option<AxisFactor>)| match (one, two) {
        (Some(one), Some(two)) => {
            (one.factor - two.factor).abs() > AGREEMENT * one.factor.min(two.factor).abs()
        }
        _ => false,
    };
    let factors = |axes: &[Option<AxisFactor>; 3]| axes.map(|axis| axis.map_or(f64::NAN, |axis| axis.factor));
    axes.iter().zip(others).any(apart).then(|| FactorQuestion::Sides {
        bodies: [body.to_owned(), other.to_owned()],
        factors: [factors(axes), factors(others)],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axes(factors: [f64; 3]) -> [Option<AxisFactor>; 3] {
        let known = |factor: f64| AxisFactor { factor, source: FactorSource::Mesh };
        factors.map(|factor| (!factor.is_nan()).then(|| known(factor)))
    }

    #[test]
    fn an_axis_without_a_factor_does_not_end_the_comparison() {
        let right = axes([1.02, f64::NAN, 0.95]);
        let differ = |left| sides_differ("calcn_r", &right, "calcn_l", &axes(left));
        // 1.09 over 1.02 is 6.9 % more.
        let Some(FactorQuestion::Sides { factors: [[x, y, z], _], .. }) = differ([1.09, 0.9, 0.95]) else {
            panic!("not asked")
        };
        assert!((x, z) == (1.02, 0.95) && y.is_nan());
        assert_eq!(differ([1.02, 0.5, 0.95]), None);
        assert_eq!(differ([f64::NAN, 0.5, 0.95]), None);
    }
}
