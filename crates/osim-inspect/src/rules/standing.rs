//! Rules about the default pose: whether the body is on its floor, and whether the bottoms of its spheres are level.

use foldhash::HashMap;
use osim_model::feet::MOST_LEAN_RAD;
use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Example, Finding, Repair, Rule, has_word};
use osim_requests::Request;

use crate::body_bones::is_named_after_foot;
use crate::rules::figure_check::FigureCheck;
use crate::rules::skeleton::series_of;
use crate::{Bottom, Figure, FindingWithRemedy, LimbFigures, SphereFigures, StandingBody};
use osim_model::rule;

rule! { pub(super) NOT_ON_FLOOR: NotOnFloor, Remark, Standing;
    what: "At the default pose the spheres are more than half a radius inside the floor and deeper than where they carry the body, or more than 20 mm above it.",
    why: "A simulation that starts there is thrown into the air by forces of many body weights, or falls first. Most published models have such a default pose, and their simulations start from another one.",
    advice: "Nothing, if simulations start from a pose of their own; else give the coordinate the value that `inspect MODEL` says",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::ElementText { tag: "location", good: "0 -0.05 0", bad: "0 0.9 0" },
}

/// A finding for each body that does not start on its floor.
pub(super) fn find_not_on_floor(check: &FigureCheck<'_>) -> Vec<FindingWithRemedy> {
    let bodies = &check.inspected.standing;
    let finding = |body: &StandingBody| {
        let which = if bodies.len() > 1 { format!(" of {}", shown(&body.body)) } else { String::new() };
        let (height, way) = (body.pose_in_words()?, body.describe_way_to_stand());
        let text = format!("the default pose{which} is {height}; {way}");
        let lowest = body.lowest()?;
        let finding = Finding::new(&NOT_ON_FLOOR, text).with_place(&lowest.path);
        Some(FindingWithRemedy::from(finding.with_measure(lowest.height_m.abs(), "")))
    };
    let off_floor = bodies.iter().filter(|body| body.is_above_floor() || body.is_inside_floor());
    off_floor.filter_map(finding).collect()
}

/// A height difference of bottoms above this, in the radius of the lowest sphere, is a warning.
const WARNING_DIFFERENCE_RADII: f64 = 0.5;
/// Tolerance for rounding errors of heights.
const ROUNDING_OF_HEIGHTS: f64 = 1e-9;

rule! { pub(super) UNEVEN_BOTTOMS: UnevenBottoms, Warning, Standing;
    what: "The lowest points of a limb's spheres differ in height by more than half a radius at the default pose, and the foot lies flat there.",
    why: "The lower spheres carry the body, the higher ones little or nothing, so that the values of a level foot do not hold. Of 134 published models with level floors two differ so much.",
    advice: "If the spheres should form one flat sole, make their lowest points level, as low as the lowest one; else correct the places that are wrong. `inspect MODEL` says how deep each sphere is. Where radii change, a rescaling can keep the lowest points where they are",
    repair: Repair::Command("moves the centres of the limb's spheres until all are as low as the lowest one at the default pose"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "check/uneven_bottoms.osim" },
}

/// Finds the limb whose bottoms differ most in height, if the difference is a warning.
pub(super) fn find_uneven_bottoms(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let worst = UnevenLimb::worst(check)?;
    let finding = || FindingWithRemedy::new(worst.finding(&UNEVEN_BOTTOMS), level_feet(check));
    worst.is_warning(check).then(finding)
}

/// How many times larger the radii are of contacts that are made for the mass of the bodies, where a note or the caller says that these are
/// made for a smaller mass; else 1.
fn growth_to_bodies(check: &FigureCheck<'_>) -> f64 {
    let made_for = check.inspected.contacts_mass_kg.as_ref().filter(|mass| mass.from.is_about_contacts());
    let bodies_kg = check.inspected.standing.iter().find_map(|body| body.mass_kg);
    let ratio = bodies_kg.zip(made_for).map(|(bodies_kg, made_for)| bodies_kg / made_for.value);
    ratio.map_or(1.0, |ratio| libm::cbrt(ratio).max(1.0))
}

/// The largest part of the larger radius by which the bottoms of spheres whose radii differ by up to four times are apart.
const MOST_OF_RADIUS: f64 = 0.75;

