//! Leaves out findings that only follow from other findings, so that `check` reports each cause once.

use std::collections::BTreeSet;

use osim_model::{FindingCode, Force, Model, Severity, VerdictTopic};

use crate::findings::FindingWithRemedy;
use crate::sides::BothSides;

use FindingCode::*;

/// Codes of causes, and the codes of what follows from them anywhere in the model, in the order in which they are left out. If something
/// else causes it, too, that is found once the first cause is gone.
const EFFECTS: [(&[FindingCode], &[FindingCode]); 6] = [
    (&[MasslessBody], &[ContactsOfAnotherMass]),
    (&[SphereInTwoForces, DoubledSpheres], &[Floats, ForceBeforeContact]),
    (&[SphereOfOtherSide], &[SphereInTwoForces, LeftRightMissing]),
    (&[LeftRightSwapped], &[SpheresMisplaced]),
    (&[OddRadius], &[UnevenBottoms]),
    (&[OddPlace, SpheresMisplaced], &[UnevenBottoms]),
];

/// What follows from a number of a force that OpenSim reads differently from what is written.
const EFFECTS_OF_MISREAD_FORCE: [FindingCode; 3] = [DynamicAboveStatic, LargeFriction, LeftRightDiffer];

/// What follows from a number of a sphere that OpenSim reads differently from what is written.
const EFFECTS_OF_MISREAD_SPHERE: [FindingCode; 9] = [
    CrowdedSpheres,
    DoubledSpheres,
    LeftRightDiffer,
    LeftRightMissing,
    LeftRightPlaces,
    OddPlace,
    OddRadius,
    SpheresMisplaced,
    UnevenBottoms,
];

/// What follows from an odd radius for its sphere.
const EFFECTS_OF_ODD_RADIUS: [FindingCode; 4] =
    [ForceBeforeContact, LargeConstantIndentation, TooStiff, WideTransition];

/// Causes by which the contacts of two sides differ.
const CAUSES_OF_UNLIKE_SIDES: [FindingCode; 3] = [NotFinite, OddRadius, OutOfDomain];

/// The warnings and errors among `findings` that have one of these codes.
fn with_codes<'f>(findings: &'f [FindingWithRemedy], codes: &[FindingCode]) -> Vec<&'f FindingWithRemedy> {
    let severe = findings.iter().filter(|one| one.severity > Severity::Remark);
    severe.filter(|one| codes.contains(&one.code())).collect()
}

/// The codes of warnings and errors that may be left out beside `findings`, because they follow from these.
pub fn codes_of_effects(findings: &[FindingWithRemedy]) -> BTreeSet<FindingCode> {
    let of_elements: [(&[FindingCode], &[FindingCode]); 5] = [
        (&[OddPlace, SpheresMisplaced], &[LeftRightPlaces, OddPlace, SpheresMisplaced]),
        (&[OddNumber], &EFFECTS_OF_MISREAD_FORCE),
        (&[OddNumber], &EFFECTS_OF_MISREAD_SPHERE),
        (&[OddRadius], &EFFECTS_OF_ODD_RADIUS),
        (&CAUSES_OF_UNLIKE_SIDES, &[LeftRightDiffer]),
    ];
    let all = EFFECTS.iter().chain(&of_elements);
    let caused = all.filter(|(causes, _)| !with_codes(findings, causes).is_empty());
    caused.flat_map(|(_, effects)| effects.iter().copied()).collect()
}

/// The findings about `model`, without warnings and errors that only follow from others, and the topics of these. A warning hides no error.
pub fn without_effects(
    model: &Model,
    findings: Vec<FindingWithRemedy>,
) -> (Vec<FindingWithRemedy>, Vec<VerdictTopic>) {
    let topics: Vec<_> = findings.iter().map(|one| (one.code(), one.rule.verdict)).collect();
    let kept = without_effects_on_elements(model, without_effects_anywhere(model, findings));
    let is_left_out = |code| kept.iter().all(|one| one.code() != code);
    let left_out = topics.into_iter().filter(|(code, _)| is_left_out(*code)).filter_map(|(_, topic)| topic);
    let left_out = left_out.collect();
    (kept, left_out)
}

