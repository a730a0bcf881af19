//! What a fit to recordings found, in words.

use osim_messages::{Input, Phrase, phrase};
use osim_motion::Summary;
use osim_motion::fit::{FitBounds, FittedParameter, MotionFit};

/// A range of a stiffness wider than this ratio says that it is not determined.
const WIDE: f64 = 3.0;
/// A range of a dissipation wider than this says the same, s/m.
const WIDE_S_M: f64 = 1.0;

/// One remark for each thing that a reader should know of a fit.
pub(super) fn remarks(
    fit: &MotionFit,
    before: Option<&Summary>,
    after: Option<&Summary>,
    bounds: &FitBounds,
) -> Vec<Phrase> {
    let mut said = Vec::new();
    if let Some((before, after)) = before.zip(after) {
        said.extend(feet(before, after));
    }
    if fit.after.vertical_rms_bw > fit.before.vertical_rms_bw {
        said.push(
            format!(
                "this is worse than the model as it is, whose spheres are up to x/R {:.2} deep: with the bound, no fit comes as close",
                fit.before.largest_relative_indentation
            )
            .into(),
        );
    }
    for one in &fit.held_out {
        said.push(
            format!(
                "held out: fitted to the {}, the error at the {} is {:.3} body weights (rms)",
                one.fitted, one.tested, one.vertical_rms_bw
            )
            .into(),
        );
    }
    for (trial, up) in fit.floor_up_m.iter().enumerate() {
        said.push(height(trial, fit.floor_up_m.len(), up));
    }
    if let Some(factor) = &fit.stiffness_factor {
        said.push(stiffness(factor));
    }
    if let Some(dissipation) = &fit.dissipation {
        said.push(of_dissipation(dissipation));
    }
    if let Some(scatter) = before.and_then(scatter) {
        said.push(scatter);
    }
    if bounds.most_relative_indentation.is_some() && fit.floor_up_m.iter().any(|up| up.at_bound) {
        said.push(phrase![
            "a sphere is as deep as its radius, which is the bound: ",
            Input::Unbounded,
            " would let it go deeper, and fit closer, but the law holds up to x/R 0.16"
        ]);
    }
    if fit.beside > 0 {
        said.push(
            format!("{} frames are left out: a foot seems to stand beside the plates", fit.beside).into(),
        );
    }
    said.push("friction is not fitted: how feet slip in kinematics is mostly error".into());
    said
}

fn feet(before: &Summary, after: &Summary) -> Vec<Phrase> {
    let pairs = before.feet.iter().zip(&after.feet);
    pairs
        .filter_map(|(old, new)| {
            let (old, new) = (old.comparison.as_ref()?, (&new.foot.name, new.comparison.as_ref()?));
            let bw = |force_n: f64| force_n / before.weight_n;
            let (name, new) = new;
            Some(Phrase::from(format!(
                "{name}: error of the force {:.3} body weights (rms), {:.3} before; up to {:.2} where the plates measured up to {:.2}",
                bw(new.normal_rms_n),
                bw(old.normal_rms_n),
                bw(new.peak_n),
                bw(new.measured_peak_n)
            )))
        })
        .collect()
}

fn height(trial: usize, trials: usize, up: &FittedParameter) -> Phrase {
    let way = if up.value < 0.0 { "down" } else { "up" };
    let of = if trials > 1 { format!(" of trial {}", trial + 1) } else { String::new() };
    let (low_m, high_m) = match up.nearly_as_good {
        (low_m, high_m) if up.value < 0.0 => (-high_m, -low_m),
        range => range,
    };
    let bound = if up.at_bound { ", the bound of the search" } else { "" };
    format!(
        "the floor{of} goes {way} by {:.1} mm{bound}; {:.1} to {:.1} mm do nearly the same",
        1e3 * up.value.abs(),
        1e3 * low_m,
        1e3 * high_m
    )
    .into()
}

fn stiffness(factor: &FittedParameter) -> Phrase {
    let (low, high) = factor.nearly_as_good;
    let mut text = format!(
        "stiffness: {:.3} times that of the model; {low:.2} to {high:.2} times do nearly the same",
        factor.value
    );
    if high / low > WIDE {
        text.push_str(": it is not determined");
        return phrase![text, ". Keep the published one with ", Input::Fit.being("height")];
    }
    text.into()
}

fn of_dissipation(dissipation: &FittedParameter) -> Phrase {
    let (low, high) = dissipation.nearly_as_good;
    let mut text =
        format!("dissipation: {:.2} s/m; {low:.2} to {high:.2} s/m do nearly the same", dissipation.value);
    if high - low > WIDE_S_M {
        text.push_str(": it is not determined");
    }
    text.into()
}

/// Feet that scatter in height by more than the spheres' radius.
fn scatter(before: &Summary) -> Option<Phrase> {
    let widest = before.feet.iter().filter_map(|foot| foot.stance_scatter_m).reduce(f64::max)?;
    let radius_m = before.smallest_radius_m?;
    (widest > radius_m).then(|| {
        format!(
            "in stance the feet's height in the recording scatters by {:.0} mm, more than R ({:.0} mm): stiffness is not determined",
            1e3 * widest,
            1e3 * radius_m
        )
        .into()
    })
}
