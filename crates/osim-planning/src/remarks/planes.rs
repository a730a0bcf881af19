//! Remarks about planes that new contacts do not meet.

use std::collections::BTreeSet;

use osim_model::feet::angle;
use osim_model::messages::{Phrase, readable};
use osim_model::{Force, ForceId, Model};
use osim_patch::{Deed, Rebuilt};

/// A plane that leans by no more than this, degrees, was probably meant to be level.
const LEANING: f64 = 10.0;

/// Planes of `base` that are nearly a floor, beside which a level one was made.
pub(crate) fn leaning(base: &Model, rebuilt: &Rebuilt) -> Option<Phrase> {
    let added = |object: &osim_patch::ObjectChange| object.deed == Deed::Added;
    let made = rebuilt.objects.iter().find(|object| added(object) && object.class == "ContactHalfSpace")?;
    let up = base.up();
    let planes: Vec<String> = base
        .ground_planes()
        .into_iter()
        .filter_map(|plane| {
            let degrees = angle(plane.normal, up).to_degrees();
            (degrees <= LEANING).then(|| format!("{} (by {} degrees)", plane.name, readable(degrees)))
        })
        .collect();
    if planes.is_empty() {
        return None;
    }
    let text = format!(
        "no half-space of the model is level: {} would be a floor, but it leans; the new forces meet {}, which is level",
        planes.join(", "),
        made.name
    );
    Some(text.into())
}

/// Planes that the `removed` forces of `model` met and that those of `rebuilt` do not.
pub(crate) fn planes_left(model: &Model, removed: &[ForceId], rebuilt: &Rebuilt) -> Option<Phrase> {
    let met = |model: &Model, forces: &mut dyn Iterator<Item = &Force>| -> BTreeSet<String> {
        let sets = forces.flat_map(|force| &force.sets);
        sets.flat_map(|set| model.half_spaces_of(set)).map(|plane| plane.name).collect()
    };
    let before = met(model, &mut removed.iter().filter_map(|&id| model.force(id)));
    let built = rebuilt.model();
    let new: BTreeSet<&str> = rebuilt
        .objects
        .iter()
        .filter(|object| object.deed == Deed::Added)
        .map(|object| object.path.as_str())
        .collect();
    let mut made = built.forces().iter().filter(|force| new.contains(force.path.as_str()));
    let after = met(built, &mut made);
    let left: Vec<&str> = before.difference(&after).map(String::as_str).collect();
    if left.is_empty() || after.is_empty() {
        return None;
    }
    let after: Vec<&str> = after.iter().map(String::as_str).collect();
    let text = format!(
        "the forces that were taken out met {}, which is not a level floor on ground; the new ones meet {}",
        left.join(" and "),
        after.join(" and ")
    );
    Some(text.into())
}
