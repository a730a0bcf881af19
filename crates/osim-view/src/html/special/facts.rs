//! What a page keeps of every model, to say how many there are of each kind and which are special.

use std::collections::{BTreeMap, BTreeSet};

use contact_scaling::limits;
use osim_inspect::series::Body;
use osim_inspect::{CheckResult, Counts, Figure, Figures};
use osim_model::messages::four_significant;
use osim_model::{FindingCode, Severity};

/// Numbers of one model.
#[derive(Debug, Clone, Default)]
pub(crate) struct Facts {
    /// What it weighs, kg; after a change the mass that the new contacts carry.
    pub(crate) mass_kg: Option<f64>,
    pub(crate) indentation: Indentation,
    /// Findings in it; after a change in the new one.
    pub(crate) counts: Counts,
    /// Each code once, with its worst severity.
    pub(crate) codes: BTreeMap<FindingCode, Severity>,
    /// Its contact without dimensions: models with equal texts have the same contact.
    pub(crate) contact: Option<String>,
    /// What the contacts were taken from, in words.
    pub(crate) reference: Option<String>,
}

/// x̂ = x/R at rest, by the Hertz law, of the sphere that sinks in most.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Indentation {
    /// Before a change.
    pub(crate) before: Option<f64>,
    /// The old contacts under the new weight, if it differs.
    pub(crate) not_scaled: Option<f64>,
    /// The model after a change, or as it is if it was only read.
    pub(crate) now: Option<f64>,
}

impl Facts {
    pub(crate) fn new(figures: &Figures, found: &CheckResult, body: Option<&Body>) -> Self {
        Self {
            mass_kg: figures.mass_kg,
            indentation: Indentation { now: deepest(figures), ..Indentation::default() },
            counts: found.counts,
            codes: worst(found),
            contact: body.and_then(contact),
            reference: None,
        }
    }
}

fn worst(found: &CheckResult) -> BTreeMap<FindingCode, Severity> {
    let mut codes: BTreeMap<FindingCode, Severity> = BTreeMap::new();
    for finding in &found.findings {
        let worst = codes.entry(finding.code()).or_insert(finding.severity);
        *worst = finding.severity.max(*worst);
    }
    codes
}

/// x̂ of the sphere that sinks in most under the body weight on one limb.
pub(crate) fn deepest(figures: &Figures) -> Option<f64> {
    figures.spheres().filter_map(|sphere| sphere.value(Figure::Indentation)).reduce(f64::max)
}

/// Whether x̂ is outside the limit of the Hertz law.
pub(crate) fn is_too_deep(indentation: f64) -> bool {
    !limits::INDENTATION.admits(indentation)
}

/// x/R and damping of each kind of sphere, as a page shows them.
fn contact(body: &Body) -> Option<String> {
    let contacts = body.dimensionless().ok()?;
    let shown = contacts.iter().map(|(_, contact)| {
        let (depth, damping) = (contact.relative_indentation(), contact.dissipation());
        format!("x/R = {}, α √(gR) = {}", four_significant(depth), four_significant(damping))
    });
    // Spheres of several kinds in any order are one contact.
    let distinct: BTreeSet<String> = shown.collect();
    Some(distinct.into_iter().collect::<Vec<_>>().join("; "))
}
