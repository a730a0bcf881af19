//! Computes the states of all contacts along a recording: places, velocities and forces of spheres.

use osim_model::feet::PoseFault;
use osim_model::{DVec3, Fault, ForceId, HalfSpace, Model, MovingPlacement, Placement, SphereId};

use crate::body_motions::{JointMotions, JointPaths};
use crate::pair::{ContactPair, TouchedSurface, contact_pairs};
use crate::{MotionFault, Recording, Table};

/// The velocity of a treadmill's belt in ground, m/s; 0 for a floor.
#[derive(Debug, Clone, PartialEq)]
pub enum Belt {
    Constant(DVec3),
    PerFrame(Vec<DVec3>),
}

impl Belt {
    /// A belt with this constant speed (m/s) against the x axis, under a subject who walks along x.
    pub const fn against_x(speed_m_s: f64) -> Self {
        Self::Constant(DVec3::new(-speed_m_s, 0.0, 0.0))
    }

    /// A belt that moves against the x axis; its speed is in a column of the recording, m/s.
    ///
    /// # Errors
    /// No such column, or a row without a number.
    pub fn from_column(table: &Table, name: &str) -> Result<Self, MotionFault> {
        let none = || MotionFault::new(format!("it has no column '{name}' for the speed of the belt"));
        let column = table.column(name).ok_or_else(none)?;
        table.check_finite(column)?;
        Ok(Self::PerFrame(column.values.iter().map(|speed| DVec3::new(-speed, 0.0, 0.0)).collect()))
    }

    /// How far the belt went since the first of the times, m.
    pub(crate) fn way_m(&self, time_s: &[f64]) -> Vec<DVec3> {
        let mut way = DVec3::ZERO;
        let step = |frame: usize| {
            if let Some(before) = frame.checked_sub(1) {
                way += (self.at(before) + self.at(frame)) / 2.0 * (time_s[frame] - time_s[before]);
            }
            way
        };
        (0..time_s.len()).map(step).collect()
    }

    /// The velocity of the belt in a frame, m/s.
    pub(crate) fn at(&self, frame: usize) -> DVec3 {
        match self {
            Self::Constant(velocity) => *velocity,
            Self::PerFrame(all) => all.get(frame).copied().unwrap_or_default(),
        }
    }
}

impl Default for Belt {
    /// A floor that does not move.
    fn default() -> Self {
        Self::Constant(DVec3::ZERO)
    }
}

/// Contacts along a motion, or the reason why they cannot be computed.
type Result<T, E = StatesError> = std::result::Result<T, E>;

/// Why the contacts of a model along a motion cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StatesError {
    #[error(transparent)]
    Model(Box<Fault>),
    #[error(transparent)]
    Pose(#[from] PoseFault),
    #[error(transparent)]
    Motion(#[from] MotionFault),
}

impl From<Fault> for StatesError {
    fn from(fault: Fault) -> Self {
        Self::Model(Box::new(fault))
    }
}

/// The state of a contact pair in one frame, with all vectors in ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState {
    pub centre_m: DVec3,
    /// Velocity of the sphere's centre, m/s.
    pub velocity_m_s: DVec3,
    /// Normal of the plane, out of it.
    pub normal: DVec3,
    /// x, the depth of the sphere below the surface of the plane (or of the other sphere), m; negative without contact.
    pub indentation_m: f64,
    /// Rate of the indentation, m/s.
    pub rate_m_s: f64,
    /// Slip velocity of the sphere against the plane (or the belt) at the point where the force acts, m/s.
    pub slip_m_s: DVec3,
    /// The point where the force acts, m.
    pub point_m: DVec3,
    /// The force on the sphere, N: the normal force and the friction, which acts against the slip.
    pub force_n: DVec3,
    /// The component of the force along the normal, N.
    pub normal_force_n: f64,
}

impl ContactState {
    /// How fast the sphere slips along the surface, m/s.
    pub fn slip_speed_m_s(&self) -> f64 {
        self.slip_m_s.length()
    }

    /// The point of the touched surface below the centre of a sphere of this radius, m.
    pub fn on_surface_m(&self, radius_m: f64) -> DVec3 {
        self.centre_m - (radius_m - self.indentation_m) * self.normal
    }
}

/// The states of all contact pairs in all frames of a recording.
#[derive(Debug, Clone)]
pub struct ContactStates {
    pub time_s: Vec<f64>,
    pub pairs: Vec<ContactPair>,
    pub planes: Vec<HalfSpace>,
    /// Names of joints that close a loop. This program does not keep the loops closed.
    pub loops: Vec<String>,
    states: Vec<ContactState>,
}

