//! How far the forces with some unknowns are from the plates, and what slack it took.

use super::foot::At;
use super::refining::{Refined, Refining};
use crate::fit::result::{FitErrors, SlackUsed};

impl Refining<'_> {
    /// Model less plates in each frame, body weights, where the recording is taken as it is, or with slack.
    pub(super) fn force_residuals(&self, shared: &[f64], slack: Option<&[Vec<f64>]>) -> Vec<f64> {
        let mut residuals = Vec::new();
        let mut before = None;
        self.each(shared, slack, |foot, frame, _, row| {
            // The first residual of a frame is its force.
            let place = Some((std::ptr::from_ref(foot.forces), frame));
            if before != place {
                residuals.push(row.value);
            }
            before = place;
        });
        residuals
    }

    /// The error of one trial, body weights.
    pub(in crate::fit) fn error_of_trial(&self, shared: &[f64], trial: usize) -> f64 {
        let (mut square, mut count) = (0.0, 0_usize);
        let mut before = None;
        self.each(shared, None, |foot, frame, _, row| {
            let place = Some((std::ptr::from_ref(foot.forces), frame));
            if foot.trial() == trial && before != place {
                square += row.value * row.value;
                count += 1;
            }
            before = place;
        });
        (square / count.max(1) as f64).sqrt()
    }

    /// How far the forces are from the plates.
    pub(in crate::fit) fn errors(&self, shared: &[f64], slack: Option<&[Vec<f64>]>) -> FitErrors {
        let residuals = self.force_residuals(shared, slack);
        let square: f64 = residuals.iter().map(|one| one * one).sum();
        FitErrors {
            vertical_rms_bw: (square / residuals.len().max(1) as f64).sqrt(),
            largest_relative_indentation: self.deepest(shared, slack),
        }
    }

    /// The largest x/R in frames with a force.
    fn deepest(&self, shared: &[f64], slack: Option<&[Vec<f64>]>) -> f64 {
        let unknowns = self.layout.unknowns(shared, &self.start);
        let at = At { layout: self.layout, shared, unknowns: &unknowns };
        let mut deepest = f64::NEG_INFINITY;
        let mut windows = slack.into_iter().flatten();
        for foot in &self.feet {
            if slack.is_some() && !foot.windows.is_empty() {
                for (window, own) in foot.windows.iter().zip(windows.by_ref()) {
                    for frame in window.frames.clone() {
                        deepest = deepest.max(foot.deepest(frame, &at, Some((window, own))));
                    }
                }
            } else {
                for frame in 0..foot.forces.frames() {
                    deepest = deepest.max(foot.deepest(frame, &at, None));
                }
            }
        }
        deepest
    }

    /// What slack was used while the feet stand.
    pub(in crate::fit) fn used(&self, refined: &Refined) -> Option<SlackUsed> {
        self.slack_m?;
        let (mut count, mut squares, mut most) = (0_usize, [0.0; 2], [0.0_f64; 2]);
        let mut windows = refined.slack.iter();
        for foot in &self.feet {
            for (window, own) in foot.windows.iter().zip(windows.by_ref()) {
                for frame in window.frames.clone().filter(|&frame| foot.has_force(frame)) {
                    let values = foot.slack_at(frame, window, own);
                    count += 1;
                    for ((square, most), value) in squares.iter_mut().zip(&mut most).zip(values) {
                        *square += value * value;
                        *most = most.max(value.abs());
                    }
                }
            }
        }
        let [height_rms_m, pitch_rms_rad] = squares.map(|square| (square / count.max(1) as f64).sqrt());
        Some(SlackUsed {
            errors: self.errors(&refined.shared, Some(&refined.slack)),
            height_rms_m,
            pitch_rms_rad,
            largest_height_m: most[0],
            largest_pitch_rad: most[1],
        })
    }
}
