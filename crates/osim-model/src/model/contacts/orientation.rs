//! How half-spaces and frames are turned, as files say it.

use crate::model::components::{ComponentId, Components};
use crate::model::fault::FileId;

/// An orientation, as a file has it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Orientation {
    /// Component path of the half-space, or of the frame that has it.
    pub path: String,
    /// Name of the property.
    pub tag: &'static str,
    /// Line of the property, or of the object where it has none, from 1.
    pub line: usize,
    /// The file it is in.
    pub file: FileId,
    /// Its body-fixed angles about x, y and z, rad; `None` where a number cannot be read.
    pub angles_rad: Option<[f64; 3]>,
}

/// An angle beyond this, rad, is in degrees. OpenSim itself writes no angle beyond π.
const WHOLE_TURN: f64 = std::f64::consts::TAU + 0.01;

impl Orientation {
    /// Whether its angles are degrees: one of them is more than a whole turn in radians.
    #[must_use]
    pub fn is_in_degrees(&self) -> bool {
        self.angles_rad.is_some_and(|angles| angles.iter().any(|angle| angle.abs() > WHOLE_TURN))
    }

    /// The angles of a half-space whose surface faces `direction` (of length 1) of its frame: a turn about y, then one about z. Its
    /// solid side is the +x of its own frame, and R x̂ = (cos β cos γ, sin γ, −sin β cos γ) is to be −`direction`.
    #[must_use]
    pub fn facing([x, y, z]: [f64; 3]) -> [f64; 3] {
        let level = libm::sqrt(x * x + z * z);
        let about_y = if level > 0.0 { libm::atan2(z, -x) } else { 0.0 };
        // A minus before a zero would only raise questions.
        [0.0, about_y + 0.0, libm::atan2(-y, level) + 0.0]
    }

    pub(super) fn read(
        components: &Components,
        id: ComponentId,
        tag: &'static str,
        otherwise: [f64; 3],
    ) -> Self {
        let (document, element) = (components.doc(id), components.element(id));
        let property = document.property_element(element, tag);
        let at = property
            .map_or_else(|| components.line(id), |own| document.line(document.tree().span(own).start));
        let angles_rad = match property {
            Some(_) => document.triple(element, tag),
            None => Some(otherwise),
        };
        Self { path: components.tree.path(id), tag, line: at, file: components.file_of(id), angles_rad }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::model::reference_frame::Rotation;

    #[test]
    fn the_solid_side_is_below() {
        assert_eq!(Orientation::facing([0.0, 1.0, 0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(Orientation::facing([-0.0, 1.0, -0.0]), [0.0, 0.0, -FRAC_PI_2]);
        assert_eq!(Orientation::facing([0.0, 0.0, 1.0]), [0.0, FRAC_PI_2, 0.0]);
        assert_eq!(Orientation::facing([1.0, 0.0, 0.0]), [0.0, PI, 0.0]);
        // 2/7, 3/7 and 6/7 make a vector of length 1.
        for up in [[2.0, 3.0, 6.0], [-6.0, 2.0, 3.0], [-3.0, -6.0, -2.0], [0.0, -7.0, 0.0]] {
            let up = up.map(|value: f64| value / 7.0);
            let solid = Rotation::body_fixed_xyz(Orientation::facing(up)).to_body([1.0, 0.0, 0.0]);
            for (solid, up) in solid.into_iter().zip(up) {
                assert!((solid + up).abs() < 1e-15, "{up:?}: {solid:?}");
            }
        }
    }

    #[test]
    fn an_angle_beyond_a_whole_turn_is_in_degrees() {
        let of = |z: f64| Orientation {
            path: "/contactgeometryset/floor".to_owned(),
            tag: "orientation",
            line: 1,
            file: FileId::MAIN,
            angles_rad: Some([0.0, 0.0, z]),
        };
        // A quarter turn, three of them, and a whole one, also rounded up.
        for radians in [-FRAC_PI_2, 3.0 * FRAC_PI_2, 2.0 * PI, -2.0 * PI - 1e-5] {
            assert!(!of(radians).is_in_degrees(), "{radians}");
        }
        for degrees in [-90.0, 90.0, 180.0, -10.0] {
            assert!(of(degrees).is_in_degrees(), "{degrees}");
        }
        let unread = Orientation { angles_rad: None, ..of(0.0) };
        assert!(!unread.is_in_degrees());
    }
}
