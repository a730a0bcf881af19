//! Compares forces of a model with forces that plates measured, and finds sphere forces that OpenSim leaves out.

use std::collections::HashMap;

use osim_model::{DVec3, ForceId};

use crate::states::{ContactStates, Wrench};

/// The differences between the contact forces of a model and the forces that plates measured, over all frames with both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Comparison {
    pub frames: usize,
    /// Root mean square of the difference along the normal of the plane, N.
    pub normal_rms_n: f64,
    /// Root mean square of the difference parallel to the plane, N.
    pub horizontal_rms_n: f64,
    /// The largest force of the model along the normal, N.
    pub peak_n: f64,
    /// The largest measured force along the normal, N.
    pub measured_peak_n: f64,
    /// Root mean square of the distance between both centres of pressure, m; `None` if no frame has both.
    pub cop_rms_m: Option<f64>,
    /// The number of frames in which model and plates have a centre of pressure.
    pub cop_frames: usize,
}

/// The plane in which forces are compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComparisonPlane {
    pub normal: DVec3,
    pub point_m: DVec3,
    /// Centres of pressure are compared in frames with a normal force above this, N.
    pub least_n: f64,
    pub has_points: bool,
}

impl Comparison {
    /// Compares `model` with `measured` in the frames with both; `None` if there are none.
    pub fn of(model: &[Wrench], measured: &[Option<Wrench>], on: &ComparisonPlane) -> Option<Self> {
        let (mut frames, mut along, mut across) = (0_usize, 0.0, 0.0);
        let (mut peak_n, mut measured_peak_n) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        let (mut cop_frames, mut apart) = (0_usize, 0.0);
        for (modelled, plate) in model.iter().zip(measured) {
            let Some(plate) = plate else { continue };
            frames += 1;
            let (modelled_n, plate_n) =
                (modelled.force_n.dot(on.normal) + 0.0, plate.force_n.dot(on.normal) + 0.0);
            let normal = modelled_n - plate_n;
            along += normal * normal;
            across += ((modelled.force_n - plate.force_n).length_squared() - normal * normal).max(0.0);
            peak_n = modelled_n.max(peak_n);
            measured_peak_n = plate_n.max(measured_peak_n);
            let centre = |wrench: &Wrench| wrench.centre_of_pressure(on.normal, on.point_m, on.least_n);
            if let Some((modelled, plate)) = centre(modelled).zip(centre(plate)).filter(|_| on.has_points) {
                apart += modelled.point_m.distance_squared(plate.point_m);
                cop_frames += 1;
            }
        }
        let mean = |sum: f64, count: usize| libm::sqrt(sum / count as f64);
        (frames > 0).then(|| Self {
            frames,
            normal_rms_n: mean(along, frames),
            horizontal_rms_n: mean(across, frames),
            peak_n,
            measured_peak_n,
            cop_rms_m: (cop_frames > 0).then(|| mean(apart, cop_frames)),
            cop_frames,
        })
    }
}

/// Forces of sphere pairs that OpenSim may leave out. If the force of one pair of a `HuntCrossleyForce` would pull, Simbody
/// leaves out the pairs that it computes later in the same force; their order is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOutForces {
    /// The number of frames in which one pair of a force would pull and other pairs of this force push.
    pub frames: usize,
    /// The largest sum of the forces of these pushing pairs in one frame, N.
    pub most_n: f64,
}

impl LeftOutForces {
    /// The forces that may be left out along `states`; `None` if there are none.
    pub fn of(states: &ContactStates) -> Option<Self> {
        let mut left_out = Self { frames: 0, most_n: 0.0 };
        for frame in 0..states.frames() {
            // For each force: whether a pair would pull, and what the others push, N.
            let mut forces: HashMap<ForceId, (bool, f64)> = HashMap::new();
            let all = states.pairs.iter().zip(states.frame(frame));
            for (pair, state) in all.filter(|(pair, _)| pair.applies && pair.smoothing.is_none()) {
                let (pulls, pushed_n) = forces.entry(pair.force).or_default();
                *pulls |= state.indentation_m > 0.0 && state.normal_force_n <= 0.0;
                *pushed_n += state.normal_force_n;
            }
            let lost = forces.values().filter(|(pulls, pushed_n)| *pulls && *pushed_n > 0.0);
            let most_n = lost.map(|(_, pushed_n)| *pushed_n).fold(0.0, f64::max);
            if most_n > 0.0 {
                left_out.frames += 1;
                left_out.most_n = left_out.most_n.max(most_n);
            }
        }
        (left_out.frames > 0).then_some(left_out)
    }
}

/// The quantile `part` (0 to 1) of the values, interpolated linearly; `None` without values.
pub(crate) fn percentile(values: &[f64], part: f64) -> Option<f64> {
    let mut sorted: Vec<f64> = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = part * sorted.len().checked_sub(1)? as f64;
    let below = place as usize;
    let low = *sorted.get(below)?;
    let high = sorted.get(below + 1).copied().unwrap_or(low);
    Some(low + (place - below as f64) * (high - low))
}