/// The findings without what follows from others anywhere in the model.
fn without_effects_anywhere(model: &Model, mut findings: Vec<FindingWithRemedy>) -> Vec<FindingWithRemedy> {
    let misread: BTreeSet<String> =
        with_codes(&findings, &[OddNumber]).iter().flat_map(|one| one.paths().cloned()).collect();
    let misreads_force = model.forces().iter().any(|force| misread.contains(&force.path));
    let misreads_sphere = model.spheres().iter().any(|sphere| misread.contains(&sphere.path));
    findings.retain(|one| {
        let is_of_force = misreads_force && EFFECTS_OF_MISREAD_FORCE.contains(&one.code());
        let is_of_sphere = misreads_sphere && EFFECTS_OF_MISREAD_SPHERE.contains(&one.code());
        one.severity == Severity::Remark || !(is_of_force || is_of_sphere)
    });
    // A sphere of the other side is in two forces: in its own, and in one that is not.
    let is_in_three = |path: &String| {
        let named = model.forces().iter().flat_map(Force::spheres).filter_map(|&id| model.sphere(id));
        named.filter(|sphere| sphere.path == *path).count() > 2
    };
    for (causes, effects) in EFFECTS {
        let Some(worst) = with_codes(&findings, causes).iter().map(|one| one.severity).max() else {
            continue;
        };
        findings.retain(|one| {
            one.severity == Severity::Remark
                || one.severity > worst
                || !effects.contains(&one.code())
                || (one.code() == SphereInTwoForces && one.paths().any(is_in_three))
        });
    }
    findings
}

/// The findings without what follows from others for the same forces and spheres.
fn without_effects_on_elements(
    model: &Model,
    mut findings: Vec<FindingWithRemedy>,
) -> Vec<FindingWithRemedy> {
    let spheres_with = |codes: &[FindingCode], are_compared: bool| -> BTreeSet<String> {
        // Places that were compared with those of another model have a sentence for each sphere.
        let all = with_codes(&findings, codes).into_iter();
        let all = all.filter(|one| !are_compared || !one.details.is_empty());
        all.flat_map(|one| one.spheres.clone()).collect()
    };
    let (odd_radii, odd_places) = (spheres_with(&[OddRadius], false), spheres_with(&[OddPlace], false));
    let compared = spheres_with(&[SpheresMisplaced], true);
    let misplaced = spheres_with(&[OddPlace, SpheresMisplaced], false);
    let wrong_forces = forces_of(model, &with_codes(&findings, &CAUSES_OF_UNLIKE_SIDES));
    let sides = (!wrong_forces.is_empty() || !misplaced.is_empty()).then(|| BothSides::of(model));
    let has_wrong_force = |path: &String| {
        let Some((sides, left)) = sides.as_ref().and_then(|sides| Some((sides, sides.force(path)?))) else {
            return false;
        };
        let right = sides.right_counterpart(left);
        wrong_forces.contains(&left.path) || right.is_some_and(|right| wrong_forces.contains(&right.path))
    };
    let is_pair_misplaced = |left: &String| {
        let mut pairs = sides.iter().flat_map(|sides| &sides.pairs);
        let pair = pairs.find(|pair| pair.left.sphere.name == *left);
        misplaced.contains(left) || pair.is_some_and(|pair| misplaced.contains(&pair.right.sphere.name))
    };
    findings.retain(|one| {
        let code = one.code();
        let are_in = |spheres: &BTreeSet<String>| {
            !one.spheres.is_empty() && one.spheres.iter().all(|sphere| spheres.contains(sphere))
        };
        let is_of_elements = match code {
            LeftRightDiffer => one.paths().all(has_wrong_force),
            LeftRightPlaces => !one.spheres.is_empty() && one.spheres.iter().all(is_pair_misplaced),
            OddPlace => are_in(&compared),
            SpheresMisplaced => one.details.is_empty() && are_in(&odd_places),
            _ => EFFECTS_OF_ODD_RADIUS.contains(&code) && are_in(&odd_radii),
        };
        one.severity == Severity::Remark || !is_of_elements
    });
    findings
}

/// The paths of the forces that `findings` are about, and of those that press the spheres that they are about.
fn forces_of(model: &Model, findings: &[&FindingWithRemedy]) -> BTreeSet<String> {
    let paths: BTreeSet<&String> = findings.iter().flat_map(|one| one.paths()).collect();
    let presses = |force: &Force| {
        let mut spheres = force.spheres().iter().filter_map(|&id| model.sphere(id));
        spheres.any(|sphere| paths.contains(&sphere.path))
    };
    let forces = model.forces().iter().filter(|force| paths.contains(&force.path) || presses(force));
    forces.map(|force| force.path.clone()).collect()
}
