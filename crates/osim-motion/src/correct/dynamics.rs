//! The masses of a model along a motion: the centre of mass, and the forces that coordinates need by inverse dynamics.

use std::collections::HashSet;

use osim_model::feet::Couplers;
use osim_model::{DVec3, Model, MovingPlacement};

use super::residuals::SLOPE_STEP;
use super::unknowns::{CoordinatesOfCorrection, CorrectedCoordinate};
use crate::body_motions::{JointMotions, JointPaths};
use crate::{
    ContactStates, CoordinateKind, Foot, MeasuredForces, MotionFault, Recording, StatesError, Wrench,
};

/// The bodies of a model that have a mass.
pub(super) struct Masses<'m> {
    paths: JointPaths<'m>,
    bodies: Vec<BodyMass>,
    gravity_m_s2: DVec3,
}

/// The mass of one body, its centre and its inertia.
struct BodyMass {
    /// Index of the body in the paths.
    index: usize,
    kg: f64,
    /// The centre of mass in the frame of the body, m.
    centre_m: DVec3,
    /// The columns of the inertia about the centre of mass in the frame of the body, kg m².
    inertia: [DVec3; 3],
}

/// The motion of a body as velocities: of rotation, and of its point at the origin of ground. Also a rate of momentum, as a force and
/// its moment about the origin of ground.
type SpatialVector = [DVec3; 2];

/// How a coordinate moves the bodies, and the force that it needs.
struct CoordinateForce {
    /// The generalised force in each frame without forces from outside, N or N m.
    needed: Vec<f64>,
    /// The velocities of each foot per speed of the coordinate: all feet in the first frame, then in the next.
    feet: Vec<SpatialVector>,
}

impl CoordinateForce {
    /// The generalised force in a frame, where these wrenches act on the feet.
    fn with_feet(&self, frame: usize, wrenches: &[Wrench]) -> f64 {
        let feet = self.feet[frame * wrenches.len()..].iter().zip(wrenches);
        let carried =
            feet.map(|([turn, shift], wrench)| turn.dot(wrench.moment_n_m) + shift.dot(wrench.force_n));
        self.needed[frame] - carried.sum::<f64>()
    }
}

/// The time over which momentum is differentiated, s.
const STEP_S: f64 = 1e-5;