#[cfg(test)]
mod tests {
    use osim_model::Model;

    use super::*;
    use crate::recording::{Recording, RecordingOptions};
    use crate::states::Belt;
    use crate::table::Table;

    #[test]
    fn differences_are_root_mean_squares() {
        let at = |x: f64, up: f64| Wrench::default().with_force(DVec3::new(0.0, up, 3.0), x * DVec3::X);
        let model = [at(0.1, 100.0), at(0.1, 200.0), at(0.0, 0.0), at(0.0, 5.0)];
        let measured = [Some(at(0.13, 104.0)), Some(at(0.1, 197.0)), None, Some(at(0.0, 5.0))];
        let on = ComparisonPlane { normal: DVec3::Y, point_m: DVec3::ZERO, least_n: 10.0, has_points: true };
        let all = Comparison::of(&model, &measured, &on).unwrap();
        // 4, -3 and 0 N: 25/3. Points 0.03 m and 0 m apart in two frames.
        assert_eq!((all.frames, all.cop_frames), (3, 2));
        assert!((all.normal_rms_n - (25.0_f64 / 3.0).sqrt()).abs() < 1e-12);
        assert!(all.horizontal_rms_n < 1e-7);
        assert!((all.cop_rms_m.unwrap() - 0.03 / 2.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!((all.peak_n, all.measured_peak_n), (200.0, 197.0));
        assert_eq!(Comparison::of(&model[2..3], &measured[2..3], &on), None);
    }

    /// A model whose body has two spheres, 1 m behind and 1 m ahead of its joint, in one force with a dissipation of 2 s/m.
    fn see_saw_model() -> Model {
        let sphere = |name: &str, x: i32| {
            format!(
                "<ContactSphere name=\"{name}\"><socket_frame>/bodyset/b</socket_frame><location>{x} 0 0</location><radius>0.03</radius>\
             </ContactSphere>"
            )
        };
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects><Body name=\"b\"><mass>1</mass></Body></objects></BodySet><JointSet>\
         <objects><PlanarJoint name=\"j\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/b\
         </socket_child_frame><coordinates><Coordinate name=\"turn\"/><Coordinate name=\"x\"/><Coordinate name=\"y\"/></coordinates>\
         </PlanarJoint></objects></JointSet><ContactGeometrySet><objects>{}{}<ContactHalfSpace name=\"floor\"><socket_frame>/ground\
         </socket_frame><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace></objects></ContactGeometrySet><ForceSet>\
         <objects><HuntCrossleyForce name=\"f\"><contact_parameters><HuntCrossleyForce::ContactParametersSet><objects>\
         <HuntCrossleyForce::ContactParameters><geometry>back front floor</geometry><stiffness>1e6</stiffness><dissipation>2\
         </dissipation></HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></contact_parameters>\
         </HuntCrossleyForce></objects></ForceSet></Model></OpenSimDocument>",
            sphere("back", -1),
            sphere("front", 1)
        );
        Model::parse(text).unwrap()
    }

    fn left_out_at_turning_rate(rad_s: f64) -> Option<LeftOutForces> {
        let names = ["turn", "x", "y"]
            .map(|name| format!("/jointset/j/{name}/value\t/jointset/j/{name}/speed"))
            .join("\t");
        let text = format!("inDegrees=no\nendheader\ntime\t{names}\n0\t0\t{rad_s}\t0\t0\t0.02\t0\n");
        let model = see_saw_model();
        let table = Table::read(text.as_bytes()).unwrap();
        let recording = Recording::of(&model, &table, &RecordingOptions::default()).unwrap();
        let states = ContactStates::of(&model, &recording, &model.force_ids(), &Belt::default());
        LeftOutForces::of(&states.unwrap())
    }

    #[test]
    fn a_pair_that_would_pull_is_found() {
        // Both are 1 cm deep. At 1 rad/s the one ahead leaves at 1 m/s, faster than 2/(3α) = 1/3 m/s, and the one behind goes in:
        // 4/3 E √R x^(3/2) (1 + 3/2 · 2 · 1) with E = 1e6/2^(3/2): 81.65 N times 4.
        let found = left_out_at_turning_rate(1.0).unwrap();
        assert_eq!(found.frames, 1);
        assert!((found.most_n - 326.6).abs() < 0.01, "{found:?}");
        // At 0.3 rad/s both push.
        assert_eq!(left_out_at_turning_rate(0.3), None);
    }

    #[test]
    fn percentiles_are_interpolated_between_values() {
        assert_eq!(percentile(&[3.0, 1.0, 2.0], 0.5), Some(2.0));
        assert_eq!(percentile(&[1.0, 2.0], 0.25), Some(1.25));
        assert_eq!(percentile(&[], 0.5), None);
    }
}
