//! Whether the model stands at its default pose.

use osim_messages::Phrase;

use super::known::Known;

/// What puts it on its feet.
pub(super) fn right(_known: &Known<'_>) -> Result<Phrase, Phrase> {
    Err("where it stands was not looked at".into())
}
