//! What was published so with known contacts is a remark: their table says which findings those are.

use osim_messages::readable;
use osim_model::{Finding, FindingCode};

use super::found::Found;
use crate::inspection::Inspection;

/// The findings as bad as they are with these contacts, and a remark that these are known.
pub(super) fn as_published(inspected: &Inspection, findings: Vec<Found>) -> Vec<Found> {
    let Some(known) = inspected.known_contacts else { return findings };
    let judged = |finding: Found| match known.severity(finding.code) {
        Some(severity) => finding.with_severity(severity),
        None => finding,
    };
    let mut judged: Vec<Found> = findings.into_iter().map(judged).collect();
    let text = format!(
        "the contact parameters are those of {}, made for {} kg",
        known.title,
        readable(known.made_for_kg)
    );
    judged.push(Finding::new(FindingCode::KnownContacts, text).into());
    judged
}
