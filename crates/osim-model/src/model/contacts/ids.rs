//! Handles of contacts in a model. Each is made by the model that has the contact, and means nothing in another one.

/// Handle of a contact sphere in its [`Model`](crate::model::Model), in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SphereId(pub(crate) usize);

/// Handle of a contact force in its [`Model`](crate::model::Model), in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ForceId(pub(crate) usize);

/// Handle of a parameter set in its [`Force`](crate::model::Force), in file order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SetId(pub(crate) usize);

impl SphereId {
    /// Its place among the spheres of the model, from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

impl ForceId {
    /// Its place among the forces of the model, from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

impl SetId {
    /// The first set of a force: the only one of a `SmoothSphereHalfSpaceForce`.
    pub const FIRST: Self = Self(0);

    /// Its place among the sets of the force, from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}
