//! What fields are about that say nothing about contacts, and which have no name in a call.

use osim_model::messages::Verb;

use crate::options::{OutputOptions, RunOptions};

/// What a field of a request is about, if it says nothing about contacts. A front end that has no files, no terminal, or one
/// model at a time leaves such fields out: it asks here, or reads `x-group` in the schema, so that it needs no list of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FieldGroup {
    /// Which files results are written to.
    Output,
    /// Many models at once.
    Many,
    /// How results are shown: on a terminal, and by an exit status.
    Shown,
}

/// How results are shown, whatever the verb.
const SHOWN: [&str; 6] = ["format", "quiet", "diff", "full", "ascii", "deny"];

impl FieldGroup {
    /// The group of a field, given by its name, which means the same for every verb.
    pub(crate) fn of(field: &str) -> Option<Self> {
        // The numbers of a figure are written beside it.
        if OutputOptions::is_about_files(field) || field == "data" {
            Some(Self::Output)
        } else if RunOptions::OF_MANY.contains(&field) {
            Some(Self::Many)
        } else {
            SHOWN.contains(&field).then_some(Self::Shown)
        }
    }

    /// Its name in schemas.
    #[cfg(feature = "schemas")]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Output => "output",
            Self::Many => "many",
            Self::Shown => "shown",
        }
    }
}

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

#[cfg(test)]
mod tests {
    use osim_model::messages::Verb;

    use super::*;
    use crate::silent_fields;

    /// The fields of all verbs that are of a group.
    fn fields_of(group: FieldGroup) -> Vec<String> {
        let mut fields: Vec<String> =
            Verb::ALL.iter().flat_map(|verb| silent_fields(*verb)).map(|(name, _)| name).collect();
        fields.retain(|field| FieldGroup::of(field) == Some(group));
        fields.sort();
        fields.dedup();
        fields
    }

    #[test]
    fn every_group_has_fields_of_requests() {
        assert_eq!(
            fields_of(FieldGroup::Output),
            ["data", "force", "geometry_output", "in_place", "no_backup", "output", "output_dir"]
        );
        assert_eq!(fields_of(FieldGroup::Many), ["jobs", "resume", "shard", "summary"]);
        let mut shown = SHOWN;
        shown.sort_unstable();
        assert_eq!(fields_of(FieldGroup::Shown), shown);
    }
}
