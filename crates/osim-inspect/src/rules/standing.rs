//! How the body stands at its default pose: over the floor, and with its soles level.

use foldhash::HashMap;
use osim_model::feet::MOST_LEAN_RAD;
use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Severity, VerdictOn};

use crate::figures::{Figure, LimbFigures, SphereFigures};
use crate::findings::Found;
use crate::inspection::{Bottom, StandingBody};
use crate::rules::limits::Limits;

pub(super) static NOT_ON_FLOOR: Rule = Rule {
    code: FindingCode::NotOnFloor,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Standing),
    what: "At the default pose the spheres are more than half a radius inside the floor and deeper than where they carry the body, or more than 20 mm above it.",
    why: "A simulation that starts there is thrown into the air by forces of many body weights, or falls first. Most published models are made so, and a simulation of theirs starts from another pose.",
    advice: "Nothing, if simulations start from a pose of their own; else give the coordinate the value that `inspect MODEL` says",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Piece {
        model: "check/within_limits.osim",
        good: "<location>0 -0.05 0</location>",
        bad: "<location>0 0.9 0</location>",
    },
};

/// A finding for each body that does not start on its floor.
pub(super) fn find_not_on_floor(limits: &Limits<'_>) -> Vec<Found> {
    let bodies = &limits.inspected.standing;
    let found = bodies
        .iter()
        .filter(|body| is_off(body))
        .filter_map(|body| not_on_floor_finding(body, bodies.len() > 1));
    found.map(Found::from).collect()
}

/// Whether a simulation of `body` starts inside the floor or above it.
fn is_off(body: &StandingBody) -> bool {
    body.is_above_floor() || body.is_inside_floor()
}

fn not_on_floor_finding(body: &StandingBody, of_several: bool) -> Option<Finding> {
    let which = if of_several { format!("with {} ", shown(&body.body)) } else { String::new() };
    let (place, way) = (body.place()?, body.way_to_stand());
    let text = format!("a simulation {which}from the default pose starts {place}; {way}");
    Some(Finding::new(&NOT_ON_FLOOR, text).with_place(&body.lowest()?.path))
}

/// Bottoms that differ by more than this, in the radius of the lowest sphere, are too uneven.
const TOO_MUCH: f64 = 0.5;
/// Heights have rounding errors.
const ROUNDING: f64 = 1e-9;

pub(super) static UNEVEN_BOTTOMS: Rule = Rule {
    code: FindingCode::UnevenBottoms,
    severity: Severity::Warning,
    verdict: Some(VerdictOn::Standing),
    what: "The bottoms of a limb's spheres differ in height by more than half a radius at the default pose, and the foot lies flat there.",
    why: "The lower spheres carry the body, the higher ones little or nothing, so that figures of a level foot do not hold. Of 134 published models with level floors two differ so much.",
    advice: "If the spheres are meant to be on one sole, make their bottoms level, as low as the lowest one; else correct the places that are wrong. `inspect MODEL` says how deep each sphere is. Where radii change, a rescaling can keep bottoms where they are",
    repair: Repair::Command(
        "moves the centres of the limb's spheres until their bottoms are as low as its lowest one at the default pose",
    ),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/uneven_bottoms.osim" },
};

/// The limb whose bottoms differ most.
pub(super) fn find_uneven_bottoms(limits: &Limits<'_>) -> Option<Found> {
    let worst = Uneven::worst(limits)?;
    worst.is_too_much().then(|| Found::new(worst.finding(&UNEVEN_BOTTOMS), limits.remedies.level()))
}

/// A limb whose lowest and highest bottoms differ.
struct Uneven<'i> {
    limb: &'i LimbFigures,
    lowest: &'i Bottom,
    highest: &'i Bottom,
    /// By how much, in the radius of the lowest sphere.
    share: f64,
    /// How far the bodies of these spheres lean, rad.
    tilt_rad: f64,
}