impl ContactStates {
    /// Computes the states of all pairs of `forces` in all frames of `recording`. The floor moves like `belt`.
    ///
    /// # Errors
    /// A value of the model that cannot be read, a body whose place is not known, or a coordinate without a value between
    /// ground and a sphere.
    pub fn of(model: &Model, recording: &Recording, forces: &[ForceId], belt: &Belt) -> Result<Self> {
        Self::from_pairs(model, recording, contact_pairs(model, forces)?, belt, None)
    }

    /// The states of the same pairs along another motion.
    ///
    /// # Errors
    /// States that cannot be computed.
    pub fn along(&self, model: &Model, recording: &Recording, belt: &Belt) -> Result<Self> {
        Self::from_pairs(model, recording, (self.pairs.clone(), self.planes.clone()), belt, None)
    }

    /// What [`along`](Self::along) computes, for a motion in which most coordinates are those of `known`; without forces, which are 0.
    pub(crate) fn along_after(
        &self,
        model: &Model,
        known: &JointMotions<'_>,
        recording: &Recording,
        belt: &Belt,
    ) -> Result<Self> {
        Self::from_pairs(model, recording, (self.pairs.clone(), self.planes.clone()), belt, Some(known))
    }

    /// Computes the states of given contact pairs along a recording, with the motions of joints in another one if these are `known`.
    fn from_pairs(
        model: &Model,
        recording: &Recording,
        (pairs, planes): (Vec<ContactPair>, Vec<HalfSpace>),
        belt: &Belt,
        known: Option<&JointMotions<'_>>,
    ) -> Result<Self> {
        let paths = paths_to(model, &pairs, &planes)?;
        check_values(&paths, recording)?;
        let planar: Vec<Surface> =
            planes.iter().map(|plane| Surface::from_plane(plane, &paths)).collect::<Result<_, _>>()?;
        let surfaces: Vec<Surface> = pairs
            .iter()
            .map(|pair| match pair.touched {
                TouchedSurface::Plane(number) => {
                    planar.get(number).copied().ok_or_else(|| Fault::refused("a plane is lost"))
                }
                TouchedSurface::Sphere(id) => Surface::from_sphere(model, id, &paths),
            })
            .collect::<Result<_, _>>()?;
        let sphere_bodies: Vec<Option<usize>> = pairs.iter().map(|pair| paths.body(&pair.body)).collect();
        let mut states = Vec::with_capacity(recording.frames() * pairs.len());
        let mut places = Vec::new();
        for frame in 0..recording.frames() {
            paths.place_bodies(recording, known, frame, &mut places);
            for ((pair, body), surface) in pairs.iter().zip(&sphere_bodies).zip(&surfaces) {
                let Some(moving) = body.and_then(|body| places.get(body)) else { continue };
                let belt_m_s = if pair.is_ground { belt.at(frame) } else { DVec3::ZERO };
                let surface = surface.at(&places, moving.at.point(pair.centre_m));
                states.push(contact_state(pair, moving, &surface, belt_m_s, known.is_none()));
            }
        }
        let loops = paths.loops.clone();
        Ok(Self { time_s: recording.time_s.clone(), pairs, planes, loops, states })
    }

    /// The number of frames.
    pub fn frames(&self) -> usize {
        self.time_s.len()
    }

    /// The states of all contact pairs in one frame.
    pub fn frame(&self, frame: usize) -> &[ContactState] {
        let count = self.pairs.len();
        self.states.get(frame * count..(frame + 1) * count).unwrap_or_default()
    }

    /// The states of one contact pair, frame by frame.
    pub fn pair(&self, pair: usize) -> impl Iterator<Item = &ContactState> {
        self.states.iter().skip(pair).step_by(self.pairs.len().max(1))
    }
}

/// The paths to the bodies of all spheres and surfaces.
pub(crate) fn paths_to<'m>(
    model: &'m Model,
    pairs: &[ContactPair],
    planes: &[HalfSpace],
) -> Result<JointPaths<'m>, PoseFault> {
    let carriers = planes.iter().filter_map(|plane| plane.body.as_deref());
    let touched = pairs.iter().filter_map(|pair| match pair.touched {
        TouchedSurface::Sphere(id) => model.sphere(id)?.body.as_deref(),
        TouchedSurface::Plane(_) => None,
    });
    let bodies = pairs.iter().map(|pair| pair.body.as_str()).chain(carriers).chain(touched);
    JointPaths::of(model, &bodies.collect())
}

