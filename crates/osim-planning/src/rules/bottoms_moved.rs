//! A change moves the bottoms of spheres, so that a body no longer stands at its default pose, or a foot is uneven.

use osim_inspect::{Bottom, StandingBody};
use osim_model::messages::{readable, shown, three_significant};
use osim_model::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::BottomsMoved,
    severity: Severity::Warn,
    seen: Seen::Change,
    verdict: None,
    what: "A change moves the bottoms of spheres so far that a body which stood at its default pose starts inside its floor or above it, or that a level foot is uneven.",
    why: "Radii grow around centres that stay. A simulation that starts from the default pose starts inside the floor then, and lower spheres carry what all should carry. Contacts that are made for a body which is still to be scaled are not judged by the pose of the one that is there, nor are spheres that follow their bodies.",
    advice: "Give the coordinate its new value, or keep bottoms where they are with `level`; nothing, if simulations start from a pose of their own and the foot is meant to be so",
    repair: Repair::NotPossible("a change is what it is about, and not a model"),
    example: Example::Request {
        good: r#"{"verb": "set", "models": ["check/within_limits.osim"], "set": {"radius": "x1.05"}}"#,
        bad: r#"{"verb": "set", "models": ["check/within_limits.osim"], "set": {"radius": "x2"}}"#,
    },
};

/// A body that stood as `before` and does not as `now`; it is named if there are `several`.
pub(crate) fn of_body(before: &StandingBody, now: &StandingBody, several: bool) -> Option<Finding> {
    let which = if several { format!(" of {}", shown(&now.body)) } else { String::new() };
    let (was, is) = (before.place()?, now.place()?);
    let text = format!("the default pose{which} was {was} and is {is} now; {}", now.way_to_stand());
    Some(Finding::new(&RULE, text).about(&now.lowest()?.path))
}

/// A limb whose bottoms differed by `before_m` and differ more now, from `lowest` to `highest`.
pub(crate) fn of_limb(limb: &str, before_m: f64, lowest: &Bottom, highest: &Bottom) -> Finding {
    let millimetres = |metres: f64| readable((metres * 1e4).round() / 10.0);
    let now_m = highest.height_m - lowest.height_m;
    let text = format!(
        "the bottoms of {} differed by {} mm at the default pose and differ by {} mm now, {} R, from {} to {}",
        shown(limb),
        millimetres(before_m),
        millimetres(now_m),
        three_significant(now_m / lowest.radius_m),
        shown(&lowest.sphere),
        shown(&highest.sphere),
    );
    Finding::new(&RULE, text).about(&highest.path)
}
