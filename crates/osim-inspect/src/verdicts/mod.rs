//! Six questions about every model, each answered in one line: what was found decides, else what is right about it.

mod floor;
mod known;
mod mass;
mod sides;
mod sizes;
mod solver;
mod standing;
mod verdict;

use std::cmp::Reverse;

use osim_model::{FindingCode, Model, VerdictOn};

use self::known::Known;
use crate::findings::Found;
use crate::inspection::Inspection;

pub use verdict::{Sign, Verdict};

/// The verdicts on a model, in their order. `findings` come the worst first.
pub(crate) fn of(model: &Model, inspected: &Inspection, findings: &[Found]) -> Vec<Verdict> {
    let known = Known { model, inspected };
    VerdictOn::ALL.into_iter().map(|on| of_one(on, &known, findings)).collect()
}

fn of_one(on: VerdictOn, known: &Known<'_>, findings: &[Found]) -> Verdict {
    let mut deciding: Vec<&Found> = findings.iter().filter(|found| found.rule.verdict == Some(on)).collect();
    // Of two that are equally bad, the mass is the reason and the depth what follows.
    deciding
        .sort_by_key(|found| (Reverse(found.severity), found.code() != FindingCode::ContactsOfAnotherMass));
    if let Some((worst, others)) = deciding.split_first() {
        let story = (on == VerdictOn::Mass).then(|| mass::beside(known, worst.code())).flatten();
        return Verdict::of_findings(on, worst, others).and(story);
    }
    if findings.iter().any(|found| found.code() == FindingCode::BareModel) {
        return Verdict::without_findings(on, Err("there are no contacts".into()));
    }
    let right = match on {
        VerdictOn::Floor => floor::right(known),
        VerdictOn::Standing => standing::right(known),
        VerdictOn::Mass => mass::right(known),
        VerdictOn::Sides => sides::right(known),
        VerdictOn::Sizes => sizes::right(known),
        VerdictOn::Solver => solver::right(known),
        VerdictOn::Recording => Err("no recording is given".into()),
    };
    Verdict::without_findings(on, right)
}