impl<'m> Masses<'m> {
    /// The bodies of `model` that count for its mass.
    pub(super) fn new(model: &'m Model) -> Result<Self, StatesError> {
        let all = || model.bodies().iter().filter(|body| !body.excluded_from_mass);
        let paths = JointPaths::of(model, &all().map(|body| body.name.as_str()).collect::<HashSet<&str>>())?;
        let shapes = model.body_shapes();
        let mut bodies = Vec::new();
        for body in all() {
            let Some(index) = paths.body(&body.name) else { continue };
            let inertia = shapes.get(&body.name).and_then(|shape| shape.inertia_kg_m2);
            let kg = body.mass_kg()?;
            // OpenSim sets the inertia of a body without mass to 0.
            let [xx, yy, zz, xy, xz, yz] = inertia.filter(|_| kg > 0.0).unwrap_or_default();
            let inertia = [DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz)];
            bodies.push(BodyMass { index, kg, centre_m: body.centre_of_mass_m, inertia });
        }
        Ok(Self { paths, bodies, gravity_m_s2: model.gravity_m_s2.unwrap_or_default().into() })
    }

    /// Calls `take` with the places of all bodies in each frame. Joints that move as in `known` are not computed again.
    fn in_each_frame<T>(
        &self,
        recording: &Recording,
        known: Option<&JointMotions<'_>>,
        mut take: impl FnMut(usize, &[MovingPlacement]) -> T,
    ) -> Vec<T> {
        let mut places = Vec::new();
        let in_frame = |frame| {
            self.paths.place_bodies(recording, known, frame, &mut places);
            take(frame, &places)
        };
        (0..recording.frames()).map(in_frame).collect()
    }

    /// The centre of mass in each frame, m; joints that move as in `known` are not computed again.
    pub(super) fn centre_along(&self, recording: &Recording, known: Option<&JointMotions<'_>>) -> Vec<DVec3> {
        let total: f64 = self.bodies.iter().map(|body| body.kg).sum();
        self.in_each_frame(recording, known, |_, places| {
            let at = |body: &BodyMass| body.kg / total * places[body.index].at.point(body.centre_m);
            self.bodies.iter().map(at).sum()
        })
    }

    /// The move of the centre of mass with each coordinate (per rad or m): all coordinates in the first frame, then in the next.
    pub(super) fn centre_slopes(
        &self,
        recording: &Recording,
        couplers: &Couplers,
        coordinates: &[CorrectedCoordinate],
    ) -> Result<Vec<DVec3>, StatesError> {
        let known = self.paths.motions_of_joints(recording);
        let at = self.centre_along(recording, Some(&known));
        let mut slopes = vec![DVec3::ZERO; recording.frames() * coordinates.len()];
        for (number, coordinate) in coordinates.iter().enumerate() {
            let moved = recording.changed(couplers, |_, values, _| values[coordinate.index] += SLOPE_STEP)?;
            let after = self.centre_along(&moved, Some(&known));
            for (frame, (after, before)) in after.iter().zip(&at).enumerate() {
                slopes[frame * coordinates.len() + number] = (*after - *before) / SLOPE_STEP;
            }
        }
        Ok(slopes)
    }

    /// The momentum of each body in each frame, and its moment about the origin of ground.
    fn momenta(&self, recording: &Recording) -> Vec<Vec<SpatialVector>> {
        self.in_each_frame(recording, None, |_, places| {
            let momentum = |body: &BodyMass| {
                let moving = &places[body.index];
                let linear = body.kg * moving.velocity_of(body.centre_m);
                let turn = moving.at.rotation.inverse().to_body(moving.angular_velocity);
                let spin = body.inertia.iter().map(|column| column.dot(turn)).collect::<Vec<f64>>();
                let spin = moving.at.rotation.to_body(DVec3::from_slice(&spin));
                [spin + moving.at.point(body.centre_m).cross(linear), linear]
            };
            self.bodies.iter().map(momentum).collect()
        })
    }

    /// The forces that the coordinates with these `indices` need along a motion whose speeds are derivatives of its values.
    fn forces(
        &self,
        recording: &Recording,
        couplers: &Couplers,
        feet: &[Foot],
        indices: &[usize],
    ) -> Result<Vec<CoordinateForce>, MotionFault> {
        let accelerations = recording.splined_accelerations()?;
        let count = recording.coordinates.len();
        let later = |by_s: f64| {
            let moved = recording.changed(couplers, |frame, values, speeds| {
                for (index, rate) in accelerations[frame * count..(frame + 1) * count].iter().enumerate() {
                    values[index] += by_s * speeds[index];
                    speeds[index] += by_s * rate;
                }
            })?;
            Ok::<_, MotionFault>(self.momenta(&moved))
        };
        let (before, after) = (later(-STEP_S)?, later(STEP_S)?);
        let feet: Vec<Option<usize>> =
            feet.iter().map(|foot| self.paths.body(foot.bodies.first()?)).collect();
        let still = recording.changed(couplers, |_, _, speeds| speeds.fill(0.0))?;
        let known = self.paths.motions_of_joints(&still);
        let force_of = |&index: &usize| {
            let only = recording.changed(couplers, |_, _, speeds| {
                speeds.fill(0.0);
                speeds[index] = 1.0;
            })?;
            let mut of_feet = Vec::new();
            let needed = self.in_each_frame(&only, Some(&known), |frame, places| {
                let velocity = |body: usize| -> SpatialVector {
                    [places[body].angular_velocity, places[body].velocity_at(DVec3::ZERO)]
                };
                of_feet.extend(feet.iter().map(|body| body.map(velocity).unwrap_or_default()));
                let power = |(number, body): (usize, &BodyMass)| {
                    let weight_n = body.kg * self.gravity_m_s2;
                    let pull = [places[body.index].at.point(body.centre_m).cross(weight_n), weight_n];
                    let rate = |part: usize| {
                        (after[frame][number][part] - before[frame][number][part]) / (2.0 * STEP_S)
                            - pull[part]
                    };
                    let [turn, shift] = velocity(body.index);
                    turn.dot(rate(0)) + shift.dot(rate(1))
                };
                self.bodies.iter().enumerate().map(power).sum()
            });
            Ok(CoordinateForce { needed, feet: of_feet })
        };
        indices.iter().map(force_of).collect()
    }
}

/// The force that no contact and no plate explains, by inverse dynamics: root mean squares, in body weights and in body weights times m.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RootResidual {
    pub vertical_bw: f64,
    pub horizontal_bw: f64,
    /// `None` if the points of the plates are not known.
    pub moment_bw_m: Option<f64>,
}

/// What a correction changes in inverse dynamics.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InverseDynamics {
    /// With the forces of the contacts, before and after the correction.
    pub before: RootResidual,
    pub after: RootResidual,
    /// With the forces of the plates, after the correction.
    pub with_plates: RootResidual,
    /// The changes of the moments of hip, knee and ankle with the forces of the plates (rms of the angle that changes most), N m; `None`
    /// without a corrected angle of this name.
    pub moment_changes_n_m: [Option<f64>; 3],
}

