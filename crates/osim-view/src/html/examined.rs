//! What is known of a model that is shown.

use osim_inspect::{CheckResult, Inspection};

/// One state of a model, inspected and checked. It is shown as it is spelled.
#[derive(Debug, Clone, Copy)]
pub struct Examined<'m> {
    /// What is in it.
    pub inspection: &'m Inspection,
    /// What is wrong with it.
    pub check: &'m CheckResult,
}

impl<'m> From<&'m (Inspection, CheckResult)> for Examined<'m> {
    fn from((inspection, check): &'m (Inspection, CheckResult)) -> Self {
        Self { inspection, check }
    }
}
