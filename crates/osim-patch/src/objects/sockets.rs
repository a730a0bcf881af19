//! Writes the paths of sockets whose paths lead nowhere.

use osim_model::{Fault, Irregularity, Model};

use crate::edit::{Edit, model_with_edits};
use crate::insert::escaped_attribute;
use crate::objects::rebuilt::{EarlierNote, ObjectAction, ObjectChange, RebuiltModel};

/// The tags of sockets, for reports.
const SOCKET_TAGS: [&str; 7] = [
    "socket_frame",
    "socket_parent",
    "socket_parent_frame",
    "socket_child_frame",
    "socket_sphere",
    "socket_half_space",
    "body_name",
];

/// Writes into each socket that was resolved by name the path of the component that was found. No other byte changes.
///
/// # Errors
/// The model with these paths cannot be read.
pub fn connect_sockets(model: &Model) -> Result<RebuiltModel, Fault> {
    let tree = model.document().tree();
    let (mut edits, mut objects) = (Vec::new(), Vec::new());
    for irregularity in &model.irregularities {
        if let Irregularity::TakenByName { owner, taken, socket: Some(socket), .. } = irregularity {
            let tag = tree.name(*socket);
            edits.push(Edit { span: tree.raw_text(*socket).span, text: escaped_attribute(taken) });
            let class = SOCKET_TAGS.into_iter().find(|known| *known == tag).unwrap_or("socket");
            let name = owner.rsplit('/').next().unwrap_or_default();
            objects.push(ObjectChange::new(ObjectAction::Connected, class, [name, owner], Some(taken)));
        }
    }
    let mut rebuilt = RebuiltModel::new(model_with_edits(model, edits)?, objects, String::new());
    rebuilt.earlier_note = EarlierNote::Untouched;
    Ok(rebuilt)
}