/// Joints whose moments are compared: parts of the names of coordinates or joints.
const COMPARED_JOINTS: [&str; 3] = ["hip", "knee", "ankle"];
/// Frames at each end that do not count, because the accelerations of a spline end badly.
pub(super) const END_FRAMES: usize = 3;

impl InverseDynamics {
    /// Compares the motions before and after a correction, each with its contacts.
    pub(super) fn compare(
        masses: &Masses<'_>,
        couplers: &Couplers,
        [before, after]: [(&Recording, &ContactStates); 2],
        (feet, measured): (&[Foot], &MeasuredForces),
        coordinates: &CoordinatesOfCorrection,
        weight_n: f64,
    ) -> Result<Self, MotionFault> {
        let all = &before.0.coordinates;
        let Some(root) = coordinates.corrected.first() else { return Ok(Self::default()) };
        let turns = all
            .iter()
            .enumerate()
            .filter(|(_, one)| one.joint == all[root.index].joint && one.kind == CoordinateKind::Rotational);
        let turns: Vec<usize> = turns.map(|(index, _)| index).collect();
        let angles = coordinates.corrected.iter().filter(|one| one.kind != CoordinateKind::Translational);
        let mut indices = vec![root.index];
        indices.extend(coordinates.level.iter().map(|(index, _)| *index).chain(turns));
        let root_count = indices.len();
        indices.extend(angles.filter(|one| one.foot.is_some() && !one.moves_toes).map(|one| one.index));
        let known_feet = measured.feet.iter().filter(|forces| forces.iter().any(Option::is_some));
        let known_feet: Vec<_> = known_feet.collect();
        let is_measured = |frame: &usize| known_feet.iter().all(|foot| foot[*frame].is_some());
        let frames = END_FRAMES..before.0.frames().saturating_sub(END_FRAMES);
        let frames: Vec<usize> = frames.filter(is_measured).collect();
        // The forces of all coordinates in each frame.
        let table = |forces: &[CoordinateForce], wrench: &dyn Fn(usize, usize) -> Wrench| {
            let in_frame = |&frame: &usize| {
                let wrenches: Vec<Wrench> = (0..feet.len()).map(|foot| wrench(frame, foot)).collect();
                forces.iter().map(|force| force.with_feet(frame, &wrenches)).collect()
            };
            frames.iter().map(in_frame).collect::<Vec<Vec<f64>>>()
        };
        let of_contacts = |states: &ContactStates, frame: usize, foot: usize| {
            Wrench::from_states(feet[foot].contacts(states, frame))
        };
        let of_plates = |frame: usize, foot: usize| measured.feet[foot][frame].unwrap_or_default();
        let rms = |sum: f64| (sum / frames.len().max(1) as f64).sqrt();
        let residual = |table: &[Vec<f64>]| {
            let part = |from: usize, to: usize| {
                rms(table.iter().flat_map(|row| &row[from..to]).map(|force| force * force).sum()) / weight_n
            };
            let level_end = 1 + coordinates.level.len();
            RootResidual {
                vertical_bw: part(0, 1),
                horizontal_bw: part(1, level_end),
                moment_bw_m: Some(part(level_end, root_count)),
            }
        };
        let needed = |recording| masses.forces(recording, couplers, feet, &indices);
        let (raw, corrected) = (needed(before.0)?, needed(after.0)?);
        let (old, new) = (table(&raw, &of_plates), table(&corrected, &of_plates));
        let change = |place: usize| {
            rms(old.iter().zip(&new).map(|(old, new)| (new[place] - old[place]).powi(2)).sum())
        };
        let is_of = |name: &str, index: usize| {
            let one = &all[index];
            [&one.name, &one.joint].iter().any(|text| text.to_ascii_lowercase().contains(name))
        };
        let largest = |name| {
            let places = (root_count..indices.len()).filter(|&place| is_of(name, indices[place]));
            places.map(change).reduce(f64::max)
        };
        let mut with_plates = residual(&new);
        with_plates.moment_bw_m =
            with_plates.moment_bw_m.filter(|_| measured.has_points.iter().all(|has| *has));
        Ok(Self {
            before: residual(&table(&raw, &|frame, foot| of_contacts(before.1, frame, foot))),
            after: residual(&table(&corrected, &|frame, foot| of_contacts(after.1, frame, foot))),
            with_plates,
            moment_changes_n_m: COMPARED_JOINTS.map(largest),
        })
    }
}
