//! A finding with what puts it right.

use std::ops::Deref;

use osim_model::{Finding, Severity};
use osim_requests::Request;
use osim_requests::spell::Speller;

/// Something found in a model, and the request that puts it right. It reads like its [`Finding`], which says where it applies.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Found {
    /// What was found.
    pub finding: Finding,
    /// What puts it right; `None` where only the user can know what to write, and for a remark. Where the result says
    /// [`steps`](crate::CheckResult::steps) it is one of them.
    pub remedy: Option<Request>,
    /// Whether known contacts were published with it.
    pub as_published: bool,
    /// The remedy as the reader types it, once [`spell`](Self::spell) was given the words of a front end.
    pub command: Option<String>,
}

impl Found {
    /// A finding, and what puts it right, where there is something.
    #[must_use]
    pub fn new(finding: Finding, remedy: Option<Request>) -> Self {
        Self { finding, remedy, as_published: false, command: None }
    }

    /// The same, as bad as in the published state of known contacts: nothing has to be put right there.
    #[must_use]
    pub fn as_published(self, severity: Severity) -> Self {
        Self { finding: self.finding.with_severity(severity), remedy: None, as_published: true, ..self }
    }

    /// Spells what it says, and its remedy, in the words of a front end.
    pub fn spell(&mut self, speller: &dyn Speller) {
        self.finding.spell(speller);
        self.command = self.remedy.as_ref().map(|remedy| speller.request(remedy));
    }
}

impl From<Finding> for Found {
    fn from(finding: Finding) -> Self {
        Self::new(finding, None)
    }
}

impl Deref for Found {
    type Target = Finding;

    fn deref(&self) -> &Finding {
        &self.finding
    }
}
