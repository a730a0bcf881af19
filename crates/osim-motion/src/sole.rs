//! Directions of a foot (down and forward), and centres of pressure on its sole.

use osim_model::feet::{DefaultPose, PoseFault, ViewAxes};
use osim_model::{DVec2, DVec3, Model, Side};

use crate::{ContactStates, FootSummary, TOUCH_DOWN_BW, Wrench};

/// Smallest distance between the middles of the left and the right spheres at which the right side is known, m.
const LEAST_DISTANCE_OF_SIDES_M: f64 = 1e-3;

/// The vector from the middle of the left spheres to the middle of the right spheres at the default pose, m; not finite if a side
/// has no spheres.
pub(crate) fn left_to_right(states: &ContactStates, pose: &DefaultPose) -> Result<DVec3, PoseFault> {
    let (mut sums, mut counts) = ([DVec3::ZERO; 2], [0.0; 2]);
    for pair in &states.pairs {
        let Some(side) = Side::of_name(&pair.body) else { continue };
        let at_m = pose.placement(&pair.body)?.point(pair.centre_m);
        let place = usize::from(side == Side::Left);
        sums[place] += at_m;
        counts[place] += 1.0;
    }
    let [right, left] = sums;
    Ok(right / counts[0] - left / counts[1])
}

/// The forward direction along the floor at the default pose, from the vector of [`left_to_right`]; the x axis if the right side
/// is not known.
pub(crate) fn forward_direction(left_to_right: DVec3, up: DVec3) -> DVec3 {
    let flat = left_to_right - left_to_right.dot(up) * up;
    let length = flat.length();
    // Also false where a side has no spheres.
    let is_known = length > LEAST_DISTANCE_OF_SIDES_M;
    if is_known { up.cross(flat / length) } else { ViewAxes::with_up(up).forward }
}

/// A direction projected on the floor, with length 1; the direction itself if it is along the normal.
pub(crate) fn project_on_floor(direction: DVec3, up: DVec3) -> DVec3 {
    let flat = direction - direction.dot(up) * up;
    let length = flat.length();
    if length > 1e-6 { flat / length } else { direction }
}

/// Centres of pressure in the axes of a foot: forward and to the right of the middle of its spheres, m, with the directions of
/// the default pose.
#[derive(Debug, Clone, PartialEq)]
pub struct PressureOnSole {
    /// The place of each sphere in these axes at the default pose, m.
    pub spheres_m: Vec<[f64; 2]>,
    /// The centre of pressure of the model in each frame, m; `None` if the force is too small.
    pub model_m: Vec<Option<[f64; 2]>>,
    /// The centre of pressure of the plates in each frame, m; `None` if it is not known.
    pub measured_m: Vec<Option<[f64; 2]>>,
}

