//! Leaves out findings that only follow from other findings, so that `check` reports each cause once.

use std::cell::LazyCell;
use std::collections::{BTreeMap, BTreeSet};

use osim_model::{FindingCode, Force, Model, Severity, VerdictTopic};

use crate::findings::FindingWithRemedy;
use crate::sides::BothSides;

use FindingCode::*;

/// Codes of causes, and the codes of what follows from them anywhere in the model, in the order in which they are left out. If something
/// else causes it, too, that is found once the first cause is gone.
const EFFECTS: [(&[FindingCode], &[FindingCode]); 18] = [
    (&[AngleInDegrees], &[LeftRightBones, LeftRightPlaces, OddPlace, SpheresMisplaced, UnevenBottoms]),
    (&[MisplacedObject], &[ConnecteeByName]),
    (&[MisnamedParameterSet, UnknownName], &[BareModel, IgnoredContacts]),
    (&[NotFinite], &[NoGravity]),
    (&[LeftRightBones, OddParent], &[OddPlace, OddRadius, SpheresMisplaced, UnevenBottoms]),
    (&[NoSurfacesMeet, ShapePressesNothing], &[LeftRightMissing, OneSideOnly]),
    (&[DoubledSpheres], &[CrowdedSpheres]),
    (&[ContactsOfAnotherMass, GravitySourcesDisagree, MassSourcesDisagree], &[Floats, ForceBeforeContact]),
    (&[MasslessBody], &[ContactsOfAnotherMass, Floats, ForceBeforeContact, TooStiff]),
    (&[ContactsOfAnotherMass], &[SunkIn]),
    (&[GravitySourcesDisagree], &[SunkIn]),
    (&[HeavyFoot, MasslessBody], &[ContactsOfAnotherMass, MassSourcesDisagree]),
    (&[SphereInTwoForces, DoubledSpheres], &[Floats, ForceBeforeContact]),
    (&[SphereOfOtherSide], &[SphereInTwoForces, LeftRightMissing, OneSideOnly]),
    (&[LargeFriction], &[DynamicAboveStatic]),
    (&[LeftRightOff], &[SpheresMisplaced]),
    (&[LeftRightSwapped], &[SpheresMisplaced, SpheresNotCompared]),
    (&[OddPlace, OddRadius, SpheresMisplaced], &[UnevenBottoms]),
];

/// What follows from a number of a force that OpenSim reads differently from what is written.
const EFFECTS_OF_MISREAD_FORCE: [FindingCode; 3] = [DynamicAboveStatic, LargeFriction, LeftRightDiffer];

/// What follows from a number of a sphere that is not finite, or that OpenSim reads differently from what is written.
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

/// The codes of what can cause a finding of `code` about the same forces and spheres.
const fn causes_on_elements(code: FindingCode) -> &'static [FindingCode] {
    match code {
        LeftRightDiffer => &[NotFinite, OddRadius, OutOfDomain],
        LeftRightPlaces => &[OddPlace, SpheresMisplaced],
        OddPlace => &[SpheresMisplaced],
        SpheresMisplaced => &[OddPlace],
        SunkIn => &[LeftRightDiffer, LeftRightPlaces, OddPlace, OddRadius, SpheresMisplaced],
        Floats | ForceBeforeContact | LargeConstantIndentation | TooStiff | WideTransition => {
            &[LeftRightDiffer, OddRadius]
        }
        DynamicAboveStatic | LargeFriction | OddTransitionVelocity => &[LeftRightDiffer],
        DuplicateNames => &[SphereInTwoForces],
        _ => &[],
    }
}

/// The warnings and errors among `findings` that have one of these codes.
fn with_codes<'f>(findings: &'f [FindingWithRemedy], codes: &[FindingCode]) -> Vec<&'f FindingWithRemedy> {
    let severe = findings.iter().filter(|one| one.severity > Severity::Remark);
    severe.filter(|one| codes.contains(&one.code())).collect()
}

