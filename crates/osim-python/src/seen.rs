//! What a survey knows of one model.

use osim_inspect::{CheckResult, Counts, Inspection};
use osim_model::files::Failure;

/// What is known of a model; its findings also as requests that put them right.
pub(crate) enum Seen {
    /// And how much is wrong with it, where the text says that.
    Inspected(Box<Inspection>, Option<Counts>),
    Checked(Box<CheckResult>, Vec<Option<String>>),
    /// A folder's model without contacts: a library may have such.
    WithoutContacts,
    Failed(Box<Failure>),
}