impl PressureOnSole {
    /// The centres of pressure of all feet, with those of the plates if known; `None` if the default pose of a body is not
    /// known. In each frame the foot is turned so that its spheres lie as near as possible to their places at the default
    /// pose.
    pub fn all<'f>(
        model: &Model,
        states: &ContactStates,
        feet: impl Iterator<Item = (&'f FootSummary, Option<&'f [Option<Wrench>]>)>,
        weight_n: f64,
    ) -> Vec<Option<Self>> {
        let pose = DefaultPose::of(model);
        let across = left_to_right(states, &pose).ok();
        feet.map(|(foot, measured)| Self::of(states, (&pose, across?), foot, measured, weight_n).ok())
            .collect()
    }

    /// The centres of pressure of one foot; `across` points from the left to the right.
    fn of(
        states: &ContactStates,
        (pose, across): (&DefaultPose, DVec3),
        foot: &FootSummary,
        measured: Option<&[Option<Wrench>]>,
        weight_n: f64,
    ) -> Result<Self, PoseFault> {
        let pairs: Vec<_> = foot.foot.pairs.iter().filter_map(|&pair| states.pairs.get(pair)).collect();
        let first = foot.foot.pairs.first().copied().unwrap_or_default();
        let normal = states.frame(0).get(first).map_or(DVec3::Y, |state| state.normal);
        let forward = project_on_floor(forward_direction(across, normal), normal);
        let axes = [forward, forward.cross(normal)];
        let flat = |point_m: DVec3| DVec2::from(axes.map(|axis| axis.dot(point_m)));
        let mut spheres_m = Vec::new();
        for pair in &pairs {
            spheres_m.push(flat(pose.placement(&pair.body)?.point(pair.centre_m)));
        }
        let middle_m = mean_point(&spheres_m);
        spheres_m.iter_mut().for_each(|place| *place -= middle_m);
        let in_foot = |frame: usize, wrench: &Wrench| {
            let contacts = foot.foot.contacts(states, frame);
            let places: Vec<DVec2> = contacts.map(|state| flat(state.centre_m)).collect();
            let on_plane_m = states.frame(frame).get(first)?.on_surface_m(pairs.first()?.radius_m);
            let centre = wrench.centre_of_pressure(normal, on_plane_m, TOUCH_DOWN_BW * weight_n)?;
            Some(in_foot_axes(&spheres_m, &places, flat(centre.point_m)).to_array())
        };
        let each = |wrenches: &mut dyn Iterator<Item = Option<Wrench>>| {
            wrenches.enumerate().map(|(frame, one)| in_foot(frame, &one?)).collect::<Vec<_>>()
        };
        let plates = measured.unwrap_or_default();
        Ok(Self {
            model_m: each(&mut foot.wrenches.iter().copied().map(Some)),
            measured_m: each(&mut plates.iter().copied()),
            spheres_m: spheres_m.iter().map(DVec2::to_array).collect(),
        })
    }

    /// The distance of the model's centre of pressure ahead and to the right of the plates', m: the mean over the frames in
    /// which both are known.
    pub fn mean_difference_m(&self) -> Option<[f64; 2]> {
        let both = self.model_m.iter().zip(&self.measured_m);
        let differences: Vec<DVec2> =
            both.filter_map(|(own, plate)| Some(DVec2::from((*own)?) - DVec2::from((*plate)?))).collect();
        (!differences.is_empty()).then(|| mean_point(&differences).to_array())
    }
}

/// A point of the floor in the axes of a foot. The spheres are at `now` in ground, and at `before` (around 0) in the axes of the
/// foot; the rotation between them is found by least squares.
fn in_foot_axes(before: &[DVec2], now: &[DVec2], point: DVec2) -> DVec2 {
    let middle = mean_point(now);
    let (mut along, mut across) = (0.0, 0.0);
    for (old, new) in before.iter().zip(now) {
        let new = *new - middle;
        along += old.dot(new);
        across += old.perp_dot(new);
    }
    let back = DVec2::new(along, -across);
    // One sphere alone has no direction.
    let back = if back.length() > 0.0 { back / back.length() } else { DVec2::X };
    back.rotate(point - middle)
}

fn mean_point(places: &[DVec2]) -> DVec2 {
    places.iter().sum::<DVec2>() / places.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_foot_that_turns_and_moves_keeps_its_points() {
        let sole = [[0.1, 0.02], [-0.1, 0.0], [0.0, -0.02]].map(DVec2::from);
        let turn = 0.4_f64;
        let there = |at: DVec2| {
            let (x, y) = (at.x, at.y);
            DVec2::new(3.0 + turn.cos() * x - turn.sin() * y, -1.0 + turn.sin() * x + turn.cos() * y)
        };
        let now = sole.map(there);
        let seen = in_foot_axes(&sole, &now, there(DVec2::new(0.05, 0.01)));
        assert!((seen.x - 0.05).abs() < 1e-12 && (seen.y - 0.01).abs() < 1e-12, "{seen:?}");
        // One sphere: the floor's own axes.
        let seen = in_foot_axes(&[DVec2::ZERO], &[DVec2::new(2.0, 1.0)], DVec2::new(2.1, 1.2));
        assert!((seen.x - 0.1).abs() < 1e-12 && (seen.y - 0.2).abs() < 1e-12, "{seen:?}");
    }
}
