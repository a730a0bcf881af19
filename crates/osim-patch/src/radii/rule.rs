//! What happens to the radius of one sphere.

use osim_model::{RadiusFrom, RadiusRule};

/// What happens to the radius of one sphere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SphereRule {
    /// As for all spheres.
    Rule(RadiusRule),
    /// As large against the body as the reference's: this, m.
    Like(f64),
    /// As the wanted stiffness and indentation need: this, m.
    Designed(f64),
    /// As its body grew: this, m.
    Followed(f64),
}

/// Old and new radius of a sphere, m.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    pub(super) old: f64,
    pub(super) new: f64,
    pub(super) ratio: f64,
}

impl SphereRule {
    pub(super) fn equation(self) -> &'static str {
        match self {
            Self::Rule(RadiusRule::Isometric) | Self::Like(_) => "8",
            Self::Followed(_) => "follow",
            Self::Designed(_) => "11, B.2",
            Self::Rule(_) => "given",
        }
    }

    /// Why the radius changes.
    pub(super) fn source(self) -> RadiusFrom {
        match self {
            Self::Rule(_) | Self::Like(_) => RadiusFrom::Rule,
            Self::Designed(_) => RadiusFrom::ContactStiffness,
            Self::Followed(_) => RadiusFrom::Bodies,
        }
    }

    /// Whether the new radius is a multiple of the old one.
    pub(super) fn is_relative(self) -> bool {
        matches!(self, Self::Rule(RadiusRule::Isometric | RadiusRule::Keep | RadiusRule::Factor(_)))
    }

    pub(super) fn pair(self, old: f64, isometric: f64) -> Pair {
        let times = |ratio: f64| Pair { old, new: if ratio == 1.0 { old } else { old * ratio }, ratio };
        match self {
            Self::Rule(RadiusRule::Isometric) => times(isometric),
            Self::Rule(RadiusRule::Keep) => times(1.0),
            Self::Rule(RadiusRule::Factor(factor)) => times(factor),
            Self::Rule(RadiusRule::Metres(new))
            | Self::Like(new)
            | Self::Followed(new)
            | Self::Designed(new) => Pair { old, new, ratio: new / old },
        }
    }
}
