//! Contacts that were scaled to another gravity than the model still has.

use osim_messages::{Input, phrase, readable};
use osim_model::{Finding, FindingCode, Model};

use crate::options::InspectOptions;

/// Two gravities that differ by less than this, relatively, are the same.
const SAME_GRAVITY: f64 = 1e-3;

/// The finding, where the note in the file gives a gravity, the model another, and nobody says which is meant.
pub(crate) fn gravity_mismatch(model: &Model, options: &InspectOptions) -> Option<Finding> {
    let noted = model.note.as_ref()?.gravity_m_s2?;
    let own = model.gravity().filter(|&gravity| gravity > 0.0)?;
    let differ = (noted - own).abs() > SAME_GRAVITY * own;
    if options.stance.gravity_m_s2.is_some() || !differ {
        return None;
    }
    let (noted, own) = (readable(noted), readable(own));
    let message = phrase![
        format!(
            "its contacts are made for {noted} m/s2 (note in the file), and its gravity is {own} m/s2: set <gravity>, or say "
        ),
        Input::Gravity.being(noted),
    ];
    Some(Finding::new(FindingCode::GravitySourcesDisagree, message))
}
