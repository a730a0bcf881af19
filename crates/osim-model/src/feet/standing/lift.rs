//! The coordinate that lifts spheres from their floor.

use crate::model::{JointCoordinate, Model, Placement};

use super::tree::Hanging;
use crate::feet::couplers::CoordinateValues;
use crate::feet::default_pose::DefaultPose;
use crate::feet::held::{Held, HeldCoordinates};
use crate::feet::vector::dot;

/// Movements this close to each other are one (per metre of the coordinate).
const SAME: f64 = 1e-9;
/// A coordinate lifts where a metre of it is at least this much along the normal: that of a floor of 60 degrees.
const LEAST_RISE: f64 = 0.5;

/// The free coordinate that moves all spheres of a joint tree alike along the normal of their floor.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Lift {
    /// Its name, such as `pelvis_ty`.
    pub coordinate: String,
    /// The joint that has it.
    pub joint: String,
    /// Its value at the default pose, m.
    pub default_m: f64,
    /// How far the spheres rise along the normal with a metre of it, m: 1 as a rule, less on a slope.
    pub rise: f64,
}

/// Why no coordinate lifts the spheres of a joint tree from their floor.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotLifted {
    /// No joint above all spheres moves.
    #[error("it is welded to what its floor is on")]
    Welded,
    /// They only turn.
    #[error("it only turns about what its floor is on")]
    Pinned,
    /// They move only along the floor.
    #[error("it only slides along its floor")]
    Slides,
    /// One lifts, and is locked.
    #[error("{coordinate}, which would lift it, is locked")]
    Locked {
        /// The coordinate.
        coordinate: String,
    },
    /// One lifts, and a function or another coordinate sets it.
    #[error("{coordinate}, which would lift it, is set by a function")]
    Driven {
        /// The coordinate.
        coordinate: String,
    },
    /// Floors of several directions.
    #[error("its floors have several directions")]
    SeveralFloors,
}

/// What a coordinate does to all spheres below its joint.
enum Moves {
    Lifts(f64),
    Slides,
    Other,
}

/// A model at its default pose, whose coordinates are tried.
pub(super) struct Lifting<'m> {
    model: &'m Model,
    pose: &'m DefaultPose,
    known: &'m CoordinateValues,
    held: HeldCoordinates<'m>,
}

impl<'m> Lifting<'m> {
    pub(super) fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
        Self { model, pose, known: CoordinateValues::of(model), held: HeldCoordinates::of(model) }
    }

    /// The coordinate of the joints on `way` that lifts most along `normal`, with its joint's place on the way.
    pub(super) fn find(&self, way: &[Hanging<'_>], normal: [f64; 3]) -> Result<(usize, Lift), NotLifted> {
        let mut best: Option<(usize, Lift)> = None;
        let mut not = NotLifted::Welded;
        for (place, hanging) in way.iter().enumerate() {
            for (index, coordinate) in hanging.joint.coordinates.iter().enumerate() {
                let name = || coordinate.name.clone();
                let moves = self.moves(hanging, index, normal).unwrap_or(Moves::Other);
                let found = match (moves, self.held.held(hanging.joint, coordinate)) {
                    (Moves::Lifts(rise), Held::Not) => {
                        let more =
                            best.as_ref().is_none_or(|(_, known)| rise.abs() > known.rise.abs() + SAME);
                        let default_m = self.known.values.get(&coordinate.name).copied().filter(|_| more);
                        let joint = hanging.joint.name.clone();
                        let lift = |default_m| (place, Lift { coordinate: name(), joint, default_m, rise });
                        best = default_m.map(lift).or(best);
                        continue;
                    }
                    (Moves::Lifts(_), Held::Locked) => NotLifted::Locked { coordinate: name() },
                    (Moves::Lifts(_), Held::Driven) => NotLifted::Driven { coordinate: name() },
                    (Moves::Slides, Held::Not) => NotLifted::Slides,
                    (Moves::Other, Held::Not) => NotLifted::Pinned,
                    _ => continue,
                };
                not = more_telling(not, found);
            }
        }
        best.ok_or(not)
    }

    fn moves(&self, hanging: &Hanging<'_>, index: usize, normal: [f64; 3]) -> Option<Moves> {
        let by = |metres: f64| self.moved(hanging, index, metres);
        let moved = [by(1.0)?, by(0.5)?, by(-1.0)?];
        let unturned = moved.iter().all(|moved| {
            let turned = moved.rotation.inverse().to_body(normal);
            (0..3).all(|axis| (turned[axis] - normal[axis]).abs() <= SAME)
        });
        let [rise, half, back] = moved.map(|moved| dot(moved.translation_m, normal));
        let is_even = (half - 0.5 * rise).abs() <= SAME && (back + rise).abs() <= SAME;
        let moves = moved.iter().any(|moved| moved.translation_m.iter().any(|part| part.abs() > SAME));
        Some(match unturned {
            true if is_even && rise.abs() >= LEAST_RISE => Moves::Lifts(rise),
            true if is_even && moves => Moves::Slides,
            _ => Moves::Other,
        })
    }

    /// Where in ground what hangs on the joint goes when its coordinate at `index` grows by `metres`.
    fn moved(&self, hanging: &Hanging<'_>, index: usize, metres: f64) -> Option<Placement> {
        let joint = hanging.joint;
        let value = |coordinate: &JointCoordinate| self.known.values.get(&coordinate.name).copied();
        let values: Vec<f64> = joint.coordinates.iter().map(value).collect::<Option<_>>()?;
        let mut grown = values.clone();
        *grown.get_mut(index)? += metres;
        let parent = match hanging.parent {
            Some(body) => *self.pose.placement(body).ok()?,
            None => Placement::IDENTITY,
        };
        let placed = |values: &[f64]| {
            let placement = joint.placement(self.model, values)?;
            Some(parent.then(&if hanging.forward { placement } else { placement.inverse() }))
        };
        Some(placed(&grown)?.then(&placed(&values)?.inverse()))
    }
}

/// Of two reasons the one that says more.
fn more_telling(one: NotLifted, other: NotLifted) -> NotLifted {
    let rank = |reason: &NotLifted| match reason {
        NotLifted::Welded => 0,
        NotLifted::Pinned => 1,
        NotLifted::Slides => 2,
        _ => 3,
    };
    if rank(&other) > rank(&one) { other } else { one }
}
