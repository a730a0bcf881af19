//! A verdict with its question.

use osim_inspect::Verdict;
use serde::Serialize;

/// A verdict as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct VerdictShown {
    question: &'static str,
    #[serde(flatten)]
    verdict: Verdict,
}

impl VerdictShown {
    /// All of a model.
    pub(crate) fn all(verdicts: &[Verdict]) -> Vec<Self> {
        let shown = |verdict: &Verdict| Self { question: verdict.on.question(), verdict: verdict.clone() };
        verdicts.iter().map(shown).collect()
    }
}
