//! Classes of contact forces.

use osim_model::ForceKind;

use crate::choice::choices;

choices! {
    /// A class of contact forces.
    ClassChoice {
        /// `SmoothSphereHalfSpaceForce`.
        Smooth = "smooth";
        /// `HuntCrossleyForce`.
        HuntCrossley = "hunt-crossley";
    }
}

choices! {
    /// The axis of a mirror.
    MirrorChoice {
        /// z: right and left.
        Z = "z";
    }
}

impl ClassChoice {
    /// That of OpenSim's class; `None` for one that cannot be chosen.
    #[must_use]
    pub const fn of(kind: ForceKind) -> Option<Self> {
        match kind {
            ForceKind::SmoothSphereHalfSpace => Some(Self::Smooth),
            ForceKind::HuntCrossley => Some(Self::HuntCrossley),
            _ => None,
        }
    }

    /// OpenSim's class.
    pub const fn kind(self) -> ForceKind {
        match self {
            Self::Smooth => ForceKind::SmoothSphereHalfSpace,
            Self::HuntCrossley => ForceKind::HuntCrossley,
        }
    }
}