/// The remedy that makes bottoms level; `None` if a limb's differ by more than radii explain: a place is wrong, and to level the foot would
/// hide it.
pub(super) fn level_feet(check: &FigureCheck<'_>) -> Option<Request> {
    let UnevenLimb { lowest, highest, .. } = UnevenLimb::worst(check)?;
    let most_m = MOST_OF_RADIUS * lowest.radius_m.max(highest.radius_m);
    (highest.height_m - lowest.height_m <= most_m).then(|| check.remedies.level_feet()).flatten()
}

/// The bottoms of all spheres by their paths.
pub(super) fn bottoms_by_path<'i>(check: &FigureCheck<'i>) -> HashMap<&'i str, &'i Bottom> {
    let bottoms = check.inspected.standing.iter().flat_map(|body| &body.bottoms);
    bottoms.map(|bottom| (bottom.path.as_str(), bottom)).collect()
}

/// A limb whose lowest and highest bottoms differ.
pub(super) struct UnevenLimb<'i> {
    limb: &'i LimbFigures,
    lowest: &'i Bottom,
    highest: &'i Bottom,
    /// The height difference in the radius of the lowest sphere.
    difference_radii: f64,
    /// How far the bodies of the lowest and the highest sphere lean, rad.
    tilt_rad: f64,
    /// The difference with all coordinates at 0, m, if it is small there: then only the pose makes the bottoms uneven.
    difference_at_zero_m: Option<f64>,
}

/// A foot that leans by more than this at the default pose, rad, stands on an edge because of the pose.
const LEAST_LEAN_RAD: f64 = 0.01;

impl<'i> UnevenLimb<'i> {
    /// The limb whose bottoms differ most in height, among those that stand.
    fn worst(check: &FigureCheck<'i>) -> Option<Self> {
        let bottoms = bottoms_by_path(check);
        let limbs = check.inspected.figures.limbs.iter().filter(|limb| limb.limb.is_some());
        let uneven: Vec<Self> = limbs.filter_map(|limb| Self::of(&bottoms, limb)).collect();
        let lowest_sole_m = uneven.iter().map(|one| one.highest.height_m).fold(f64::INFINITY, f64::min);
        // A foot that is raised above the whole of another one does not stand.
        let stands = |one: &Self| one.lowest.height_m - lowest_sole_m <= one.lowest.radius_m;
        let standing = uneven.into_iter().filter(stands);
        standing.reduce(|a, b| if b.difference_radii > a.difference_radii { b } else { a })
    }

    fn differs_by_more_than(&self, radii: f64) -> bool {
        self.difference_radii > radii + ROUNDING_OF_HEIGHTS
    }

    /// Whether the difference is a warning. It is not a warning if the foot leans so much that the difference follows from the pose, or if it
    /// is small for contacts that are made for the mass of these bodies.
    fn is_warning(&self, check: &FigureCheck<'_>) -> bool {
        let tilt_rad = if self.tilt_rad > MOST_LEAN_RAD { self.tilt_rad } else { 0.0 };
        let of_pose_m = self.lowest.centre_m.distance(self.highest.centre_m) * libm::sin(tilt_rad);
        let most_radii = WARNING_DIFFERENCE_RADII * growth_to_bodies(check);
        self.differs_by_more_than(most_radii + of_pose_m / self.lowest.radius_m)
            && self.difference_at_zero_m.is_none()
    }

    /// Whether the pose decides which of the spheres are low.
    pub(super) fn leans(&self) -> bool {
        self.tilt_rad > LEAST_LEAN_RAD || self.difference_at_zero_m.is_some()
    }

