//! What was published so with known contacts is a remark: their table says which findings those are.

use super::found::Found;
use crate::inspection::Inspection;
use crate::rules::known_contacts;

/// The findings as bad as they are with these contacts, and a remark that these are known.
pub(super) fn as_published(inspected: &Inspection, findings: Vec<Found>) -> Vec<Found> {
    let Some(known) = inspected.known_contacts else { return findings };
    let judged = |finding: Found| match known.severity(finding.code()) {
        Some(severity) => finding.as_published(severity),
        None => finding,
    };
    let mut judged: Vec<Found> = findings.into_iter().map(judged).collect();
    judged.push(known_contacts::of_contacts(known).into());
    judged
}
