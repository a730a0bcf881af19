//! A model with its new contacts.

use std::collections::HashSet;

use osim_model::{Fault, FaultKind, Force, Model, Selected};
use osim_patch::{Layout, Rebuilt, add_contacts};

/// `base` with the contacts of `layout`, and their forces.
///
/// # Errors
/// Contacts of `base` that stay are on bodies that get new ones: both would carry the weight.
pub(super) fn added(base: &Model, layout: &mut Layout) -> Result<(Rebuilt, Selected), Fault> {
    let bodies: HashSet<&str> = layout.contacts.iter().map(|contact| contact.body.as_str()).collect();
    let is_there = |force: &Force| {
        let mut spheres = force.spheres().into_iter().filter_map(|id| base.sphere(id)?.body.as_deref());
        base.meets_half_space(force) && spheres.any(|body| bodies.contains(body))
    };
    let doubled = Selected::those(base, is_there);
    if !doubled.forces.is_empty() {
        return Err(Fault::new(FaultKind::ContactsExist { forces: base.names_of(&doubled.forces) }));
    }
    let rebuilt = add_contacts(base, layout)?;
    let own: HashSet<&str> = layout.contacts.iter().map(|contact| contact.force.as_str()).collect();
    let selected = Selected::those(rebuilt.model(), |force| own.contains(force.name.as_str()));
    Ok((rebuilt, selected))
}