    /// The lowest and the highest bottom of `limb`; `None` if its bottoms are not known.
    pub(super) fn of(bottoms: &HashMap<&str, &'i Bottom>, limb: &'i LimbFigures) -> Option<Self> {
        let of_limb = limb.spheres.iter().filter_map(|sphere| bottoms.get(sphere.path.as_str()));
        let all: Vec<&Bottom> = of_limb.copied().collect();
        // Spheres of a knee or a seat are no part of the sole, unless they are named like those of a foot.
        let is_on_foot = |bottom: &&Bottom| bottom.body.as_deref().is_some_and(is_named_after_foot);
        let of_feet: Vec<&Bottom> = all.iter().copied().filter(is_on_foot).collect();
        let is_of_sole = |bottom: &&Bottom| {
            let series = || series_of(&bottom.sphere);
            of_feet.iter().any(|one| one.path == bottom.path)
                || is_named_after_foot(&series())
                || has_word(&series(), "heel")
                || of_feet.iter().any(|one| series_of(&one.sphere) == series())
        };
        let bottoms: Vec<&Bottom> =
            if of_feet.is_empty() { all } else { all.into_iter().filter(is_of_sole).collect() };
        let lowest = bottoms.iter().copied().reduce(|a, b| if b.height_m < a.height_m { b } else { a })?;
        let highest = bottoms.iter().copied().reduce(|a, b| if b.height_m > a.height_m { b } else { a })?;
        let difference_radii = (highest.height_m - lowest.height_m) / lowest.radius_m;
        let tilt_rad = bottoms.iter().map(|bottom| bottom.tilt_rad).fold(0.0, f64::max);
        let mut at_zero_m: Vec<f64> =
            bottoms.iter().map(|bottom| bottom.height_at_zero_m).collect::<Option<_>>().unwrap_or_default();
        at_zero_m.sort_by(f64::total_cmp);
        let most_m = WARNING_DIFFERENCE_RADII * lowest.radius_m;
        let is_level = |at_zero_m: &f64| highest.height_m - lowest.height_m > most_m && *at_zero_m <= most_m;
        let difference_at_zero_m = at_zero_m.last().zip(at_zero_m.first()).map(|(high, low)| high - low);
        let difference_at_zero_m = difference_at_zero_m.filter(is_level);
        Some(Self { limb, lowest, highest, difference_radii, tilt_rad, difference_at_zero_m })
    }

    /// The finding of `rule` about this limb.
    fn finding(&self, rule: &'static Rule) -> Finding {
        let Self { limb, lowest, highest, difference_radii, tilt_rad, .. } = self;
        let millimetres = |metres: f64| readable((metres * 1e4).round() / 10.0);
        let tilted = match self.difference_at_zero_m {
            Some(metres) => format!("; with all coordinates at 0 by {} mm", millimetres(metres)),
            None if *tilt_rad > MOST_LEAN_RAD => {
                format!("; the foot is tilted by {:.0} degrees there", tilt_rad.to_degrees())
            }
            None => String::new(),
        };
        let text = format!(
            "the lowest points of {} differ by {} mm at the default pose, {} R, from {} to {}{}{tilted}",
            shown(limb.limb.as_deref().unwrap_or_default()),
            millimetres(highest.height_m - lowest.height_m),
            three_significant(*difference_radii),
            shown(&lowest.sphere),
            shown(&highest.sphere),
            self.depths_in_words(),
        );
        Finding::new(rule, text).with_place(&highest.path).with_measure(*difference_radii, "")
    }

    /// How deep the lowest and the highest sphere are while the limb carries the body; empty if it is not known.
    fn depths_in_words(&self) -> String {
        let depth = |bottom: &Bottom| {
            let has_path = |sphere: &&SphereFigures| sphere.path == bottom.path;
            let sphere = self.limb.spheres.iter().find(has_path)?;
            Some(three_significant(sphere.value(Figure::StandingIndentationModelLaw)?))
        };
        let both = depth(self.lowest).zip(depth(self.highest));
        let text = |(lowest, highest)| format!(": with body weight on them x/R is {lowest} and {highest}");
        both.map(text).unwrap_or_default()
    }
}

/// A height difference of bottoms above this, in the radius of the lowest sphere, is a remark.
const REMARK_DIFFERENCE_RADII: f64 = 0.3;

rule! { pub(super) UNLEVEL_FOOT: UnlevelFoot, Remark, Standing;
    what: "The lowest points of a limb's spheres differ in height by more than 0.3 radii at the default pose; by more than half a radius only because the foot is tilted there.",
    why: "The lower spheres are deeper than the values of a level foot show. Of 134 published models with level floors 16 differ so much.",
    advice: "Nothing, if this is intended; `inspect MODEL` says how deep each sphere is at its own height. Where radii change, a rescaling can keep the lowest points where they are",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Models { good: "check/known_contacts.osim", bad: "format/mixed_radii.osim" },
}

/// Finds the limb whose bottoms differ most in height, unless the difference is a warning.
pub(super) fn find_unlevel_foot(check: &FigureCheck<'_>) -> Option<FindingWithRemedy> {
    let worst = UnevenLimb::worst(check)
        .filter(|worst| worst.differs_by_more_than(REMARK_DIFFERENCE_RADII) && !worst.is_warning(check))?;
    Some(worst.finding(&UNLEVEL_FOOT).into())
}
