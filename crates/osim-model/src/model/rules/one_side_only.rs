//! Spheres of one side alone.

use crate::messages::shown;

use crate::model::finding::{Example, Finding, FindingCode, Repair, Rule, Seen, Severity, VerdictOn};
use crate::model::sides::{BothSides, Placed};

pub(crate) static RULE: Rule = Rule {
    code: FindingCode::OneSideOnly,
    severity: Severity::Info,
    seen: Seen::Model,
    verdict: Some(VerdictOn::Sides),
    what: "Spheres are on one side alone: the other one has none, or no body for them.",
    why: "A model that kicks, hops on one leg or has a prosthesis may need no more; one that walks falls to the other side.",
    advice: "Nothing, if that is meant; else give the other side contacts, too",
    repair: Repair::NotPossible("nothing is wrong"),
    example: Example::Piece {
        model: "format/v40000.osim",
        good: "<geometry>floor heel_l toe_l</geometry>",
        bad: "<geometry>floor</geometry>",
    },
};

/// One finding for all of them.
pub(super) fn find(sides: &BothSides<'_>) -> Option<Finding> {
    if let Some(first) = sides.one_side.first() {
        let text = format!("only the {} side has contact spheres that meet a floor", first.side.as_str());
        return Some(about(text, &sides.one_side.iter().collect::<Vec<_>>(), first));
    }
    let without_body = sides.alone.iter().filter(|alone| alone.other_body.is_none());
    let all: Vec<&Placed<'_>> = without_body.map(|alone| &alone.sphere).collect();
    let first = all.first()?;
    let text = format!(
        "{} on {} has no counterpart: the other side has no such body",
        shown(&first.sphere.name),
        shown(first.body)
    );
    Some(about(text, &all, first))
}

fn about(text: String, all: &[&Placed<'_>], first: &Placed<'_>) -> Finding {
    let finding = Finding::at(&RULE, first.sphere.line, text).about(&first.sphere.path);
    finding.of_spheres(all.iter().map(|placed| placed.sphere.name.clone()).collect())
}
