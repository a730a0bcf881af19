//! Forces of a model beside those that plates measured.

use osim_model::feet::dot;

use crate::wrench::Wrench;

/// How far the forces of a model are from those that plates measured, over the frames in which both are known.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// How many frames were compared.
    pub frames: usize,
    /// Root mean square of the difference along the plane's normal, N.
    pub normal_rms_n: f64,
    /// Root mean square of the difference across it, N.
    pub horizontal_rms_n: f64,
    /// The largest force of the model along the normal, N.
    pub peak_n: f64,
    /// The largest measured one, N.
    pub measured_peak_n: f64,
    /// Root mean square of the distance between both centres of pressure, m; `None` where there is none.
    pub cop_rms_m: Option<f64>,
    /// In how many frames both have a centre of pressure.
    pub cop_frames: usize,
}

/// Where forces are compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComparedOn {
    /// The plane's normal.
    pub normal: [f64; 3],
    /// A point of it, m.
    pub point_m: [f64; 3],
    /// A centre of pressure counts above this force, N.
    pub least_n: f64,
    /// Whether the plates have points.
    pub has_points: bool,
}

impl Comparison {
    /// Compares `model` with `measured` in the frames that `counts`; `None` where there are none.
    #[must_use]
    pub fn of(
        model: &[Wrench],
        measured: &[Option<Wrench>],
        on: &ComparedOn,
        counts: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let (mut frames, mut along, mut across) = (0_usize, 0.0, 0.0);
        let (mut peak_n, mut measured_peak_n) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        let (mut cop_frames, mut apart) = (0_usize, 0.0);
        for (frame, (own, plate)) in model.iter().zip(measured).enumerate() {
            let Some(plate) = plate.as_ref().filter(|_| counts(frame)) else { continue };
            frames += 1;
            let (own_n, plate_n) = (dot(own.force_n, on.normal), dot(plate.force_n, on.normal));
            let difference: [f64; 3] = std::array::from_fn(|i| own.force_n[i] - plate.force_n[i]);
            let normal = own_n - plate_n;
            along += normal * normal;
            across += (dot(difference, difference) - normal * normal).max(0.0);
            peak_n = own_n.max(peak_n);
            measured_peak_n = plate_n.max(measured_peak_n);
            let centre = |wrench: &Wrench| wrench.centre_of_pressure(on.normal, on.point_m, on.least_n);
            if let Some((own, plate)) = centre(own).zip(centre(plate)).filter(|_| on.has_points) {
                let away: [f64; 3] = std::array::from_fn(|i| own.point_m[i] - plate.point_m[i]);
                apart += dot(away, away);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_root_mean_squares() {
        let at = |x: f64, up: f64| Wrench::default().plus([0.0, up, 3.0], [x, 0.0, 0.0]);
        let model = [at(0.1, 100.0), at(0.1, 200.0), at(0.0, 0.0), at(0.0, 5.0)];
        let measured = [Some(at(0.13, 104.0)), Some(at(0.1, 197.0)), None, Some(at(0.0, 5.0))];
        let on = ComparedOn { normal: [0.0, 1.0, 0.0], point_m: [0.0; 3], least_n: 10.0, has_points: true };
        let all = Comparison::of(&model, &measured, &on, |_| true).unwrap();
        // 4, -3 and 0 N: 25/3. Points 0.03 m and 0 m apart in two frames.
        assert_eq!((all.frames, all.cop_frames), (3, 2));
        assert!((all.normal_rms_n - (25.0_f64 / 3.0).sqrt()).abs() < 1e-12);
        assert!(all.horizontal_rms_n < 1e-7);
        assert!((all.cop_rms_m.unwrap() - 0.03 / 2.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!((all.peak_n, all.measured_peak_n), (200.0, 197.0));
        assert_eq!(Comparison::of(&model, &measured, &on, |frame| frame == 2), None);
    }
}