/// The findings about `model`, without warnings and errors that only follow from others, and the codes that have no finding any more, with
/// their topics.
pub fn without_effects(
    model: &Model,
    findings: Vec<FindingWithRemedy>,
) -> (Vec<FindingWithRemedy>, BTreeMap<FindingCode, Option<VerdictTopic>>) {
    let mut left_out: BTreeMap<_, _> = findings.iter().map(|one| (one.code(), one.rule.verdict)).collect();
    let kept = without_effects_on_elements(model, without_effects_anywhere(model, findings));
    left_out.retain(|code, _| kept.iter().all(|one| one.code() != *code));
    (kept, left_out)
}

/// Takes warnings and errors that follow from their causes out of `findings`. A warning hides no error: it becomes one.
fn leave_out(
    findings: &mut Vec<FindingWithRemedy>,
    is_cause: impl Fn(&FindingWithRemedy) -> bool,
    is_effect: impl Fn(&FindingWithRemedy) -> bool,
) {
    let effects = findings.extract_if(.., |one| one.severity > Severity::Remark && is_effect(one));
    let worst = effects.map(|one| one.severity).max();
    for cause in findings.iter_mut().filter(|one| one.severity > Severity::Remark && is_cause(one)) {
        cause.finding.severity = cause.severity.max(worst.unwrap_or(cause.severity));
    }
}

/// The findings without what follows from others anywhere in the model.
fn without_effects_anywhere(model: &Model, mut findings: Vec<FindingWithRemedy>) -> Vec<FindingWithRemedy> {
    let paths = |codes: &[FindingCode]| -> BTreeSet<String> {
        with_codes(&findings, codes).iter().flat_map(|one| one.paths().cloned()).collect()
    };
    let (misread, unusable) = (paths(&[OddNumber]), paths(&[NotFinite, OddNumber, OutOfDomain]));
    let large_friction = paths(&[LargeFriction]);
    let misreads_force = model.forces().iter().any(|force| misread.contains(&force.path));
    let no_number = paths(&[NotFinite, OddNumber]);
    let misreads_sphere = model.spheres().iter().any(|sphere| no_number.contains(&sphere.path));
    let has_unusable_mass = model.bodies().iter().any(|body| unusable.contains(&body.path));
    findings.retain(|one| {
        let is_of_force = misreads_force && EFFECTS_OF_MISREAD_FORCE.contains(&one.code());
        let is_of_sphere = misreads_sphere && EFFECTS_OF_MISREAD_SPHERE.contains(&one.code());
        let is_of_body = has_unusable_mass && matches!(one.code(), MassUnknown | SunkIn);
        one.severity == Severity::Remark || !(is_of_force || is_of_sphere || is_of_body)
    });
    // A sphere of the other side is in two forces: in its own, and in one that is not.
    let is_in_three = |path: &String| {
        let named = model.forces().iter().flat_map(Force::spheres).filter_map(|&id| model.sphere(id));
        named.filter(|sphere| sphere.path == *path).count() > 2
    };
    let turns_floor = |path: &String| {
        let planes = model.half_spaces().into_iter().chain(model.half_spaces_inside());
        planes.flat_map(|plane| plane.orientations).any(|one| one.path == *path)
    };
    let is_in_joint = |path: &String| {
        path.starts_with("/jointset/") || (path.starts_with("/bodyset/") && path.matches('/').count() > 2)
    };
    for (causes, effects) in EFFECTS {
        let found = with_codes(&findings, causes);
        let is_elsewhere = match causes {
            // The angles of a floor say nothing about bones and spheres.
            [AngleInDegrees] => found.iter().flat_map(|one| one.paths()).all(turns_floor),
            // The names in a joint say nothing about contacts.
            [MisnamedParameterSet, UnknownName] => found.iter().flat_map(|one| one.paths()).all(is_in_joint),
            [NotFinite] => model.gravity().is_some(),
            // Under less gravity than they are made for, spheres sink in less.
            [GravitySourcesDisagree] => {
                model.note.as_ref().and_then(|note| note.gravity_m_s2) > model.gravity()
            }
            _ => false,
        };
        if found.is_empty() || is_elsewhere {
            continue;
        }
        let is_cause = |one: &FindingWithRemedy| causes.contains(&one.code());
        leave_out(&mut findings, is_cause, |one| {
            let is_of_its_own = match one.code() {
                SphereInTwoForces => one.paths().any(is_in_three),
                DynamicAboveStatic => one.paths().any(|path| !large_friction.contains(path)),
                // Places in the model before scaling do not depend on what is switched off.
                SpheresMisplaced => causes == [LeftRightOff] && !one.details.is_empty(),
                _ => false,
            };
            effects.contains(&one.code()) && !is_of_its_own
        });
    }
    findings
}

