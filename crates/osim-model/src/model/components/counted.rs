//! Of a model beside a set that stands alone: which of its sets count.

/// Which sets of a model count: beside a set that stands alone, others are in its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counted {
    All,
    /// Only where spheres are: of a model given as geometry, with another that has masses and joints.
    Geometry,
    /// All but forces, which the set has.
    AllButForces,
    /// All but forces and contact geometry, which other files have.
    Bodies,
}

impl Counted {
    /// Of the file `index` of `count` that are given beside a set: first geometry, then the model.
    pub(super) fn beside_set(index: usize, count: usize) -> Self {
        match (index, count) {
            (0, 1) => Self::AllButForces,
            (0, _) => Self::Geometry,
            _ => Self::Bodies,
        }
    }

    /// Whether this set of a model counts.
    pub(super) fn has(self, set: &str) -> bool {
        match self {
            Self::All => true,
            Self::Geometry => set == "ContactGeometrySet",
            Self::AllButForces => set != "ForceSet",
            Self::Bodies => !["ForceSet", "ContactGeometrySet"].contains(&set),
        }
    }
}