/// Checks that every coordinate on the paths has a value.
fn check_values(paths: &JointPaths<'_>, recording: &Recording) -> Result<()> {
    let first = recording.values(0);
    for (joint, range) in paths.coordinates() {
        for (coordinate, value) in joint.coordinates.iter().zip(first.get(range).unwrap_or_default()) {
            if !value.is_finite() {
                let (coordinate, joint) = (coordinate.name.clone(), joint.name.clone());
                return Err(PoseFault::Coordinate { coordinate, joint }.into());
            }
        }
    }
    Ok(())
}

/// A plane or a sphere, on ground or on a body.
#[derive(Clone, Copy)]
struct Surface {
    body: Option<usize>,
    /// A point of the plane, or the centre of the sphere, m.
    point_m: DVec3,
    shape: SurfaceShape,
}

/// The shape of a surface that a sphere touches.
#[derive(Clone, Copy)]
enum SurfaceShape {
    /// A plane with this unit normal.
    Plane(DVec3),
    /// A sphere with this radius, m.
    Sphere(f64),
}

/// A plane or sphere in one frame, as it faces another sphere near it.
struct SurfaceInFrame {
    body_motion: MovingPlacement,
    normal: DVec3,
    /// Height of the centre of the other sphere above the surface along the normal, m.
    height_m: f64,
}

impl Surface {
    /// The surface of a plane on ground or on a body.
    fn from_plane(plane: &HalfSpace, paths: &JointPaths<'_>) -> Result<Self> {
        let unread = || Fault::refused(format!("the place of half-space {} cannot be read", plane.path));
        let (normal, point_m) = plane.normal.zip(plane.point_m).ok_or_else(unread)?;
        if plane.body.is_none() && !plane.on_ground {
            return Err(unread().into());
        }
        let body = plane.body.as_deref().and_then(|body| paths.body(body));
        Ok(Self { body, point_m, shape: SurfaceShape::Plane(normal) })
    }

    /// The surface of a sphere that another sphere touches.
    fn from_sphere(model: &Model, id: SphereId, paths: &JointPaths<'_>) -> Result<Self, Fault> {
        let unread = || Fault::refused("the place of a sphere that another one touches cannot be read");
        let (sphere, point_m) = model.sphere(id).zip(model.centre_m(id)).ok_or_else(unread)?;
        let body = sphere.body.as_deref().and_then(|body| paths.body(body));
        Ok(Self { body, point_m, shape: SurfaceShape::Sphere(sphere.round_radius_m()?) })
    }

    /// The surface in one frame, as it faces a sphere with this centre, m.
    fn at(&self, places: &[MovingPlacement], centre_m: DVec3) -> SurfaceInFrame {
        let ground = MovingPlacement::at_rest(Placement::IDENTITY);
        let body_motion = self.body.and_then(|body| places.get(body)).copied().unwrap_or(ground);
        let away = centre_m - body_motion.at.point(self.point_m);
        match self.shape {
            SurfaceShape::Plane(normal) => {
                let normal = body_motion.at.rotation.to_body(normal);
                SurfaceInFrame { normal, height_m: away.dot(normal), body_motion }
            }
            SurfaceShape::Sphere(radius_m) => {
                let distance_m = away.length();
                // Two centres at one place have no direction; any will do.
                let normal = if distance_m > 0.0 { away / distance_m } else { DVec3::Y };
                SurfaceInFrame { normal, height_m: distance_m - radius_m, body_motion }
            }
        }
    }
}

/// The state of one contact pair in one frame.
fn contact_state(
    pair: &ContactPair,
    moving: &MovingPlacement,
    surface: &SurfaceInFrame,
    belt_m_s: DVec3,
    has_force: bool,
) -> ContactState {
    let normal = surface.normal;
    let centre_m = moving.at.point(pair.centre_m);
    let indentation_m = pair.radius_m - surface.height_m;
    // Between the bottom of the sphere, which is as deep as the indentation, and the plane.
    let along = pair.radius_m - indentation_m * (1.0 - pair.depth_share);
    let point_m = centre_m - along * normal;
    let relative = moving.velocity_at(point_m) - surface.body_motion.velocity_at(point_m);
    let rate_m_s = -relative.dot(normal);
    let against_belt = relative - belt_m_s;
    let slip_m_s = against_belt - against_belt.dot(normal) * normal;
    let normal_force_n = if has_force { pair.law.force(indentation_m, rate_m_s) } else { 0.0 };
    ContactState {
        centre_m,
        velocity_m_s: moving.velocity_of(pair.centre_m),
        normal,
        indentation_m,
        rate_m_s,
        slip_m_s,
        point_m,
        force_n: normal_force_n * normal - pair.friction_force(normal_force_n, slip_m_s),
        normal_force_n,
    }
}

