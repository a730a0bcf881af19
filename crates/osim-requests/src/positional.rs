//! What has no name in a call.

use osim_model::messages::Verb;

/// The fields of a request for `verb` that a call has without their names, in their order. In schemas they are `x-positional`.
pub(crate) const fn positional(verb: Verb) -> &'static [&'static str] {
    match verb {
        Verb::Plot => &["kind", "models"],
        Verb::Batch => &["manifest"],
        Verb::Sweep => &["model"],
        Verb::DropTest => &["subject"],
        Verb::Motion => &["subject", "motion"],
        Verb::Fit => &["file"],
        Verb::Presets => &["name"],
        Verb::Explain => &["topics"],
        Verb::Reproduce => &[],
        _ => &["models"],
    }
}
