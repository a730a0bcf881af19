//! The component classes that OpenSim knows; and the sets of a model that are read if another set is given as a separate file.

use std::sync::LazyLock;

/// The subclasses of `Component` in the Python package of OpenSim 4.6, in alphabetical order.
pub fn component_classes() -> &'static [&'static str] {
    static CLASSES: LazyLock<Vec<&str>> =
        LazyLock::new(|| include_str!("component_classes.txt").lines().collect());
    &CLASSES
}

pub(super) fn is_component_class(tag: &str) -> bool {
    component_classes().binary_search(&tag).is_ok()
}

/// Which sets of a model file (`ForceSet`, `ContactGeometrySet`, `BodySet`, …) are read. A set that is given as a separate file replaces the model's own set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CountedSets {
    All,
    /// Only the contact geometry: the file is given for its spheres, and another model has masses and joints.
    Geometry,
    /// Everything except forces: the separate set has the forces.
    AllButForces,
    /// Everything except forces and contact geometry: other files have these.
    Bodies,
}

impl CountedSets {
    /// The sets that are read from file number `index` of the `count` files given with a separate set. The geometry comes first, then the
    /// model.
    pub(super) fn of_file_beside_set(index: usize, count: usize) -> Self {
        match (index, count) {
            (0, 1) => Self::AllButForces,
            (0, _) => Self::Geometry,
            _ => Self::Bodies,
        }
    }

    /// Whether `set` is read from the file.
    pub(super) fn includes(self, set: &str) -> bool {
        match self {
            Self::All => true,
            Self::Geometry => set == "ContactGeometrySet",
            Self::AllButForces => set != "ForceSet",
            Self::Bodies => !["ForceSet", "ContactGeometrySet"].contains(&set),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_of_opensim_are_known_and_others_are_not() {
        assert!(
            is_component_class("SmoothSphereHalfSpaceForce")
                && is_component_class("Body")
                && !is_component_class("MyContacts")
        );
    }
}