impl<'i> Uneven<'i> {
    /// The limb whose bottoms differ most.
    pub(super) fn worst(limits: &Limits<'i>) -> Option<Self> {
        let bottoms = limits.inspected.standing.iter().flat_map(|body| &body.bottoms);
        let bottoms: HashMap<&str, &Bottom> = bottoms.map(|bottom| (bottom.path.as_str(), bottom)).collect();
        let limbs = limits.inspected.figures.limbs.iter();
        let uneven = limbs.filter_map(|limb| Self::of(&bottoms, limb));
        uneven.reduce(|a, b| if b.share > a.share { b } else { a })
    }

    /// Whether they differ by more than `share` of the radius of the lowest sphere.
    fn is_beyond(&self, share: f64) -> bool {
        self.share > share + ROUNDING
    }

    /// Whether that is a warning: a foot that leans has such contacts by its pose.
    fn is_too_much(&self) -> bool {
        self.is_beyond(TOO_MUCH) && self.tilt_rad <= MOST_LEAN_RAD
    }

    fn of(bottoms: &HashMap<&str, &'i Bottom>, limb: &'i LimbFigures) -> Option<Self> {
        limb.limb.as_ref()?;
        let own = limb.spheres.iter().filter_map(|sphere| bottoms.get(sphere.path.as_str()));
        let bottoms: Vec<&Bottom> = own.copied().collect();
        let lowest = bottoms.iter().copied().reduce(|a, b| if b.height_m < a.height_m { b } else { a })?;
        let highest = bottoms.iter().copied().reduce(|a, b| if b.height_m > a.height_m { b } else { a })?;
        let share = (highest.height_m - lowest.height_m) / lowest.radius_m;
        let tilt_rad = bottoms.iter().map(|bottom| bottom.tilt_rad).fold(0.0, f64::max);
        Some(Self { limb, lowest, highest, share, tilt_rad })
    }

    pub(super) fn finding(&self, rule: &'static Rule) -> Finding {
        let Self { limb, lowest, highest, share, tilt_rad } = self;
        let millimetres = readable(((highest.height_m - lowest.height_m) * 1e4).round() / 10.0);
        let tilted = match *tilt_rad > MOST_LEAN_RAD {
            true => format!("; the foot leans by {:.0} degrees there", tilt_rad.to_degrees()),
            false => String::new(),
        };
        let text = format!(
            "the bottoms of {} differ by {millimetres} mm at the default pose, {} R, from {} to {}{}{tilted}",
            shown(limb.limb.as_deref().unwrap_or_default()),
            three_significant(*share),
            shown(&lowest.sphere),
            shown(&highest.sphere),
            self.shares(),
        );
        Finding::new(rule, text).with_place(&highest.path)
    }

    /// How deep the two are where the limb carries the body.
    fn shares(&self) -> String {
        let of = |bottom: &Bottom| {
            let is_it = |sphere: &&SphereFigures| sphere.path == bottom.path;
            let sphere = self.limb.spheres.iter().find(is_it)?;
            Some(three_significant(sphere.value(Figure::StandingIndentationModelLaw)?))
        };
        match of(self.lowest).zip(of(self.highest)) {
            Some((lowest, highest)) => {
                format!(": with body weight on them x/R is {lowest} and {highest}")
            }
            None => String::new(),
        }
    }
}

/// Bottoms that differ by more than this, in the radius of the lowest sphere, are a remark.
const REMARK: f64 = 0.3;

pub(super) static UNLEVEL_FOOT: Rule = Rule {
    code: FindingCode::UnlevelFoot,
    severity: Severity::Remark,
    verdict: Some(VerdictOn::Standing),
    what: "The bottoms of a limb's spheres differ in height by more than 0.3 radii at the default pose; by more than half a radius only because the foot leans there.",
    why: "The lower spheres are deeper than the figures of a level foot say. Of 134 published models with level floors 16 differ so much.",
    advice: "Nothing, if that is meant; `inspect MODEL` says how deep each sphere is at its own height. Where radii change, a rescaling can keep bottoms where they are",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "format/mixed_radii.osim" },
};

/// The limb whose bottoms differ most, unless that is a warning.
pub(super) fn find_unlevel_foot(limits: &Limits<'_>) -> Option<Found> {
    let worst = Uneven::worst(limits).filter(|worst| worst.is_beyond(REMARK) && !worst.is_too_much())?;
    Some(worst.finding(&UNLEVEL_FOOT).into())
}
