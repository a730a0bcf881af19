//! Objects of one class together, so that twelve spheres are one line.

use osim_patch::{Deed, ObjectChange};

/// Objects of one class to which the same happens.
pub struct ObjectGroup<'p> {
    /// What is done.
    pub deed: Deed,
    /// The class of the objects.
    pub class: &'static str,
    /// Their names, in the plan's order.
    pub names: Vec<&'p str>,
}

/// Objects by what happens to them and by class, in the order of the first of each.
pub fn object_groups(objects: &[ObjectChange]) -> Vec<ObjectGroup<'_>> {
    let mut groups: Vec<ObjectGroup<'_>> = Vec::new();
    for object in objects {
        match groups.iter_mut().find(|group| group.deed == object.deed && group.class == object.class) {
            Some(group) => group.names.push(&object.name),
            None => {
                groups.push(ObjectGroup {
                    deed: object.deed,
                    class: object.class,
                    names: vec![&object.name],
                });
            }
        }
    }
    groups
}
