//! Remedies as requests, for callers that apply them.

use osim_inspect::CheckResult;
use osim_requests::Request;

/// The requests that put each finding right, one after the other, as a JSON list; `None` where nothing does.
pub(crate) fn remedies(found: &CheckResult) -> Vec<Option<String>> {
    let of = |finding| {
        let steps: Vec<String> = found.steps_to(finding).iter().map(Request::to_json).collect();
        (!steps.is_empty()).then(|| format!("[{}]", steps.join(",")))
    };
    found.findings.iter().map(of).collect()
}