impl ContactPair {
    /// The friction force, N, as a vector along the slip; the force on the sphere acts against it.
    fn friction_force(&self, normal_force_n: f64, slip_m_s: DVec3) -> DVec3 {
        // The smooth class never divides by 0: it adds its constant to the square.
        let speed = libm::sqrt(slip_m_s.length_squared() + self.smoothing.unwrap_or(0.0));
        if speed == 0.0 || normal_force_n == 0.0 {
            return DVec3::ZERO;
        }
        normal_force_n * self.friction.coefficient(speed) * slip_m_s / speed
    }
}

/// The sum of several forces, and the sum of their moments.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// Sum of the contact forces, N.
    pub force_n: DVec3,
    /// The moment of the forces about the origin of ground, N m.
    pub moment_n_m: DVec3,
}

impl Wrench {
    /// The sum of the contact forces in `states`, and of their moments.
    pub fn from_states<'s>(states: impl IntoIterator<Item = &'s ContactState>) -> Self {
        states.into_iter().fold(Self::default(), |sum, state| sum.with_force(state.force_n, state.point_m))
    }

    /// The wrench with a force (N) added at a point (m).
    pub(crate) fn with_force(mut self, force_n: DVec3, point_m: DVec3) -> Self {
        self.force_n += force_n;
        self.moment_n_m += point_m.cross(force_n);
        self
    }

    /// The sum of two wrenches.
    pub fn plus(&self, other: &Self) -> Self {
        Self { force_n: self.force_n + other.force_n, moment_n_m: self.moment_n_m + other.moment_n_m }
    }

    /// The centre of pressure in the plane through `on_plane_m` (m) with the unit `normal`, and the moment about the normal
    /// at this point: p = p0 + n × M0/(F·n) with M0 = M − p0 × F, and n·(M0 − (p − p0) × F). `None` if the force along the
    /// normal is not above `least_n`.
    pub fn centre_of_pressure(
        &self,
        normal: DVec3,
        on_plane_m: DVec3,
        least_n: f64,
    ) -> Option<CentreOfPressure> {
        let along = self.force_n.dot(normal);
        if along.is_nan() || along.abs() <= least_n {
            return None;
        }
        let moment = self.moment_n_m - on_plane_m.cross(self.force_n);
        let from_plane = normal.cross(moment) / along;
        Some(CentreOfPressure {
            point_m: on_plane_m + from_plane,
            free_moment_n_m: (moment - from_plane.cross(self.force_n)).dot(normal),
        })
    }
}

/// The centre of pressure of a ground reaction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentreOfPressure {
    pub point_m: DVec3,
    /// The moment about the normal at the centre of pressure, N m.
    pub free_moment_n_m: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_of_pressure_of_one_force_is_its_point() {
        // 100 N up and 20 N forward at (0.3, 0, 0.1): the point comes back, and nothing turns about the normal.
        let (up, at) = (DVec3::Y, DVec3::new);
        let wrench = Wrench::default().with_force(at(20.0, 100.0, 0.0), at(0.3, 0.0, 0.1));
        let centre = wrench.centre_of_pressure(up, at(5.0, 0.0, -7.0), 1.0).unwrap();
        assert!(centre.point_m.abs_diff_eq(at(0.3, 0.0, 0.1), 1e-12), "{centre:?}");
        assert!(centre.free_moment_n_m.abs() < 1e-12);
        // Two opposite pulls along x, 0.2 m apart in z, turn about y by z × x = y: 0.1 * 20 + 0.1 * 20.
        let pull = at(20.0, 0.0, 0.0);
        let turned = wrench.with_force(pull, at(0.3, 0.0, 0.2)).with_force(-pull, at(0.3, 0.0, 0.0));
        let centre = turned.centre_of_pressure(up, DVec3::ZERO, 1.0).unwrap();
        assert!((centre.free_moment_n_m - 4.0).abs() < 1e-12, "{centre:?}");
        assert_eq!(turned.centre_of_pressure(up, DVec3::ZERO, 100.0), None);
    }
}