/// The findings without what follows from others for the same forces and spheres.
fn without_effects_on_elements(
    model: &Model,
    mut findings: Vec<FindingWithRemedy>,
) -> Vec<FindingWithRemedy> {
    let sides = LazyCell::new(|| BothSides::of(model));
    // Places that were compared with those of another model have a sentence for each sphere.
    let is_compared = |place: &FindingWithRemedy| !place.details.is_empty();
    let is_effect = |findings: &[FindingWithRemedy], one: &FindingWithRemedy| {
        let mut causes = with_codes(findings, causes_on_elements(one.code()));
        causes.retain(|cause| match one.code() {
            OddPlace => is_compared(cause),
            SpheresMisplaced => !is_compared(one),
            _ => true,
        });
        if one.severity == Severity::Remark || causes.is_empty() {
            return false;
        }
        if matches!(one.code(), DuplicateNames | LeftRightDiffer) {
            let wrong = forces_of(model, &causes);
            let is_wrong = |force: Option<&Force>| force.is_some_and(|force| wrong.contains(&force.path));
            return one.paths().all(|path| {
                let left = sides.force(path);
                is_wrong(left) || is_wrong(left.and_then(|left| sides.right_counterpart(left)))
            });
        }
        let differ = causes.iter().filter(|cause| cause.code() == LeftRightDiffer);
        let pairs = differ.flat_map(|one| one.paths()).filter_map(|left| sides.odd_and_other(left, None));
        let odd: Vec<&Force> = pairs.map(|(_, [odd, _])| odd).collect();
        let of_odd = odd.iter().flat_map(|force| force.spheres()).filter_map(|&id| model.sphere(id));
        let names = causes.iter().flat_map(|cause| &cause.spheres).chain(of_odd.map(|sphere| &sphere.name));
        let elements: BTreeSet<&String> = names.chain(odd.iter().map(|force| &force.path)).collect();
        let is_wrong = |element: &String| {
            // Of a pair, one sphere is at the wrong place.
            let is_of_pair = matches!(one.code(), LeftRightPlaces | SunkIn);
            let other = is_of_pair.then(|| sides.counterpart(element)).flatten().map(|other| &other.name);
            let is_other_wrong = |other: &String| elements.contains(other) && !one.spheres.contains(other);
            elements.contains(element) || other.is_some_and(is_other_wrong)
        };
        let own: Vec<&String> =
            if one.spheres.is_empty() { one.paths().collect() } else { one.spheres.iter().collect() };
        !own.is_empty() && own.into_iter().all(is_wrong)
    };
    // Differences of the sides come first, because nothing follows from one that is left out itself.
    for are_sides in [true, false] {
        let are_judged = findings.iter().filter(|one| (one.code() == LeftRightDiffer) == are_sides);
        let effects: Vec<_> = are_judged.filter(|one| is_effect(&findings, one)).cloned().collect();
        for effect in effects {
            let is_it =
                |one: &FindingWithRemedy| one.code() == effect.code() && one.message == effect.message;
            let causes = causes_on_elements(effect.code());
            let is_about =
                |one: &FindingWithRemedy| one.spheres.iter().any(|name| effect.spheres.contains(name));
            let is_known = with_codes(&findings, causes).into_iter().any(is_about);
            let is_cause =
                |one: &FindingWithRemedy| causes.contains(&one.code()) && (!is_known || is_about(one));
            leave_out(&mut findings, is_cause, is_it);
        }
    }
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
